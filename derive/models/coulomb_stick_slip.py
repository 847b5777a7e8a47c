r"""Stick–slip by dry friction: one mass and one spring on a belt, with a static and a kinetic
coefficient.

::

                     N_0
               k      |
    |-------/\/\/\--+---+
                    | m |---> x
                    +---+
     ============================>  V
                 belt

A mass is pressed on a belt by the given force N_0 and held by a spring k. It rides with the belt
until the spring pulls by μ_s N_0, and slides back against μ_k N_0. Lengths are measured in N_0/k,
time in √(m/k): then it sticks from x = 2 μ_k − μ_s to μ_s, and slides on the circle about x = μ_k,
in the plane of x and x′, through these points with x′ = V. With Δ = μ_s − μ_k the period is

    2 Δ/V + 2 π − 2 atan(Δ/V),

and x reaches from μ_k − A to μ_k + A with A² = Δ² + V².
"""

from ..model import Page, sgn

page = Page(
    "One mass, one spring and dry friction: stick-slip whose period and amplitude have closed "
    "forms."
)

m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness of the spring")
N_0 = page.unit("N_0", "N", "normal force")

mu_s = page.parameter("mu_s", "1", "static friction coefficient", ">= 0", 0.6)
mu_k = page.parameter("mu_k", "1", "kinetic friction coefficient", ">= 0", 0.4)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)

x = page.coordinate("x", "m", "displacement along the belt")

page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.normal_force(N_0)
page.friction(x, V, slip=lambda v: mu_k * sgn(v), holds=mu_s)
