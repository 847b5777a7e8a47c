"""Roots in small boxes where Jacobians are nearly singular, of thousands of boxes at once: :mod:`reduction` on arrays of balls.

The same reduction to one unknown u and the same cubic with an enclosure of its last coefficient, in double-double instead of any
number of digits. What it does not decide is left to the other.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..generated.double_double import two_sum
from .elimination import solved
from .interval_arrays import FloatArray, Intervals, raised
from .jets import Jet
from .wide_balls import WideBalls

#: Forces of some of the boxes, by their rows: of balls or of jets of balls.
Evaluate: TypeAlias = Callable[[NDArray[np.int64], Sequence[Any]], Sequence[Any]]
#: Times the other unknowns are given more room, and times they are narrowed.
WIDENINGS, NARROWINGS = 6, 5
#: Rounds of halvings of pieces of u, and most pieces of one box in a round.
ROUNDS, PIECES = 120, 24
#: Times boxes are halved in u.
LEVELS = 6
#: Steps of interval Newton on one root.
STEPS = 6
#: No further step where the last one has left more than this part, or less than that width, relatively.
MUCH, DONE = 0.5, 2.0**-56


@dataclass(frozen=True)
class Found:
    """Roots, shape (2, n, roots), what each is alone in, the box of each, and the boxes that are not decided."""

    ends: FloatArray
    alone: FloatArray
    box: NDArray[np.int64]
    open: NDArray[np.bool_]


def reduced_roots(evaluate: Evaluate, boxes: FloatArray, slopes: FloatArray) -> Found:
    """All roots in boxes of shape (2, n, N), given the Jacobian somewhere in each, shape (n, n, N)."""
    n, count = boxes.shape[1:]
    known = np.isfinite(slopes).all(axis=(0, 1))
    left, _, right = np.linalg.svd(np.moveaxis(np.where(known, slopes, 0.0), -1, 0))
    along, equation = np.abs(right[:, -1, :]).argmax(axis=1), np.abs(left[:, :, -1]).argmax(axis=1)
    parts = []
    part, box = boxes[:, :, known], np.flatnonzero(known)
    for _ in range(LEVELS):
        open_ = np.zeros(box.size, dtype=np.bool_)
        with np.errstate(all="ignore"):
            for u, row in sorted(set(zip(along[box].tolist(), equation[box].tolist(), strict=True))):
                rows = np.flatnonzero((along[box] == u) & (equation[box] == row))
                ends, alone, mine, open_[rows] = _Group(evaluate, box[rows], u, row, n).roots(part[:, :, rows])
                parts.append((ends, alone, box[rows[mine]]))
        part, box = _halves(part[:, :, open_], along[box[open_]]), np.concatenate([box[open_], box[open_]])
        if not box.size:
            break
    undecided: NDArray[np.bool_] = np.array(~known, dtype=np.bool_)
    undecided[box] = True
    none = np.empty((2, n, 0))
    return Found(
        np.concatenate([none, *(part[0] for part in parts)], axis=2),
        np.concatenate([none, *(part[1] for part in parts)], axis=2),
        np.concatenate([np.empty(0, dtype=np.int64), *(part[2] for part in parts)]),
        undecided,
    )


def _halves(boxes: FloatArray, along: NDArray[np.int64]) -> FloatArray:
    """Both halves of boxes in the unknown of that number."""
    rows = np.arange(along.size)
    low, high = -boxes[0, along, rows], boxes[1, along, rows]
    cut = np.clip(low + (61 / 128) * (high - low), low, high)
    lower, upper = boxes.copy(), boxes.copy()
    lower[1, along, rows], upper[0, along, rows] = cut, -cut
    return np.concatenate([lower, upper], axis=2)


@dataclass(frozen=True)
class _Group:
    """Boxes with the same u and the same equation that is left."""

    evaluate: Evaluate
    rows: NDArray[np.int64]
    along: int
    equation: int
    n: int

    def roots(self, boxes: FloatArray) -> tuple[FloatArray, FloatArray, NDArray[np.int64], NDArray[np.bool_]]:
        every = np.arange(self.rows.size)
        sides = Intervals(boxes)
        u = WideBalls.around(sides[self.along])
        others, proved = self._others(u, [WideBalls.around(sides[i]) for i in range(self.n) if i != self.along])
        whole = self._expansion(every, u, others, 3)
        centre = u.middle.high
        at = WideBalls.exact(centre)
        point = self._expansion(every, at, self._narrowed(every, at, others), 2)
        cubic = [*point, whole[3]]
        low, high = (raised(part) for part in (boxes[0, self.along] + centre, boxes[1, self.along] - centre))
        one, two, box, open_ = _isolated(cubic, -low, high)
        open_ |= ~proved
        kept = ~open_[box]
        one, two, box = one[kept], two[kept], box[kept]
        mine = [value.taken(box) for value in others]
        alone = self._boxed(centre[box], one, two, mine)
        ends = self._polished(centre[box], one, two, box, mine, whole[3].taken(box))
        bad = ~np.isfinite(ends).all(axis=(0, 1)) | ~np.isfinite(alone).all(axis=(0, 1))
        open_[box[bad]] = True
        kept = ~open_[box]
        return ends[:, :, kept], alone[:, :, kept], box[kept], open_

    def _rows(self, where: NDArray[np.int64], u: Any, others: Sequence[Any]) -> tuple[list[Any], Any]:
        """The equations for the other unknowns, and the one that is left."""
        rest = iter(others)
        values = list(self.evaluate(self.rows[where], [u if i == self.along else next(rest) for i in range(self.n)]))
        return [value for number, value in enumerate(values) if number != self.equation], values[self.equation]

    def _slopes(self, where: NDArray[np.int64], u: WideBalls, others: Sequence[WideBalls]) -> list[list[Any]]:
        rows, _ = self._rows(where, u, [Jet.variable(value, number, 1) for number, value in enumerate(others)])
        return [[row.derivative(number) if isinstance(row, Jet) else 0 for number in range(self.n - 1)] for row in rows]

    def _newton(self, where: NDArray[np.int64], u: WideBalls, others: Sequence[WideBalls]) -> list[WideBalls]:
        """Interval Newton's operator for the other unknowns as functions of u."""
        middle = [value.centre() for value in others]
        rows, _ = self._rows(where, u, middle)
        return [m - step for m, step in zip(middle, solved(self._slopes(where, u, others), rows), strict=True)]

    def _others(self, u: WideBalls, given: list[WideBalls]) -> tuple[list[WideBalls], NDArray[np.bool_]]:
        """Balls of the other unknowns that hold exactly one value each for every u, and where that is proved."""
        every = np.arange(self.rows.size)
        proved = np.zeros(self.rows.size, dtype=np.bool_)
        out = given
        for _ in range(WIDENINGS):
            wide = [value.widened(4.0) for value in given]
            image = self._newton(every, u, wide)
            inside = np.logical_and.reduce([one.inside(other) for one, other in zip(image, wide, strict=True)])
            new = inside & ~proved
            out = [WideBalls.where(new, one, other) for one, other in zip(image, out, strict=True)]
            proved |= inside
            if proved.all():
                break
            given = [one.union(other) for one, other in zip(image, given, strict=True)]
        return self._narrowed(every, u, out), proved

    def _narrowed(self, where: NDArray[np.int64], u: WideBalls, others: Sequence[WideBalls]) -> list[WideBalls]:
        current = list(others)
        for _ in range(NARROWINGS):
            image = self._newton(where, u, current)
            better = np.logical_and.reduce([one.radius < other.radius for one, other in zip(image, current, strict=True)])
            much = np.logical_or.reduce([one.radius < MUCH * other.radius for one, other in zip(image, current, strict=True)])
            current = [WideBalls.where(better, one, other) for one, other in zip(image, current, strict=True)]
            if not (better & much).any():
                break
        return current

    def _expansion(self, where: NDArray[np.int64], u: WideBalls, others: Sequence[WideBalls], highest: int) -> list[Any]:
        """Taylor coefficients of what is left as a function of u."""
        slopes = self._slopes(where, u, others)
        jets = [Jet({(): value}, highest) for value in others]
        variable = Jet.variable(u, 0, highest)
        for order in range(1, highest + 1):
            rows, _ = self._rows(where, variable, jets)
            steps = solved(slopes, [_coefficient(row, order) for row in rows])
            jets = [Jet({**jet.terms, (0,) * order: -step}, highest) for jet, step in zip(jets, steps, strict=True)]
        _, last = self._rows(where, variable, jets)
        zero = WideBalls.exact(np.zeros(where.size))
        return [zero + _coefficient(last, order) for order in range(highest + 1)]

    def _polished(
        self,
        centre: FloatArray,
        one: FloatArray,
        two: FloatArray,
        box: NDArray[np.int64],
        others: list[WideBalls],
        last: WideBalls,
    ) -> FloatArray:
        """Small boxes around the only root in each span, by interval Newton."""
        for _ in range(STEPS):
            middle = np.clip(0.5 * (one + two), one, two)
            at = WideBalls(two_sum(centre, middle), np.zeros_like(centre))
            point = [*self._expansion(box, at, self._narrowed(box, at, others), 2), last]
            slope = _taylor_slope(point, _between(one - middle, two - middle)).intervals()
            step = (point[0].intervals() / slope).ends
            ends = raised(np.stack([step[1] - middle, step[0] + middle]))
            new = np.fmin(ends, np.stack([-one, two]))
            narrower = new[0] + new[1] < two - one
            more = (new[0] + new[1] < MUCH * (two - one)) & (new[0] + new[1] > DONE * np.maximum(1.0, np.abs(centre)))
            one, two = np.where(narrower, -new[0], one), np.where(narrower, new[1], two)
            if not more.any():
                break
        return self._boxed(centre, one, two, self._narrowed(box, _around(centre, one, two), others))

    def _boxed(self, centre: FloatArray, one: FloatArray, two: FloatArray, others: list[WideBalls]) -> FloatArray:
        rest = iter([value.intervals().ends for value in others])
        u = _around(centre, one, two).intervals().ends
        return np.stack([u if i == self.along else next(rest) for i in range(self.n)], axis=1)


