"""Pages whose gap is an expression, each beside its mechanics written by hand: forces, gap, masses and dampers.

Forces are those that pull back, so that the balance is ``forces = 0``; with complex numbers they give their own slopes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
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
ATAN = "lambda v: 2 / pi * mu0 * atan(d * v)"
STRIBECK = "lambda v: mu0 * (r + (1 - r) * exp(-f * Abs(v))) * tanh(d * v)"
FALL = """
r = page.parameter("r", "1", "what is left of friction", "[0, 1]", 0.5)
f = page.parameter("f", "s/m", "how fast friction falls", "> 0", 1.0)
"""


@dataclass(frozen=True)
class Hand:
    """A page, and what it says written by hand: q by coordinate, p by name, N = −gap where ``contact`` is 1."""

    page: str
    forces: Callable[[Any, Values, int], list[Any]]
    gap: Callable[[Any, Values], Any]
    mass: Callable[[Any, Values], list[list[Any]]]
    damping: Callable[[Any, Values, Any], list[list[Any]]]  #: with the normal force for the last argument
    law: Callable[[Any, Values], Any] = lambda depth, p: depth  #: of the contact
    reach: float = 3.0  #: how far from 0 starts lie
    ranges: Mapping[str, tuple[float, float]] = field(default_factory=dict)  #: of parameters that are not drawn around their base
    vary: tuple[str, tuple[float, float]] = ("mu0", (0.0, 2.0))  #: what folds and onsets are looked for along


def push(hand: Hand, q: Any, p: Values, contact: int) -> Any:
    """The normal force."""
    return hand.law(-hand.gap(q, p), p) if contact else 0.0


def slope(p: Values) -> Any:
    """Of the friction law at steady sliding."""
    return p["mu0"] * p["d"] * np.exp(-p["d"] * p["V"])


def tanh_slope(p: Values) -> Any:
    """Of the law with tanh."""
    return p["mu0"] * p["d"] / np.cosh(p["d"] * p["V"]) ** 2


def atan_law(p: Values) -> tuple[Any, Any]:
    """μ(V) and its slope."""
    u = p["d"] * p["V"]
    return 2 / np.pi * p["mu0"] * np.arctan(u), 2 / np.pi * p["mu0"] * p["d"] / (1 + u * u)


def falling(p: Values) -> tuple[Any, Any]:
    """μ(V) and its slope of a law that rises as tanh and falls."""
    tail, rise = (1 - p["r"]) * np.exp(-p["f"] * p["V"]), np.tanh(p["d"] * p["V"])
    return p["mu0"] * (p["r"] + tail) * rise, p["mu0"] * ((p["r"] + tail) * p["d"] * (1 - rise**2) - p["f"] * tail * rise)


def hertz(depth: Any, p: Values) -> Any:
    """Depth to the power of 3/2; odd, so that it is a number beyond the touch too, where nothing is compared."""
    side = np.sign(np.real(depth))
    return side * (side * depth) ** 1.5


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

# ------------------------------------------------------------------------------------------------------------ cam

_CAM = (
    HEAD
    + f"""
