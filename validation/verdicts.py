"""Verdicts on motions against a driver that knows nothing of the library's; a line for every motion, and a table.

``python -m validation.verdicts FILE [N [FIRST]]``: N motions (120 unless given) judged by ``ss.fate``, from number FIRST on:
100 at random, and from number 100 on those from rest where irregular ones are common, at a steep friction law and a slow belt
(even numbers), and transients at the base values (odd ones). Finished ones stand in FILE, one a line, and the same command goes on
from there. Each verdict is held against SciPy's DOP853 with its own events, on equations written by hand, begun where the library's
motion ended:

- rest: 3000 time units later the motion comes no farther from the equilibrium than before, or stays within 1e-6 of it;
- cycle: once round from its state leads back to it within 1e-6, and the multipliers by differences of this driver, all but the
  one nearest to 1, are in the unit circle, as far as they are known, to 1e-3;
- chaos: two motions 1e-8 apart part at a rate that agrees with the largest exponent within a factor of two, over twelve stretches;
- lift-off: there is no crossing of y = 0.

Errors of exponents are held against those of multipliers, where a motion has wound onto a cycle: the share of 95 % intervals that
hold is printed below the table.
"""

from __future__ import annotations

import math
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

import spragsym as ss
from tests.oracles import article_motion
from validation.parts import numbered

#: How long a motion is followed by the library; among irregular ones.
T_END, LONGER = 20_000.0, 40_000.0

#: So many are drawn at random; further ones where motions are irregular.
RANDOM = 100


def carried(values: tuple[float, ...], state: Any, span: float, rtol: float = 1e-11) -> tuple[Any, int]:
    """Where the motion is after a while, and how often it crossed y = 0, piece by piece between SciPy's events."""
    theta0, *rest = values
    constants, V = (math.cos(theta0), math.sin(theta0), *rest), rest[-2]
    state, clock, crossed = np.array(state, dtype=float), 0.0, 0
    contact, side = int(state[1] <= 0), 1 if state[2] <= V else -1
    while clock < span:
        mode = (contact, side)

        def rates(_: float, z: Any, mode: tuple[int, int] = mode) -> Any:
            return [*z[2:], *article_motion.accelerations(z.tolist(), constants, *mode)]

        def leaves(_: float, z: Any, mode: tuple[int, int] = mode) -> float:
            return float((1 - 2 * mode[0]) * z[1] + 1e-12)

        def turns(_: float, z: Any, mode: tuple[int, int] = mode) -> float:
            return float(mode[1] * (V - z[2]) + 1e-12)

        for event in (leaves, turns):
            event.terminal, event.direction = True, -1  # type: ignore[attr-defined]  # as SciPy wants it
        part = solve_ivp(rates, (clock, span), state, method="DOP853", rtol=rtol, atol=1e-3 * rtol, events=(leaves, turns))
        clock, state = float(part.t[-1]), part.y[:, -1]
        if len(part.t_events[0]):
            contact, crossed = 1 - contact, crossed + 1
        elif len(part.t_events[1]):
            side = -side
    return state, crossed


def drawn(number: int) -> tuple[tuple[float, ...], list[float]]:
    """Parameters and start of a motion."""
    rng = np.random.default_rng([83, number])
    if number >= RANDOM:
        steep = (rng.uniform(0.70, 0.78), 0.5, 0.007, 0.007, 0.1, 0.0, 0.25, rng.uniform(17.0, 23.0))
        base = (rng.uniform(0.77, 1.3), 0.5, 0.007, 0.007, 0.1, 0.0, 0.5, 10.0)
        return tuple(float(value) for value in (base if number % 2 else steep)), [0.0] * 4
    values = (
        rng.uniform(0.2, 2.9), rng.uniform(0.05, 1.0), 0.007 * 10 ** rng.uniform(-0.5, 0.5),
        0.007 * 10 ** rng.uniform(-0.5, 0.5), 0.1 * 10 ** rng.uniform(-0.4, 0.4), 0.0, rng.uniform(0.05, 0.6), rng.uniform(2.0, 15.0),
    )  # fmt: skip
    start = [0.0] * 4 if rng.random() < 0.3 else rng.uniform([-0.5, -0.5, -0.3, -0.3], [3.0, 3.0, 0.3, 0.3]).tolist()
    return tuple(float(value) for value in values), start


