"""Pages with several contacts, and their equilibria by hand.

Where all forces are linear between the borders of the contacts, each combination of contacts that
touch is one linear system: its solution counts where the gaps of these are ≤ 0 and those of the
others are > 0.
"""

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

HEAD = '''r"""A page of the tests."""
from spragsym.derive.model import Abs, Page, cos, exp, sgn, sin, tanh
page = Page("A page of the tests.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
a = page.unit("a", "m", "length")
mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.3)
V = page.parameter("V", "m/s", "belt speed", "> 0", 0.5)
def law(v):
    return mu0 * tanh(20 * v / V)
'''

#: A body on legs, which a load presses onto a belt and friction turns.
PAD = (
    HEAD
    + """
F = page.parameter("F", "N", "load", ">= 0", 0.05)
k_x = page.parameter("k_x", "N/m", "stiffness along", "> 0", 0.5)
k_t = page.parameter("k_t", "N m", "stiffness of turning", ">= 0", 0.3)
h = page.parameter("h", "m", "height of the centre", "> 0", 0.8)
x = page.coordinate("x", "m", "along the belt")
y = page.coordinate("y", "m", "across it")
phi = page.coordinate("phi", "rad", "turning")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2 + 0.3 * m * a**2 * page.rate(phi)**2 / 2)
page.spring(k_x, along=x)
page.potential(k_t * phi**2 / 2 + F * y)
front = page.contact(y - a * phi, lambda depth: k_c * depth, name="front")
rear = page.contact(y + a * phi, lambda depth: k_c * depth, name="rear")
page.friction(x + h * phi, V, law, at_rest=mu0, on=front)
page.friction(x + h * phi, V, law, at_rest=mu0, on=rear)
"""
)
#: The same with a third leg in the middle, which is shorter.
THREE = (
    PAD
    + """
s = page.parameter("s", "m", "what the third leg is shorter by", ">= 0", 0.01)
middle = page.contact(y + s, lambda depth: 2 * k_c * depth, name="middle")
page.friction(x + h * phi, V, law, at_rest=mu0, on=middle)
"""
)
#: And with a stop without friction in front.
FOUR = (
    THREE
    + """
g = page.parameter("g", "m", "play before the stop", ">= 0", 0.02)
page.contact(g - x, lambda depth: k_c * depth, name="stop")
"""
)

#: Shoes of a drum brake on their pivots: one whose friction presses it on, one that it lifts off.
SHOES = (
    HEAD
    + """
F = page.parameter("F", "N", "actuating force", "> 0", 0.05)
l = page.parameter("l", "m", "its arm", "> 0", 1.5)
b = page.parameter("b", "m", "arm of the normal force", "> 0", 0.7)
c = page.parameter("c", "m", "arm of friction", "> 0", 0.9)
phi = page.coordinate("phi", "rad", "turning of the leading shoe")
psi = page.coordinate("psi", "rad", "turning of the trailing shoe")
page.kinetic(m * a**2 * (page.rate(phi)**2 + page.rate(psi)**2) / 2)
page.force(F * l, along=phi)
page.force(F * l, along=psi)
leading = page.contact(-b * phi, lambda depth: k_c * depth, name="leading")
trailing = page.contact(-b * psi, lambda depth: k_c * depth, name="trailing")
page.friction(c * phi, V, law, at_rest=mu0, on=leading)
page.friction(-c * psi, V, law, at_rest=mu0, on=trailing)
"""
)

#: The same where the leading shoe is loaded by P against a spring of its own.
SPRUNG = (
    SHOES.replace("page.force(F * l, along=phi)", "page.force(P * l, along=phi)")
    .replace(
        "page.force(F * l, along=psi)", "page.force(F * l, along=psi)\npage.spring(k, along=phi)"
    )
    .replace(
        "F = page",
        """k = page.parameter("k", "N m", "its spring", "> 0", 0.3)
P = page.parameter("P", "N", "load of the leading shoe", "real", 0.0)
F = page""",
        1,
    )
)

#: And with a drum that is worn, at one place less than elsewhere.
WORN = SPRUNG.replace(
    "page.contact(-b * phi,", "page.contact(d * (1 + (s - s_0)**2) - b * phi,"
).replace(
    "F = page",
    """d = page.parameter("d", "m", "least wear", "> 0", 0.05)
s = page.parameter("s", "1", "place of the drum", "real", 0.2)
s_0 = page.parameter("s_0", "1", "place of least wear", "real", 0.3)
F = page""",
    1,
)

#: SPRUNG with a stop: where the shoe locks, it is off the drum, or jammed on the stop.
JAMMING = (
    SPRUNG
    + """
g = page.parameter("g", "m", "play before the stop", "> 0", 0.1)
page.contact(g - a * phi, lambda depth: k_c * depth, name="stop")
"""
)

