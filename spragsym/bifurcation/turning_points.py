"""Limit points (folds) reached by tubes: where states followed along a parameter v turn back,
proved.

Many points of the parameters are treated at once. The pivot of the tubes is a coordinate, so that
they pass the fold; see :mod:`spragsym.bifurcation.tubes`.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from ..numerics.columns import ByColumn
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, quiet
from .tubes import Place, Tubes, sizes_of


@dataclass(frozen=True)
class LimitPoints(ByColumn):
    """Folds z = (q, v), shape (n + 1, N), with lower and upper bounds of v.

    Only those marked ``proved`` are proved; the numbers of others have no meaning.
    """

    z: FloatArray
    low: FloatArray
    high: FloatArray
    proved: BoolArray


def limit_points(tubes: Tubes, start: Place, forward: int) -> LimitPoints:
    """The first folds reached from a place as v moves up (``forward`` 1) or down (−1).

    The tubes must be those of points. Secant steps on dv/ds along the curve give the fold in
    floats. Then segments that shrink towards it are proved to hold the curve, with v monotonic in
    each. A last segment across the fold, at whose end v goes back, holds the fold and bounds v.
    """
    low, high = np.full((2, start.proved.size), np.nan)
    out = LimitPoints(start.z.copy(), low, high, np.zeros(low.size, dtype=bool))
    for own, here, rows, by_v in pivots(tubes, start):
        moving = np.sign(by_v)
        towards = forward * moving
        z, met = secants(own, here.z, towards)
        met &= (z - here.z)[own.pivot] * towards > 0
        out.scatter(rows[met], _proved(own[met], here[met], z[:, met], moving[met], forward))
    return out


def past(tubes: Tubes, start: Place, forward: int, by: FloatArray) -> Place:
    """The states after v has moved on by ``by``, or as far as is proved, where the curve is steep.

    Places that have not moved at all are not proved.
    """
    out = start[np.arange(start.proved.size)]
    out.proved[:] = False
    for own, here, rows, by_v in pivots(tubes, start):
        begin, moving = start.v[rows], np.sign(by_v)
        by_s = own.tangents(here.z)[0]
        # A quarter of the distance if the curve stayed as steep.
        step = np.minimum(0.25 * np.abs(by_v * by[rows]), 0.1 * size_of(here.z)[own.pivot])
        goal, least = begin + forward * by[rows], 1e-4 * step
        open_ = own.rises(here, by_s) == moving
        for _ in range(tubes.options.steep_steps):
            on = np.flatnonzero(open_ & ((goal - here.v) * forward > 0) & (step > least))
            if not on.size:
                break
            good = _moved_on(own, here, by_s, on, forward * moving * step, moving)
            step[on] *= np.where(good, 1.5, 0.25)
        here.proved[:] = open_ & (here.v != begin)
        out.scatter(rows, here)
    return out


def passed(
    tubes: Tubes, start: Place, goal: FloatArray, sharp: bool = False
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Bounds of the value of ``vary`` up to which the states of a place exist as it rises: a value
    to which all are proved to exist, and a value above which all are proved to have ended.

    The first is at least ``start.z`` and, if all states reach it, the goal. The second is infinite
    if no fold below the goal is proved. Also returns bounds of |dv/dp| by each free parameter,
    shape (free, N). The pivot is a coordinate, and the tube passes the fold, where v begins to
    fall. A ``sharp`` answer is as near to the fold as the width of the boxes allows; otherwise the
    bounds only separate the fold from the goal.
    """
    safe, top, moves = start.v.copy(), np.full(goal.size, np.inf), np.zeros(tubes.half.shape)
    for own, here, rows, by_v in pivots(tubes, start):
        safe[rows], top[rows], moves[:, rows] = _passed(own, here, goal[rows], by_v, sharp)
        open_ = (safe[rows] < goal[rows]) & np.isinf(top[rows])
        if open_.any() and not sharp:
            # The fold, or the tube across it, may extend just above the goal.
            rows = rows[open_]
            safe[rows], _, moves[:, rows] = _passed(
                own[open_], here[open_], goal[rows], by_v[open_], over=False
            )
    return safe, top, moves


