"""The balance of forces with many digits, at one point of parameters: what float64 does not decide near folds and cusps."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import partial
from types import MappingProxyType
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.sparse.csgraph import connected_components

from ..exact import certified_roots, contractors, many_reductions
from ..exact.ball_functions import XP
from ..exact.boxes import POLE, System
from ..exact.certified_roots import Roots
from ..exact.interval_arrays import FloatArray, Intervals
from ..exact.intervals import Ball, Balls
from ..exact.polynomials import Undecided
from ..exact.reduction import Evaluate, Reduced, reduced_roots
from .balance import Balance
from .wide import WideBalance

#: Ends of parameters that lie in a range.
Spans: TypeAlias = Mapping[str, tuple[Fraction, Fraction]]
#: Ends of roots and of boxes in which each is alone.
Known: TypeAlias = tuple[FloatArray, FloatArray] | None
#: Bits of the forces.
BITS = (160, 320)
#: Bound on the error up to which a state counts as settled.
TOLERANCE = 1e-12
#: Clusters of boxes of a point: more lie around no equilibria.
CLUSTERS = 24
#: Boxes that are compared with each other at once.
TOGETHER = 512
#: Half-width of the box around a root that is known, but not well enough.
AROUND = 2.0**-13


class PreciseBalance:
    """Forces of a balance at one point, of balls or jets of balls; ``spans`` are parameters that lie in a range."""

    def __init__(self, balance: Balance, given: FloatArray, bits: int, spans: Spans = MappingProxyType({})) -> None:
        self.balance = balance
        self.values: dict[str, Any] = {}
        for name, number in zip(balance.parameters, given, strict=True):
            if name in spans:
                with Balls().precision(bits):
                    value = Balls().between(*spans[name])
            else:
                value = ball(float(number), bits)
            if name in balance.angles:
                self.values |= zip(balance.angles[name], Balls().cos_sin(value), strict=True)
            else:
                self.values[name] = value

    def forces(self, q: Sequence[Any]) -> Sequence[Any]:
        """The balance."""
        directions = self.balance.plain_directions(q, self.values, XP)
        rows: Sequence[Any] = self.balance.call("forces", q, directions, self.values, XP)
        return rows


def ball(value: float, bits: int) -> Ball:
    """A float, exactly."""
    numerator, denominator = value.as_integer_ratio()
    return Ball(numerator, 0, 1 - denominator.bit_length(), bits)


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


def settled(balance: Balance, given: FloatArray, around: FloatArray, found: Roots) -> Roots:
    """What is unsettled after double-double, looked at again with many digits."""
    points = unsettled(found)
    if not points.size:
        return found
    regions = np.broadcast_to(around, (*around.shape[:2], given.shape[1]))
    hulls = {int(at): clusters(boxes_of(found, int(at))) for at in points}
    points = np.array([at for at, some in hulls.items() if len(some) <= CLUSTERS], dtype=np.int64)
    if not points.size:
        return found
    tasks = [(int(at), cluster) for at in points for cluster in hulls[int(at)]]
    known = _by_double_double(balance, given, tasks)
    parts = [
        of_point(
            regions[:, :, at],
            found,
            int(at),
            [(cluster, roots) for (point, cluster), roots in zip(tasks, known, strict=True) if point == at],
            partial(_reduced, balance, given[:, at]),
        )
        for at in points
    ]
    sizes, left_sizes = ([getattr(part, name).size for part in parts] for name in ("point", "left_point"))
    again = Roots(
        np.concatenate([part.ends for part in parts], axis=2),
        np.concatenate([part.alone for part in parts], axis=2),
        np.repeat(np.arange(points.size), sizes),
        np.concatenate([part.left for part in parts], axis=2),
        np.repeat(np.arange(points.size), left_sizes),
    )
    return replaced(found, points, again)


def boxes_of(found: Roots, point: int) -> FloatArray:
    """Boxes of a point that are left, and boxes around its roots that are known to few digits."""
    mine = np.flatnonzero(found.point == point)
    poor = mine[~(found.error[mine] <= TOLERANCE)]
    return np.concatenate([found.left[:, :, found.left_point == point], found.ends[:, :, poor] + AROUND], axis=2)


def _by_double_double(balance: Balance, given: FloatArray, tasks: Sequence[tuple[int, FloatArray]]) -> list[Known]:
    """Ends of roots in clusters of points and of boxes in which each is alone; None where that takes more digits."""
    wide = WideBalance(balance.model, balance.contact, balance.law)
    points = np.array([point for point, _ in tasks], dtype=np.int64)
    boxes = np.stack([cluster for _, cluster in tasks], axis=-1)
    boxes = boxes + 0.25 * (boxes[0] + boxes[1]) + 1e-9
    with np.errstate(all="ignore"):
        parameters = wide.prepared(Intervals.point(given[:, points]))
        slopes = wide.jacobian(Intervals.point(Intervals(boxes).middle), parameters).middle

        def forces(rows: NDArray[np.int64], q: Sequence[Any]) -> Sequence[Any]:
            out: Sequence[Any] = wide.wide_forces(q, wide.wide_values(parameters[:, rows]))
            return out

        found = many_reductions.reduced_roots(forces, boxes, slopes)
    error = certified_roots.relative_error(found.ends, Intervals(found.ends).middle)
    found.open[found.box[~(error <= TOLERANCE)]] = True
    return [
        None if found.open[k] else (found.ends[:, :, found.box == k], found.alone[:, :, found.box == k])
        for k in range(points.size)
    ]


def of_point(
    region: FloatArray,
    found: Roots,
    point: int,
    tasks: Sequence[tuple[FloatArray, Known]],
    reduce: Callable[[FloatArray], Reduced],
) -> Roots:
    """Roots and boxes left of one point, whose clusters of boxes are known or reduced to one unknown."""
    mine = np.flatnonzero(found.point == point)
    good = mine[found.error[mine] <= TOLERANCE]
    ends, alone, left = [found.ends[:, :, good]], [found.alone[:, :, good]], [np.empty((2, found.ends.shape[1], 0))]
    for cluster, known in tasks:
        if known is not None:
            ends.append(known[0])
            alone.append(known[1])
            continue
        by_digits = reduce(cluster + 0.25 * (cluster[0] + cluster[1]) + 1e-9)
        ends += [_outward(box) for box in by_digits.roots]
        alone += [_outward(box) for box in by_digits.alone]
        left += [_outward(box) for box in by_digits.left]
    every, only = np.concatenate(ends, axis=2), np.concatenate(alone, axis=2)
    order = np.argsort(-only[0, 0])
    every, only = every[:, :, order], only[:, :, order]
    keep, unclear = certified_roots.once(every, only, np.zeros(order.size, dtype=np.int64))
    keep = keep[~contractors.apart(every[:, :, keep], region[:, :, None])]
    border = ~contractors.within(every[:, :, keep], region[:, :, None])
    open_boxes = np.concatenate([*left, every[:, :, unclear], every[:, :, keep[border]]], axis=2)
    kept = keep[~border]
    return Roots(
        every[:, :, kept], only[:, :, kept], np.full(kept.size, point),
        open_boxes, np.full(open_boxes.shape[2], point),
    )  # fmt: skip


def _reduced(balance: Balance, given: FloatArray, cluster: FloatArray) -> Reduced:
    """Equilibria in a cluster."""
    return reduced(balance, given, cluster, lambda bits: PreciseBalance(balance, given, bits).forces)


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
        if not out.left:
            break
    return out


def _outward(box: Sequence[tuple[Fraction, Fraction]]) -> FloatArray:
    """Floats that lie outside of the ends or on them, shape (2, n, 1)."""
    ends = np.array([[-float(low) for low, _ in box], [float(high) for _, high in box]])
    out: FloatArray = np.nextafter(ends, np.inf)[:, :, None]
    return out


def clusters(boxes: FloatArray) -> list[FloatArray]:
    """Hulls of boxes, shape (2, n, N), that meet each other, until no two hulls meet."""
    hulls = boxes
    while True:
        parts = [_hulls(hulls[:, :, begin : begin + TOGETHER]) for begin in range(0, hulls.shape[2], TOGETHER)]
        merged = np.concatenate(parts, axis=2) if parts else hulls
        if merged.shape[2] == hulls.shape[2]:
            return list(np.moveaxis(merged, 2, 0))
        hulls = merged


def _hulls(boxes: FloatArray) -> FloatArray:
    """One hull for all boxes that meet, directly or through others, each widened by half of itself."""
    widened = boxes + (0.5 * (boxes[0] + boxes[1]) + 1e-8)
    meet = ~(widened[:, :, :, None] + boxes[::-1, :, None, :] < 0).any(axis=(0, 1))
    count, label = connected_components(meet, directed=False)
    order = np.argsort(label, kind="stable")
    begins = np.searchsorted(label[order], np.arange(count))
    hulls: FloatArray = np.maximum.reduceat(boxes[:, :, order], begins, axis=2)
    return hulls
