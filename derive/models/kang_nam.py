r"""Kang and Nam's minimal model: a mass on a moving belt, leaned on by an inclined spring.

::

                    anchor, held at L_0 (cos θ₀, sin θ₀)
                   o
                  /
             k   /
                /  θ
        k_x  +-----+
    |--/\/\/-|  m  |  F_L presses down, k_y ties to the ground
             +-----+
          ~~~~~~k_c~~~~~~  contact
     ============================>  V
                 belt

A mass m lies on a belt that runs at the speed V. Springs k_x and k_y tie it to the ground, along
the belt and across it. A spring k of undeformed length L_0 leans on it, from an anchor under the
angle θ₀, and a preload F_L presses it on the belt, which carries it through the contact stiffness
k_c and drags it by friction. Lengths are measured in L_0, time in √(m/k_c), forces in k_c L_0.
"""

from ..model import Abs, Page, cos, exp, sgn, sin

page = Page("A mass on a moving belt, leaned on by an inclined spring: the article's model.")

m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
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
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law in creep", "> 0", 10.0)

x = page.coordinate("x", "m", "displacement along the belt")
y = page.coordinate("y", "m", "displacement across the belt, negative into the belt")

page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.spring(k_x, along=x)
page.spring(k_y, along=y)
page.spring(k, (x, y), (L_0 * cos(theta0), L_0 * sin(theta0)), length=L_0)
page.force(0, -F_L, at=(x, y))
page.contact(y, lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
