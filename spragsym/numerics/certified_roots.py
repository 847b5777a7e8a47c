"""From boxes with one root each to the roots of each point: once each, to full precision, with a bound on the error."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from . import boxes, contractors
from .boxes import Outcome, System
from .interval_arrays import FloatArray, Intervals, raised

#: Steps of interval Newton, of which each doubles the number of digits.
STEPS = 8
#: Relative half-width of boxes around what floats take for a root.
NEAR = 2.0**-40
#: Relative width up to which there is no further one.
DONE = 2.0**-50


@dataclass(frozen=True)
class Roots:
    """Roots of many points, sorted by point.

    Attributes
    ----------
    ends : ndarray
        Shape (2, n, roots): −low and high of a box that holds exactly one root, and no other root lies nearer than ``alone``.
    alone : ndarray
        Shape (2, n, roots): the larger box in which it is the only root.
    point : ndarray of int64
        The point of each.
    left : ndarray
        Shape (2, n, boxes): boxes of which it is not known what they hold.
    left_point : ndarray of int64
        The point of each.
    """

    ends: FloatArray
    alone: FloatArray
    point: NDArray[np.int64]
    left: FloatArray
    left_point: NDArray[np.int64]

    @property
    def middle(self) -> FloatArray:
        """Floats inside of the boxes, shape (n, roots)."""
        return Intervals(self.ends).middle

    @property
    def error(self) -> FloatArray:
        """Bound on |error| / max(1, |value|), over the unknowns, shape (roots,)."""
        return relative_error(self.ends, self.middle)


def concatenated(parts: Sequence[Roots], n: int) -> Roots:
    """Roots and boxes of several searches for n unknowns, one after the other."""
    none, nowhere = np.empty((2, n, 0)), np.empty(0, dtype=np.int64)
    every = [Roots(none, none, nowhere, none, nowhere), *parts]
    return Roots(
        np.concatenate([part.ends for part in every], axis=2),
        np.concatenate([part.alone for part in every], axis=2),
        np.concatenate([part.point for part in every]),
        np.concatenate([part.left for part in every], axis=2),
        np.concatenate([part.left_point for part in every]),
    )


def relative_error(ends: FloatArray, middle: FloatArray) -> FloatArray:
    """Bound on |x − middle| / max(1, |middle|) over the boxes, shape (2, n, N), the largest of the components."""
    out: FloatArray = raised((contractors.distance(ends, middle) / np.maximum(1.0, np.abs(middle))).max(axis=0))
    return out


def roots(system: System, outcome: Outcome, region: FloatArray, low: FloatArray, high: FloatArray) -> Roots:
    """The roots of each point, from what a search found; arguments as for :func:`spragsym.numerics.boxes.search`.

    A root that can't be told from one on the border of the region is among the boxes that are left.
    """
    n = outcome.unique.ends.shape[1]
    place, point = outcome.points.below(outcome.unique.nodes)
    alone = outcome.unique.ends[:, :, place]
    ends = np.minimum(outcome.where.ends[:, :, place], alone)
    order = np.lexsort((-alone[0, 0], point))
    point, alone, ends = point[order], alone[:, :, order], ends[:, :, order]
    with np.errstate(all="ignore"):
        ends, gone = _refined(system, ends, Intervals(np.stack([-low, high])), point)
        # Each holds a root; where a law ends at the root itself, as a contact's at the touch, refinement may lose it: undecided.
        lost, lost_point = alone[:, :, gone], point[gone]
        ends, alone, point = ends[:, :, ~gone], alone[:, :, ~gone], point[~gone]
        keep, unclear = once(ends, alone, point)
        around = np.broadcast_to(region, (*region.shape[:2], low.shape[1]))
        keep = keep[~contractors.apart(ends[:, :, keep], around[:, :, point[keep]])]
        border = ~contractors.within(ends[:, :, keep], around[:, :, point[keep]])
        keep, unclear = keep[~border], np.concatenate([unclear, keep[border]])
    place, left_point = outcome.points.below(outcome.undecided.nodes)
    left = np.concatenate([outcome.undecided.ends[:, :, place], ends[:, :, unclear], lost], axis=2).reshape(2, n, -1)
    left_point = np.concatenate([left_point, point[unclear], lost_point])
    return Roots(ends[:, :, keep], alone[:, :, keep], point[keep], left, left_point)


def _refined(
    system: System, ends: FloatArray, parameters: Intervals, point: NDArray[np.int64]
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """Boxes contracted until they do not get narrower; and whether one was found empty."""
    ends = ends.copy()
    empty = np.zeros(point.size, dtype=np.bool_)
    for begin in range(0, point.size, boxes.CHUNK):
        rows = np.arange(begin, min(begin + boxes.CHUNK, point.size))
        at = system.prepared(parameters[:, point[rows]])
        ends[:, :, rows], known = _guessed(system, ends[:, :, rows], at)
        rows, at = rows[~known], at[:, ~known]
        for _ in range(STEPS if rows.size else 0):
            before = ends[:, :, rows]
            step = stepped(system, before, at)
            empty[rows] |= contractors.apart(step.ends, before)
            new = np.fmin(step.ends, before)
            ends[:, :, rows] = new
            widths = new[0] + new[1]
            wide = widths > DONE * np.maximum(1.0, np.abs(new).max(axis=0))
            narrower = (wide & (widths < 0.75 * (before[0] + before[1]))).any(axis=0)
            rows, at = rows[narrower], at[:, narrower]
            if not rows.size:
                break
    return ends, empty


def stepped(system: System, ends: FloatArray, parameters: Intervals) -> contractors.Newton:
    """The step of interval Newton from the middles of boxes of shape (2, n, N)."""
    middle = Intervals(ends).middle
    values, slopes = system.at_points(middle, parameters), system.jacobian(Intervals(ends), parameters)
    return contractors.newton(values, slopes, middle, contractors.distance(ends, middle))


def _guessed(system: System, ends: FloatArray, parameters: Intervals) -> tuple[FloatArray, NDArray[np.bool_]]:
    """Small boxes around guesses, where interval Newton shows that the only root is there; the given ones elsewhere."""
    guess = system.guessed(Intervals(ends).middle, parameters)
    if guess is None:
        return ends, np.zeros(ends.shape[2], dtype=np.bool_)
    reach = NEAR * np.maximum(1.0, np.abs(guess))
    around = np.stack([reach - guess, reach + guess])
    step = stepped(system, around, parameters)
    known = contractors.inside(step.ends, around) & contractors.within(around, ends)
    return np.where(known, step.ends, ends), known


def once(ends: FloatArray, alone: FloatArray, point: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Rows of different roots, and rows that may be a root already found or another; sorted by point and lower end.

    Two boxes of a point hold the same root if one lies where the other's is alone, and different ones if they do not meet.
    """
    keep = np.ones(point.size, dtype=np.bool_)
    unclear = np.zeros(point.size, dtype=np.bool_)
    for shift in range(1, point.size):
        # In the order of the lower ends of the first unknown: boxes that do not overlap in it have no overlap farther on.
        near = (point[shift:] == point[:-shift]) & (alone[1, 0, :-shift] >= -alone[0, 0, shift:])
        if not near.any():
            break
        first = np.flatnonzero(near)
        second = first + shift
        alive = keep[first] & keep[second]
        first, second = first[alive], second[alive]
        one, other = ends[:, :, first], ends[:, :, second]
        same = contractors.within(other, alone[:, :, first]) | contractors.within(one, alone[:, :, second])
        keep[second[same]] = False
        unclear[second[~same & ~contractors.apart(one, other)]] = True
    unclear &= keep
    return np.flatnonzero(keep & ~unclear), np.flatnonzero(unclear)
