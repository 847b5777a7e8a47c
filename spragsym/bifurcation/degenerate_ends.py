"""Ends of a range at which all states are degenerate: what a search over boxes leaves undecided there, and why.

Without the inclined spring, σ = 0, the two directions of the article's model do not feel each other, and the one across the belt
is not damped. So all states at that end are on the border of stability, and none of them is an onset that a parameter passes.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..numerics import boxes, contractors
from ..numerics.certified_roots import stepped
from ..numerics.interval_arrays import FloatArray, Intervals, stacked
from ..statics.mechanics.balance import NOTHING
from .defining_systems import Augmented

#: How much wider than a box the one is in which a root is proved to be the only one, relatively and absolutely.
WIDER, ROOM = 0.25, 1e-11


def shared(system: Augmented, left: FloatArray) -> NDArray[np.bool_]:
    """Boxes of coordinates and parameter whose only root is proved to be at an end of the range where all states are roots.

    ``system`` is along one parameter, with a condition of order 0; ``left`` has the shape (2, n + 1, N).
    """
    out = np.zeros(left.shape[2], dtype=np.bool_)
    if system.condition.order or not out.size:
        return out
    wide = left + (WIDER * (left[0] + left[1]) + ROOM * np.maximum(1.0, np.abs(left).max(axis=0)))
    with np.errstate(all="ignore"):
        alone = _one_root(system, system.fixed(out.size), wide)
        for end in system.family.spans[0]:
            here = (-left[0, -1] <= end) & (end <= left[1, -1])
            states = _one_root(system.balance, _at_end(system, end, out.size), wide[:, :-1])
            out |= here & alone & states & vanishes(system, end, wide)
    return out


def vanishes(system: Augmented, end: float, ends: FloatArray) -> NDArray[np.bool_]:
    """Boxes over whose coordinates the condition is 0 everywhere at this value of the parameter."""
    count, (vary,) = ends.shape[2], system.family.vary
    # 0 as the number, unless it is an angle.
    exactly = end == 0 and vary not in system.balance.angles
    value: Any = 0 if exactly else Intervals.point(np.full(count, end))
    try:
        with np.errstate(all="ignore"):
            at = system.state([*Intervals(ends[:, :-1]), value], _at_end(system, end, count), (count,))
            values = stacked(system.condition.equations(at), (count,))
    except ZeroDivisionError:  # a law that has no value there
        return np.zeros(count, dtype=np.bool_)
    out: NDArray[np.bool_] = np.logical_and.reduce(values.magnitude <= NOTHING)
    return out


def _at_end(system: Augmented, end: float, count: int) -> Intervals:
    """Prepared parameters with this value of the one that varies."""
    return system.prepared(Intervals.point(system.family.at(np.full((1, count), end))))


def _one_root(system: boxes.System, parameters: Intervals, wide: FloatArray) -> NDArray[np.bool_]:
    """Boxes with exactly one root."""
    return contractors.inside(stepped(system, wide, parameters).ends, wide)
