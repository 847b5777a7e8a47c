r"""The article's model with a friction that falls with the sliding speed.

::

     μ                                     anchor, held at L_0 (cos θ₀, sin θ₀)
     |  _ μ_s                             o
     | / \                            k  /
     ||   \__                           /  θ
     ||      ‾‾‾---___  μ_k    k_x  +-----+
     ||                    |--/\/\/-|  m  |  F_L presses down, k_y ties to the ground
     |+-----------------> v         +-----+
                                 ~~~~~~k_c~~~~~~  contact
                            ============================>  V

As in the model of Kang and Nam a mass lies on a belt, tied by springs k_x and k_y, leaned on by the
spring k and pressed down by F_L. Friction has Stribeck's form: it rises in a thin layer of creep,
1/d, towards μ_s, and falls over speeds of v_s to μ_k. At steady sliding it is μ(V), so that V and d
are parameters of the equilibria too, and its negative slope works against all damping.
"""

from ..model import Abs, Page, cos, exp, sgn, sin

page = Page("The article's model with Stribeck friction, which falls with the sliding speed.")

m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
L_0 = page.unit("L_0", "m", "undeformed length of the inclined spring", latex="L_o")

theta0 = page.parameter(
    "theta0", "rad", "inclination of the undeformed spring", "(0, pi)", latex=r"\theta_o"
)
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
mu_s = page.parameter("mu_s", "1", "friction coefficient towards which creep rises", ">= 0", 0.6)
mu_k = page.parameter("mu_k", "1", "friction coefficient of fast sliding", ">= 0", 0.4)
v_s = page.parameter("v_s", "m/s", "speed over which friction falls", "> 0", 0.5)
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
page.friction(
    x, V, lambda v: (mu_k + (mu_s - mu_k) * exp(-Abs(v) / v_s)) * (1 - exp(-d * Abs(v))) * sgn(v)
)
