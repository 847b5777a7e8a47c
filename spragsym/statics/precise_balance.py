"""Acceptance of what a search finds: with many digits near folds and cusps, on one side of the
contact's border, within one turn.

What float64 does not decide is decided by the balance of forces with many digits, at one point of
parameters.

A search excludes boxes that lie beyond the border; a box that meets it may hold a root on either
side. So the sign of the gap is proved at the root itself: over the box in which it is known to
floats, and where that meets the border over one of many digits. What digits do not tell from a root
on the border is among the boxes that are left.
"""

from collections import Counter
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np

from ..numerics import contractors
from ..numerics.balls import Ball, UndecidedSign
from ..numerics.certified_roots import Roots, different
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals, quiet, width_of
from ..numerics.precise_roots import (
    Reduced,
    as_intervals,
    exact_ends,
    narrowed,
    outward,
    reduced_roots,
)
from ..numerics.vectors import TURN, TURN_BEGIN
from .balance import PreciseBalance
from .systems import GAPS, Boxes, StateSystem


def refined(
    system: StateSystem, given: FloatArray, found: Roots, among: BoolArray | bool = False
) -> Roots:
    """Roots in narrower boxes where the error is beyond the tolerance of the options, and others
    ``among`` them.
    """
    ends = found.ends.copy()
    for root in np.flatnonzero(~(found.error <= system.options.tolerance) | among):
        box = narrowed(
            PreciseBalance(system, given[:, found.point[root]], system.options.root_bits),
            ends[:, :, root],
            found.alone[:, :, root],
        )
        if box is not None:
            ends[:, :, root] = np.fmin(as_intervals(box).ends[:, :, 0], ends[:, :, root])
    return replace(found, ends=ends)


def refined_in_digits(
    system: StateSystem,
    given: FloatArray,
    box: FloatArray,
    found: Roots,
    *,
    most: int = 24,
) -> Roots:
    """Clusters that a search has left or knows to few digits, with many digits, one after the
    other; a root that is known to be alone has its digits before that.

    Not of points with more clusters than ``most``, if the options do not say, nor with more boxes
    than their ``folded``, of which the hull is left.
    """
    options = system.options
    most = most if options.clusters is None else options.clusters
    many = np.flatnonzero(np.bincount(found.undecided_point) > options.folded)
    if many.size:
        whole = [
            found.undecided[:, :, found.undecided_point == point].max(axis=2) for point in many
        ]
        decided = refined_in_digits(system, given, box, found.of(many, others=True), most=most)
        return decided.concatenated(
            found.of(many).select(undecided=slice(0)).with_undecided(np.stack(whole, axis=2), many)
        )
    found = refined(system, given, found)
    poor = ~(found.error <= options.tolerance)
    boxes = np.concatenate([found.undecided, found.ends[:, :, poor] + 2.0**-13], axis=2)
    hulls, owner = clusters(boxes, np.concatenate([found.undecided_point, found.point[poor]]))
    points, which, count = np.unique(owner, return_inverse=True, return_counts=True)
    few = count <= most
    parts, lost = list[Roots](), Counter[int]()
    for k, point in enumerate(owner.tolist()):
        if few[which[k]]:
            own, hull = found.of(np.array([point])), hulls[:, :, k]
            if lost[point] < options.open_clusters:
                part = _or_known(own, hull, reduced(system, given[:, point], hull, point))
            else:
                part = own.select(
                    contractors.within(own.ends, hull[:, :, None]), slice(0)
                ).with_undecided(hull[:, :, None], np.array([point]))
            lost[point] += part.undecided_point.size > options.open_parts
            parts.append(part)
    if not parts:
        return found
    mine = found.of(points[few])
    again = different(
        mine.select(mine.error <= options.tolerance, slice(0)).concatenated(*parts), box
    )
    # Clusters are looked at in boxes that are wider than they are.
    inside = ~contractors.apart(again.undecided, box[:, :, again.undecided_point])
    return found.of(points[few], others=True).concatenated(again.select(undecided=inside))


def _or_known(found: Roots, hull: FloatArray, part: Roots) -> Roots:
    """Roots of a cluster by many digits; where they leave something, roots that are known already,
    to few digits.
    """
    inside = contractors.within(found.ends, hull[:, :, None])
    if (
        not part.undecided.shape[2]
        or not inside.any()
        or not contractors.apart(found.undecided, hull[:, :, None]).all()
    ):
        return part
    return found.select(inside, slice(0))


