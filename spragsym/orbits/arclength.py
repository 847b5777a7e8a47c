"""Pseudo-arclength continuation: the next closed orbit on a branch, through folds of the branch."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from ..core.errors import ConvergenceError
from ..models.field import Mode
from ..models.parameters import FloatArray, Span
from ..motion.integrators import Flow
from ..motion.multipliers import criterion_of, unsure
from ..motion.shooting import (
    Conditions,
    Iterate,
    Orbit,
    across,
    closed_orbit,
    integrated,
    offset_from_jumps,
    refined_mesh,
    remeshed,
    rounding,
)
from ..numerics.vectors import magnitude, norm
from .options import BranchOptions


def in_phase(_: Setting, near: Orbit, target: FloatArray) -> Conditions:
    """The first state stays in the plane across the flow at an orbit, through a target."""
    return across(near, target[: near.field.size])


@dataclass(frozen=True)
class Setting:
    """Setting that all points of a branch share: the flow, which parameters are free, and units of
    the arc's length.

    ``holds(setting, orbit, target)`` is what holds near an orbit besides closing: the phase, in the
    plane across the flow at that orbit, through a target; along a curve of events its test
    function's equation too.
    """

    flow: Flow
    free: tuple[int, ...]
    period: float
    spans: tuple[float, ...]
    holds: Callable[[Setting, Orbit, FloatArray], Conditions] = in_phase
    options: BranchOptions = field(default_factory=BranchOptions)

    def integrated(self, guess: Iterate) -> Orbit:
        """A guess integrated, with derivatives by what is free."""
        return integrated(self.flow, replace(guess, free=self.free))

    def weights(self, orbit: Orbit) -> FloatArray:
        """Weights of states, period and parameters in the length of the arc."""
        each = np.full(orbit.states.size, 1 / np.sqrt(len(orbit.states)))
        return np.concatenate([each, [1 / self.period], 1 / np.array(self.spans)])


class Touch(NamedTuple):
    """Contact of an orbit with a border: it comes to it, or turns where the border's level is
    extremal.

    ``way`` is the border with the direction of the turn, or with the sign of the level from which
    it comes; ``share`` is that of the period. At a turn ``level`` is the border's, with its slope
    along the branch; at an arrival it is negative if it does not stay.
    """

    way: tuple[int, int]
    share: float
    state: FloatArray
    level: float
    slope: float = np.nan


@dataclass(frozen=True)
class BranchPoint:
    """A closed orbit on a branch, and the direction in which the branch goes on: of length 1 in the
    branch's units.

    ``alone`` is that there is no other direction, as there is where orbits at one value of the
    parameter are a whole family.
    """

    setting: Setting
    orbit: Orbit
    tangent: FloatArray
    alone: bool = True

    @property
    def value(self) -> float:
        """The value of the first free parameter."""
        return self.orbit.guess.varied[0]

    @property
    def coordinates(self) -> FloatArray:
        """States, period and free parameters."""
        return self.orbit.guess.coordinates

    @property
    def weights(self) -> FloatArray:
        """Units of the arc's length."""
        return self.setting.weights(self.orbit)

    @property
    def place(self) -> FloatArray:
        """States, period and free parameters in these units."""
        return self.weights * self.coordinates

    @property
    def way(self) -> FloatArray:
        """The tangent in these units, of length 1."""
        return self.weights * self.tangent

    def oriented(self, sign: float) -> BranchPoint:
        """The point, with the branch going on the other way for −1."""
        return replace(self, tangent=sign * self.tangent)

    @cached_property
    def touches(self) -> list[Touch]:
        """All turns of the borders' levels."""
        orbit, tangent = self.orbit, self.tangent
        size, along, found = orbit.field.size, tangent[orbit.states.size + 1 :], list[Touch]()
        for extremum in orbit.extrema():
            mode = orbit.mode(extremum.state)
            if extremum.border >= 0 and orbit.field.borders[extremum.border].sign(mode):
                change = extremum.by_state @ tangent[:size] + extremum.by_parameters @ along
                way, at = np.append(change, along), np.append(extremum.state, orbit.guess.varied)
                step = 1e-6 / max(1.0, magnitude(change))
                back, level, ahead = (
                    float(level_and_rate(orbit, extremum.border, mode, at + share * step * way)[0])
                    for share in (-1, 0, 1)
                )
                slope = (ahead - back) / (2 * step)
                found.append(
                    Touch(
                        (extremum.border, extremum.direction),
                        extremum.t / orbit.period,
                        extremum.state,
                        level,
                        slope,
                    )
                )
        return found


