"""A particle on a saddle that turns about its axis.

L. E. J. Brouwer, Beweging van een materieel punt op den bodem eener draaiende vaas onder den
invloed der zwaartekracht, Nieuw Archief voor Wiskunde 12 (1918) 407-419; here linear.
"""

from spragsym.derive.model import Page

page = Page("A particle on a saddle that turns about its axis.")

m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "curvature of the rising side, as a stiffness")
L = page.unit("L", "m", "length")

n = page.parameter("n", "N/m", "curvature of the falling side", "> 0", 0.5, becomes="fall")
W = page.parameter("W", "rad/s", "speed of rotation", ">= 0", 1.2)
c = page.parameter("c", "N s/m", "damper on the saddle", ">= 0", 0.0, becomes="zeta")

x = page.coordinate("x", "m", "displacement along the rising side")
y = page.coordinate("y", "m", "displacement along the falling side")

page.kinetic(m * ((page.rate(x) - W * y) ** 2 + (page.rate(y) + W * x) ** 2) / 2)
page.potential((k * x**2 - n * y**2) / 2)
page.damper(c, along=x)
page.damper(c, along=y)
