r"""A mass on a belt that gets harder exponentially: a smooth penalty.

::

                o   anchor at L_0 (cos θ₀, sin θ₀)
               /
           k  /  θ
        +-----+
        |  m  |  F_L presses down, k_x ties to the ground
        +-----+
      ~~~ N = k_c l (e^(δ/l) − 1) ~~~
      ======================>  V
"""

from spragsym.derive.model import Abs, Page, cos, exp, sgn, sin

page = Page("A mass on a belt whose contact hardens exponentially, leaned on by a spring.")

m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness at first touch")
L_0 = page.unit("L_0", "m", "undeformed length of the spring")

theta0 = page.parameter("theta0", "rad", "inclination of the undeformed spring", "(0, pi)", 0.8)
mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.5)
F_L = page.parameter("F_L", "N", "preload", "> 0", 0.007, becomes="kappa")
k_x = page.parameter("k_x", "N/m", "stiffness to ground", ">= 0", 0.007, becomes="alpha")
k = page.parameter("k", "N/m", "stiffness of the spring", "> 0", 0.1, becomes="sigma")
l = page.parameter(
    "l", "m", "depth over which the belt gets e times as hard", "> 0", 0.05, becomes="depth_e"
)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law", "> 0", 10.0)

x = page.coordinate("x", "m", "displacement along the belt")
y = page.coordinate("y", "m", "displacement across the belt")

page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.spring(k_x, along=x)
page.spring(k, (x, y), (L_0 * cos(theta0), L_0 * sin(theta0)), length=L_0)
page.force(0, -F_L, at=(x, y))
page.contact(y, lambda depth: k_c * l * (exp(depth / l) - 1))
page.friction(x, V, lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0)
