"""Pseudo-arclength continuation of closed orbits.

A branch is a curve of closed orbits in the space of the unknowns: states at the mesh nodes, period,
free parameters. The curve is followed by prediction along the tangent and correction by Newton's
method (:func:`corrected`), in the hyperplane at a given arclength; so it passes folds, at which the
parameter turns back. :func:`steps` controls the step length, :func:`zero_of` locates zeros of a
test function along the arc. With a test function as a further equation and a second free parameter,
the same functions follow a curve of bifurcations.
"""

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
    """Phase condition: the first state lies in the plane through that of ``target``, normal to the
    flow at the first state of the orbit ``near``.
    """
    return across(near, target[: near.field.size])


@dataclass(frozen=True)
class Setting:
    """Data that all points of a branch share: the flow, the indices of the free parameters, and the
    units of arclength, which are a ``period`` and a span for each free parameter.

    ``holds(setting, orbit, target)`` gives the equations besides closing, near an orbit: the phase
    condition, with ``target`` as in :func:`in_phase`; along a curve of bifurcations a test function
    = 0, too.
    """

    flow: Flow
    free: tuple[int, ...]
    period: float
    spans: tuple[float, ...]
    holds: Callable[[Setting, Orbit, FloatArray], Conditions] = in_phase
    options: BranchOptions = field(default_factory=BranchOptions)

    def integrated(self, guess: Iterate) -> Orbit:
        """The orbit of an iterate, with derivatives by the free parameters."""
        return integrated(self.flow, replace(guess, free=self.free))

    def weights(self, orbit: Orbit) -> FloatArray:
        """Weights of states, period and free parameters in arclength: reciprocal units."""
        each = np.full(orbit.states.size, 1 / np.sqrt(len(orbit.states)))
        return np.concatenate([each, [1 / self.period], 1 / np.array(self.spans)])


class Touch(NamedTuple):
    """A point of an orbit at which the level of a border has an extremum, or at which the orbit
    arrives at a border on which it may stay.

    ``way`` is the index of the border, with −1 for a maximum and 1 for a minimum, or with the sign
    of the level before the arrival. ``share`` is the time as a share of the period. At an extremum
    ``level`` is the border's level there, and ``slope`` its derivative along the branch. At an
    arrival ``level`` is negative if the orbit does not stay.
    """

    way: tuple[int, int]
    share: float
    state: FloatArray
    level: float
    slope: float = np.nan


