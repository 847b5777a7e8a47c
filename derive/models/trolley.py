r"""The article's model whose spring is held by a trolley.

::

                    m_a  x_a
           |--/\/\/-(o)----->   trolley, on a rail along the belt
               k_a  /
                   /
               k  /
                 /  θ
        k_x  +-----+
    |--/\/\/-|  m  |  F_L presses down, k_y ties to the ground
             +-----+
          ~~~~~~k_c~~~~~~  contact
     ============================>  V
                 belt

As in the model of Kang and Nam a mass lies on a belt, tied by springs k_x and k_y, leaned on by the
spring k and pressed down by F_L. The anchor of the inclined spring has the mass m_a and moves along
the belt by x_a, on a spring k_a to the ground.
"""

from ..model import Abs, Page, cos, exp, sgn, sin

page = Page("The article's model whose spring is anchored on a trolley that moves along the belt.")

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
k_a = page.parameter(
    "k_a", "N/m", "stiffness that holds the trolley", "> 0", 0.1, becomes="alpha_a"
)
m_a = page.parameter("m_a", "kg", "mass of the trolley", "> 0", 0.1, becomes="nu_a")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law in creep", "> 0", 10.0)

x = page.coordinate("x", "m", "displacement along the belt")
y = page.coordinate("y", "m", "displacement across the belt, negative into the belt")
x_a = page.coordinate("x_a", "m", "displacement of the trolley along the belt")

page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2 + m_a * page.rate(x_a) ** 2 / 2)
page.spring(k_x, along=x)
page.spring(k_y, along=y)
page.spring(k_a, along=x_a)
page.spring(k, (x, y), (L_0 * cos(theta0) + x_a, L_0 * sin(theta0)), length=L_0)
page.force(0, -F_L, at=(x, y))
page.contact(y, lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
