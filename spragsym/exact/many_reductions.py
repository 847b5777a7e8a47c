"""Roots in small boxes where Jacobians are nearly singular, of thousands of boxes at once: :mod:`reduction` on arrays.

The same function g(u) of :mod:`.reduced_equations` and the same cubic g(h) = c₀ + c₁ h + c₂ h² + c₃ h³ with an enclosure of
its last coefficient, about a point where g' is 0 or as near to it as it gets. There c₀ and c₁ say whether roots lie on both sides
of it or nowhere: they are known in double-double, where floats would not tell; of c₂ and c₃, which are multiplied by small
numbers, intervals of floats are enough. What this does not decide is left to the other, with any number of digits.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .cubics import Cubics, isolated
from .elimination import solved
from .interval_arrays import FloatArray, Intervals, raised
from .reduced_equations import ReducedEquations, System, less
from .wide_balls import WideBalls

#: Times the other unknowns are given more room, and times they are narrowed.
WIDENINGS, NARROWINGS = 6, 5
#: Narrowing ends where a step leaves more than this part, or less than that width, relatively.
MUCH, DONE = 0.5, 2.0**-47
#: Times boxes are halved in u.
LEVELS = 6
#: Steps to the point that g is expanded about.
STEPS = 2
#: What u is given beyond the ends of a box, so that distances from its centre, rounded outward, lie inside.
ROOM = 2.0**-40
#: Parts of a box within and beyond so many times the distance of roots from its centre, and bounds on that over its width.
REACH, LEAST, MOST = 4.0, 1 / 256, 1 / 5
#: Steps to a root, and the relative width up to which there is no further one.
POLISHINGS, FINE = 5, 2.0**-46
#: Boxes that are looked at together.
CHUNK = 4096


@dataclass(frozen=True)
class Found:
    """Roots, shape (2, n, roots), what each is alone in, the box of each, and the boxes that are not decided."""

    ends: FloatArray
    alone: FloatArray
    box: NDArray[np.int64]
    open: NDArray[np.bool_]


def reduced_roots(system: System, boxes: FloatArray, slopes: FloatArray, levels: int = LEVELS) -> Found:
    """All roots in boxes of shape (2, n, N), given the Jacobian somewhere in each, shape (n, n, N)."""
    n = boxes.shape[1]
    known = np.isfinite(slopes).all(axis=(0, 1))
    left, _, right = np.linalg.svd(np.moveaxis(np.where(known, slopes, 0.0), -1, 0))
    order = _last_first(np.abs(right[:, -1, :])), _last_first(np.abs(left[:, :, -1]))
    parts: list[tuple[FloatArray, FloatArray, NDArray[np.int64]]] = []
    part, box = boxes[:, :, known], np.flatnonzero(known)
    undecided: NDArray[np.bool_] = np.array(~known, dtype=np.bool_)
    for _ in range(levels):
        open_, cuts = np.zeros(box.size, dtype=np.bool_), np.empty((2, box.size))
        for begin in range(0, box.size, CHUNK):
            some = slice(begin, begin + CHUNK)
            rows = box[some]
            with np.errstate(all="ignore"):
                reduction = _Reduction(system, rows, order[0][:, rows], order[1][:, rows])
                ends, alone, mine, open_[some], cuts[:, some] = reduction.roots(part[:, :, some])
            parts.append((ends, alone, rows[mine]))
        # What is no function of u in a part is none of it in a narrower one, mostly: a search narrows the other unknowns, too.
        undecided[box[open_ & np.isnan(cuts[0])]] = True
        open_ &= ~undecided[box]
        part, place = _divided(part[:, :, open_], order[0][0, box[open_]], cuts[:, open_])
        box = box[open_][place]
        if not box.size:
            break
    undecided[box] = True
    none = np.empty((2, n, 0))
    return Found(
        np.concatenate([none, *(part[0] for part in parts)], axis=2),
        np.concatenate([none, *(part[1] for part in parts)], axis=2),
        np.concatenate([np.empty(0, dtype=np.int64), *(part[2] for part in parts)]),
        undecided,
    )


def _last_first(weights: FloatArray) -> NDArray[np.int64]:
    """Numbers of the columns, shape (n, N), that of the largest weight first."""
    order: NDArray[np.int64] = np.argsort(-weights, axis=1, kind="stable").T
    return order


def _divided(boxes: FloatArray, along: NDArray[np.int64], cuts: FloatArray) -> tuple[FloatArray, NDArray[np.int64]]:
    """Parts of boxes, cut twice in the unknown of that number, and the box of each."""
    rows = np.arange(along.size)
    low, high = -boxes[0, along, rows], boxes[1, along, rows]
    ends = np.stack([low, *np.clip(cuts, low, high), high])
    parts = []
    for one, two in pairwise(ends):
        part = boxes.copy()
        part[0, along, rows], part[1, along, rows] = -one, two
        there = np.flatnonzero(two > one)
        parts.append((part[:, :, there], there))
    return np.concatenate([part for part, _ in parts], axis=2), np.concatenate([there for _, there in parts])


@dataclass(frozen=True)
class _Curve:
    """The other unknowns as functions of u, by Taylor's series: coefficients of each, the last one all over the box."""

    centre: FloatArray
    terms: list[list[Intervals]]
    box: list[Intervals]

    def taken(self, rows: NDArray[np.int64]) -> _Curve:
        """Some of them."""
        terms = [[term[rows] for term in row] for row in self.terms]
        return _Curve(self.centre[rows], terms, [value[rows] for value in self.box])

    def at(self, u: Intervals) -> list[Intervals]:
        """What holds the others where u is in a part of the box."""
        h = u - Intervals.point(self.centre)
        out = []
        for (value, first, second, third), box in zip(self.terms, self.box, strict=True):
            series = value + h * (first + h * (second + h * third))
            out.append(Intervals(np.fmin(series.ends, box.ends)))
        return out


