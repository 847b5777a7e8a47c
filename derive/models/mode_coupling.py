r"""Flutter by mode coupling: two linear modes that friction couples, with a threshold in closed
form.

::

                 |
                 > k_y
                 >
        k_x   +-----+
    |--/\/\/--|  m  |  F_L presses down
              +-----+
              / ~k_c~  contact
             / k, leaning against the motion under 45°
     ============================>  V
                 belt

A mass is pressed on a belt by F_L and always touches it, through the contact stiffness k_c; where
the contact would pull, it is an opposite face that presses and rubs, as in a slot. Springs
k_x and k_y tie it to the ground along the belt and across it, and a third one, k, under 45°,
couples the two: its length changes by (x − y)/√2. All of it is linear. In units of k_c the
stiffness matrix is, with α = k_x/k_c, β = k_y/k_c and σ = k/k_c,

    K = ( α + σ/2       μ − σ/2    )
        ( −σ/2       1 + β + σ/2   ).

Its modes come together, and flutter begins, where (K₁₁ − K₂₂)² + 4 K₁₂ K₂₁ = 0, which is at the
friction

    μ = ((1 + β − α)² + σ²)/(2 σ).

Lengths are measured in F_L/k_c: the preload alone dips the mass by 1.
"""

from ..model import Abs, Page, exp, sgn

page = Page("A linear model of two degrees of freedom that flutters by mode coupling.")

m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
F_L = page.unit("F_L", "N", "preload that presses the mass on the belt")

mu0 = page.parameter("mu0", "1", "friction coefficient at full slip", ">= 0", 0.3, latex=r"\mu_o")
k_x = page.parameter(
    "k_x", "N/m", "stiffness to ground along the belt", ">= 0", 1.3, becomes="alpha"
)
k = page.parameter("k", "N/m", "stiffness of the spring under 45°", "> 0", 0.5, becomes="sigma")
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
page.potential(k * (x - y) ** 2 / 4)
page.force(0, -F_L, at=(x, y))
page.contact(y, lambda depth: k_c * depth, unilateral=False)
page.friction(x, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
