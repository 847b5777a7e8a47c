r"""The article's model with dampers along the belt, across it, and beside the inclined spring.

::

                    anchor, held at L_0 (cos θ₀, sin θ₀)
                   o
                  //
        k and c_s//
                //  θ
    k_x, c_x +-----+
    |--/\/\/-|  m  |  F_L presses down, k_y and c_y tie to the ground
    |---]|---|     |
             +-----+
          ~~~~~~k_c~~~~~~  contact
     ============================>  V
                 belt

As in the model of Kang and Nam a mass lies on a belt, tied by springs k_x and k_y, leaned on by the
spring k and pressed down by F_L. Every spring has a viscous damper beside it. With ζ = c/√(k_c m)
for each of them the forces are −ζ_x x′, −ζ_y y′, and −ζ_s L′ along the inclined spring. At rest
dampers push nothing: the equilibria are those of the article, and only the linearization differs.
"""

from ..model import Abs, Page, cos, exp, sgn, sin

page = Page("The article's model with a damper beside every spring.")

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
c_x = page.parameter(
    "c_x", "N s/m", "damper to ground along the belt", ">= 0", 0.01, becomes="zeta_x"
)
c_y = page.parameter(
    "c_y", "N s/m", "damper to ground across the belt", ">= 0", 0.01, becomes="zeta_y"
)
c_s = page.parameter(
    "c_s", "N s/m", "damper beside the inclined spring", ">= 0", 0.01, becomes="zeta_s"
)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law in creep", "> 0", 10.0)

x = page.coordinate("x", "m", "displacement along the belt")
y = page.coordinate("y", "m", "displacement across the belt, negative into the belt")

page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.spring(k_x, along=x)
page.spring(k_y, along=y)
page.spring(k, (x, y), (L_0 * cos(theta0), L_0 * sin(theta0)), length=L_0)
page.damper(c_x, along=x)
page.damper(c_y, along=y)
page.damper(c_s, (x, y), (L_0 * cos(theta0), L_0 * sin(theta0)))
page.force(0, -F_L, at=(x, y))
page.contact(y, lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
