"""Least periods of cycles with the coordinates in every order, against SciPy on equations by hand
and against closed forms.

Beside what moves stands a coordinate that comes to rest, and one that follows; each of the three
comes first in turn. A period that is told several times is wrong, and so is a cycle that is not
found from a state on its way, or by the fate of that.
"""

import functools
import itertools
import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import spragsym as ss
from tests.oracles.user_pages import model_of

#: Periods that differ by more, relatively, are not one.
OFF = 1e-6
#: What moves by less late in a motion rests, or is about to.
MOVES = 0.01

HEAD = '''"""What moves, what follows, and what comes to rest."""
from spragsym.derive.model import Page, cos, sgn, sin

page = Page("What moves, what follows, and what comes to rest.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
L = page.unit("L", "m", "length")
k_w = page.parameter("k_w", "N/m", "spring of what follows", "> 0")
c_w = page.parameter("c_w", "N s/m", "its damper", ">= 0")
c_r = page.parameter("c_r", "N s/m", "damper of what comes to rest", ">= 0")
'''

TAIL = """
page.kinetic(m * ({inertia} + page.rate(w) ** 2 + page.rate(r) ** 2) / 2)
page.damper(c_w, along=w)
page.spring(k, along=r)
page.damper(c_r, along=r)
"""

INERTIA = {"z": "page.rate(z) ** 2", "phi": "(L * page.rate(phi)) ** 2"}

COORDINATES = {
    "z": 'z = page.coordinate("z", "m", "block")\n',
    "phi": 'phi = page.coordinate("phi", "rad", "rotor")\n',
    "w": 'w = page.coordinate("w", "m", "what follows")\n',
    "r": 'r = page.coordinate("r", "m", "what comes to rest")\n',
}

BLOCK = """
c = page.parameter("c", "N s/m", "damper", ">= 0")
mu_s = page.parameter("mu_s", "1", "friction coefficient", ">= 0")
v_s = page.parameter("v_s", "m/s", "sliding speed at which it is largest", "> 0")
V = page.parameter("V", "m/s", "belt speed", ">= 0")
{coordinates}
page.spring(k, along=z)
page.damper(c, along=z)
page.potential(k_w * (w - z) ** 2 / 2)
page.normal_force(k * L)
page.friction(z, V, lambda v: 2 * mu_s * v * v_s / (v**2 + v_s**2))
"""

DRY = """
mu_s = page.parameter("mu_s", "1", "static friction coefficient", ">= 0")
mu_k = page.parameter("mu_k", "1", "kinetic friction coefficient", ">= 0")
V = page.parameter("V", "m/s", "belt speed", ">= 0")
{coordinates}
page.spring(k, along=z)
page.spring(k_w, along=w)
page.normal_force(k * L)
page.friction(z, V, slip=lambda v: mu_k * sgn(v), holds=mu_s)
"""

ROTOR = """
c = page.parameter("c", "N m s", "damper", ">= 0")
T = page.parameter("T", "N m", "torque", "real")
e = page.parameter("e", "N", "coupling", "real")
{coordinates}
page.potential(k * L**2 * (1 - cos(phi)) + e * w * sin(phi))
page.damper(c, along=phi)
page.force(T, along=phi)
page.spring(k_w, along=w)
"""

MOTOR = """
c = page.parameter("c", "N m s", "slope of the motor's torque over its speed", "> 0")
T = page.parameter("T", "N m", "torque of the motor at rest", "real")
mu_s = page.parameter("mu_s", "1", "friction coefficient", ">= 0")
v_s = page.parameter("v_s", "m/s", "sliding speed at which it is largest", "> 0")
V = page.parameter("V", "m/s", "speed of the frame", ">= 0", 0.0)
{coordinates}
page.damper(c, along=phi)
page.force(T, along=phi)
page.spring(k_w, along=w)
page.normal_force(k * L)
page.friction(w - L * phi, V, lambda v: 2 * mu_s * v * v_s / (v**2 + v_s**2))
"""


