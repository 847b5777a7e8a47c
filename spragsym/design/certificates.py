"""Certificates of claims about every point of a box of parameters: proved, refuted by a point, or
undecided.

The box is halved into parts (branch and bound). Claims about all states in contact, of any model,
are decided by a search for equilibria over a part, as over one point, see
:mod:`spragsym.numerics.boxes`: a box of coordinates in which interval Newton proves one root holds
one state for every point of the part. The claim is decided over these boxes and the undecided ones.
A part that stays open is halved across the parameter that moves the states most; the states of its
halves lie in the boxes of its own.
"""

from __future__ import annotations

import itertools
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import IntEnum
from functools import partial
from types import MappingProxyType
from typing import Any, ClassVar, Self, TypeAlias

import numpy as np

from ..bifurcation.tubes import halves
from ..core.errors import ParameterError
from ..core.progress import doing
from ..models.parameters import ParameterSet
from ..models.quantities import Unit
from ..numerics import certified_roots
from ..numerics.certified_roots import Roots
from ..numerics.columns import ByColumn
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    IntArray,
    Intervals,
    hulls_of,
    quiet,
    rounded_outward,
    scale_of,
    width_of,
)
from ..results import Equilibria, EquilibriumType, Result
from ..statics import stability
from ..statics.balance import Balance
from ..statics.equilibria import equilibria
from ..statics.precise_balance import on_side, reduced_by_turns
from ..statics.regions import region
from ..statics.search import balances_of


class Decision(IntEnum):
    """What is known of a claim over a part of a box."""

    REFUTED = -1
    OPEN = 0
    PROVED = 1


@dataclass(frozen=True)
class Certificate(Result):
    """Certificate of a claim over a box of parameters: proved, refuted or undecided.

    Attributes
    ----------
    claim : str
        As given.
    outcome : str
        ``"proved"``, ``"refuted"`` or ``"undecided"``.
    counterexample : Parameters, mapping of str to float, or None
        A point of the box at which the claim is false, if it is refuted; of a
        :class:`spragsym.Study` its quantities in SI.
    undecided : float
        Share of the volume of the box that is neither proved nor known to hold a counterexample.
    boxes : int
        Boxes that were looked at.
    """

    claim: str
    outcome: str
    counterexample: Any
    undecided: float
    boxes: int


@dataclass(frozen=True)
class BoxParts(ByColumn, ABC):
    """Parts of a box, one in each column, by their ends of shape (sides, N)."""

    #: So many parts take no longer to decide than fewer.
    few: ClassVar[int] = 0

    low: FloatArray
    high: FloatArray

    def __len__(self) -> int:
        return int(self.low.shape[1])

    @property
    @abstractmethod
    def outcome(self) -> IntArray:
        """The :class:`Decision` for each part: proved or refuted for all of it, or open."""

    @property
    def volume(self) -> FloatArray:
        """Volume of each part, over the sides that have a width."""
        width = self.high - self.low
        return width.prod(axis=0, where=width > 0)

    @property
    def open_volume(self) -> FloatArray:
        """The volume of each open part, 0 for others."""
        return np.where(self.outcome == Decision.OPEN, self.volume, 0.0)

    @property
    def slight(self) -> FloatArray:
        """A small weight of each side by its relative width, which decides where states give no
        weight.
        """
        return (
            1e-6 * (self.high - self.low) / np.maximum(np.abs(self.high) + np.abs(self.low), 1e-300)
        )

    def divisible(self) -> BoolArray:
        """Mask of the sides with floats between their ends."""
        return np.nextafter(self.low, np.inf) < self.high

    def divided(self, weight: FloatArray, most: int) -> Self:
        """The parts, each halved across the side of largest ``weight``.

        Fewer parts than :attr:`few` are halved again, up to ``most`` parts.
        """
        parts, weight = self._halved(weight)
        while (
            0 < len(parts) < self.few
            and 2 * len(parts) <= most
            and parts.divisible().any(axis=0).all()
        ):
            parts, weight = parts._halved(weight)
        return parts

    def _halved(self, weight: FloatArray) -> tuple[Self, FloatArray]:
        """Both halves of each part, and their weights: half of it for the side that was cut."""
        side, high, low = halves(self.low, self.high, weight)
        weight = weight.copy()
        weight[side, np.arange(side.size)] *= 0.5
        parts = replace(self, high=high).concatenated(replace(self, low=low))
        return parts, np.concatenate([weight, weight], axis=1)


