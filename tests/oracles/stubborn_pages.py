"""Pages whose states are found late: of angles that no turn repeats, of springs that harden, of polar
coordinates.
"""

from functools import cache
from typing import Any

from tests.oracles.user_pages import model_of, shipped_page

#: A double pendulum whose tip rubs on a belt, its joints held by springs, so that no angle repeats.
PENDULUM = '''r"""Two rods.

::

    o--o--o
"""

from spragsym.derive.model import Page, cos, sin, tanh

page = Page("Two rods that hang from a pivot and rub on a belt.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
l = page.unit("l", "m", "length")
mu0 = page.parameter("mu0", "1", "friction", ">= 0", 0.4)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
V = page.parameter("V", "m/s", "speed", ">= 0", 0.8)
G = page.parameter("G", "N", "weight", "> 0", 0.5)
H = page.parameter("H", "m", "belt below the pivot", "> 0", 1.8)
K = page.parameter("K", "N/m", "contact", "> 0", 20.0)
k_t = page.parameter("k_t", "N m", "joints", ">= 0", 0.1)
a = page.coordinate("a", "rad", "first")
b = page.coordinate("b", "rad", "second")
va, vb = page.rate(a), page.rate(b)
page.kinetic(m * l**2 * (2 * va**2 + vb**2 + 2 * va * vb * cos(a - b)) / 2)
page.potential(k_t * (a**2 + (b - a) ** 2) / 2)
page.potential(-G * l * (2 * cos(a) + cos(b)))
page.contact(H - l * cos(a) - l * cos(b), lambda s: K * s)
page.friction(l * (sin(a) + sin(b)), V, lambda v: mu0 * tanh(d * v))
'''


@cache
def pendulum() -> Any:
    """The two rods."""
    return model_of(PENDULUM, "pendulum")


@cache
def hardening() -> Any:
    """Two inclined springs, of which the second is a potential that hardens."""
    spring = "page.spring(k_2, (x, y), (L_2 * cos(theta0_2), L_2 * sin(theta0_2)), length=L_2)"
    return model_of(
        shipped_page(
            "two_springs",
            ("import Abs", "import sqrt, Abs"),
            (
                spring,
                'k_3 = page.parameter("k_3", "N/m^3", "hardening", ">= 0", 0.02)\n'
                "far = sqrt((L_2*cos(theta0_2) - x)**2 + (L_2*sin(theta0_2) - y)**2) - L_2\n"
                "page.potential(k_2 * far**2 / 2 + k_3 * far**4 / 4)",
            ),
        ),
        "hardening",
    )


#: A mass in a turning frame in polar coordinates, whose inertia r² vanishes in the middle.
POLAR = '''r"""A mass.

::

    r, f
"""

from spragsym.derive.model import Page, cos, sin, tanh

page = Page("A whirling mass in polar coordinates, within a stator.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
l = page.unit("l", "m", "length")
W = page.parameter("W", "rad/s", "speed", "> 0", 0.8)
e = page.parameter("e", "m", "eccentricity", "> 0", 0.3)
c = page.parameter("c", "N s/m", "damping", ">= 0", 0.1)
g = page.parameter("g", "m", "clearance", "> 0", 0.5)
mu0 = page.parameter("mu0", "1", "friction", ">= 0", 0.1)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
V = page.parameter("V", "m/s", "surface speed", "> 0", 1.0)
r = page.coordinate("r", "m", "radius")
f = page.coordinate("f", "rad", "angle")
page.kinetic(m * (page.rate(r) ** 2 + r**2 * (page.rate(f) + W) ** 2) / 2)
page.spring(k, along=r)
page.damper(c, along=r)
page.damper(c * r**2, along=f)
page.force(m * e * W**2 * cos(f), along=r)
page.force(-m * e * W**2 * r * sin(f) - c * r**2 * W, along=f)
page.contact(g - r, lambda s: 10 * k * s)
page.friction(-g * f, V, lambda v: mu0 * tanh(d * v))
'''


@cache
def polar() -> Any:
    """The whirling mass."""
    return model_of(POLAR, "polar")
