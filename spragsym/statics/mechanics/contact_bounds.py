"""Bounds of coordinates from the contact's force, where the gap is an expression: no state in contact has a negative depth.

Over a wide box the gap has both signs, and a law that hardens makes a large negative force of depths that no state in contact
has. Here the depth is cut off at 0, and the contact's force is a number of its own beside the forces of lift-off. So no slope is
needed of what is cut off, which has none at the border.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...numerics import contractors, jets
from ...numerics.interval_arrays import FloatArray, Intervals, stacked
from .balance import Balance
from .forces import Values
from .laws import FREE


class _Pressed:
    """``pushing`` = 1 in generated functions, whose depth (1 − pushing)² TOUCH − pushing · gap is then cut off at 0."""

    def __mul__(self, other: Any) -> Any:
        return other

    __rmul__ = __mul__

    def __rsub__(self, one: int) -> _Nothing:
        return _Nothing()


class _Nothing:
    """1 − pushing and multiples of its square: 0, which cuts off at 0 what it is added to."""

    def __mul__(self, other: Any) -> _Nothing:
        return self

    def __truediv__(self, other: int) -> _Nothing:
        return self

    def __add__(self, depth: Intervals) -> Intervals:
        return _cut_off(depth)

    def __sub__(self, gap: Intervals) -> Intervals:
        return self + -gap

    __radd__ = __add__


def _cut_off(value: Intervals) -> Intervals:
    """What is below 0 moved to 0: 0 alone of what lies below as a whole."""
    return Intervals(np.stack([np.minimum(value.ends[0], 0.0), np.maximum(value.ends[1], 0.0)]))


def applies(balance: Balance) -> bool:
    """Whether the contact opens, its gap is an expression, and no state beyond the border counts."""
    return (
        balance.contact
        and balance.opens
        and not balance.room
        and balance.model.about["contact"]["gap"] not in balance.coordinates
    )


def by_contact_force(balance: Balance, ends: FloatArray, values: Values, directions: Sequence[Any]) -> FloatArray:
    """Smaller boxes with the same states in contact: each coordinate from its row, with cosines and sines left free."""
    ends = _closed(balance, ends, values)
    unknowns = Intervals(ends)
    near, shape = unknowns.nearest_to_zero, unknowns.shape[1:]
    force = _cut_off(stacked([balance.contact_force(list(unknowns), values, _Pressed(), FREE)], shape)[0])
    # Slopes by pushing, where that is 0: the force of a touch, and what of it goes along each coordinate.
    pushing = jets.Jet.variable(Intervals(np.zeros((2, *shape))), 0, 1)
    of_touch = balance.by_coordinate("forces", list(unknowns), directions, values, FREE, pushing=pushing)
    touch = jets.gradient(balance.contact_force(list(unknowns), values, pushing, FREE), 1)[0]
    along = stacked([jets.gradient(row, 1)[0] / touch for row in of_touch], shape)
    apart = stacked(balance.by_coordinate("forces", list(unknowns), directions, values, FREE, pushing=0), shape)
    force = _balancing(force, apart, along)
    at_near, slopes, near, reach = balance.linear(
        unknowns, near, lambda q: balance.by_coordinate("forces", q, directions, values, FREE, pushing=0)
    )
    given = at_near + along * force, slopes, near, reach
    found: FloatArray = np.fmin(contractors.by_rows(*given), contractors.newton(*given).ends)
    return np.fmin(found, ends)


def _closed(balance: Balance, ends: FloatArray, values: Values) -> FloatArray:
    """Smaller boxes with all points of a gap ≤ 0: each coordinate from the gap's slopes by it and the others."""
    unknowns = Intervals(ends)
    near, shape = unknowns.nearest_to_zero, unknowns.shape[1:]
    at_near = stacked([balance.gap(list(Intervals.point(near)), values, FREE)], shape)[0]
    slopes = stacked(jets.gradient(balance.gap(jets.variables(list(unknowns), 1), values, FREE), balance.n), shape)
    shift = unknowns - Intervals.point(near)
    found = ends.copy()
    for place in range(balance.n):
        others = sum((slopes[j] * shift[j] for j in range(balance.n) if j != place), at_near)
        most = Intervals.point(near[place]) - others / slopes[place]
        upper = slopes.ends[0, place] < 0
        lower = slopes.ends[1, place] < 0
        found[1, place] = np.where(upper, np.fmin(ends[1, place], most.ends[1]), ends[1, place])
        found[0, place] = np.where(lower, np.fmin(ends[0, place], most.ends[0]), ends[0, place])
    return np.where(found[0] + found[1] >= 0, found, ends)


def _balancing(force: Intervals, apart: Intervals, along: Intervals) -> Intervals:
    """What is left of the contact's force where it balances the others in each row that it has a known direction in."""
    ends = force.ends
    for row in range(apart.shape[0]):
        other = (-apart[row] / along[row]).ends
        both = np.fmin(ends, other)
        ends = np.where(both[0] + both[1] >= 0, both, ends)
    return Intervals(ends)