psi = page.parameter("psi", "rad", "angle at rest", "real", 0.8)
k_t = page.parameter("k_t", "N m", "torsion spring", "> 0", 0.05, becomes="tau")
c_t = page.parameter("c_t", "N m s", "damping of the pivot", ">= 0", 0.02, becomes="zeta")
h = page.parameter("h", "m", "height of the pivot", "> 0", 0.9, becomes="eta")
e = page.parameter("e", "m", "eccentricity", ">= 0", 0.3)
phi = page.coordinate("phi", "rad", "angle")
page.kinetic(m * L_0**2 * page.rate(phi)**2 / 2)
page.potential(k_t * (phi - psi)**2 / 2)
page.damper(c_t, along=phi)
page.contact(h + e * sin(phi) - L_0, lambda depth: k_c * L_0 * (depth / L_0)**(3 / 2))
page.friction(L_0 * phi + e * cos(phi), V, {TANH})
"""
)


def _cam(q: Any, p: Values, contact: int) -> list[Any]:
    N, phi = push(CAM, q, p, contact), q[0]
    return [p["tau"] * (phi - p["psi"]) - N * p["e"] * np.cos(phi) - p["mu0"] * N * (1 - p["e"] * np.sin(phi))]


CAM = Hand(
    _CAM, _cam, lambda q, p: p["eta"] + p["e"] * np.sin(q[0]) - 1, lambda q, p: [[1.0]],
    lambda q, p, N: [[p["zeta"] + N * tanh_slope(p) * (1 - p["e"] * np.sin(q[0])) ** 2]],
    law=hertz, reach=30.0, ranges={"psi": (-2.0, 2.0), "eta": (0.4, 1.3), "e": (0.05, 0.8)}, vary=("psi", (-2.0, 2.0)),
)  # fmt: skip

# ----------------------------------------------------------------------------------------------------------- bead

_BEAD = (
    HEAD
    + FALL
    + f"""
k = page.parameter("k", "N/m", "spring", "> 0", 0.5, becomes="sigma")
a = page.parameter("a", "m", "where it is at rest", "real", 0.5)
h = page.parameter("h", "m", "distance of the wall", "> 0", 0.4, becomes="eta")
b = page.parameter("b", "m", "height of the track", "real", 0.4)
F = page.parameter("F", "N", "weight", "real", 0.1, becomes="kappa")
c = page.parameter("c", "N s/m", "damper", ">= 0", 0.02, becomes="zeta")
k_3 = page.parameter("k_3", "N/m^3", "hardening of the wall", ">= 0", 3.0, becomes="gamma")
x = page.coordinate("x", "m", "along")
page.kinetic(m * (1 + 4 * b**2 * x**2 / L_0**4) * page.rate(x)**2 / 2)
page.spring(k, along=x - a)
page.force(0, -F, at=(x, b * x**2 / L_0**2))
page.damper(c, along=x)
page.contact(h - x, lambda depth: k_c * depth + k_3 * depth**3)
page.friction(b * x**2 / L_0**2, V, {STRIBECK})
"""
)


def _bead(q: Any, p: Values, contact: int) -> list[Any]:
    N, x = push(BEAD, q, p, contact), q[0]
    rise = 2 * p["b"] * x
    return [p["sigma"] * (x - p["a"]) + p["kappa"] * rise + N - falling(p)[0] * N * rise]


BEAD = Hand(
    _BEAD, _bead, lambda q, p: p["eta"] - q[0], lambda q, p: [[1 + 4 * p["b"] ** 2 * q[0] ** 2]],
    lambda q, p, N: [[p["zeta"] + N * falling(p)[1] * (2 * p["b"] * q[0]) ** 2]],
    law=lambda depth, p: depth + p["gamma"] * depth**3, reach=8.0,
    ranges={"a": (-1.0, 2.5), "b": (-1.5, 1.5), "kappa": (-0.6, 0.6), "mu0": (0.0, 3.0), "r": (0.0, 1.0)}, vary=("a", (-2.0, 3.0)),
)  # fmt: skip

# ---------------------------------------------------------------------------------------------------------- wedge

_WEDGE = (
    HEAD
    + f"""
