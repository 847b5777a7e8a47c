"""Three blocks in a row on a belt, each on a leaf spring and tied to its neighbours.

R. Burridge and L. Knopoff, Model and theoretical seismicity, Bulletin of the Seismological Society
of America 57 (1967) 341-371; here with Coulomb's friction, and seen from the plate that pulls.
"""

from spragsym.derive.model import Page, sgn

page = Page("Three blocks in a row on a belt, each on a leaf spring and tied to its neighbours.")

m = page.unit("m", "kg", "mass of a block")
k_p = page.unit("k_p", "N/m", "leaf spring of a block")
N = page.unit("N", "N", "normal force of a block")

mu_s = page.parameter("mu_s", "1", "friction coefficient that holds", "> 0", 0.5)
mu_k = page.parameter("mu_k", "1", "friction coefficient of sliding", "> 0", 0.3)
k_c = page.parameter("k_c", "N/m", "spring between neighbours", ">= 0", 1.0, becomes="kappa")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.1)

x_1 = page.coordinate("x_1", "m", "displacement of the first block")
x_2 = page.coordinate("x_2", "m", "displacement of the second block")
x_3 = page.coordinate("x_3", "m", "displacement of the third block")

page.kinetic(m * (page.rate(x_1) ** 2 + page.rate(x_2) ** 2 + page.rate(x_3) ** 2) / 2)
page.potential(k_p * (x_1**2 + x_2**2 + x_3**2) / 2)
page.potential(k_c * ((x_1 - x_2) ** 2 + (x_2 - x_3) ** 2) / 2)
for number, x in enumerate((x_1, x_2, x_3), 1):
    block = page.normal_force(N, name=f"block_{number}")
    page.friction(x, V, slip=lambda v: mu_k * sgn(v), holds=mu_s, on=block)
