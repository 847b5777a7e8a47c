"""One state of a model along a parameter, proved: a chain of boxes, each with exactly one state for every value in it."""

from __future__ import annotations

import numpy as np

from ..exact import contractors
from ..exact.interval_arrays import FloatArray, Intervals, stacked
from ..exact.jets import gradient, variables
from .balance import Balance, matrix
from .bifurcation_conditions import Fold
from .border import on_side
from .defining_systems import Augmented

#: The first step over the whole way, and most steps.
FIRST, MOST = 2.0**-5, 400
#: Half-width of a box at least, over its size; how often it is made wider, and by how much of its width.
NARROW, INFLATIONS, ROOM = 1e-9, 6, 0.1
#: Steps of Newton's method at the end of a step.
STEPS = 6


def carried(balance: Balance, given: FloatArray, row: int, values: FloatArray, q: FloatArray) -> FloatArray | None:
    """The state at each value, shape (n, values), of the one that is ``q`` at the first; None where a step can't be proved.

    ``given`` are the parameters, shape (parameters, 1), ``row`` is the number of the one that takes the values, which go one way.
    """
    states = [q]
    for begin, end in zip(values[:-1].tolist(), values[1:].tolist(), strict=True):
        arrived = _carried(balance, given, row, begin, end, states[-1])
        if arrived is None:
            return None
        states.append(arrived)
    return np.stack(states, axis=1)


def _carried(balance: Balance, given: FloatArray, row: int, begin: float, end: float, q: FloatArray) -> FloatArray | None:
    at, step = begin, FIRST * (end - begin)
    for _ in range(MOST):
        to = end if abs(step) >= abs(end - at) else at + step
        following = _refined(balance, _prepared(balance, given, row, to, to), q)
        # Around the end itself a box as small as all boxes are at least: both that meet there hold that state.
        if _one_state(balance, given, row, (at, to), np.stack([q, following], axis=1)) and _one_state(
            balance, given, row, (to, to), np.stack([following, following], axis=1), 1
        ):
            if to == end:
                return following
            at, q, step = to, following, 2 * step
        else:
            step = 0.25 * (to - at)
    return None


def _prepared(balance: Balance, given: FloatArray, row: int, one: float, two: float) -> Intervals:
    low, high = given.copy(), given.copy()
    low[row], high[row] = min(one, two), max(one, two)
    with np.errstate(all="ignore"):
        return balance.prepared(Intervals.between(low, high))


def _refined(balance: Balance, parameters: Intervals, q: FloatArray) -> FloatArray:
    """By Newton's method."""
    with np.errstate(all="ignore"):
        for _ in range(STEPS):
            forces = balance.at_points(q[:, None], parameters).middle[:, 0]
            slopes = balance.jacobian(Intervals.point(q[:, None]), parameters).middle[:, :, 0]
            if not (np.isfinite(slopes).all() and np.isfinite(forces).all() and np.linalg.det(slopes)):
                return q
            q = q - np.linalg.solve(slopes, forces)
    return q


def _one_state(
    balance: Balance, given: FloatArray, row: int, ends: tuple[float, float], places: FloatArray, tries: int = INFLATIONS
) -> bool:
    """Whether a box that moves from one place to the other holds exactly one state, in contact, for each value on the way.

    With q = m + d (v − v_m) + u the forces are F(m, v_m) + K u + (K d + ∂F/∂v)(v − v_m), by the mean value theorem with slopes
    over the whole box; where d is near the state's own change with v, little is left of the last term.
    """
    n, one = balance.n, np.ones(1)
    half, middle = 0.5 * (ends[1] - ends[0]), 0.5 * (places[:, 0] + places[:, 1])[:, None]
    along = (places[:, 1:] - places[:, :1]) / ((ends[1] - ends[0]) or 1.0)
    least = NARROW * np.maximum(1.0, np.abs(places[:, :1]))
    system = Augmented(balance, [balance.parameters[row]], Fold())
    parameters = _prepared(balance, given, row, *ends)
    centre = 0.5 * (ends[0] + ends[1])
    away = Intervals(np.abs(half) * (1 + 2.0**-40) * np.ones((2, 1)) + np.spacing(abs(centre)))
    span = Intervals.between(np.minimum(*ends) * one, np.maximum(*ends) * one)
    reach = 2 * least
    with np.errstate(all="ignore"):
        forces = balance.at_points(middle, _prepared(balance, given, row, centre, centre))
        for _ in range(tries):
            room = np.abs(along * half) * (1 + 2.0**-40) + reach
            box = Intervals(np.stack([-(middle - room), middle + room]) + np.spacing(np.abs(middle) + room))
            at = system.state(variables([*box, span], 1), parameters, (1,))
            rows = matrix([gradient(force, n + 1) for force in at.forces()], (1,))
            slopes = Intervals(rows.ends[:, :, :n])
            left = [
                forces[i] + sum((slopes[i, j] * Intervals.point(along[j]) for j in range(n)), rows[i, n]) * away for i in range(n)
            ]
            step = contractors.newton(stacked(left, (1,)), slopes, 0.0 * middle, reach)
            if not np.isfinite(step.ends).all():
                return False
            whole = np.stack([reach, reach])
            if contractors.inside(step.ends, whole)[0]:
                return bool(on_side(balance, parameters, box.ends)[0][0])
            reach = (1 + ROOM) * np.maximum(reach, np.maximum(*np.abs(step.ends)))
    return False
