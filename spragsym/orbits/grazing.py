"""Grazing: an orbit only touches a border, and the number of its kinks changes."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ..errors import ConvergenceError
from ..models.parameters import FloatArray
from ..motion.segment import Turn
from ..motion.shooting import Conditions, Guess, Loop, divided, solved
from .arclength import Point, Setting

#: Turns of two neighbouring points are one where they are as close as this, in shares of a period.
ALIKE = 0.06


@dataclass(frozen=True)
class Touch:
    """A turn at which a border's level is extremal: the level there, and how it changes along the branch."""

    turn: Turn
    share: float
    level: float
    slope: float


def touches(setting: Setting, point: Point) -> list[Touch]:
    """All turns of the borders of a point."""
    loop, field = point.loop, setting.field
    found, size = [], field.size
    for turn in loop.turns():
        if turn.border < 0:
            continue
        parameters = point.tangent[loop.guess.states.size + 1 :]
        change = turn.by_state @ point.tangent[:size] + turn.by_parameters[:, : len(parameters)] @ parameters
        level = _level(setting, loop, turn.border, turn.state, 0.0)
        step = 1e-6 / max(1.0, float(np.abs(change).max()))
        ahead = _level(setting, loop, turn.border, turn.state + step * change, step, parameters)
        back = _level(setting, loop, turn.border, turn.state - step * change, -step, parameters)
        found.append(Touch(turn, turn.t / loop.guess.period, level, (ahead - back) / (2 * step)))
    return found


def _level(
    setting: Setting, loop: Loop, border: int, state: FloatArray, step: float, parameters: FloatArray | None = None
) -> float:
    values = list(loop.guess.values)
    for index, change in zip(setting.free, [] if parameters is None else parameters.tolist(), strict=False):
        values[index] += step * change
    constants = setting.field.constants(values)
    mode = setting.field.initial_mode(state, constants)
    return float(setting.field.borders[border].level(state.tolist(), constants, mode))


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
    share = np.linspace(0.0, 1.0, 41)
    sign = np.sign(one.level)
    cubic = (
        one.level * (1 + 2 * share) * (1 - share) ** 2 + length * one.slope * share * (1 - share) ** 2
        + other.level * share**2 * (3 - 2 * share) - length * other.slope * share**2 * (1 - share)
    )  # fmt: skip
    margin = 0.1 * abs(one.level - other.level)
    lowest = float((sign * cubic).min())
    return lowest < margin and lowest < 0.5 * min(abs(one.level), abs(other.level))


def may_have_touched(one: list[Touch], other: list[Touch], pairs: list[tuple[Touch, Touch]], length: float) -> bool:
    """Whether a turn that one of two points has alone may have been at the border between: by its level and slope there."""
    kept = {id(touch) for pair in pairs for touch in pair}
    alone = [(touch, length) for touch in one if id(touch) not in kept]
    alone += [(touch, -length) for touch in other if id(touch) not in kept]
    return any(np.sign(touch.level) * (touch.level + away * touch.slope) < 0.5 * abs(touch.level) for touch, away in alone)


def grazing(setting: Setting, near: Point, touch: Touch) -> Loop:
    """The closed orbit that touches a border, begun where it does: near a point with a turn near that border."""
    period = near.loop.guess.period
    pieces = len(near.loop.guess.states)
    begun = Guess(touch.turn.state[None], period, near.loop.guess.values)
    guess = divided(setting.flow, begun, pieces)
    loop = solved(setting.flow, guess, touching(setting, touch.turn.border, pieces), setting.free, reach=0.5)
    if abs(loop.guess.period / period - 1) > 0.2:
        raise ConvergenceError("another orbit touches the border")
    return loop


def touching(setting: Setting, border: int, pieces: int) -> Conditions:
    """Level and rate of a border are zero at the first state."""
    field, size, free = setting.field, setting.field.size, setting.free
    unknowns = pieces * size + 1 + len(free)

    def both(state: FloatArray, values: tuple[float, ...]) -> FloatArray:
        constants, numbers = field.constants(values), state.tolist()
        mode = field.initial_mode(numbers, constants)
        that = field.borders[border]
        accelerations = field.acceleration(numbers, constants, mode, math)
        level, change = that.level(numbers, constants, mode), that.rate(numbers, accelerations, constants, mode)
        return np.array([change, level], dtype=float)

    def conditions(loop: Loop) -> tuple[FloatArray, FloatArray]:
        state, values = loop.guess.states[0], loop.guess.values
        rows, step = np.zeros((2, unknowns)), 1e-7
        for i in range(size):
            shift = step * np.eye(size)[i]
            rows[:, i] = (both(state + shift, values) - both(state - shift, values)) / (2 * step)
        for column, index in enumerate(free):
            up, down = list(values), list(values)
            up[index] += step
            down[index] -= step
            rows[:, pieces * size + 1 + column] = (both(state, tuple(up)) - both(state, tuple(down))) / (2 * step)
        return both(state, values), rows

    return conditions
