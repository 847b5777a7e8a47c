"""What happens on a branch between two of its points: test functions that change sign, and levels that do."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..dynamics.criteria import CRITERIA, at_minus_one, is_complex_pair
from ..dynamics.shooting import Guess, Loop, across, divided, solved
from ..errors import ConvergenceError
from ..parameters import FloatArray
from .arclength import Point, Setting, between, corrected
from .grazing import Touch, grazing, may_touch, paired, signature, touches

#: What test functions tell, a grazing apart.
KINDS = (*CRITERIA, "crossing")

#: Halvings of a step that looks as if something were hidden in it.
DEEPEST = 9

#: Where the parameter changes less than this along the arc, a multiplier that passes 1 belongs to a fold.
FLAT = 1e-6

#: An event is located to this, in units of the arc.
LOCATED = 1e-11


@dataclass(frozen=True)
class Seen:
    """A point with its test functions and turns."""

    setting: Setting
    point: Point

    @cached_property
    def criteria(self) -> dict[str, float]:
        """Values of the test functions, by kind of event."""
        return {kind: criterion(kind, self.point) for kind in KINDS}

    @cached_property
    def touches(self) -> list[Touch]:
        """Turns of the borders."""
        return touches(self.setting, self.point)


def criterion(kind: str, point: Point) -> float:
    """A test function along a branch: at a fold the parameter itself turns back; where another branch crosses, it does not."""
    if kind == "fold":
        return float(point.tangent[-1])
    if kind == "crossing":
        return CRITERIA["fold"](point.loop) * float(np.sign(point.tangent[-1]))
    return CRITERIA[kind](point.loop)


@dataclass(frozen=True)
class Finding:
    """Something that happens on a branch: what, the orbit there, and how well its place is known.

    ``border`` is the one that it touches; ``crossed`` how the branch goes on where another one crosses it.
    """

    kind: str
    loop: Loop
    error: float
    border: int = -1
    crossed: FloatArray | None = None


def findings(one: Seen, other: Seen, length: float, before: Seen | None = None, depth: int = 0) -> Iterator[Finding]:
    """All that happens between two points of a branch, in its order; halves the step where something may be hidden in it."""
    setting = one.setting
    changed = [kind for kind in KINDS if (one.criteria[kind] < 0) != (other.criteria[kind] < 0)]
    pairs = list(paired(one.touches, other.touches)) if len(one.touches) == len(other.touches) else []
    pairs = pairs or list(paired(one.touches, other.touches))
    through = [pair for pair in pairs if (pair[0].level < 0) != (pair[1].level < 0)]
    kinks = sum(abs(a - b) for a, b in zip(signature(one.point), signature(other.point), strict=True)) // 2
    hidden = (
        kinks != len(through)
        or any(may_touch(*pair, length) for pair in pairs if pair not in through)
        or (before is not None and any(_bends_to_zero(kind, before, one, other) for kind in CRITERIA if kind not in changed))
        or len(changed) + len(through) > 1
    )
    if hidden and depth < DEEPEST:
        try:
            middle = Seen(setting, corrected(setting, one.point, length / 2))
        except ConvergenceError:
            middle = None
        if middle is not None:
            rest = between(setting, middle.point, other.point)
            yield from findings(one, middle, length / 2, before, depth + 1)
            yield from findings(middle, other, rest, one, depth + 1)
            return
    for touch, after in through:
        yield from _grazing(one, other, touch, after)
    for kind in changed:
        yield from _located(kind, one, other, length)


def _bends_to_zero(kind: str, before: Seen, one: Seen, other: Seen) -> bool:
    """Whether the parabola through three values of one sign, equally far apart, comes to 0 between the last two."""
    a, b, c = (each.criteria[kind] for each in (before, one, other))
    if not (a > 0) == (b > 0) == (c > 0):
        return False
    slope, bend = (c - a) / 2, (a + c) / 2 - b
    if bend * b <= 0 or not 0 < -slope / (2 * bend) < 1:
        return False
    lowest = b - slope**2 / (4 * bend)
    return lowest * b < 0.05 * b * b


def _grazing(one: Seen, other: Seen, touch: Touch, after: Touch) -> Iterator[Finding]:
    near, turn = (one, touch) if abs(touch.level) <= abs(after.level) else (other, after)
    for point, begun in ((near, turn), (one, touch), (other, after)):
        try:
            loop = grazing(one.setting, point.point, begun)
        except ConvergenceError:
            continue
        index = one.setting.free[0]
        ends = sorted(each.point.loop.guess.values[index] for each in (one, other))
        width = ends[1] - ends[0]
        if ends[0] - width - 1e-12 <= loop.guess.values[index] <= ends[1] + width + 1e-12:
            yield Finding("grazing", loop, 10 * loop.missed + 1e-12, touch.turn.border)
            return
    yield Finding(
        "grazing", near.point.loop, abs(other.point.loop.guess.values[one.setting.free[0]] - _value(one)), touch.turn.border
    )


def _value(seen: Seen) -> float:
    return seen.point.loop.guess.values[seen.setting.free[0]]


def _located(kind: str, one: Seen, other: Seen, length: float) -> Iterator[Finding]:
    """Where a test function is zero, by bracketing along the arc."""
    from scipy.optimize import brentq

    setting, known = one.setting, {0.0: one.point, length: other.point}

    def value(arc: float) -> float:
        if arc not in known:
            known[arc] = corrected(setting, one.point, arc)
        return criterion(kind, known[arc])

    try:
        root = float(brentq(value, 0.0, length, xtol=LOCATED, rtol=8.9e-16))
    except (ConvergenceError, ValueError):
        merged = None
        if kind in ("fold", "crossing"):
            merged = halved(setting, min((one.point, other.point), key=lambda point: abs(float(point.tangent[-1]))).loop)
        if merged is not None:
            yield Finding("merging", merged, 1e-11)
        else:
            crossed = other.point.tangent if kind == "crossing" else None
            yield Finding(
                "fold" if kind == "crossing" else kind, other.point.loop, abs(_value(one) - _value(other)), crossed=crossed
            )
        return
    point = known[root] if root in known else corrected(setting, one.point, root)
    if kind == "torus" and not is_complex_pair(point.loop):
        return
    if kind == "crossing" and abs(point.tangent[-1]) * setting.spans[0] < FLAT:
        return  # the fold itself, by rounding
    merged = halved(setting, point.loop) if kind == "fold" else None
    if merged is not None:
        yield Finding("merging", merged, 1e-11)
        return
    near = min((abs(arc - root), arc) for arc in known if arc != root)[1]
    index = setting.free[0]
    error = abs(known[near].loop.guess.values[index] - point.loop.guess.values[index])
    if kind == "crossing":
        yield Finding("fold", point.loop, max(error, 1e-11), crossed=point.tangent)
        return
    yield Finding(kind, point.loop, min(error, abs(point.tangent[-1]) * 1e-9 + 1e-11))


def repeats(loop: Loop) -> bool:
    """Whether a loop is one orbit twice round: its turns of the second half are those of the first."""
    turns = [turn for turn in loop.turns() if turn.border == -1]
    half = loop.guess.period / 2
    for turn in turns:
        later = [each for each in turns if abs(each.t - turn.t - half) < 1e-3 * half]
        if turn.t < 0.9 * half and not any(np.abs(each.state - turn.state).max() < 1e-5 for each in later):
            return False
    return bool(turns)


def halved(setting: Setting, loop: Loop) -> Loop | None:
    """The doubling of the cycle of half the period, where a doubled cycle ends near a loop; None if it is no such end."""
    guess, field = loop.guess, setting.field
    index, size = setting.free[0], field.size
    if len(guess.states) > 1:
        middle = divided(field, setting.fly, Guess(guess.states[:1], guess.period, guess.values), 2).states[1]
    else:
        none = np.zeros((2, len(field.parameters)))
        middle = setting.fly(guess.states[0], loop.constants, guess.period / 2, none).state
    if np.abs(middle - guess.states[0]).max() > 0.05 * max(1.0, float(np.abs(guess.states).max())):
        return None
    begun = Guess(((middle + guess.states[0]) / 2)[None], guess.period / 2, guess.values)

    def at(value: float) -> Loop:
        values = list(guess.values)
        values[index] = value
        moved = Guess(begun.states, begun.period, tuple(values))
        constants = field.constants(values)
        return solved(field, setting.fly, moved, across(field, moved.states[0], constants, size + 1))

    try:
        low, high = guess.values[index], guess.values[index] + 1e-4 * setting.spans[0]
        a, b = at_minus_one(at(low)), at_minus_one(at(high))
        for _ in range(20):
            if a == b or abs(high - low) < 1e-15 * (1 + abs(high)):
                break
            low, high, a = high, high - b * (high - low) / (b - a), b
            if abs(high - guess.values[index]) > 0.1 * setting.spans[0]:
                return None
            b = at_minus_one(at(high))
        return at(high) if abs(b) < 1e-8 else None
    except ConvergenceError:
        return None
