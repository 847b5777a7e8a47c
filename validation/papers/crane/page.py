"""Crane: trolley and load on an elastic rope."""

from spragsym.derive.model import Page, cos, sin

page = Page("A trolley with a load on an elastic rope, on a spring.")
M = page.unit("M", "kg", "trolley")
k = page.unit("k", "N/m", "spring")
l_0 = page.unit("l_0", "m", "rope")
m = page.parameter("m", "kg", "load", "> 0", 0.5, becomes="eta")
c = page.parameter("c", "N/m", "rope stiffness", "> 0", 8.0, becomes="kappa")
g = page.parameter("g", "m/s^2", "gravity", "> 0", 0.7, becomes="gam")
b = page.parameter("b", "N s/m", "friction of trolley", ">= 0", 0.1, becomes="beta")
x = page.coordinate("x", "m", "trolley")
r = page.coordinate("r", "m", "rope length")
theta = page.coordinate("theta", "rad", "angle")
X, Y = x + r * sin(theta), -r * cos(theta)
page.kinetic(M * page.rate(x) ** 2 / 2 + m * (page.rate(X) ** 2 + page.rate(Y) ** 2) / 2)
page.potential(k * x**2 / 2 + c * (r - l_0) ** 2 / 2 + m * g * Y)
page.damper(b, along=x)
