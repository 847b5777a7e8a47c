r"""A pad on two legs that a load presses onto a belt: friction tilts it, and the rear leg may lift.

::

                  | F
                  v
            +-----------+                 m, J, k_x, k_t, c
            |  x, y, φ  |  - - -
            ++---------++     | h
        front|         |rear  |           k_c
        ==================================>  V
             |<- 2 a ->|

A pad is held along the belt by the stiffness k_x and against tilting by k_t; c damps its motion
across. The load F presses it on two legs at the distance a before and behind its centre, each of
the contact stiffness k_c. Friction, μF in all, acts at the height h below the centre and presses
the front leg, which the belt reaches first: steady sliding on both legs is tilted by

    φ = μ h F/(2 k_c a² + k_t),

and the rear leg lifts at

    μ = (2 k_c a² + k_t)/(2 k_c a h).

With k_t = 0 that is a/h, where the pad turns over: its sliding ends there.

Elementary statics.
"""

from ..model import Abs, Page, exp, sgn

page = Page("A pad on two legs that a load presses onto a belt: friction tilts it, a leg may lift.")

m = page.unit("m", "kg", "mass of the pad")
k_c = page.unit("k_c", "N/m", "contact stiffness of a leg")
a = page.unit("a", "m", "half the distance between the legs")

mu0 = page.parameter("mu0", "1", "friction coefficient at full slip", ">= 0", 0.5, latex=r"\mu_o")
F = page.parameter("F", "N", "load on the pad", "> 0", 0.05, becomes="kappa")
k_x = page.parameter("k_x", "N/m", "stiffness along the belt", "> 0", 0.5, becomes="alpha")
k_t = page.parameter("k_t", "N m", "stiffness of tilting", ">= 0", 0.3, becomes="tau")
h = page.parameter("h", "m", "height of the centre above the belt", "> 0", 0.8, becomes="eta")
J = page.parameter("J", "kg m^2", "moment of inertia of the pad", "> 0", 0.3, becomes="iota")
c = page.parameter("c", "N s/m", "damping across the belt", ">= 0", 0.1, becomes="zeta")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law in creep", "> 0", 10.0)

x = page.coordinate("x", "m", "displacement along the belt")
y = page.coordinate("y", "m", "displacement across the belt, negative into the belt")
phi = page.coordinate("phi", "rad", "tilting of the pad, which presses the front leg")

page.kinetic((m * (page.rate(x) ** 2 + page.rate(y) ** 2) + J * page.rate(phi) ** 2) / 2)
page.spring(k_x, along=x)
page.potential(k_t * phi**2 / 2)
page.damper(c, along=y)
page.force(-F, along=y)
front = page.contact(y - a * phi, lambda depth: k_c * depth, name="front")
rear = page.contact(y + a * phi, lambda depth: k_c * depth, name="rear")
for leg in (front, rear):
    page.friction(
        x + h * phi,
        V,
        lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v),
        at_rest=mu0,
        on=leg,
    )
