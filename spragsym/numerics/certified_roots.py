"""From boxes with one root each to the roots of each point: once each, to full precision, with a
bound on the error.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from . import boxes, contractors
from .boxes import EquationSystem
from .columns import Selection
from .interval_arrays import (
    BoolArray,
    FloatArray,
    IndexArray,
    IntArray,
    Intervals,
    quiet,
    rounded_outward,
    scale_of,
    width_of,
)


@dataclass(frozen=True)
class Roots:
    """Roots of many points, sorted by point; boxes are −low and high, (2, n, roots)."""

    ends: FloatArray  #: a box that holds exactly one root
    alone: FloatArray  #: the larger box in which it is the only one
    point: IntArray  #: the point of each
    undecided: FloatArray  #: boxes of which it is not known what they hold
    undecided_point: IntArray

    @classmethod
    def at(
        cls, ends: FloatArray, alone: FloatArray | None = None, point: IntArray | None = None
    ) -> Roots:
        """Roots, and nothing undecided: each alone in its box and of point 0, where not said."""
        point = np.zeros(ends.shape[2], dtype=int) if point is None else point
        return cls(ends, ends if alone is None else alone, point, ends[:, :, :0], point[:0])

    @classmethod
    def none(cls, n: int) -> Roots:
        """No roots, of n unknowns."""
        return cls.at(np.empty((2, n, 0)))

    def select(self, roots: Selection = slice(None), undecided: Selection = slice(None)) -> Roots:
        """Some of the roots and some of the undecided boxes."""
        return Roots(
            self.ends[:, :, roots],
            self.alone[:, :, roots],
            self.point[roots],
            self.undecided[:, :, undecided],
            self.undecided_point[undecided],
        )

    def of(self, points: IntArray, others: bool = False) -> Roots:
        """Roots and boxes of some points, or of all others."""
        return self.select(
            *(np.isin(part, points, invert=others) for part in (self.point, self.undecided_point))
        )

    def numbered(self, points: IntArray) -> Roots:
        """Roots of some points, by the numbers of all points."""
        return replace(self, point=points[self.point], undecided_point=points[self.undecided_point])

    def with_undecided(self, boxes: FloatArray, point: IntArray) -> Roots:
        """The roots with further undecided boxes."""
        return replace(
            self,
            undecided=np.concatenate([self.undecided, boxes], axis=2),
            undecided_point=np.concatenate([self.undecided_point, point]),
        )

    def reopened(self, roots: Selection, open_: Selection) -> Roots:
        """Some of the roots, and others of them among the undecided boxes."""
        return self.select(roots).with_undecided(self.ends[:, :, open_], self.point[open_])

    def concatenated(self, *others: Roots) -> Roots:
        """These, and roots and boxes of other searches."""
        columns = zip(*(vars(part).values() for part in (self, *others)), strict=True)
        return Roots(*(np.concatenate(column, axis=-1) for column in columns))

    @property
    def every(self) -> tuple[FloatArray, IntArray]:
        """Boxes of roots and then the undecided ones, and the points of both."""
        return np.concatenate([self.ends, self.undecided], axis=2), np.concatenate(
            [self.point, self.undecided_point]
        )

    @property
    def middle(self) -> FloatArray:
        """Floats inside of the boxes, shape (n, roots)."""
        return Intervals(self.ends).middle

    @property
    def error(self) -> FloatArray:
        """Bound on |error| / max(1, |value|), over the unknowns, shape (roots,)."""
        return relative_error(self.ends, self.middle)


def relative_error(ends: FloatArray, middle: FloatArray) -> FloatArray:
    """Bound on |x − middle| / max(1, |middle|) over the boxes, shape (2, n, N), the largest of the
    components.
    """
    return rounded_outward((contractors.distance(ends, middle) / scale_of(middle)).max(axis=0))


def search(
    system: EquationSystem, region: FloatArray, low: FloatArray, high: FloatArray, **how: Any
) -> Roots:
    """The roots of each point in a region; arguments as of :func:`spragsym.numerics.boxes.search`.

    A root that can't be told from one on the border of the region is among the boxes that are left.
    """
    outcome = boxes.search(system, region, low, high, **how)
    row, point = outcome.points.below(outcome.unique.nodes)
    open_, undecided_point = outcome.points.below(outcome.undecided.nodes)
    alone = outcome.unique.ends[:, :, row]
    with quiet():
        ends = np.minimum(outcome.where.ends[:, :, row], alone)
        ends, gone = _refined(system, ends, Intervals.between(low, high), point)
        # Each holds a root; where a law ends at the root itself, as a contact's at the touch,
        # refinement may lose it: undecided.
        found = Roots(
            ends, alone, point, outcome.undecided.ends[:, :, open_], undecided_point
        ).select(~gone)
        return different(
            found, np.broadcast_to(region, (*region.shape[:2], low.shape[1]))
        ).with_undecided(alone[:, :, gone], point[gone])


def different(found: Roots, regions: FloatArray) -> Roots:
    """Roots in the regions of their points, each once; what can't be told from another or one on
    the border is left.

    ``regions`` have the shape (2, n, points).
    """
    found = distinct(found)
    neighbourhoods = regions[:, :, found.point]
    border = ~contractors.within(found.ends, neighbourhoods)
    return found.reopened(~border, border & ~contractors.apart(found.ends, neighbourhoods))


def distinct(found: Roots) -> Roots:
    """Roots, each once, by point and lower end; what can't be told from another is left."""
    found = found.select(np.lexsort((-found.alone[0, 0], found.point)))
    return found.reopened(*once(found.ends, found.alone, found.point))


