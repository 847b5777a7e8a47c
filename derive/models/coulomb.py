r"""The article's model with dry friction: the mass sticks to the belt until the static coefficient
is used up.

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

All but the friction is as in the article: springs k_x and k_y to the ground, an inclined spring k,
a preload F_L and the contact stiffness k_c. The article lets friction rise as μ₀ (1 − exp(−d |v|))
with the sliding speed v, so that what sticks creeps. Here the belt holds the mass by any force up
to μ₀ N, and μ₀ times the ratio of kinetic to static friction is left where it slides. A ratio of 1
is the limit d → ∞ of the article's law.
"""

from ..model import Page, cos, sgn, sin

page = Page(
    "The article's model with dry friction, which holds the mass until its static coefficient "
    "is used up."
)

m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
L_0 = page.unit("L_0", "m", "undeformed length of the inclined spring", latex="L_o")

theta0 = page.parameter(
    "theta0", "rad", "inclination of the undeformed spring", "(0, pi)", latex=r"\theta_o"
)
mu0 = page.parameter("mu0", "1", "static friction coefficient", ">= 0", 0.5, latex=r"\mu_o")
ratio = page.parameter("ratio", "1", "kinetic over static friction coefficient", "[0, 1]", 1.0)
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

x = page.coordinate("x", "m", "displacement along the belt")
y = page.coordinate("y", "m", "displacement across the belt, negative into the belt")

page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.spring(k_x, along=x)
page.spring(k_y, along=y)
page.spring(k, (x, y), (L_0 * cos(theta0), L_0 * sin(theta0)), length=L_0)
page.force(0, -F_L, at=(x, y))
page.contact(y, lambda depth: k_c * depth)
page.friction(x, V, slip=lambda v: mu0 * ratio * sgn(v), holds=mu0)
