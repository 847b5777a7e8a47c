"""Two links, the second driven at the elbow: moments of inertia are taken about the pivots."""

from spragsym.derive.model import Page, cos, sin

page = Page("Two links that hang, the second driven at the elbow.")

m_1 = page.unit("m_1", "kg", "mass of the first link")
l_1 = page.unit("l_1", "m", "length of the first link")
g = page.unit("g", "m/s^2", "acceleration of gravity")

m_2 = page.parameter("m_2", "kg", "mass of the second link", "> 0", 1.0, becomes="nu")
l_c1 = page.parameter("l_c1", "m", "centre of the first link", "> 0", 0.5, becomes="r1")
l_c2 = page.parameter("l_c2", "m", "centre of the second link", "> 0", 0.5, becomes="r2")
I_1 = page.parameter("I_1", "kg m^2", "inertia of the first link", "> 0", 0.4, becomes="j1")
I_2 = page.parameter("I_2", "kg m^2", "inertia of the second link", "> 0", 0.4, becomes="j2")
tau_e = page.parameter("tau_e", "N m", "torque at the elbow", "real", 0.1, becomes="tq")

q1 = page.coordinate("q1", "rad", "angle of the shoulder")
q2 = page.coordinate("q2", "rad", "angle of the elbow, relative")

v1, v2 = page.rate(q1), page.rate(q1 + q2)
elbow_x, elbow_y = page.rate(l_1 * sin(q1)), page.rate(-l_1 * cos(q1))
centre_x = elbow_x + page.rate(l_c2 * sin(q1 + q2))
centre_y = elbow_y + page.rate(-l_c2 * cos(q1 + q2))
own = I_2 - m_2 * l_c2**2
page.kinetic((I_1 * v1**2 + m_2 * (centre_x**2 + centre_y**2) + own * v2**2) / 2)
page.potential(-m_1 * g * l_c1 * cos(q1) - m_2 * g * (l_1 * cos(q1) + l_c2 * cos(q1 + q2)))
page.force(tau_e, along=q2)
