"""Certificates of claims about every point of a box of parameters: proved, refuted by a point, or
undecided, by halving parts.

Claims about all states in contact, of any model: a box of parameters is searched for equilibria as
one point is, see :mod:`spragsym.numerics.boxes`: a box of coordinates in which interval Newton
proves one root holds one for every point of it. What a claim asks is decided over these boxes, and
over those that are left. A part of the box that stays open is halved across the parameter that
moves the states most; its states lie where those of the whole do.
"""

from __future__ import annotations

import itertools
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import IntEnum
from operator import attrgetter
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
    """Parts of a box, one a column: their ends, shape (sides, N)."""

    #: Fewer parts than this take as long as so many.
    few: ClassVar[int] = 0

    low: FloatArray
    high: FloatArray

    def __len__(self) -> int:
        return int(self.low.shape[1])

    @property
    @abstractmethod
    def outcome(self) -> IntArray:
        """Whether a claim holds for all of a part, or is false for all of it."""

    @property
    def volume(self) -> FloatArray:
        """Volume of each part, over the sides that have a width."""
        width = self.high - self.low
        return width.prod(axis=0, where=width > 0)

    @property
    def open_volume(self) -> FloatArray:
        """The volume of parts that are undecided, 0 for the others."""
        return np.where(self.outcome == Decision.OPEN, self.volume, 0.0)

    @property
    def slight(self) -> FloatArray:
        """Weight of the relative width of each side beside its effect on the states."""
        return (
            1e-6 * (self.high - self.low) / np.maximum(np.abs(self.high) + np.abs(self.low), 1e-300)
        )

    def divisible(self) -> BoolArray:
        """Sides that have floats between their ends."""
        return np.nextafter(self.low, np.inf) < self.high

    def divided(self, weight: FloatArray, most: int) -> Self:
        """Each cut across the side that matters most, and few of them again and again, as often as
        one step takes them all.
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
        side, high, low = halves(self.low, self.high, weight)
        weight = weight.copy()
        weight[side, np.arange(side.size)] *= 0.5
        return replace(self, high=high).concatenated(replace(self, low=low)), np.concatenate(
            [weight, weight], axis=1
        )


@dataclass(frozen=True)
class ProvedParts(BoxParts):
    """Parts of which it is known for some that a claim holds."""

    holds: BoolArray

    @property
    def outcome(self) -> IntArray:
        """Whether a claim holds."""
        return np.where(self.holds, Decision.PROVED, Decision.OPEN)


class Claim(ABC):
    """A claim about a box of parameters: what is proved of parts of it, and at which points it is
    false.
    """

    #: Parts at a time, all parts unless told otherwise, and corners at which the claim may be
    #: refuted.
    batch, most, corners = 64, 2000, 64
    #: Whether a counterexample is looked for in parts that are halved, too.
    early = True
    #: What the sides of the parts are.
    sides: tuple[str, ...]
    whole: BoxParts

    @abstractmethod
    def settled(self, parts: Any) -> tuple[Any, FloatArray]:
        """The parts with what is proved of them, and how much each side matters."""

    @abstractmethod
    def point(self, values: FloatArray) -> ParameterSet:
        """The parameters at points of the box, shape (sides, …)."""

    @abstractmethod
    def fails(self, points: FloatArray) -> BoolArray:
        """Points of the box, shape (sides, N), at which the claim is proved to be false."""

    def refuted(self, points: FloatArray) -> ParameterSet | None:
        """The parameters at the first of some points at which the claim is proved to be false; None
        without one.
        """
        fails = np.flatnonzero(self.fails(points))
        return self.point(points[:, fails[0]]) if fails.size else None

    def run(
        self,
        share: Callable[[Any], FloatArray],
        most: int,
        kept: Callable[[Any], Any] = lambda parts: parts,
    ) -> Iterator[tuple[Any, BoolArray, int]]:
        """Parts in turn, those of which most is open first: which of them are not halved any more,
        and how many were looked at.

        ``share`` is how much of a part is open, ``kept`` what of parts matters. What is open is
        halved, unless it is as thin as floats are or ``most`` parts were looked at: those that are
        left then come last.
        """
        pending, seen = self.whole, 0
        while len(pending) and seen < most:
            order = np.argsort(-share(pending), kind="stable")
            taken = order[: min(self.batch, most - seen)]
            some = kept(pending[taken])
            with doing(
                "{} of at most {} parts of the box looked at, {} open", seen, most, len(pending)
            ):
                some, weight = self.settled(some) if len(some) else (some, some.low)
            seen += taken.size
            last = (share(some) <= 0) | ~some.divisible().any(axis=0)
            yield some, last, int(taken.size)
            pending = pending[order[taken.size :]]
            if not last.all():
                pending = pending.concatenated(some[~last].divided(weight[:, ~last], most - seen))
        if len(pending):
            yield pending, np.ones(len(pending), dtype=bool), 0

    def at_corners(self) -> FloatArray:
        """Points at which a counterexample is looked for first: the middle and corners of the box,
        shape (sides, N).
        """
        low, high = self.whole.low[:, 0], self.whole.high[:, 0]
        ends = [
            (one,) if one == other else (one, other) for one, other in zip(low, high, strict=True)
        ]
        return np.array(
            [0.5 * (low + high), *itertools.islice(itertools.product(*ends), self.corners)]
        ).T

    def certificate(self, claim: str, most: int, refute: bool) -> Certificate:
        """Whether it holds for all of the box."""
        volume = self.whole.volume[0]
        if (
            refute
            and self.whole.outcome[0] != Decision.PROVED
            and (found := self.refuted(self.at_corners())) is not None
        ):
            return Certificate(claim, "refuted", found, 1.0, 1)
        seen, proved, left, decided = 0, 0.0, 0.0, True
        for parts, last, looked in self.run(lambda parts: parts.open_volume / volume, most):
            seen += looked
            outcome, share = parts.outcome, parts.volume / volume
            open_ = outcome == Decision.OPEN
            proved += float(share[outcome == Decision.PROVED].sum())
            left += float(share[last & open_].sum())
            decided &= not (last & open_).any()
            false = np.flatnonzero(outcome == Decision.REFUTED)
            points = 0.5 * (parts.low + parts.high)[:, open_ & (last | self.early)][:, : self.batch]
            found = self.point(parts.high[:, false[0]]) if false.size else None
            if found is None and refute and points.size:
                found = self.refuted(points)
            if found is not None:
                return Certificate(claim, "refuted", found, max(1.0 - proved, 0.0), seen)
        return Certificate(claim, "proved" if decided else "undecided", None, left, seen)


def corner_values(
    names: Sequence[str],
    low: ParameterSet,
    high: ParameterSet,
    units: Mapping[str, Unit] = MappingProxyType({}),
) -> tuple[FloatArray, FloatArray]:
    """Parameters of two corners of a box, and ends of units, each of shape (P, 1)."""
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


#: Of each combination of contacts that touch: its balance, bounds of some parts, and as roots, with
#: the parts as points, the states that have this combination all over a part, and as what is left
#: the boxes of which that, or whether they hold a state, is not known.
OfCombinations: TypeAlias = Sequence[tuple[Balance, Intervals, Roots]]


def _one(combinations: OfCombinations) -> BoolArray:
    """Parts with one state at each point."""
    proved, left = (
        sum(
            np.bincount(points(roots), minlength=bounds.shape[-1])
            for _, bounds, roots in combinations
        )
        for points in (attrgetter("point"), attrgetter("undecided_point"))
    )
    return np.asarray((proved == 1) & (left == 0))


def _none_flutters(combinations: OfCombinations) -> BoolArray:
    """Parts all of whose states have real κ only, those in boxes that are left included."""
    holds = []
    for balance, bounds, roots in combinations:
        every, point = roots.every
        real = stability.real(balance, balance.prepared(bounds[:, point]), every)
        holds.append(np.bincount(point[~real], minlength=bounds.shape[-1]) == 0)
    return np.all(holds, axis=0)


#: For each claim where it holds, and at which points it is refuted: several states, or proved to be
#: none; one proved to flutter.
STATES: dict[
    str, tuple[Callable[[OfCombinations], BoolArray], Callable[[Equilibria], BoolArray]]
] = {
    "one equilibrium": (
        _one,
        lambda eq: (eq.count > 1) | ((eq.count == 0) & eq.decided & eq.whole),
    ),
    "no flutter": (
        _none_flutters,
        lambda eq: ((eq.undamped == EquilibriumType.FLUTTER) & ~eq.marginal).any(axis=-1),
    ),
}


@dataclass(frozen=True)
class LocatedParts(ProvedParts):
    """Parts, and where their states of each combination of contacts are: ``around``, shape (2,
    combinations, n, N), is infinite where nothing is known of that.
    """

    around: FloatArray


class ClaimOfStates(Claim):
    """One of the claims of :data:`STATES`."""

    def __init__(self, low: ParameterSet, high: ParameterSet, claim: str) -> None:
        self.model = low.model
        self.balances = balances_of(self.model)
        self.sides = tuple(self.balances[0].parameters)
        self.true, self.false = STATES[claim]
        nowhere = np.full((2, len(self.balances), self.balances[0].n, 1), np.inf)
        corners = corner_values(self.sides, low, high)
        box = Intervals.between(*corners)
        # None flutters, wherever a state is.
        never = claim == "no flutter" and all(
            stability.is_conservative(balance, box) for balance in self.balances
        )
        self.whole = LocatedParts(*corners, np.array([never]), nowhere)

    def point(self, values: FloatArray) -> ParameterSet:
        return self.model.Parameters(**dict(zip(self.sides, values, strict=True)))

    def fails(self, points: FloatArray) -> BoolArray:
        return self.false(equilibria(self.point(points)))

    def certificate(self, claim: str, most: int, refute: bool) -> Certificate:
        """Whether it holds for all of the box; of few parts where no region is proved to hold all
        states of its middle, so that it may be refuted at most.
        """
        middle = Intervals.point(self.at_corners()[:, :1])
        unproved = (not region(balance, middle)[1].all() for balance in self.balances)
        if self.whole.outcome[0] == Decision.OPEN and any(unproved):
            most = min(most, self.batch)
        return super().certificate(claim, most, refute)

    def settled(self, parts: Any) -> tuple[LocatedParts, FloatArray]:
        if parts.holds.all():
            return parts, parts.low
        located = [
            self._located(balance, parts, searched)
            for balance, searched in zip(
                self.balances, np.moveaxis(parts.around, 1, 0), strict=True
            )
        ]
        states, where = zip(*located, strict=True)
        searched = np.stack(where, axis=1)
        whole = np.isfinite(searched).all(axis=(0, 1, 2))
        bounds = Intervals.between(parts.low, parts.high)
        with quiet():
            holds = whole & self.true(
                [(one, bounds, roots) for one, roots in zip(self.balances, states, strict=True)]
            )
        weight = parts.slight
        for balance, roots in zip(self.balances, states, strict=True):
            self._weigh(weight, balance, parts, roots)
        return replace(parts, holds=holds, around=searched), weight

    def _located(
        self, balance: Balance, parts: LocatedParts, box: FloatArray
    ) -> tuple[Roots, FloatArray]:
        """States of one combination in parts, and boxes with all of them, shape (2, n, N)."""
        bounds = Intervals.between(parts.low, parts.high)
        whole = np.asarray(np.isfinite(box).all(axis=(0, 1)))
        new = np.flatnonzero(~whole)
        if new.size:
            box = box.copy()
            box[:, :, new], whole[new] = region(balance, bounds[:, new])
        found = reduced_by_turns(
            balance.periodic,
            certified_roots.search(
                balance, box, parts.low, parts.high, budget=600, narrow=2.0**-20
            ),
        )
        ends, point = found.every
        in_contact, beyond = on_side(balance, balance.prepared(bounds[:, point]), ends)
        # Only those whose root is proved.
        kept = in_contact & (np.arange(point.size) < found.point.size)
        left = ~(beyond | kept)
        states = Roots.at(ends, point=point).reopened(kept, left)
        where = hulls_of(ends[:, :, ~beyond], point[~beyond], len(parts))
        room = 1e-6 + balance.options.margin * np.maximum(width_of(where), 0.0)
        with quiet():  # where there is no state it stays as it is
            where = np.fmin(rounded_outward(where + room), box)
        return states, np.where(whole, where, np.inf)

    @staticmethod
    def _weigh(out: FloatArray, balance: Balance, parts: LocatedParts, states: Roots) -> None:
        """Raise ``out``, shape (P, N), to how far each parameter moves the states of each part."""
        middle = 0.5 * (parts.low + parts.high)
        ends, point = states.every
        with quiet():
            q = Intervals(ends).middle
            K = balance.jacobian(Intervals.point(q), balance.prepared_at(middle[:, point])).middle
            back = np.abs(np.linalg.pinv(np.nan_to_num(np.moveaxis(K, -1, 0))))
            for row in np.flatnonzero((parts.low != parts.high).any(axis=1)):
                low, high = middle[:, point], middle[:, point]
                low[row], high[row] = parts.low[row, point], parts.high[row, point]
                pushed = balance.residuals(
                    Intervals.point(q), balance.prepared(Intervals.between(low, high))
                ).width
                moved = np.einsum("Nij,jN->iN", back, pushed) / scale_of(q)
                np.maximum.at(out[row], point, np.nan_to_num(moved).max(axis=0))
