"""Two rods with a torsion spring between them, pressed together by a load."""

from spragsym.derive.model import Page, cos

page = Page("Two rods with a torsion spring between them, pressed together by a load.")

m = page.unit("m_j", "kg", "mass of the joint")
k = page.unit("k", "N m", "torsion spring")
l = page.unit("l", "m", "length of a rod")

theta_0 = page.parameter("theta_i", "rad", "inclination without load", "(0, pi)", 0.05)
P = page.parameter("P", "N", "load", ">= 0", 0.5, becomes="load")

theta = page.coordinate("theta", "rad", "inclination of a rod")

page.kinetic(m * l**2 * page.rate(theta) ** 2 / 2)
page.potential(k * (2 * (theta - theta_0)) ** 2 / 2 + 2 * P * l * cos(theta))