def level_and_rate(orbit: Orbit, border: int, mode: Mode, point: FloatArray) -> FloatArray:
    """Level and rate of a border in a mode at a state, followed by the free parameters, as they are
    for an orbit.
    """
    field, guess, size = orbit.field, orbit.guess, orbit.field.size
    for index, value in zip(guess.free, point[size:].tolist(), strict=True):
        guess = guess.at(index, value)
    constants, state = field.constants(guess.values), point[:size].tolist()
    that = field.borders[border]
    rate = field.level_rate(that, state, constants, mode)
    return np.array([that.level(state, constants, mode), rate], dtype=float)


def point_of(setting: Setting, orbit: Orbit, along: FloatArray | None = None) -> BranchPoint:
    """A point with its tangent, turned so that it goes along a direction; by default to larger
    values of the first parameter.
    """
    sizes, ways = directions(setting, orbit)
    # Share of the largest singular value below which another one is 0.
    least_singular = 1e-10
    # How little what does not close may move an orbit.
    point = BranchPoint(
        setting,
        orbit,
        ways[-1] / setting.weights(orbit),
        bool(sizes[-1] > max(least_singular * sizes[0], orbit.largest_gap / 1e-6)),
    )
    ahead = turning(point) if along is None else point.way @ (along * point.weights)
    return point.oriented(-1.0 if ahead < 0 else 1.0)


def directions(setting: Setting, orbit: Orbit) -> tuple[FloatArray, FloatArray]:
    """Singular values of the equations' derivative, and right singular vectors, a row each, in
    units of the arc.

    The last vectors span its null space; there is one more of them than values.
    """
    _, rows = setting.holds(setting, orbit, orbit.guess.coordinates)(orbit)
    return np.linalg.svd(orbit.slopes(rows) / setting.weights(orbit))[1:]


def resolution(orbit: Orbit, kind: str) -> float:
    """Unit in which the error of a test function, a hundredfold, is below the gap that an orbit may
    leave open.
    """
    return max(1.0, 100.0 * unsure(orbit, kind) / orbit.options.closed)


def at_zero(kind: str, setting: Setting, near: Orbit, target: FloatArray) -> Conditions:
    """Conditions of a closed orbit at which a test function is 0, in its :func:`resolution`, so
    that its rounding does not keep the orbit open.
    """
    phase, unit = in_phase(setting, near, target), resolution(near, kind)
    weights = setting.weights(near)

    def conditions(orbit: Orbit) -> tuple[FloatArray, FloatArray]:
        off, row = phase(orbit)
        # Differences of the condition are taken over this.
        slope = differences(
            lambda step: np.array(
                [
                    criterion_of(
                        kind, integrated(setting.flow, replace(orbit.guess.moved(step), free=()))
                    )
                ]
            ),
            np.zeros(len(weights)),
            1e-6 / weights,
        )
        return np.append(off, criterion_of(kind, orbit) / unit), np.vstack([row, slope / unit])

    return conditions


def corrected(
    point: BranchPoint, length: float, *, reach: float = np.inf, iterations: int = 7
) -> BranchPoint:
    """The point on the branch a length of arc from a point, negative lengths backward."""
    setting = point.setting
    guess = point.orbit.guess.moved(length * point.tangent)
    target, arc = guess.coordinates, (point.way * point.weights)[None]
    # Orbits may be as small as 1e-3 in the model's units.
    options = replace(setting.flow.options, steps=iterations, last_step=1e-15)
    orbit = closed_orbit(
        setting.flow,
        guess,
        setting.holds(setting, point.orbit, target),
        lambda orbit: (arc @ (orbit.guess.coordinates - target), arc),
        reach=reach,
        options=options,
    )
    return point_of(setting, orbit, point.tangent)


