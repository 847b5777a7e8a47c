"""A rod about a fixed hinge, which a torsion spring lifts off the drum below its head."""

from spragsym.derive.model import Page, cos, sin, tanh

page = Page("A rod about a fixed hinge, whose head a load presses on a drum.")
m = page.unit("m", "kg", "mass of the head")
k = page.unit("k", "N/m", "stiffness of the contact")
L = page.unit("L", "m", "length of the rod")
tilt = page.parameter("tilt", "rad", "angle of the spring at rest", "(0, pi/2)", 0.6)
mu = page.parameter("mu", "1", "friction coefficient", ">= 0", 0.3)
c = page.parameter("c", "N m/rad", "torsion spring", "> 0", 0.05, becomes="tau")
P = page.parameter("P", "N", "load on the head", "> 0", 0.01, becomes="rho")
V = page.parameter("V", "m/s", "speed of the drum", ">= 0", 0.3)
d = page.parameter("d", "s/m", "steepness of the friction law", "> 0", 8.0)
phi = page.coordinate("phi", "rad", "angle of the rod")
x, y = L * cos(phi), L * sin(phi)
page.kinetic(m * page.rate(phi) ** 2 * L**2 / 2)
page.potential(c * (phi - tilt) ** 2 / 2)
page.force(0, -P, at=(x, y))
page.contact(y - L / 2, lambda depth: k * depth)
page.friction(x, V, lambda v: mu * tanh(d * v), at_rest=mu)
