"""A disc on a shaft that is damped in itself, and by bearings on the ground, in the frame that
turns with it.

A. L. Kimball, Internal friction theory of shaft whirling, General Electric Review 27 (1924)
244-251: above the critical speed a damper that turns along makes the disc whirl.
"""

from spragsym.derive.model import Page

page = Page("A disc on a shaft that is damped in itself and on the ground, in a turning frame.")

m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness of the shaft")
L = page.unit("L", "m", "length")

c_i = page.parameter("c_i", "N s/m", "damper of the shaft", "> 0", 0.1, becomes="zeta_i")
c_e = page.parameter("c_e", "N s/m", "damper on the ground", "> 0", 0.05, becomes="zeta_e")
W = page.parameter("W", "rad/s", "speed of rotation", ">= 0", 1.0)

x = page.coordinate("x", "m", "displacement along the first axis")
y = page.coordinate("y", "m", "displacement along the second axis")

page.kinetic(m * ((page.rate(x) - W * y) ** 2 + (page.rate(y) + W * x) ** 2) / 2)
page.potential(k * (x**2 + y**2) / 2)
page.damper(c_i + c_e, along=x)
page.damper(c_i + c_e, along=y)
page.force(c_e * W * y, along=x)
page.force(-c_e * W * x, along=y)
