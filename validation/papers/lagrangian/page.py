"""A pendulum of length d."""

from spragsym.derive.model import Page, cos, sin

page = Page("A pendulum of length d.")

m = page.unit("m", "kg", "mass")
d = page.unit("d", "m", "length")
g = page.unit("g", "m/s^2", "acceleration of gravity")

theta = page.coordinate("theta", "rad", "angle, 0 where it hangs")

page.kinetic(m * (page.rate(d * sin(theta)) ** 2 + page.rate(-d * cos(theta)) ** 2) / 2)
page.potential(-m * g * d * cos(theta))
