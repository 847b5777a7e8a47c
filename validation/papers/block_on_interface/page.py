"""A rigid block on a belt with a power law of the interface (Martins, Oden, Simoes 1990)."""

from spragsym.derive.model import Page, sgn

page = Page("A block with a compliant interface on a belt.")
M = page.unit("M", "kg", "mass")
c_n = page.unit("c_n", "N/m^(5/2)", "interface")
L = page.unit("L", "m", "length")
K_x = page.parameter("K_x", "N/m", "spring", "> 0", 0.6, becomes="kappa")
C_x = page.parameter("C_x", "N s/m", "damper", ">= 0", 0.05, becomes="zeta_x")
C_y = page.parameter("C_y", "N s/m", "damper", ">= 0", 0.05, becomes="zeta_y")
W = page.parameter("W", "N", "weight", "> 0", 0.2, becomes="w")
mu_0 = page.parameter("mu_0", "1", "friction", ">= 0", 0.3)
U = page.parameter("U", "m/s", "belt", "> 0", 0.3, becomes="u")
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "upward")
page.kinetic(M * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.spring(K_x, along=x)
page.damper(C_x, along=x)
page.damper(C_y, along=y)
page.force(0, -W, at=(x, y))
page.contact(y, lambda a: c_n * a ** (5 / 2))
page.friction(x, U, slip=lambda w: mu_0 * sgn(w), holds=mu_0)
