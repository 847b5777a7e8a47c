r"""The article's model with a second inclined spring.

::

        o  λ_2 L_0 (cos θ₀₂, sin θ₀₂)
         \           o  L_0 (cos θ₀, sin θ₀)
      k_2 \         /
           \       /  k
            \     /
        k_x  +---+
    |--/\/\/-| m |  F_L presses down, k_y ties to the ground
             +---+
          ~~~~k_c~~~~  contact
     ============================>  V
                 belt

As in the model of Kang and Nam a mass lies on a belt, tied by springs k_x and k_y, leaned on by the
spring k and pressed down by F_L. A second spring, of stiffness k_2 and undeformed length λ_2 L_0,
leans on it under the angle θ₀₂.
"""

from ..model import Abs, Page, cos, exp, sgn, sin

page = Page("The article's model with a second inclined spring.")

m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
L_0 = page.unit("L_0", "m", "undeformed length of the first inclined spring", latex="L_o")

theta0 = page.parameter(
    "theta0", "rad", "inclination of the first undeformed spring", "(0, pi)", latex=r"\theta_o"
)
mu0 = page.parameter("mu0", "1", "friction coefficient at full slip", ">= 0", 0.5, latex=r"\mu_o")
F_L = page.parameter(
    "F_L", "N", "preload that presses the mass on the belt", "> 0", 0.007, becomes="kappa"
)
k_x = page.parameter(
    "k_x", "N/m", "stiffness to ground along the belt", ">= 0", 0.007, becomes="alpha"
)
k = page.parameter(
    "k", "N/m", "stiffness of the first inclined spring", "> 0", 0.1, becomes="sigma"
)
k_y = page.parameter(
    "k_y", "N/m", "stiffness to ground across the belt", ">= 0", 0.0, becomes="beta"
)
theta0_2 = page.parameter(
    "theta0_2", "rad", "inclination of the second spring", "(0, pi)", 2.0, latex=r"\theta_{o2}"
)
k_2 = page.parameter(
    "k_2", "N/m", "stiffness of the second inclined spring", ">= 0", 0.05, becomes="sigma_2"
)
lambda_2 = page.parameter(
    "lambda_2", "1", "length of the second spring over that of the first", "> 0", 1.0
)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law in creep", "> 0", 10.0)

x = page.coordinate("x", "m", "displacement along the belt")
y = page.coordinate("y", "m", "displacement across the belt, negative into the belt")
L_2 = lambda_2 * L_0

page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.spring(k_x, along=x)
page.spring(k_y, along=y)
page.spring(k, (x, y), (L_0 * cos(theta0), L_0 * sin(theta0)), length=L_0)
page.spring(k_2, (x, y), (L_2 * cos(theta0_2), L_2 * sin(theta0_2)), length=L_2)
page.force(0, -F_L, at=(x, y))
page.contact(y, lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
