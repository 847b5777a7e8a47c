"""Ends of branches of doubled cycles: the two halves become one, on the cycle of half the period, which doubles there."""

import numpy as np

from ..errors import ConvergenceError
from ..models.parameters import FloatArray
from ..motion.bifurcation_functions import unsure
from ..motion.shooting import CLOSED, Guess, Loop, extent, rate, recut, solved
from .arclength import SURE, Point, Setting, at_zero, fixed, point_of

#: The halves of a step's orbits come together if they pass each other within this share of how far they move.
NEAR = 0.5

#: Halves farther apart than this share of the orbit's extent are two.
SMALL = 0.3

#: Halves that come closer than this share are one, and those that are this close from the beginning: an orbit twice round.
NEAREST, ONE = 1e-3, 1e-9


def in_halves(loop: Loop, setting: Setting) -> Loop:
    """The loop in an even number of stretches."""
    pieces = len(loop.states)
    if pieces % 2 == 0:
        return loop
    return setting.looped(recut(loop, 2 * pieces))


def parted(point: Point) -> FloatArray:
    """How far apart the two halves of a round are: states less those half a round before, across the flow, over √their number."""
    states, half = point.loop.states, len(point.loop.states) // 2
    apart = states[half:] - states[:half]
    flows = np.array([rate(point.loop.field, state, point.loop.constants) for state in states[:half]])
    along = (flows * apart).sum(axis=1) / (flows * flows).sum(axis=1)
    return np.asarray((apart - along[:, None] * flows).ravel() / np.sqrt(half), dtype=float)


def meets(one: Point, other: Point) -> float | None:
    """The share of the step from one point to the next at which their halves come together; None if they do not."""
    if len(one.loop.states) != len(other.loop.states):
        return None
    before, after = parted(one), parted(other)
    way = after - before
    length = float(np.linalg.norm(way))
    now, was, size = float(np.linalg.norm(after)), float(np.linalg.norm(before)), extent(other.loop)
    if now > SMALL * size or not length > 0 or not was > ONE:
        return None
    if now < min(was, NEAREST * size):
        return 1.0
    share = -float(before @ way) / length**2
    return share if 0 < share < 1 and float(np.linalg.norm(before + share * way)) < NEAR * length else None


def between_halves(one: Point, other: Point, share: float) -> tuple[Guess, float]:
    """The cycle of half the period at a share of a step, near which to look for its doubling, and how far off that may be."""
    a, b = one.loop.guess, other.loop.guess
    states, half = (1 - share) * a.states + share * b.states, len(a.states) // 2
    guess = Guess((states[:half] + states[half:]) / 2, ((1 - share) * a.period + share * b.period) / 2, a.values)
    reach = (float(np.linalg.norm(states[:half] - states[half:])) + float(np.linalg.norm(b.states - a.states))) / np.sqrt(half)
    return guess.at(one.setting.free[0], one.value + share * (other.value - one.value)), reach


def halved(setting: Setting, begun: Guess, reach: float) -> tuple[Loop, float] | None:
    """The doubling of the cycle of half the period near a guess, and the error of its parameter.

    None if there is none whose states are within ``reach``: then the halves have only come near each other.
    """
    kind = "period_doubling"
    try:
        near = fixed(setting, setting.looped(begun))
        doubling = at_zero(kind, setting, near, near.guess.coordinates(setting.free))
        loop = solved(setting.flow, near.guess, doubling, setting.free)
    except (ConvergenceError, np.linalg.LinAlgError):
        return None
    if not float(np.linalg.norm(loop.states - begun.states)) / np.sqrt(len(begun.states)) < reach:
        return None
    there = point_of(setting, loop)
    steepness = float(doubling(loop)[1][-1] @ there.tangent) * max(1.0, SURE * unsure(near, kind) / CLOSED)
    return loop, unsure(loop, kind) * abs(float(there.tangent[-1]) / steepness) + 1e-15 * (1 + abs(there.value))
