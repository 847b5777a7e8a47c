"""A pendulum that hangs, with a damping torque and a constant torque."""

from spragsym.derive.model import Page, cos, sin

page = Page("A pendulum that hangs, with a damping torque and a constant torque.")

m = page.unit("m", "kg", "mass")
l = page.unit("l", "m", "length")
g = page.unit("g", "m/s^2", "acceleration of gravity")

b = page.parameter("b", "N m s", "damping", ">= 0", 0.1, becomes="beta")
u_0 = page.parameter("u_0", "N m", "torque", "real", 0.2, becomes="nu")

theta = page.coordinate("theta", "rad", "angle, 0 where it hangs")

page.kinetic(m * (page.rate(l * sin(theta)) ** 2 + page.rate(-l * cos(theta)) ** 2) / 2)
page.potential(-m * g * l * cos(theta))
page.damper(b, along=theta)
page.force(u_0, along=theta)
