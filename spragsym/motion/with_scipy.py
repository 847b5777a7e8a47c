"""SciPy's DOP853, restarted at every crossing into another mode of the field."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np

from ..errors import ConvergenceError
from ..models.field import GAP, Field, Mode
from ..models.parameters import FloatArray
from .lobatto import unit_points
from .problem import Problem, event_at, initial_mode, out_of_range, too_many_steps
from .solution import Crossing, Solution, assembled

# The continuation of a mode grows without bound far outside it. Trial steps that go there are rejected
# in any case: the number must only be finite.
FLOATS = SimpleNamespace(**{**vars(math), "exp": lambda z: math.exp(min(z, 100.0))})
ARRAYS = SimpleNamespace(
    sqrt=np.sqrt, exp=lambda z: np.exp(np.minimum(z, 100.0)), log=np.log, tanh=np.tanh, atan=np.atan, atan2=np.atan2,
    cos=np.cos, sin=np.sin, pi=np.pi,
)  # fmt: skip

#: Each step is searched for crossings on this many intervals, and between them at extrema.
_SEARCH = np.linspace(0.0, 1.0, 9)


def integrate(problem: Problem) -> Solution:
    """Integrate a problem from 0 to ``t_end`` and keep what follows ``t_record``."""
    with np.errstate(all="ignore"):  # trial steps may go as far as numbers do not, and are rejected
        return _integrated(problem)


def _integrated(problem: Problem) -> Solution:
    from scipy.integrate import DOP853

    unit = unit_points()
    mode, state, clock, first_step = initial_mode(problem), np.array(problem.start), 0.0, None
    times: list[FloatArray] = []
    states: list[FloatArray] = []
    crossings: list[Crossing] = []
    steps = 0
    if not np.isfinite(_field(problem, mode)(0.0, state)).all():
        raise out_of_range()

    def points(begin: float, end: float) -> FloatArray:
        """Times of the samples of a step, none before ``t_record``."""
        begin = max(begin, problem.t_record - clock)
        if end <= begin:
            return np.empty(0)
        local = begin + unit * (end - begin)
        local[-1] = end
        return local

    while clock < problem.t_end:
        # Time runs from 0 in every mode: the closer to the crossing, the more digits it has.
        bound = problem.t_end - clock
        solver = DOP853(
            _field(problem, mode), 0.0, state, bound, rtol=problem.rtol, atol=problem.rtol * 1e-3,
            first_step=None if first_step is None else min(first_step, bound),
        )  # fmt: skip
        crossing = None
        while solver.status == "running" and crossing is None:
            message = solver.step()
            if solver.status == "failed":
                raise ConvergenceError(f"SciPy's DOP853 stopped at t = {clock + solver.t:.6g}: {message}; use a larger rtol")
            steps += 1
            if steps > problem.max_steps:
                raise too_many_steps(problem, clock + solver.t)
            if not np.isfinite(solver.y).all():
                raise out_of_range()
            dense, begin, end = solver.dense_output(), solver.t_old, solver.t
            local = points(begin, end)
            # What is searched and what is kept in one call: a call costs more than its numbers.
            searched, kept = np.split(dense(np.concatenate([_grid(begin, end), local])), [len(_SEARCH)], axis=1)
            crossing = first_crossing(problem.field, problem.constants, mode, dense, begin, end, searched)
            if crossing is not None:
                local = points(begin, crossing[0])
                kept = dense(local)
            if len(local):
                times.append(clock + local)
                states.append(kept)
        if crossing is None:
            break
        end, row = crossing
        first_step, state, clock = solver.step_size, dense(end), clock + end
        border = problem.field.borders[row]
        mode, kind = border.beyond(mode), event_at(border, upward=border.sign(mode) < 0)
        if kind is not None:
            crossings.append(Crossing(clock, tuple(state.tolist()), kind))
    return assembled(np.array(times), np.array(states), crossings, problem.t_record)


def first_step(problem: Problem, mode: Mode) -> float:
    """The length of the first step, as SciPy chooses it."""
    from scipy.integrate import DOP853

    solver = DOP853(
        _field(problem, mode), 0.0, np.array(problem.start), problem.t_end, rtol=problem.rtol, atol=problem.rtol * 1e-3
    )
    return float(solver.h_abs)


def _field(problem: Problem, mode: Mode) -> Callable[[float, FloatArray], tuple[float, ...]]:
    n, constants, acceleration = len(problem.field.coordinates), problem.constants, problem.field.acceleration

    def field(_: float, state: FloatArray) -> tuple[float, ...]:
        values = state.tolist()
        return (*values[n:], *acceleration(values, constants, mode, FLOATS))

    return field


def clearances(field: Field, constants: tuple[float, ...], mode: Mode, states: FloatArray) -> FloatArray:
    """Distance from the borders of a mode, negative beyond them, and its rate: shape (borders, 2, …)."""
    accelerations = field.acceleration(states, constants, mode, ARRAYS)
    found = np.empty((len(field.borders), 2, *states.shape[1:]))
    for row, border in zip(found, field.borders, strict=True):
        sign = border.sign(mode)
        row[0] = sign * border.level(states, constants, mode) + GAP * border.kink
        row[1] = sign * border.rate(states, accelerations, constants, mode)
    return found


def _grid(begin: float, end: float) -> FloatArray:
    """Where a step is searched."""
    return begin + _SEARCH * (end - begin)


def first_crossing(
    field: Field, constants: tuple[float, ...], mode: Mode, dense: Callable[[Any], FloatArray], begin: float, end: float,
    searched: FloatArray | None = None,
) -> tuple[float, int] | None:  # fmt: skip
    """When, within a step, the motion first leaves its mode, and through which border.

    ``searched`` are the states at the points of the search, where they are known.
    """

    def border(row: int, t: Any) -> FloatArray:
        """Distance from one of the borders, and its rate."""
        distance_and_rate: FloatArray = clearances(field, constants, mode, dense(np.asarray(t)))[row]
        return distance_and_rate

    grid = _grid(begin, end)
    found = []
    for row, (distance, rate) in enumerate(clearances(field, constants, mode, dense(grid) if searched is None else searched)):
        at = partial(border, row)
        bracket = _bracket(grid, distance, rate, at)
        if bracket is not None:
            found.append((_root(at, 0, *bracket), row))
    return min(found, default=None)


def _bracket(
    grid: FloatArray, value: FloatArray, rate: FloatArray, both: Callable[[float], FloatArray]
) -> tuple[float, float] | None:
    """The first interval where ``value`` goes from not negative to negative, dips between points included."""
    if value.min() > np.abs(rate).max() * (grid[1] - grid[0]):
        return None
    for i in range(len(grid) - 1):
        if value[i + 1] < 0:
            return float(grid[i]), float(grid[i + 1])
        if rate[i] < 0 < rate[i + 1]:
            lowest = _root(both, 1, float(grid[i]), float(grid[i + 1]))
            if both(lowest)[0] < 0:
                return float(grid[i]), lowest
    return None


def _root(border: Callable[[float], FloatArray], part: int, begin: float, end: float) -> float:
    """Where the distance from a border (part 0) or its rate (part 1) changes sign."""
    from scipy.optimize import brentq

    def function(t: float) -> float:
        return float(border(t)[part])

    if function(begin) * function(end) > 0:
        return begin  # the motion begins beyond the border, by rounding: it is left at once
    return float(brentq(function, begin, end, xtol=1e-15, rtol=8.9e-16))
