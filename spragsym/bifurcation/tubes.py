"""Tubes around curves of states, proved: boxes that hold one state for each value of what moves,
for whole boxes of parameters.

A point of a curve is z = (q, v): the coordinates, and the parameter that moves. One of these is the
pivot s, which the others follow: v itself, or a coordinate where a fold is to be passed. About a
middle m, with the parameters p about their middle c,

    z = m + d s + D (p − c) + u,   F(m, c) + (F_z d) s + (F_z D + F_p) (p − c) + F_z u = 0,

by the mean value theorem with slopes over the whole box. Where d and D are near the curve's own
slopes, little is left of the two terms in the middle, and interval Newton in u proves that each s
and each p have one state in the box, and only one. Segments hold together where the set of states
at the end of one lies in the box of the next.

The state moves with the parameters, and slopes depend on both. Affine arithmetic keeps that to
first order, so that over a box little more is left than slopes really vary by; intervals would take
each entry of the matrix for its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from types import ModuleType
from typing import Any, Self

import numpy as np

from ..numerics import affine, contractors, plans, tape
from ..numerics.affine import AFFINE, UNIT, Affine
from ..numerics.arithmetic import Number
from ..numerics.columns import ByColumn
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    IntArray,
    Intervals,
    ends_around,
    pair,
    quiet,
    scale_of,
)
from ..numerics.jets import Jet
from ..numerics.tape import NotRecorded, Tape
from ..statics.balance import Balance
from ..statics.forces import Evaluation, filled
from ..statics.namespaces import NARROW, XP
from ..statics.precise_balance import on_side
from .options import ContinuationOptions

#: A sum of a few products of floats, rounded up.
ROUNDED_UP = 1 + 2.0**-40


def halves(
    low: FloatArray, high: FloatArray, weight: FloatArray, share: float = 0.5
) -> tuple[IntArray, FloatArray, FloatArray]:
    """Boxes, one a column, cut at a share of their side of most weight: its number, and the upper
    ends of one part and the lower ones of the other.

    A side between whose ends there is no float is cut last.
    """
    column = np.arange(low.shape[1])
    some = slice(len(weight))
    side = np.where(np.nextafter(low[some], np.inf) < high[some], weight, -1.0).argmax(axis=0)
    cut = (1 - share) * low[side, column] + share * high[side, column]
    top, bottom = high.copy(), low.copy()
    top[side, column], bottom[side, column] = cut, cut
    return side, top, bottom


@dataclass(frozen=True)
class Place(ByColumn):
    """Place of tubes: the middle z of the states there, how far the states of a box lie from it at
    most, and slopes D.

    Within ``room`` of z + D (p − c) each point p of the box has one state and no other, which lies
    within ``off`` of it, and within ``held`` of the middle. A tube has its states about z + a s + D
    (p − c) for all |s| ≤ moved: ``along`` are its slopes a by the pivot; of a place ``moved`` is 0.
    ``z``, ``along``, ``held``, ``off`` and ``room`` have the shape (n + 1, N), ``moved`` (N,),
    ``by_p`` (n + 1, free, N); ``sure`` where it is proved.
    """

    z: FloatArray
    along: FloatArray
    moved: FloatArray
    by_p: FloatArray
    held: FloatArray
    off: FloatArray
    room: FloatArray
    sure: BoolArray

    @property
    def v(self) -> FloatArray:
        """Values of the parameter that varies."""
        return self.z[-1]

    def box(self) -> Intervals:
        """All states there; what does not leave the middle is a point."""
        wide = self.held + np.where(self.held > 0, np.spacing(np.abs(self.z) + self.held), 0.0)
        return Intervals(ends_around(self.z, wide))

    def lies_in(
        self, other: Place, shift: FloatArray | float = 0.0, turned: FloatArray | float = 0.0
    ) -> BoolArray:
        """Whether its states are those of another place, which holds for all its parameters: by
        their coordinates.

        ``shift`` is how far the states of the other move from its middle to this one's, ``turned``
        how much the slopes of the two differ by over the box.
        """
        apart = np.abs(self.z - other.z - shift) + turned
        within = (
            apart * ROUNDED_UP
            + self.off * ROUNDED_UP
            + 2 * np.spacing(np.abs(self.z) + np.abs(other.z) + self.held + np.abs(shift))
        )
        return self.sure & other.sure & (within[:-1] <= other.room[:-1]).all(axis=0)

    def numbers(self, apart: FloatArray) -> Affine:
        """The coordinates and what moves, with s, then each p over its half-width, then each u for
        the sides.
        """
        size, free, count = self.by_p.shape
        terms = np.zeros((1 + free + size, size, count))
        terms[0] = self.along * self.moved
        terms[1 : 1 + free] = np.moveaxis(self.by_p * apart, 1, 0)
        terms[1 + free + np.arange(size), np.arange(size)] = self.off
        return Affine(self.z, terms, 2 * UNIT * np.abs(terms).sum(axis=0))


@dataclass(frozen=True)
class Slopes:
    """Rows of slopes by q, v and the free parameters, shape (n, n + 1 + free, N): intervals, or
    affine numbers that ``Y`` has multiplied.

    What belongs to the rows beside slopes ``Y`` multiplies as well.
    """

    rows: Any
    Y: FloatArray | None = None

    def taken(self, value: Any) -> Intervals:
        """Numbers of the type as intervals."""
        return value if self.Y is None else value.interval()

    def left(self, forces: Intervals, tube: Place, apart: FloatArray) -> Intervals:
        """F(m, c) and what is left of the changes along a tube and across the box of its
        parameters, by row.
        """
        if self.Y is not None:
            forces = Intervals(contractors.product(self.Y, forces.ends[:, :, None])[:, :, 0])
        moved, strayed = (Intervals(pair(part, part)) for part in (tube.moved, apart))
        total = forces + self.image(tube.along) * moved
        for k, reach in enumerate(strayed):
            total = total + self.image(tube.by_p[:, k], self.rows[:, len(tube.along) + k]) * reach
        return total

    def image(self, direction: FloatArray, start: Any = None) -> Intervals:
        """The rows times a vector, shape (n + 1, N), and more: what is 0 for all boxes is left
        out.
        """
        total = self.rows[:, 0] * 0 if start is None else start
        for j, part in enumerate(direction):
            if part.any():
                total = total + self.rows[:, j] * part
        return self.taken(total)

    def newton(self, left: Intervals, others: Sequence[int], reach: FloatArray) -> FloatArray:
        """Ends of a step of interval Newton for the unknowns ``others`` from what is left of the
        forces.
        """
        given = left, self.taken(self.rows[:, others]), np.zeros_like(reach), reach
        return contractors.newton(*given).ends if self.Y is None else contractors.by_rows(*given)


@dataclass(frozen=True)
class Tubes(ByColumn):
    """Curves of states of a model in contact as ``vary`` moves, for boxes of parameters, one a
    column.

    ``fixed`` are all parameters, shape (parameters, N), and ``prepared`` the ends of what follows
    from them, shape (2, arguments, N); ``centre`` and ``half`` are middle and half-width of those
    that are ``free`` to have a width, shape (free, N). The ``pivot`` is the number of what the
    others follow among the coordinates and, last, what moves.
    """

    balance: Balance
    vary: str
    free: tuple[str, ...]
    pivot: int
    fixed: FloatArray
    prepared: FloatArray
    centre: FloatArray
    half: FloatArray
    options: ContinuationOptions

    @classmethod
    def of_points(
        cls,
        balance: Balance,
        vary: str,
        fixed: FloatArray,
        free: tuple[str, ...] = (),
        options: ContinuationOptions | None = None,
    ) -> Self:
        """At points of the parameters, boxes of zero width; the pivot is the parameter that
        varies.
        """
        centre = fixed[[balance.parameters.index(name) for name in free]]
        half, options = np.zeros_like(centre), options or ContinuationOptions()
        prepared = balance.prepared(Intervals.point(fixed)).ends
        return cls(balance, vary, free, balance.n, fixed, prepared, centre, half, options)

    @property
    def n(self) -> int:
        """Number of coordinates, which is also the index of the parameter that varies."""
        return self.balance.n

    @property
    def moving(self) -> list[int]:
        """Indices of the free parameters among the model's, and of the one that varies."""
        return [self.balance.parameters.index(name) for name in (*self.free, self.vary)]

    @property
    def others(self) -> list[int]:
        """Indices of the unknowns that are functions of the pivot."""
        return [each for each in range(self.n + 1) if each != self.pivot]

    # ---------------------------------------------------------------------------------------------
    # evaluation

    def bounds(self, v: Intervals) -> Intervals:
        """Prepared parameters with these values of the one that varies."""
        moved = dict(zip(self.free, self._span(), strict=True)) | {self.vary: v}
        return self.balance.prepared_beside(self.prepared, self.fixed, moved)

    def _span(self) -> Intervals:
        wide = np.where(
            self.half > 0, self.half * ROUNDED_UP + np.spacing(np.abs(self.centre)), 0.0
        )
        return Intervals(ends_around(self.centre, wide))

    def slopes(self, z: Intervals) -> Intervals:
        """Slopes of the forces by q, v and the free parameters over boxes, shape (n, n + 1 + free,
        N).
        """

        def rows(q: Sequence[Number], parameters: Intervals) -> list[Any]:
            return [entry for row in self._rows(self.balance.state(q, parameters)) for entry in row]

        key = "slopes along", self.vary, self.free, bool(self.half.any())
        with quiet():
            found = self.balance.taped(key, rows, z[:-1], self.bounds(z[-1]))
        shape = 2, self.n, found.shape[0] // self.n, *found.shape[1:]
        return Intervals(found.ends.reshape(shape))

    def over(self, tube: Place) -> Slopes:
        """Slopes over places or tubes, affine where parameters have a width.

        Those are multiplied by the inverse of their midpoints for all unknowns but the pivot,
        before they become intervals.
        """
        if not self.half.any():
            return Slopes(self.slopes(tube.box()))
        with quiet():
            rows = self.affine_slopes(tube)
            Y = contractors.inverse(rows.value[:, self.others])
            first, *others = (rows[k, None] * Y[:, k, None] for k in range(self.n))
            return Slopes(sum(others, first), Y)

    def affine_slopes(self, tube: Place) -> Affine:
        """Slopes in affine arithmetic, shape (n, n + 1 + free, N)."""
        apart, (free, count) = self.apart(), self.half.shape
        moving = tube.numbers(apart)
        sides = np.zeros((len(moving.terms), free, count))
        sides[1 + np.arange(free), np.arange(free)] = apart
        given = Affine(
            np.concatenate([moving.value, self.centre]),
            np.concatenate([moving.terms, sides], axis=1),
            np.concatenate([moving.error, np.zeros((free, count))]),
        )
        if (recorded := self._affine_tape) is not None:
            found = affine.evaluated(recorded, given, Intervals(self.prepared))
        else:
            found = self._affine_by_rows(given, tube)
        shape = self.n, self.n + 1 + free, count
        terms = found.terms.reshape(-1, *shape)
        return Affine(found.value.reshape(shape), terms, found.error.reshape(shape))

    @property
    def _affine_tape(self) -> Tape | None:
        """Slopes by what moves and is free, and by the prepared parameters; None where no tape has
        them: of units, and of torsion springs, whose angles are intervals.
        """
        balance, n = self.balance, self.n
        if balance.factors or balance.torsions or not tape.available():
            return None
        vanishing = balance.vanishing(Intervals(self.prepared))

        def rows(given: Iterable[Any], parameters: Intervals) -> list[Any]:
            every = list(given)
            names = dict(zip((self.vary, *self.free), every[n:], strict=True))
            values = {**balance.arguments(parameters), **balance.with_angles(names, NARROW)}
            at = balance.at(every[:n], values, parameters.shape[1:], NARROW)
            return [entry for row in self._rows(at) for entry in row]

        sizes = n + 1 + len(self.free), len(vanishing)
        try:
            return balance.tapes.tape(("affine", self.vary, *self.free), rows, sizes, vanishing)
        except NotRecorded:
            return None

    def _affine_by_rows(self, given: Affine, tube: Place) -> Affine:
        """The same by NumPy, from the numbers of what moves and is free."""
        shape, n = self.half.shape[1:], self.n
        fixed = zip(self.balance.parameters, self.fixed, strict=True)
        values = {
            name: Affine(row, np.zeros((1, *shape))) if row.any() else 0 for name, row in fixed
        }
        values |= {name: given[n + k] for k, name in enumerate((self.vary, *self.free))}
        q = [given[i] for i in range(n)]
        at = self.balance.at(q, self.balance.arguments_of(values, AFFINE), xp=AFFINE)
        rows = self._rows(replace(at, turnings=self._turnings(tube.box())))
        return Affine.stacked([entry for row in rows for entry in row], shape)

    def _turnings(self, box: Intervals) -> list[Affine]:
        """Angles of torsion springs, from intervals."""
        if not self.balance.torsions:
            return []
        found = self.balance.state(box[:-1], self.bounds(box[-1])).directions
        return list(map(Affine.between, found[3 * self.balance.springs :]))

    def _rows(self, at: Evaluation) -> list[list[Any]]:
        """Derivatives of the forces by row; by the free parameters only where some box has a
        width.
        """
        none = [0] * (len(self.free) - len(self._wide))
        return [[*row, *none] for row in self._slopes(at, self._wide)]

    @property
    def _wide(self) -> tuple[str, ...]:
        """Free parameters, if some box has a width."""
        return self.free if self.half.any() else ()

    def _slopes(self, at: Evaluation, names: Sequence[str]) -> list[list[Any]]:
        """Derivatives of the forces by the coordinates, by what varies and by these parameters."""
        name = "forces_by_parameters"
        rows = self.balance.followed.get(name, name)
        moved = self.balance.by_parameters(at, [self.vary, *names], rows)
        slopes = at.followed("forces_jacobian")
        return [[*row, *more] for row, more in zip(slopes, moved, strict=True)]

    def floats(self, z: FloatArray, slopes: bool = True) -> tuple[FloatArray, FloatArray]:
        """Forces and their slopes in the middle of the boxes, in floats."""
        columns = self.fixed.copy()
        columns[self.moving] = np.vstack([self.centre, z[-1]])
        q = z[:-1]
        if z.shape[1] == 1:  # the same bits by numbers, in a third of the time
            q, columns = q[:, 0], columns[:, 0]
        with quiet():
            at = self.balance.at(list(q), self.balance.floats(columns), xp=np)
            forces, rows = at.followed("forces"), self._rows(at) if slopes else []
        return filled([forces], z.shape[1:])[0], filled(rows, z.shape[1:])

    def _forces(self, z: FloatArray) -> Intervals:
        """Enclosed, in the middle of the boxes."""
        bounds = replace(self, half=np.zeros_like(self.half)).bounds(Intervals.point(z[-1]))
        balance = self.balance

        def rows(q: Sequence[Number], parameters: Intervals) -> Sequence[Any]:
            return balance.state(q, parameters, balance.any_side).followed("forces")

        with quiet():
            return balance.taped("followed", rows, Intervals.point(z[:-1]), bounds)

    def apart(self) -> FloatArray:
        """Largest distance of the free parameters from their middles."""
        if not self.half.any():
            return self.half
        wide = self._span()
        return np.maximum(wide.high - self.centre, self.centre - wide.low) * ROUNDED_UP

    def corrected(self, z: FloatArray) -> FloatArray:
        """Newton's method in the middle of the boxes with a given pivot, the slopes renewed every
        other step.
        """
        others, z, inverse = self.others, np.array(z, order="C"), np.zeros(0)
        if (found := self._tapes) is not None:
            compiled, tapes = found
            steps = self.options.newton_steps
            compiled.corrected(tapes[:2], self._centred, self.pivot, steps, z)
            return z
        for number in range(self.options.newton_steps):
            forces, slopes = self.floats(z, slopes=number % 2 == 0)
            if number % 2 == 0:
                inverse = contractors.inverse(slopes[:, others])
            step = np.einsum("ijN,jN->iN", inverse, forces)
            step = np.where(np.isfinite(step), step, 0.0)
            z[others] -= step
            if (np.abs(step) < 1e-13 * (1 + np.abs(z[others]))).all():
                break
        return z

    def tangents(self, z: FloatArray) -> tuple[FloatArray, FloatArray]:
        """dz/ds and dz/dp in the middle of the boxes."""
        others = self.others
        by_s, by_p = np.ones(z.shape), np.zeros((self.n + 1, *self.half.shape))
        if (found := self._tapes) is not None:
            compiled, tapes = found
            to_p = by_p if self.half.any() else by_p[:, :0]
            at = np.ascontiguousarray(z), by_s, to_p
            compiled.tangents(tapes[:2], self._centred, self.pivot, *at)
            return by_s, by_p
        slopes = self.floats(z)[1]
        inverse = contractors.inverse(slopes[:, others])
        by_s[others] = -np.einsum("ijN,jN->iN", inverse, slopes[:, self.pivot])
        by_p[others] = -np.einsum("ijN,jkN->ikN", inverse, slopes[:, self.n + 1 :])
        return by_s, by_p

    def _across(self, z: FloatArray) -> FloatArray:
        """dz/dp in the middle of the boxes, where they have a width at all."""
        return self.tangents(z)[1] if self.half.any() else np.zeros((self.n + 1, *self.half.shape))

    # ---------------------------------------------------------------------------------------------
    # proofs

    def place(
        self,
        z: FloatArray,
        like: Place | None = None,
        error: FloatArray | float | None = None,
    ) -> Place:
        """The states of whole boxes at one value of the pivot, one for each point of a box; z is
        about those in the middle.

        ``like`` is a place near by, which tells how far from the middle states may lie. With an
        ``error``, over max(1, |coordinate|), z is a state in the middle to within it, and the place
        is sure only where it is proved to be of that state.
        """
        given, others, z = z, self.others, self.corrected(z)
        zero = np.zeros_like(z)
        beside = zero if like is None else like.off * self.half.any(axis=0)
        found = self._one_state(z, zero, self._across(z), zero[0], beside)
        if error is not None:
            # Newton's method may have come to another state, which is proved just as well.
            away = np.abs(z - given)[others] + error * scale_of(given[others])
            found.sure[:] &= (away * ROUNDED_UP <= found.room[others]).all(axis=0)
        return found

    def segment(self, start: Place, z: FloatArray) -> tuple[BoolArray, Place, Place]:
        """From a place to another value of the pivot, about which z is: where that is proved, the
        place there, and the tube.
        """
        end = self.place(z, start)
        z = end.z
        pivot, held = self.pivot, start.held[self.pivot]
        way = z[pivot] - start.z[pivot]
        with quiet():
            along = np.where(way != 0, (z - start.z) / way, 0.0)
        # With another pivot than before the states there lie on either side of the middle.
        wide = np.where(
            held > 0, held * ROUNDED_UP + 2 * np.spacing(np.abs(start.z[pivot]) + held), 0
        )
        begin = start.z - along * np.sign(way) * wide
        middle, half = 0.5 * (begin + z), 0.5 * np.abs(z - begin)[pivot]
        by_p = self._across(middle)
        beside = np.maximum(*(self._beside(one, middle, along, by_p) for one in (start, end)))
        tube = self._one_state(middle, along, by_p, half, beside)
        return tube.sure & end.sure & start.sure & (np.abs(way) >= wide), end, tube

    def _beside(
        self, place: Place, middle: FloatArray, along: FloatArray, by_p: FloatArray
    ) -> FloatArray:
        """Distance of the states of a place from where a tube's middle moves to with the pivot and
        the parameters.
        """
        off, turned, pivot = place.z - middle, place.by_p - by_p, self.pivot
        swing = (np.abs(turned - along[:, None] * turned[pivot]) * self.apart()).sum(axis=1)
        size = np.abs(place.z) + np.abs(middle) + place.held
        moved = (
            np.abs(off - along * off[pivot]) + swing + place.off + np.abs(along) * place.off[pivot]
        )
        out = moved * ROUNDED_UP + 4 * np.spacing(size)
        out[pivot] = 0.0
        return np.where(np.isfinite(out), out, np.inf)

    def _one_state(
        self,
        z: FloatArray,
        along: FloatArray,
        by_p: FloatArray,
        half: FloatArray,
        beside: FloatArray,
    ) -> Place:
        """Boxes that hold one state, in contact, for each value of the pivot and of the parameters,
        where that is proved.

        They hold what lies within ``beside`` of where their middles move; ``half`` is how far the
        pivot does.
        """
        others = self.others
        # The middle is rounded.
        moved = np.where(
            half > 0, half * ROUNDED_UP + np.spacing(np.abs(z[self.pivot]) + half), 0.0
        )
        swing = (np.abs(along) * moved + (np.abs(by_p) * self.apart()).sum(axis=1)) * ROUNDED_UP
        least = 2 * self.options.half_width * scale_of(z[others])
        more = 1 + self.options.inflation
        reach = np.maximum(least, more * beside[others] * self.half.any(axis=0))
        out = Place(
            z,
            along,
            moved,
            by_p,
            swing.copy(),
            np.zeros_like(z),
            np.zeros_like(z),
            np.zeros(half.size, dtype=bool),
        )
        most = np.zeros_like(reach)
        found = None if self.half.any() else self._tapes
        if found is None:
            self._inflate(out, beside, reach, most)
        else:
            compiled, tapes = found
            given = z, along, swing, moved, beside, reach, out.room, most, out.sure
            compiled.tubes(
                tapes,
                tuple(self.balance.borders()),
                self._centred,
                self.pivot,
                more,
                self.options.inflations,
                *map(np.ascontiguousarray, given),
            )
        out.held[others], out.off[others] = (swing[others] + most) * ROUNDED_UP, most * ROUNDED_UP
        return out

    @property
    def _centred(self) -> FloatArray:
        """Ends of the prepared parameters in the middle of the boxes, but for what varies."""
        if not self.free:
            return self.prepared
        moved = dict(zip(self.free, Intervals.point(self.centre), strict=True))
        return self.balance.prepared_beside(self.prepared, self.fixed, moved).ends

    @property
    def _tapes(self) -> tuple[ModuleType, tuple[Any, ...]] | None:
        """Compiled code, and as that takes them forces, slopes, by the free parameters too where
        some box has a width, and gaps, where only what varies moves.
        """
        balance, compiled = self.balance, plans.compiled_for(self.n + 1)
        if balance.factors or compiled is None:
            return None
        vanishing, names = balance.vanishing(Intervals(self._centred)), self._wide

        def given(
            name: str, entries: Callable[[Evaluation], Sequence[Any]]
        ) -> tuple[bytes, bytes, int, int] | None:
            def rows(z: Intervals, parameters: Intervals) -> Sequence[Any]:
                *q, v = z
                moved = balance.with_angles({self.vary: v}, XP)
                values = {**balance.arguments(parameters), **moved}
                at = balance.at(q, values, parameters.shape[1:])
                at.sides = balance.any_side if name == "forces" else None
                return entries(at)

            key, sizes = ("tubes", name, self.vary, *names), (self.n + 1, len(vanishing))
            return plans.given(balance.tapes.tape(key, rows, sizes, vanishing))

        try:
            return compiled, (
                given("forces", lambda at: at.followed("forces")),
                given("slopes", lambda at: [one for row in self._slopes(at, names) for one in row]),
                given("gaps", lambda at: at.gaps()) if balance.borders() else None,
            )
        except NotRecorded:
            return None

    def _inflate(self, out: Place, beside: FloatArray, reach: FloatArray, most: FloatArray) -> None:
        """Make boxes about places, at first as wide as ``reach``, wider until they are proved, and
        ``out`` and ``most`` what is known of those that are.
        """
        others = self.others
        rows = np.arange(out.sure.size)
        swing = out.held
        more = 1 + self.options.inflation
        forces = self._forces(out.z)
        for _ in range(self.options.inflations):
            if not rows.size:
                break
            alone = beside[:, rows]
            alone[others] = np.maximum(reach, alone[others])
            some, tried = self[rows], replace(out[rows], held=swing[:, rows] + alone, off=alone)
            slopes = some.over(tried)
            with quiet():
                step = slopes.newton(
                    slopes.left(forces[:, rows], tried, some.apart()), others, reach
                )
            good = np.isfinite(step).all(axis=(0, 1))
            done = good & contractors.inside(step, reach)
            if done.any():
                here, box = rows[done], tried[done].box()
                out.sure[here] = on_side(
                    self.balance, some[done].bounds(box[-1]), box.ends[:, :-1]
                )[0]
                out.room[:, here], most[:, here] = alone[:, done], np.maximum(*step[:, :, done])
            left = good & ~done
            rows = rows[left]
            reach = more * np.maximum(reach, np.maximum(*np.abs(step)))[:, left]

    def rises(self, tube: Place, by_s: FloatArray) -> FloatArray:
        """Sign of dv/ds for all states in places or tubes, 0 where it is not known; ``by_s`` is
        about dz/ds.
        """
        slopes = self.over(tube)
        solved, _ = self._solved(slopes, slopes.rows[:, self.pivot], by_s)
        return np.where(solved, np.sign(by_s[-1]), 0.0)

    def bends(self, tube: Place, by_s: FloatArray) -> FloatArray:
        """Sign of d²v/ds² for all states in tubes of points, 0 where it is not known; ``by_s`` is
        about dz/ds.

        Where F has second derivatives over the box, F_z z″ + F_zz[z′, z′] = 0.
        """
        if self.free or self.balance.factors:
            return np.zeros(tube.sure.size)
        slopes = self.over(tube)
        _, off = self._solved(slopes, slopes.rows[:, self.pivot], by_s)
        wide, about = np.zeros(by_s.shape), np.zeros(by_s.shape)
        wide[self.others] = off
        by_z = Intervals(ends_around(by_s, wide + np.spacing(np.abs(by_s) + wide)))

        def rows(z: Sequence[Any], by_z: Sequence[Any], parameters: Intervals) -> Sequence[Any]:
            *q, v = (Jet({(): one, (0,): slope}, 2) for one, slope in zip(z, by_z, strict=True))
            values = self.balance.arguments(parameters)
            moved = self.balance.with_angles({self.vary: v}, XP)
            at = self.balance.at(q, {**values, **moved}, parameters.shape[1:])
            return [row.derivative(0, 0) for row in at.rows("forces")]

        with quiet():
            bent = self.balance.taped(
                ("bent", self.vary), rows, tube.box(), by_z, Intervals(self.prepared)
            )
            inverse = contractors.inverse(slopes.rows[:, self.others].middle)
            about[self.others] = -np.einsum("ijN,jN->iN", inverse, bent.middle)
            solved, _ = self._solved(slopes, bent, about)
        return np.where(solved, np.sign(about[-1]), 0.0)

    def _solved(
        self, slopes: Slopes, starts: Any, about: FloatArray
    ) -> tuple[BoolArray, FloatArray]:
        """Where the solutions of slopes · x + starts = 0 for all but the pivot, ``about`` so large,
        have a last one of that sign; how far each may be off, infinite where nothing is known.
        """
        about = about.copy()
        about[self.pivot] = 0.0
        size = np.abs(about[-1])
        reach = np.tile(0.1 * size + 1e-12, (self.n, 1))
        off = np.full(reach.shape, np.inf)
        with quiet():
            left = slopes.image(about, starts)
            for _ in range(self.options.inflations):
                if np.isfinite(off).all():
                    break
                # v is the last of what follows a coordinate.
                step = slopes.newton(left, self.others, reach)
                most = np.maximum(*step)
                off = np.where(contractors.inside(step, reach), np.fmin(off, most), off)
                reach = (1 + self.options.inflation) * np.maximum(reach, most)
        return off[-1] * ROUNDED_UP < size, off

    # ---------------------------------------------------------------------------------------------
    # the way

    def followed(
        self,
        start: Place,
        goal: FloatArray,
        least: float | None = None,
        needless: Callable[[Place], BoolArray] | None = None,
    ) -> Place:
        """The state as ``vary`` moves to a goal: the last places that are proved, at the goal where
        all of the way is.

        ``needless`` says of the places where they stand which of them need not be followed farther;
        it is asked at first, and when some have come to their goals.
        """
        here = start[np.arange(goal.size)]
        way = goal - here.v
        step = self.options.first_step * way
        least = self.options.least_step if least is None else least
        open_, arrived = here.sure.copy(), -1
        for _ in range(self.options.steps):
            there = here.v == goal
            if needless is not None and there.sum() > arrived:
                open_ &= ~needless(here)
                arrived = there.sum()
            rows = np.flatnonzero(open_ & ~there & (np.abs(step) >= least * np.abs(way)))
            if not rows.size:
                break
            at = here[rows]
            z, rest = at.z.copy(), goal[rows] - at.v
            z[-1] = np.where(np.abs(step[rows]) >= np.abs(rest), goal[rows], at.v + step[rows])
            good, end, _ = self[rows].segment(at, z)
            here.scatter(rows[good], end[good])
            step[rows] = np.where(good, 2 * step[rows], 0.25 * (z[-1] - at.v))
        return here


def in_turn(
    balance: Balance, goals: Iterable[tuple[str, FloatArray]], at: FloatArray, place: Place
) -> tuple[Place, BoolArray]:
    """The states of a place where one parameter after the other has moved from its value in ``at``,
    all parameters of shape (P, N), to its goal; and where all of the way is proved.
    """
    at, proved = at.copy(), np.ones(at.shape[1], dtype=bool)
    for name, goal in goals:
        row, tubes = balance.parameters.index(name), Tubes.of_points(balance, name, at)
        start = tubes.place(np.vstack([place.z[:-1], at[row]]))
        proved &= start.lies_in(place)
        place = tubes.followed(start, goal)
        proved &= place.v == goal
        at[row] = goal
    return place, proved
