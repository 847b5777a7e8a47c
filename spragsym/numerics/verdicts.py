"""What becomes of the boxes of a search: one holds no root, or exactly one, or is to be cut."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import TypeAlias

import numpy as np

from . import contractors
from .interval_arrays import (
    BoolArray,
    FloatArray,
    Int8Array,
    IntArray,
    Intervals,
    scale_of,
    width_of,
)

#: Margin, spread, small, narrow, shrunk and the finest width of boxes, and spans of all unknowns
#: that compiled code has room for.
CompiledRules: TypeAlias = tuple[float, float, float, float, float, float, tuple[float, ...]]
#: Relative width of boxes that are as narrow as rounding lets them be.
NARROW = 2.0**-44


class BoxVerdict(IntEnum):
    """No root; exactly one; not known, and no use to cut it; its points are to be parted; it has
    become narrower; it is to be halved.
    """

    DROPPED = 0
    PROVED = 1
    UNDECIDED = 2
    PARTED = 3
    AGAIN = 4
    HALVED = 5


@dataclass(frozen=True)
class Rules:
    """Of :class:`spragsym.numerics.boxes.BoxOptions` those that are asked here, and ``sharp`` where
    points are points. Over a box of them roots are as wide as it makes them, and what is cut
    closely has no room for these. ``spans`` are how far the unknowns reach, where that is far from
    1: what is cut where slopes tell nothing is widest in proportion to these.
    """

    margin: float
    spread: float
    small: float
    narrow: float
    shrunk: float
    sharp: bool
    spans: FloatArray

    @property
    def compiled(self) -> CompiledRules:
        """The numbers as compiled code takes them, with room for its most unknowns."""
        spans = (*self.spans.tolist(), *[1.0] * contractors.MOST)[: contractors.MOST]
        return self.margin, self.spread, self.small, self.narrow, self.shrunk, NARROW, spans


@dataclass(frozen=True)
class Looked:
    """N boxes that are looked at, each −low and high, shape (2, n, N): as they were ``given``, as
    they are contracted, and ``wide``, with room around; F at ``middle`` and slopes over ``wide``.

    ``single`` and ``spent``, shape (N,): of one point, and looked at often enough.
    """

    given: FloatArray
    ends: FloatArray
    wide: FloatArray
    middle: FloatArray
    values: Intervals
    slopes: Intervals
    single: BoolArray
    spent: BoolArray


@dataclass(frozen=True)
class Judged:
    """Ends of interval Newton's step, where the root of a proved box lies; of boxes that are to be
    looked at again what is left; a :class:`BoxVerdict` each; and the unknown in which one is cut.
    """

    step: FloatArray
    left: FloatArray
    verdicts: Int8Array
    along: IntArray


def judged(boxes: Looked, rules: Rules) -> Judged:
    """Verdicts by NumPy, where no plan has them by compiled code."""
    middle, before, wide = boxes.middle, boxes.ends, boxes.wide
    found = contractors.newton(
        boxes.values, boxes.slopes, middle, contractors.distance(wide, middle)
    )
    ends, dropped = found.ends, found.none | contractors.apart(found.ends, before)
    if rules.sharp:
        by_rows, none = contractors.by_each_row(
            boxes.values, boxes.slopes, middle, contractors.distance(before, middle)
        )
        ends = np.fmin(ends, by_rows)
        empty = np.logical_or.reduce(width_of(ends) < 0) | contractors.apart(ends, before)
        dropped |= none | empty
    now = with_room(ends, before, found.noise, rules.margin)
    closed = np.logical_and.reduce(found.ends < wide)
    verdicts = np.select(  # the first that holds
        [np.logical_and.reduce(closed), dropped],
        [BoxVerdict.PROVED, BoxVerdict.DROPPED],
        _divided(boxes, now, found.noise, closed, rules),
    ).astype(np.int8)
    return Judged(found.ends, now, verdicts, _most_told(now, boxes.slopes, closed, rules.spans))


def with_room(
    ends: FloatArray, given: FloatArray, noise: FloatArray | float, margin: float
) -> FloatArray:
    """A box narrowed, but not to the last digit: a component that converges before the others keeps
    room until all are proved.
    """
    return np.fmin(ends + (margin * Intervals(given).width + 4 * noise), given)


def _divided(
    boxes: Looked, now: FloatArray, noise: FloatArray, closed: BoolArray, rules: Rules
) -> IntArray:
    """Ways in which boxes that are neither dropped nor proved are divided."""
    widths, single, spent = width_of(now), boxes.single, boxes.spent
    scale = scale_of(now).max(axis=0)
    # What shrinks towards an exact 0 does so down to the least of floats: it is no progress.
    ratio = np.where(widths <= NARROW * scale, 1.0, widths / width_of(boxes.given))
    moved = ~np.logical_and.reduce(noise < rules.spread * widths)
    stuck = np.logical_or.reduce(noise >= rules.spread * widths) & np.logical_and.reduce(
        widths <= rules.small * scale
    )
    narrow = np.logical_and.reduce(widths <= rules.narrow * scale)
    done = (single & (spent | stuck)) | (narrow & (single | ~moved))
    better = np.where(closed, 1.0, ratio).prod(axis=0) < rules.shrunk
    return np.select(  # the first that holds
        [done, ~single & (spent | moved), better],
        [BoxVerdict.UNDECIDED, BoxVerdict.PARTED, BoxVerdict.AGAIN],
        BoxVerdict.HALVED,
    )


def _most_told(
    now: FloatArray, slopes: Intervals, closed: BoolArray, spans: FloatArray
) -> IntArray:
    """The unknown in which the residuals change most in proportion to all that they change.

    A component that interval Newton maps into the interior is not what keeps the box open.
    """
    widths = width_of(now)
    change = slopes.magnitude * widths[None]
    share = (change / change.sum(axis=1, keepdims=True)).sum(axis=0)
    finite = np.isfinite(share).all(axis=0)
    # What is as narrow as rounding allows gets no narrower by halving.
    done = closed | (widths <= NARROW * scale_of(now).max(axis=0))
    return np.where(done, -1.0, np.where(finite, share, widths / spans[:, None])).argmax(axis=0)
