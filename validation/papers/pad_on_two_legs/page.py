"""A pad on two legs, which a load presses onto a belt and friction turns: the rear leg lifts.

Elementary statics.
"""

from spragsym.derive.model import Page, tanh

page = Page("A pad on two legs, which a load presses onto a belt and friction turns.")

m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness of a leg")
a = page.unit("a", "m", "half the distance of the legs")

mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.3)
F = page.parameter("F", "N", "load", ">= 0", 0.05)
k_x = page.parameter("k_x", "N/m", "stiffness along the belt", "> 0", 0.5)
k_t = page.parameter("k_t", "N m", "stiffness of turning", ">= 0", 0.3)
h = page.parameter("h", "m", "height of the centre", "> 0", 0.8)
V = page.parameter("V", "m/s", "belt speed", "> 0", 0.5)

x = page.coordinate("x", "m", "displacement along the belt")
y = page.coordinate("y", "m", "displacement across it")
phi = page.coordinate("phi", "rad", "turning")
turns = 0.3 * m * a**2 * page.rate(phi) ** 2

page.kinetic((m * page.rate(x) ** 2 + m * page.rate(y) ** 2 + turns) / 2)
page.spring(k_x, along=x)
page.potential(k_t * phi**2 / 2)
page.force(-F, along=y)
front = page.contact(y - a * phi, lambda depth: k_c * depth, name="front")
rear = page.contact(y + a * phi, lambda depth: k_c * depth, name="rear")
for leg in (front, rear):
    page.friction(x + h * phi, V, lambda v: mu0 * tanh(20 * v / V), at_rest=mu0, on=leg)
