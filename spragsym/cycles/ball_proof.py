"""The proof of a cycle in balls: it runs as a process of its own, since python-flint's precision is one for all threads.

``python -m spragsym.cycles.ball_proof`` reads a claim as JSON from standard input and writes what was proved to standard output.
"""

from __future__ import annotations

import importlib
import json
import math
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from flint import acb_mat, arb, arb_mat, ctx

from ..dynamics.field import Field, Mode
from ..errors import ParameterError
from .ball_flow import Balls, NotProved, polynomial, slopes_at, solution
from .jets import XP

#: Rounds of Newton's method with the slopes of double precision.
ROUNDS = 14

#: Half of the window in which a border is crossed, in units of the radius of the starts.
WINDOW = 1e5


def proved(field: Field, claim: dict[str, Any]) -> dict[str, Any]:
    """What is shown of a claim, all numbers as decimal strings; within :func:`bits` of :func:`bits_for` its digits."""
    digits = int(claim["digits"])
    radius, order = arb(10) ** -digits, math.ceil(1.9 * digits)
    radius = arb(float(radius.mid()))
    constants = list(field.constants([arb(value) for value in claim["values"]], XP))
    state, period = [arb(value) for value in claim["state"]], arb(claim["period"])
    n = len(field.coordinates)
    moved = [i for i in range(field.size) if i != n]  # the first speed is 0 where the first coordinate is largest
    mode = field.exact(field.initial_mode(claim["state"], field.constants(claim["values"])))
    slopes = np.array(claim["slopes"])
    inverse = [[arb(value) for value in row] for row in np.linalg.inv(slopes).tolist()]
    state, period, times = _refined(field, constants, state, period, mode, claim["crossings"], inverse, moved, order, digits)

    start = [arb(0, radius) if i in moved else arb(0) for i in range(field.size)]
    balls = Balls(field, constants, order, [value.mid() for value in state], _unit(field.size), start, mode)
    clock, half = arb(0), arb(float((radius * WINDOW).mid()))
    for index, time in times:
        before = arb(time - half).mid()
        balls.carry(_exactly(before - clock))
        balls.cross(index, 2 * half)
        clock = _exactly(before + 2 * half)
    balls.carry(_exactly(period - clock))
    if balls.mode != mode:
        raise NotProved("the motion does not come back in the smooth piece in which it began")
    return _krawczyk(balls, state, period, radius, inverse, moved)


def bits_for(digits: int) -> int:
    """Bits with which a proof to ``digits`` digits works."""
    return math.ceil(3.33 * (2.6 * digits + 20))


@contextmanager
def bits(count: int) -> Iterator[None]:
    """Balls of ``count`` bits for as long as the context lasts."""
    before = ctx.prec
    ctx.prec = count
    try:
        yield
    finally:
        ctx.prec = before


def _exactly(value: Any) -> Any:
    if not value.is_exact():
        raise NotProved("time could not be kept exactly; more bits would do it")
    return value


def _unit(size: int) -> Any:
    return arb_mat(size, size, [int(i == j) for i in range(size) for j in range(size)])


# ------------------------------------------------------------------------------ the orbit to many digits, not yet proved


def _refined(
    field: Field, constants: list[Any], state: list[Any], period: Any, mode: Mode, crossings: list[list[float]],
    inverse: list[list[Any]], moved: list[int], order: int, digits: int,
) -> tuple[list[Any], Any, list[tuple[int, Any]]]:  # fmt: skip
    """State, period and crossing times to the digits of the proof, by Newton's method with a fixed slope."""
    goal = arb(10) ** -(1.4 * digits)
    missed = arb(1)
    for _ in range(ROUNDS):
        end, times = _traced(field, constants, state, period, mode, crossings, order, digits)
        gaps = [(a - b).mid() for a, b in zip(end, state, strict=True)]
        steps = [sum((row[j] * gaps[j] for j in range(len(gaps))), arb(0)).mid() for row in inverse]
        for i, column in enumerate(moved):
            state[column] = (state[column] - steps[i]).mid()
        period = (period - steps[-1]).mid()
        before, missed = missed, max((abs(gap) for gap in gaps), key=float)
        if missed < goal or (missed > before and before < arb(10) ** -(1.15 * digits)):
            return state, period, times
    raise NotProved("Newton's method in many digits does not converge from the cycle as it is given")


def _traced(
    field: Field, constants: list[Any], state: list[Any], period: Any, mode: Mode, crossings: list[list[float]], order: int,
    digits: int,
) -> tuple[list[Any], list[tuple[int, Any]]]:  # fmt: skip
    """The end of one round to many digits, and when it crosses which border; not rigorous."""
    clock, now, times = arb(0), list(state), []
    for about, border in [*((float(t), int(i)) for t, i in crossings), (None, -1)]:
        target = period if about is None else arb(about)
        while True:
            jets = solution(field, now, constants, mode, order)
            size = max(float(abs(jet[order]).mid()) for jet in jets)
            reach = min(0.5 * (10.0 ** -(1.7 * digits) / max(size, 1e-300)) ** (1 / order), 1.0) if size > 0 else 1.0
            left = target - clock
            if float(left.mid()) <= reach:
                break
            now = [polynomial(jet, order, arb(reach)).mid() for jet in jets]
            clock = (clock + arb(reach)).mid()
        left = left.mid()
        if about is not None:
            that = field.borders[border]
            for _ in range(10):
                there = [polynomial(jet, order, left).mid() for jet in jets]
                accelerations = field.acceleration(there, constants, mode, XP)
                change = that.rate(there, accelerations, constants, mode)
                left = (left - that.level(there, constants, mode) / change).mid()
        now = [polynomial(jet, order, left).mid() for jet in jets]
        clock = (clock + left).mid()
        if about is not None:
            times.append((border, clock))
            mode = field.borders[border].beyond(mode)
    return now, times