def reduced(system: StateSystem, given: FloatArray, cluster: FloatArray, point: int = 0) -> Roots:
    """Roots of a system in a cluster, at one point of that number, with more bits if fewer leave
    something.
    """
    cluster = cluster + (0.25 * width_of(cluster) + 1e-9)
    middle = Intervals(cluster).middle
    with quiet():
        parameters = system.prepared_at(given[:, None])
        slopes = system.jacobian(Intervals.point(middle[:, None]), parameters).middle[:, :, 0]
        pole = bool(system.abandoned(Intervals(cluster[:, :, None]), parameters, 4)[0])
    box = exact_ends(cluster)
    found = Reduced([], [], [box])
    options = system.options
    for bits in (options.bits, 2 * options.bits) if not pole and np.isfinite(slopes).all() else ():
        with suppress(UndecidedSign):
            precise = PreciseBalance(system, given, bits)
            found = reduced_roots(precise.values, box, slopes, bits, options)
            if not found.undecided or len(found.undecided) > options.open_parts:
                break
    ends, alone, left = (
        np.concatenate([np.empty((2, len(box), 0)), *(outward(one).ends for one in boxes)], axis=2)
        for boxes in (found.roots, found.alone, found.undecided)
    )
    return Roots(ends, alone, np.full(ends.shape[2], point), left, np.full(left.shape[2], point))


def clusters(boxes: FloatArray, point: IntArray) -> tuple[FloatArray, IntArray]:
    """Hulls of boxes of the same point, shape (2, n, N), that meet each other, until no two hulls
    meet; and the point of each.

    Two meet if one of them, widened by half of itself, meets the other.
    """
    parts, owner = [boxes[:, :, :0]], list[IntArray]()
    for number in np.unique(point):
        hulls = boxes[:, :, :0]
        for box in np.moveaxis(boxes[:, :, point == number], 2, 0):
            hull = box[:, :, None]
            while (
                meet := ~(
                    contractors.apart(_widened(hulls), hull)
                    & contractors.apart(hulls, _widened(hull))
                )
            ).any():
                hull = np.concatenate([hull, hulls[:, :, meet]], axis=2).max(axis=2, keepdims=True)
                hulls = hulls[:, :, ~meet]
            hulls = np.concatenate([hulls, hull], axis=2)
        parts.append(hulls[:, :, np.argsort(-hulls[0, 0], kind="stable")])
        owner.append(np.full(hulls.shape[2], number))
    return np.concatenate(parts, axis=2), np.concatenate([point[:0], *owner])


def _widened(boxes: FloatArray) -> FloatArray:
    return boxes + (0.5 * width_of(boxes) + 1e-8)


def on_contact_side(system: StateSystem, given: FloatArray, found: Roots) -> Roots:
    """Roots on the side of the border that was asked for; those that may lie on it among the boxes
    that are left.

    ``given`` are parameters, shape (parameters, points).
    """

    def beside_border(ends: FloatArray, point: IntArray) -> tuple[BoolArray, BoolArray]:
        return on_side(system, system.prepared_at(given[:, point]), ends)

    inside, beyond = beside_border(found.ends, found.point)
    for row in np.flatnonzero(~(inside | beyond)).tolist():
        digits = PreciseBalance(system, given[:, found.point[row]], system.options.root_bits)
        with suppress(UndecidedSign, ZeroDivisionError):
            root = narrowed(digits, found.ends[:, :, row], found.alone[:, :, row])
            gaps = [] if root is None else digits.state(root).gaps()
            if gaps and all(isinstance(gap, Ball) for gap in gaps):
                inside[row : row + 1], beyond[row : row + 1] = digits.balance.sides(
                    list(as_intervals(gaps))
                )
    found = found.reopened(inside, ~(inside | beyond))
    return found.select(undecided=~beside_border(found.undecided, found.undecided_point)[1])


def on_side(
    system: StateSystem, parameters: Intervals, ends: FloatArray
) -> tuple[BoolArray, BoolArray]:
    """Boxes, shape (2, n, N), that lie on the side asked for, its border included, and boxes that
    lie beyond it.
    """
    with quiet():
        gaps = Boxes(system, Intervals(ends), parameters).taped(*GAPS)
        return system.balance.sides(list(gaps))


def reduced_by_turns(periodic: Iterable[int], found: Roots) -> Roots:
    """Roots and boxes that are left, without those whose image after a turn is there too.

    What meets an end of the turn itself, of which this can't be said, is among the boxes that are
    left.
    """
    angles = list(periodic)
    if not angles:
        return found
    beyond, across = _parted(found.ends, angles)
    hidden, _ = _parted(found.undecided, angles)
    return found.select(undecided=~hidden).reopened(~beyond & ~across, across & ~beyond)


def _parted(ends: FloatArray, periodic: Sequence[int]) -> tuple[BoolArray, BoolArray]:
    """Boxes that lie beyond the turn with one of these unknowns, and boxes that meet an end of
    it.
    """
    low, high = -ends[0, periodic], ends[1, periodic]
    # Where the turn ends; the search goes beyond it at both ends.
    end = TURN_BEGIN + TURN
    beyond = np.logical_or.reduce((low > end) | (high < TURN_BEGIN))
    across = np.logical_or.reduce(
        (low <= end) & (high >= end) | (low <= TURN_BEGIN) & (high >= TURN_BEGIN)
    )
    return beyond, across
