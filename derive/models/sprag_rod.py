r"""A rod on a pivot whose tip leans on a moving wall: sprag-slip in one coordinate.

::

      ///////////////////////////
                 o))  k_t, c_t   pivot, at the height h = l cos θ₀
                /|
               / |
           l  /φ |
             / m |
            /    |
      -----*-------------------
        ~~~k_c~~~  contact
      ========================>  V
                wall

A uniform rod of length l and mass m turns on a pivot at the distance h = l cos θ₀ from a wall that
moves with the speed V. It is turned by φ against the motion, and its tip touches the wall where |φ|
is less than θ₀: the gap is h − l cos φ. A torsion spring k_t, at rest at φ = θ₀ − ψ, presses the
tip on the wall; a damper c_t turns with it.

Friction pulls the tip along with the wall, below the pivot, and so deeper in. Where the contact is
stiff, the tip stays at the angle θ₀, and the moments k_t ψ of the spring, N l sin θ₀ of the normal
force and μ N l cos θ₀ of friction give

    N = k_t ψ / (l (sin θ₀ − μ cos θ₀)),

which grows beyond all bounds as θ₀ comes down to the jamming angle, tan θ₀ = μ: there the rod locks
the wall. The wall of this page gives way: close to the jamming angle the rod jumps, through the
upright position, to the other side, where it trails.
"""

from ..model import Abs, Page, cos, exp, pi, sgn, sin

page = Page("A rod on a pivot with a torsion spring, whose tip leans against a moving wall.")

m = page.unit("m", "kg", "mass of the rod")
k_c = page.unit("k_c", "N/m", "contact stiffness")
l = page.unit("l", "m", "length of the rod")

theta0 = page.parameter(
    "theta0",
    "rad",
    "angle of the rod to the wall's normal at touch",
    "(0, pi/2)",
    latex=r"\theta_o",
)
mu0 = page.parameter("mu0", "1", "friction coefficient at full slip", ">= 0", 0.4, latex=r"\mu_o")
k_t = page.parameter("k_t", "N m", "stiffness of the torsion spring", "> 0", 0.01, becomes="kappa")
psi = page.parameter(
    "psi", "rad", "turn by which the torsion spring presses the rod on the wall", "(0, pi)", 0.1
)
c_t = page.parameter("c_t", "N m s", "damping of the pivot", ">= 0", 0.01, becomes="zeta")
V = page.parameter("V", "m/s", "speed of the wall", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law in creep", "> 0", 10.0)

phi = page.coordinate(
    "phi", "rad", "angle of the rod to the wall's normal, against the motion", latex=r"\varphi"
)

page.kinetic(m * l**2 / 3 * page.rate(phi) ** 2 / 2)
page.torsion(k_t, (-l * sin(phi), 0), (0, l * cos(phi)), rest=pi / 2 - theta0 + psi)
page.damper(c_t, along=phi)
page.contact(l * cos(theta0) - l * cos(phi), lambda depth: k_c * depth)
page.friction(-l * sin(phi), V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
