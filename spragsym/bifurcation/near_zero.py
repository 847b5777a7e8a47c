"""Points near the end 0 of a parameter that is larger than 0, where all states are degenerate at 0 or a law has no value.

At σ = 0 nothing may hold the mass along the belt, and at v_s = 0 Stribeck's law would jump: in a box that reaches down to 0 no
search decides anything. In the logarithm of the parameter all of its sizes are alike, and each is decided on its own, down to
:data:`LEAST`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ..numerics import certified_roots
from ..numerics.certified_roots import Roots, concatenated, distinct
from ..numerics.interval_arrays import FloatArray, Intervals
from ..statics.mechanics.laws import XP
from ..statics.mechanics.state import State
from .defining_systems import Augmented
from .degenerate_ends import vanishes

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
