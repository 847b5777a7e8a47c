r"""Stick-slip: one mass, one spring, one damper, and a friction that falls with the sliding speed.

::

                     N_0
               k      |
    |-------/\/\/\--+---+
    |               | m |---> x
    |-------]|------+---+
               c
     ============================>  V
                 belt

A mass is pressed on a belt by the given force N_0 and held by a spring k and a damper c. The
friction coefficient

    μ(v) = 2 μ_s v v_s/(v² + v_s²)

rises to μ_s at the sliding speed v_s and falls beyond it; it is smooth also where v changes its
sign. At steady sliding the spring is stretched by μ(V) N_0/k, and a small deviation obeys x″ + (ζ +
μ′(V)) x′ + x = 0 with ζ = c/√(k m): the slope of the friction law is a damping. Sliding loses its
stability in a Hopf bifurcation where

    ζ = 2 μ_s v_s (V² − v_s²)/(V² + v_s²)².

Lengths are measured in N_0/k, time in √(m/k).
"""

from ..model import Page

page = Page(
    "One mass, one spring, and a falling friction law: stick-slip, with its Hopf point in "
    "closed form."
)

m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness of the spring")
N_0 = page.unit("N_0", "N", "normal force")

mu_s = page.parameter("mu_s", "1", "largest friction coefficient", ">= 0", 0.5)
v_s = page.parameter("v_s", "m/s", "sliding speed at which friction is largest", "> 0", 0.1)
c = page.parameter("c", "N s/m", "damper beside the spring", ">= 0", 0.05, becomes="zeta")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)

x = page.coordinate("x", "m", "displacement along the belt")

page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.damper(c, along=x)
page.normal_force(N_0)
page.friction(x, V, lambda v: 2 * mu_s * v * v_s / (v**2 + v_s**2))