def _around(centre: FloatArray, one: FloatArray, two: FloatArray) -> WideBalls:
    """centre + [one, two]."""
    middle = np.clip(0.5 * (one + two), one, two)
    radius = raised(np.maximum(two - middle, middle - one))
    return WideBalls(two_sum(centre, middle), raised(radius))


def _between(low: FloatArray, high: FloatArray) -> WideBalls:
    return WideBalls.around(Intervals(raised(np.stack([-low, high]))))


def _coefficient(row: Any, order: int) -> Any:
    return row.terms.get((0,) * order, 0) if isinstance(row, Jet) else (row if order == 0 else 0)


def _taylor(c: Sequence[Any], h: WideBalls) -> WideBalls:
    """The cubic over a piece, expanded about its middle."""
    m = h.centre()
    d = h - m
    slope = c[1] + m * (c[2] * 2 + m * c[3] * 3)
    out: WideBalls = c[0] + m * (c[1] + m * (c[2] + m * c[3])) + d * (slope + d * (c[2] + m * c[3] * 3 + d * c[3]))
    return out


def _taylor_slope(c: Sequence[Any], h: WideBalls) -> WideBalls:
    m = h.centre()
    d = h - m
    out: WideBalls = c[1] + m * (c[2] * 2 + m * c[3] * 3) + d * (c[2] * 2 + m * c[3] * 6 + d * c[3] * 3)
    return out


