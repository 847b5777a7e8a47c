"""Certificates of claims about every point of a box of parameters: proved, refuted by a point, or undecided, by halving parts."""

from __future__ import annotations

import itertools
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, Self

import numpy as np

from ..bifurcation.tubes.tube_regions import ByColumn, Flags, halves
from ..errors import ParameterError
from ..models.parameters import ParameterSet
from ..numerics.interval_arrays import FloatArray, IntArray
from ..progress import doing
from ..results.result import Result

#: Outcomes of a part.
OPEN, SAFE, ENDS = 0, 1, -1


@dataclass(frozen=True)
class Certificate(Result):
    """Certificate of a claim over a box of parameters: proved, refuted or undecided.

    Attributes
    ----------
    claim : str
        As given.
    outcome : str
        ``"proved"``, ``"refuted"`` or ``"undecided"``.
    counterexample : Parameters or None
        A point of the box at which the claim is false, if it is refuted.
    undecided : float
        Share of the volume of the box that is neither proved nor known to hold a counterexample.
    boxes : int
        Boxes that were looked at.
    """

    claim: str
    outcome: str
    counterexample: ParameterSet | None
    undecided: float
    boxes: int


@dataclass(frozen=True)
class Boxes(ByColumn, ABC):
    """Parts of a box, one a column: their ends, shape (sides, N)."""

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

    def divisible(self) -> Flags:
        """Sides that have floats between their ends."""
        return np.nextafter(self.low, np.inf) < self.high

    def divided(self, weight: FloatArray, most: int) -> Self:
        """Each cut across the side that matters most."""
        _, high, low = halves(self.low, self.high, weight)
        return replace(self, high=high).then(replace(self, low=low))


@dataclass(frozen=True)
class Held(Boxes):
    """Parts of which it is known for some that a claim holds."""

    holds: Flags

    @property
    def outcome(self) -> IntArray:
        """Whether a claim holds."""
        return np.where(self.holds, SAFE, OPEN)


class Claim(ABC):
    """A claim about a box of parameters: what is proved of parts of it, and at which points it is false."""

    #: Parts at a time, all parts unless told otherwise, and corners at which the claim may be refuted.
    batch, most, corners = 64, 2000, 64
    #: What the sides of the parts are.
    sides: tuple[str, ...]
    whole: Boxes

    @abstractmethod
    def settled(self, parts: Any, sharp: bool = False) -> tuple[Any, FloatArray]:
        """The parts with what is proved of them, and how much each side matters; ``sharp`` asks for all that can be known."""

    @abstractmethod
    def point(self, values: FloatArray) -> ParameterSet:
        """The parameters at points of the box, shape (sides, …)."""

    @abstractmethod
    def refuted(self, points: FloatArray) -> ParameterSet | None:
        """The parameters at the first of some points, shape (sides, N), at which the claim is proved to be false, or None."""

    def suspects(self, parts: Boxes, last: Flags) -> FloatArray:
        """Points of open parts at which a counterexample is looked for; ``last`` are parts that are not halved any more."""
        return np.asarray(0.5 * (parts.low + parts.high)[:, parts.outcome == OPEN][:, : self.batch])

    def run(
        self, share: Callable[[Any], FloatArray], most: int, sharp: bool = False, kept: Callable[[Any], Any] | None = None
    ) -> Iterator[tuple[Any, Flags, int]]:
        """Parts in turn, those of which most is open first: which of them are not halved any more, and how many were looked at.

        ``share`` is how much of a part is open, ``kept`` what of parts matters. What is open is halved, unless it is as thin as
        floats are or ``most`` parts were looked at: those that are left then come last.
        """
        pending, seen = self.whole, 0
        while len(pending) and seen < most:
            order = np.argsort(-share(pending), kind="stable")
            taken = order[: min(self.batch, most - seen)]
            some = pending[taken] if kept is None else kept(pending[taken])
            with doing("{} of at most {} parts of the box looked at, {} open", seen, most, len(pending)):
                some, weight = self.settled(some, sharp) if len(some) else (some, some.low)
            seen += taken.size
            last = (share(some) <= 0) | ~some.divisible().any(axis=0)
            yield some, last, int(taken.size)
            pending = pending[order[taken.size :]]
            if not last.all():
                pending = pending.then(some[~last].divided(weight[:, ~last], most - seen))
        if len(pending):
            yield pending, np.ones(len(pending), dtype=np.bool_), 0

    def certificate(self, claim: str, most: int, refute: bool) -> Certificate:
        """Whether it holds for all of the box."""
        volume = self.whole.volume[0]
        ends = self.whole.low[:, 0], self.whole.high[:, 0]
        known = (self.whole.outcome == SAFE).all()
        if refute and not known and (found := self.refuted(corners(*ends, self.corners))) is not None:
            return Certificate(claim, "refuted", found, 1.0, 1)
        seen, proved, left, decided = 0, 0.0, 0.0, True

        def share(parts: Boxes) -> FloatArray:
            return np.where(parts.outcome == OPEN, parts.volume / volume, 0.0)

        for parts, last, looked in self.run(share, most):
            seen += looked
            outcome, rest = parts.outcome, last & (parts.outcome == OPEN)
            proved += float((parts.volume / volume)[outcome == SAFE].sum())
            left += float(share(parts)[rest].sum())
            decided &= not rest.any()
            false, points = np.flatnonzero(outcome == ENDS), self.suspects(parts, last)
            found = self.point(parts.high[:, false[0]]) if false.size else None
            if found is None and refute and points.size:
                found = self.refuted(points)
            if found is not None:
                return Certificate(claim, "refuted", found, max(1.0 - proved, 0.0), seen)
        return Certificate(claim, "proved" if decided else "undecided", None, left, seen)


def corners(low: FloatArray, high: FloatArray, most: int) -> FloatArray:
    """The middle and corners of a box, shape (sides, N)."""
    ends = [(one,) if one == other else (one, other) for one, other in zip(low, high, strict=True)]
    return np.array([0.5 * (low + high), *itertools.islice(itertools.product(*ends), most)]).T


def corner_values(names: Sequence[str], low: Any, high: Any) -> tuple[FloatArray, FloatArray]:
    """Parameters of two corners of a box, each of shape (P,)."""
    for what, corner in (("low", low), ("high", high)):
        if corner.shape:
            raise ParameterError(f"{what} has the shape {corner.shape}; give one point, the corner of a box")
    one, other = (np.array(p.scalars(*names)) for p in (low, high))
    for name, least, most in zip(names, one, other, strict=True):
        if least > most:
            raise ParameterError(f"low.{name} = {least:g} is above high.{name} = {most:g}; exchange the two")
    return one, other