def fixed(setting: Setting, orbit: Orbit) -> Orbit:
    """The closed orbit near another at the same value of the parameter, with the derivatives by the
    parameter.
    """
    orbit = orbit.bound()
    conditions = setting.holds(setting, orbit, orbit.guess.coordinates)
    return setting.integrated(closed_orbit(setting.flow, orbit.guess, conditions).guess)


def placed(point: BranchPoint, value: float, way: FloatArray | None = None) -> BranchPoint:
    """The point at a value of the first free parameter, near where a way from another point, by
    default its tangent, leads.
    """
    setting, way = point.setting, point.tangent if way is None else way
    step = (value - point.value) / float(way[-len(setting.free)]) * way
    # Exactly, since there may be no parameters beyond.
    near = setting.integrated(point.orbit.guess.moved(step).at(setting.free[0], value))
    return point_of(setting, fixed(setting, near), point.tangent)


def within(point: BranchPoint, length: float, to: Span, reach: float = np.inf) -> BranchPoint:
    """The point a length of arc ahead, or at the end of a range of the first free parameter where
    the tangent leads beyond it.

    There may be no parameters beyond. ConvergenceError where the branch itself leads beyond it.
    """
    aim = point.value + length * turning(point)
    end = min(max(aim, to[0]), to[1])
    found = corrected(point, length, reach=reach) if end == aim else placed(point, end)
    moved = 0.0 if end == aim else magnitude(found.orbit.states - point.orbit.states)
    if moved > reach or not to[0] <= found.value <= to[1]:
        raise ConvergenceError("the end of the range is nearer, or farther, than a step")
    return found


def turning(point: BranchPoint) -> float:
    """Component of the first free parameter in the direction of a branch: 0 where it turns back."""
    return float(point.tangent[-len(point.setting.free)])


def steps(
    point: BranchPoint,
    ahead: Callable[[BranchPoint, float], BranchPoint],
    options: BranchOptions,
    look: Callable[[BranchPoint, BranchPoint, float], Any] = lambda _, found, length: found,
) -> Iterator[Any]:
    """Points of a branch by steps that are shorter where one fails or the branch bends, longer
    where it is straight; no end.

    ``ahead`` gives the point a length of arc from another, ``look`` what is seen on that way, by
    default the point; a ConvergenceError of either ends the steps once they are the shortest.
    """
    length = options.first_step
    while True:
        try:
            found = ahead(point, length)
            straight = aligned(point, found)
            if straight < options.straight and length > options.kink:
                raise ConvergenceError("it bends within the shortest step")
            seen = look(point, found, length)
        except (ConvergenceError, ZeroDivisionError, np.linalg.LinAlgError):
            length /= 3
            if length < options.shortest_step:
                raise
            continue
        yield seen
        point = remeshed_point(found)
        length = min(options.longest_step, length * (1.6 if straight > options.straighter else 1.1))


def zero_of(
    test: Callable[[BranchPoint], float],
    one: BranchPoint,
    other: BranchPoint,
    length: float,
    xtol: float | None = None,
    *,
    singular: bool = False,
) -> BranchPoint:
    """Zero of a test function between two points, by bracketing along the arc; ConvergenceError,
    ValueError without.

    Where the equations are ``singular`` at the zero, Newton's method comes only so near to it: then
    the point next to the first one that it does not find.
    """
    from scipy.optimize import brentq

    points, xtol = {0.0: one, length: other}, xtol or one.setting.options.located

    def value(arc: float) -> float:
        if arc not in points:
            try:
                points[arc] = corrected(one, arc)
            except ConvergenceError:
                if not singular:
                    raise
                points[arc] = points[min(points, key=lambda known: abs(known - arc))]
                return 0.0
        return test(points[arc])

    return points[float(brentq(value, 0.0, length, xtol=xtol, rtol=8.9e-16))]