@dataclass(frozen=True)
class ProvedParts(BoxParts):
    """Parts with a mask of those for which a claim is proved."""

    holds: BoolArray

    @property
    def outcome(self) -> IntArray:
        """Proved or open; no part is refuted as a whole."""
        return np.where(self.holds, Decision.PROVED, Decision.OPEN)


class Claim(ABC):
    """A claim about a box of parameters: how parts are decided, and at which points it is false."""

    #: Parts in one batch, default limit of all parts, and most corners to try for a refutation.
    batch, most, corners = 64, 2000, 64
    #: Whether to look for a counterexample also in parts that will be halved.
    early = True
    #: Names of the sides of the parts.
    sides: tuple[str, ...]
    whole: BoxParts

    @abstractmethod
    def settled(self, parts: Any) -> tuple[Any, FloatArray]:
        """The parts with what is proved of them, and the weight of each side for halving."""

    @abstractmethod
    def point(self, values: FloatArray) -> ParameterSet:
        """The parameters at points of the box, shape (sides, …)."""

    @abstractmethod
    def fails(self, points: FloatArray) -> BoolArray:
        """Points of the box, shape (sides, N), at which the claim is proved to be false."""

    def refuted(self, points: FloatArray) -> ParameterSet | None:
        """The parameters at the first of the points at which the claim is proved to be false, or
        None.
        """
        fails = np.flatnonzero(self.fails(points))
        return self.point(points[:, fails[0]]) if fails.size else None

    def run(
        self,
        share: Callable[[Any], FloatArray],
        most: int,
        kept: Callable[[Any], Any] = lambda parts: parts,
    ) -> Iterator[tuple[Any, BoolArray, int]]:
        """Decide parts in batches, those with the largest open share first.

        Yields the parts, a mask of those that will not be halved, and the count of parts just
        decided. ``share`` gives the open share of a part, and ``kept`` drops parts that do not
        matter. An open part is halved unless no float lies between its ends or ``most`` parts have
        been decided; parts left over come last.
        """
        pending, seen = self.whole, 0
        while len(pending) and seen < most:
            order = np.argsort(-share(pending), kind="stable")
            chosen = order[: min(self.batch, most - seen)]
            parts = kept(pending[chosen])
            with doing(
                "{} of at most {} parts of the box looked at, {} open", seen, most, len(pending)
            ):
                parts, weight = self.settled(parts) if len(parts) else (parts, parts.low)
            seen += chosen.size
            last = (share(parts) <= 0) | ~parts.divisible().any(axis=0)
            yield parts, last, int(chosen.size)
            pending = pending[order[chosen.size :]]
            if not last.all():
                pending = pending.concatenated(parts[~last].divided(weight[:, ~last], most - seen))
        if len(pending):
            yield pending, np.ones(len(pending), dtype=bool), 0

    def at_corners(self) -> FloatArray:
        """Points to try first for a refutation: the middle and corners of the box, shape (sides,
        N).
        """
        low, high = self.whole.low[:, 0], self.whole.high[:, 0]
        ends = [dict.fromkeys(pair) for pair in zip(low, high, strict=True)]
        corners = itertools.islice(itertools.product(*ends), self.corners)
        return np.array([0.5 * (low + high), *corners]).T

    def certificate(self, claim: str, most: int, refute: bool) -> Certificate:
        """The certificate of the claim over the whole box."""
        volume = self.whole.volume[0]
        if refute and self.whole.outcome[0] != Decision.PROVED:
            found = self.refuted(self.at_corners())
            if found is not None:
                return Certificate(claim, "refuted", found, 1.0, 1)
        seen, proved, undecided, decided = 0, 0.0, 0.0, True
        for parts, last, looked in self.run(lambda parts: parts.open_volume / volume, most):
            seen += looked
            outcome, share = parts.outcome, parts.volume / volume
            open_ = outcome == Decision.OPEN
            proved += float(share[outcome == Decision.PROVED].sum())
            undecided += float(share[last & open_].sum())
            decided &= not (last & open_).any()
            false = np.flatnonzero(outcome == Decision.REFUTED)
            points = 0.5 * (parts.low + parts.high)[:, open_ & (last | self.early)][:, : self.batch]
            found = self.point(parts.high[:, false[0]]) if false.size else None
            if found is None and refute and points.size:
                found = self.refuted(points)
            if found is not None:
                return Certificate(claim, "refuted", found, max(1.0 - proved, 0.0), seen)
        return Certificate(claim, "proved" if decided else "undecided", None, undecided, seen)