# -------------------------------------------------------------------------------------------------- the theorem


def _krawczyk(
    balls: Balls, state: list[Any], period: Any, radius: Any, inverse: list[list[Any]], moved: list[int]
) -> dict[str, Any]:  # fmt: skip
    """Krawczyk's operator on the return after a period, in the moved parts of the start and the period."""
    field, m = balls.field, balls.field.size
    box, n = balls.box, len(balls.field.coordinates)
    around = [value + arb(0, arb(1e-6)) for value in box]
    balls.keeps_clear(around)
    accelerations = field.acceleration(around, balls.constants, balls.mode, XP)
    rates = [*around[n:], *map(arb, accelerations)]
    rows = slopes_at(field, around, balls.constants, balls.mode)
    slope = max([arb(1), *(sum((abs(arb(v)) for v in row), arb(0)) for row in rows)], key=lambda ball: float(ball.upper()))
    if not all(abs(rate) * radius < arb(1e-6) for rate in rates):
        raise NotProved("the period's ball is too wide")
    # Over the ball of the period the derivative of the flow changes by no more than this share.
    share = ((slope.abs_upper() * radius).exp() - 1).abs_upper()
    sizes = [sum((abs(balls.matrix[k, j]).abs_upper() for k in range(m)), arb(0)) for j in range(m)]
    monodromy = arb_mat(m, m, [balls.matrix[i, j] + arb(0, (share * sizes[j]).abs_upper()) for i in range(m) for j in range(m)])
    gaps = [value - begun for value, begun in zip(balls.point, state, strict=True)]
    corrections = [sum((inverse[i][k] * gaps[k] for k in range(m)), arb(0)) for i in range(m)]
    widths = []
    for i in range(m):
        row = [
            (1 if i == column else 0) - sum((inverse[i][k] * (monodromy[k, j] - int(k == j)) for k in range(m)), arb(0))
            for column, j in enumerate(moved)
        ]
        row.append((1 if i == m - 1 else 0) - sum((inverse[i][k] * rates[k] for k in range(m)), arb(0)))
        widths.append(sum((abs(value).abs_upper() for value in row), arb(0)) * radius)
    inside = [abs(c).abs_upper() + w for c, w in zip(corrections, widths, strict=True)]
    if not all(value < radius for value in inside):
        worst = max(float((value / radius).mid()) for value in inside)
        raise NotProved(f"Newton's operator does not map the box into itself: {worst:.3g} times its size")
    return _told(balls, monodromy, state, period, inside)


def _told(balls: Balls, monodromy: Any, state: list[Any], period: Any, inside: list[Any]) -> dict[str, Any]:
    m = balls.field.size
    try:
        eigenvalues = acb_mat(m, m, [monodromy[i, j] for i in range(m) for j in range(m)]).eig()
    except (ValueError, ArithmeticError):
        eigenvalues = []
    trivial = [i for i, value in enumerate(eigenvalues) if (value - 1).contains(0)]
    others = [value for i, value in enumerate(eigenvalues) if i not in trivial]
    stable = None
    if len(trivial) == 1:
        if all(abs(value) < 1 for value in others):
            stable = True
        elif any(abs(value) > 1 for value in others):
            stable = False
    error = max(inside, key=lambda ball: float(ball.mid()))
    ordered = sorted(others, key=lambda value: (-float(abs(value).mid()), -float(value.imag.mid())))
    return {
        "state": [value.str(60, radius=False) for value in state],
        "period": period.str(60, radius=False),
        "error": float(error.upper()) * (1 + 1e-12),
        "multipliers": [
            [value.real.mid().str(40, radius=False), value.imag.mid().str(40, radius=False),
             float(max(value.real.rad(), value.imag.rad(), key=float)) * (1 + 1e-9)]
            for value in [*(eigenvalues[i] for i in trivial), *ordered]
        ],
        "stable": stable,
    }  # fmt: skip


def main() -> None:
    """Read a claim, write what was proved or why not."""
    claim = json.load(sys.stdin)
    try:
        with bits(bits_for(int(claim["digits"]))):
            module, function, *given = claim["field"]
            field = getattr(importlib.import_module(module), function)(*given)
            found = {"proved": True, **proved(field, claim)}
    except (NotProved, ParameterError) as reason:
        found = {"proved": False, "reason": str(reason)}
    json.dump(found, sys.stdout)


if __name__ == "__main__":
    main()
