"""A mass on a belt whose quantities have names of results, sets and commands."""

from spragsym.derive.model import Page, tanh

page = Page("A mass on a belt, with names that the package has too.")
m = page.unit("m", "kg", "mass")
L_0 = page.unit("L_0", "m", "length")
k_c = page.unit("k_c", "N/m", "contact stiffness")
omega = page.parameter("omega", "1", "friction", ">= 0", 0.5)
rate = page.parameter("rate", "N", "weight", ">= 0", 1.0)
error = page.parameter("error", "N", "lift", ">= 0", 0.5)
count = page.parameter("count", "N/m", "stiffness", "> 0", 0.5)
shape = page.parameter("shape", "m/s", "belt speed", ">= 0", 0.5)
method = page.parameter("method", "s/m", "steepness", "> 0", 10.0)
mean = page.coordinate("mean", "m", "along the belt")
when = page.coordinate("when", "m", "across the belt")
page.kinetic(m * (page.rate(mean) ** 2 + page.rate(when) ** 2) / 2)
page.spring(count, along=mean)
page.spring(count, along=when)
page.force(0, error - rate, at=(mean, when))
page.contact(when + mean / 8, lambda depth: k_c * depth)
page.friction(mean, shape, lambda v: omega * tanh(method * v))