def parting(values: tuple[float, ...], state: Any, stretches: int = 12, span: float = 100.0) -> float:
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


def reach_of(values: tuple[float, ...], state: Any, place: Any, pieces: int = 200, span: float = 2.0) -> tuple[float, Any]:
    """How far a motion comes from a place in a while, and where it then is."""
    off = 0.0
    for _ in range(pieces):
        state, _ = carried(values, state, span)
        off = max(off, float(np.abs(state - place).max()))
    return off, state


def holds(values: tuple[float, ...], found: ss.Fate) -> tuple[bool, str]:
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
        ahead, behind = ([carried(values, state + sign * kick, told.period, 1e-12)[0] for kick in kicks] for sign in (1, -1))
        multipliers = np.linalg.eigvals((np.array(ahead) - np.array(behind)).T / 2e-6)
        others = np.delete(multipliers, int(np.argmin(np.abs(multipliers - 1))))
        largest = float(np.abs(others).max())
        return closed < 1e-6 and largest < 1 + 1e-3, f"closes to {closed:.1g}; largest multiplier by differences {largest:.6f}"
    if found.kind == "chaotic":
        rate = parting(values, found.end)
        return 0.4 < rate / found.exponents[0] < 2.5, f"parts at {rate:.3g}, exponent {found.exponents[0]:.3g}"
    if found.kind == "lift-off":
        crossed = carried(values, found.end, 200.0)[1]
        return crossed == 0, f"{crossed} crossings of y = 0"
    return True, "nothing is said"


def examined(number: int) -> dict[str, Any]:
    """One motion."""
    values, start = drawn(number)
    begun = time.process_time()
    found = ss.fate(ss.Parameters(*values), start=start, t_end=T_END if number < RANDOM else LONGER)
    line: dict[str, Any] = {"number": number, "kind": found.kind, "why": found.why, "seconds": time.process_time() - begun}
    right, how = holds(values, found)
    line |= {"confirmed": bool(right), "how": how}
    if found.kind == "cycle":
        told = ss.lyapunov(ss.Parameters(*values), start=found.outcome.cycle, t_end=4000.0)
        line["intervals"] = (np.abs(told.exponents - found.exponents) <= told.error + 1e-9).tolist()
    return line


def table(name: str, lines: list[dict[str, Any]]) -> None:
    """Verdicts, and how many of them are confirmed."""
    counts = Counter((line["kind"], line["confirmed"]) for line in lines)
    print(f"| verdict, of {len(lines)} motions {name} | motions | confirmed | processor seconds |\n|---|---|---|---|")
    for kind in sorted({line["kind"] for line in lines}):
        seconds = [line["seconds"] for line in lines if line["kind"] == kind]
        print(f"| {kind} | {len(seconds)} | {counts[kind, True]} | {np.median(seconds):.1f} |")
    print()


def main() -> None:
    """Go through the motions; exit code 1 if a verdict is not confirmed."""
    if not 2 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    count, first = (int(text) for text in (*sys.argv[2:], *("120", "0")[len(sys.argv) - 2 :]))
    lines = numbered(Path(sys.argv[1]), range(first, first + count), examined)
    table("at random", [line for line in lines if line["number"] < RANDOM])
    table("where irregular ones are common", [line for line in lines if line["number"] >= RANDOM])
    held = [each for line in lines for each in line.get("intervals", ())]
    if held:
        print(f"{sum(held)} of {len(held)} intervals of exponents hold the multipliers' values")
    sys.exit(any(not line["confirmed"] for line in lines))


if __name__ == "__main__":
    main()