g = page.parameter("g", "rad", "slope of the guide", "(0, pi/2)", 0.6)
theta0 = page.parameter("theta0", "rad", "inclination", "(0, pi)", 1.4)
k = page.parameter("k", "N/m", "inclined spring", "> 0", 0.5, becomes="sigma")
k_s = page.parameter("k_s", "N/m", "spring along the guide", ">= 0", 0.02, becomes="alpha")
F = page.parameter("F", "N", "load", "real", 0.05, becomes="kappa")
c = page.parameter("c", "N s/m", "damper of the spring", ">= 0", 0.02, becomes="zeta")
s = page.coordinate("s", "m", "along the guide")
end, anchor = (s * cos(g), s * sin(g)), (L_0 * cos(theta0), L_0 * sin(theta0))
page.kinetic(m * page.rate(s)**2 / 2)
page.spring(k, end, anchor, length=L_0)
page.spring(k_s, along=s)
page.damper(c, end, anchor)
page.force(-F, along=s)
page.contact(s * sin(g), lambda depth: k_c * depth / (1 + depth / L_0))
page.friction(s * cos(g), V, {ATAN})
"""
)


def _length(q: Any, p: Values) -> tuple[Any, Any]:
    """Of the inclined spring, and how fast it grows along the guide."""
    dx, dy = q[0] * np.cos(p["g"]) - np.cos(p["theta0"]), q[0] * np.sin(p["g"]) - np.sin(p["theta0"])
    length = np.sqrt(dx**2 + dy**2)
    return length, (dx * np.cos(p["g"]) + dy * np.sin(p["g"])) / length


def _wedge(q: Any, p: Values, contact: int) -> list[Any]:
    N, (length, way) = push(WEDGE, q, p, contact), _length(q, p)
    pull = p["sigma"] * (length - 1) * way
    return [pull + p["alpha"] * q[0] + p["kappa"] - N * np.sin(p["g"]) - atan_law(p)[0] * N * np.cos(p["g"])]


WEDGE = Hand(
    _WEDGE, _wedge, lambda q, p: q[0] * np.sin(p["g"]), lambda q, p: [[1.0]],
    lambda q, p, N: [[p["zeta"] * _length(q, p)[1] ** 2 + N * atan_law(p)[1] * np.cos(p["g"]) ** 2]],
    law=lambda depth, p: depth / (1 + depth),
    ranges={"g": (0.1, 1.5), "theta0": (0.1, 3.0), "kappa": (-0.5, 0.5)}, vary=("kappa", (-0.8, 0.8)),
)  # fmt: skip

# ------------------------------------------------------------------------------------------------------- two rods

_RODS = (
    HEAD
    + f"""
psi = page.parameter("psi", "rad", "angle at rest", "real", 0.4)
k_1 = page.parameter("k_1", "N m", "torsion spring", "> 0", 0.2, becomes="tau_1")
k_2 = page.parameter("k_2", "N m", "torsion spring between", "> 0", 0.3, becomes="tau_2")
c_1 = page.parameter("c_1", "N m s", "damping of the pivot", ">= 0", 0.02, becomes="zeta")
h = page.parameter("h", "m", "distance of the wall", "> 0", 1.8, becomes="eta")
a = page.coordinate("a", "rad", "angle of the first")
b = page.coordinate("b", "rad", "angle of the second")
page.kinetic(m * L_0**2 * (2 * page.rate(a)**2 + page.rate(b)**2 + 2 * cos(a - b) * page.rate(a) * page.rate(b)) / 2)
page.potential(k_1 * (a - psi)**2 / 2 + k_2 * (b - a)**2 / 2)
page.damper(c_1, along=a)
page.contact(h - L_0 * cos(a) - L_0 * cos(b), lambda depth: k_c * depth)
page.friction(L_0 * sin(a) + L_0 * sin(b), V, {FRICTION})
"""
)


def _rods(q: Any, p: Values, contact: int) -> list[Any]:
    N, (a, b) = push(RODS, q, p, contact), q
    turned = p["tau_2"] * (b - a)
    return [
        p["tau_1"] * (a - p["psi"]) - turned - N * (np.sin(a) + p["mu0"] * np.cos(a)),
        turned - N * (np.sin(b) + p["mu0"] * np.cos(b)),
    ]


def _rods_damped(q: Any, p: Values, N: Any) -> Any:
    way = np.cos(q)
    return N * slope(p) * np.outer(way, way) + np.diag([p["zeta"], 0.0])


RODS = Hand(
    _RODS, _rods, lambda q, p: p["eta"] - np.cos(q[0]) - np.cos(q[1]),
    lambda q, p: [[2.0, np.cos(q[0] - q[1])], [np.cos(q[0] - q[1]), 1.0]], _rods_damped,
    reach=10.0, ranges={"psi": (-1.2, 1.2), "eta": (1.2, 2.1), "mu0": (0.0, 1.2)}, vary=("eta", (1.0, 2.2)),
)  # fmt: skip

# ------------------------------------------------------------------------------------------------------- carriage

_CARRIAGE = (
    HEAD
    + f"""
