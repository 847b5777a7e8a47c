"""A mass on a spring that swings: the angle is 0 where it hangs."""

from spragsym.derive.model import Page, cos, sin

page = Page("A mass on a spring that swings.")

m = page.unit("m", "kg", "mass")
l_0 = page.unit("l_0", "m", "free length of the spring")
g = page.unit("g", "m/s^2", "acceleration of gravity")

k = page.parameter("k", "N/m", "stiffness", "> 0", 5.0, becomes="kappa")
c = page.parameter("c", "N s/m", "damper along the spring", ">= 0", 0.1, becomes="zeta")

z = page.coordinate("z", "m", "elongation")
theta = page.coordinate("theta", "rad", "angle")

x, y = (l_0 + z) * sin(theta), -(l_0 + z) * cos(theta)
page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.potential(k * z**2 / 2 + m * g * y)
page.damper(c, along=z)
