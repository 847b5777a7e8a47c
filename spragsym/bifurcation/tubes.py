"""Tubes around curves of states, proved: boxes that hold one state for each value of what moves, for whole boxes of parameters.

A point of a curve is z = (q, v): the coordinates, and the parameter that moves. One of these is the pivot s, which the others
follow: v itself, or a coordinate where a fold is to be passed. About a middle m, with the parameters p about their middle c,

    z = m + d s + D (p − c) + u,   F(m, c) + (F_z d) s + (F_z D + F_p) (p − c) + F_z u = 0,

by the mean value theorem with slopes over the whole box. Where d and D are near the curve's own slopes, little is left of the
two terms in the middle, and interval Newton in u proves that each s and each p have one state in the box, and only one.
Segments hold together where the set of states at the end of one lies in the box of the next.

The state moves with the parameters, and slopes depend on both. Affine arithmetic keeps that to first order, so that over a box
little more is left than slopes really vary by; intervals would take each entry of the matrix for its own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Any, Self

import numpy as np

from ..numerics import contractors
from ..numerics.affine import AFFINE, UNIT, Affine
from ..numerics.arithmetic import Matrix
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals, Shape, matrix, stacked
from ..statics.balance import Balance
from ..statics.forces import State
from ..statics.precise_balance import on_side

#: The first step over the whole way, the least one, and most steps.
FIRST, LEAST, MOST = 2.0**-5, 2.0**-14, 400
#: Half-width of a box at least, over its size; how often it is made wider, and by how much of its width.
NARROW, INFLATIONS, ROOM = 1e-9, 6, 0.1
#: Steps of Newton's method at the end of a step.
STEPS = 6
#: A slope that is not nothing.
TINY = 1e-12
#: A sum of a few products of floats, rounded up.
UP = 1 + 2.0**-40


@dataclass(frozen=True)
class ByColumn:
    """Arrays of which each column, along the last axis, is of one box; what is no array is of all."""

    def __getitem__(self, rows: Any) -> Self:
        return self._made(lambda part: part[rows] if isinstance(part, ByColumn) else part[..., rows])

    def then(self, others: Self) -> Self:
        """These, and others."""

        def joined(one: Any, other: Any) -> Any:
            return one.then(other) if isinstance(one, ByColumn) else np.concatenate([one, other], axis=-1)

        return self._made(joined, others)

    def _made(self, of: Callable[..., Any], *others: Self) -> Self:
        parts = {field.name: [getattr(each, field.name) for each in (self, *others)] for field in fields(self)}
        return replace(self, **{name: of(*each) for name, each in parts.items() if not isinstance(each[0], Mapping)})


def halves(low: FloatArray, high: FloatArray, weight: FloatArray) -> tuple[IntArray, FloatArray, FloatArray]:
    """Boxes, one a column, cut in the middle of their side of most weight: its number, and the
    upper ends of one half and the lower ones of the other.

    A side between whose ends there is no float is cut last.
    """
    column = np.arange(low.shape[1])
    some = slice(len(weight))
    side = np.where(np.nextafter(low[some], np.inf) < high[some], weight, -1.0).argmax(axis=0)
    middle = 0.5 * (low[side, column] + high[side, column])
    top, bottom = high.copy(), low.copy()
    top[side, column], bottom[side, column] = middle, middle
    return side, top, bottom


@dataclass(frozen=True)
class Parts(ByColumn):
    """Boxes of parameters, one a column: all of them, and middle and half-width of those that have a width or move.

    ``fixed`` has the shape (parameters, N), ``centre`` and ``half`` have (free, N).
    """

    fixed: FloatArray
    centre: FloatArray
    half: FloatArray

    @classmethod
    def points(cls, fixed: FloatArray) -> Parts:
        """Parameters of which none has a width."""
        nothing = np.zeros((0, fixed.shape[1]))
        return cls(fixed, nothing, nothing)

    def middles(self) -> Parts:
        """Regions of zero width: their midpoints."""
        return replace(self, half=np.zeros_like(self.half))


@dataclass(frozen=True)
class Place(ByColumn):
    """Where tubes stand: the middle z of the states there, how far the states of a box lie from it at most, and slopes D.

    Within ``room`` of z + D (p − c) each point p of the box has one state and no other, which lies within ``off`` of it, and
    within ``held`` of the middle. ``z``, ``held``, ``off`` and ``room`` have the shape (n + 1, N), ``by_p`` has (n + 1, free, N);
    ``sure`` where it is proved.
    """

    z: FloatArray
    held: FloatArray
    off: FloatArray
    room: FloatArray
    by_p: FloatArray
    sure: BoolArray

    def put(self, rows: Any, other: Place) -> None:
        """Take the places of some rows over."""
        for field in fields(self):
            getattr(self, field.name)[..., rows] = getattr(other, field.name)

    def box(self) -> Intervals:
        """All states there."""
        return Intervals(np.stack([-self.z, self.z]) + self.held + np.spacing(np.abs(self.z) + self.held))

    def region(self) -> Region:
        """The region over which slopes are evaluated."""
        return Region(self.box(), self.z, np.zeros_like(self.z), np.zeros(self.z.shape[1]), self.by_p, self.off)

    def lies_in(self, other: Place, n: int, shift: Any = 0.0, turned: Any = 0.0) -> BoolArray:
        """Whether its states are those of another place, which holds for all its parameters: by their n coordinates.

        ``shift`` is how far the states of the other move from its middle to this one's, ``turned`` how much the slopes of the
        two differ by over the box.
        """
        apart = np.abs(self.z - other.z - shift) + turned
        within = apart * UP + self.off * UP + 2 * np.spacing(np.abs(self.z) + np.abs(other.z) + self.held + np.abs(shift))
        return self.sure & other.sure & (within[:n] <= other.room[:n]).all(axis=0)


@dataclass(frozen=True)
class Region(ByColumn):
    """States z = m + a s + D (p − c) + u of boxes of parameters p, |s| ≤ moved and |u| ≤ off; ``box`` holds all of them.

    ``middle``, ``along`` and ``off`` have the shape (n + 1, N), ``moved`` (N,), ``by_p`` (n + 1, free, N).
    """

    box: Intervals
    middle: FloatArray
    along: FloatArray
    moved: FloatArray
    by_p: FloatArray
    off: FloatArray

    def numbers(self, apart: FloatArray) -> list[Affine]:
        """The coordinates and what moves, with s, then each p over its half-width, then each u for the sides."""
        size, free, count = self.by_p.shape
        found = []
        for i in range(size):
            terms = np.zeros((1 + free + size, count))
            terms[0], terms[1 : 1 + free], terms[1 + free + i] = self.along[i] * self.moved, self.by_p[i] * apart, self.off[i]
            found.append(Affine(self.middle[i], terms, 2 * UNIT * np.abs(terms).sum(axis=0)))
        return found


@dataclass(frozen=True)
class Slopes:
    """Rows of slopes by q, v and the free parameters: intervals, or affine numbers that ``Y`` has multiplied.

    ``zero`` is the 0 of their type; what belongs to the rows beside slopes ``Y`` multiplies as well.
    """

    rows: Matrix
    zero: Any
    Y: FloatArray | None = None

    def taken(self, value: Any) -> Intervals:
        """A number of the type as an interval."""
        return value if self.Y is None else value.interval()

    def forces(self, found: Intervals) -> Intervals:
        """Forces, shape (n, N), as these rows have them."""
        return found if self.Y is None else Intervals(contractors.product(self.Y, found.ends[:, :, None])[:, :, 0])

    def image(self, row: int, direction: FloatArray, start: Any = None) -> Any:
        """A row times a vector, shape (n + 1, N), and more: what is 0 for all boxes is left out."""
        terms = (self.rows[row][j] * part for j, part in enumerate(direction) if part.any())
        return sum(terms, self.zero if start is None else start)

    def newton(self, left: Sequence[Intervals], others: Sequence[int], reach: FloatArray) -> FloatArray:
        """Ends of a step of interval Newton for the unknowns ``others`` from what is left of the forces."""
        shape = reach.shape[1:]
        entries = matrix([[self.taken(row[j]) for j in others] for row in self.rows], shape)
        given = stacked(left, shape), entries, np.zeros_like(reach), reach
        return contractors.newton(*given).ends if self.Y is None else contractors.by_rows(*given)


def of_affine(rows: Matrix, others: Sequence[int], shape: Shape) -> Slopes:
    """Slopes from rows of affine numbers, multiplied by the inverse of their midpoints before they become intervals."""
    middles = np.array([[_middle(row[j], shape) for j in others] for row in rows])
    Y, zero = contractors.inverse(middles), Affine(np.zeros(shape), np.zeros((1, *shape)))
    n = range(len(rows))
    return Slopes([[sum((rows[k][j] * Y[i, k] for k in n), zero) for j in range(len(rows[0]))] for i in n], zero, Y)


def _middle(entry: Any, shape: Shape) -> FloatArray:
    return np.broadcast_to(entry.value if isinstance(entry, Affine) else float(entry), shape)


def beside_tube(
    place: Place, middle: FloatArray, along: FloatArray, by_p: FloatArray, apart: FloatArray, pivot: int
) -> FloatArray:  # fmt: skip
    """How far the states of a place lie from where a tube's middle moves to with the pivot and the parameters."""
    off = np.abs(place.z - middle - along * (place.z[pivot] - middle[pivot]))
    turned = np.abs(place.by_p - by_p - along[:, None] * (place.by_p[pivot] - by_p[pivot]))
    size = np.abs(place.z) + np.abs(middle) + place.held
    out = (off + (turned * apart).sum(axis=1) + place.off + np.abs(along) * place.off[pivot]) * UP + 4 * np.spacing(size)
    out[pivot] = 0.0
    return np.where(np.isfinite(out), out, np.inf)