class _Reduction(ReducedEquations):
    """Boxes whose numbers are floats, and double-double where these do not tell."""

    def roots(self, boxes: FloatArray) -> tuple[FloatArray, FloatArray, NDArray[np.int64], NDArray[np.bool_], FloatArray]:
        """Boxes around roots and what they are alone in, the box of each; boxes that stay open, and where to cut them, or NaN."""
        every = np.arange(self.rows.size)
        side, *given = Intervals(boxes[:, self.unknowns, every])
        u = Intervals(side.ends + ROOM * side.width)
        others, proved = self._others(u, given)
        if not proved.any():
            nothing = np.empty((2, len(self.unknowns), 0))
            return nothing, nothing, every[:0], ~proved, np.full((2, every.size), np.nan)
        (*_, last), terms = self.expansion(every, u, others, 3)
        curve, bend = self._centre(u, others, last, [row[-1] for row in terms])
        centre = curve.centre
        value, slope = self._precise(every, centre, [row[0] for row in curve.terms])
        low, high = raised(side.ends + np.stack([centre, -centre]))
        cubics = Cubics(value, slope, bend, last)
        one, two, guess, box, open_ = isolated(cubics, -low, high)
        half = np.clip(side.low + (61 / 128) * (side.high - side.low), side.low, side.high)
        # Nearer to the centre its last coefficient is known better.
        near_by = np.clip(cubics.scale() * REACH, LEAST * side.width, MOST * side.width)
        cuts = np.where(open_ & np.isfinite(near_by), np.stack([centre - near_by, centre + near_by]), half)
        cuts[:, ~proved] = np.nan
        open_ |= ~proved
        kept = ~open_[box]
        one, two, guess, box = one[kept], two[kept], guess[kept], box[kept]
        # Inward: what lies beyond the ends may be another root.
        spans = Intervals(-raised(np.stack([one + centre[box], -two - centre[box]])))
        ends = self._polished(box, spans, centre[box] + guess, curve.taken(box))
        alone = self._boxed(box, [spans, *(value[box] for value in others)])
        bad = ~np.isfinite(ends).all(axis=(0, 1)) | ~np.isfinite(alone).all(axis=(0, 1))
        open_[box[bad]] = True
        kept = ~open_[box]
        return ends[:, :, kept], alone[:, :, kept], box[kept], open_, cuts

    def _boxed(self, where: NDArray[np.int64], values: Sequence[Intervals]) -> FloatArray:
        """Boxes of unknowns in their order, shape (2, n, N)."""
        return np.stack([value.ends for value in self.ordered(where, values)], axis=1)

    def _others(self, u: Intervals, given: list[Intervals]) -> tuple[list[Intervals], NDArray[np.bool_]]:
        """Intervals of the other unknowns that hold exactly one value each for every u, and where that is proved."""
        every = np.arange(self.rows.size)
        proved = np.full(self.rows.size, not given)
        if not given:
            return given, proved
        out = given
        for _ in range(WIDENINGS):
            wide = [Intervals(value.ends + 1.5 * value.width) for value in given]
            image = self.newton(every, u, wide)
            inside = np.logical_and.reduce([(one.ends < other.ends).all(axis=0) for one, other in zip(image, wide, strict=True)])
            new = inside & ~proved
            out = [Intervals(np.where(new, one.ends, other.ends)) for one, other in zip(image, out, strict=True)]
            proved |= inside
            if proved.all():
                break
            given = [one.hull(other) for one, other in zip(image, given, strict=True)]
        return self._narrowed(every, u, out), proved

    def _narrowed(self, where: NDArray[np.int64], u: Intervals, others: Sequence[Intervals]) -> list[Intervals]:
        if not others:
            return []
        ends = np.stack([value.ends for value in others], axis=1)
        rows = np.arange(where.size)
        for _ in range(NARROWINGS):
            now = ends[:, :, rows]
            new = np.stack([value.ends for value in self.newton(where[rows], u[rows], list(Intervals(now)))], axis=1)
            new = np.fmin(new, now)
            ends[:, :, rows] = new
            widths, before = new[0] + new[1], now[0] + now[1]
            more = (widths < MUCH * before) & (widths > DONE * np.maximum(1.0, np.abs(new).max(axis=0)))
            rows = rows[more.any(axis=0)]
            if not rows.size:
                break
        return list(Intervals(ends))

    def _centre(self, u: Intervals, others: list[Intervals], last: Intervals, lasts: list[Intervals]) -> tuple[_Curve, Intervals]:
        """The others about a point where g' is 0 or nearest to 0, roughly, and g''/2 there."""
        rows = np.arange(self.rows.size)
        curve = _Curve(u.middle, [[Intervals(np.zeros((2, rows.size))) for _ in range(3)] + [term] for term in lasts], others)
        bend = Intervals(np.zeros((2, rows.size)))
        centre, near = curve.centre[rows], others
        for step in range(STEPS + 1):
            at = Intervals.point(centre)
            (slope, second), terms = self.expansion(rows, at, self._narrowed(rows, at, near), 2)
            curve.centre[rows], bend.ends[:, rows] = centre, second.ends
            for old, new in zip(curve.terms, terms, strict=True):
                for one, other in zip(old, new, strict=False):
                    one.ends[:, rows] = other.ends
            if step == STEPS:
                break
            move = _flattest(slope.middle, second.middle, last.middle[rows])
            moved = np.clip(centre + move, u.low[rows], u.high[rows])
            off = np.abs(moved - centre) > 1e-9 * u.width[rows]
            rows, centre = rows[off], moved[off]
            if not rows.size:
                break
            near = curve.taken(rows).at(Intervals.point(centre))
        return curve, bend

    def _precise(self, where: NDArray[np.int64], u: FloatArray, others: Sequence[Intervals]) -> tuple[WideBalls, WideBalls]:
        """g and g' at floats, in double-double; the others are known to hold their values there."""
        at = WideBalls.exact(u)
        middle = [WideBalls.exact(value.middle) for value in others]
        values = self.values(where, [at, *middle])[1:]
        slopes = self.slopes(where, [Intervals.point(u), *others])[1:]
        steps = solved([[_wide(entry) for entry in row[1:]] for row in slopes], values)
        sharp = [at, *(m - step for m, step in zip(middle, steps, strict=True))]
        slopes = self.slopes(where, sharp)
        steps = solved([row[1:] for row in slopes[1:]], [row[0] for row in slopes[1:]])
        zero = WideBalls.exact(np.zeros(where.size))
        return zero + self.values(where, sharp)[0], zero + less(slopes[0][0], slopes[0][1:], steps)

    def _polished(self, where: NDArray[np.int64], spans: Intervals, guess: FloatArray, curve: _Curve) -> FloatArray:
        """Small boxes around the only root in each span of u, near a guess; NaN where that is not shown."""
        ends = np.full((2, len(self.unknowns), where.size), np.nan)
        rows = np.arange(where.size)
        for _ in range(POLISHINGS):
            u, *_ = found = self._step(where[rows], spans[rows], guess[rows], curve.taken(rows))
            box = Intervals(self._boxed(where[rows], found))
            ends[:, :, rows], guess[rows] = box.ends, u.middle
            rows = rows[(box.width > FINE * np.maximum(1.0, box.magnitude)).any(axis=0)]
            if not rows.size:
                break
        return ends

    def _step(self, where: NDArray[np.int64], spans: Intervals, guess: FloatArray, curve: _Curve) -> list[Intervals]:
        """Newton's step from a guess: u and the others, NaN for a u that is not shown to hold the root.

        A root u + h has h = −g(u) / (g'(u) + c₂ h) with a c₂ of its enclosure. An interval that this maps into itself has one.
        """
        u = np.clip(guess, spans.low, spans.high)
        at = Intervals.point(u)
        value, slope = self._precise(where, u, self._narrowed(where, at, curve.at(at)))
        reach = 4 * value.size / np.abs(slope.middle.high) + 1e-30
        around = Intervals(raised(np.stack([reach - u, reach + u])))
        inside = (around.ends <= spans.ends).all(axis=0)
        others = self._narrowed(where, around, curve.at(around))
        bend = self.expansion(where, around, others, 2)[0][1]
        room = Intervals(np.stack([reach, reach]))
        h = -(value.intervals() / (slope.intervals() + bend * room))
        proved = inside & (h.ends < room.ends).all(axis=0)
        found = np.fmin(raised(h.ends + np.stack([-u, u])), around.ends)
        return [Intervals(np.where(proved, found, np.nan)), *others]


def _flattest(first: FloatArray, second: FloatArray, third: FloatArray) -> FloatArray:
    """The h with first + 2 second h + 3 third h² = 0 that is nearest to 0, or that of the extremum where there is none."""
    square = second * second - 3 * first * third
    root = np.where(square > 0, -first / (second + np.copysign(np.sqrt(np.maximum(square, 0.0)), second)), -second / (3 * third))
    return np.where(np.isfinite(root), root, 0.0)


def _wide(value: Any) -> Any:
    return WideBalls.around(value) if isinstance(value, Intervals) else value
