"""Ends of a range at which all states are degenerate, or a law has no value: what a search leaves undecided there, and beside it.

Without the inclined spring, σ = 0, the two directions of the article's model do not feel each other, and the one across the belt
is not damped. So all states at that end are on the border of stability, and none of them is an onset that a parameter passes.

In a box that reaches down to such an end at 0 no search decides anything. In the logarithm of a parameter that is larger than 0
all of its sizes are alike, and each is decided on its own, down to :data:`LEAST`.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ..numerics import boxes, certified_roots, contractors
from ..numerics.certified_roots import Roots, concatenated, distinct, stepped
from ..numerics.interval_arrays import BoolArray, FloatArray, Intervals, stacked
from ..statics.mechanics.balance import NOTHING
from ..statics.mechanics.laws import XP
from ..statics.mechanics.state import State
from .defining_systems import Augmented

#: How much wider than a box the one is in which a root is proved to be the only one, relatively and absolutely.
WIDER, ROOM = 0.25, 1e-11


def shared(system: Augmented, left: FloatArray) -> BoolArray:
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


def vanishes(system: Augmented, end: float, ends: FloatArray) -> BoolArray:
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
    return np.logical_and.reduce(values.magnitude <= NOTHING)


def _at_end(system: Augmented, end: float, count: int) -> Intervals:
    """Prepared parameters with this value of the one that varies."""
    return system.prepared(Intervals.point(system.family.at(np.full((1, count), end))))


def _one_root(system: boxes.System, parameters: Intervals, wide: FloatArray) -> BoolArray:
    """Boxes with exactly one root."""
    return contractors.inside(stepped(system, wide, parameters).ends, wide)


#: Where the range of such a parameter begins.
LEAST = 2.0**-300
#: Up to which value the logarithm is taken, and from which on the parameter itself; between them both are.
HIGH, LOW = 2.0**-9, 2.0**-10
#: Boxes looked at.
BUDGET = 100_000


class Logarithmic(Augmented):
    """A defining system with the logarithm of its parameter as unknown."""

    def evaluated(self, unknowns: Sequence[Any], *given: Any, **more: Any) -> State:
        """The evaluation at coordinates and logarithm."""
        return super().evaluated([*unknowns[:-1], XP.exp(unknowns[-1])], *given, **more)


def begins(system: Augmented, around: FloatArray) -> bool:
    """Whether the range of the parameter in the region ``around`` begins at 0, which it never is, and nothing is known there."""
    (vary,) = system.family.vary
    (entry,) = [entry for entry in system.balance.model.about["parameters"] if entry["name"] == vary]
    if entry["low"] != 0 or not entry["low_open"] or around[0, -1, 0] != 0 or around[1, -1, 0] <= HIGH:
        return False
    return vary not in system.balance.angles and (bool(vanishes(system, 0.0, around)[0]) or not _bounded(system, around))


def _bounded(system: Augmented, around: FloatArray) -> bool:
    """Whether the condition has bounds in the whole region but for large values of the parameter."""
    low = np.concatenate([around[:, :-1], np.array([[[0.0]], [[LOW]]])], axis=1)
    with np.errstate(all="ignore"):
        fixed = system.prepared(Intervals.point(system.family.at(np.array([[LOW]]))))
        return bool(np.isfinite(system.residuals(Intervals(low), fixed).ends[:, -1]).all())


def searched(system: Augmented, around: FloatArray, limits: FloatArray) -> Roots:
    """All roots with a parameter from :data:`LEAST` to :data:`HIGH`, as boxes of the parameter itself."""
    by_logarithm, given = Logarithmic(system.family, system.condition), system.family.begin
    ends = np.concatenate([around[:, :-1], [[[-np.log(LEAST)]], [[np.log(HIGH)]]]], axis=1)
    found = certified_roots.search(by_logarithm, ends, given, given, limits=limits, budget=BUDGET)
    return replace(found, ends=_raised(found.ends), alone=_raised(found.alone), left=_raised(found.left))


def joined(one: Roots, other: Roots) -> Roots:
    """Roots of the search near 0 and of that from :data:`LOW` on, each once.

    What the one leaves in the range of the other is decided there.
    """
    parts = [one.kept(left=-one.left[0, -1] <= LOW), other.kept(left=other.left[1, -1] >= HIGH)]
    return distinct(concatenated(parts, one.ends.shape[1]))


def _raised(ends: FloatArray) -> FloatArray:
    """Boxes of the parameter from boxes of its logarithm."""
    with np.errstate(all="ignore"):
        return np.concatenate([ends[:, :-1], Intervals(ends[:, -1:]).exp().ends], axis=1)