class Tubes:
    """Curves of states of a model in contact as ``vary`` moves; ``free`` are the parameters that have a width."""

    def __init__(self, balance: Balance, vary: str, free: tuple[str, ...] = ()) -> None:
        self.balance, self.n = balance, balance.n
        self.moving = balance.parameters.index(vary)
        self.vary, self.free = vary, free
        self.places = [balance.parameters.index(name) for name in free]

    # --------------------------------------------------------------------------------------------------- evaluation

    def _bounds(self, parts: Parts, v: Intervals) -> Intervals:
        low, high = parts.fixed.copy(), parts.fixed.copy()
        low[self.moving], high[self.moving] = v.low, v.high
        span = self._span(parts)
        low[self.places], high[self.places] = span.low, span.high
        with np.errstate(all="ignore"):
            return self.balance.prepared(Intervals.between(low, high))

    @staticmethod
    def _span(parts: Parts) -> Intervals:
        wide = np.where(parts.half > 0, parts.half * UP + np.spacing(np.abs(parts.centre)), 0.0)
        return Intervals(np.stack([-parts.centre, parts.centre]) + wide)

    def slopes(self, parts: Parts, z: Intervals) -> Intervals:
        """Slopes of the forces by q, v and the free parameters over boxes, shape (n, n + 1 + free, N)."""
        at = self.balance.state(z[: self.n], self._bounds(parts, z[self.n]))
        with np.errstate(all="ignore"):
            return matrix(self._rows(at, self._moving(parts)), at.shape)

    def over(self, parts: Parts, region: Region, pivot: int) -> Slopes:
        """Slopes over regions, solved for all unknowns but the pivot: affine where parameters have a width."""
        if not parts.half.any():
            slopes = self.slopes(parts, region.box)
            return Slopes([list(row) for row in slopes], Intervals(np.zeros((2, *slopes.shape[2:]))))
        with np.errstate(all="ignore"):
            return of_affine(self.affine_slopes(parts, region), self._others(pivot), parts.half.shape[1:])

    def affine_slopes(self, parts: Parts, region: Region) -> list[list[Any]]:
        """Slopes in affine arithmetic, by row and column."""
        apart, shape = self.apart(parts), parts.half.shape[1:]
        z = region.numbers(apart)
        fixed = zip(self.balance.parameters, parts.fixed, strict=True)
        values: dict[str, Any] = {name: Affine(row, np.zeros((1, *shape))) if row.any() else 0 for name, row in fixed}
        for k, name in enumerate(self.free):
            terms = np.zeros_like(z[0].terms)
            terms[1 + k] = apart[k]
            values[name] = Affine(parts.centre[k], terms)
        values[self.vary] = z[self.n]
        at = self.balance.at(z[: self.n], self.balance.arguments_of(values, AFFINE), xp=AFFINE)
        return self._rows(replace(at, turnings=self._turnings(parts, region)), self._moving(parts))

    def _turnings(self, parts: Parts, region: Region) -> list[Affine]:
        """Angles of torsion springs, from intervals."""
        if not self.balance.torsions:
            return []
        found = self.balance.state(region.box[: self.n], self._bounds(parts, region.box[self.n])).directions
        return list(map(Affine.between, found[3 * self.balance.springs :]))

    def _rows(self, at: State, names: list[str]) -> list[list[Any]]:
        none = [0] * (1 + len(self.free) - len(names))
        return [[*row, *more, *none] for row, more in zip(at.stiffness(), at.by_parameters(names), strict=True)]

    def _moving(self, parts: Parts) -> list[str]:
        """What moves, and the free parameters where any box has a width."""
        return [self.vary, *(self.free if parts.half.any() else ())]

    def floats(self, parts: Parts, z: FloatArray, slopes: bool = True) -> tuple[FloatArray, FloatArray]:
        """Forces and their slopes in the middle of the boxes, in floats."""
        columns = parts.fixed.copy()
        columns[self.moving], columns[self.places] = z[self.n], parts.centre
        at = self.balance.at(list(z[: self.n]), self.balance.floats(columns), xp=np)
        with np.errstate(all="ignore"):
            forces = at.rows("forces")
            rows = self._rows(at, self._moving(parts)) if slopes else []
        whole = np.zeros((self.n, self.n + 1 + len(self.free), z.shape[1]))
        for i, row in enumerate(rows):
            for j, entry in enumerate(row):
                whole[i, j] = entry
        return np.stack([np.broadcast_to(force, z.shape[1:]) for force in forces]), whole

    def _forces(self, parts: Parts, z: FloatArray) -> Intervals:
        """Enclosed, in the middle of the boxes."""
        bounds = self._bounds(parts.middles(), Intervals.point(z[self.n]))
        at = self.balance.state(Intervals.point(z[: self.n]), bounds, self.balance.anywhere)
        with np.errstate(all="ignore"):
            return stacked(at.rows("forces"), at.shape)

    def apart(self, parts: Parts) -> FloatArray:
        """How far the free parameters lie from their middles at most."""
        wide = self._span(parts)
        return np.maximum(wide.high - parts.centre, parts.centre - wide.low) * UP

    def _others(self, pivot: int) -> list[int]:
        return [each for each in range(self.n + 1) if each != pivot]

    def corrected(self, parts: Parts, z: FloatArray, pivot: int) -> FloatArray:
        """Newton's method in the middle of the boxes with a given pivot, the slopes renewed every other step."""
        others, z, inverse = self._others(pivot), z.copy(), np.zeros(0)
        for number in range(STEPS):
            forces, slopes = self.floats(parts, z, slopes=number % 2 == 0)
            if number % 2 == 0:
                inverse = contractors.inverse(slopes[:, others])
            step = np.einsum("ijN,jN->iN", inverse, forces)
            step = np.where(np.isfinite(step), step, 0.0)
            z[others] -= step
            if (np.abs(step) < 1e-13 * (1 + np.abs(z[others]))).all():
                break
        return z

    def tangents(self, parts: Parts, z: FloatArray, pivot: int) -> tuple[FloatArray, FloatArray]:
        """dz/ds and dz/dp in the middle of the boxes."""
        others = self._others(pivot)
        slopes = self.floats(parts, z)[1]
        inverse = contractors.inverse(slopes[:, others])
        by_s, by_p = np.ones(z.shape), np.zeros((self.n + 1, *parts.half.shape))
        by_s[others] = -np.einsum("ijN,jN->iN", inverse, slopes[:, pivot])
        by_p[others] = -np.einsum("ijN,jkN->ikN", inverse, slopes[:, self.n + 1 :])
        return by_s, by_p

    def _across(self, parts: Parts, z: FloatArray, pivot: int) -> FloatArray:
        """dz/dp in the middle of the boxes, where they have a width at all."""
        return self.tangents(parts, z, pivot)[1] if parts.half.any() else np.zeros((self.n + 1, *parts.half.shape))

    # ------------------------------------------------------------------------------------------------------- proofs

    def place(self, parts: Parts, z: FloatArray, pivot: int, like: Place | None = None) -> Place:
        """The states of whole boxes at one value of the pivot, one for each point of a box; z is about those in the middle.

        ``like`` is a place near by, which tells how far from the middle states may lie.
        """
        z = self.corrected(parts, z, pivot)
        zero, by_p = np.zeros_like(z), self._across(parts, z, pivot)
        beside = zero if like is None else like.off * parts.half.any(axis=0)
        sure, room, held, off = self._one_state(parts, z, zero, by_p, np.zeros(z.shape[1]), pivot, beside)
        return Place(z, held, off, room, by_p, sure)

    def segment(self, parts: Parts, start: Place, z: FloatArray, pivot: int) -> tuple[BoolArray, Place, Region]:
        """From a place to another value of the pivot, about which z is: where that is proved, the place there, and the tube."""
        end = self.place(parts, z, pivot, start)
        z = end.z
        way = z[pivot] - start.z[pivot]
        with np.errstate(all="ignore"):
            along = np.where(way != 0, (z - start.z) / way, 0.0)
        # With another pivot than before the states there lie on either side of the middle.
        wide = np.where(
            start.held[pivot] > 0, start.held[pivot] * UP + 2 * np.spacing(np.abs(start.z[pivot]) + start.held[pivot]), 0
        )
        begin = start.z - along * np.sign(way) * wide
        middle, half = 0.5 * (begin + z), 0.5 * np.abs(z[pivot] - begin[pivot])
        middle[pivot] = 0.5 * (begin[pivot] + z[pivot])
        inside = self._across(parts, middle, pivot)
        apart = self.apart(parts)
        beside = np.maximum(*(beside_tube(one, middle, along, inside, apart, pivot) for one in (start, end)))
        sure, _, held, off = self._one_state(parts, middle, along, inside, half, pivot, beside)
        tube = Intervals(np.stack([-middle, middle]) + held + np.spacing(np.abs(middle) + held))
        region = Region(tube, middle, along, self._moved(middle, half, pivot), inside, off)
        return sure & end.sure & start.sure & (np.abs(way) >= wide), end, region

    @staticmethod
    def _moved(middle: FloatArray, half: FloatArray, pivot: int) -> FloatArray:
        """How far the pivot's values lie from the middle, which is rounded."""
        return np.where(half > 0, half * UP + np.spacing(np.abs(middle[pivot]) + half), 0.0)

    def _one_state(
        self, parts: Parts, middle: FloatArray, along: FloatArray, by_p: FloatArray, half: FloatArray, pivot: int,
        beside: FloatArray,
    ) -> tuple[BoolArray, FloatArray, FloatArray, FloatArray]:  # fmt: skip
        """Whether boxes hold one state, in contact, for each value of the pivot and of the parameters.

        They hold what lies within ``beside`` of where their middles move. Beside it how far from there a state is alone, and how
        far from the middles, and from where these move, states lie at most.
        """
        others, count = self._others(pivot), middle.shape[1]
        least = NARROW * np.maximum(1.0, np.abs(middle[others]))
        apart, moved = self.apart(parts), self._moved(middle, half, pivot)
        swing = (np.abs(along) * moved + (np.abs(by_p) * apart).sum(axis=1)) * UP
        forces = self._forces(parts, middle)
        across, strayed = Intervals(np.stack([moved, moved])), Intervals(np.stack([apart, apart]))
        reach = np.maximum(2 * least, (1 + ROOM) * beside[others] * parts.half.any(axis=0))
        room, held, off = np.zeros_like(middle), swing.copy(), np.zeros_like(middle)
        sure, open_ = np.zeros(count, dtype=np.bool_), np.ones(count, dtype=np.bool_)
        for _ in range(INFLATIONS):
            rows = np.flatnonzero(open_)
            if not rows.size:
                break
            m, alone = middle[:, rows], beside[:, rows].copy()
            alone[others] = np.maximum(reach[:, rows], alone[others])
            size = swing[:, rows] + alone
            box = Intervals(np.stack([-m, m]) + size + np.where(size > 0, np.spacing(np.abs(m) + size), 0.0))
            region = Region(box, m, along[:, rows], moved[rows], by_p[:, :, rows], alone)
            slopes = self.over(parts[rows], region, pivot)
            with np.errstate(all="ignore"):
                left = self._left(slopes, slopes.forces(forces[:, rows]), region, across[rows], strayed[:, rows])
                step = slopes.newton(left, others, reach[:, rows])
            good = np.isfinite(step).all(axis=(0, 1))
            done = good & contractors.inside(step, np.stack([reach[:, rows]] * 2))
            if done.any():
                here = rows[done]
                bounds = self._bounds(parts[here], box[:, done][self.n])
                sure[here] = on_side(self.balance, bounds, box.ends[:, : self.n, done])[0]
                room[:, here] = alone[:, done]
                held[np.array(others)[:, None], here] = (swing[others][:, here] + np.maximum(*step[:, :, done])) * UP
                off[np.array(others)[:, None], here] = np.maximum(*step[:, :, done]) * UP
            open_[rows[done | ~good]] = False
            reach[:, rows] = (1 + ROOM) * np.maximum(reach[:, rows], np.where(good, np.maximum(*np.abs(step)), 0.0))
        return sure, room, held, off

    def _left(self, slopes: Slopes, forces: Intervals, region: Region, moved: Intervals, strayed: Intervals) -> list[Intervals]:
        """F(m, c) and what is left of the changes along the tube and across the box, by row."""
        left = []
        for i, row in enumerate(slopes.rows):
            total = forces[i] + slopes.taken(slopes.image(i, region.along)) * moved
            for k in range(strayed.shape[0]):
                change = slopes.image(i, region.by_p[:, k], row[self.n + 1 + k])
                total = total + slopes.taken(change) * strayed[k]
            left.append(total)
        return left

    def rises(self, parts: Parts, region: Region, by_s: FloatArray, pivot: int) -> IntArray:
        """Sign of dv/ds for all states in regions, 0 where it is not known; ``by_s`` is about dz/ds."""
        others, v = self._others(pivot), self.n
        slopes, zero = self.over(parts, region, pivot), np.zeros((self.n, by_s.shape[1]))
        out, direction = np.zeros(by_s.shape[1], dtype=np.int64), by_s.copy()
        direction[pivot] = 0.0
        with np.errstate(all="ignore"):
            left = [slopes.taken(slopes.image(i, direction, row[pivot])) for i, row in enumerate(slopes.rows)]
            reach = zero + 0.1 * np.abs(by_s[v]) + TINY
            for _ in range(INFLATIONS):
                # Of what dz/ds differs by from the slope in the middle.
                step = slopes.newton(left, others, reach)
                known = contractors.inside(step, np.stack([reach, reach]))
                off = np.maximum(*step)[others.index(v)] * UP
                out = np.where(known & (off < np.abs(by_s[v])), np.sign(by_s[v]).astype(np.int64), out)
                reach = np.where(
                    known | ~np.isfinite(step).all(axis=(0, 1)), reach, (1 + ROOM) * np.maximum(reach, np.maximum(*step))
                )
        return out

    # ------------------------------------------------------------------------------------------------------ the way

    def followed(self, parts: Parts, start: Place, goal: FloatArray, least: float = LEAST) -> Place:
        """The state as ``vary`` moves to a goal: the last places that are proved, at the goal where all of the way is."""
        here = start[np.arange(goal.size)]
        way = goal - here.z[self.n]
        step = FIRST * way
        for _ in range(MOST):
            rows = np.flatnonzero(here.sure & (here.z[self.n] != goal) & (np.abs(step) >= least * np.abs(way)))
            if not rows.size:
                break
            at = here[rows]
            rest = goal[rows] - at.z[self.n]
            whole = np.abs(step[rows]) >= np.abs(rest)
            to = np.where(whole, goal[rows], at.z[self.n] + step[rows])
            z = at.z.copy()
            z[self.n] = to
            good, end, _ = self.segment(parts[rows], at, z, self.n)
            here.put(rows[good], end[good])
            step[rows] = np.where(good, 2 * step[rows], 0.25 * (to - at.z[self.n]))
        return here