def corner_values(
    names: Sequence[str],
    low: ParameterSet,
    high: ParameterSet,
    units: Mapping[str, Unit] = MappingProxyType({}),
) -> tuple[FloatArray, FloatArray]:
    """Parameters and units at both corners of a box, each of shape (P, 1)."""
    for what, corner in (("low", low), ("high", high)):
        if corner.shape:
            raise ParameterError(
                f"{what} has the shape {corner.shape}; give one point, the corner of a box"
            )
    one = np.array([*low.scalars(*names), *(unit.low for unit in units.values())])
    other = np.array([*high.scalars(*names), *(unit.high for unit in units.values())])
    for name, least, most in zip([*names, *units], one, other, strict=True):
        if least > most:
            raise ParameterError(
                f"low.{name} = {least:g} is above high.{name} = {most:g}; exchange the two"
            )
    return one[:, None], other[:, None]


#: For each combination of touching contacts: its balance, the bounds of parts, and roots whose
#: points are the parts. The roots are states in this combination all over the part. Undecided boxes
#: may hold a state, or its combination is not known.
OfCombinations: TypeAlias = Sequence[tuple[Balance, Intervals, Roots]]


def _one(combinations: OfCombinations) -> BoolArray:
    """Parts with exactly one state at each point."""
    (_, bounds, _), *_ = combinations
    count = bounds.shape[-1]
    proved = sum(np.bincount(roots.point, minlength=count) for *_, roots in combinations)
    open_ = sum(np.bincount(roots.undecided_point, minlength=count) for *_, roots in combinations)
    return np.asarray((proved == 1) & (open_ == 0))


def _of_all_states(
    holds_over: Callable[[Balance, Intervals, FloatArray], BoolArray],
    combinations: OfCombinations,
) -> BoolArray:
    """Parts of whose states all, those in undecided boxes included, something holds: for prepared
    parameters and boxes of coordinates ``holds_over`` says where.
    """
    holds = []
    for balance, bounds, roots in combinations:
        every, point = roots.every
        each = holds_over(balance, balance.prepared(bounds[:, point]), every)
        holds.append(np.bincount(point[~each], minlength=bounds.shape[-1]) == 0)
    return np.all(holds, axis=0)


def _some_not_stable(eq: Equilibria) -> BoolArray:
    """Points with a state that grows, or that nothing damps: the λ there have the sum 0."""
    grows = np.asarray((eq["growth_sign"] > 0).any(axis=-1))
    balances = balances_of(eq.parameters.model)
    given = np.array(eq.parameters.broadcast(*balances[0].parameters))
    for at in zip(*np.nonzero(~grows & (eq.count > 0)), strict=True):
        q = [eq[name][(*at, 0)] for name in balances[0].coordinates]
        grows[at] = all(stability.is_undamped(balance, given[:, *at], q) for balance in balances)
    return grows


#: For each claim, the function that says for which parts it is proved, and the one that says at
#: which points it is false.
STATES: dict[
    str, tuple[Callable[[OfCombinations], BoolArray], Callable[[Equilibria], BoolArray]]
] = {
    "one equilibrium": (
        _one,
        lambda eq: (eq.count > 1) | ((eq.count == 0) & eq.decided & eq.whole),
    ),
    "no flutter": (
        partial(_of_all_states, stability.real),
        lambda eq: ((eq.undamped == EquilibriumType.FLUTTER) & ~eq.marginal).any(axis=-1),
    ),
    "stable": (partial(_of_all_states, stability.decays), _some_not_stable),
}


@dataclass(frozen=True)
class LocatedParts(ProvedParts):
    """Parts with boxes around their states: ``around``, shape (2, combinations, n, N), is infinite
    where nothing is known.
    """

    around: FloatArray