M = page.parameter("M", "kg", "mass of the carriage", "> 0", 2.0, becomes="nu")
psi = page.parameter("psi", "rad", "angle at rest", "real", 0.5)
k = page.parameter("k", "N/m", "spring of the carriage", "> 0", 0.3, becomes="sigma")
k_t = page.parameter("k_t", "N m", "torsion spring", "> 0", 0.1, becomes="tau")
c = page.parameter("c", "N s/m", "damper of the carriage", ">= 0", 0.03, becomes="zeta")
h = page.parameter("h", "m", "height of the pivot", "> 0", 0.85, becomes="eta")
x = page.coordinate("x", "m", "of the carriage")
phi = page.coordinate("phi", "rad", "angle of the rod")
page.kinetic(M * page.rate(x)**2 / 2 + m * (
    page.rate(x)**2 + L_0**2 * page.rate(phi)**2 + 2 * L_0 * cos(phi) * page.rate(x) * page.rate(phi)) / 2)
page.spring(k, along=x)
page.potential(k_t * (phi - psi)**2 / 2)
page.damper(c, along=x)
page.contact(h - L_0 * cos(phi), lambda depth: k_c * L_0 * (depth / L_0)**(3 / 2))
page.friction(x + L_0 * sin(phi), V, {TANH})
"""
)


def _carriage(q: Any, p: Values, contact: int, law: Callable[[Any, Values], Any] = hertz) -> list[Any]:
    x, phi = q
    N = law(np.cos(phi) - p["eta"], p) if contact else 0.0
    drag = p["mu0"] * N
    return [p["sigma"] * x - drag, p["tau"] * (phi - p["psi"]) - N * np.sin(phi) - drag * np.cos(phi)]


def _carriage_damped(q: Any, p: Values, N: Any) -> Any:
    way = np.array([1.0, np.cos(q[1])])
    return N * tanh_slope(p) * np.outer(way, way) + np.diag([p["zeta"], 0.0])


CARRIAGE = Hand(
    _CARRIAGE, _carriage, lambda q, p: p["eta"] - np.cos(q[1]),
    lambda q, p: [[1 + p["nu"], np.cos(q[1])], [np.cos(q[1]), 1.0]], _carriage_damped,
    law=hertz, reach=12.0, ranges={"psi": (-1.5, 1.5), "eta": (0.3, 1.05), "mu0": (0.0, 1.5)}, vary=("eta", (0.1, 1.2)),
)  # fmt: skip

# --------------------------------------------------------------------------------------------------------- sledge

#: The carriage on a belt that hardens: its law, written for any depth, pulls far beyond the border.
_SLEDGE = _CARRIAGE.replace("k_c * L_0 * (depth / L_0)**(3 / 2)", "k_c * depth + k_3 * depth**3").replace(
    "x = page.coord", 'k_3 = page.parameter("k_3", "N/m^3", "hardening", ">= 0", 10.0, becomes="gamma")\nx = page.coord', 1
)


def _hardening(depth: Any, p: Values) -> Any:
    return depth + p["gamma"] * depth**3


SLEDGE = replace(CARRIAGE, page=_SLEDGE, forces=partial(_carriage, law=_hardening), law=_hardening)

# --------------------------------------------------------------------------------------------------------- hollow

_HOLLOW = (
    HEAD
    + FALL
    + f"""