class Case(NamedTuple):
    """A page, what moves on it, values of its parameters, a start by names, and the least period
    as it follows from elsewhere, None for a motion that repeats nothing there; and the rates of
    what moves and what follows, by hand.
    """

    page: str
    mover: str
    values: dict[str, float]
    start: dict[str, float]
    period: float | None
    rates: Callable[..., Any] | None = None


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One cycle, with its coordinates in one order."""
    kinds = (block, dry, rotor, motor)
    kind = kinds[number // 6 % len(kinds)]
    case = kind(rng)
    order = [*itertools.permutations((case.mover, "w", "r"))][number % 6]
    found: dict[str, Any] = {"kind": kind.__name__, "wrong": []}
    if case.period is None:
        return found | {"kind": "no cycle"}
    p = built(case.page, order).Parameters(**case.values)
    near = [case.start.get(name, 0.0) for name in (*order, *(f"v{each}" for each in order))]
    cycle = ss.cycle(p, near=near)
    fate = ss.fate(p, start=near)
    again = ss.cycle(p, near=cycle.state)
    own = case.period
    if not cycle.stable and case.rates is not None and abs(cycle.period / own - 1) > OFF:
        # Near the start, and not where the motion from it goes.
        found["kind"] = "unstable"
        own = cycle.period if is_least_period(case, order, cycle) else math.nan
    told = {
        "cycle": (cycle.period, own),
        "fate": (fate.outcome.period, case.period),
        "cycle at its own state": (again.period, own),
    }
    off = {name: abs(period / known - 1) for name, (period, known) in told.items()}
    found["wrong"] = [
        f"{kind.__name__} with {', '.join(order)}: {name} has {told[name][0]:.10g}, "
        f"{told[name][0] / case.period:.6g} periods"
        for name, each in off.items()
        if not each <= OFF
    ]
    return found | {"off": max(off.values())}


def is_least_period(case: Case, order: tuple[str, ...], cycle: ss.results.Cycle) -> bool:
    """Whether SciPy's motion from a cycle's state is back after its period, and not after a
    divisor of that.
    """
    assert case.rates is not None
    places = dict(zip(order, cycle.state.reshape(2, -1).T, strict=True))
    start = np.ravel([[places[case.mover][i], places["w"][i]] for i in range(2)])
    times = cycle.period / np.arange(9, 0, -1)
    run = solve_ivp(
        case.rates, (0.0, cycle.period), start, "DOP853", t_eval=times, rtol=1e-12, atol=1e-14
    )
    apart = np.abs(run.y - start[:, None]).max(axis=0)
    return bool(apart[-1] < OFF < 1e-3 < apart[:-1].min())


CASES = 60


@functools.cache
def built(page: str, order: tuple[str, ...]) -> Any:
    """The model of a page with its coordinates in an order."""
    coordinates = "".join(COORDINATES[name] for name in order)
    (mover,) = INERTIA.keys() & {*order}
    text = HEAD + page.format(coordinates=coordinates) + TAIL.format(inertia=INERTIA[mover])
    return model_of(text, "_".join(order))


def beside(rng: np.random.Generator) -> dict[str, float]:
    """Parameters of what follows and of what comes to rest."""
    return {
        "k_w": rng.uniform(2.0, 6.0),
        "c_w": rng.uniform(0.2, 1.0),
        "c_r": rng.uniform(0.1, 0.6),
    }


def block(rng: np.random.Generator) -> Case:
    """A block on a belt whose friction falls with speed, and a mass on a spring to it."""
    own = {
        "c": rng.uniform(0.0, 0.1),
        "mu_s": rng.uniform(0.3, 0.8),
        "v_s": rng.uniform(0.1, 0.2),
        "V": rng.uniform(0.2, 0.4),
    }
    known = own | beside(rng)
    start = {"z": rng.uniform(0.0, 0.5), "r": rng.uniform(-0.3, 0.3)}

    def rates(_: float, u: Sequence[float]) -> list[float]:
        z, w, vz, vw = u
        v = known["V"] - vz
        mu = 2 * known["mu_s"] * v * known["v_s"] / (v * v + known["v_s"] ** 2)
        pull = known["k_w"] * (w - z)
        return [vz, vw, mu - z - known["c"] * vz + pull, -pull - known["c_w"] * vw]

    first = [start["z"], 0.0, 0.0, 0.0]
    return Case(BLOCK, "z", known, start, period_of(rates, first, lambda _, u: u[2], -1), rates)


def dry(rng: np.random.Generator) -> Case:
    """A block that sticks and slips: its period has a closed form."""
    mu_s = rng.uniform(0.4, 0.8)
    own = {"mu_s": mu_s, "mu_k": mu_s * rng.uniform(0.4, 0.9), "V": rng.uniform(0.1, 1.0)}
    ratio = (own["mu_s"] - own["mu_k"]) / own["V"]
    start = {"z": mu_s, "vz": own["V"], "r": rng.uniform(-0.3, 0.3), "w": rng.uniform(-0.3, 0.3)}
    period = 2 * ratio + 2 * math.pi - 2 * math.atan(ratio)
    return Case(DRY, "z", own | beside(rng), start, period)


def rotor(rng: np.random.Generator) -> Case:
    """A driven pendulum that turns around, and a mass that it shakes."""
    own = {
        "c": rng.uniform(0.1, 0.3),
        "T": rng.uniform(0.8, 1.5),
        "e": rng.uniform(0.02, 0.2),
    }
    known = own | beside(rng)
    start = {"vphi": own["T"] / own["c"], "r": rng.uniform(-0.3, 0.3)}

    def rates(_: float, u: Sequence[float]) -> list[float]:
        phi, w, turning, vw = u
        torque = known["T"] - known["c"] * turning - math.sin(phi)
        return [
            turning,
            vw,
            torque - known["e"] * w * math.cos(phi),
            -known["k_w"] * w - known["e"] * math.sin(phi) - known["c_w"] * vw,
        ]

    first = [0.0, 0.0, start["vphi"], 0.0]
    period = period_of(rates, first, lambda _, u: math.sin(u[0] / 2), 0)
    return Case(ROTOR, "phi", known, start, period, rates)


def motor(rng: np.random.Generator) -> Case:
    """A belt that a motor of limited power drives, at its steady speed."""
    own = {
        "c": rng.uniform(0.3, 1.0),
        "T": rng.uniform(0.6, 1.5),
        "mu_s": rng.uniform(0.1, 0.3),
        "v_s": rng.uniform(0.1, 0.3),
    }

    def lacking(speed: float) -> float:
        mu = 2 * own["mu_s"] * speed * own["v_s"] / (speed**2 + own["v_s"] ** 2)
        return own["T"] - own["c"] * speed - mu

    speed = float(brentq(lacking, 0.0, own["T"] / own["c"], xtol=1e-14))
    known = own | beside(rng) | {"c_w": 2.0}  # what follows is damped by more than friction drives
    start = {
        "vphi": speed + rng.uniform(0.0, 0.2),
        "r": rng.uniform(-0.3, 0.3),
        "w": rng.uniform(0.0, 0.1),
    }
    return Case(MOTOR, "phi", known, start, 2 * math.pi / speed)


def period_of(
    rates: Callable[..., Any], start: Sequence[float], section: Any, direction: int
) -> float | None:
    """The least period of what a motion settles to, by its returns to a section; None where it is
    not seen to settle.
    """
    section.direction = direction
    found = solve_ivp(
        rates, (0.0, 900.0), start, method="DOP853", events=section, rtol=1e-11, atol=1e-13
    )
    if np.ptp(found.y[: len(start) // 2, -len(found.t) // 9 :]) < MOVES:
        return None
    times, states = found.t_events[0][-40:], found.y_events[0][-40:]
    if direction == 0:  # an angle that turns around
        states = states[:, 1:]
    for rounds in range(1, 9):
        apart = np.abs(states[rounds:] - states[:-rounds]).max(axis=0)
        if (apart < 1e-7 * (1 + np.ptp(states, axis=0))).all():
            return float(times[-1] - times[-1 - rounds])
    return None
