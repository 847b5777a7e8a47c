"""Pages with bells, steps and forces that fall with distance, beside their forces by hand.

No region of equilibria follows from slopes over large boxes of these. Forces are those that pull
back, so that the balance is ``forces = 0``; what is drawn of their parameters is :func:`drawn`.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import root

from tests.oracles.gap_pages import FRICTION, Hand, Values

HEAD = '''"""A page of the tests."""
from spragsym.derive.model import Abs, Page, cos, exp, log, sgn, sin, sqrt, tanh
page = Page("A page of the tests.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "contact stiffness")
L_0 = page.unit("L_0", "m", "length")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.5)
k_x = page.parameter("k_x", "N/m", "stiffness to ground", ">= 0", 0.01, becomes="alpha")
h = page.parameter("h", "m", "height", ">= 0", 0.02, becomes="eta")
F_L = page.parameter("F_L", "N", "preload", "real", 0.01, becomes="kappa")
x = page.coordinate("x", "m", "along")
page.spring(k_x, along=x)
'''
SLIP = 'd = page.parameter("d", "s/m", "steepness of the friction law", "> 0", 10.0)\n'


@dataclass(frozen=True)
class Case:
    """A page by hand, what is drawn of its parameters and where SciPy starts."""

    hand: Hand
    ranges: dict[str, tuple[float, float]]
    starts: tuple[tuple[float, float], ...]


def strut(x: Any, y: Any, p: Values) -> tuple[Any, Any]:
    """The force of the inclined spring on (x, y), of length 1 when undeformed."""
    dx, dy = np.cos(p["theta0"]) - x, np.sin(p["theta0"]) - y
    length = np.hypot(dx, dy)
    pull = p["sigma"] * (1 - 1 / length)
    return pull * dx, pull * dy


STRUT = """theta0 = page.parameter("theta0", "rad", "inclination of the strut", "(0, pi)", 0.9)
k = page.parameter("k", "N/m", "stiffness of the strut", "> 0", 0.12, becomes="sigma")
page.spring(k, (x, y), (L_0 * cos(theta0), L_0 * sin(theta0)), length=L_0)
"""
PLANE = """y = page.coordinate("y", "m", "across")
page.force(0, -F_L, at=(x, y))
"""
MASS = "page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2)\n"

# ------------------------------------------------------------------------------------------------
# a bell under the mass

_HUMP = (
    HEAD
    + PLANE
    + MASS
    + STRUT
    + """
r = page.parameter("r", "1", "share of friction that is left at high speed", "[0, 1]", 0.7)
v_s = page.parameter("v_s", "m/s", "speed over which friction falls", "> 0", 0.25)
c = page.parameter("c", "N s/m", "damping", ">= 0", 0.01)
page.damper(c, along=x)
page.damper(c, along=y)
page.contact(y - h * exp(-((x / L_0 - 1)**2)), lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu0 * (r + (1 - r) * exp(-Abs(v) / v_s)) * tanh(20 * v / v_s))
"""
)


def _bell(x: Any) -> Any:
    return np.exp(-((x - 1) ** 2))


def _hump(q: Any, p: Values, contact: int) -> list[Any]:
    x, y = q
    N = contact * (p["eta"] * _bell(x) - y)
    mu = p["mu0"] * (p["r"] + (1 - p["r"]) * np.exp(-p["V"] / p["v_s"]))
    mu = mu * np.tanh(20 * p["V"] / p["v_s"])
    pull = strut(x, y, p)
    bent = 2 * p["eta"] * (x - 1) * _bell(x)
    return [p["alpha"] * x - pull[0] - N * (bent + mu), p["kappa"] - pull[1] - N]


HUMP = Case(
    Hand(_HUMP, _hump, lambda q, p: q[1] - p["eta"] * _bell(q[0])),
    {
        "theta0": (0.3, 1.4),
        "sigma": (0.02, 0.6),
        "alpha": (1e-3, 0.1),
        "eta": (1e-3, 0.2),
        "kappa": (1e-3, 0.1),
        "mu0": (0.05, 1.0),
        "v_s": (0.05, 1.0),
    },
    ((-3.0, 4.0), (-1.0, 1.0)),
)

# ------------------------------------------------------------------------------------------------
# a dent, and a force that falls as 1/x

_DENT = (
    HEAD
    + SLIP
    + PLANE
    + MASS
    + f"""
