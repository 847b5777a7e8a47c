"""Certificates over boxes of parameters of any model: parts on which the followed state is proved to go on, or proved to end."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..design.certificates import Certificate
from ..design.claims import CLAIMS
from ..errors import ConvergenceError, ModelError, ParameterError
from ..exact import contractors
from ..exact.interval_arrays import FloatArray
from ..statics.results import Stability
from .balance import Balance
from .equilibria import equilibria
from .tubes import Flags, Parts, Place, Tubes

#: Parts at a time, and points at a time.
BATCH, POINTS = 1024, 1024
#: The least step of a tube, over the whole way. A wide part that needs smaller ones is halved instead.
WIDE, THIN = 2.0**-6, 2.0**-14
#: Most corners of a box that are looked at for a counterexample.
CORNERS = 64
#: Two states that are the same one, to rounding.
NEAR = 1e-8
#: Outcomes of a part.
OPEN, SAFE, ENDS = 0, 1, -1

Outcomes: TypeAlias = NDArray[np.int64]


@dataclass(frozen=True)
class Pieces:
    """Parts of a box, one a column: their ends, and where the followed state begins in the part that each is a piece of.

    ``low`` and ``high`` have the shape (free + 1, N), the parameter that moves last; ``middle``, (free, N), is that of ``base``.
    """

    low: FloatArray
    high: FloatArray
    base: Place
    middle: FloatArray

    def __getitem__(self, rows: Any) -> Pieces:
        return Pieces(self.low[:, rows], self.high[:, rows], self.base[rows], self.middle[:, rows])

    def __len__(self) -> int:
        return int(self.low.shape[1])

    def then(self, others: Pieces) -> Pieces:
        """These, and others."""
        base = Place(*(np.concatenate([getattr(one.base, name) for one in (self, others)], axis=-1)
                       for name in ("z", "held", "by_p", "sure")))  # fmt: skip
        pairs = ((self.low, others.low), (self.high, others.high), (self.middle, others.middle))
        low, high, middle = (np.concatenate(pair, axis=1) for pair in pairs)
        return Pieces(low, high, base, middle)

    def halved(self, weight: FloatArray) -> Pieces:
        """Each cut across the side that matters most; what is as thin as floats are stays as it is, twice."""
        column = np.arange(len(self))
        side = np.where(self.high > self.low, weight, -1.0).argmax(axis=0)
        middle = 0.5 * (self.low[side, column] + self.high[side, column])
        low, high = self.low.copy(), self.high.copy()
        low[side, column], high[side, column] = middle, middle
        return replace(self, high=high).then(replace(self, low=low))


class Splitting:
    """A state followed over a box of parameters, from one value of the parameter that moves to those in the box."""

    def __init__(self, low: Any, high: Any, vary: str, begin: float) -> None:
        model = low.model
        self.model, self.vary, self.begin = model, vary, begin
        self.balance = Balance(model, contact=True)
        ends = [dict(zip(self.balance.parameters, p.scalars(*self.balance.parameters), strict=True)) for p in (low, high)]
        for name, one in ends[0].items():
            if one > ends[1][name]:
                raise ParameterError(f"low.{name} = {one:g} is above high.{name} = {ends[1][name]:g}; exchange the two")
        if begin > ends[0][vary]:
            raise ParameterError(f"begin = {begin:g} is above low.{vary} = {ends[0][vary]:g}; begin where {vary} is lower")
        self.free = tuple(name for name in self.balance.parameters if ends[0][name] != ends[1][name] and name != vary)
        self.tubes = Tubes(self.balance, vary, self.free)
        self.fixed = np.array([[ends[0][name]] for name in self.balance.parameters])
        one, other = (np.array([[end[name]] for name in (*self.free, vary)]) for end in ends)
        middle = 0.5 * (one + other)[:-1]
        start = self.tubes.place(self._parts(one, other), np.append(self._first(middle[:, 0]), begin)[:, None], self.tubes.n)
        self.whole = Pieces(one, other, start, middle)

    def _parts(self, low: FloatArray, high: FloatArray) -> Parts:
        centre = 0.5 * (low[:-1] + high[:-1])
        half = np.maximum(high[:-1] - centre, centre - low[:-1])
        return Parts(np.repeat(self.fixed, low.shape[1], axis=1), centre, half)

    def _at(self, values: FloatArray) -> dict[str, float]:
        """All parameters by name."""
        names = dict(zip(self.balance.parameters, self.fixed[:, 0].tolist(), strict=True))
        return {**names, **dict(zip((*self.free, self.vary), values.tolist(), strict=False))}

    def _first(self, middle: FloatArray) -> FloatArray:
        """The stable state of smallest first coordinate in the middle of the box, where what moves begins."""
        p = self.model.Parameters(**{**self._at(middle), self.vary: self.begin})
        eq = equilibria(self.model, p)
        stable = np.flatnonzero(eq.stability[: int(eq.count)] == Stability.STABLE)
        if not eq.decided or not stable.size:
            raise ConvergenceError(f"no state in the middle of the box is known to be stable at {self.vary} = {self.begin:g}")
        states = np.array([eq.coordinates[name][stable] for name in self.balance.coordinates])
        first: FloatArray = states[:, np.abs(states[0]).argmin()]
        return first

    def point(self, values: FloatArray) -> Any:
        """The parameters at a point of the box."""
        return self.model.Parameters(**self._at(values))

    def points(self, values: FloatArray) -> Pieces:
        """Points of the box, shape (free + 1, N), as pieces of it."""
        every = np.zeros(values.shape[1], dtype=np.int64)
        return replace(self.whole[every], low=values, high=values)

    # ---------------------------------------------------------------------------------------------------- decisions

    def settled(self, pieces: Pieces, least: float) -> tuple[Outcomes, FloatArray, Pieces]:
        """What is proved of each piece, how much each side matters where nothing is, and the pieces with their own beginnings."""
        parts, start = self._begun(pieces)
        last, goal = self.tubes.n, pieces.high[-1]
        reached = self.tubes.followed(parts, start, goal, least)
        out = np.where(reached.sure & (reached.z[last] == goal), SAFE, OPEN)
        width = pieces.high - pieces.low
        weight = width / np.maximum(np.abs(pieces.high) + np.abs(pieces.low), 1e-300)
        rows = np.flatnonzero((out == OPEN) & reached.sure & (reached.z[last] != start.z[last]))
        if rows.size:
            out[rows], moves = self.tubes.passed(parts[rows], reached[rows], pieces.low[-1, rows], goal[rows])
            weight[:, rows] = 0.5 * width[:, rows] * np.concatenate([moves, np.ones((1, rows.size))])
        own = np.flatnonzero(start.sure)
        base, middle = pieces.base[np.arange(len(pieces))], pieces.middle.copy()
        base.put(own, start[own])
        middle[:, own] = parts.centre[:, own]
        return out, weight, replace(pieces, base=base, middle=middle)

    def _begun(self, pieces: Pieces) -> tuple[Parts, Place]:
        """Where pieces begin: the state of what they are pieces of, proved; not sure where it can't be."""
        parts = self._parts(pieces.low, pieces.high)
        z = pieces.base.z + np.einsum("ikN,kN->iN", pieces.base.by_p, parts.centre - pieces.middle)
        here = self.tubes.place(parts, z, self.tubes.n)
        same = pieces.base.sure & contractors.within(here.box().ends, pieces.base.box().ends)
        rows = np.flatnonzero(here.sure & ~same)
        same[rows] = self._linked(pieces.middle[:, rows], pieces.base.z[:-1, rows], parts.centre[:, rows], here.z[:-1, rows])
        return parts, replace(here, sure=here.sure & same)

    def _linked(self, one: FloatArray, q: FloatArray, other: FloatArray, arrived: FloatArray) -> Flags:
        """Whether states in some middles become those in others, as one parameter after the other moves."""
        out = np.ones(one.shape[1], dtype=np.bool_)
        at, q = np.repeat(self.fixed, one.shape[1], axis=1), q.copy()
        at[self.tubes.places], at[self.tubes.moving] = one, self.begin
        for k, name in enumerate(self.free):
            tubes, rows = Tubes(self.balance, name), np.flatnonzero(out & (one[k] != other[k]))
            none = np.zeros((0, rows.size))
            parts = Parts(at[:, rows], none, none)
            start = tubes.place(parts, np.concatenate([q[:, rows], one[k : k + 1, rows]]), tubes.n)
            end = tubes.followed(parts, start, other[k, rows])
            out[rows] = end.sure & (end.z[-1] == other[k, rows])
            at[self.tubes.places[k], rows], q[:, rows] = other[k, rows], end.z[:-1]
        same: Flags = out & (np.abs(q - arrived) <= NEAR * np.maximum(1.0, np.abs(arrived))).all(axis=0)
        return same

    def run(
        self, share: Callable[[FloatArray, FloatArray], FloatArray], most: int
    ) -> Iterator[tuple[Pieces, FloatArray, Outcomes]]:
        """Pieces that were looked at with their shares and outcomes, the largest first; the last ones are those that are left."""
        pending, seen = self.whole, 0
        while len(pending):
            shares = share(pending.low, pending.high)
            if seen >= most:
                yield pending, shares, np.zeros(len(pending), dtype=np.int64)
                return
            order = np.argsort(-shares, kind="stable")
            taken = order[: min(BATCH, most - seen)]
            some, rest = pending[taken], pending[order[taken.size :]]
            outcome, weight, some = self.settled(some, WIDE)
            seen += taken.size
            open_ = outcome == OPEN
            yield some[~open_], shares[taken][~open_], outcome[~open_]
            pending = rest.then(some[open_].halved(weight[:, open_]))


