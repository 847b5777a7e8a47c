"""Defining systems of folds, cusps and onsets: coordinates and parameters are unknowns together.

The forces vanish, and as many conditions hold as there are parameters: det K = 0 with one parameter is a fold; with two, and
with no change of det K along the direction that K maps to 0, a cusp. Derivatives come from jets over intervals. Where two points
lie so near to each other that float64 does not tell them apart, the same is evaluated in balls.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from types import MappingProxyType
from typing import Any

import numpy as np

from ..numerics.balls import XP as BALLS
from ..numerics.boxes import POLE, System
from ..numerics.certified_roots import Roots
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals, Shape, matrix, stacked
from ..numerics.jets import constant, gradient, variables
from ..numerics.precise_roots import Digits
from ..statics.mechanics.laws import XP
from ..statics.mechanics.precise_balance import PreciseBalance, Spans, boxes_of, settled_by_digits
from ..statics.mechanics.state import State
from .families import Family
from .near_anchors import regular_at_anchors


@dataclass(frozen=True)
class Condition:
    """What is asked of a state beside the balance.

    ``equations`` are the values that must vanish, one for each unknown parameter; jets carry ``order`` more derivatives.
    ``singular`` and ``touching``: one of them is det K = 0, or that the gap of the contact is 0. ``hopeless`` are boxes in which
    an inequality that is asked for can't hold, ``given_up`` those that halving would never decide.
    """

    equations: Callable[[State], Sequence[Any]]
    order: int = 0
    singular: bool = False
    touching: bool = False
    hopeless: Callable[[State], BoolArray] | None = None
    given_up: Callable[[State], BoolArray] | None = None


class Augmented(System):
    """Balance and condition; unknowns are the coordinates, then the parameters that vary."""

    def __init__(self, family: Family, condition: Condition) -> None:
        self.family, self.balance, self.condition = family, family.balance, condition
        self.n = self.balance.n + len(family.vary)
        self.opens, self.sides = self.balance.opens, self.balance.sides

    def prepared(self, bounds: Intervals) -> Intervals:
        """Prepared parameters of the balance; an unknown is replaced at each evaluation."""
        return self.balance.prepared(bounds)

    def fixed(self, count: int) -> Intervals:
        """Prepared parameters of so many boxes at one point of the parameters that do not vary."""
        with np.errstate(all="ignore"):
            return self.prepared(Intervals.point(np.repeat(self.family.begin, count, axis=1)))

    def state(self, unknowns: Sequence[Any], parameters: Intervals, shape: Shape, sides: Sequence[int] | None = None) -> State:
        """The evaluation at intervals or jets of them."""
        return self.evaluated(unknowns, self.balance.arguments(parameters), shape, sides=sides)

    def evaluated(
        self, unknowns: Sequence[Any], fixed: Mapping[str, Any], shape: Shape, xp: Any = XP,
        sides: Sequence[int] | None = None,
    ) -> State:  # fmt: skip
        """The evaluation at unknowns of any number type, from arguments of which those that vary are replaced."""
        n = self.balance.n
        changed = dict(zip(self.family.vary, unknowns[n:], strict=True))
        values = {**fixed, **self.balance.with_angles(changed, xp)}
        return State(self.balance, unknowns[:n], values, shape, xp=xp, sides=sides)

    def gap_over(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """The gap of the contact over boxes, shape (N,)."""
        shape = unknowns.shape[1:]
        return stacked([self.state(list(unknowns), parameters, shape).gap()], shape)[0]

    def residuals(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Forces and condition over boxes."""
        return self._values(unknowns, parameters, self.balance.anywhere)

    def _values(self, unknowns: Intervals, parameters: Intervals, sides: Sequence[int]) -> Intervals:
        """Values of the system on either side of the rays where torsion angles jump."""
        shape = unknowns.shape[1:]
        at = self.state(list(unknowns), parameters, shape, sides)
        extra = at
        if self.condition.order:
            # Derivatives that the condition itself is made of.
            extra = self.state(variables(list(unknowns), self.condition.order), parameters, shape, sides)
        values = [*at.forces(), *self.condition.equations(extra)]
        return stacked([constant(value) for value in values], shape)

    def jacobian(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Their slopes by coordinates and parameters."""
        shape = unknowns.shape[1:]
        at = self.state(variables(list(unknowns), self.condition.order + 1), parameters, shape)
        # By the coordinates the stiffness itself, which is sharper, and finite where a law like Hertz's begins.
        n = self.balance.n
        rows = [
            [constant(entry) for entry in row] + gradient(force, self.n)[n:]
            for row, force in zip(at.slopes(), at.forces(), strict=True)
        ]
        return matrix(rows + [gradient(value, self.n) for value in self.condition.equations(at)], shape)

    def hopeless(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """Boxes beyond the contact's border, or without what the condition asks for."""
        shape = unknowns.shape[1:]
        at = self.state(list(unknowns), parameters, shape)
        out: BoolArray = self.balance.nothing_at(at.q, at.values, shape)
        out = out if self.condition.hopeless is None else out | self.condition.hopeless(at)
        if self.condition.singular:
            out = out | regular_at_anchors(self.balance, at.q, at.values, ~out)

        def no_root(rows: IntArray, sides: Sequence[int]) -> BoolArray:
            values = self._values(unknowns[:, rows], parameters[:, rows], sides)
            return ~np.logical_and.reduce(values.holds_zero())

        return out | self.balance.beside_jumps(at.q, at.values, ~out, no_root)

    def given_up(self, unknowns: Intervals, parameters: Intervals, width: float = POLE) -> BoolArray:
        """Boxes that the balance gives up, and those that the condition gives up."""
        at = self.state(list(unknowns), parameters, unknowns.shape[1:])
        poles: BoolArray = self.balance.at_poles(at.q, at.values, at.shape, width)
        return poles if self.condition.given_up is None else poles | self.condition.given_up(at)

    def contracted(self, unknowns: Intervals, parameters: Intervals) -> FloatArray:
        """The coordinates contracted by the balance over the box of parameters."""
        n, shape = self.balance.n, unknowns.shape[1:]
        at = self.state(list(unknowns), parameters, shape, self.balance.anywhere)
        ends = self.balance.with_directions(unknowns[:n], at.values, at.directions)
        return np.concatenate([ends, unknowns.ends[:, n:]], axis=1)


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
        """Residuals of the balance of forces and of the bifurcation condition."""
        at = self.state(unknowns)
        return [*at.forces(), *self.system.condition.equations(at)]

    def gap(self, unknowns: Sequence[Any]) -> Any:
        """Gap of the contact."""
        return self.state(unknowns).gap()

    def state(self, unknowns: Sequence[Any]) -> State:
        """The evaluation at balls or jets of balls."""
        return self.system.evaluated(unknowns, self.arguments, (), BALLS)