k_y = page.parameter("k_y", "N/m", "stiffness across", ">= 0", 0.05, becomes="beta")
k_l = page.parameter("k_l", "N/m", "stiffness that falls with distance", ">= 0", 0.1, becomes="lam")
page.spring(k_y, along=y)
page.potential(k_l * L_0**2 * log(1 + x**2 / L_0**2) / 2)
page.contact(y + h * (1 - exp(-x**2 / L_0**2)),
             lambda depth: k_c * depth + 3 * k_c * depth**2 / L_0)
page.friction(x, V, {FRICTION})
"""
)


def _dent(q: Any, p: Values, contact: int) -> list[Any]:
    x, y = q
    depth = -_dent_gap(q, p)
    N = contact * (depth + 3 * depth**2)
    bent = 2 * p["eta"] * x * np.exp(-(x**2))
    pull = p["alpha"] * x + p["lam"] * x / (1 + x**2)
    return [pull - N * (bent + p["mu0"]), p["beta"] * y + p["kappa"] - N]


def _dent_gap(q: Any, p: Values) -> Any:
    return q[1] + p["eta"] * (1 - np.exp(-(q[0] ** 2)))


DENT = Case(
    Hand(_DENT, _dent, _dent_gap, lambda depth, p: depth + 3 * depth**2),
    {
        "alpha": (1e-3, 0.05),
        "beta": (1e-3, 0.3),
        "lam": (1e-3, 0.3),
        "eta": (1e-3, 0.3),
        "kappa": (1e-3, 0.2),
        "mu0": (0.05, 1.0),
    },
    ((-30.0, 60.0), (-1.0, 0.2)),
)

# ------------------------------------------------------------------------------------------------
# a step, a rod that turns, a force with a limit

_STEP = (
    HEAD
    + SLIP
    + f"""
k_s = page.parameter("k_s", "N/m", "stiffness with a limit", ">= 0", 0.1, becomes="lam")
k_t = page.parameter("k_t", "N m", "stiffness that turns back", "> 0", 0.2, becomes="tau")
psi = page.parameter("psi", "rad", "angle at rest", "real", 0.3)
phi = page.coordinate("phi", "rad", "angle")
page.kinetic(m * (page.rate(x)**2 + page.rate(L_0 * phi)**2) / 2)
page.force(-F_L, along=L_0 * sin(phi))
page.potential(k_s * L_0**2 * sqrt(1 + x**2 / L_0**2))
page.potential(k_t * (phi - psi)**2 / 2)
page.contact(L_0 * sin(phi) - h * tanh(3 * x / L_0), lambda depth: k_c * depth)
page.friction(x, V, {FRICTION})
"""
)


def _step_gap(q: Any, p: Values) -> Any:
    return np.sin(q[1]) - p["eta"] * np.tanh(3 * q[0])


def _step(q: Any, p: Values, contact: int) -> list[Any]:
    x, phi = q
    N = -contact * _step_gap(q, p)
    bent = -3 * p["eta"] * (1 - np.tanh(3 * x) ** 2)
    return [
        p["alpha"] * x + p["lam"] * x / np.sqrt(1 + x**2) - N * (bent + p["mu0"]),
        p["tau"] * (phi - p["psi"]) + (p["kappa"] - N) * np.cos(phi),
    ]


STEP = Case(
    Hand(_STEP, _step, _step_gap),
    {
        "alpha": (1e-3, 0.1),
        "lam": (1e-3, 0.3),
        "tau": (0.02, 1.0),
        "psi": (-1.2, 0.3),
        "eta": (1e-3, 0.2),
        "kappa": (1e-3, 0.2),
        "mu0": (0.05, 1.0),
    },
    ((-20.0, 60.0), (-2.0, 2.0)),
)

# ------------------------------------------------------------------------------------------------
# three coordinates, a bell between two of them, a strut

_CHAIN = (
    HEAD
    + SLIP
    + PLANE
    + STRUT
    + f"""
