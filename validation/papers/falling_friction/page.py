"""A block on a belt with Stribeck friction, Duffing spring."""

from spragsym.derive.model import Page, exp, sgn

page = Page("A block on a belt with a hardening spring and friction that falls.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "spring")
N_0 = page.unit("N_0", "N", "normal load")
k_3 = page.parameter("k_3", "N/m^3", "cubic spring", ">= 0", 0.1, becomes="kappa_3")
c = page.parameter("c", "N s/m", "damper", ">= 0", 0.05)
mu_s = page.parameter("mu_s", "1", "static", ">= 0", 0.5)
mu_m = page.parameter("mu_m", "1", "kinetic", ">= 0", 0.3)
v_s = page.parameter("v_s", "m/s", "Stribeck speed", "> 0", 0.2)
v_0 = page.parameter("v_0", "m/s", "belt speed", ">= 0", 0.5)
x = page.coordinate("x", "m", "block")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.potential(k_3 * x**4 / 4)
page.damper(c, along=x)
page.normal_force(N_0)
page.friction(
    x, v_0, slip=lambda v: (mu_m + (mu_s - mu_m) * exp(-abs(v) / v_s)) * sgn(v), holds=mu_s
)
