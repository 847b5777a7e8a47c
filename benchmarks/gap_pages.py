"""Pages whose gap is an expression, each beside its mechanics written by hand: forces, gap, masses and dampers.

Forces are those that pull back, so that the balance is ``forces = 0``; with complex numbers they give their own slopes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

Values = Mapping[str, Any]

HEAD = '''r"""A page of the tests."""
from spragsym.derive.model import Abs, Page, atan, cos, exp, pi, sgn, sin, sqrt
page = Page("A page of the tests.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
L_0 = page.unit("L_0", "m", "length")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law", "> 0", 10.0)
mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.5)
'''
FRICTION = "lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0"


@dataclass(frozen=True)
class Hand:
    """A page, and what it says written by hand: q by coordinate, p by name, N = −gap where ``contact`` is 1."""

    page: str
    forces: Callable[[Any, Values, int], list[Any]]
    gap: Callable[[Any, Values], Any]
    mass: Callable[[Any, Values], list[list[Any]]]
    damping: Callable[[Any, Values, Any], list[list[Any]]]  #: with the normal force for the last argument
    law: Callable[[Any], Any] = lambda depth: depth  #: of the contact
    reach: float = 3.0  #: how far from 0 starts lie
    ranges: Mapping[str, tuple[float, float]] = field(default_factory=dict)  #: of parameters that are not drawn around their base
    vary: tuple[str, tuple[float, float]] = ("mu0", (0.0, 2.0))  #: what folds and onsets are looked for along


def push(hand: Hand, q: Any, p: Values, contact: int) -> Any:
    """The normal force."""
    return hand.law(-hand.gap(q, p)) if contact else 0.0


def slope(p: Values) -> Any:
    """Of the friction law at steady sliding."""
    return p["mu0"] * p["d"] * np.exp(-p["d"] * p["V"])


# ------------------------------------------------------------------------------------------------------------ rod

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


ROD = Hand(
    _ROD, _rod, lambda q, p: p["eta"] - np.cos(q[0]), lambda q, p: [[1.0]],
    lambda q, p, N: [[N * slope(p) * np.cos(q[0]) ** 2]],
    reach=40.0, ranges={"psi": (-1.5, 1.5), "eta": (0.2, 1.05), "mu0": (0.0, 1.5)}, vary=("eta", (0.05, 1.2)),
)  # fmt: skip

# ----------------------------------------------------------------------------------------------------------- rail

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


RAIL = Hand(
    _RAIL, _rail, lambda q, p: q[1] - p["b"] * np.sin(q[0]), lambda q, p: [[1.0, 0.0], [0.0, 1.0]],
    lambda q, p, N: [[N * slope(p), 0.0], [0.0, 0.0]],
    reach=12.0, ranges={"kappa": (-0.2, 0.4), "mu0": (0.0, 1.5)}, vary=("kappa", (-0.3, 0.6)),
)  # fmt: skip

# ----------------------------------------------------------------------------------------------------------- disc

_DISC = (
    HEAD
    + f"""
F_L = page.parameter("F_L", "N", "preload", "real", 0.01, becomes="kappa")
k_x = page.parameter("k_x", "N/m", "stiffness to ground", ">= 0", 0.02, becomes="alpha")
k = page.parameter("k", "N/m", "stiffness of the spring", "> 0", 0.1, becomes="sigma")
k_w = page.parameter("k_w", "N/m", "stiffness of the disc", "> 0", 0.5, becomes="beta")
c_w = page.parameter("c_w", "N s/m", "damper of the disc", ">= 0", 0.02, becomes="zeta")
M = page.parameter("M", "kg", "mass of the disc", "> 0", 1.5, becomes="nu")
theta0 = page.parameter("theta0", "rad", "inclination", "(0, pi)", 0.8)
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
w = page.coordinate("w", "m", "of the disc")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2 + M * page.rate(w)**2 / 2)
page.spring(k_x, along=x)
page.spring(k, (x, y), (L_0 * cos(theta0), L_0 * sin(theta0)), length=L_0)
page.spring(k_w, along=w)
page.damper(c_w, along=w)
page.force(0, -F_L, at=(x, y))
page.contact(y - w, lambda depth: k_c * depth)
page.friction(x, V, {FRICTION})
"""
)


def leaning(p: Values, x: Any, y: Any) -> tuple[Any, Any]:
    """The pull of the inclined spring, along and across."""
    dx, dy = np.cos(p["theta0"]) - x, np.sin(p["theta0"]) - y
    length = np.sqrt(dx**2 + dy**2)
    pull = p["sigma"] * (length - 1)
    return pull * dx / length, pull * dy / length


def _disc(q: Any, p: Values, contact: int) -> list[Any]:
    N, (x, y, w) = push(DISC, q, p, contact), q
    along, across = leaning(p, x, y)
    return [p["alpha"] * x - along - p["mu0"] * N, p["kappa"] - across - N, p["beta"] * w + N]


DISC = Hand(
    _DISC, _disc, lambda q, p: q[1] - q[2], lambda q, p: np.diag([1.0, 1.0, p["nu"]]).tolist(),
    lambda q, p, N: np.diag([N * slope(p), 0.0, p["zeta"]]).tolist(),
    ranges={"kappa": (-0.02, 0.05), "mu0": (0.0, 1.5), "theta0": (0.1, 3.0)}, vary=("theta0", (0.05, 3.1)),
)  # fmt: skip

HANDS = {"rod": ROD, "rail": RAIL, "disc": DISC}