k_z = page.parameter("k_z", "N/m", "stiffness of the second mass", "> 0", 0.3, becomes="zeta")
k_b = page.parameter("k_b", "N/m", "strength of the bell", "real", 0.05, becomes="beta")
z = page.coordinate("z", "m", "second mass")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2 + page.rate(z)**2 / 3) / 2)
page.spring(k_z, along=z - x)
page.spring(k_z, along=z)
page.potential(k_b * L_0**2 * exp(-(z / L_0 - 1)**2))
page.contact(y - h * exp(-x**2 / L_0**2), lambda depth: k_c * depth)
page.friction(x, V, {FRICTION})
"""
)


def _chain_gap(q: Any, p: Values) -> Any:
    return q[1] - p["eta"] * np.exp(-(q[0] ** 2))


def _chain(q: Any, p: Values, contact: int) -> list[Any]:
    x, y, z = q
    N = -contact * _chain_gap(q, p)
    pull = strut(x, y, p)
    bent = 2 * p["eta"] * x * np.exp(-(x**2))
    between = p["zeta"] * (z - x)
    return [
        p["alpha"] * x - pull[0] - between - N * (bent + p["mu0"]),
        p["kappa"] - pull[1] - N,
        between + p["zeta"] * z - 2 * p["beta"] * (z - 1) * _bell(z),
    ]


CHAIN = Case(
    Hand(_CHAIN, _chain, _chain_gap),
    {
        "theta0": (0.3, 1.4),
        "sigma": (0.02, 0.6),
        "alpha": (1e-3, 0.1),
        "zeta": (0.02, 0.5),
        "beta": (0.01, 0.3),
        "eta": (1e-3, 0.2),
        "kappa": (1e-3, 0.1),
        "mu0": (0.05, 1.0),
    },
    ((-3.0, 4.0), (-1.0, 1.0), (-3.0, 4.0)),
)

CASES = {"hump": HUMP, "dent": DENT, "step": STEP, "chain": CHAIN}


def drawn(case: Case, rng: np.random.Generator, number: int) -> dict[str, NDArray[np.float64]]:
    """Parameters at random: over decades where the range is positive, else evenly."""
    return {
        name: np.exp(rng.uniform(np.log(low), np.log(high), number))
        if low > 0
        else rng.uniform(low, high, number)
        for name, (low, high) in case.ranges.items()
    }


def by_many_starts(
    case: Case, p: Values, rng: np.random.Generator, starts: int
) -> NDArray[np.float64]:
    """States in contact that SciPy finds from starts at random, each once, shape (states,
    coordinates).
    """
    low, high = np.array(case.starts).T
    forces: Callable[[Any], Any] = lambda q: np.array(case.hand.forces(q, p, 1))  # noqa: E731
    found: list[NDArray[np.float64]] = []
    for start in rng.uniform(low, high, (starts, low.size)):
        end = root(forces, start, tol=1e-12)
        q = end.x
        known = any(np.abs(q - other).max() < 1e-6 * (1 + np.abs(q).max()) for other in found)
        rests = np.abs(forces(q)).max() < 1e-11
        if rests and not known and case.hand.gap(q, p) < -1e-9:
            found.append(q)
    return np.array(found).reshape(len(found), low.size)


def missed(
    case: Case, model: Any, p: Values, eq: Any, rng: np.random.Generator, starts: int
) -> tuple[int, list[str]]:
    """How many states SciPy finds in the regions, and what of them and of those listed is wrong."""
    wrong, number = list[str](), 0
    for point in range(eq.count.size):
        at = {**model.base, **{name: float(column[point]) for name, column in p.items()}}
        q = [getattr(eq, name)[point, : eq.count[point]] for name in model.coordinates]
        own = np.array(q).T
        wrong += [
            f"no state: {state}, {at}"
            for state in own
            if np.abs(case.hand.forces(state, at, 1)).max() > 1e-10
        ]
        low, high = eq.region[point].T
        for state in by_many_starts(case, at, rng, starts):
            if not ((state > low) & (state < high)).all() and not eq.whole[point]:
                continue
            number += 1
            near = np.abs(own - state).max(axis=1) < 1e-5 * (1 + np.abs(state).max())
            left = any(
                (np.array(box.low) <= state).all() and (state <= np.array(box.high)).all()
                for box in eq.undecided
                if box.index == (point,)
            )
            if not near.any() and not left:
                wrong.append(f"lost: {state}, {at}")
    return number, wrong
