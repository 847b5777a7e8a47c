"""Real roots of many cubics at once, told apart, where the last coefficient is an interval: all functions that it encloses.

For g with g(h) = c₀ + c₁ h + c₂ h² + c₃ h³, g'(h) = c₁ + 2 c₂ h + 3 c₃ h² and g''(h) = 2 c₂ + 6 c₃ h, with a c₃ of its own in the
enclosure for each of them and each h. On a piece where the signs of g'' at both ends are the same, g is convex or concave: then

- different signs of g at the ends are one root, and the same signs on the side of the chord are none;
- with m ≤ |g''|, g has no root where |g(e)| > g'(e)² / (2 m) at any e and g(e) has the sign of g''.

So one cut at the extremum decides between none and two.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .interval_arrays import EPS, FloatArray, Intervals, raised
from .wide_balls import WideBalls

#: Rounds of cuts, and most pieces of one cubic in a round.
ROUNDS, PIECES = 60, 24
#: Rounds to a float near a root.
GUESSES = 80


@dataclass(frozen=True)
class Cubics:
    """Coefficients: the first two to many digits, the last two as intervals."""

    value: WideBalls
    slope: WideBalls
    bend: Intervals
    last: Intervals

    def taken(self, rows: NDArray[np.int64]) -> Cubics:
        """Some of them."""
        return Cubics(self.value.taken(rows), self.slope.taken(rows), self.bend[rows], self.last[rows])

    def at(self, h: FloatArray) -> WideBalls:
        """g at floats."""
        x = WideBalls.exact(h)
        inner = WideBalls.around(self.bend) + WideBalls.around(self.last) * x
        out: WideBalls = self.value + x * (self.slope + x * inner)
        return out

    def slopes(self, h: FloatArray) -> Intervals:
        """g' at floats."""
        x = Intervals.point(h)
        return self.slope.intervals() + x * (self.bend * 2 + x * self.last * 3)

    def bends(self, h: FloatArray) -> Intervals:
        """g'' at floats."""
        return self.bend * 2 + Intervals.point(h) * self.last * 6

    def scale(self) -> FloatArray:
        """About how far from 0 roots and extrema lie that are not far from it."""
        first, second, third = self.slope.middle.high, self.bend.middle, self.last.magnitude
        out: FloatArray = (
            np.cbrt(np.abs(self.value.middle.high) / third) + np.abs(second / third) + np.sqrt(np.abs(first / third))
        )
        return out


_Spans = tuple[FloatArray, FloatArray, NDArray[np.int64]]


def isolated(
    cubics: Cubics, low: FloatArray, high: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray, NDArray[np.int64], NDArray[np.bool_]]:
    """Spans with exactly one root each between low and high, a float near it, its cubic; and cubics that are not decided."""
    failed = ~(np.isfinite(cubics.value.radius) & np.isfinite(cubics.slope.radius))
    failed |= ~np.isfinite(cubics.bend.ends + cubics.last.ends).all(axis=0)
    one, two, number = low, high, np.arange(low.size)
    found: list[_Spans] = []
    for _ in range(ROUNDS):
        failed |= np.bincount(number, minlength=low.size) > PIECES
        alive = ~failed[number]
        one, two, number = one[alive], two[alive], number[alive]
        if not number.size:
            break
        root, open_, lost, cuts = _looked_at(cubics.taken(number), one, two)
        failed[number[lost]] = True
        found.append((one[root], two[root], number[root]))
        one, two, number, cuts = one[open_], two[open_], number[open_], cuts[:, open_]
        one, two = np.concatenate([one, cuts[0], cuts[1]]), np.concatenate([cuts[0], cuts[1], two])
        number = np.concatenate([number, number, number])
        there = two > one
        one, two, number = one[there], two[there], number[there]
    failed[number] = True
    lows, highs = (np.concatenate([low[:0], *(part[k] for part in found)]) for k in (0, 1))
    rows = np.concatenate([np.empty(0, dtype=np.int64), *(part[2] for part in found)])
    return lows, highs, _guesses(cubics.taken(rows), lows, highs), rows, failed


