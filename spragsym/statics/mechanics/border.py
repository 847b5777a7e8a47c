"""Acceptance of roots of a search: on one side of the contact's border, and within one turn of angles.

A search excludes boxes that lie beyond the border; a box that meets it may hold a root on either side. So the sign of the gap is
proved at the root itself: over the box in which it is known to floats, and where that meets the border over one of many digits.
What digits do not tell from a root on the border is among the boxes that are left.
"""

from collections.abc import Callable
from contextlib import suppress
from typing import Any, Protocol

import numpy as np

from ...models.field import BEGIN, TURN
from ...numerics.balls import Ball, Undecided
from ...numerics.certified_roots import Roots
from ...numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals
from ...numerics.precise_roots import as_intervals, narrowed
from .balance import Balance
from .precise_balance import ROOT_BITS


class WithGap(Protocol):
    """A system whose roots are states of a model."""

    #: Whether the contact opens at all.
    opens: bool

    def prepared(self, bounds: Intervals) -> Intervals:
        """Parameters as the system takes them."""

    def sides(self, gap: Intervals) -> tuple[BoolArray, BoolArray]:
        """Gaps on the side of the border that is asked for or on it, and gaps beyond it."""

    def gap_over(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """The gap of the contact over boxes, shape (N,)."""


def on_its_side(system: WithGap, given: FloatArray, found: Roots, precise: Callable[[FloatArray, int], Any]) -> Roots:
    """Roots on the side of the border that was asked for; those that may lie on it among the boxes that are left.

    ``given`` are parameters, shape (parameters, points), ``precise`` makes the system with many digits at one of them.
    """
    if not system.opens:
        return found
    inside, beyond = on_side(system, _at(system, given, found.point), found.ends)
    for row in np.flatnonzero(~(inside | beyond)).tolist():
        digits = precise(given[:, found.point[row]], ROOT_BITS)
        with suppress(Undecided, ZeroDivisionError):
            root = narrowed(digits, found.ends[:, :, row], found.alone[:, :, row])
            gap = None if root is None else digits.gap(root)
            if isinstance(gap, Ball):
                inside[row : row + 1], beyond[row : row + 1] = system.sides(as_intervals([gap])[0])
    open_ = ~(inside | beyond)
    found = found.kept(inside).besides(found.ends[:, :, open_], found.point[open_])
    return found.kept(left=~on_side(system, _at(system, given, found.left_point), found.left)[1])


def on_side(system: WithGap, parameters: Intervals, ends: FloatArray) -> tuple[BoolArray, BoolArray]:
    """Boxes, shape (2, n, N), that lie on the side asked for, its border included, and boxes that lie beyond it."""
    if not system.opens:
        every = np.ones(ends.shape[2], dtype=np.bool_)
        return every, ~every
    with np.errstate(all="ignore"):
        return system.sides(system.gap_over(Intervals(ends), parameters))


def _at(system: WithGap, given: FloatArray, point: IntArray) -> Intervals:
    with np.errstate(all="ignore"):
        return system.prepared(Intervals.point(given[:, point]))


#: Where the turn ends; the search goes beyond it at both ends.
END = BEGIN + TURN


def once_around(balance: Balance, found: Roots) -> Roots:
    """Roots and boxes that are left, without those whose image after a turn is there too.

    What meets an end of the turn itself, of which this can't be said, is among the boxes that are left.
    """
    if not balance.around:
        return found
    beyond, across = _parted(found.ends, balance.around)
    hidden, _ = _parted(found.left, balance.around)
    open_ = across & ~beyond
    return found.kept(~beyond & ~across, ~hidden).besides(found.ends[:, :, open_], found.point[open_])


def _parted(ends: FloatArray, around: list[int]) -> tuple[BoolArray, BoolArray]:
    """Boxes that lie beyond the turn with one of these unknowns, and boxes that meet an end of it."""
    low, high = -ends[0, around], ends[1, around]
    beyond = np.logical_or.reduce((low > END) | (high < BEGIN))
    across = np.logical_or.reduce((low <= END) & (high >= END) | (low <= BEGIN) & (high >= BEGIN))
    return np.asarray(beyond), np.asarray(across)
