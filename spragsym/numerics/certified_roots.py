"""Roots of each parameter point from the boxes that branch and prune has found: duplicates are
removed, and each root is enclosed to full precision, with an error bound (:class:`Roots`).
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
    """Roots of many parameter points, sorted by point; boxes are −low and high, (2, n, roots)."""

    ends: FloatArray  #: a tight box that contains the root
    alone: FloatArray  #: a larger box in which it is the only root
    point: IntArray  #: the index of its parameter point
    undecided: FloatArray  #: boxes that may contain roots
    undecided_point: IntArray  #: the points of these

    @classmethod
    def at(
        cls, ends: FloatArray, alone: FloatArray | None = None, point: IntArray | None = None
    ) -> Roots:
        """Roots without undecided boxes; by default each unique in its box, and of point 0."""
        point = np.zeros(ends.shape[2], dtype=int) if point is None else point
        return cls(ends, ends if alone is None else alone, point, ends[:, :, :0], point[:0])

    @classmethod
    def none(cls, n: int) -> Roots:
        """No roots, for n unknowns."""
        return cls.at(np.empty((2, n, 0)))

    def select(self, roots: Selection = slice(None), undecided: Selection = slice(None)) -> Roots:
        """Selected roots and undecided boxes."""
        return Roots(
            self.ends[:, :, roots],
            self.alone[:, :, roots],
            self.point[roots],
            self.undecided[:, :, undecided],
            self.undecided_point[undecided],
        )

    def of(self, points: IntArray, others: bool = False) -> Roots:
        """Roots and boxes of given points, or of all ``others``."""
        return self.select(
            *(np.isin(part, points, invert=others) for part in (self.point, self.undecided_point))
        )

    def numbered(self, points: IntArray) -> Roots:
        """The same roots with new point indices: ``points`` are those of the old ones."""
        return replace(self, point=points[self.point], undecided_point=points[self.undecided_point])

    def with_undecided(self, boxes: FloatArray, point: IntArray) -> Roots:
        """The roots with further undecided boxes."""
        return replace(
            self,
            undecided=np.concatenate([self.undecided, boxes], axis=2),
            undecided_point=np.concatenate([self.undecided_point, point]),
        )

    def reopened(self, roots: Selection, open_: Selection) -> Roots:
        """The roots ``roots``, with the roots ``open_`` turned into undecided boxes."""
        return self.select(roots).with_undecided(self.ends[:, :, open_], self.point[open_])

    def concatenated(self, *others: Roots) -> Roots:
        """All roots and boxes of several results."""
        columns = zip(*(vars(part).values() for part in (self, *others)), strict=True)
        return Roots(*(np.concatenate(column, axis=-1) for column in columns))

    @property
    def every(self) -> tuple[FloatArray, IntArray]:
        """Boxes of the roots, then undecided boxes; and the points of all."""
        boxes = np.concatenate([self.ends, self.undecided], axis=2)
        return boxes, np.concatenate([self.point, self.undecided_point])

    @property
    def middle(self) -> FloatArray:
        """Approximate roots: midpoints of the boxes, (n, roots); 0 where it is as good."""
        found = Intervals(self.ends)
        # Else rounding alone would make up the digits of a number that is 0 by symmetry.
        return np.where(np.abs(found.middle) <= 0.25 * found.width, 0.0, found.middle)

    @property
    def error(self) -> FloatArray:
        """Error bounds: the largest |error| / max(1, |value|) of the unknowns, (roots,)."""
        return relative_error(self.ends, self.middle)


def relative_error(ends: FloatArray, middle: FloatArray) -> FloatArray:
    """Upper bound of |x − middle| / max(1, |middle|) over boxes (2, n, N), the largest of the
    components, (N,).
    """
    return rounded_outward((contractors.distance(ends, middle) / scale_of(middle)).max(axis=0))


def search(
    system: EquationSystem, region: FloatArray, low: FloatArray, high: FloatArray, **how: Any
) -> Roots:
    """All roots of each point in a region; arguments as of :func:`spragsym.numerics.boxes.search`.

    A root that may be on the border of the region is undecided.
    """
    outcome = boxes.search(system, region, low, high, **how)
    row, point = outcome.points.below(outcome.unique.nodes)
    open_, undecided_point = outcome.points.below(outcome.undecided.nodes)
    alone = outcome.unique.ends[:, :, row]
    with quiet():
        ends = np.minimum(outcome.where.ends[:, :, row], alone)
        ends, lost = _refined(system, ends, Intervals.between(low, high), point)
        undecided = outcome.undecided.ends[:, :, open_]
        found = Roots(ends, alone, point, undecided, undecided_point).select(~lost)
        regions = np.broadcast_to(region, (*region.shape[:2], low.shape[1]))
        # Each box contains a root; but if a law ends at the root, as a contact's at the touch,
        # refinement may lose it. Such a root is undecided.
        return different(found, regions).with_undecided(alone[:, :, lost], point[lost])


def different(found: Roots, regions: FloatArray) -> Roots:
    """The roots in the regions (2, n, points) of their points, without duplicates.

    A root that may be a duplicate, or on the border of the region, is undecided.
    """
    found = distinct(found)
    neighbourhoods = regions[:, :, found.point]
    border = ~contractors.within(found.ends, neighbourhoods)
    return found.reopened(~border, border & ~contractors.apart(found.ends, neighbourhoods))


def distinct(found: Roots) -> Roots:
    """The roots without duplicates, sorted by point and lower end; possible duplicates are
    undecided.
    """
    found = found.select(np.lexsort((-found.alone[0, 0], found.point)))
    return found.reopened(*once(found.ends, found.alone, found.point))


def _refined(
    system: EquationSystem, ends: FloatArray, parameters: Intervals, point: IntArray
) -> tuple[FloatArray, BoolArray]:
    """Boxes contracted by interval Newton until they become no narrower; and the mask of those that
    became empty.
    """
    ends = ends.copy()
    empty = np.zeros(point.size, dtype=bool)
    for begin in range(0, point.size, boxes.CHUNK):
        rows = np.arange(begin, min(begin + boxes.CHUNK, point.size))
        at = system.prepared(parameters[:, point[rows]])
        for _ in range(8):  # quadratic convergence
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
    """Interval Newton step of boxes (2, n, N)."""
    middle = Intervals(ends).middle
    values = system.residuals(Intervals.point(middle), parameters)
    slopes = system.jacobian(Intervals(ends), parameters)
    return contractors.newton(values, slopes, middle, contractors.distance(ends, middle))


def once(ends: FloatArray, alone: FloatArray, point: IntArray) -> tuple[IntArray, IntArray]:
    """Indices of different roots, and of those that may be duplicates; arguments are sorted by
    point and lower end.

    Two boxes of a point contain the same root if one is inside the other's ``alone``, and different
    roots if they are disjoint.
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
    """Index pairs of boxes of the same point that overlap in the first unknown; the boxes are
    sorted by point and lower end. Yields arrays of pairs at distance 1, 2, ….
    """
    for shift in range(1, point.size):
        # If no boxes at this distance overlap, none do at a larger one.
        near = (point[shift:] == point[:-shift]) & (boxes[1, 0, :-shift] >= -boxes[0, 0, shift:])
        if not near.any():
            return
        first = np.flatnonzero(near)
        yield first, first + shift


def in_order(rows: FloatArray, error: FloatArray, point: IntArray) -> IndexArray:
    """Indices that sort states by point and lexicographically by coordinates, where coordinates
    that agree within their errors count as equal.

    So the order of mirror images, which have equal coordinates, does not depend on rounding.
    ``rows``, (n, states), are coordinates, ``error`` bounds of |error| / max(1, |coordinate|).
    """
    keys = []
    for row in rows:
        order = np.lexsort((row, point))
        at = row[order]
        # States at infinity are equal if they have the same sign.
        near = np.where(np.isfinite(at), 1e-12 * (1 + np.abs(at)) + error[order] * scale_of(at), 0)
        with quiet():
            begins = np.diff(at, prepend=-np.inf) > near + np.roll(near, 1)
        ranks = np.empty(order.size, dtype=np.intp)
        ranks[order] = np.cumsum(begins | (np.diff(point[order], prepend=-1) != 0))
        keys.append(ranks)
    return np.lexsort((*reversed(keys), point))