k = page.parameter("k", "N/m", "stiffness along", "> 0", 0.1, becomes="sigma")
k_3 = page.parameter("k_3", "N/m^3", "hardening along", ">= 0", 0.2, becomes="gamma")
k_y = page.parameter("k_y", "N/m", "stiffness across", ">= 0", 0.1, becomes="beta")
F = page.parameter("F", "N", "preload", "real", 0.1, becomes="kappa")
b = page.parameter("b", "1", "how fast the ground falls", "real", 0.3)
theta0 = page.parameter("theta0", "rad", "inclination of the damper", "(0, pi)", 1.0)
c = page.parameter("c", "N s/m", "inclined damper", ">= 0", 0.05, becomes="zeta")
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)
page.spring(k, along=x)
page.potential(k_3 * x**4 / 4)
page.spring(k_y, along=y)
page.force(0, -F, at=(x, y))
page.damper(c, (x, y), (3 * L_0 * cos(theta0), 3 * L_0 * sin(theta0)))
page.contact(y + b * x**2 / L_0, lambda depth: k_c * L_0 * (depth / L_0)**(3 / 2))
page.friction(x, V, {STRIBECK})
"""
)


def _hollow(q: Any, p: Values, contact: int) -> list[Any]:
    N, (x, y) = push(HOLLOW, q, p, contact), q
    along = p["sigma"] * x + p["gamma"] * x**3 - 2 * p["b"] * x * N - falling(p)[0] * N
    return [along, p["beta"] * y + p["kappa"] - N]


def _hollow_damped(q: Any, p: Values, N: Any) -> Any:
    way = np.array([3 * np.cos(p["theta0"]) - q[0], 3 * np.sin(p["theta0"]) - q[1]])
    return p["zeta"] * np.outer(way, way) / (way @ way) + np.diag([N * falling(p)[1], 0.0])


HOLLOW = Hand(
    _HOLLOW, _hollow, lambda q, p: q[1] + p["b"] * q[0] ** 2, lambda q, p: [[1.0, 0.0], [0.0, 1.0]], _hollow_damped,
    law=hertz, reach=6.0, ranges={"kappa": (-0.3, 0.6), "b": (-0.8, 0.8), "mu0": (0.0, 1.5), "theta0": (0.2, 2.9), "r": (0.0, 1.0)},
    vary=("kappa", (-0.4, 0.8)),
)  # fmt: skip

# ------------------------------------------------------------------------------------------------------------ pad

_PAD = (
    HEAD
    + f"""
J = page.parameter("J", "kg m^2", "moment of inertia", "> 0", 0.3, becomes="nu")
k_x = page.parameter("k_x", "N/m", "stiffness along", "> 0", 0.2, becomes="alpha")
k_1 = page.parameter("k_1", "N/m", "stiffness behind the front", "> 0", 0.3, becomes="beta_1")
k_2 = page.parameter("k_2", "N/m", "stiffness behind the rear", "> 0", 0.2, becomes="beta_2")
k_t = page.parameter("k_t", "N m", "stiffness of turning", "> 0", 0.05, becomes="tau")
c_x = page.parameter("c_x", "N s/m", "damper along", ">= 0", 0.02, becomes="zeta")
c_t = page.parameter("c_t", "N m s", "damper of turning", ">= 0", 0.01, becomes="xi")
h = page.parameter("h", "m", "height of the centre", ">= 0", 0.4, becomes="eta")
F = page.parameter("F", "N", "preload", "real", 0.1, becomes="kappa")
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
phi = page.coordinate("phi", "rad", "angle")
page.kinetic((m * (page.rate(x)**2 + page.rate(y)**2) + J * page.rate(phi)**2) / 2)
page.spring(k_x, along=x)
page.spring(k_1, along=y + L_0 * sin(phi) / 2)
page.spring(k_2, along=y - L_0 * sin(phi) / 2)
page.potential(k_t * phi**2 / 2)
page.damper(c_x, along=x)
page.damper(c_t, along=phi)
page.force(0, -F, at=(x, y))
page.contact(y - L_0 * sin(phi) / 3, lambda depth: k_c * depth)
page.friction(x + h * phi, V, {FRICTION})
"""
)


def _pad(q: Any, p: Values, contact: int) -> list[Any]:
    N, (x, y, phi) = push(PAD, q, p, contact), q
    front, rear = p["beta_1"] * (y + np.sin(phi) / 2), p["beta_2"] * (y - np.sin(phi) / 2)
    turning = (front - rear) * np.cos(phi) / 2 + p["tau"] * phi + N * np.cos(phi) / 3 - p["mu0"] * N * p["eta"]
    return [p["alpha"] * x - p["mu0"] * N, front + rear + p["kappa"] - N, turning]


def _pad_damped(q: Any, p: Values, N: Any) -> Any:
    way = np.array([1.0, 0.0, p["eta"]])
    return N * slope(p) * np.outer(way, way) + np.diag([p["zeta"], 0.0, p["xi"]])


PAD = Hand(
    _PAD, _pad, lambda q, p: q[1] - np.sin(q[2]) / 3, lambda q, p: np.diag([1.0, 1.0, p["nu"]]).tolist(), _pad_damped,
    reach=6.0, ranges={"kappa": (-0.2, 0.5), "mu0": (0.0, 1.5)}, vary=("mu0", (0.0, 1.5)),
)  # fmt: skip

# ---------------------------------------------------------------------------------------------------------- chain

_CHAIN = (
    HEAD
    + f"""
