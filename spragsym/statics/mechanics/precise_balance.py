"""The balance of forces with many digits, at one point of parameters: what float64 does not decide near folds and cusps."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from types import MappingProxyType
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ...numerics import certified_roots, contractors
from ...numerics.ball_functions import XP
from ...numerics.boxes import POLE, System
from ...numerics.certified_roots import Roots
from ...numerics.interval_arrays import FloatArray, Intervals
from ...numerics.intervals import Balls
from ...numerics.krawczyk import ball, outward
from ...numerics.polynomials import Undecided
from ...numerics.reduction import Evaluate, Reduced, reduced_roots
from .balance import Balance

#: Ends of parameters that lie in a range.
Spans: TypeAlias = Mapping[str, tuple[Fraction, Fraction]]
#: A system at one point of parameters, with a number of bits.
Precise: TypeAlias = Callable[[FloatArray, int], Evaluate]
#: Bits of the forces.
BITS = (160, 320)
#: Bound on the error up to which a state counts as settled.
TOLERANCE = 1e-12
#: Clusters of boxes of a point: more lie around no equilibria.
CLUSTERS = 24
#: Parts that are left all over a cluster: more bits do not help.
ALL_OVER = 32
#: Boxes that are left of a point where roots form a line.
LINE = 500
#: Next boxes of the same point that a box is compared with at once.
TOGETHER = 512
#: Half-width of the box around a root that is known, but not well enough.
AROUND = 2.0**-13


class PreciseBalance:
    """Forces of a balance at one point, of balls or jets of balls; ``spans`` are parameters that lie in a range."""

    def __init__(self, balance: Balance, given: FloatArray, bits: int, spans: Spans = MappingProxyType({})) -> None:
        self.balance, self.bits = balance, bits
        self.arguments: dict[str, Any] = {}
        for name, number in zip(balance.parameters, given, strict=True):
            if name in spans:
                with Balls().precision(bits):
                    value = Balls().between(*spans[name])
            else:
                value = ball(float(number), bits)
            if name in balance.angles:
                self.arguments |= zip(balance.angles[name], Balls().cos_sin(value), strict=True)
            self.arguments[name] = value

    def values(self, unknowns: Sequence[Any]) -> Sequence[Any]:
        """Forces at coordinates."""
        return self._called("forces", unknowns)

    def slopes(self, unknowns: Sequence[Any]) -> Sequence[Sequence[Any]]:
        """Stiffness at coordinates."""
        return self._called("forces_jacobian", unknowns)

    def gap(self, unknowns: Sequence[Any]) -> Any:
        """Gap of the contact at coordinates."""
        return self.balance.gap(unknowns, self.arguments, XP)

    def _called(self, name: str, q: Sequence[Any]) -> Sequence[Any]:
        directions = self.balance.plain_directions(q, self.arguments, XP)
        rows: Sequence[Any] = self.balance.call(name, q, directions, self.arguments, XP)
        return rows


def unsettled(found: Roots) -> NDArray[np.int64]:
    """Points with boxes that are left, or with roots that are known to few digits only."""
    poor = ~(found.error <= TOLERANCE)
    out: NDArray[np.int64] = np.unique(np.concatenate([found.left_point, found.point[poor]]))
    return out


def replaced(found: Roots, points: NDArray[np.int64], again: Roots) -> Roots:
    """Roots and boxes of all points, those of the given ones by what a search among these has found."""
    old, left = ~np.isin(found.point, points), ~np.isin(found.left_point, points)
    return Roots(
        np.concatenate([found.ends[:, :, old], again.ends], axis=2),
        np.concatenate([found.alone[:, :, old], again.alone], axis=2),
        np.concatenate([found.point[old], points[again.point]]),
        np.concatenate([found.left[:, :, left], again.left], axis=2),
        np.concatenate([found.left_point[left], points[again.left_point]]),
    )


def clustered(given: FloatArray, around: FloatArray, found: Roots) -> Roots:
    """The same with one hull for each cluster of boxes that are left, and of boxes around roots that are known to few digits."""
    points = unsettled(found)
    if not points.size:
        return found
    hulls, owner = clusters(*boxes_of(found))
    none = np.empty((2, hulls.shape[1], 0))
    part = Roots(none, none, np.empty(0, dtype=np.int64), hulls, owner)
    return replaced(found, points, assembled(of_each(around, given), found, points, [part]))


def lines(found: Roots, most: int = LINE) -> NDArray[np.int64]:
    """Points of which more is left than lies around equilibria: where something is free to move they form lines."""
    return np.flatnonzero(np.bincount(found.left_point) > most)


def precise_forces(balance: Balance) -> Precise:
    """The balance at a point of parameters with a number of bits."""
    return lambda given, bits: PreciseBalance(balance, given, bits).values


def settled_by_digits(
    system: System, given: FloatArray, around: FloatArray, found: Roots, precise: Precise, without: Sequence[int] = ()
) -> Roots:
    """What a search has left or knows to few digits, with many digits, one point after the other; ``without`` some points."""
    if not unsettled(found).size:
        return found
    hulls, owner = clusters(*boxes_of(found))
    points, which, count = np.unique(owner, return_inverse=True, return_counts=True)
    few = (count <= CLUSTERS) & ~np.isin(points, without)
    points, hulls, owner = points[few], hulls[:, :, few[which]], owner[few[which]]
    parts = [
        with_digits(point, around.shape[1], _reduced(system, given[:, point], widened(hull), precise))
        for hull, point in zip(np.moveaxis(hulls, 2, 0), owner.tolist(), strict=True)
    ]
    return replaced(found, points, assembled(of_each(around, given), found, points, parts))


def of_each(around: FloatArray, given: FloatArray) -> FloatArray:
    """The region of each point."""
    return np.broadcast_to(around, (*around.shape[:2], given.shape[1]))


def hull_of_each(boxes: FloatArray, owner: NDArray[np.int64], count: int) -> FloatArray:
    """The hull of all boxes of each owner, as they are looked at."""
    order = np.argsort(owner, kind="stable")
    hulls: FloatArray = np.maximum.reduceat(boxes[:, :, order], np.searchsorted(owner[order], np.arange(count)), axis=2)
    return widened(hulls)


def at(found: Roots, points: NDArray[np.int64]) -> Roots:
    """Roots of some points by the numbers of all."""
    return replace(found, point=points[found.point], left_point=points[found.left_point])


def of_points(found: Roots, points: NDArray[np.int64]) -> Roots:
    """Roots and boxes of some points."""
    mine, left = np.isin(found.point, points), np.isin(found.left_point, points)
    return Roots(
        found.ends[:, :, mine], found.alone[:, :, mine], found.point[mine], found.left[:, :, left], found.left_point[left]
    )


def boxes_of(found: Roots) -> tuple[FloatArray, NDArray[np.int64]]:
    """Boxes that are left, and boxes around roots that are known to few digits, and the point of each."""
    poor = ~(found.error <= TOLERANCE)
    ends = np.concatenate([found.left, found.ends[:, :, poor] + AROUND], axis=2)
    return ends, np.concatenate([found.left_point, found.point[poor]])


def widened(hull: FloatArray) -> FloatArray:
    """The box in which a cluster is looked at."""
    out: FloatArray = hull + 0.25 * (hull[0] + hull[1]) + 1e-9
    return out


def with_digits(point: int, n: int, by_digits: Reduced) -> Roots:
    """What a reduction with many digits has found of a point, of n unknowns."""
    ends, alone, left = (
        np.concatenate([np.empty((2, n, 0)), *(outward(box).ends for box in boxes)], axis=2)
        for boxes in (by_digits.roots, by_digits.alone, by_digits.left)
    )
    return Roots(ends, alone, np.full(ends.shape[2], point), left, np.full(left.shape[2], point))


def assembled(regions: FloatArray, found: Roots, points: NDArray[np.int64], parts: Sequence[Roots]) -> Roots:
    """Roots of some points, each once, that are known well or are in the parts; boxes left; and both by places among the points.

    Parameters
    ----------
    regions : ndarray
        Shape (2, n, points), of all points.
    """
    good = np.isin(found.point, points) & (found.error <= TOLERANCE)
    every = np.concatenate([found.ends[:, :, good], *(part.ends for part in parts)], axis=2)
    only = np.concatenate([found.alone[:, :, good], *(part.alone for part in parts)], axis=2)
    point = np.concatenate([found.point[good], *(part.point for part in parts)])
    order = np.lexsort((-only[0, 0], point))
    every, only, point = every[:, :, order], only[:, :, order], point[order]
    keep, unclear = certified_roots.once(every, only, point)
    keep = keep[~contractors.apart(every[:, :, keep], regions[:, :, point[keep]])]
    border = ~contractors.within(every[:, :, keep], regions[:, :, point[keep]])
    open_ = np.concatenate([unclear, keep[border]])
    left = np.concatenate([*(part.left for part in parts), every[:, :, open_]], axis=2)
    left_point = np.concatenate([*(part.left_point for part in parts), point[open_]])
    # Clusters are looked at in boxes that are wider than they are.
    inside = ~contractors.apart(left, regions[:, :, left_point])
    left, left_point = left[:, :, inside], left_point[inside]
    kept = keep[~border]
    return Roots(
        every[:, :, kept], only[:, :, kept], np.searchsorted(points, point[kept]),
        left, np.searchsorted(points, left_point),
    )  # fmt: skip


def _reduced(system: System, given: FloatArray, cluster: FloatArray, precise: Precise) -> Reduced:
    """Roots in a cluster."""
    return reduced(system, given, cluster, lambda bits: precise(given, bits))


def reduced(system: System, given: FloatArray, cluster: FloatArray, precise: Callable[[int], Evaluate]) -> Reduced:
    """Roots of a system in a cluster, with more bits if fewer leave something; ``precise`` gives it for a number of bits."""
    middle = Intervals(cluster).middle
    with np.errstate(all="ignore"):
        parameters = system.prepared(Intervals.point(given[:, None]))
        slopes = system.jacobian(Intervals.point(middle[:, None]), parameters).middle[:, :, 0]
        pole = bool(system.given_up(Intervals(cluster[:, :, None]), parameters, 4 * POLE)[0])
    box = [(-float(low), float(high)) for low, high in cluster.T]
    whole = [(Fraction(low), Fraction(high)) for low, high in box]
    out = Reduced([], [], [whole])
    if pole or not np.isfinite(slopes).all():
        return out
    for bits in BITS:
        try:
            out = reduced_roots(precise(bits), box, slopes, bits)
        except Undecided:
            continue
        if not out.left or len(out.left) > ALL_OVER:
            break
    return out


def clusters(boxes: FloatArray, point: NDArray[np.int64]) -> tuple[FloatArray, NDArray[np.int64]]:
    """Hulls of boxes of the same point, shape (2, n, N), that meet each other, until no two hulls meet; and the point of each."""
    hulls = boxes
    while True:
        label = _meeting(hulls, point)
        order = np.argsort(label, kind="stable")
        begins = np.searchsorted(label[order], np.arange(label.max(initial=-1) + 1))
        if begins.size == label.size:
            order = np.lexsort((-hulls[0, 0], point))
            return hulls[:, :, order], point[order]
        hulls, point = np.maximum.reduceat(hulls[:, :, order], begins, axis=2), point[order][begins]


def _meeting(boxes: FloatArray, point: NDArray[np.int64]) -> NDArray[np.int64]:
    """One number for all boxes of a point that meet, directly or through others, each widened by half of itself."""
    from scipy.sparse import coo_array  # takes as long to import as all else that a first answer needs
    from scipy.sparse.csgraph import connected_components

    wide = boxes + (0.5 * (boxes[0] + boxes[1]) + 1e-8)
    order = np.lexsort((-wide[0, 0], point))
    boxes, wide, point = boxes[:, :, order], wide[:, :, order], point[order]
    pairs = [np.empty((2, 0), dtype=np.int64)]
    first = np.arange(point.size)
    for shift in range(1, min(point.size, TOGETHER)):
        # In the order of the lower ends: what begins beyond the end of a box does not meet it, nor does all that follows.
        first = first[first + shift < point.size]
        second = first + shift
        near = (point[first] == point[second]) & (wide[1, 0, first] + wide[0, 0, second] >= 0)
        first, second = first[near], second[near]
        if not first.size:
            break
        meet = ~contractors.apart(wide[:, :, first], boxes[:, :, second])
        meet |= ~contractors.apart(boxes[:, :, first], wide[:, :, second])
        pairs.append(np.stack([first[meet], second[meet]]))
    one, two = np.concatenate(pairs, axis=1)
    graph = coo_array((np.ones(one.size, dtype=np.bool_), (one, two)), shape=(point.size, point.size))
    label = np.empty(point.size, dtype=np.int64)
    label[order] = connected_components(graph, directed=False)[1]
    return label
