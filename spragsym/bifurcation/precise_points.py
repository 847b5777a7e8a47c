"""Folds and onsets with many digits: where two of them lie so near to each other that float64 does not tell them apart.

Near a cusp two folds meet, and where a curve of folds only touches the line of the parameter that varies they do too. There the
forces and the condition, as one system in coordinates and parameter, are nearly singular, and :mod:`spragsym.numerics.reduction`
brings them down to one unknown.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from types import MappingProxyType
from typing import Any

import numpy as np

from ..numerics.ball_functions import XP
from ..numerics.certified_roots import Roots
from ..numerics.interval_arrays import FloatArray, Intervals
from ..numerics.krawczyk import Digits
from ..statics.mechanics.precise_balance import PreciseBalance, Spans, boxes_of, settled_by_digits
from ..statics.mechanics.state import State
from .defining_systems import Augmented

#: Boxes beyond which they lie around no points.
MANY = 400
#: Clusters of boxes that are looked at.
CLUSTERS = 12


def settled(system: Augmented, region: FloatArray, found: Roots) -> Roots:
    """What a search along one parameter in a region has left open, or knows to few digits only, again with many digits."""
    if not boxes_of(found)[1].size or system.condition.order or found.left.shape[2] > MANY:
        return found
    with np.errstate(all="ignore"):
        if system.given_up(Intervals(found.left), system.fixed(found.left.shape[2])).any():
            return found  # no number of digits tells what is there
    return settled_by_digits(system, system.family.begin, region, found, partial(PreciseAugmented, system), most=CLUSTERS)


class PreciseAugmented(Digits):
    """Balance and condition of balls at one point of the parameters that do not vary; ``spans`` as of the balance."""

    def __init__(self, system: Augmented, given: FloatArray, bits: int, spans: Spans = MappingProxyType({})) -> None:
        self.system, self.bits, self.order = system, bits, system.condition.order
        self.arguments = PreciseBalance(system.balance, np.nan_to_num(given), bits, spans).arguments

    def equations(self, unknowns: Sequence[Any]) -> Sequence[Any]:
        """Forces and condition."""
        at = self.state(unknowns)
        return [*at.forces(), *self.system.condition.equations(at)]

    def gap(self, unknowns: Sequence[Any]) -> Any:
        """Gap of the contact."""
        return self.state(unknowns).gap()

    def state(self, unknowns: Sequence[Any]) -> State:
        """The evaluation at balls or jets of balls."""
        return self.system.evaluated(unknowns, self.arguments, (), XP)