m_1 = page.parameter("m_1", "kg", "mass of the first", "> 0", 0.5, becomes="nu_1")
m_2 = page.parameter("m_2", "kg", "mass of the second", "> 0", 0.8, becomes="nu_2")
k_1 = page.parameter("k_1", "N/m", "stiffness of the first", "> 0", 0.3, becomes="sigma_1")
k_2 = page.parameter("k_2", "N/m", "stiffness of the second", "> 0", 0.4, becomes="sigma_2")
k_3 = page.parameter("k_3", "N/m", "stiffness of the third", "> 0", 0.2, becomes="sigma_3")
k = page.parameter("k", "N/m", "stiffness of the inclined spring", "> 0", 0.1, becomes="sigma")
c = page.parameter("c", "N s/m", "damper of the second", ">= 0", 0.05, becomes="zeta")
F_L = page.parameter("F_L", "N", "preload", "real", 0.01, becomes="kappa")
a = page.parameter("a", "1", "slope of the ground", "real", 0.1)
theta0 = page.parameter("theta0", "rad", "inclination", "(0, pi)", 0.8)
x_1 = page.coordinate("x_1", "m", "of the first")
x_2 = page.coordinate("x_2", "m", "of the second")
x_3 = page.coordinate("x_3", "m", "of the third")
y = page.coordinate("y", "m", "of the third, across")
page.kinetic((m_1 * page.rate(x_1)**2 + m_2 * page.rate(x_2)**2 + m * (page.rate(x_3)**2 + page.rate(y)**2)) / 2)
page.spring(k_1, along=x_1)
page.spring(k_2, along=x_2 - x_1)
page.spring(k_3, along=x_3 - x_2)
page.spring(k, (x_3, y), (L_0 * cos(theta0), L_0 * sin(theta0)), length=L_0)
page.damper(c, along=x_2 - x_1)
page.force(0, -F_L, at=(x_3, y))
page.contact(y - a * x_3, lambda depth: k_c * depth)
page.friction(x_3, V, {FRICTION})
"""
)


def _chain(q: Any, p: Values, contact: int) -> list[Any]:
    N, (x_1, x_2, x_3, y) = push(CHAIN, q, p, contact), q
    along, across = leaning(p, x_3, y)
    first, second, third = p["sigma_1"] * x_1, p["sigma_2"] * (x_2 - x_1), p["sigma_3"] * (x_3 - x_2)
    return [first - second, second - third, third - along + p["a"] * N - p["mu0"] * N, p["kappa"] - across - N]


def _chain_damped(q: Any, p: Values, N: Any) -> Any:
    way = np.array([-1.0, 1.0, 0.0, 0.0])
    return p["zeta"] * np.outer(way, way) + np.diag([0.0, 0.0, N * slope(p), 0.0])


CHAIN = Hand(
    _CHAIN, _chain, lambda q, p: q[3] - p["a"] * q[2], lambda q, p: np.diag([p["nu_1"], p["nu_2"], 1.0, 1.0]).tolist(),
    _chain_damped, ranges={"kappa": (-0.02, 0.05), "a": (-0.4, 0.4), "mu0": (0.0, 1.5), "theta0": (0.1, 3.0)},
    vary=("mu0", (0.0, 1.0)),
)  # fmt: skip

# ---------------------------------------------------------------------------------------------------------- stack

_STACK = (
    HEAD
    + f"""
