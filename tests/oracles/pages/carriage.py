r"""A mass on a belt whose inclined spring is held by a heavy head: four coordinates.

::

               k_g ) (m_h)   head at L_0 (cos θ₀, sin θ₀) + (x_h, y_h)
                    /
            k, c   /
                  /  θ
        k_x  +-----+
    |--/\/\--|  m  |  F_L presses down
             +-----+
        ~~~~~~k_c~~~~~~
     =====================>  V
"""

from spragsym.derive.model import Abs, Page, cos, exp, sgn, sin

page = Page(
    "A mass on a belt, leaned on by a spring whose upper end is a mass on springs of its own."
)

m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
L_0 = page.unit("L_0", "m", "undeformed length of the spring")

theta0 = page.parameter("theta0", "rad", "inclination of the undeformed spring", "(0, pi)", 0.8)
mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.5)
F_L = page.parameter("F_L", "N", "preload", "> 0", 0.02, becomes="kappa")
k_x = page.parameter("k_x", "N/m", "stiffness to ground", ">= 0", 0.02, becomes="alpha")
k = page.parameter("k", "N/m", "stiffness of the spring", "> 0", 0.1, becomes="sigma")
k_g = page.parameter("k_g", "N/m", "stiffness that holds the head", "> 0", 0.3, becomes="gamma")
m_h = page.parameter("m_h", "kg", "mass of the head", "> 0", 0.5, becomes="nu")
c = page.parameter("c", "N s/m", "damper between both masses", ">= 0", 0.05, becomes="zeta")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law", "> 0", 10.0)

x = page.coordinate("x", "m", "displacement along the belt")
y = page.coordinate("y", "m", "displacement across the belt")
x_h = page.coordinate("x_h", "m", "displacement of the head along the belt")
y_h = page.coordinate("y_h", "m", "displacement of the head across the belt")
head = (L_0 * cos(theta0) + x_h, L_0 * sin(theta0) + y_h)

page.kinetic(
    m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2
    + m_h * (page.rate(x_h) ** 2 + page.rate(y_h) ** 2) / 2
)
page.spring(k_x, along=x)
page.spring(k_g, along=x_h)
page.spring(k_g, along=y_h)
page.spring(k, (x, y), head, length=L_0)
page.damper(c, (x, y), head)
page.force(0, -F_L, at=(x, y))
page.contact(y, lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