def corners(low: FloatArray, high: FloatArray) -> FloatArray:
    """The middle and corners of a box, shape (free + 1, N), what moves at its upper end."""
    sides = [(one,) if one == other else (one, other) for one, other in zip(low[:-1], high[:-1], strict=True)]
    some = list(itertools.islice(itertools.product(*sides), CORNERS))
    return np.array([[*(0.5 * (low + high))[:-1], high[-1]], *((*one, high[-1]) for one in some)]).T


def certify(
    low: Any, high: Any, claim: str = "no jump", *, vary: str, begin: float = 0.0, max_boxes: int = 2000, refute: bool = True
) -> Certificate:
    """Prove for every point of a box of parameters that the followed state does not end, or find one at which it does.

    Parameters
    ----------
    low, high : Parameters
        Two corners, scalars, of one model.
    claim : {"no jump"}
        The state that is stable and of smallest first coordinate in the middle of the box where ``vary`` begins, and what it
        becomes over the box, goes on as ``vary`` rises from ``begin`` to its value in the box: it stays in contact, and neither
        meets another state.
    vary : str
        The parameter that rises.
    begin : float
        Its value where the state is taken up.
    max_boxes : int
        Parts of the box to look at before what is left is given back as undecided.
    refute : bool
        Also look for a point where the claim is false.

    Returns
    -------
    Certificate
        ``boxes`` counts the parts.

    Notes
    -----
    Source: tubes around curves of states, see :mod:`spragsym.models.tubes`. A part is proved where the tube of all its points
    comes to the upper end of ``vary``; at a counterexample the tube of the point passes a fold below. A part that a fold crosses
    is halved.
    """
    if claim != "no jump":
        known = claim in CLAIMS
        raise (ModelError if known else ParameterError)(
            f"claim = {claim!r} is not there yet for the model {low.model.name}; give 'no jump'"
            if known else f"claim = {claim!r} is not one of {', '.join(map(repr, CLAIMS))}"
        )  # fmt: skip
    box = Splitting(low, high, vary, begin)
    volume = (box.whole.high - box.whole.low).prod(axis=0, where=box.whole.high > box.whole.low)
    seen, left = 0, 1.0
    if refute:
        at = corners(box.whole.low[:, 0], box.whole.high[:, 0])
        outcome = box.settled(box.points(at), THIN)[0]
        if (outcome == ENDS).any():
            return Certificate(claim, "refuted", box.point(at[:, outcome.argmin()]), 1.0, 1)

    def share(one: FloatArray, other: FloatArray) -> FloatArray:
        part: FloatArray = (other - one).prod(axis=0, where=other > one) / volume
        return part

    for pieces, shares, outcome in box.run(share, max_boxes):
        seen += len(pieces)
        left -= float(shares[outcome == SAFE].sum())
        ends = np.flatnonzero(outcome == ENDS)
        if ends.size:
            return Certificate(claim, "refuted", box.point(pieces.high[:, ends[0]]), left, seen)
        if (outcome == OPEN).any() and refute:
            at = np.concatenate([0.5 * (pieces.low + pieces.high)[:-1], pieces.high[-1:]])[:, :POINTS]
            found = box.settled(box.points(at), THIN)[0]
            if (found == ENDS).any():
                return Certificate(claim, "refuted", box.point(at[:, found.argmin()]), float(shares.sum()), seen)
        if (outcome == OPEN).any():
            return Certificate(claim, "undecided", None, float(shares.sum()), seen)
    return Certificate(claim, "proved", None, 0.0, seen)