@dataclass(frozen=True)
class BranchPoint:
    """A closed orbit on a branch, with the branch's tangent there, of length 1 in arclength.

    ``alone`` is True if the tangent is unique. It is not where the orbits at one value of the
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
        """The unknowns: states, period and free parameters."""
        return self.orbit.guess.coordinates

    @property
    def weights(self) -> FloatArray:
        """Weights of the unknowns in arclength."""
        return self.setting.weights(self.orbit)

    @property
    def scaled(self) -> FloatArray:
        """The unknowns times their weights: distances of these are arclengths."""
        return self.weights * self.coordinates

    @property
    def direction(self) -> FloatArray:
        """The tangent times the weights, a unit vector."""
        return self.weights * self.tangent

    def oriented(self, sign: float) -> BranchPoint:
        """The point with its tangent multiplied by a sign."""
        return replace(self, tangent=sign * self.tangent)

    @cached_property
    def touches(self) -> list[Touch]:
        """The extrema of the levels of all borders of the modes in which they occur."""
        orbit, tangent, found = self.orbit, self.tangent, list[Touch]()
        size, by_branch = orbit.field.size, tangent[orbit.states.size + 1 :]
        for extremum in orbit.extrema():
            mode = orbit.mode(extremum.state)
            if extremum.border < 0 or not orbit.field.borders[extremum.border].sign(mode):
                continue
            change = extremum.by_state @ tangent[:size] + extremum.by_parameters @ by_branch
            direction = np.append(change, by_branch)
            at = np.append(extremum.state, orbit.guess.varied)
            step = 1e-6 / max(1.0, magnitude(change))
            back, level, ahead = (
                float(level_and_rate(orbit, extremum.border, mode, at + k * step * direction)[0])
                for k in (-1, 0, 1)
            )
            found.append(
                Touch(
                    (extremum.border, extremum.direction),
                    extremum.t / orbit.period,
                    extremum.state,
                    level,
                    (ahead - back) / (2 * step),
                )
            )
        return found


def level_and_rate(orbit: Orbit, border: int, mode: Mode, point: FloatArray) -> FloatArray:
    """Level and rate of the border with index ``border`` in a mode, (2,). ``point`` is a state
    followed by values of the free parameters; other parameters are the orbit's.
    """
    field, guess, size = orbit.field, orbit.guess, orbit.field.size
    for index, value in zip(guess.free, point[size:].tolist(), strict=True):
        guess = guess.at(index, value)
    constants, state = field.constants(guess.values), point[:size].tolist()
    that = field.borders[border]
    rate = field.level_rate(that, state, constants, mode)
    return np.array([that.level(state, constants, mode), rate], dtype=float)


def point_of(setting: Setting, orbit: Orbit, along: FloatArray | None = None) -> BranchPoint:
    """The point of an orbit, with the tangent that has a positive component along ``along``; by
    default towards larger values of the first free parameter.
    """
    sizes, vectors = directions(setting, orbit)
    # The tangent is unique if the smallest singular value is not 0: it exceeds rounding, and the
    # largest gap divided by it moves the orbit by less than 1e-6.
    unique = bool(sizes[-1] > max(1e-10 * sizes[0], orbit.largest_gap / 1e-6))
    point = BranchPoint(setting, orbit, vectors[-1] / setting.weights(orbit), unique)
    ahead = turning(point) if along is None else point.direction @ (along * point.weights)
    return point.oriented(-1.0 if ahead < 0 else 1.0)


def directions(setting: Setting, orbit: Orbit) -> tuple[FloatArray, FloatArray]:
    """Singular values of the Jacobian in units of arclength, and its right singular vectors, a row
    each.

    There is one vector more than values: the last one spans the null space, the tangent.
    """
    _, rows = setting.holds(setting, orbit, orbit.guess.coordinates)(orbit)
    return np.linalg.svd(orbit.slopes(rows) / setting.weights(orbit))[1:]


def resolution(orbit: Orbit, kind: str) -> float:
    """Factor by which a test function is divided so that a hundred times its error is below the
    tolerance of shooting.
    """
    return max(1.0, 100.0 * unsure(orbit, kind) / orbit.options.closed)


def at_zero(kind: str, setting: Setting, near: Orbit, target: FloatArray) -> Conditions:
    """Conditions of a bifurcation: the phase condition, and the test function of ``kind`` = 0.

    The test function is divided by its :func:`resolution`, so that its rounding does not keep
    Newton's method from converging. Its derivatives are central differences.
    """
    phase, unit = in_phase(setting, near, target), resolution(near, kind)
    weights = setting.weights(near)

    def conditions(orbit: Orbit) -> tuple[FloatArray, FloatArray]:
        def test(step: FloatArray) -> FloatArray:
            moved = replace(orbit.guess.moved(step), free=())
            return np.array([criterion_of(kind, integrated(setting.flow, moved))])

        residual, row = phase(orbit)
        slope = differences(test, np.zeros(len(weights)), 1e-6 / weights)
        return np.append(residual, criterion_of(kind, orbit) / unit), np.vstack([row, slope / unit])

    return conditions


def corrected(
    point: BranchPoint, length: float, *, reach: float = np.inf, iterations: int = 7
) -> BranchPoint:
    """The point of the branch at an arclength from another point; negative lengths are backward.

    Predictor along the tangent, corrector by Newton's method in the hyperplane normal to it.
    """
    setting = point.setting
    guess = point.orbit.guess.moved(length * point.tangent)
    target, arc = guess.coordinates, (point.direction * point.weights)[None]
    # A small last step, because orbits may have an extent of 1e-3.
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
    """The closed orbit near an orbit with the parameter fixed, integrated with the derivatives by
    the parameter.
    """
    orbit = orbit.bound()
    conditions = setting.holds(setting, orbit, orbit.guess.coordinates)
    return setting.integrated(closed_orbit(setting.flow, orbit.guess, conditions).guess)


def placed(point: BranchPoint, value: float, direction: FloatArray | None = None) -> BranchPoint:
    """The point of the branch at a value of the first free parameter, predicted from another point
    along a direction, by default the tangent.
    """
    setting, direction = point.setting, point.tangent if direction is None else direction
    step = (value - point.value) / float(direction[-len(setting.free)]) * direction
    # The value is set exactly: rounding could exceed the parameter's range.
    near = setting.integrated(point.orbit.guess.moved(step).at(setting.free[0], value))
    return point_of(setting, fixed(setting, near), point.tangent)


def within(point: BranchPoint, length: float, to: Span, reach: float = np.inf) -> BranchPoint:
    """The point of the branch at an arclength ahead; or at the end of the range ``to`` of the first
    free parameter, if the tangent leads beyond it.

    The model may not allow values beyond. Raises ConvergenceError if the branch itself leads
    beyond.
    """
    aim = point.value + length * turning(point)
    end = min(max(aim, to[0]), to[1])
    found = corrected(point, length, reach=reach) if end == aim else placed(point, end)
    moved = 0.0 if end == aim else magnitude(found.orbit.states - point.orbit.states)
    if moved > reach or not to[0] <= found.value <= to[1]:
        raise ConvergenceError("the end of the range is nearer, or farther, than a step")
    return found


def turning(point: BranchPoint) -> float:
    """Component of the tangent along the first free parameter, which is 0 at a fold."""
    return float(point.tangent[-len(point.setting.free)])


def steps(
    point: BranchPoint,
    ahead: Callable[[BranchPoint, float], BranchPoint],
    options: BranchOptions,
    look: Callable[[BranchPoint, BranchPoint, float], Any] = lambda _, found, length: found,
) -> Iterator[Any]:
    """Follow a branch from a point: yield the result of ``look`` for each step, without end.

    ``ahead(point, length)`` makes a step of a given arclength. ``look(point, found, length)``
    examines it, by default it gives the new point. If one of them raises ConvergenceError, or the
    branch bends too much, the step is repeated with a third of its length; below the shortest step
    the error is raised. Steps grow while the branch is straight.
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
    """The point between two points of a branch at which a test function is 0, by Brent's method in
    arclength. Raises ValueError if the test function has one sign at both, ConvergenceError if an
    orbit is not found.

    If the Jacobian is ``singular`` at the zero, Newton's method fails next to it: then the zero is
    the known point nearest to the first one at which it fails.
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
    """The point at a value of the free parameter, reached along the branch without a fold.

    Each step must agree with the tangents at both ends: a single Newton iteration might converge to
    another sheet, or another branch. Raises ConvergenceError if the branch has a fold or ends
    before the value.
    """
    setting, direction = point.setting, math.copysign(1.0, value - point.value)
    to = (min(point.value, value), max(point.value, value))

    def ahead(point: BranchPoint, length: float) -> BranchPoint:
        found = within(point, length, to)
        if not turning(found) * direction > 0:
            raise ConvergenceError("it turns back")
        return found

    try:
        # The first step is long enough for the whole way.
        options = BranchOptions(first_step=2.0, longest_step=np.inf, shortest_step=1e-3, kink=0.0)
        start = point.oriented(direction * math.copysign(1.0, turning(point)))
        for found in steps(start, ahead, options):
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
    """The point on a finer mesh, if deviations grow too much over one interval; or on a shifted
    mesh, if a node is near a jump of the field.
    """
    orbit, setting, begin = point.orbit, point.setting, 0.0
    if setting.holds is not in_phase:
        return point
    mesh = refined_mesh(orbit)
    if mesh is None and (begin := offset_from_jumps(orbit)):
        mesh = remeshed(orbit, len(orbit.states), begin)
    if mesh is None:
        return point
    # The new tangent is oriented by the old one's components of period, parameters and, if it is
    # the same, the first state.
    states = np.zeros(mesh.states.shape)
    if not begin:
        states[0] = point.tangent[: orbit.field.size]
    old = np.append(states, point.tangent[orbit.states.size :])
    return point_of(setting, setting.integrated(mesh), old)


def uncertainty(point: BranchPoint) -> float:
    """Error of the parameter at a point: the largest of gaps and rounding, times the row sum of
    |J⁻¹| for the parameter, J the Jacobian with the arclength condition.
    """
    orbit = point.orbit
    _, phase = across(orbit)(orbit)
    jacobian = orbit.slopes(phase, (point.direction * point.weights)[None])
    sensitivity = float(np.abs(np.linalg.pinv(jacobian, rcond=1e-14)[-1]).sum())
    return sensitivity * max(orbit.largest_gap, rounding(orbit))


def between(one: BranchPoint, other: BranchPoint) -> float:
    """Arclength from one point to another: the component of the chord along the first tangent."""
    return float((other.scaled - one.scaled) @ one.direction)


def aligned(one: BranchPoint, other: BranchPoint) -> float:
    """The smallest cosine between the tangents at two points and the chord between them."""
    chord, cosine = other.scaled - one.scaled, float(one.direction @ other.direction)
    length = norm(chord)
    if length > 0:
        return min(cosine, *(float(chord @ each.direction) / length for each in (one, other)))
    return cosine


def started(setting: Setting, guess: Iterate) -> BranchPoint:
    """The first point of a branch, from a closed orbit; ConvergenceError if it is not closed."""
    orbit = setting.integrated(guess)
    if orbit.largest_gap > 1e-9:
        raise ConvergenceError("a branch begins at a closed orbit")
    return point_of(setting, orbit)


def differences(
    function: Callable[[FloatArray], FloatArray], point: FloatArray, step: FloatArray | float
) -> FloatArray:
    """Derivatives of a function by each component of ``point``, by central differences, along the
    last axis.
    """
    offsets = np.eye(len(point)) * step
    slopes = [(function(point + h) - function(point - h)) / (2 * h.max()) for h in offsets]
    return np.stack(slopes, axis=-1)
