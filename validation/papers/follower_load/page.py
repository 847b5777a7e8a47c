"""Two bars hinged by springs and dampers, under a load of which a share follows the second bar.

G. Herrmann, R. W. Bungay, On the stability of elastic systems subjected to nonconservative forces,
Journal of Applied Mechanics 31 (1964) 435-440.
"""

from spragsym.derive.model import Page, cos, sin

page = Page("Two hinged bars under a load that follows the second one.")

m = page.unit("m", "kg", "mass at the end; twice as much is at the hinge")
l = page.unit("l", "m", "length of the bars")
c = page.unit("c", "N m", "stiffness of the hinges")

P = page.parameter("P", "N", "load", "real", 1.0)
alpha = page.parameter("alpha", "1", "share of the angle that the load follows", "real", 1.0)
b_1 = page.parameter("b_1", "N m s", "damper of the lower hinge", ">= 0", 0.01, becomes="B_1")
b_2 = page.parameter("b_2", "N m s", "damper of the upper hinge", ">= 0", 0.01, becomes="B_2")

phi_1 = page.coordinate("phi_1", "rad", "angle of the first bar")
phi_2 = page.coordinate("phi_2", "rad", "angle of the second bar")

hinge = (l * sin(phi_1), l * cos(phi_1))
end = (hinge[0] + l * sin(phi_2), hinge[1] + l * cos(phi_2))
squares = [page.rate(x) ** 2 + page.rate(y) ** 2 for x, y in (hinge, end)]
page.kinetic(m * (2 * squares[0] + squares[1]) / 2)
page.potential(c * phi_1**2 / 2 + c * (phi_2 - phi_1) ** 2 / 2)
page.damper(b_1, along=phi_1)
page.damper(b_2, along=phi_2 - phi_1)
page.force(-P * sin(alpha * phi_2), -P * cos(alpha * phi_2), at=end)