def _looked_at(
    c: Cubics, one: FloatArray, two: FloatArray
) -> tuple[NDArray[np.bool_], NDArray[np.bool_], NDArray[np.bool_], FloatArray]:
    """Of pieces: which have exactly one root, which are still open, which can't be told, and where to cut, shape (2, N)."""
    ends = (one, two)
    values, slopes, bends = [c.at(h) for h in ends], [c.slopes(h) for h in ends], [c.bends(h) for h in ends]
    signs = [value.signs() for value in values]
    bend = bends[0].hull(bends[1])
    bent = ~bend.holds_zero()
    middle = np.clip(one + (two - one) * (63 / 128), one, two)
    reach = raised(np.maximum(two - middle, middle - one))
    around = Intervals(np.stack([reach, reach]))
    straight = c.slopes(middle) + bend * around
    slope = Intervals(np.where(bent, slopes[0].hull(slopes[1]).ends, straight.ends))
    monotone = ~slope.holds_zero()
    up = np.where(bend.low > 0, 1, -1)
    known = (signs[0] != 0) & (signs[1] != 0)
    simple = monotone | bent
    root = simple & known & (signs[0] != signs[1])
    same = simple & known & (signs[0] == signs[1])
    none = same & (monotone | (signs[0] != up))
    for value, end, sign in zip(values, slopes, signs, strict=True):
        least = np.abs(value.middle.high) * (1 - 4 * EPS) - value.radius
        none |= bent & (sign == up) & (least * bend.mignitude * 2 > end.magnitude**2 * (1 + 8 * EPS))
    none |= ~(c.at(middle).intervals() + slope * around).holds_zero()
    lost = simple & ~known & ~none
    open_ = ~(root | none | lost)
    return root & ~none, open_, lost, _cuts(c, one, two, middle, bent)


def _cuts(c: Cubics, one: FloatArray, two: FloatArray, middle: FloatArray, bent: NDArray[np.bool_]) -> FloatArray:
    """At the extremum of pieces that are bent; on both sides of where others may change their bend; in the middle elsewhere."""
    first, second, third = c.slope.middle.high, c.bend.middle, c.last.middle
    half = second + np.copysign(np.sqrt(np.maximum(second * second - 3 * first * third, 0.0)), second)
    extremes = np.stack([-first / half, -half / (3 * third)])
    fits = (extremes > one) & (extremes < two)
    extreme = np.where(fits[0], extremes[0], np.where(fits[1], extremes[1], middle))
    flat = -(c.bend / (c.last * 3))
    turn = flat.middle
    # Half as far as the extrema: so far g' keeps its sign.
    apart = np.sqrt(np.abs((first + turn * (2 * second + 3 * third * turn)) / (3 * third)))
    room = np.maximum(flat.width, 0.5 * apart)
    sides = np.stack([flat.low - room, flat.high + room])
    turns = np.isfinite(sides).all(axis=0) & (((sides > one) & (sides < two)).any(axis=0))
    sides = np.clip(np.where(turns, sides, middle), one, two)
    out: FloatArray = np.where(bent, extreme, sides)
    return out


def _guesses(c: Cubics, low: FloatArray, high: FloatArray) -> FloatArray:
    """Floats near the roots, by Newton's method in floats, kept between ends of different signs."""
    c0, c1, c2, c3 = c.value.middle.high, c.slope.middle.high, c.bend.middle, c.last.middle

    def value(h: FloatArray) -> FloatArray:
        out: FloatArray = c0 + h * (c1 + h * (c2 + h * c3))
        return out

    rising = value(high) > value(low)
    one, two = low.copy(), high.copy()
    h = 0.5 * (one + two)
    for _ in range(GUESSES):
        now = value(h)
        above = (now > 0) == rising
        one, two = np.where(above, one, h), np.where(above, h, two)
        step = h - now / (c1 + h * (2 * c2 + h * 3 * c3))
        new = np.where((step > one) & (step < two), step, 0.5 * (one + two))
        done = np.abs(new - h) <= EPS * np.abs(h)
        h = new
        if done.all():
            break
    return h