def _passed(
    tubes: Tubes,
    start: Place,
    goal: FloatArray,
    by_v: FloatArray,
    sharp: bool = False,
    over: bool = True,
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """:func:`passed` for tubes of one pivot; ``over`` says whether to pass the fold, or stop before
    it.
    """
    way, towards = goal - start.v, np.sign(by_v)
    straight = np.abs(by_v * way)
    by_s, by_p = tubes.tangents(start.z)
    safe, top, highest = start.v.copy(), np.full(goal.size, np.inf), np.full(goal.size, -np.inf)
    moves = np.abs(by_p[-1])
    open_ = tubes.rises(start, by_s) == towards
    rising = open_.copy()
    # The first step is longer than the spread of the pivot at the start.
    here = start[np.arange(goal.size)]
    step = np.maximum(0.25 * straight, 2 * start.half_width[tubes.pivot])
    for _ in range(tubes.options.turn_steps):
        rows = np.flatnonzero(open_ & (step > tubes.options.least_step * straight))
        if not rows.size:
            break
        at, own = here[rows], tubes[rows]
        good, end, tube = own.segment(at, at.z + by_s[:, rows] * (towards * step)[rows])
        up = np.zeros(rows.size, dtype=bool)
        up[good] = own[good].rises(tube[good], by_s[:, rows[good]]) == towards[rows[good]]
        good &= np.where(rising[rows], up, tube.box().high[-1] < goal[rows])
        # A sharp answer comes no nearer to the fold than v varies over the box of parameters.
        near = 0.1 * (goal[rows] - at.v)
        if sharp:
            near = np.minimum(
                near, 0.05 * (moves[:, rows] * own.half).sum(axis=0) + 2.0**-12 * way[rows]
            )
        turns = over & rising[rows] & ~good & (np.abs(by_s[-1, rows]) * step[rows] < near)
        rising[rows[turns]] = False
        step[rows] *= np.where(good, 1.5, np.where(turns, 0.5, 0.25))
        rows, end, own, tube = rows[good], end[good], own[good], tube[good]
        if not rows.size:
            continue
        here.scatter(rows, end)
        by_s[:, rows], by_p = own.tangents(end.z)
        moves[:, rows] = np.abs(by_p[-1])
        ends = end.box()[-1]
        safe[rows] = np.where(rising[rows], ends.low, safe[rows])
        # While v rises it is highest at the end.
        highest[rows] = np.maximum(
            highest[rows], np.where(rising[rows], ends.high, tube.box().high[-1])
        )
        falls = own.rises(end, by_s[:, rows]) == -towards[rows]
        top[rows] = np.where(~rising[rows] & falls, highest[rows], np.inf)
        open_[rows] = (safe[rows] <= goal[rows]) & np.isinf(top[rows])
    return safe, top, moves


def pivots(tubes: Tubes, start: Place) -> Iterator[tuple[Tubes, Place, IntArray, FloatArray]]:
    """Tubes with the pivot that moves most relative to its size, for all places where one moves.

    Yields, for each pivot, the tubes, their places, their numbers, and the slope of the pivot by v.
    """
    by_v, _ = tubes.tangents(start.z)
    with quiet():
        pivots = np.argmax(np.abs(by_v[:-1]) / size_of(start.z)[:-1], axis=0)
    for pivot in range(tubes.n):
        rows = np.flatnonzero(start.proved & (pivots == pivot) & (by_v[pivot] != 0))
        if rows.size:
            yield replace(tubes[rows], pivot=pivot), start[rows], rows, by_v[pivot, rows]


def secants(tubes: Tubes, z: FloatArray, towards: FloatArray) -> tuple[FloatArray, BoolArray]:
    """Secant steps to dv/ds = 0 from states on a curve, and where they have converged.

    The first step is a small one in the direction ``towards`` along the pivot.
    """
    size = size_of(z)[tubes.pivot]
    step = towards * 1e-4 * size
    by_s = tubes.tangents(z)[0]
    for _ in range(tubes.options.secant_steps):
        slope = by_s[-1]
        z = tubes.corrected(z + by_s * step)
        by_s = tubes.tangents(z)[0]
        with quiet():
            estimate = -by_s[-1] * step / (by_s[-1] - slope)
        longest = 8 * np.abs(step)
        step = np.where(np.isfinite(estimate), np.clip(estimate, -longest, longest), 0.0)
        converged = np.abs(step) <= 1e-9 * size
        if converged.all():
            break
    return z, converged & np.isfinite(z).all(axis=0)


def _proved(
    tubes: Tubes, here: Place, fold: FloatArray, moving: FloatArray, forward: int
) -> LimitPoints:
    """The limit points with proved bounds of v, from approximate folds."""
    by_s = tubes.tangents(here.z)[0]
    open_ = tubes.rises(here, by_s) == moving
    # Length of the last segment; v varies by the square of it there.
    last, share = 1e-6 * size_of(fold)[tubes.pivot], np.full(moving.size, 0.2)
    for _ in range(tubes.options.segments):
        rest = (fold - here.z)[tubes.pivot]
        rows = np.flatnonzero(open_ & (np.abs(rest) > last) & (share > 1e-4))
        if not rows.size:
            break
        step = np.sign(rest) * np.minimum(share * np.abs(rest), np.abs(rest) - 0.5 * last)
        good = _moved_on(tubes, here, by_s, rows, step, moving)
        share[rows] = np.where(good, np.minimum(1.5 * share[rows], 1.0), 0.6 * share[rows])
    open_ &= np.abs((fold - here.z)[tubes.pivot]) <= last
    good, end, tube = tubes.segment(here, fold + (fold - here.z))
    good &= open_ & (tubes.rises(end, tubes.tangents(end.z)[0]) == -moving)
    reached, ends = here.box()[-1], tube.box()[-1]
    low, high = (reached.low, ends.high) if forward > 0 else (ends.low, reached.high)
    return LimitPoints(fold, low, high, good)


def _moved_on(
    tubes: Tubes,
    here: Place,
    by_s: FloatArray,
    rows: IntArray,
    step: FloatArray,
    moving: FloatArray,
) -> BoolArray:
    """Where one segment is proved in which v is monotonic, among the places of the given rows.

    There ``here`` and ``by_s``, dz/ds, become those at its end.
    """
    own, slope = tubes[rows], by_s[:, rows]
    proved, end, tube = own.segment(here[rows], here.z[:, rows] + slope * step[rows])
    slope_at_end = own.tangents(end.z)[0]
    mean = 0.5 * (slope + slope_at_end)
    good = proved.copy()
    good[proved] = own[proved].rises(tube[proved], mean[:, proved]) == moving[rows[proved]]
    # Near a fold dv/ds varies much. If it is monotonic (v″ has a sign), its ends bound it.
    open_ = np.flatnonzero(proved & ~good & (np.abs(slope_at_end[-1]) < 0.5 * np.abs(slope[-1])))
    if open_.size:
        bent = own[open_].bends(tube[open_], mean[:, open_]) != 0
        ends = own[open_].rises(end[open_], slope_at_end[:, open_]) == moving[rows[open_]]
        good[open_] = bent & ends
    here.scatter(rows[good], end[good])
    by_s[:, rows[good]] = slope_at_end[:, good]
    return good


def size_of(z: FloatArray) -> FloatArray:
    """Sizes of coordinates and of the parameter that varies, at least 1e-3 or that share of their
    unit.
    """
    return sizes_of(z, 1e-3)
