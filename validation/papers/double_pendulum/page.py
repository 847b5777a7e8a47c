"""Two masses on rods that hang below each other: both angles are 0 where they hang."""

from spragsym.derive.model import Page, cos, sin

page = Page("Two masses on rods that hang below each other.")

m_1 = page.unit("m_1", "kg", "mass of the first object")
L_1 = page.unit("L_1", "m", "length of the first rod")
g = page.unit("g", "m/s^2", "acceleration of gravity")

m_2 = page.parameter("m_2", "kg", "mass of the second object", "> 0", 0.5, becomes="nu")
L_2 = page.parameter("L_2", "m", "length of the second rod", "> 0", 1.5, becomes="ell")

theta_1 = page.coordinate("theta_1", "rad", "angle of the first rod")
theta_2 = page.coordinate("theta_2", "rad", "angle of the second rod")

x_1, y_1 = L_1 * sin(theta_1), -L_1 * cos(theta_1)
x_2, y_2 = x_1 + L_2 * sin(theta_2), y_1 - L_2 * cos(theta_2)
squares = [page.rate(x) ** 2 + page.rate(y) ** 2 for x, y in ((x_1, y_1), (x_2, y_2))]
page.kinetic((m_1 * squares[0] + m_2 * squares[1]) / 2)
page.potential(m_1 * g * y_1 + m_2 * g * y_2)
