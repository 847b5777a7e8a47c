"""Acceptance of the roots that a search finds: near folds and cusps, by contact side, within one
turn.

Roots that float64 does not decide are decided in ball arithmetic, at one point of the parameters.

A search excludes boxes beyond a contact's border; a box that meets the border may hold a root on
either side. So the sign of the gap is proved at the root itself: over its box in floats or, where
that box meets the border, over a narrower box of balls. A gap that is 0, as of a contact without
load, is proved where the coordinates on which it depends are proved to be floats. If balls do not
tell the gap from 0 otherwise, the root becomes an undecided box.
"""

from collections import Counter
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction

import numpy as np

from ..numerics import balls, contractors
from ..numerics.arithmetic import determinant
from ..numerics.balls import Ball, UndecidedSign
from ..numerics.certified_roots import Roots, different, distinct
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals, quiet, width_of
from ..numerics.precise_roots import (
    Reduced,
    as_intervals,
    exact_ends,
    lies_in,
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
    """The roots, with narrower boxes by ball arithmetic where the error exceeds the tolerance, and
    for those marked in ``among``.
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
    """The result of a search after ball arithmetic has treated undecided and inaccurate clusters.

    A root that is known to be alone in its box is only narrowed. Points with more clusters than
    ``most``, unless the options give another number, are left as they are. Points with more
    undecided boxes than the option ``folded`` are left with the hull of these boxes.
    """
    options = system.options
    most = most if options.clusters is None else options.clusters
    many = np.flatnonzero(np.bincount(found.undecided_point) > options.folded)
    if many.size:
        merged = [
            found.undecided[:, :, found.undecided_point == point].max(axis=2) for point in many
        ]
        others = refined_in_digits(system, given, box, found.of(many, others=True), most=most)
        roots = found.of(many).select(undecided=slice(0))
        return others.concatenated(roots.with_undecided(np.stack(merged, axis=2), many))
    found = refined(system, given, found)
    poor = ~(found.error <= options.tolerance)
    boxes = np.concatenate([found.undecided, found.ends[:, :, poor] + 2.0**-13], axis=2)
    hulls, owner = clusters(boxes, np.concatenate([found.undecided_point, found.point[poor]]))
    points, which, count = np.unique(owner, return_inverse=True, return_counts=True)
    few = count <= most
    parts, failures = list[Roots](), Counter[int]()
    for k, point in enumerate(owner.tolist()):
        if few[which[k]]:
            own, hull = found.of(np.array([point])), hulls[:, :, k]
            if failures[point] < options.open_clusters:
                part = _or_known(own, hull, reduced(system, given[:, point], hull, point))
            else:
                inside = contractors.within(own.ends, hull[:, :, None])
                roots = own.select(inside, slice(0))
                part = roots.with_undecided(hull[:, :, None], np.array([point]))
            failures[point] += part.undecided_point.size > options.open_parts
            parts.append(part)
    if not parts:
        return found
    mine = found.of(points[few])
    accurate = mine.select(mine.error <= options.tolerance, slice(0))
    again = different(accurate.concatenated(*parts), box)
    # Clusters were widened, and may have undecided parts outside of the searched box.
    inside = ~contractors.apart(again.undecided, box[:, :, again.undecided_point])
    return found.of(points[few], others=True).concatenated(again.select(undecided=inside))


def _or_known(found: Roots, hull: FloatArray, part: Roots) -> Roots:
    """The roots ``part`` of a cluster by ball arithmetic or, if these are incomplete, the float
    roots.

    The float roots serve only if they lie in the hull of the cluster and nothing else there is
    undecided.
    """
    inside = contractors.within(found.ends, hull[:, :, None])
    decided = contractors.apart(found.undecided, hull[:, :, None]).all()
    if part.undecided.shape[2] and inside.any() and decided:
        return found.select(inside, slice(0))
    return part


def reduced(system: StateSystem, given: FloatArray, cluster: FloatArray, point: int = 0) -> Roots:
    """Roots of a system in one cluster, at point number ``point``, by reduction to one unknown.

    Twice the number of bits is tried if something remains undecided.
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
    """Hulls of boxes of the same point that meet, shape (2, n, clusters), and the point of each.

    Two boxes meet if one of them, widened by half its width, intersects the other. Hulls are merged
    until no two meet.
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
    """Boxes widened by half their width on either side."""
    return boxes + (0.5 * width_of(boxes) + 1e-8)


def on_contact_side(system: StateSystem, given: FloatArray, found: Roots) -> Roots:
    """The roots on the required side of the contacts' borders; roots that may lie on a border
    become undecided boxes.

    ``given`` are parameters, shape (parameters, points).
    """

    def beside_border(ends: FloatArray, point: IntArray) -> tuple[BoolArray, BoolArray]:
        return on_side(system, system.prepared_at(given[:, point]), ends)

    inside, beyond = beside_border(found.ends, found.point)
    for row in np.flatnonzero(~(inside | beyond)).tolist():
        precise = PreciseBalance(system, given[:, found.point[row]], system.options.root_bits)
        root = _located(precise, found.ends[:, :, row], found.alone[:, :, row])
        inside[row : row + 1], beyond[row : row + 1] = _sides(precise, root)
    found = found.reopened(inside, ~(inside | beyond))
    return found.select(undecided=~beside_border(found.undecided, found.undecided_point)[1])


def decided_at_edges(system: StateSystem, given: FloatArray, found: Roots) -> Roots:
    """The result with undecided boxes that hold one root as roots, if that is a state in the box.

    Where the gap of a contact is a coordinate, the searched region ends at the border, and a search
    does not decide a root on an end of its region.
    """
    most, roots = 24, dict[int, FloatArray]()
    count = found.undecided_point.size
    if not 0 < count <= most:
        return found
    with quiet():
        parameters = system.prepared_at(given[:, found.undecided_point])
        slopes = system.jacobian(Intervals(found.undecided), parameters)
        is_regular = determinant([[*row] for row in slopes]).signs != 0
    for row in np.flatnonzero(is_regular).tolist():
        box = found.undecided[:, :, row]
        precise = PreciseBalance(
            system, given[:, found.undecided_point[row]], system.options.root_bits
        )
        root = _located(precise, box)
        if root and lies_in(root, box) and _sides(precise, root)[0].all():
            roots[row] = as_intervals(root).ends
    if not roots:
        return found
    rows = [*roots]
    decided = Roots.at(
        np.concatenate([*roots.values()], axis=2),
        found.undecided[:, :, rows],
        found.undecided_point[rows],
    )
    found = found.select(undecided=~np.isin(np.arange(count), rows))
    return distinct(found.concatenated(decided))


def _located(
    precise: PreciseBalance, box: FloatArray, alone: FloatArray | None = None
) -> list[Ball]:
    """The root in a box in balls, with coordinates that are floats as these; empty if none is
    proved. Arguments as of :func:`narrowed`.
    """
    with suppress(UndecidedSign, ZeroDivisionError):
        root = narrowed(precise, box, alone)
        return [] if root is None else exact_in_part(precise, root)
    return []


def _sides(precise: PreciseBalance, root: Sequence[Ball]) -> tuple[BoolArray, BoolArray]:
    """Masks of shape (1,) whether a root is on the required side of all borders, and beyond one."""
    unknown = np.zeros(1, dtype=bool)
    with suppress(UndecidedSign, ZeroDivisionError):
        gaps = precise.state(root).gaps() if root else []
        if gaps and all(isinstance(gap, Ball) for gap in gaps):
            # As floats they are rounded outward, but for a gap that is exactly 0.
            nonzero = np.array([[not balls.is_exactly_zero(gap)] for gap in gaps])
            return precise.balance.sides([*Intervals(as_intervals(gaps).ends * nonzero)])
    return unknown, unknown


def exact_in_part(system: PreciseBalance, root: Sequence[Ball]) -> list[Ball]:
    """The box of a root with coordinates replaced by the floats that they are proved to be.

    If all residuals are exactly 0 at the nearest floats, these are the root. If one residual is 0
    for one coordinate at its float and all values of the others, and its slope by that coordinate
    is not 0, the coordinate is that float, by the mean value theorem.
    """
    found, floats = list(root), [_nearest_float(part) for part in root]
    if all(number is None for number in floats):
        return found
    at = [part if number is None else number for part, number in zip(found, floats, strict=True)]
    if None not in floats and all(balls.is_exactly_zero(value) for value in system.values(at)):
        return at
    slopes = system.slopes(found)
    for _ in found:  # what is exact may make the residual of another coordinate exact
        for j, number in enumerate(floats):
            if number is None:
                continue
            at = [*found[:j], number, *found[j + 1 :]]
            rows = zip(system.values(at), slopes, strict=True)
            if any(balls.is_exactly_zero(value) and balls.sign(row[j]) for value, row in rows):
                found = at
    return found


def _nearest_float(part: Ball) -> Ball | None:
    """0 or the float nearest to the midpoint, as an exact ball; None if it is not in the ball."""
    low, high = balls.ends(part)
    number = 0.0 if low <= 0 <= high else float((low + high) / 2)
    return balls.ball(number, part.bits) if low <= Fraction(number) <= high else None


def on_side(
    system: StateSystem, parameters: Intervals, ends: FloatArray
) -> tuple[BoolArray, BoolArray]:
    """Masks of boxes, shape (2, n, N), on the required side of the borders, and of boxes beyond."""
    with quiet():
        gaps = Boxes(system, Intervals(ends), parameters).taped(*GAPS)
        return system.balance.sides(list(gaps))


def reduced_by_turns(periodic: Iterable[int], found: Roots) -> Roots:
    """Roots and undecided boxes within one turn of each periodic angle, without their images.

    A root whose box meets an end of the turn becomes an undecided box.
    """
    angles = list(periodic)
    if not angles:
        return found
    beyond, across = _parted(found.ends, angles)
    hidden, _ = _parted(found.undecided, angles)
    return found.select(undecided=~hidden).reopened(~beyond & ~across, across & ~beyond)


def _parted(ends: FloatArray, periodic: Sequence[int]) -> tuple[BoolArray, BoolArray]:
    """Masks of boxes outside of the turn, and of boxes that meet an end of it, for any of the
    angles.
    """
    low, high = -ends[0, periodic], ends[1, periodic]
    end = TURN_BEGIN + TURN  # the search goes beyond both ends
    beyond = np.logical_or.reduce((low > end) | (high < TURN_BEGIN))
    across = np.logical_or.reduce(
        (low <= end) & (high >= end) | (low <= TURN_BEGIN) & (high >= TURN_BEGIN)
    )
    return beyond, across