def _refined(
    system: EquationSystem, ends: FloatArray, parameters: Intervals, point: IntArray
) -> tuple[FloatArray, BoolArray]:
    """Boxes contracted until they do not get narrower; and whether one was found empty."""
    ends = ends.copy()
    empty = np.zeros(point.size, dtype=bool)
    for begin in range(0, point.size, boxes.CHUNK):
        rows = np.arange(begin, min(begin + boxes.CHUNK, point.size))
        at = system.prepared(parameters[:, point[rows]])
        for _ in range(8):  # each doubles the number of digits
            before = ends[:, :, rows]
            step = stepped(system, before, at)
            empty[rows] |= contractors.apart(step.ends, before)
            new = np.fmin(step.ends, before)
            ends[:, :, rows] = new
            widths = width_of(new)
            wide = widths > 2.0**-50 * scale_of(new).max(axis=0)
            narrower = (wide & (widths < 0.75 * width_of(before))).any(axis=0)
            rows, at = rows[narrower], at[:, narrower]
            if not rows.size:
                break
    return ends, empty


def stepped(system: EquationSystem, ends: FloatArray, parameters: Intervals) -> contractors.Newton:
    """The step of interval Newton from the middles of boxes of shape (2, n, N)."""
    middle = Intervals(ends).middle
    values = system.residuals(Intervals.point(middle), parameters)
    slopes = system.jacobian(Intervals(ends), parameters)
    return contractors.newton(values, slopes, middle, contractors.distance(ends, middle))


def once(ends: FloatArray, alone: FloatArray, point: IntArray) -> tuple[IntArray, IntArray]:
    """Rows of different roots, and rows that may be a root already found or another; sorted by
    point and lower end.

    Two boxes of a point hold the same root if one lies where the other's is alone, and different
    ones if they do not meet.
    """
    keep = np.ones(point.size, dtype=bool)
    unclear = np.zeros(point.size, dtype=bool)
    for first, second in neighbours(alone, point):
        alive = keep[first] & keep[second]
        first, second = first[alive], second[alive]
        one, other = ends[:, :, first], ends[:, :, second]
        same = contractors.within(other, alone[:, :, first]) | contractors.within(
            one, alone[:, :, second]
        )
        keep[second[same]] = False
        unclear[second[~same & ~contractors.apart(one, other)]] = True
    unclear &= keep
    return np.flatnonzero(keep & ~unclear), np.flatnonzero(unclear)


def neighbours(boxes: FloatArray, point: IntArray) -> Iterator[tuple[IntArray, IntArray]]:
    """Rows of pairs of boxes of one point that overlap in the first unknown; sorted by point and
    lower end.
    """
    for shift in range(1, point.size):
        # In the order of the lower ends: boxes that do not overlap have no overlap farther on.
        near = (point[shift:] == point[:-shift]) & (boxes[1, 0, :-shift] >= -boxes[0, 0, shift:])
        if not near.any():
            return
        first = np.flatnonzero(near)
        yield first, first + shift


def in_order(rows: FloatArray, error: FloatArray, point: IntArray) -> IndexArray:
    """Numbers of states of some points in their order: by the rows from the first on, of which
    those that agree decide nothing.

    Two states that mirror each other have equal coordinates, of which rounding would make a first
    and a second. ``rows`` are coordinates, shape (n, states), ``error`` bounds over max(1,
    |coordinate|); states of one ``point`` are compared.
    """
    keys = []
    for row in rows:
        order = np.lexsort((row, point))
        at = row[order]
        # Of states at infinity those on one side agree, and none of them with a finite one.
        near = np.where(np.isfinite(at), 1e-12 * (1 + np.abs(at)) + error[order] * scale_of(at), 0)
        with quiet():
            begins = np.diff(at, prepend=-np.inf) > near + np.roll(near, 1)
        ranks = np.empty(order.size, dtype=np.intp)
        ranks[order] = np.cumsum(begins | (np.diff(point[order], prepend=-1) != 0))
        keys.append(ranks)
    return np.lexsort((*reversed(keys), point))
