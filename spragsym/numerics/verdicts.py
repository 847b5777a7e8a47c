"""The decision about each box in branch and prune: it contains no root, or exactly one, or is
divided. By interval Newton in NumPy; compiled code does the same in ``_newton.h``.
"""

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

#: Margin, spread, small, narrow, shrunk, the smallest width, and spans, padded to the most unknowns
#: of compiled code.
CompiledRules: TypeAlias = tuple[float, float, float, float, float, float, tuple[float, ...]]
#: Relative width of boxes below which rounding makes further bisection useless.
NARROW = 2.0**-44


class BoxVerdict(IntEnum):
    """Decision about a box."""

    DROPPED = 0  #: no root
    PROVED = 1  #: exactly one root
    UNDECIDED = 2  #: not known, and bisection would not help
    PARTED = 3  #: separate the points of its node
    AGAIN = 4  #: it has become much narrower: examine it again
    HALVED = 5  #: bisect it


@dataclass(frozen=True)
class Rules:
    """Options of :class:`spragsym.numerics.boxes.BoxOptions` used here, with two more.

    ``sharp``: the parameters are points. Over a box of parameters a root is a set, and contraction
    row by row could cut into it. ``spans``, (n,), are the scales of the unknowns: if the slopes do
    not decide which unknown to bisect, the widest one in units of its scale is bisected.
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
        """The rules as compiled code takes them."""
        spans = (*self.spans.tolist(), *[1.0] * contractors.MOST)[: contractors.MOST]
        return self.margin, self.spread, self.small, self.narrow, self.shrunk, NARROW, spans


@dataclass(frozen=True)
class Looked:
    """N boxes to be decided, and F over them.

    Boxes are −low and high, (2, n, N): as ``given``, contracted (``ends``), and ``wide``, with a
    margin. ``values`` are F at ``middle``, ``slopes`` the Jacobian over ``wide``. ``single``, (N,):
    the node has one point. ``spent``, (N,): its budget is used up.
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
    """Decisions about N boxes.

    ``step``, (2, n, N), is interval Newton's result, which contains the root of a proved box.
    ``left``, (2, n, N), are the contracted boxes. ``verdicts``, (N,), are :class:`BoxVerdict`;
    ``along``, (N,), is the unknown in which a box would be bisected.
    """

    step: FloatArray
    left: FloatArray
    verdicts: Int8Array
    along: IntArray


def judged(boxes: Looked, rules: Rules) -> Judged:
    """Decide boxes by NumPy, for systems without a compiled plan."""
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
    verdicts = np.select(  # the first condition that is true
        [np.logical_and.reduce(closed), dropped],
        [BoxVerdict.PROVED, BoxVerdict.DROPPED],
        _divided(boxes, now, found.noise, closed, rules),
    ).astype(np.int8)
    return Judged(found.ends, now, verdicts, _to_bisect(now, boxes.slopes, closed, rules.spans))


def with_room(
    ends: FloatArray, given: FloatArray, noise: FloatArray | float, margin: float
) -> FloatArray:
    """Contracted boxes ``ends`` widened by a margin, within the ``given`` ones.

    A component that converges before the others must not become too narrow for the existence proof,
    which needs all of them.
    """
    return np.fmin(ends + (margin * Intervals(given).width + 4 * noise), given)


def _divided(
    boxes: Looked, now: FloatArray, noise: FloatArray, closed: BoolArray, rules: Rules
) -> IntArray:
    """Verdicts of boxes ``now`` that are neither dropped nor proved.

    ``noise``, (n, N), is the width of the root that the parameters or rounding cause.
    """
    widths, single, spent = width_of(now), boxes.single, boxes.spent
    scale = scale_of(now).max(axis=0)
    # A component that shrinks towards an exact 0 would do so down to the smallest float.
    ratio = np.where(widths <= NARROW * scale, 1.0, widths / width_of(boxes.given))
    moved = ~np.logical_and.reduce(noise < rules.spread * widths)
    stuck = np.logical_or.reduce(noise >= rules.spread * widths) & np.logical_and.reduce(
        widths <= rules.small * scale
    )
    narrow = np.logical_and.reduce(widths <= rules.narrow * scale)
    done = (single & (spent | stuck)) | (narrow & (single | ~moved))
    better = np.where(closed, 1.0, ratio).prod(axis=0) < rules.shrunk
    return np.select(  # the first condition that is true
        [done, ~single & (spent | moved), better],
        [BoxVerdict.UNDECIDED, BoxVerdict.PARTED, BoxVerdict.AGAIN],
        BoxVerdict.HALVED,
    )


def _to_bisect(
    now: FloatArray, slopes: Intervals, closed: BoolArray, spans: FloatArray
) -> IntArray:
    """The unknown to bisect, (N,): that with the largest share of the residuals' change over the
    box (smear rule).

    Components that interval Newton maps into their interior (``closed``), and those as narrow as
    rounding allows, are excluded.
    """
    widths = width_of(now)
    change = slopes.magnitude * widths[None]
    share = (change / change.sum(axis=1, keepdims=True)).sum(axis=0)
    finite = np.isfinite(share).all(axis=0)
    done = closed | (widths <= NARROW * scale_of(now).max(axis=0))
    return np.where(done, -1.0, np.where(finite, share, widths / spans[:, None])).argmax(axis=0)
