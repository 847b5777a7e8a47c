"""Proved tubes around curves of states (validated continuation), for boxes of parameters.

A point of a curve is z = (q, v): the coordinates and the parameter that moves. One component of z
is the pivot s, of which the others are functions. The pivot is v itself, or a coordinate to pass a
fold. With a point m, and with parameters p in a box with middle c, the mean value theorem gives

    z = m + d s + D (p − c) + u,   F(m, c) + (F_z d) s + (F_z D + F_p) (p − c) + F_z u = 0,

where slopes are enclosed over the whole box. If d and D approximate the derivatives of the curve by
s and p, the two terms in the middle are small. Interval Newton in u then proves that the box holds
one state, and only one, for each s and each p. Two tubes belong to the same curve if the states at
the end of one lie in the box of the next.

Slopes over a box of parameters use affine arithmetic. It keeps the dependence of state and slopes
on the parameters to first order; intervals would treat every entry of the matrix as independent.
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

#: Factor that makes a sum of a few products of nonnegative floats an upper bound.
ROUNDED_UP = 1 + 2.0**-40


def sizes_of(z: FloatArray, least: float) -> FloatArray:
    """Sizes of coordinates and of the parameter that varies, z of shape (n + 1, …), at least the
    share ``least`` of 1, or of a smaller unit where all coordinates, or that parameter, are far
    below 1.
    """
    sizes = np.abs(z)
    for part in (sizes[:-1], sizes[-1:]):
        # Coordinates of 0.01 are usual where lengths are 1; a coordinate of 0 tells no unit.
        unit = np.minimum(np.maximum(2.0**9 * part.max(axis=0), 1e-6), 1.0)
        np.maximum(part, least * unit, out=part)
    return sizes


def halves(
    low: FloatArray, high: FloatArray, weight: FloatArray, share: float = 0.5
) -> tuple[IntArray, FloatArray, FloatArray]:
    """Boxes cut in two across the side of largest weight, at a ``share`` of it; one box in each
    column.

    Returns the number of the side, the upper ends of the lower part and the lower ends of the upper
    part. A side too short to be cut in floats is chosen last.
    """
    column = np.arange(low.shape[1])
    weighted = slice(len(weight))
    has_floats = np.nextafter(low[weighted], np.inf) < high[weighted]
    side = np.where(has_floats, weight, -1.0).argmax(axis=0)
    cut = (1 - share) * low[side, column] + share * high[side, column]
    top, bottom = high.copy(), low.copy()
    top[side, column], bottom[side, column] = cut, cut
    return side, top, bottom


@dataclass(frozen=True)
class Place(ByColumn):
    """States for boxes of parameters, at one value of the pivot or along a tube.

    The states lie near the linear prediction z + d s + D (p − c), |s| ≤ ``half_pivot``, where d is
    ``by_s``, the slopes by the pivot, and D is ``by_p``. At a single value of the pivot,
    ``half_pivot`` is 0. If ``proved``, for each s and p

    - one state lies within ``remainder`` of the prediction, and within ``half_width`` of z,
    - no other state lies within ``radius`` of the prediction.

    The shape is (n + 1, N) for ``z``, ``by_s``, ``half_width``, ``remainder`` and ``radius``, (N,)
    for ``half_pivot`` and ``proved``, and (n + 1, free, N) for ``by_p``.
    """

    z: FloatArray
    by_s: FloatArray
    half_pivot: FloatArray
    by_p: FloatArray
    half_width: FloatArray
    remainder: FloatArray
    radius: FloatArray
    proved: BoolArray

    @property
    def v(self) -> FloatArray:
        """Values of the parameter that moves."""
        return self.z[-1]

    def box(self) -> Intervals:
        """Boxes that hold all states; a component that does not vary is a point."""
        half = self.half_width
        rounding = np.where(half > 0, np.spacing(np.abs(self.z) + half), 0.0)
        return Intervals(ends_around(self.z, half + rounding))

    def lies_in(
        self, other: Place, shift: FloatArray | float = 0.0, spread: FloatArray | float = 0.0
    ) -> BoolArray:
        """Whether the states are proved to be those of the ``other`` place, by their coordinates.

        ``shift`` is the change of the other's states between the two middles. ``spread`` bounds the
        difference that the slopes of the two make over the box of parameters.
        """
        distance = np.abs(self.z - other.z - shift) + spread
        largest = (
            distance * ROUNDED_UP
            + self.remainder * ROUNDED_UP
            + 2 * np.spacing(np.abs(self.z) + np.abs(other.z) + self.half_width + np.abs(shift))
        )
        return self.proved & other.proved & (largest[:-1] <= other.radius[:-1]).all(axis=0)

    def numbers(self, apart: FloatArray) -> Affine:
        """z in affine arithmetic; the terms are of s, of each p over its half-width, and of each u.

        ``apart`` are the half-widths of the free parameters.
        """
        size, free, count = self.by_p.shape
        terms = np.zeros((1 + free + size, size, count))
        terms[0] = self.by_s * self.half_pivot
        terms[1 : 1 + free] = np.moveaxis(self.by_p * apart, 1, 0)
        terms[1 + free + np.arange(size), np.arange(size)] = self.remainder
        return Affine(self.z, terms, 2 * UNIT * np.abs(terms).sum(axis=0))


@dataclass(frozen=True)
class Slopes:
    """Rows of slopes by q, v and the free parameters, shape (n, n + 1 + free, N).

    They are intervals, or affine numbers that have been multiplied by the preconditioner ``Y``.
    Other numbers of the rows must be multiplied by ``Y`` too.
    """

    rows: Any
    Y: FloatArray | None = None

    def taken(self, value: Intervals | Affine) -> Intervals:
        """Numbers of the type of the rows, as intervals."""
        return value if isinstance(value, Intervals) else value.interval()

    def left(self, forces: Intervals, tube: Place, apart: FloatArray) -> Intervals:
        """Residuals along a tube without the term in u: F(m, c) + (F_z d) s + (F_z D + F_p) (p −
        c).

        ``apart`` are the half-widths of the free parameters.
        """
        if self.Y is not None:
            forces = Intervals(contractors.product(self.Y, forces.ends[:, :, None])[:, :, 0])
        half_pivot, half_widths = (Intervals(pair(part, part)) for part in (tube.half_pivot, apart))
        total = forces + self.image(tube.by_s) * half_pivot
        for k, half in enumerate(half_widths):
            total = total + self.image(tube.by_p[:, k], self.rows[:, len(tube.by_s) + k]) * half
        return total

    def image(self, direction: FloatArray, start: Intervals | Affine | None = None) -> Intervals:
        """The rows times a vector, shape (n + 1, N), plus ``start``.

        Components that are 0 in all boxes are left out.
        """
        total = self.rows[:, 0] * 0 if start is None else start
        for j, part in enumerate(direction):
            if part.any():
                total = total + self.rows[:, j] * part
        return self.taken(total)

    def newton(self, left: Intervals, others: Sequence[int], reach: FloatArray) -> FloatArray:
        """Ends of one interval Newton step for the unknowns ``others``, within ``reach`` of 0.

        ``left`` are the residuals of :meth:`left`.
        """
        lines = left, self.taken(self.rows[:, others]), np.zeros_like(reach), reach
        if self.Y is None:
            return contractors.newton(*lines).ends
        return contractors.by_rows(*lines)


@dataclass(frozen=True)
class Tubes(ByColumn):
    """Curves of states of a model as the parameter ``vary`` moves, one for each of N boxes of
    parameters.

    ``fixed`` are all parameters, shape (parameters, N), and ``prepared`` the ends of the arguments
    that follow from them, shape (2, arguments, N). ``centre`` and ``half`` are middle and
    half-width of the ``free`` parameters, which may have a width, shape (free, N). ``pivot`` is the
    index of the pivot in z; the index n is that of ``vary``.
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
        """Tubes for single points of the parameters; the pivot is the parameter that moves."""
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
        """Indices, among the model's parameters, of the free ones and of ``vary``."""
        return [self.balance.parameters.index(name) for name in (*self.free, self.vary)]

    @property
    def others(self) -> list[int]:
        """Indices in z of the unknowns that are functions of the pivot."""
        return [each for each in range(self.n + 1) if each != self.pivot]

    # ---------------------------------------------------------------------------------------------
    # evaluation

    def bounds(self, v: Intervals) -> Intervals:
        """Prepared parameters over the boxes, for values ``v`` of the parameter that moves."""
        moved = dict(zip(self.free, self._span(), strict=True)) | {self.vary: v}
        return self.balance.prepared_beside(self.prepared, self.fixed, moved)

    def _span(self) -> Intervals:
        """Enclosures of the free parameters."""
        wide = np.where(
            self.half > 0, self.half * ROUNDED_UP + np.spacing(np.abs(self.centre)), 0.0
        )
        return Intervals(ends_around(self.centre, wide))

    def slopes(self, z: Intervals) -> Intervals:
        """Slopes of the forces by q, v and the free parameters over boxes, shape (n, n + 1 + free,
        N), by interval arithmetic.
        """

        def rows(q: Sequence[Number], parameters: Intervals) -> list[Any]:
            return [entry for row in self._rows(self.balance.state(q, parameters)) for entry in row]

        key = "slopes along", self.vary, self.free, bool(self.half.any())
        with quiet():
            found = self.balance.taped(key, rows, z[:-1], self.bounds(z[-1]))
        shape = 2, self.n, found.shape[0] // self.n, *found.shape[1:]
        return Intervals(found.ends.reshape(shape))

    def over(self, tube: Place) -> Slopes:
        """Slopes over places or tubes.

        Where parameters have a width, they are affine, and multiplied by the inverse of their
        midpoints for all unknowns but the pivot before they become intervals.
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
        recorded = self._affine_tape
        if recorded is not None:
            found = affine.evaluated(recorded, given, Intervals(self.prepared))
        else:
            found = self._affine_by_rows(given, tube)
        shape = self.n, self.n + 1 + free, count
        terms = found.terms.reshape(-1, *shape)
        return Affine(found.value.reshape(shape), terms, found.error.reshape(shape))

    @property
    def _affine_tape(self) -> Tape | None:
        """Tape of the slopes for affine numbers; None where there is none.

        That is so with units among the parameters, and with torsion springs, whose angles are
        intervals.
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
        """Entries of the slopes by NumPy, without a tape; ``given`` are z and the free
        parameters.
        """
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
        """Angles of torsion springs over a box, by interval arithmetic."""
        if not self.balance.torsions:
            return []
        found = self.balance.state(box[:-1], self.bounds(box[-1])).directions
        return list(map(Affine.between, found[3 * self.balance.springs :]))

    def _rows(self, at: Evaluation) -> list[list[Any]]:
        """Rows of derivatives of the forces; those by free parameters are 0 if no box has a
        width.
        """
        none = [0] * (len(self.free) - len(self._wide))
        return [[*row, *none] for row in self._slopes(at, self._wide)]

    @property
    def _wide(self) -> tuple[str, ...]:
        """The free parameters if some box has a width, else none."""
        return self.free if self.half.any() else ()

    def _slopes(self, at: Evaluation, names: Sequence[str]) -> list[list[Any]]:
        """Rows of derivatives of the forces by the coordinates, by ``vary`` and by the named
        parameters.
        """
        name = "forces_by_parameters"
        rows = self.balance.followed.get(name, name)
        moved = self.balance.by_parameters(at, [self.vary, *names], rows)
        slopes = at.followed("forces_jacobian")
        return [[*row, *more] for row, more in zip(slopes, moved, strict=True)]

    def floats(self, z: FloatArray, slopes: bool = True) -> tuple[FloatArray, FloatArray]:
        """Forces and their slopes as floats, at z and the middles of the boxes of parameters."""
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
        """Enclosures of the forces at z and the middles of the boxes of parameters."""
        bounds = replace(self, half=np.zeros_like(self.half)).bounds(Intervals.point(z[-1]))
        balance = self.balance

        def rows(q: Sequence[Number], parameters: Intervals) -> Sequence[Any]:
            return balance.state(q, parameters, balance.any_side).followed("forces")

        with quiet():
            return balance.taped("followed", rows, Intervals.point(z[:-1]), bounds)

    def apart(self) -> FloatArray:
        """Upper bounds of the distances of the free parameters from their middles."""
        if not self.half.any():
            return self.half
        wide = self._span()
        return np.maximum(wide.high - self.centre, self.centre - wide.low) * ROUNDED_UP

    def corrected(self, z: FloatArray) -> FloatArray:
        """States at the pivots of ``z``, by Newton's method in the middles of the boxes of
        parameters.

        The Jacobian is computed at every other step.
        """
        others, z, inverse = self.others, np.array(z, order="C"), np.zeros(0)
        found = self._tapes
        if found is not None:
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
        """Derivatives dz/ds and dz/dp of the curves, in the middles of the boxes of parameters."""
        others = self.others
        by_s, by_p = np.ones(z.shape), np.zeros((self.n + 1, *self.half.shape))
        found = self._tapes
        if found is not None:
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
        """dz/dp in the middles of the boxes; 0 if no box has a width."""
        return self.tangents(z)[1] if self.half.any() else np.zeros((self.n + 1, *self.half.shape))

    # ---------------------------------------------------------------------------------------------
    # proofs

    def place(
        self,
        z: FloatArray,
        like: Place | None = None,
        error: FloatArray | float | None = None,
    ) -> Place:
        """The proved states of the boxes at one value of the pivot; ``z`` is near those in the
        middles.

        ``like`` is a place nearby, whose ``remainder`` suggests how wide the new one must be. With
        ``error``, relative to max(1, |coordinate|), ``z`` is the state in the middle to within that
        error, and the place is proved only if it holds that state.
        """
        given, others, z = z, self.others, self.corrected(z)
        zero = np.zeros_like(z)
        beside = zero if like is None else like.remainder * self.half.any(axis=0)
        if error is not None:
            distance = np.abs(z - given) + error * scale_of(given)
            distance[self.pivot] = 0.0
            beside = np.maximum(beside, 2 * distance)
        found = self._one_state(z, zero, self._across(z), zero[0], beside)
        if error is not None:
            # Newton's method may have converged to another state.
            found.proved[:] &= (distance * ROUNDED_UP <= found.radius)[others].all(axis=0)
        return found

    def segment(self, start: Place, z: FloatArray) -> tuple[BoolArray, Place, Place]:
        """The tube from a place to another value of the pivot, given by ``z`` near the states
        there.

        Returns where it is proved, the place at its end, and the tube.
        """
        end = self.place(z, start)
        z = end.z
        pivot, spread = self.pivot, start.half_width[self.pivot]
        change = z[pivot] - start.z[pivot]
        with quiet():
            by_s = np.where(change != 0, (z - start.z) / change, 0.0)
        # After a change of the pivot, its values at the start are spread about the middle.
        overlap = np.where(
            spread > 0,
            spread * ROUNDED_UP + 2 * np.spacing(np.abs(start.z[pivot]) + spread),
            0,
        )
        begin = start.z - by_s * np.sign(change) * overlap
        middle, half = 0.5 * (begin + z), 0.5 * np.abs(z - begin)[pivot]
        by_p = self._across(middle)
        beside = np.maximum(*(self._beside(one, middle, by_s, by_p) for one in (start, end)))
        tube = self._one_state(middle, by_s, by_p, half, beside)
        return tube.proved & end.proved & start.proved & (np.abs(change) >= overlap), end, tube

    def _beside(
        self, place: Place, middle: FloatArray, by_s: FloatArray, by_p: FloatArray
    ) -> FloatArray:
        """Bound on the distance of a place's states from the linear prediction of a tube.

        The prediction starts at the tube's ``middle``, with slopes ``by_s`` and ``by_p``.
        """
        pivot = self.pivot
        offset = place.z - middle
        difference = place.by_p - by_p
        swing = (np.abs(difference - by_s[:, None] * difference[pivot]) * self.apart()).sum(axis=1)
        size = np.abs(place.z) + np.abs(middle) + place.half_width
        distance = (
            np.abs(offset - by_s * offset[pivot])
            + swing
            + place.remainder
            + np.abs(by_s) * place.remainder[pivot]
        )
        out = distance * ROUNDED_UP + 4 * np.spacing(size)
        out[pivot] = 0.0
        return np.where(np.isfinite(out), out, np.inf)

    def _one_state(
        self,
        z: FloatArray,
        by_s: FloatArray,
        by_p: FloatArray,
        half: FloatArray,
        beside: FloatArray,
    ) -> Place:
        """Places with one state, on the contact's side, for each value of the pivot and of the
        parameters; ``proved`` says where that holds.

        ``z``, ``by_s`` and ``by_p`` are those of the places, and ``half`` is the half-length of the
        range of the pivot. Boxes are at least as wide as ``beside`` around the linear prediction.
        """
        others = self.others
        half_pivot = np.where(  # the middle is rounded
            half > 0, half * ROUNDED_UP + np.spacing(np.abs(z[self.pivot]) + half), 0.0
        )
        by_pivot = np.abs(by_s) * half_pivot
        swing = (by_pivot + (np.abs(by_p) * self.apart()).sum(axis=1)) * ROUNDED_UP
        least = 2 * self.options.half_width * sizes_of(z, 1.0)[others]
        more = 1 + self.options.inflation
        reach = np.maximum(least, more * beside[others] * self.half.any(axis=0))
        zero, none = np.zeros_like(z), np.zeros(half.size, dtype=bool)
        out = Place(z, by_s, half_pivot, by_p, swing.copy(), zero, zero.copy(), none)
        most = np.zeros_like(reach)
        found = None if self.half.any() else self._tapes
        if found is None:
            self._inflate(out, beside, reach, most)
        else:
            compiled, tapes = found
            given = z, by_s, swing, half_pivot, beside, reach, out.radius, most, out.proved
            compiled.tubes(
                tapes,
                tuple(self.balance.borders()),
                self._centred,
                self.pivot,
                more,
                self.options.inflations,
                *map(np.ascontiguousarray, given),
            )
        out.half_width[others] = (swing[others] + most) * ROUNDED_UP
        out.remainder[others] = most * ROUNDED_UP
        return out

    @property
    def _centred(self) -> FloatArray:
        """Ends of the prepared parameters, at the middles of the free ones."""
        if not self.free:
            return self.prepared
        moved = dict(zip(self.free, Intervals.point(self.centre), strict=True))
        return self.balance.prepared_beside(self.prepared, self.fixed, moved).ends

    @property
    def _tapes(self) -> tuple[ModuleType, tuple[Any, ...]] | None:
        """Compiled code and its tapes of forces, slopes and gaps; None where something can't be
        recorded.

        Slopes by free parameters are among them only if some box has a width.
        """
        balance, compiled = self.balance, plans.compiled_for(self.n + 1)
        if balance.factors or compiled is None:
            return None
        vanishing, names = balance.vanishing(Intervals(self._centred)), self._wide

        def packed(
            name: str, entries: Callable[[Evaluation], Sequence[Any]]
        ) -> tuple[bytes, bytes, int, int] | None:
            def rows(z: Iterable[Any], parameters: Intervals) -> Sequence[Any]:
                at = self._at(z, parameters)
                at.sides = balance.any_side if name == "forces" else None
                return entries(at)

            key, sizes = ("tubes", name, self.vary, *names), (self.n + 1, len(vanishing))
            return plans.packed(balance.tapes.tape(key, rows, sizes, vanishing))

        try:
            return compiled, (
                packed("forces", lambda at: at.followed("forces")),
                packed(
                    "slopes", lambda at: [one for row in self._slopes(at, names) for one in row]
                ),
                packed("gaps", lambda at: at.gaps()) if balance.borders() else None,
            )
        except NotRecorded:
            return None

    def _at(self, z: Iterable[Any], parameters: Intervals) -> Evaluation:
        """The evaluation at z = (q, v), numbers of any type, with prepared parameters."""
        *q, v = z
        moved = self.balance.with_angles({self.vary: v}, XP)
        values = {**self.balance.arguments(parameters), **moved}
        return self.balance.at(q, values, parameters.shape[1:])

    def _inflate(self, out: Place, beside: FloatArray, reach: FloatArray, most: FloatArray) -> None:
        """Prove boxes around places, by interval Newton steps with ε-inflation.

        Boxes begin with the half-widths ``reach`` and grow until they are proved. Fills in
        ``proved`` and ``radius`` of ``out``, and ``most``, the half-widths of the boxes that hold
        the states.
        """
        others = self.others
        rows = np.arange(out.proved.size)
        swing = out.half_width
        more = 1 + self.options.inflation
        forces = self._forces(out.z)
        for _ in range(self.options.inflations):
            if not rows.size:
                break
            radius = beside[:, rows]
            radius[others] = np.maximum(reach, radius[others])
            half_width = swing[:, rows] + radius
            tubes, tried = self[rows], replace(out[rows], half_width=half_width, remainder=radius)
            slopes = tubes.over(tried)
            with quiet():
                residual = slopes.left(forces[:, rows], tried, tubes.apart())
                step = slopes.newton(residual, others, reach)
            finite = np.isfinite(step).all(axis=(0, 1))
            unique = finite & contractors.inside(step, reach)
            if unique.any():
                proved, box = rows[unique], tried[unique].box()
                inside, _ = on_side(self.balance, tubes[unique].bounds(box[-1]), box.ends[:, :-1])
                out.proved[proved], out.radius[:, proved] = inside, radius[:, unique]
                most[:, proved] = np.maximum(*step[:, :, unique])
            wider = finite & ~unique
            rows = rows[wider]
            reach = more * np.maximum(reach, np.maximum(*np.abs(step)))[:, wider]

    def rises(self, tube: Place, by_s: FloatArray) -> FloatArray:
        """Sign of dv/ds for all states in places or tubes, 0 if not proved; ``by_s`` approximates
        dz/ds.
        """
        slopes = self.over(tube)
        solved, _ = self._solved(slopes, slopes.rows[:, self.pivot], by_s, tube.z)
        return np.where(solved, np.sign(by_s[-1]), 0.0)

    def bends(self, tube: Place, by_s: FloatArray) -> FloatArray:
        """Sign of d²v/ds² for all states in tubes of points, 0 if not proved; ``by_s`` approximates
        dz/ds.

        The second derivative z″ solves F_z z″ + F_zz[z′, z′] = 0, where F has second derivatives
        over the box.
        """
        if self.free or self.balance.factors:
            return np.zeros(tube.proved.size)
        slopes = self.over(tube)
        _, error = self._solved(slopes, slopes.rows[:, self.pivot], by_s, tube.z)
        wide, about = np.zeros(by_s.shape), np.zeros(by_s.shape)
        wide[self.others] = error
        by_z = Intervals(ends_around(by_s, wide + np.spacing(np.abs(by_s) + wide)))

        def rows(z: Sequence[Any], by_z: Sequence[Any], parameters: Intervals) -> Sequence[Any]:
            jets = (Jet({(): one, (0,): slope}, 2) for one, slope in zip(z, by_z, strict=True))
            return [row.derivative(0, 0) for row in self._at(jets, parameters).rows("forces")]

        with quiet():
            bent = self.balance.taped(
                ("bent", self.vary), rows, tube.box(), by_z, Intervals(self.prepared)
            )
            inverse = contractors.inverse(slopes.rows[:, self.others].middle)
            about[self.others] = -np.einsum("ijN,jN->iN", inverse, bent.middle)
            solved, _ = self._solved(slopes, bent, about, tube.z)
        return np.where(solved, np.sign(about[-1]), 0.0)

    def _solved(
        self, slopes: Slopes, starts: Intervals | Affine, about: FloatArray, z: FloatArray
    ) -> tuple[BoolArray, FloatArray]:
        """Whether the last component of x is proved to have the sign of ``about``, and error bounds
        of x.

        x solves slopes · x + starts = 0; its component of the pivot is 0. ``about`` approximates x.
        A bound is infinite where nothing is proved. The states are near z, whose components may be
        of very different sizes.
        """
        about = about.copy()
        about[self.pivot] = 0.0
        size, units = np.abs(about[-1]), sizes_of(z, 1.0)
        reach = (0.1 * size + 1e-12) * (units / units[-1])[self.others]
        error = np.full(reach.shape, np.inf)
        with quiet():
            residual = slopes.image(about, starts)
            for _ in range(self.options.inflations):
                if np.isfinite(error).all():
                    break
                step = slopes.newton(residual, self.others, reach)
                most = np.maximum(*step)
                error = np.where(contractors.inside(step, reach), np.fmin(error, most), error)
                reach = (1 + self.options.inflation) * np.maximum(reach, most)
        return error[-1] * ROUNDED_UP < size, error

    # ---------------------------------------------------------------------------------------------
    # continuation

    def followed(
        self,
        start: Place,
        goal: FloatArray,
        least: float | None = None,
        needless: Callable[[Place], BoolArray] | None = None,
    ) -> Place:
        """The states as ``vary`` moves from a place to a goal: the last proved place of each.

        It is at the goal where the whole way is proved. Steps are doubled after a success and
        quartered after a failure. ``needless`` marks places that need not be followed farther; it
        is asked at the start, and whenever more of them have reached their goals.
        """
        here = start[np.arange(goal.size)]
        distance = goal - here.v
        step = self.options.first_step * distance
        least = self.options.least_step if least is None else least
        open_, arrived = here.proved.copy(), -1
        for _ in range(self.options.steps):
            reached = here.v == goal
            if needless is not None and reached.sum() > arrived:
                open_ &= ~needless(here)
                arrived = reached.sum()
            rows = np.flatnonzero(open_ & ~reached & (np.abs(step) >= least * np.abs(distance)))
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
    """The states of a place after one parameter after the other has moved to its goal.

    ``at`` are all parameters at the start, shape (P, N), and ``goals`` names and new values. Also
    returns where all of it is proved.
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