def along(point: BranchPoint, value: float) -> BranchPoint:
    """The point at a value of the free parameter on the same sheet of a branch, which may not turn
    back on the way.

    By steps each of which agrees with the tangents at both of its ends: Newton's method alone may
    find another sheet, or another branch. ConvergenceError where there is no such way.
    """
    setting, direction = point.setting, math.copysign(1.0, value - point.value)
    to = (min(point.value, value), max(point.value, value))

    def ahead(point: BranchPoint, length: float) -> BranchPoint:
        found = within(point, length, to)
        if not turning(found) * direction > 0:
            raise ConvergenceError("it turns back")
        return found

    try:
        # Options of the way to a value of the parameter, in shares of it: all of it at
        # once where the branch is straight.
        on_the_way = BranchOptions(
            first_step=2.0, longest_step=np.inf, shortest_step=1e-3, kink=0.0
        )
        for found in steps(
            point.oriented(direction * math.copysign(1.0, turning(point))),
            ahead,
            on_the_way,
        ):
            point = found
            if point.value == value:
                break
    except (ConvergenceError, ZeroDivisionError) as error:
        name = point.orbit.field.parameters[setting.free[0]]
        what = "cycle" if setting.holds is in_phase else "equilibrium"
        raise ConvergenceError(
            f"the {what} ends near {name} = {point.value:.10g} on the way"
        ) from error
    return point


def remeshed_point(point: BranchPoint) -> BranchPoint:
    """The point in more mesh intervals, where derivatives over one have grown large, or in others,
    where one begins at a jump.
    """
    orbit, setting, begin = point.orbit, point.setting, 0.0
    if setting.holds is not in_phase:
        return point
    if (cut := refined_mesh(orbit)) is None and (begin := offset_from_jumps(orbit)):
        cut = remeshed(orbit, len(orbit.states), begin)
    if cut is None:
        return point
    along = np.zeros(cut.states.shape)
    if (
        not begin
    ):  # the old tangent by its first state, if that is still the first, period and parameter
        along[0] = point.tangent[: orbit.field.size]
    return point_of(
        setting, setting.integrated(cut), np.append(along, point.tangent[orbit.states.size :])
    )


def uncertainty(point: BranchPoint) -> float:
    """Error of the parameter: what does not close, with what rounding adds, times the sensitivity
    along the branch.
    """
    orbit = point.orbit
    _, phase = across(orbit)(orbit)
    rows = orbit.slopes(phase, (point.way * point.weights)[None])
    return float(np.abs(np.linalg.pinv(rows, rcond=1e-14)[-1]).sum()) * max(
        orbit.largest_gap, rounding(orbit)
    )


def between(one: BranchPoint, other: BranchPoint) -> float:
    """Length of the chord from one point to the other along the first one's tangent."""
    return float((other.place - one.place) @ one.way)


def aligned(one: BranchPoint, other: BranchPoint) -> float:
    """The smallest cosine between two tangents and the chord from one point to the other, if these
    are apart.
    """
    chord, both = other.place - one.place, float(one.way @ other.way)
    length = norm(chord)
    if length > 0:
        return min(both, *(float(chord @ each.way) / length for each in (one, other)))
    return both


def started(setting: Setting, guess: Iterate) -> BranchPoint:
    """The first point of a branch, from a closed orbit."""
    orbit = setting.integrated(guess)
    if orbit.largest_gap > 1e-9:
        raise ConvergenceError("a branch begins at a closed orbit")
    return point_of(setting, orbit)


def differences(
    function: Callable[[FloatArray], FloatArray], point: FloatArray, step: FloatArray | float
) -> FloatArray:
    """Central differences of a function by each number of a place, along the last axis."""
    ways = np.eye(len(point)) * step
    return np.stack(
        [(function(point + way) - function(point - way)) / (2 * way.max()) for way in ways], axis=-1
    )