def _isolated(
    cubic: Sequence[WideBalls], low: FloatArray, high: FloatArray
) -> tuple[FloatArray, FloatArray, NDArray[np.int64], NDArray[np.bool_]]:
    """Spans with exactly one root each, the box of each, and the boxes whose roots can't be told apart."""
    failed: NDArray[np.bool_] = np.any([~np.isfinite(part.radius) for part in cubic], axis=0)
    one: FloatArray = low
    two: FloatArray = high
    box: NDArray[np.int64] = np.arange(low.size)
    found: list[tuple[FloatArray, FloatArray, NDArray[np.int64]]] = []
    for _ in range(ROUNDS):
        crowded = np.bincount(box, minlength=low.size) > PIECES
        failed |= crowded
        alive = ~failed[box]
        one, two, box = one[alive], two[alive], box[alive]
        if not box.size:
            break
        c = [part.taken(box) for part in cubic]
        h = _between(one, two)
        open_ = _taylor(c, h).signs() == 0
        one, two, box, c, h = one[open_], two[open_], box[open_], [part.taken(open_) for part in c], h.taken(open_)
        straight = _taylor_slope(c, h).signs() != 0
        signs = [_taylor(c, WideBalls.exact(end)).signs() for end in (one, two)]
        failed[box[straight & ((signs[0] == 0) | (signs[1] == 0))]] = True
        rooted = straight & (signs[0] * signs[1] < 0)
        found.append((one[rooted], two[rooted], box[rooted]))
        one, two, box = one[~straight], two[~straight], box[~straight]
        cut = one + (two - one) * (63 / 128)
        one, two, box = np.concatenate([one, cut]), np.concatenate([cut, two]), np.concatenate([box, box])
    failed[box] = True
    lows, highs = (np.concatenate([low[:0], *(part[k] for part in found)]) for k in (0, 1))
    return lows, highs, np.concatenate([np.empty(0, dtype=np.int64), *(part[2] for part in found)]), failed
