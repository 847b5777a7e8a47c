r"""The article's model on a belt that gets stiffer the deeper the mass dips into it.

::

                    anchor, held at L_0 (cos θ₀, sin θ₀)
                   o
                  /
             k   /
                /  θ
        k_x  +-----+
    |--/\/\/-|  m  |  F_L presses down, k_y ties to the ground
             +-----+
          ~k_c, k_3~~~~~~  contact: N = k_c δ + k_3 δ³
     ============================>  V
                 belt

As in the model of Kang and Nam a mass lies on a belt, tied by springs k_x and k_y, leaned on by the
spring k and pressed down by F_L. The contact force is a cubic polynomial of the penetration δ: n =
−(y + γ y³) for y < 0, with γ = k_3 L_0²/k_c.
"""

from ..model import Abs, Page, cos, exp, sgn, sin

page = Page("The article's model with a contact that hardens: n = −(y + γ y³).")

m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness at first touch")
L_0 = page.unit("L_0", "m", "undeformed length of the inclined spring", latex="L_o")

theta0 = page.parameter(
    "theta0", "rad", "inclination of the undeformed spring", "(0, pi)", latex=r"\theta_o"
)
mu0 = page.parameter("mu0", "1", "friction coefficient at full slip", ">= 0", 0.5, latex=r"\mu_o")
F_L = page.parameter(
    "F_L", "N", "preload that presses the mass on the belt", "> 0", 0.007, becomes="kappa"
)
k_x = page.parameter(
    "k_x", "N/m", "stiffness to ground along the belt", ">= 0", 0.007, becomes="alpha"
)
k = page.parameter("k", "N/m", "stiffness of the inclined spring", "> 0", 0.1, becomes="sigma")
k_y = page.parameter(
    "k_y", "N/m", "stiffness to ground across the belt", ">= 0", 0.0, becomes="beta"
)
k_3 = page.parameter("k_3", "N/m^3", "hardening of the contact", ">= 0", 100.0, becomes="gamma")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law in creep", "> 0", 10.0)

x = page.coordinate("x", "m", "displacement along the belt")
y = page.coordinate("y", "m", "displacement across the belt, negative into the belt")

page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.spring(k_x, along=x)
page.spring(k_y, along=y)
page.spring(k, (x, y), (L_0 * cos(theta0), L_0 * sin(theta0)), length=L_0)
page.force(0, -F_L, at=(x, y))
page.contact(y, lambda depth: k_c * depth + k_3 * depth**3)
page.friction(x, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
