"""Grazing: an orbit only touches a border, and the number of its kinks changes."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

import numpy as np

from ..errors import ConvergenceError
from ..models.parameters import FloatArray
from ..motion.segment import Turn
from ..motion.shooting import Conditions, Guess, Loop, recut, solved
from .arclength import Point, Setting
from .system import differences

#: Turns of two neighbouring points are one where they are as close as this, in shares of a period.
ALIKE = 0.06


@dataclass(frozen=True)
class Touch:
    """A turn at which a border's level is extremal: the level there, and how it changes along the branch."""

    turn: Turn
    share: float
    level: float
    slope: float


def touches(point: Point) -> list[Touch]:
    """All turns of the borders of a point."""
    setting, loop, found = point.setting, point.loop, []
    size = setting.field.size
    along = point.tangent[loop.states.size + 1 :]
    for turn in loop.turns():
        if turn.border >= 0:
            change = turn.by_state @ point.tangent[:size] + turn.by_parameters[:, : len(along)] @ along
            way, at = np.append(change, along), np.append(turn.state, loop.guess.coordinates(setting.free)[-len(along) :])
            step = 1e-6 / max(1.0, float(np.abs(change).max()))
            back, level, ahead = (
                float(_level_and_rate(setting, turn.border, loop.guess, at + share * step * way)[0]) for share in (-1, 0, 1)
            )
            found.append(Touch(turn, turn.t / loop.period, level, (ahead - back) / (2 * step)))
    return found


def _level_and_rate(setting: Setting, border: int, guess: Guess, place: FloatArray) -> FloatArray:
    """Level and rate of a border at a state, followed by the free parameters."""
    field, size = setting.field, setting.field.size
    for index, value in zip(setting.free, place[size:].tolist(), strict=True):
        guess = guess.at(index, value)
    constants, state = field.constants(guess.values), place[:size].tolist()
    mode, that = field.initial_mode(state, constants), field.borders[border]
    accelerations = field.acceleration(state, constants, mode, math)
    return np.array([that.level(state, constants, mode), that.rate(state, accelerations, constants, mode)], dtype=float)


def signature(point: Point) -> tuple[int, ...]:
    """Crossings of each border in a round."""
    crossed = [crossing.border for crossing in point.loop.crossings()]
    return tuple(crossed.count(i) for i in range(len(point.loop.field.borders)))


def paired(one: list[Touch], other: list[Touch]) -> Iterator[tuple[Touch, Touch]]:
    """Turns of one point with those of the next that they have become."""
    for touch in one:
        alike = [
            (abs((touch.share - each.share + 0.5) % 1 - 0.5) + float(np.abs(touch.turn.state - each.turn.state).max()), i)
            for i, each in enumerate(other)
            if (each.turn.border, each.turn.direction) == (touch.turn.border, touch.turn.direction)
        ]
        if alike and min(alike)[0] < 10 * ALIKE:
            yield touch, other[min(alike)[1]]


def may_touch(one: Touch, other: Touch, length: float) -> bool:
    """Whether the cubic through levels and slopes of a pair comes to 0 between its ends, which have one sign."""
    from scipy.interpolate import CubicHermiteSpline

    cubic = CubicHermiteSpline([0.0, 1.0], [one.level, other.level], [length * one.slope, length * other.slope])
    margin = 0.1 * abs(one.level - other.level)
    lowest = float((np.sign(one.level) * cubic(np.linspace(0.0, 1.0, 41))).min())
    return lowest < margin and lowest < 0.5 * min(abs(one.level), abs(other.level))


def may_have_touched(one: list[Touch], other: list[Touch], pairs: list[tuple[Touch, Touch]], length: float) -> bool:
    """Whether a turn that one of two points has alone may have been at the border between: by its level and slope there."""
    kept = {id(touch) for pair in pairs for touch in pair}
    alone = [(touch, length) for touch in one if id(touch) not in kept]
    alone += [(touch, -length) for touch in other if id(touch) not in kept]
    return any(np.sign(touch.level) * (touch.level + away * touch.slope) < 0.5 * abs(touch.level) for touch, away in alone)


def grazing(near: Point, touch: Touch) -> Loop:
    """The closed orbit that touches a border, begun where it does: near a point with a turn near that border."""
    setting, known = near.setting, near.loop.guess
    guess = recut(near.loop, len(known.states), touch.turn.t)
    loop = solved(setting.flow, guess, touching(touch.turn.border, setting), setting.free, reach=0.5)
    if abs(loop.period / known.period - 1) > 0.2:
        raise ConvergenceError("another orbit touches the border")
    return loop


def touching(border: int, setting: Setting, *_: object) -> Conditions:
    """Level and rate of a border are zero at the first state."""
    size = setting.field.size

    def conditions(loop: Loop) -> tuple[FloatArray, FloatArray]:
        both, begin = partial(_level_and_rate, setting, border, loop.guess), len(loop.guess.coordinates())
        place = np.append(loop.states[0], loop.guess.coordinates(setting.free)[begin:])
        slopes, rows = differences(both, place, 1e-7), np.zeros((2, begin + len(setting.free)))
        rows[:, :size], rows[:, begin:] = slopes[:, :size], slopes[:, size:]
        return both(place), rows

    return conditions
