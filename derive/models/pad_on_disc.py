r"""A brake pad between its piston and a disc that gives way: four coordinates.

::

               F_L
                |
             +--v--+
             | m_z |  z   piston
             +-----+
                >            o  L_0 (cos θ₀, sin θ₀)
                > k_p       /
                >          /  k
        k_x  +-----+      /
    |--/\/\/-|  m  |-----+   x, y   pad
             +-----+
          ~~~~~~k_c~~~~~~    contact, gap y − w
        +-----------------+
        |       m_w       |  w   disc  ====>  V
        +-----------------+
            > k_w   |_| c_w
            >       | |
        ///////////////////

The pad, of the mass m, is held along the disc by k_x and leaned on by the inclined spring k, as in
the model of Kang and Nam. The piston m_z presses on its back through k_p with the force F_L. Below
it the disc, of the mass m_w, bends away from the pad by w, on the stiffness k_w and with the
damping c_w: the gap is y − w.

Piston and disc change where the pad is, and the normal force not at all: what rests here rests in
the article's model too, whose contact stiffness is that of k_c and k_w in a row, k_c k_w/(k_c +
k_w). What moves does not.
"""

from ..model import Abs, Page, cos, exp, sgn, sin

page = Page(
    "A brake pad with its piston on a disc that gives way, leaned on by an inclined spring."
)

m = page.unit("m", "kg", "mass of the pad")
k_c = page.unit("k_c", "N/m", "contact stiffness")
L_0 = page.unit("L_0", "m", "undeformed length of the inclined spring", latex="L_o")

theta0 = page.parameter(
    "theta0", "rad", "inclination of the undeformed spring", "(0, pi)", latex=r"\theta_o"
)
mu0 = page.parameter("mu0", "1", "friction coefficient at full slip", ">= 0", 0.5, latex=r"\mu_o")
F_L = page.parameter("F_L", "N", "force on the piston", "> 0", 0.007, becomes="kappa")
k_x = page.parameter(
    "k_x", "N/m", "stiffness that holds the pad along the disc", "> 0", 0.007, becomes="alpha"
)
k = page.parameter("k", "N/m", "stiffness of the inclined spring", "> 0", 0.1, becomes="sigma")
k_p = page.parameter(
    "k_p", "N/m", "stiffness between piston and pad", "> 0", 0.5, becomes="sigma_p"
)
k_w = page.parameter("k_w", "N/m", "stiffness of the disc", "> 0", 4.0, becomes="sigma_w")
m_z = page.parameter("m_z", "kg", "mass of the piston", "> 0", 0.5, becomes="nu_z")
m_w = page.parameter("m_w", "kg", "mass of the disc", "> 0", 5.0, becomes="nu_w")
c_w = page.parameter("c_w", "N s/m", "damping of the disc", ">= 0", 0.1, becomes="zeta_w")
V = page.parameter("V", "m/s", "speed of the disc", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law in creep", "> 0", 10.0)

x = page.coordinate("x", "m", "displacement of the pad along the disc")
y = page.coordinate("y", "m", "displacement of the pad across the disc")
w = page.coordinate("w", "m", "displacement of the disc, negative away from the pad")
z = page.coordinate("z", "m", "displacement of the piston, negative towards the pad")

page.kinetic(
    (
        m * (page.rate(x) ** 2 + page.rate(y) ** 2)
        + m_w * page.rate(w) ** 2
        + m_z * page.rate(z) ** 2
    )
    / 2
)
page.spring(k_x, along=x)
page.spring(k, (x, y), (L_0 * cos(theta0), L_0 * sin(theta0)), length=L_0)
page.spring(k_p, along=z - y)
page.spring(k_w, along=w)
page.damper(c_w, along=w)
page.force(-F_L, along=z)
page.contact(y - w, lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
