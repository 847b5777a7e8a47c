"""A block on a belt, held by a spring whose other end is shaken, with falling friction."""

from spragsym.derive.model import Abs, Page, cos, sgn

page = Page("A block on a belt, its spring shaken at the other end.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "spring")
F_N = page.unit("F_N", "N", "normal load")
mu_s = page.parameter("mu_s", "1", "static", ">= 0", 0.4)
delta = page.parameter("delta", "s/m", "fall of the friction", "> 0", 3.0)
v_0 = page.parameter("v_0", "m/s", "belt speed", ">= 0", 0.5)
u_0 = page.parameter("u_0", "m", "amplitude of the shaking", ">= 0", 0.5)
Omega = page.parameter("Omega", "1/s", "frequency of the shaking", "> 0", 0.9)
x = page.coordinate("x", "m", "block")
phase = page.clock(Omega)
page.kinetic(m * page.rate(x) ** 2 / 2)
page.potential(k * x**2 / 2)
page.force(k * u_0 * cos(phase), along=x)
page.normal_force(F_N)
page.friction(x, v_0, slip=lambda v: mu_s / (1 + delta * Abs(v)) * sgn(v), holds=mu_s)
