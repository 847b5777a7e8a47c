"""A box on a belt, held by a spring and a damper, with dry friction."""

from spragsym.derive.model import Page, sgn

page = Page("A box on a belt, held by a spring and a damper, with dry friction.")

m = page.unit("m", "kg", "mass of the box")
k = page.unit("k", "N/m", "spring")
g = page.unit("g", "m/s^2", "acceleration of gravity")

mu_c = page.parameter("mu_c", "1", "friction coefficient", ">= 0", 1.5)
d = page.parameter("d", "N s/m", "damper", ">= 0", 0.1, becomes="zeta")
v_b = page.parameter("v_b", "m/s", "speed of the belt", ">= 0", 1.0)

x = page.coordinate("x", "m", "displacement along the belt")

page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.damper(d, along=x)
page.normal_force(m * g)
page.friction(x, v_b, slip=lambda v: mu_c * sgn(v), holds=mu_c)
