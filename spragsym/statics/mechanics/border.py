"""On which side of the contact's border a root lies: the one place where roots of a search are accepted, whatever they are of.

A search excludes boxes that lie beyond the border; a box that meets it may hold a root on either side. So the sign of the gap is
proved at the root itself: over the box in which it is known to floats, and where that meets the border over one of many digits.
What digits do not tell from a root on the border is among the boxes that are left.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from ...numerics.boxes import System
from ...numerics.certified_roots import Roots
from ...numerics.interval_arrays import FloatArray, Intervals
from ...numerics.intervals import Ball
from ...numerics.krawczyk import Digits, as_intervals, narrowed
from ...numerics.polynomials import Undecided

#: Bits of a root where floats do not tell the sign of its gap.
BITS = 256


class WithGap(System, Protocol):
    """A system whose roots are states of a model."""

    #: Whether the contact opens at all.
    opens: bool

    def sides(self, gap: Intervals) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Gaps on the side of the border that is asked for or on it, and gaps beyond it."""

    def gap_over(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """The gap of the contact over boxes, shape (N,)."""


class DigitsWithGap(Digits, Protocol):
    """The same of balls, at one point."""

    def gap(self, unknowns: Any) -> Any:
        """The gap of the contact."""


def on_its_side(system: WithGap, given: FloatArray, found: Roots, precise: Callable[[FloatArray], DigitsWithGap]) -> Roots:
    """Roots on the side of the border that was asked for; those that may lie on it among the boxes that are left.

    Parameters
    ----------
    given : ndarray
        Parameters, shape (parameters, points).
    precise : callable
        The system with many digits at a point of parameters.
    """
    if not system.opens:
        return found
    inside, beyond = on_side(system, _at(system, given, found.point), found.ends)
    for row in np.flatnonzero(~(inside | beyond)).tolist():
        gap = _gap(precise(given[:, found.point[row]]), found.ends[:, :, row], found.alone[:, :, row])
        if gap is not None:
            inside[row : row + 1], beyond[row : row + 1] = system.sides(gap)
    open_ = ~(inside | beyond)
    left = np.concatenate([found.left, found.ends[:, :, open_]], axis=2)
    left_point = np.concatenate([found.left_point, found.point[open_]])
    possible = ~on_side(system, _at(system, given, left_point), left)[1]
    return replace(
        found, ends=found.ends[:, :, inside], alone=found.alone[:, :, inside], point=found.point[inside],
        left=left[:, :, possible], left_point=left_point[possible],
    )  # fmt: skip


def on_side(system: WithGap, parameters: Intervals, ends: FloatArray) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Boxes, shape (2, n, N), that lie on the side asked for, its border included, and boxes that lie beyond it."""
    if not system.opens:
        every = np.ones(ends.shape[2], dtype=np.bool_)
        return every, ~every
    with np.errstate(all="ignore"):
        return system.sides(system.gap_over(Intervals(ends), parameters))


def _at(system: WithGap, given: FloatArray, point: NDArray[np.int64]) -> Intervals:
    with np.errstate(all="ignore"):
        return system.prepared(Intervals.point(given[:, point]))


def _gap(precise: DigitsWithGap, box: FloatArray, alone: FloatArray) -> Intervals | None:
    """The gap at a root, of many digits before it is rounded outward; None where the root is not known to as many."""
    try:
        root = narrowed(precise, box, alone)
        gap = None if root is None else precise.gap(root)
    except (Undecided, ZeroDivisionError):
        return None
    return as_intervals([gap])[0] if isinstance(gap, Ball) else None