m_u = page.parameter("m_u", "kg", "mass of the plate", "> 0", 0.6, becomes="nu_u")
m_w = page.parameter("m_w", "kg", "mass of the disc", "> 0", 2.0, becomes="nu_w")
k_x = page.parameter("k_x", "N/m", "stiffness along", "> 0", 0.1, becomes="alpha")
k_u = page.parameter("k_u", "N/m", "stiffness of the lining", "> 0", 0.4, becomes="sigma_u")
k_w = page.parameter("k_w", "N/m", "stiffness of the disc", "> 0", 0.8, becomes="sigma_w")
c_x = page.parameter("c_x", "N s/m", "damper along", ">= 0", 0.02, becomes="zeta_x")
c_u = page.parameter("c_u", "N s/m", "damper of the lining", ">= 0", 0.02, becomes="zeta_u")
c_w = page.parameter("c_w", "N s/m", "damper of the disc", ">= 0", 0.05, becomes="zeta_w")
F = page.parameter("F", "N", "force on the plate", "real", 0.1, becomes="kappa")
b = page.parameter("b", "m", "height of the waves", ">= 0", 0.2)
x = page.coordinate("x", "m", "along")
y = page.coordinate("y", "m", "across")
w = page.coordinate("w", "m", "of the disc")
u = page.coordinate("u", "m", "of the plate")
page.kinetic((m * (page.rate(x)**2 + page.rate(y)**2) + m_w * page.rate(w)**2 + m_u * page.rate(u)**2) / 2)
page.spring(k_x, along=x)
page.spring(k_u, along=y - u)
page.spring(k_w, along=w)
page.damper(c_x, along=x)
page.damper(c_u, along=y - u)
page.damper(c_w, along=w)
page.force(-F, along=u)
page.contact(y - w - b * sin(x / L_0), lambda depth: k_c * L_0 * log(1 + depth / L_0))
page.friction(x, V, {TANH})
"""
)


def _stack(q: Any, p: Values, contact: int) -> list[Any]:
    N, (x, y, w, u) = push(STACK, q, p, contact), q
    lining = p["sigma_u"] * (y - u)
    return [p["alpha"] * x + N * p["b"] * np.cos(x) - p["mu0"] * N, lining - N, p["sigma_w"] * w + N, p["kappa"] - lining]


def _stack_damped(q: Any, p: Values, N: Any) -> Any:
    way = np.array([0.0, 1.0, 0.0, -1.0])
    return p["zeta_u"] * np.outer(way, way) + np.diag([p["zeta_x"] + N * tanh_slope(p), 0.0, p["zeta_w"], 0.0])


STACK = Hand(
    _STACK, _stack, lambda q, p: q[1] - q[2] - p["b"] * np.sin(q[0]),
    lambda q, p: np.diag([1.0, 1.0, p["nu_w"], p["nu_u"]]).tolist(), _stack_damped,
    law=lambda depth, p: np.log(1 + depth), reach=6.0, ranges={"kappa": (-0.1, 0.4), "mu0": (0.0, 1.5)}, vary=("mu0", (0.0, 1.5)),
)  # fmt: skip

HANDS = {
    "rod": ROD, "rail": RAIL, "disc": DISC, "cam": CAM, "bead": BEAD, "wedge": WEDGE, "rods": RODS, "carriage": CARRIAGE,
    "sledge": SLEDGE, "hollow": HOLLOW, "pad": PAD, "chain": CHAIN, "stack": STACK,
}  # fmt: skip