class ClaimOfStates(Claim):
    """One of the claims of :data:`STATES`, about all equilibria in contact."""

    def __init__(self, low: ParameterSet, high: ParameterSet, claim: str) -> None:
        self.model = low.model
        self.balances = balances_of(self.model)
        self.sides = tuple(self.balances[0].parameters)
        self.true, self.false = STATES[claim]
        nowhere = np.full((2, len(self.balances), self.balances[0].n, 1), np.inf)
        corners = corner_values(self.sides, low, high)
        box = Intervals.between(*corners)
        # With a symmetric K no state flutters, wherever it is.
        never = claim == "no flutter" and all(
            stability.is_conservative(balance, box) for balance in self.balances
        )
        self.whole = LocatedParts(*corners, np.array([never]), nowhere)

    def point(self, values: FloatArray) -> ParameterSet:
        return self.model.Parameters(**dict(zip(self.sides, values, strict=True)))

    def fails(self, points: FloatArray) -> BoolArray:
        return self.false(equilibria(self.point(points)))

    def certificate(self, claim: str, most: int, refute: bool) -> Certificate:
        """The certificate over the whole box.

        If no region is proved to hold all states at the middle, the claim can't be proved, and only
        one batch is tried for a refutation.
        """
        middle = Intervals.point(self.at_corners()[:, :1])
        unproved = (not region(balance, middle)[1].all() for balance in self.balances)
        if self.whole.outcome[0] == Decision.OPEN and any(unproved):
            most = min(most, self.batch)
        return super().certificate(claim, most, refute)

    def settled(self, parts: Any) -> tuple[LocatedParts, FloatArray]:
        if parts.holds.all():
            return parts, parts.low
        bounds = Intervals.between(parts.low, parts.high)
        weight, around, combinations = parts.slight, list[FloatArray](), list[Any]()
        for k, balance in enumerate(self.balances):
            roots, box = self._located(balance, parts, parts.around[:, k])
            self._weigh(weight, balance, parts, roots)
            around.append(box)
            combinations.append((balance, bounds, roots))
        boxes = np.stack(around, axis=1)
        complete = np.isfinite(boxes).all(axis=(0, 1, 2))
        with quiet():
            holds = complete & self.true(combinations)
        return replace(parts, holds=holds, around=boxes), weight

    def _located(
        self, balance: Balance, parts: LocatedParts, box: FloatArray
    ) -> tuple[Roots, FloatArray]:
        """States of one combination in parts, and boxes that hold all of them, shape (2, n, N).

        ``box`` are the boxes to search; where infinite, the region is computed first.
        """
        bounds = Intervals.between(parts.low, parts.high)
        complete = np.asarray(np.isfinite(box).all(axis=(0, 1)))
        unknown = np.flatnonzero(~complete)
        if unknown.size:
            box = box.copy()
            box[:, :, unknown], complete[unknown] = region(balance, bounds[:, unknown])
        found = reduced_by_turns(
            balance.periodic,
            certified_roots.search(
                balance, box, parts.low, parts.high, budget=600, narrow=2.0**-20
            ),
        )
        ends, point = found.every
        in_contact, beyond = on_side(balance, balance.prepared(bounds[:, point]), ends)
        # The first boxes are those with a proved root; undecided ones follow.
        proved = in_contact & (np.arange(point.size) < found.point.size)
        states = Roots.at(ends, point=point).reopened(proved, ~(beyond | proved))
        hulls = hulls_of(ends[:, :, ~beyond], point[~beyond], len(parts))
        margin = 1e-6 + balance.options.margin * np.maximum(width_of(hulls), 0.0)
        with quiet():  # a part without states keeps an empty hull
            hulls = np.fmin(rounded_outward(hulls + margin), box)
        return states, np.where(complete, hulls, np.inf)

    @staticmethod
    def _weigh(out: FloatArray, balance: Balance, parts: LocatedParts, states: Roots) -> None:
        """Raise ``out``, shape (P, N), to the largest move of the states of each part by each
        parameter.

        Moves are relative to the states' size, to first order.
        """
        middle = 0.5 * (parts.low + parts.high)
        ends, point = states.every
        with quiet():
            q = Intervals(ends).middle
            K = balance.jacobian(Intervals.point(q), balance.prepared_at(middle[:, point])).middle
            inverse = np.abs(np.linalg.pinv(np.nan_to_num(np.moveaxis(K, -1, 0))))
            for row in np.flatnonzero((parts.low != parts.high).any(axis=1)):
                low, high = middle[:, point], middle[:, point]
                low[row], high[row] = parts.low[row, point], parts.high[row, point]
                over = balance.prepared(Intervals.between(low, high))
                forces = balance.residuals(Intervals.point(q), over).width
                moved = np.einsum("Nij,jN->iN", inverse, forces) / scale_of(q)
                np.maximum.at(out[row], point, np.nan_to_num(moved).max(axis=0))
