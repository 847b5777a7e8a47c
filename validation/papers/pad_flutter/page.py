"""A pad with bounce and pitch on two contact springs with follower friction (North)."""

from spragsym.derive.model import Page

page = Page("Binary flutter of a pad.")
m = page.unit("m", "kg", "mass")
k_1 = page.unit("k_1", "N/m", "leading spring")
a = page.unit("a", "m", "half length")
k_2 = page.parameter("k_2", "N/m", "trailing spring", "> 0", 1.2, becomes="kappa")
J = page.parameter("J", "kg m^2", "inertia", "> 0", 0.4, becomes="iota")
c_y = page.parameter("c_y", "N s/m", "damper", ">= 0", 0.02, becomes="zeta_y")
c_t = page.parameter("c_t", "N m s", "damper", ">= 0", 0.03, becomes="zeta_t")
h = page.parameter("h", "m", "half thickness", "> 0", 0.3, becomes="eta")
mu = page.parameter("mu", "1", "friction", ">= 0", 0.4)
y = page.coordinate("y", "m", "bounce")
theta = page.coordinate("theta", "rad", "pitch")
page.kinetic((m * page.rate(y) ** 2 + J * page.rate(theta) ** 2) / 2)
f = k_1 * (y + a * theta)
r = k_2 * (y - a * theta)
page.spring(k_1, along=y + a * theta)
page.spring(k_2, along=y - a * theta)
page.damper(c_y, along=y)
page.damper(c_t, along=theta)
page.force(-mu * h * (f + r), along=theta)