#: Two blocks on a belt, tied to the ground and to each other.
BLOCKS = """r\"\"\"A page of the tests.\"\"\"
from spragsym.derive.model import Page, sgn
page = Page("A page of the tests.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness of the first block's spring")
a = page.unit("a", "m", "length")
beta = page.parameter("beta", "1", "stiffness of the second block's spring over k", "> 0", 1.2)
kappa = page.parameter("kappa", "1", "stiffness between the blocks over k", ">= 0", 0.8)
mu_s = page.parameter("mu_s", "1", "static friction coefficient", ">= 0", 0.6)
mu_k = page.parameter("mu_k", "1", "kinetic friction coefficient", ">= 0", 0.4)
N_1 = page.parameter("N_1", "N", "normal force of the first block", ">= 0", 1.0)
N_2 = page.parameter("N_2", "N", "normal force of the second block", ">= 0", 1.3)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.2)
x_1 = page.coordinate("x_1", "m", "of the first block")
x_2 = page.coordinate("x_2", "m", "of the second block")
page.kinetic(m * (page.rate(x_1)**2 + page.rate(x_2)**2) / 2)
page.spring(k, along=x_1)
page.spring(beta * k, along=x_2)
page.spring(kappa * k, along=x_1 - x_2)
first = page.normal_force(N_1, name="first")
second = page.normal_force(N_2, name="second")
page.friction(x_1, V, slip=lambda v: mu_k * sgn(v), holds=mu_s, on=first)
page.friction(x_2, V, slip=lambda v: mu_k * sgn(v), holds=mu_s, on=second)
"""

#: A third block behind them, in a row.
ROW = (
    BLOCKS.replace(
        "page.rate(x_2)**2) / 2)",
        "page.rate(x_2)**2 + page.rate(x_3)**2) / 2)\npage.spring(k, along=x_3)\n"
        "page.spring(kappa * k, along=x_2 - x_3)",
    ).replace("page.kinetic", 'x_3 = page.coordinate("x_3", "m", "of the third")\npage.kinetic')
    + """
third = page.normal_force(N_1, name="third")
page.friction(x_3, V, slip=lambda v: mu_k * sgn(v), holds=mu_s, on=third)
"""
)
#: And a soft stop in front of the third.
STOPPED_ROW = (
    ROW
    + """
page.contact(0.4 * a - x_3, lambda depth: k * depth, name="stop")
"""
)

#: The same with friction that falls with the sliding speed.
FALLING_BLOCKS = (
    BLOCKS.replace("lambda v: mu_k * sgn(v)", "lambda v: mu_s / (1 + Abs(v) / mu_k) * sgn(v)")
    .replace("import Page, sgn", "import Abs, Page, sgn")
    .replace(
        'mu_k = page.parameter("mu_k", "1", "kinetic friction coefficient"',
        'mu_k = page.parameter("mu_k", "m/s", "speed at which friction is half"',
    )
    .replace('">= 0", 0.4)', '"> 0", 0.4)')
)

#: Two blocks that a bar with a mass of its own ties: friction on one changes what holds the other.
TIED_BLOCKS = BLOCKS.replace(
    "page.rate(x_2)**2) / 2)",
    "page.rate(x_2)**2) / 2 + c * m * (page.rate(x_1) + page.rate(x_2))**2 / 2)",
).replace(
    "x_1 = page",
    'c = page.parameter("c", "1", "mass of the bar over m", ">= 0", 0.7)\nx_1 = page',
    1,
)

#: A mass between two pads, into which it is pressed by d in the middle.
PADS = """r\"\"\"A page of the tests.\"\"\"
from spragsym.derive.model import Page
page = Page("A page of the tests.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
a = page.unit("a", "m", "length")
d = page.parameter("d", "m", "preloaded depth", "real", 0.1)
x = page.coordinate("x", "m", "across the pads")
page.kinetic(m * page.rate(x)**2 / 2)
page.contact(x - d, lambda depth: k_c * depth, name="left")
page.contact(-x - d, lambda depth: k_c * depth, name="right")
"""

#: A mass that its middle repels to either of two stops.
SNAP = """r\"\"\"A page of the tests.\"\"\"
from spragsym.derive.model import Page
page = Page("A page of the tests.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness by which the middle repels")
a = page.unit("a", "m", "half the distance of the stops")
k_c = page.parameter("k_c", "N/m", "contact stiffness", "> 0", 4.0)
c = page.parameter("c", "N s/m", "damper", "> 0", 0.5)
F = page.parameter("F", "N", "force towards the left", "real", 0.1)
x = page.coordinate("x", "m", "across the stops")
page.kinetic(m * page.rate(x)**2 / 2)
page.potential(-k * x**2 / 2 + F * x)
page.damper(c, along=x)
page.contact(a + x, lambda depth: k_c * depth, name="left")
page.contact(a - x, lambda depth: k_c * depth, name="right")
"""

