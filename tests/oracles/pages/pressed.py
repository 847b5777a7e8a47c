"""A mass that is pressed on a belt that leans, and lifted."""

from spragsym.derive.model import Page, tanh

page = Page("A mass on a belt.")
m = page.unit("m", "kg", "mass")
L_0 = page.unit("L_0", "m", "length")
k_c = page.unit("k_c", "N/m", "contact stiffness")
W = page.parameter("W", "N", "weight", ">= 0", 1.0)
P = page.parameter("P", "N", "lift", ">= 0", 0.5)
k = page.parameter("k", "N/m", "stiffness", "> 0", 0.5)
mu0 = page.parameter("mu0", "1", "friction", ">= 0", 0.5)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
x = page.coordinate("x", "m", "along the belt")
y = page.coordinate("y", "m", "across the belt")
page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.spring(k, along=x)
page.spring(k, along=y)
page.force(0, P - W, at=(x, y))
page.contact(y + x / 8, lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu0 * tanh(d * v))
