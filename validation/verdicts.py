"""Verdicts on motions against a driver that knows nothing of the library's.

A hundred motions at random, and from number 100 on those from rest where irregular ones are common,
at a steep friction law and a slow belt (even numbers), and transients at the base values (odd
ones), judged by ``ss.fate``. Each verdict is held against SciPy's DOP853 with its own events, on
equations written by hand, begun where the library's motion ended:

- rest: 3000 time units later the motion comes no farther from the equilibrium than before, or stays
  within 1e-6 of it;
- cycle: once round from its state leads back to it within 1e-6, and the multipliers by differences
  of this driver, all but the one nearest to 1, are in the unit circle, as far as they are known, to
  1e-3;
- chaos: two motions 1e-8 apart part at a rate that agrees with the largest exponent within a factor
  of two, over twelve stretches;
- lift-off: there is no crossing of y = 0.

Errors of exponents are held against those of multipliers, where a motion has wound onto a cycle:
the share of 95 % intervals that hold is counted. It guards the claim of docs/oscillation.md that
another driver confirms every verdict.
"""

import math
from typing import Any

import numpy as np

import spragsym as ss
from tests.oracles.second_driver import carried

CASES = 120
#: How long a motion is followed by the library; among irregular ones.
T_END, LONGER = 20_000.0, 40_000.0

#: So many are drawn at random; further ones where motions are irregular.
RANDOM = 100


def drawn(number: int) -> tuple[tuple[float, ...], list[float]]:
    """Parameters and start of a motion."""
    rng = np.random.default_rng([83, number])
    if number >= RANDOM:
        steep = (
            rng.uniform(0.70, 0.78),
            0.5,
            0.007,
            0.007,
            0.1,
            0.0,
            0.25,
            rng.uniform(17.0, 23.0),
        )
        base = (rng.uniform(0.77, 1.3), 0.5, 0.007, 0.007, 0.1, 0.0, 0.5, 10.0)
        return tuple(float(value) for value in (base if number % 2 else steep)), [0.0] * 4
    values = (
        rng.uniform(0.2, 2.9),
        rng.uniform(0.05, 1.0),
        0.007 * 10 ** rng.uniform(-0.5, 0.5),
        0.007 * 10 ** rng.uniform(-0.5, 0.5),
        0.1 * 10 ** rng.uniform(-0.4, 0.4),
        0.0,
        rng.uniform(0.05, 0.6),
        rng.uniform(2.0, 15.0),
    )
    start = (
        [0.0] * 4
        if rng.random() < 0.3
        else rng.uniform([-0.5, -0.5, -0.3, -0.3], [3.0, 3.0, 0.3, 0.3]).tolist()
    )
    return tuple(float(value) for value in values), start


def parting(
    values: tuple[float, ...], state: Any, stretches: int = 12, span: float = 100.0
) -> float:
    """The rate at which motions 1e-8 apart part, over some stretches."""
    total, other = 0.0, np.array(state) + np.array([1e-8, 0.0, 0.0, 0.0])
    for _ in range(stretches):
        state, _ = carried(values, state, span)
        other, _ = carried(values, other, span)
        off = other - state
        size = float(np.linalg.norm(off))
        total += math.log(size / 1e-8)
        other = state + off * (1e-8 / size)
    return total / (stretches * span)


def reach_of(
    values: tuple[float, ...], state: Any, place: Any, pieces: int = 200, span: float = 2.0
) -> tuple[float, Any]:
    """How far a motion comes from a place in a while, and where it then is."""
    off = 0.0
    for _ in range(pieces):
        state, _ = carried(values, state, span)
        off = max(off, float(np.abs(state - place).max()))
    return off, state


def holds(values: tuple[float, ...], found: ss.results.Fate) -> tuple[bool, str]:
    """Whether the other driver confirms a verdict."""
    if found.kind == "rest":
        place = np.array([*found.outcome.rest, 0.0, 0.0])
        before, state = reach_of(values, found.end, place)
        after, _ = reach_of(values, carried(values, state, 3000.0)[0], place)
        return after < max(1.02 * before, 1e-6), f"up to {before:.3g} off, 3000 later {after:.3g}"
    if found.kind == "cycle":
        told = found.outcome
        state = np.array(told.cycle)
        end, _ = carried(values, state, told.period, 1e-13)
        closed = float(np.abs(end - state).max())
        kicks = 1e-6 * np.eye(4)
        ahead, behind = (
            [carried(values, state + sign * kick, told.period, 1e-12)[0] for kick in kicks]
            for sign in (1, -1)
        )
        multipliers = np.linalg.eigvals((np.array(ahead) - np.array(behind)).T / 2e-6)
        others = np.delete(multipliers, int(np.argmin(np.abs(multipliers - 1))))
        largest = float(np.abs(others).max())
        return (
            closed < 1e-6 and largest < 1 + 1e-3,
            f"closes to {closed:.1g}; largest multiplier by differences {largest:.6f}",
        )
    if found.kind == "chaotic":
        rate = parting(values, found.end)
        return 0.4 < rate / found.exponents[
            0
        ] < 2.5, f"parts at {rate:.3g}, exponent {found.exponents[0]:.3g}"
    if found.kind == "lift-off":
        crossed = carried(values, found.end, 200.0)[1]
        return crossed == 0, f"{crossed} crossings of y = 0"
    return True, "nothing is said"


def judge(number: int, _: np.random.Generator) -> dict[str, Any]:
    """One motion."""
    values, start = drawn(number)
    found = ss.fate(ss.Parameters(*values), start=start, t_end=T_END if number < RANDOM else LONGER)
    right, how = holds(values, found)
    line: dict[str, Any] = {
        "kind": found.kind,
        "wrong": [] if right else [f"{found.kind}, {found.why}: {how}"],
    }
    if found.kind == "cycle":
        told = ss.lyapunov(ss.Parameters(*values), start=found.outcome.cycle, t_end=4000.0)
        held = np.abs(told.exponents - found.exponents) <= told.error + 1e-9
        line |= {"intervals of exponents": held.size, "of them hold": int(held.sum())}
    return line
