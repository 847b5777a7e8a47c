"""Folds at the end of tubes: where states that are followed along a parameter turn back, proved, for many points at once."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..numerics.interval_arrays import BoolArray, FloatArray
from .tubes import LEAST, Parts, Place, Tubes

#: First step towards the fold, over the size of the coordinate, and how much farther the next one may go.
PROBE, FARTHER = 1e-4, 8.0
#: Steps of the secant method, and how near to one another the last two are, over the size of the coordinate.
SECANTS, MET = 40, 1e-9
#: Half the width of the last segment, over the size of the coordinate: v differs by its square there.
LAST = 1e-6
#: Share of the way to the fold of a segment, the smallest one that is tried, and segments at most.
SHARE, LEAST_SHARE, SEGMENTS = 0.65, 1e-4, 400
#: The first step where the curve is steep, over the way there if it stayed as steep, and over the size of the coordinate at
#: most; the least one over the first, and steps at most.
STEEP, WIDE, SMALLEST, STEPS = 0.25, 0.1, 1e-4, 100
#: Steps through a fold, the first one as a share of the straight way, and what counts as no size of a coordinate.
TURNS, TURN, SMALL = 60, 0.25, 1e-3
#: A step towards a fold that is this share of what is left to the goal is near enough to go over it.
NEAR = 0.1
#: For a sharp answer: a step that is this share of how far apart the folds of a part lie, and this one of the whole.
CLOSE, SHARP = 0.05, 2.0**-12


@dataclass(frozen=True)
class Turned:
    """Folds z = (q, v), shape (n + 1, N), and between which values v lies there; ``sure`` where that is proved."""

    z: FloatArray
    low: FloatArray
    high: FloatArray
    sure: BoolArray


def turned(tubes: Tubes, parts: Parts, start: Place, forward: int, segments: int = SEGMENTS) -> Turned:
    """The first folds of states at a place as v moves on, up or down, where it turns back; points without width.

    The pivot is the coordinate that moves most. Newton's method along the curve, with secants, gives the fold in floats. Then
    segments that shrink towards it are proved to hold the curve, v moving on in all of them, and a last one across the fold,
    beyond which v goes back: the fold is in that one, and its ends bound v.
    """
    nothing = np.full(start.sure.size, np.nan)
    out = Turned(start.z.copy(), nothing, nothing.copy(), np.zeros(start.sure.size, dtype=np.bool_))
    for pivot, rows, by_v in pivots(tubes, parts, start):
        towards = forward * np.sign(by_v)
        z, met = secants(tubes, parts[rows], start.z[:, rows], pivot, towards)
        found = met & ((z[pivot] - start.z[pivot, rows]) * towards > 0)
        some = rows[found]
        out.z[:, some] = z[:, found]
        out.low[some], out.high[some], out.sure[some] = _proved(
            tubes, parts[some], start[some], z[:, found], pivot, towards[found], forward, segments
        )
    return out


def past(tubes: Tubes, parts: Parts, start: Place, forward: int, by: FloatArray) -> Place:
    """States carried on where they are steep, until v has moved on by so much, or as far as that is proved, if at all."""
    out = start[np.arange(start.sure.size)]
    out.sure[:] = False
    for pivot, rows, by_v in pivots(tubes, parts, start):
        here, some, towards = start[rows], parts[rows], forward * np.sign(by_v)
        by_s = tubes.tangents(some, here.z, pivot)[0]
        step = np.minimum(STEEP * np.abs(by_v * by[rows]), WIDE * _size(here.z[pivot]))
        goal = start.z[tubes.n, rows] + forward * by[rows]
        open_ = tubes.rises(some, here.region(), by_s, pivot) == forward * towards
        least = SMALLEST * step
        for _ in range(STEPS):
            on = np.flatnonzero(open_ & ((goal - here.z[tubes.n]) * forward > 0) & (step > least))
            if not on.size:
                break
            good = _moved_on(tubes, some, here, by_s, on, (towards * step)[on], pivot, forward * towards[on])
            step[on] *= np.where(good, 1.5, 0.25)
        here.sure[:] = open_ & (here.z[tubes.n] != start.z[tubes.n, rows])
        out.put(rows, here)
    return out


def passed(
    tubes: Tubes, parts: Parts, start: Place, goal: FloatArray, sharp: bool = False
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """How far all states of a place are proved to go on as ``vary`` rises, and above which value to have ended.

    The pivot is a coordinate, and the tube goes on through a fold, where v, which has risen before, falls. The first is
    ``start.z`` or more, and at least the goal where all come to it; the second is below the goal, else infinite. Beside
    them how far each free parameter moves v, shape (free, N). A ``sharp`` answer is as near to the fold as the width of
    the parts allows; else it only tells the two apart from the goal.
    """
    safe, top = start.z[tubes.n].copy(), np.full(goal.size, np.inf)
    moves = np.zeros(parts.half.shape)
    for pivot, rows, by_v in pivots(tubes, parts, start):
        safe[rows], top[rows], moves[:, rows] = _passed(tubes, parts[rows], start[rows], goal[rows], pivot, by_v, sharp)
        left = np.flatnonzero((safe[rows] < goal[rows]) & np.isinf(top[rows]))
        if left.size and not sharp:
            # The fold lies just above the goal, or a tube over it does.
            some, v = rows[left], by_v[left]
            safe[some], _, moves[:, some] = _passed(tubes, parts[some], start[some], goal[some], pivot, v, sharp, over=False)
    return safe, top, moves


def _passed(
    tubes: Tubes, parts: Parts, start: Place, goal: FloatArray, pivot: int, by_v: FloatArray, sharp: bool, over: bool = True
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """:func:`passed` for one pivot; ``over`` says whether the tube goes over the fold, or up to it only."""
    towards, straight = np.sign(by_v), np.abs(by_v * (goal - start.z[tubes.n]))
    by_s, by_p = tubes.tangents(parts, start.z, pivot)
    safe, top, highest = start.z[tubes.n].copy(), np.full(goal.size, np.inf), np.full(goal.size, -np.inf)
    moves = np.abs(by_p[tubes.n])
    open_ = tubes.rises(parts, start.region(), by_s, pivot) == towards
    rising = open_.copy()
    # All states of the place lie within the first segment.
    here, step = start[np.arange(goal.size)], np.maximum(TURN * straight, 2 * start.held[pivot])
    for _ in range(TURNS):
        rows = np.flatnonzero(open_ & (step > LEAST * straight))
        if not rows.size:
            break
        at, some = here[rows], parts[rows]
        good, end, tube = tubes.segment(some, at, at.z + by_s[:, rows] * (towards * step)[rows], pivot)
        up = np.zeros(rows.size, dtype=np.bool_)
        up[good] = tubes.rises(some[good], tube[good], by_s[:, rows[good]], pivot) == towards[rows[good]]
        good &= np.where(rising[rows], up, tube.box.high[tubes.n] < goal[rows])
        # Near its fold v is as wide as the parts make it: there is no nearer.
        near = NEAR * (goal[rows] - at.z[tubes.n])
        if sharp:
            wide = (moves[:, rows] * some.half).sum(axis=0)
            near = np.minimum(near, CLOSE * wide + SHARP * (goal - start.z[tubes.n])[rows])
        turns = over & rising[rows] & ~good & (np.abs(by_s[tubes.n, rows]) * step[rows] < near)
        rising[rows[turns]] = False
        step[rows] *= np.where(good, 1.5, np.where(turns, 0.5, 0.25))
        rows, end, some, tube = rows[good], end[good], some[good], tube[good]
        if not rows.size:
            continue
        here.put(rows, end)
        by_s[:, rows], by_p = tubes.tangents(some, end.z, pivot)
        moves[:, rows] = np.abs(by_p[tubes.n])
        safe[rows] = np.where(rising[rows], end.box().low[tubes.n], safe[rows])
        # While v rises it is highest at the end.
        reached = np.where(rising[rows], end.box().high[tubes.n], tube.box.high[tubes.n])
        highest[rows] = np.maximum(highest[rows], reached)
        falls = tubes.rises(some, end.region(), by_s[:, rows], pivot) == -towards[rows]
        top[rows] = np.where(~rising[rows] & falls, highest[rows], np.inf)
        open_[rows] = (safe[rows] <= goal[rows]) & np.isinf(top[rows])
    return safe, top, moves


def pivots(tubes: Tubes, parts: Parts, start: Place) -> Iterator[tuple[int, Any, FloatArray]]:
    """The coordinate that moves most, over its size, where it does; the points for which it is that, and its slope by v."""
    by_v, _ = tubes.tangents(parts, start.z, tubes.n)
    with np.errstate(all="ignore"):
        pivots = np.argmax(np.abs(by_v[: tubes.n]) / np.maximum(np.abs(start.z[: tubes.n]), SMALL), axis=0)
    for pivot in range(tubes.n):
        rows = np.flatnonzero(start.sure & (pivots == pivot) & (by_v[pivot] != 0))
        if rows.size:
            yield pivot, rows, by_v[pivot, rows]


def secants(tubes: Tubes, parts: Parts, z: FloatArray, pivot: int, towards: FloatArray) -> tuple[FloatArray, BoolArray]:
    """Where dv/ds = 0, from states on the curve, of which it is the first slope, to one that is a step ``towards`` it, and on."""
    size = _size(z[pivot])
    step = towards * PROBE * size
    by_s = tubes.tangents(parts, z, pivot)[0]
    slope = by_s[tubes.n]
    for _ in range(SECANTS):
        z = tubes.corrected(parts, z + by_s * step, pivot)
        by_s = tubes.tangents(parts, z, pivot)[0]
        with np.errstate(all="ignore"):
            ahead = -by_s[tubes.n] * step / (by_s[tubes.n] - slope)
        longest = FARTHER * np.abs(step)
        slope, step = by_s[tubes.n], np.where(np.isfinite(ahead), np.clip(ahead, -longest, longest), 0.0)
        if (np.abs(step) <= MET * size).all():
            break
    return z, (np.abs(step) <= MET * size) & np.isfinite(z).all(axis=0)


def _proved(
    tubes: Tubes,
    parts: Parts,
    here: Place,
    fold: FloatArray,
    pivot: int,
    towards: FloatArray,
    forward: int,
    segments: int,
) -> tuple[FloatArray, FloatArray, BoolArray]:
    """Between which values v lies where it turns back, and whether that is proved."""
    n, last, moving = tubes.n, LAST * _size(fold[pivot]), forward * towards
    by_s = tubes.tangents(parts, here.z, pivot)[0]
    open_ = tubes.rises(parts, here.region(), by_s, pivot) == moving
    share = np.full(fold.shape[1:], SHARE)
    for _ in range(segments):
        rest = fold[pivot] - here.z[pivot]
        rows = np.flatnonzero(open_ & (np.abs(rest) > last) & (share > LEAST_SHARE))
        if not rows.size:
            break
        good = _moved_on(tubes, parts, here, by_s, rows, (share * rest)[rows], pivot, moving[rows])
        share[rows] = np.where(good, np.minimum(1.1 * share[rows], SHARE), 0.6 * share[rows])
    low, high, sure = *np.full((2, share.size), np.nan), np.zeros(share.size, dtype=np.bool_)
    rows = np.flatnonzero(open_ & (np.abs(fold[pivot] - here.z[pivot]) <= last))
    if rows.size:
        across = fold[:, rows] + (fold - here.z)[:, rows]
        good, end, tube = tubes.segment(parts[rows], here[rows], across, pivot)
        beyond = tubes.tangents(parts[rows], end.z, pivot)[0]
        good &= tubes.rises(parts[rows], end.region(), beyond, pivot) == -moving[rows]
        reached = here[rows].box()[n]
        low[rows], high[rows] = (reached.low, tube.box.high[n]) if forward > 0 else (tube.box.low[n], reached.high)
        sure[rows] = good
    return low, high, sure


def _moved_on(
    tubes: Tubes, parts: Parts, here: Place, by_s: FloatArray, rows: NDArray[np.intp], step: FloatArray, pivot: int,
    moving: FloatArray,
) -> BoolArray:  # fmt: skip
    """One segment of some rows: where it is proved that v moves on in it ``here`` and dz/ds become those at its end."""
    good, end, tube = tubes.segment(parts[rows], here[rows], here.z[:, rows] + by_s[:, rows] * step, pivot)
    then = tubes.tangents(parts[rows], end.z, pivot)[0]
    mean = 0.5 * (by_s[:, rows] + then)
    good[good] = tubes.rises(parts[rows[good]], tube[good], mean[:, good], pivot) == moving[good]
    here.put(rows[good], end[good])
    by_s[:, rows[good]] = then[:, good]
    return good


def _size(z: FloatArray) -> FloatArray:
    return np.maximum(np.abs(z), SMALL)
