"""Folds at the end of tubes: where states that are followed along a parameter turn back, proved,
for many points at once.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from ..numerics.columns import ByColumn
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, quiet
from .tubes import Place, Tubes


@dataclass(frozen=True)
class LimitPoints(ByColumn):
    """Folds z = (q, v), shape (n + 1, N), and between which values v lies there: proved where
    ``sure``, else without meaning.
    """

    z: FloatArray
    low: FloatArray
    high: FloatArray
    sure: BoolArray


def limit_points(tubes: Tubes, start: Place, forward: int) -> LimitPoints:
    """The first folds of states at a place as v moves on, up or down, where it turns back; points
    without width.

    The pivot is the coordinate that moves most. Newton's method along the curve, with secants,
    gives the fold in floats. Then segments that shrink towards it are proved to hold the curve, v
    moving on in all of them, and a last one across the fold, beyond which v goes back: the fold is
    in that one, and its ends bound v.
    """
    low, high = np.full((2, start.sure.size), np.nan)
    out = LimitPoints(start.z.copy(), low, high, np.zeros(low.size, dtype=bool))
    for some, here, rows, by_v in pivots(tubes, start):
        moving = np.sign(by_v)
        towards = forward * moving
        z, met = secants(some, here.z, towards)
        met &= (z - here.z)[some.pivot] * towards > 0
        out.scatter(rows[met], _proved(some[met], here[met], z[:, met], moving[met], forward))
    return out


def past(tubes: Tubes, start: Place, forward: int, by: FloatArray) -> Place:
    """States carried on where they are steep, until v has moved on by so much, or as far as that is
    proved, if at all.
    """
    out = start[np.arange(start.sure.size)]
    out.sure[:] = False
    for some, here, rows, by_v in pivots(tubes, start):
        begin, moving = start.v[rows], np.sign(by_v)
        by_s = some.tangents(here.z)[0]
        # A part of the way there if the curve stayed as steep.
        step = np.minimum(0.25 * np.abs(by_v * by[rows]), 0.1 * size_of(here.z[some.pivot]))
        goal, least = begin + forward * by[rows], 1e-4 * step
        open_ = some.rises(here, by_s) == moving
        for _ in range(tubes.options.steep_steps):
            on = np.flatnonzero(open_ & ((goal - here.v) * forward > 0) & (step > least))
            if not on.size:
                break
            good = _moved_on(some, here, by_s, on, forward * moving * step, moving)
            step[on] *= np.where(good, 1.5, 0.25)
        here.sure[:] = open_ & (here.v != begin)
        out.scatter(rows, here)
    return out


def passed(
    tubes: Tubes, start: Place, goal: FloatArray, sharp: bool = False
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Bounds of how far all states of a place are proved to go on as ``vary`` rises, and above
    which value to have ended.

    The pivot is a coordinate, and the tube goes on through a fold, where v, which has risen before,
    falls. The first is ``start.z`` or more, and at least the goal where all come to it; the second
    is below the goal, else infinite. Beside them how far each free parameter moves v, shape (free,
    N). A ``sharp`` answer is as near to the fold as the width of the parts allows; else it only
    tells the two apart from the goal.
    """
    safe, top, moves = start.v.copy(), np.full(goal.size, np.inf), np.zeros(tubes.half.shape)
    for some, here, rows, by_v in pivots(tubes, start):
        safe[rows], top[rows], moves[:, rows] = _passed(some, here, goal[rows], by_v, sharp)
        left = (safe[rows] < goal[rows]) & np.isinf(top[rows])
        if left.any() and not sharp:
            # The fold lies just above the goal, or a tube over it does.
            rows = rows[left]
            safe[rows], _, moves[:, rows] = _passed(
                some[left], here[left], goal[rows], by_v[left], over=False
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
    """:func:`passed` for one pivot; ``over`` says whether the tube goes over the fold, or up to it
    only.
    """
    way, towards = goal - start.v, np.sign(by_v)
    straight = np.abs(by_v * way)
    by_s, by_p = tubes.tangents(start.z)
    safe, top, highest = start.v.copy(), np.full(goal.size, np.inf), np.full(goal.size, -np.inf)
    moves = np.abs(by_p[-1])
    open_ = tubes.rises(start, by_s) == towards
    rising = open_.copy()
    # All states of the place lie within the first segment.
    here = start[np.arange(goal.size)]
    step = np.maximum(0.25 * straight, 2 * start.held[tubes.pivot])
    for _ in range(tubes.options.turn_steps):
        rows = np.flatnonzero(open_ & (step > tubes.options.least_step * straight))
        if not rows.size:
            break
        at, some = here[rows], tubes[rows]
        good, end, tube = some.segment(at, at.z + by_s[:, rows] * (towards * step)[rows])
        up = np.zeros(rows.size, dtype=bool)
        up[good] = some[good].rises(tube[good], by_s[:, rows[good]]) == towards[rows[good]]
        good &= np.where(rising[rows], up, tube.box().high[-1] < goal[rows])
        # Near its fold v is as wide as the parts make it: there is no nearer.
        near = 0.1 * (goal[rows] - at.v)
        if sharp:
            near = np.minimum(
                near, 0.05 * (moves[:, rows] * some.half).sum(axis=0) + 2.0**-12 * way[rows]
            )
        turns = over & rising[rows] & ~good & (np.abs(by_s[-1, rows]) * step[rows] < near)
        rising[rows[turns]] = False
        step[rows] *= np.where(good, 1.5, np.where(turns, 0.5, 0.25))
        rows, end, some, tube = rows[good], end[good], some[good], tube[good]
        if not rows.size:
            continue
        here.scatter(rows, end)
        by_s[:, rows], by_p = some.tangents(end.z)
        moves[:, rows] = np.abs(by_p[-1])
        ends = end.box()[-1]
        safe[rows] = np.where(rising[rows], ends.low, safe[rows])
        # While v rises it is highest at the end.
        highest[rows] = np.maximum(
            highest[rows], np.where(rising[rows], ends.high, tube.box().high[-1])
        )
        falls = some.rises(end, by_s[:, rows]) == -towards[rows]
        top[rows] = np.where(~rising[rows] & falls, highest[rows], np.inf)
        open_[rows] = (safe[rows] <= goal[rows]) & np.isinf(top[rows])
    return safe, top, moves


def pivots(tubes: Tubes, start: Place) -> Iterator[tuple[Tubes, Place, IntArray, FloatArray]]:
    """Tubes about the coordinate that moves most, over its size, where it does; their places,
    numbers, and its slope by v.
    """
    by_v, _ = tubes.tangents(start.z)
    with quiet():
        pivots = np.argmax(np.abs(by_v[:-1]) / size_of(start.z[:-1]), axis=0)
    for pivot in range(tubes.n):
        rows = np.flatnonzero(start.sure & (pivots == pivot) & (by_v[pivot] != 0))
        if rows.size:
            yield replace(tubes[rows], pivot=pivot), start[rows], rows, by_v[pivot, rows]


def secants(tubes: Tubes, z: FloatArray, towards: FloatArray) -> tuple[FloatArray, BoolArray]:
    """Secant steps to dv/ds = 0, from states on the curve, of which it is the first slope, to one
    that is a step ``towards`` it, and on.
    """
    size = size_of(z[tubes.pivot])
    step = towards * 1e-4 * size
    by_s = tubes.tangents(z)[0]
    for _ in range(tubes.options.secant_steps):
        slope = by_s[-1]
        z = tubes.corrected(z + by_s * step)
        by_s = tubes.tangents(z)[0]
        with quiet():
            ahead = -by_s[-1] * step / (by_s[-1] - slope)
        longest = 8 * np.abs(step)
        step = np.where(np.isfinite(ahead), np.clip(ahead, -longest, longest), 0.0)
        near = np.abs(step) <= 1e-9 * size
        if near.all():
            break
    return z, near & np.isfinite(z).all(axis=0)


def _proved(
    tubes: Tubes, here: Place, fold: FloatArray, moving: FloatArray, forward: int
) -> LimitPoints:
    """Between which values v lies where it turns back, and whether that is proved."""
    by_s = tubes.tangents(here.z)[0]
    open_ = tubes.rises(here, by_s) == moving
    # In the last segment v differs by the square of this.
    last, share = 1e-6 * size_of(fold[tubes.pivot]), np.full(moving.size, 0.2)
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
    """One segment of some rows: where it is proved that v moves on in it ``here`` and dz/ds become
    those at its end.
    """
    some, slope = tubes[rows], by_s[:, rows]
    good, end, tube = some.segment(here[rows], here.z[:, rows] + slope * step[rows])
    then = some.tangents(end.z)[0]
    on = good.copy()
    on[good] = some[good].rises(tube[good], 0.5 * (slope + then)[:, good]) == moving[rows[good]]
    # Where dv/ds falls by half and more, and only grows or falls, its ends tell it.
    left = np.flatnonzero(good & ~on & (np.abs(then[-1]) < 0.5 * np.abs(slope[-1])))
    if left.size:
        bent = some[left].bends(tube[left], 0.5 * (slope + then)[:, left]) != 0
        ends = some[left].rises(end[left], then[:, left]) == moving[rows[left]]
        on[left] = bent & ends
    good = on
    here.scatter(rows[good], end[good])
    by_s[:, rows[good]] = then[:, good]
    return good


def size_of(z: FloatArray) -> FloatArray:
    """The size of coordinates, at least what counts as no size."""
    return np.maximum(np.abs(z), 1e-3)
