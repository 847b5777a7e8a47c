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
from ..numerics.jets import constant, gradient, variables
from ..numerics.krawczyk import Digits
from ..statics.mechanics.precise_balance import PreciseBalance, Spans, settled_by_digits, unsettled
from .defining_systems import Augmented, State

#: Boxes beyond which they lie around no points.
MANY = 400
#: Clusters of boxes that are looked at.
CLUSTERS = 12


def settled(system: Augmented, region: FloatArray, found: Roots) -> Roots:
    """What a search along one parameter in a region has left open, or knows to few digits only, again with many digits."""
    points = unsettled(found)
    if not points.size or system.condition.order or found.left.shape[2] > MANY:
        return found
    with np.errstate(all="ignore"):
        if system.given_up(Intervals(found.left), system.fixed(found.left.shape[2])).any():
            return found  # no number of digits tells what is there
    return settled_by_digits(system, system.family.begin, region, found, partial(PreciseAugmented, system), most=CLUSTERS)


class PreciseAugmented(Digits):
    """Balance and condition of balls at one point of the parameters that do not vary; ``spans`` as of the balance."""

    def __init__(self, system: Augmented, given: FloatArray, bits: int, spans: Spans = MappingProxyType({})) -> None:
        self.system, self.bits = system, bits
        self.base = PreciseBalance(system.balance, np.nan_to_num(given), bits, spans)

    def rows(self, unknowns: Sequence[Any]) -> list[Any]:
        """Forces and condition, of balls or jets of balls."""
        at = self.state(unknowns)
        return [*at.forces(), *self.system.condition.equations(at)]

    def values(self, unknowns: Sequence[Any]) -> list[Any]:
        """Values of the balance and of a condition that needs derivatives."""
        order = self.system.condition.order
        return [constant(row) for row in self.rows(variables(unknowns, order))] if order else self.rows(unknowns)

    def slopes(self, unknowns: Sequence[Any]) -> list[list[Any]]:
        """Their slopes."""
        return [gradient(row, self.system.n) for row in self.rows(variables(unknowns, self.system.condition.order + 1))]

    def gap(self, unknowns: Sequence[Any]) -> Any:
        """Gap of the contact."""
        return self.state(unknowns).gap()

    def state(self, unknowns: Sequence[Any]) -> State:
        """The evaluation at balls or jets of balls."""
        n, balance = self.system.balance.n, self.system.balance
        changed = dict(zip(self.system.family.vary, unknowns[n:], strict=True))
        values = self.base.arguments | balance.with_angles(changed, XP)
        return State(balance, unknowns[:n], values, (), xp=XP)
