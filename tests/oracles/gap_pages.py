"""Pages whose gap is an expression, each beside its forces and its gap written by hand.

Forces are those that pull back, so that the balance is ``forces = 0``.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

Values = Mapping[str, Any]

HEAD = '''r"""A page of the tests."""
from spragsym.derive.model import Abs, Page, atan, cos, exp, log, pi, sgn, sin, sqrt, tanh
page = Page("A page of the tests.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
L_0 = page.unit("L_0", "m", "length")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law", "> 0", 10.0)
mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.5)
'''
FRICTION = "lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0"
TANH = "lambda v: mu0 * tanh(d * v), at_rest=mu0"


@dataclass(frozen=True)
class Hand:
    """A page, and what it says written by hand: q by coordinate, p by name, N = law(−gap) where
    ``contact`` is 1.
    """

    page: str
    forces: Callable[[Any, Values, int], list[Any]]
    gap: Callable[[Any, Values], Any]
    law: Callable[[Any, Values], Any] = lambda depth, p: depth


def push(hand: Hand, q: Any, p: Values, contact: int) -> Any:
    """The normal force."""
    return hand.law(-hand.gap(q, p), p) if contact else 0.0


# ------------------------------------------------------------------------------------------------
# rod

_ROD = (
    HEAD
    + f"""
psi = page.parameter("psi", "rad", "angle at rest", "real", 0.3)
k_t = page.parameter("k_t", "N m", "torsion spring", "> 0", 0.05, becomes="tau")
h = page.parameter("h", "m", "distance of the wall", "> 0", 0.9, becomes="eta")
phi = page.coordinate("phi", "rad", "angle")
page.kinetic(m * L_0**2 * page.rate(phi)**2 / 2)
page.potential(k_t * (phi - psi)**2 / 2)
page.contact(h - L_0 * cos(phi), lambda depth: k_c * depth)
page.friction(L_0 * sin(phi), V, {FRICTION})
"""
)


def _rod(q: Any, p: Values, contact: int) -> list[Any]:
    N = push(ROD, q, p, contact)
    return [p["tau"] * (q[0] - p["psi"]) - N * np.sin(q[0]) - p["mu0"] * N * np.cos(q[0])]


ROD = Hand(_ROD, _rod, lambda q, p: p["eta"] - np.cos(q[0]))

# -------------------------------------------------------------------------------------------------
# rail

_RAIL = (
    HEAD
    + f"""
k = page.parameter("k", "N/m", "stiffness along", "> 0", 0.05, becomes="sigma")
k_y = page.parameter("k_y", "N/m", "stiffness across", ">= 0", 0.1, becomes="alpha")
F_L = page.parameter("F_L", "N", "preload", "real", 0.05, becomes="kappa")
b = page.parameter("b", "m", "height of the waves", ">= 0", 0.2)
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.spring(k, along=x)
page.spring(k_y, along=y)
page.force(0, -F_L, at=(x, y))
page.contact(y - b * sin(x / L_0), lambda depth: k_c * depth)
page.friction(x, V, {FRICTION})
"""
)


def _rail(q: Any, p: Values, contact: int) -> list[Any]:
    N, (x, y) = push(RAIL, q, p, contact), q
    return [p["sigma"] * x + N * p["b"] * np.cos(x) - p["mu0"] * N, p["alpha"] * y + p["kappa"] - N]


RAIL = Hand(_RAIL, _rail, lambda q, p: q[1] - p["b"] * np.sin(q[0]))

# -------------------------------------------------------------------------------------------------
# sledge

_SLEDGE = (
    HEAD
    + f"""
M = page.parameter("M", "kg", "mass of the sledge", "> 0", 2.0, becomes="nu")
psi = page.parameter("psi", "rad", "angle at rest", "real", 0.5)
k = page.parameter("k", "N/m", "spring of the sledge", "> 0", 0.3, becomes="sigma")
k_t = page.parameter("k_t", "N m", "torsion spring", "> 0", 0.1, becomes="tau")
c = page.parameter("c", "N s/m", "damper of the sledge", ">= 0", 0.03, becomes="zeta")
h = page.parameter("h", "m", "height of the pivot", "> 0", 0.85, becomes="eta")
k_3 = page.parameter("k_3", "N/m^3", "hardening", ">= 0", 10.0, becomes="gamma")
x = page.coordinate("x", "m", "of the sledge")
phi = page.coordinate("phi", "rad", "angle of the rod")
page.kinetic(M * page.rate(x)**2 / 2 + m * (
    page.rate(x)**2 + L_0**2 * page.rate(phi)**2 + 2 * L_0 * cos(phi) * page.rate(x) * page.rate(phi)) / 2)
page.spring(k, along=x)
page.potential(k_t * (phi - psi)**2 / 2)
page.damper(c, along=x)
page.contact(h - L_0 * cos(phi), lambda depth: k_c * depth + k_3 * depth**3)
page.friction(x + L_0 * sin(phi), V, {TANH})
"""
)


def _sledge(q: Any, p: Values, contact: int) -> list[Any]:
    N, (x, phi) = push(SLEDGE, q, p, contact), q
    drag = p["mu0"] * N
    return [
        p["sigma"] * x - drag,
        p["tau"] * (phi - p["psi"]) - N * np.sin(phi) - drag * np.cos(phi),
    ]


SLEDGE = Hand(
    _SLEDGE,
    _sledge,
    lambda q, p: p["eta"] - np.cos(q[1]),
    lambda depth, p: depth + p["gamma"] * depth**3,
)

HANDS = {"rod": ROD, "rail": RAIL, "sledge": SLEDGE}
