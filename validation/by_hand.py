"""Random attack on every shipped model and other pages, against forces written by hand: equilibria,
motions, generated code.

Values are log-uniform over 10⁻⁶ to 10⁶ or near the base, ends of ranges and 0 among them. A motion,
on both integrators, is held against one that SciPy integrates without modes and events, and against
the balance of energy. Last found: errors up to 7e-8 on proved states of stiff springs, kinks and
belts that run backwards, which were carried through (5b82b53f).
"""

import contextlib
import functools
import itertools
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from tests.oracles import by_hand, emission
from tests.oracles.forces_by_hand import DRAWN, Drawn, Values

CASES = 20 * len(DRAWN)
#: Steps after which a motion is given up.
MAX_STEPS = 4000
RTOL = 1e-9
#: Calls of the field after which the reference is given up.
CALLS = 100_000


@functools.cache
def derived() -> Any:
    """A folder for what is derived, as long as the process lives."""
    return tempfile.TemporaryDirectory()


@functools.cache
def model_of(name: str) -> Any:
    """A model, derived once."""
    return by_hand.load(name, Path(derived().name))


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One set of parameters of one model; the first of each has its generated functions
    compared.
    """
    name = list(DRAWN)[number % len(DRAWN)]
    model, drawn = model_of(name), DRAWN[name]
    values = draw(model, rng)
    asked = [
        lambda side=side: by_hand.equilibria(model, drawn, values, side, rng)
        for side in (True, False)[: 1 + drawn.lifts]
    ]
    asked.append(lambda: motion(model, drawn, values, rng))
    found: dict[str, Any] = {"kind": name, "wrong": [], "undecided": 0, "refused": 0}
    for ask in asked:
        try:
            told = ask()
        except ss.errors.SpragsymError:
            found["refused"] += 1
            continue
        found["wrong"] += [f"{name} {values}: {text}" for text in told["wrong"]]
        found["undecided"] += told.get("undecided", 0)
    if number < len(DRAWN):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(None):
            found["wrong"] += emission.compare(name, 20, number, Path(folder))
    return found


def draw(model: Any, rng: np.random.Generator) -> Values:
    """One set of parameters."""
    values: Values = {}
    near = rng.random() < 0.3  # all near the base
    for name, allowed in model.Parameters.ranges.items():
        low, high = max(allowed.low, -1e6), min(allowed.high, 1e6)
        base = model.base.get(name, 1.0)
        kind = rng.random()
        if high < 1e6:
            ends = [
                low if not allowed.open_low else np.nextafter(low, high),
                np.nextafter(high, low),
                (low + high) / 2,
            ]
            value = rng.choice(ends) if kind < 0.08 else rng.uniform(low, high)
        elif low < 0:
            value = rng.uniform(-3.2, 3.2)
        elif kind < 0.08 and allowed.contains(0.0):
            value = 0.0
        elif near or kind < 0.3:
            value = (base or 0.1) * 10 ** rng.uniform(-0.6, 0.6)
        else:
            value = 10 ** rng.uniform(-6, 6)
        values[name] = float(value)
    return values


def start_of(drawn: Drawn, rng: np.random.Generator) -> tuple[Any, int]:
    """Rest at 0, a place on the gap's border, one in lift-off, the belt's speed, or anything."""
    n = len(drawn.masses)
    start = np.zeros(2 * n)
    kind = rng.integers(6)
    if kind >= 2:
        start += rng.normal(0, 0.3, 2 * n)
    if n > 1 and kind == 3:
        start[1] = 0.0
    if n > 1 and kind == 4:
        start[[1, n + 1]] = abs(start[[1, n + 1]])
    return start, int(kind)


def motion(model: Any, drawn: Drawn, values: Values, rng: np.random.Generator) -> dict[str, Any]:
    """What is wrong with a motion of one set."""
    start, kind = start_of(drawn, rng)
    if kind == 1:
        start[len(drawn.masses)] = values["V"]
    if "depth_e" in values:
        start[1] = max(start[1], -5 * values["depth_e"])  # no number holds the force much deeper
    rhs = by_hand.field(drawn, values)
    rate = _fastest(rhs, start)
    t_end = float(min(20.0, 30.0 / rate) * 10 ** rng.uniform(-1, 0))
    outcome = {
        "wrong": [],
        "seconds": 0.0,
        "kind": int(kind),
        "t_end": t_end,
        "start": start.tolist(),
    }
    try:
        reference, sure = _reference(rhs, start, t_end)
    except TimeoutError:
        return {**outcome, "refused": "the reference takes too long"}
    for backend in ("heyoka", "scipy"):
        begin = time.process_time()
        for rtol in (RTOL, RTOL / 1000):  # stiff creep multiplies the tolerance
            try:
                tr = ss.simulate(
                    model.Parameters(**values),
                    start=start,
                    t_end=t_end,
                    rtol=rtol,
                    backend=backend,
                    max_steps=MAX_STEPS,
                )
            except ss.errors.ConvergenceError as error:
                outcome["refused"] = str(error)
                wrong = []
                break
            outcome["seconds"] = max(outcome["seconds"], time.process_time() - begin)
            wrong = [
                f"{backend}: {text}"
                for text in _off_motion(drawn, values, tr, reference, sure, rate)
            ]
            if not wrong:
                break
        outcome["wrong"] += wrong
    return outcome


def _off_motion(
    drawn: Drawn, values: Values, tr: Any, reference: Any, sure: float, rate: float
) -> list[str]:
    """Whether a motion ends elsewhere than the reference, or its energy does not balance; ``rate``,
    with the length 1, is what absolute tolerances of rates are taken over.
    """
    if not np.isfinite(tr.state).all():
        return ["a number that is none"]
    wrong, n = [], len(drawn.masses)
    off_end = np.abs(tr.state[:, -1] - reference)
    least = 1e-3 * np.repeat([1.0, max(1.0, rate)], n)
    away = off_end.max()
    if (off_end > 1e-6 * np.maximum(least, np.abs(tr.state).max()) + 30 * sure).any():
        wrong.append(f"the end is {away:.2g} from the reference's, sure to {sure:.1g}")
    energy, power = tr.energy(), tr.power()
    kinetic = np.abs(
        tr.state[n:] ** 2 * np.array(drawn.inertia(values), dtype=float)[:, None]
    ).max()
    scale = np.abs(energy).max() + kinetic + tr.integral(np.abs(power))
    rounding = (
        1e-14 * max(map(abs, values.values())) * max(1.0, values.get("lambda_2", 1.0)) ** 2
    )  # of springs' energies at rest
    off = abs(energy[-1] - energy[0] - tr.integral(power))
    if not off <= 1e-5 * scale + rounding:
        wrong.append(f"the energy is off by {off / scale:.2g} of its size")
    return wrong


def _fastest(rhs: Any, start: Any) -> float:
    """A rate of the field near the start, by differences."""
    base = rhs(0.0, start)
    rates = [
        np.abs((rhs(0.0, start + 1e-6 * unit) - base) / 1e-6).max() for unit in np.eye(len(start))
    ]
    return float(np.sqrt(max(max(rates), 1e-6)))


def _reference(rhs: Any, start: Any, t_end: float) -> tuple[Any, float]:
    """The end of the motion by an implicit method on the field as a whole, and the difference of
    two tolerances.
    """
    from scipy.integrate import solve_ivp

    calls = itertools.count()

    def counted(t: float, state: Any) -> Any:
        if next(calls) > CALLS:
            raise TimeoutError
        return rhs(t, state)

    with np.errstate(all="ignore"):
        ends = [
            solve_ivp(
                counted,
                (0.0, t_end),
                start,
                method="LSODA",
                rtol=rtol,
                atol=rtol * 1e-3,
                max_step=t_end / 500,
            ).y[:, -1]
            for rtol in (1e-8, 1e-10)
        ]
    return ends[1], float(np.abs(ends[1] - ends[0]).max())
