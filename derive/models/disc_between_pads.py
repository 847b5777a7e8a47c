r"""A disc between two pads that press on its faces: friction couples its displacement across and
its tilting, and a face may lift.

::

            |  pad  |
            +-------+           k_c, N_0
     - - - -~~~~~~~~~- - - - - - - - -  upper
    =====================================>  V
         disc   y, φ      2 h               m, J, k_y, k_t
    =====================================
     - - - -~~~~~~~~~- - - - - - - - -  lower
            +-------+           k_c, N_0
            |  pad  |

An element of the disc, of the thickness 2 h, moves across its plane by y and tilts by φ, on the
stiffnesses k_y and k_t. A pad on either side is pressed on it by N_0 through the contact stiffness
k_c, so that the faces part from the pads where y is ±N_0/k_c. Friction acts along the tilted faces,
where the pads are: it tilts the element by the moments ±μ N (h ∓ y), which differ once y ≠ 0, and
pushes it back across by μ N φ. While both touch, the middle y = φ = 0 begins to flutter at

    μ = |(k_y + 2 k_c)/m − k_t/J| √(m J) / (4 √(N_0 (h k_c − N_0))).

After the two faces of M. R. North, "Disc brake squeal", IMechE C38/76 (1976).
"""

from ..model import Abs, Page, exp, sgn

page = Page(
    "A disc between two pads, coupled by the friction on both of its faces, which may lift."
)

m = page.unit("m", "kg", "mass of the element of the disc")
k_c = page.unit("k_c", "N/m", "contact stiffness of a pad")
h = page.unit("h", "m", "half thickness of the disc")

mu0 = page.parameter("mu0", "1", "friction coefficient at full slip", ">= 0", 0.5, latex=r"\mu_o")
N_0 = page.parameter("N_0", "N", "preload of a pad", "> 0", 0.1, becomes="kappa")
k_y = page.parameter(
    "k_y", "N/m", "stiffness of the disc across its plane", ">= 0", 1.0, becomes="beta"
)
k_t = page.parameter("k_t", "N m", "stiffness of tilting", "> 0", 1.0, becomes="tau")
J = page.parameter("J", "kg m^2", "moment of inertia of the element", "> 0", 0.4, becomes="iota")
V = page.parameter("V", "m/s", "speed of the disc", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law in creep", "> 0", 10.0)

y = page.coordinate("y", "m", "displacement of the disc across its plane")
phi = page.coordinate("phi", "rad", "tilting of the disc")

page.kinetic((m * page.rate(y) ** 2 + J * page.rate(phi) ** 2) / 2)
page.spring(k_y, along=y)
page.potential(k_t * phi**2 / 2)
upper = page.contact(-y - N_0 / k_c, lambda depth: k_c * depth, name="upper")
lower = page.contact(y - N_0 / k_c, lambda depth: k_c * depth, name="lower")
for face, side in ((upper, 1), (lower, -1)):
    page.friction(
        (side * h - y) * phi,
        V,
        lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v),
        at_rest=mu0,
        on=face,
    )