#: A ladder of length 2 a whose floor runs towards the wall and whose wall runs up.
LADDER = (
    HEAD
    + """
W = page.parameter("W", "N", "weight", "> 0", 0.05)
nu = page.parameter("nu", "1", "friction coefficient of the wall", ">= 0", 0.2)
x = page.coordinate("x", "m", "of the centre, from the wall")
y = page.coordinate("y", "m", "of the centre, from the floor")
alpha = page.coordinate("alpha", "rad", "inclination")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2 + m * a**2 * page.rate(alpha)**2 / 6)
page.potential(W * y)
floor = page.contact(y - a * sin(alpha), lambda depth: k_c * depth, name="floor")
wall = page.contact(x - a * cos(alpha), lambda depth: k_c * depth, name="wall")
page.friction(-x - a * cos(alpha), V, law, at_rest=mu0, on=floor)
page.friction(y + a * sin(alpha), V, lambda v: nu * tanh(20 * v / V), at_rest=nu, on=wall)
"""
)


#: Ranges of the parameters of a pad that are drawn: no combination of touches is rare.
RANGES = {
    "mu0": (0.0, 3.0),
    "F": (0.01, 0.1),
    "k_x": (0.2, 1.0),
    "k_t": (0.05, 1.0),
    "h": (0.2, 1.5),
    "s": (0.0, 0.05),
    "g": (0.0, 0.2),
}


@dataclass(frozen=True)
class Leg:
    """A contact: gap g·q + c, force k times the depth, friction μ along s·q."""

    name: str
    g: tuple[float, ...]
    c: float
    k: float
    mu: float
    s: tuple[float, ...]


def pad(p: Mapping[str, float], names: tuple[str, ...]) -> tuple[Any, Any, list[Leg]]:
    """K without contacts, loads and contacts of the pad: q = (x, y, φ), in units m, k_c and a."""
    slide = 1.0, 0.0, p["h"]
    legs = {
        "front": Leg("front", (0, 1, -1), 0.0, 1.0, p["mu0"], slide),
        "rear": Leg("rear", (0, 1, 1), 0.0, 1.0, p["mu0"], slide),
        "middle": Leg("middle", (0, 1, 0), p.get("s", 0.0), 2.0, p["mu0"], slide),
        "stop": Leg("stop", (-1, 0, 0), p.get("g", 0.0), 1.0, 0.0, slide),
    }
    loads = np.array([0.0, -p["F"], 0.0])
    return np.diag([p["k_x"], 0.0, p["k_t"]]), loads, [legs[name] for name in names]


def balanced(K: Any, loads: Any, legs: list[Leg]) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Every equilibrium with its contacts that touch, one linear system for each combination."""
    for some in itertools.product((True, False), repeat=len(legs)):
        whole, right = K.copy(), loads.copy()
        for leg, touches in zip(legs, some, strict=True):
            if touches:  # the force −k (g·q + c) along g and μ s
                along = leg.k * (np.array(leg.g) + leg.mu * np.array(leg.s))
                whole += np.outer(along, leg.g)
                right -= along * leg.c
        if np.linalg.matrix_rank(whole) < len(loads):
            continue
        q = np.linalg.solve(whole, right)
        q += np.linalg.solve(whole, right - whole @ q)
        gaps = [np.dot(leg.g, q) + leg.c for leg in legs]
        if all((gap <= 0) == touches for gap, touches in zip(gaps, some, strict=True)):
            yield tuple(leg.name for leg, touches in zip(legs, some, strict=True) if touches), q


#: A block on a block on a belt; between the blocks nothing moves the friction.
STACK = '''r"""Two blocks.

::

    stacked
"""

from spragsym.derive.model import Page, sgn

page = Page("A block that rests on a block on a belt.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
l = page.unit("l", "m", "length")
V = page.parameter("V", "m/s", "belt", ">= 0", 0.3)
x_1 = page.coordinate("x_1", "m", "upper")
x_2 = page.coordinate("x_2", "m", "lower")
page.kinetic(m * (page.rate(x_1) ** 2 + 2 * page.rate(x_2) ** 2) / 2)
page.spring(k, along=x_1)
page.spring(3 * k / 2, along=x_2)
upper, lower = (page.normal_force(N * k * l, name=name) for name, N in (("upper", 1 / 2), ("lower", 1)))
page.friction(x_1 - x_2, 0, slip=lambda v: 0.4 * sgn(v), holds=0.6, on=upper)
page.friction(x_2, V, slip=lambda v: 0.4 * sgn(v), holds=0.6, on=lower)
'''
