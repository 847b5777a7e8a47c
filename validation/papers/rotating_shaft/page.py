"""A disc on a shaft of unequal stiffness, seen from the frame that turns with it.

The divergence between the two critical speeds is A. Föppl's and D. M. Smith's, The motion of a
rotor carried by a flexible shaft in flexible bearings, Proceedings of the Royal Society A 142
(1933) 92-118.
"""

from spragsym.derive.model import Page

page = Page("A disc on a shaft of unequal stiffness, seen from the frame that turns with it.")

m = page.unit("m", "kg", "mass")
k_x = page.unit("k_x", "N/m", "stiffness along x")
L = page.unit("L", "m", "length")

k_y = page.parameter("k_y", "N/m", "stiffness along y", "> 0", 2.0, becomes="kappa")
W = page.parameter("W", "rad/s", "speed of rotation", ">= 0", 1.2)

x = page.coordinate("x", "m", "displacement along the first axis")
y = page.coordinate("y", "m", "displacement along the second axis")

page.kinetic(m * ((page.rate(x) - W * y) ** 2 + (page.rate(y) + W * x) ** 2) / 2)
page.spring(k_x, along=x)
page.spring(k_y, along=y)
