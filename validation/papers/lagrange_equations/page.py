"""A pendulum on a cart that a force pushes: the angle is 0 where it hangs."""

from spragsym.derive.model import Page, cos, sin

page = Page("A pendulum on a cart that a force pushes.")
m_p = page.unit("m_p", "kg", "mass of the pendulum")
l = page.unit("l", "m", "length of the pendulum")
g = page.unit("g", "m/s^2", "acceleration of gravity")
m_c = page.parameter("m_c", "kg", "mass of the cart", "> 0", 2.0, becomes="nu")
f = page.parameter("f", "N", "force on the cart", "real", 0.1, becomes="phi")
x = page.coordinate("x", "m", "displacement of the cart")
theta = page.coordinate("theta", "rad", "angle of the pendulum, 0 where it hangs")
along = page.rate(x + l * sin(theta))
up = page.rate(-l * cos(theta))
page.kinetic((m_c * page.rate(x) ** 2 + m_p * (along**2 + up**2)) / 2)
page.potential(-m_p * g * l * cos(theta))
page.force(f, along=x)
