"""Closed orbits by multiple shooting.

The period is divided into k equal mesh intervals. The unknowns are the states (k, m) at their
beginnings, the period, and any free parameters. The equations: the flow map takes each state to the
next one (a gap of 0), a phase condition, and one further condition per free parameter.
:func:`closed_orbit` solves them by Newton's method, with the derivatives of the flow from the
variational equations.

An :class:`Iterate` is a point in the space of unknowns, an :class:`Orbit` an iterate whose mesh
intervals have been integrated. Other functions choose the mesh, reduce an orbit to its least
period, and estimate its error.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import TypeAlias

import numpy as np

from ..core.errors import ConvergenceError, ParameterError
from ..models.field import OVERSHOOT, Field, Mode, Values
from ..models.parameters import FloatArray
from ..numerics.interval_arrays import BoolArray
from ..numerics.vectors import TURN, magnitude, norm, state_difference
from .integrators import Flow
from .lobatto import PiecewisePolynomial
from .multipliers import Multipliers, multipliers_of
from .options import ShootingOptions
from .scales import MotionScales, scaled, scales_of
from .solution import Crossing, Extremum, FlowResult


@dataclass(frozen=True)
class Iterate:
    """Iterate of Newton's method: ``states`` (k, m) at the beginnings of k equal mesh intervals,
    the period, and the values of all parameters, of which those with indices ``free`` are unknown.
    """

    states: FloatArray
    period: float
    values: Values
    free: tuple[int, ...] = ()

    @property
    def interval(self) -> float:
        """Length of a mesh interval."""
        return self.period / len(self.states)

    def moved(self, step: FloatArray) -> Iterate:
        """The next iterate, by a step in states, period and free parameters."""
        size = self.states.size
        values = list(self.values)
        for index, change in zip(self.free, step[size + 1 :], strict=True):
            values[index] += float(change)
        states = self.states + step[:size].reshape(self.states.shape)
        return Iterate(states, self.period + float(step[size]), tuple(values), self.free)

    def at(self, index: int, value: float) -> Iterate:
        """The iterate with another value of one parameter, by its index."""
        return replace(self, values=(*self.values[:index], value, *self.values[index + 1 :]))

    @property
    def varied(self) -> list[float]:
        """Values of the free parameters."""
        return [self.values[i] for i in self.free]

    @property
    def coordinates(self) -> FloatArray:
        """Vector of the unknowns: states, period, free parameters; (k m + 1 + free,)."""
        return np.concatenate([self.states.ravel(), [self.period], self.varied])


@dataclass(frozen=True)
class Orbit:
    """An iterate with the results of the flow map over its mesh intervals. It may have gaps."""

    flow: Flow
    guess: Iterate
    constants: Values
    flow_results: tuple[FlowResult, ...]

    @property
    def field(self) -> Field:
        """The field."""
        return self.flow.field

    @property
    def options(self) -> ShootingOptions:
        """Options of shooting."""
        return self.flow.options

    @property
    def states(self) -> FloatArray:
        """States at the beginnings of the mesh intervals, (k, m)."""
        return self.guess.states

    @property
    def state(self) -> FloatArray:
        """Initial state of the orbit."""
        return self.states[0]

    @property
    def period(self) -> float:
        """The period."""
        return self.guess.period

    @property
    def values(self) -> Values:
        """Values of the parameters."""
        return self.guess.values

    def mode(self, state: FloatArray) -> Mode:
        """The mode of a state."""
        return self.field.initial_mode(state.tolist(), self.constants)

    def rate(self, state: FloatArray) -> FloatArray:
        """The derivative of a state in time."""
        return rate(self.field, state, self.constants)

    def bound(self) -> Orbit:
        """The orbit with all parameters fixed."""
        return replace(self, guess=replace(self.guess, free=()))

    @cached_property
    def ends(self) -> FloatArray:
        """Ends of the mesh intervals, shape (k, m)."""
        return np.array([each.state for each in self.flow_results])

    @cached_property
    def gaps(self) -> FloatArray:
        """Residual: end of each mesh interval minus the beginning of the next, shape (k, m).
        Periodic coordinates are compared modulo whole turns, and states modulo shifts that leave
        the field unchanged.
        """
        return state_difference(self.ends, np.roll(self.states, -1, axis=0), self.field.periodic)

    @property
    def largest_gap(self) -> float:
        """Largest absolute gap."""
        return magnitude(self.gaps)

    @cached_property
    def windings(self) -> dict[int, int]:
        """Number of turns in one period, by the index of each periodic coordinate."""
        moved = (self.ends - self.states).sum(axis=0) / TURN
        return {index: round(float(moved[index])) for index in self.field.periodic}

    @property
    def winding(self) -> int:
        """Number of turns of the first coordinate in one period."""
        return self.windings.get(0, 0)

    @cached_property
    def bounds(self) -> tuple[FloatArray, FloatArray]:
        """Smallest and largest value of each component of the state over one period, (m,) each,
        without what may be shifted.
        """
        states = np.hstack(
            [
                self.flow.samples(each, self.constants, self.guess.interval).states
                for each in self.states
            ]
        )
        states = self.field.periodic.unshifted(states.T).T
        return states.min(axis=1), states.max(axis=1)

    @cached_property
    def errors(self) -> FloatArray:
        """Errors of the components of the first state, and of the period, (m + 1,)."""
        return errors_of(self)

    @cached_property
    def leads(self) -> bool:
        """True if the leading coordinate, whose maxima mark the periods, moves by more than its
        error.
        """
        lead = self.field.lead
        values = [extremum.state[lead] for extremum in self.extrema() if extremum.border == -1]
        extent = np.ptp([*values, *self.states[:, lead]])
        return bool(self.windings.get(lead, 0) or extent > self.options.moves * self.errors[lead])

    @cached_property
    def lead(self) -> int:
        """Index of the first coordinate that moves by more than its error."""
        if self.field.lead == 0 and self.leads:
            return 0
        low, high = self.bounds
        moves = high - low > self.options.moves * self.errors[:-1]
        return int(moves[: len(self.field.coordinates)].argmax())

    def with_lead(self) -> Orbit:
        """The orbit with :attr:`lead` as the leading coordinate, integrated again if it changes."""
        lead = self.lead
        if lead == self.field.lead:
            return self
        return integrated(replace(self.flow, field=self.field.with_lead(lead)), self.guess)

    def at(self, t: float) -> FloatArray:
        """The state at a time within the period, integrated from the nearest state before."""
        interval = self.guess.interval
        which = min(int(t / interval), len(self.states) - 1)
        start, remaining = self.states[which], t - which * interval
        if not remaining > 1e-14 * interval:
            return start
        return self.flow.flow_map(start, self.constants, remaining).state

    @cached_property
    def held(self) -> FloatArray:
        """Directions in which friction holds the mass at one place for the whole period,
        orthonormal rows, (h, m); as of one block at rest beside another that moves.

        The orbit is one of a continuum, of which each has its own place along these directions.
        """
        borders, rates = self.field.borders, self.rate(self.state)
        changed = {borders[crossing.border].contact for crossing in self.crossings()}
        normals, mode = [np.zeros((0, self.field.size))], self.mode(self.state)
        n = len(self.field.coordinates)
        for border in self.field.stays(mode):
            assert border.slopes is not None
            slopes = border.slopes(self.state.tolist(), self.constants, mode)[n : 2 * n]
            normal = np.array([*slopes, *[0.0] * n], dtype=float)
            if self.field.clock:  # a place on a belt that moves to and fro
                normal[n - 1] -= normal @ rates / rates[n - 1]
            # On a belt that moves on, held places differ by a shift in time.
            still = abs(normal @ rates) <= OVERSHOOT * norm(normal)
            if still and border.contact not in changed:
                normals.append(normal[None])
        return np.linalg.qr(np.vstack(normals).T)[0].T

    @property
    def relative(self) -> FloatArray:
        """Projection of deviations across the shifts that leave the field unchanged, (m, m)."""
        return self.field.periodic.unshifted(np.eye(self.field.size))

    @property
    def drift(self) -> FloatArray:
        """By how much a period shifts each coordinate, (n,): an orbit that closes up to a shift is
        a relative periodic orbit.
        """
        moved = (self.ends - self.states).sum(axis=0)
        found: FloatArray = moved - self.field.periodic.unshifted(moved)
        return found[: len(self.field.coordinates)]

    @property
    def shifted(self) -> BoolArray:
        """Mask of the coordinates that a shift changes, (n,)."""
        n = len(self.field.coordinates)
        found: BoolArray = np.diag(self.relative)[:n] < 1 - 1e-12
        return found

    @cached_property
    def _intervals(self) -> list[FloatArray]:
        """Derivatives of the flow over the mesh intervals, (m, m) each, of deviations that leave
        the orbit where friction :attr:`held` it, across what may be shifted.
        """
        across = self.relative
        first, *others = (across @ each.by_state @ across for each in self.flow_results)
        return [first - first @ self.held.T @ self.held, *others]

    @cached_property
    def monodromy(self) -> FloatArray:
        """Monodromy matrix: derivative of the flow over one period by the first state, (m, m); 0 by
        what is :attr:`held`.
        """
        product = np.eye(self.field.size)
        for each in self._intervals:
            product = each @ product
        return product

    @property
    def ended(self) -> int:
        """Number of deviations that friction ends: across all that is :attr:`held`, and one across
        a border on which the orbit sticks for some time.
        """
        borders, held = self.field.borders, len(self.held)
        sticks = len(self.field.stays(self.mode(self.state))) > held or any(
            borders[crossing.border].stays and not crossing.sign for crossing in self.crossings()
        )
        return held + sticks

    @cached_property
    def multipliers(self) -> Multipliers:
        """Floquet multipliers. The smallest ones, of the deviations that friction :attr:`ended`,
        are set to exactly 0, those along what is :attr:`held` or may be shifted to 1.
        """
        m, held = self.field.deviations, len(self.held) + len(self.field.periodic.shifts)
        flows = [(self.relative @ self.rate(state))[:m] for state in self.states]
        found = multipliers_of([each[:m, :m] for each in self._intervals], flows)
        others, errors = found.others[: m - 1 - held], found.errors[: m - 1 - held]
        nonzero = np.arange(len(others)) < len(others) - self.ended
        return replace(
            found,
            others=np.where(nonzero, others, 0.0),
            errors=np.where(nonzero, errors, 0.0),
            held=held,
        )

    def slopes(self, *rows: FloatArray) -> FloatArray:
        """Jacobian of the gaps by states, period and free parameters, (k m, k m + 1 + free), above
        the given rows, which are those of further conditions.
        """
        (k, m), parameters = self.states.shape, len(self.guess.free)
        matrix = np.zeros((k * m, k * m + 1 + parameters))
        for i, each in enumerate(self.flow_results):
            own, after = slice(i * m, (i + 1) * m), (i + 1) % k
            matrix[own, i * m : (i + 1) * m] += each.by_state
            matrix[own, after * m : (after + 1) * m] -= np.eye(m)
            matrix[own, k * m] = self.rate(each.state) / k
            matrix[own, k * m + 1 :] = each.by_parameters[:, :parameters]
            if len(self.field.periodic.shifts):  # what may be shifted stays where it is
                matrix[own] = self.relative @ matrix[own]
                matrix[own, own] += np.eye(m) - self.relative
        # What friction holds closes at every place: it stays where it is.
        matrix[:m, :m] += self.held.T @ self.held
        return np.vstack([matrix, *rows])

    def crossings(self) -> tuple[Crossing, ...]:
        """All border crossings of one period, with times from its beginning."""
        return tuple(
            c._replace(t=c.t + i * self.guess.interval)
            for i, each in enumerate(self.flow_results)
            for c in each.crossings
        )

    def maxima(self) -> list[Extremum]:
        """Maxima of the leading coordinate, in time, that at the start included.

        An integrator may miss an extremum at either end of its interval: one at the start is added.
        """
        found = [
            extremum
            for extremum in self.extrema()
            if extremum.border == -1 and extremum.direction < 0
        ]
        start, speed = self.state, len(self.field.coordinates) + self.field.lead
        if found and abs(start[speed]) < self.options.same_state and self.rate(start)[speed] < 0:
            found.insert(0, found[0]._replace(t=0.0, state=start))
        return found

    @property
    def top(self) -> Extremum | None:
        """The largest maximum of the leading coordinate, None if there is none.

        Of several that are equal up to rounding, the one with the largest next component of the
        state, so that the choice does not depend on rounding.
        """
        found, tolerance = self.maxima(), 1e-6 * extent(self)
        for index in (self.field.lead, self.field.lead + 1):
            largest = max((maximum.state[index] for maximum in found), default=0.0)
            found = [each for each in found if each.state[index] >= largest - tolerance]
        return next(iter(found), None)

    def extrema(self) -> tuple[Extremum, ...]:
        """All extrema of one period, with derivatives by the first state of the period."""
        interval, found = self.guess.interval, []
        by_state = np.eye(self.field.size)
        by_parameters = np.zeros_like(self.flow_results[0].by_parameters)
        for i, each in enumerate(self.flow_results):
            found += [
                extremum._replace(
                    t=extremum.t + i * interval,
                    by_state=extremum.by_state @ by_state,
                    by_parameters=extremum.by_parameters + extremum.by_state @ by_parameters,
                )
                for extremum in each.extrema
            ]
            by_parameters = each.by_parameters + each.by_state @ by_parameters
            by_state = each.by_state @ by_state
        return tuple(found)

    def samples(self) -> PiecewisePolynomial:
        """One period as a piecewise polynomial."""
        return self.flow.samples(self.state, self.constants, self.period)

    def moments(self) -> tuple[float, float]:
        """Mean and root mean square over one period of the first coordinate; NaN if it winds, or
        may be shifted.
        """
        if self.winding or self.shifted[0]:
            return math.nan, math.nan
        mean, square = (
            math.fsum(each.integrals[i] for each in self.flow_results) / self.period for i in (0, 1)
        )
        if math.isnan(mean):
            samples = self.samples()
            x, weights = samples.states[0], samples.weights() / self.period
            mean, square = float((weights * x).sum()), float((weights * x**2).sum())
        return mean, math.sqrt(square)


def in_scales(orbit: Orbit) -> Orbit:
    """The orbit in units of its motion, in which the tolerances of shooting are meant."""
    field, constants = orbit.field, orbit.constants
    if field.scales:
        return orbit
    scales = scales_of(field, constants, orbit.state.tolist())
    if scales.trivial:
        return orbit
    return _converted(orbit, scaled(field, scales), scales.inverse)


def natural(orbit: Orbit) -> Orbit:
    """The orbit in the units of the model."""
    field = orbit.field
    if field.natural and field.scales:
        return _converted(orbit, field.natural, field.scales)
    return orbit


def _converted(orbit: Orbit, field: Field, scales: MotionScales) -> Orbit:
    """The orbit multiplied by ``scales``; ``field`` is the field in the resulting units."""
    guess = orbit.guess
    states, period = guess.states * scales.states, guess.period * scales.time
    return replace(
        orbit,
        flow=replace(orbit.flow, field=field),
        guess=replace(guess, states=states, period=period),
        flow_results=tuple(map(scales.flow_result, orbit.flow_results)),
    )


#: Further equations: ``conditions(orbit)`` gives their residuals (r,) and Jacobian (r, unknowns).
Conditions: TypeAlias = Callable[[Orbit], tuple[FloatArray, FloatArray]]


def rate(field: Field, state: Sequence[float] | FloatArray, constants: Values) -> FloatArray:
    """Time derivative of a state, (m,); NaN where it is undefined, as at the anchor of a spring."""
    numbers = [float(value) for value in state]
    try:
        return field.rates(numbers, constants, field.initial_mode(numbers, constants))
    except ZeroDivisionError:
        return np.full(field.size, np.nan)


def integrated(flow: Flow, guess: Iterate) -> Orbit:
    """The orbit of an iterate: its mesh intervals are integrated, with derivatives.

    Raises ConvergenceError if a free parameter is out of its range, or the period not positive.
    """
    field, free = flow.field, guess.free
    try:
        for index in free:
            field.check(field.parameters[index], guess.values[index])
    except ParameterError as error:
        raise ConvergenceError(
            f"Newton's method leaves the parameters that there are: {error}"
        ) from error
    if not guess.period > 0:
        raise ConvergenceError("the period is not positive")
    constants = field.constants(guess.values)
    interval, directions = guess.interval, np.eye(len(field.parameters))[[*free]]
    return Orbit(
        flow,
        guess,
        constants,
        tuple(flow.flow_map(state, constants, interval, directions) for state in guess.states),
    )


def closed_orbit(
    flow: Flow,
    guess: Iterate | Orbit,
    *conditions: Conditions,
    reach: float = np.inf,
    options: ShootingOptions | None = None,
) -> Orbit:
    """The closed orbit near a guess, by Newton's method.

    ``conditions`` are the phase condition and one further condition per free parameter.
    ``reach`` is the largest distance of the states from those of the guess, and ``options`` replace
    those of the flow. Raises ConvergenceError if Newton's method does not converge within these
    limits.
    """
    options = options or flow.options
    orbit = integrated(flow, guess) if isinstance(guess, Iterate) else guess
    start, size, previous = orbit.guess, orbit.states.size, np.inf
    for iteration in range(options.steps):
        values, rows = zip(*(each(orbit) for each in conditions), strict=True)
        residual = np.concatenate([orbit.gaps.ravel(), *values])
        if magnitude(residual) <= rounding(orbit):
            # Orbits that are not isolated, as of a model without damping, have a nearly singular
            # Jacobian: another step would lead away.
            return orbit
        try:
            step = np.linalg.solve(orbit.slopes(*rows), -residual)
        except np.linalg.LinAlgError as error:
            raise ConvergenceError("Newton's method meets a singular matrix") from error
        width = magnitude(step)
        scale = 1 + max(magnitude(orbit.states), orbit.period)
        stagnates = width <= 1e-8 * scale and width > 0.2 * previous
        converged = width <= options.last_step * scale or stagnates
        # Rounding at the beginning of a mesh interval grows up to its end, by more than allowed if
        # the mesh could not be refined.
        tolerance = options.closed * max(1.0, growth(orbit) / options.growth)
        if converged and magnitude(residual) <= tolerance * (1 + magnitude(orbit.states)):
            return orbit
        if iteration and width > 1e3 * previous:
            break
        guess = orbit.guess.moved(step)
        if magnitude(guess.states - start.states) > reach or not np.isfinite(step[:size]).all():
            break
        if not 0.5 < guess.period / start.period < 2:
            break
        orbit, previous = integrated(flow, guess), width
    raise ConvergenceError("Newton's method finds no closed orbit there; start nearer to one")


def through(point: FloatArray, normal: FloatArray, guess: Iterate) -> Conditions:
    """Phase condition: the first state lies in the plane through ``point`` with this ``normal``.

    ``guess`` only gives the number of unknowns.
    """
    row = np.zeros((1, len(guess.coordinates)))
    row[0, : len(normal)] = normal
    return lambda orbit: (np.array([normal @ (orbit.state - point)]), row)


def across(orbit: Orbit, point: FloatArray | None = None) -> Conditions:
    """Phase condition: the plane normal to the flow at the first state of an orbit, through that
    state or through ``point``.
    """
    first = orbit.state
    normal = orbit.rate(first)
    point = first if point is None else point
    return through(point, normal / norm(normal), orbit.guess)


def phase(orbit: Orbit, guess: Iterate) -> Conditions:
    """Phase condition for a guess near an orbit: the leading coordinate has an extremum at the
    start if it has one in the guess; otherwise the plane of :func:`across`.
    """
    m, speed = orbit.field.size, len(orbit.field.coordinates) + orbit.field.lead
    if abs(guess.states[0, speed]) > 1e-8:  # no extremum
        return across(replace(orbit, guess=guess))
    return through(np.zeros(m), np.eye(m)[speed], guess)


def remeshed(orbit: Orbit, pieces: int, begin: float = 0.0) -> Iterate:
    """The orbit on ``pieces`` equal mesh intervals, the first of which starts at time ``begin``.

    Each state is integrated from the nearest old one before it: integrated from the first state
    alone, the error of a strongly unstable orbit would grow too large for Newton's method.
    """
    times = (begin + np.arange(pieces) * orbit.period / pieces) % orbit.period
    return replace(orbit.guess, states=np.array([orbit.at(t) for t in times.tolist()]))


def refined_mesh(orbit: Orbit, first: bool = False) -> Iterate | None:
    """The orbit on twice as many mesh intervals if deviations grow too much over one interval.

    None if they do not, or if the maximum number of intervals is reached; ``first`` selects the
    maximum for a first guess.
    """
    options, pieces = orbit.options, len(orbit.states)
    if growth(orbit) <= options.growth:
        return None
    most = min(options.intervals, options.first_intervals) if first else options.intervals
    return remeshed(orbit, 2 * pieces) if pieces < most else None


def off_jumps(orbit: Orbit) -> Orbit:
    """An orbit of which no mesh interval begins on a jump of the field.

    There the derivatives of the flow lack the saltation matrix: they do not take the rate at the
    beginning of an interval to that at its end. Such an orbit is integrated again, on a mesh that
    is shifted by 0.3 intervals.
    """
    rates = [orbit.rate(state) for state in orbit.states]
    ends = zip(orbit.flow_results, rates, [*rates[1:], rates[0]], strict=True)
    if not orbit.field.sticking_borders or all(
        norm(each.by_state @ first - last) < orbit.options.trivial * norm(last)
        for each, first, last in ends
    ):
        return orbit
    return integrated(orbit.flow, remeshed(orbit, len(orbit.states), 0.3 * orbit.guess.interval))


def offset_from_jumps(orbit: Orbit) -> float:
    """Shift of the mesh in time that moves its nodes farthest away from jumps of the field; 0 if no
    node is near one.

    Newton's method may move a node across a jump only by continuing on the wrong side of it.
    """
    interval, borders = orbit.guess.interval, orbit.field.borders
    times = sorted(
        crossing.t % interval for crossing in orbit.crossings() if borders[crossing.border].slopes
    )
    if not times:
        return 0.0
    width, begin = max((later - t, t) for t, later in pairwise([*times, times[0] + interval]))
    # A node is near a jump if it is closer than a tenth of the longest time without jumps.
    if min(times[0], interval - times[-1]) < 0.1 * width:
        return (begin + width / 2) % interval
    return 0.0


def subdivided(flow: Flow, guess: Iterate) -> Orbit:
    """The orbit of a guess, on a mesh that is refined until deviations grow little per interval."""
    orbit = integrated(flow, guess)
    while refined := refined_mesh(orbit, first=True):
        orbit = integrated(flow, refined)
    return orbit


def least_period(orbit: Orbit) -> Orbit:
    """The orbit over its least period.

    The orbit may be several rounds of a shorter one. Every prime number of rounds up to
    :func:`_most_rounds` is tried. The rounds are the same orbit if they differ by no more than the
    orbit's error: just after a period doubling two rounds differ by very little.
    """
    most = _most_rounds(orbit)
    for rounds in (k for k in range(2, most + 1) if all(k % j for j in range(2, k))):
        if any(turns % rounds for turns in orbit.windings.values()):
            continue
        if (shorter := _divided(orbit, rounds)) is not None:
            return least_period(shorter)
    return orbit


def _most_rounds(orbit: Orbit) -> int:
    """Upper bound of the number of rounds that an orbit may consist of.

    In each round a coordinate with turns makes at least one, and the leading coordinate has at
    least one maximum. Every other coordinate goes up and down by its range, no faster than its
    largest rates.
    """
    maxima = len(orbit.maxima()) if orbit.leads and not orbit.windings.get(orbit.field.lead) else 0
    bounds = [abs(turns) for turns in (*orbit.windings.values(), maxima) if turns]
    if 1 in bounds:
        return 1
    low, high = orbit.bounds
    n, options = len(orbit.field.coordinates), orbit.options
    for index in np.flatnonzero(~orbit.shifted).tolist():
        extent = float(high[index] - low[index])
        if extent > options.moves * orbit.errors[index] and not orbit.windings.get(index):
            up, down = high[n + index], -low[n + index]
            shortest = extent / up + extent / down
            bounds.append(int((1 + options.same_range) * orbit.period / shortest))
    return min(bounds, default=1)


def _divided(orbit: Orbit, rounds: int) -> Orbit | None:
    """The orbit over its period divided by ``rounds``; None if it does not close after that time.

    Near an equilibrium an orbit almost closes after any time. So the shorter orbit must have the
    same ranges of all components, too.
    """
    errors, ranges, options = orbit.errors[:-1], _ranges(orbit), orbit.options
    gap = np.abs(
        state_difference(orbit.at(orbit.period / rounds), orbit.state, orbit.field.periodic)
    )
    if not (gap <= np.maximum(options.same_state * ranges, 10 * errors)).all():
        return None
    tolerance = options.same_range * ranges + options.moves * errors
    with suppress(ConvergenceError):
        guess = Iterate(orbit.state[None], orbit.period / rounds, orbit.values)
        guess = subdivided(orbit.flow, guess).guess
        at_guess = phase(orbit, guess)
        try:
            shorter = closed_orbit(orbit.flow, guess, at_guess, reach=magnitude(tolerance))
        except ConvergenceError:
            # Without damping, orbits are not isolated and the Jacobian is singular.
            shorter = integrated(orbit.flow, guess)
        if (np.abs(_ranges(shorter) - ranges) <= tolerance).all():
            return shorter
    return None


def _ranges(orbit: Orbit) -> FloatArray:
    """Ranges of all components of the state, (m,); 2π for coordinates that make turns."""
    low, high = orbit.bounds
    ranges = high - low
    ranges[[index for index, turns in orbit.windings.items() if turns]] = TURN
    return ranges


def difference(orbit: Orbit) -> float:
    """Largest difference between the ends of mesh intervals integrated with and without
    derivatives, which have different steps: an estimate of the integration error.
    """
    ends = [
        orbit.flow.plain(state, orbit.constants, orbit.guess.interval).state
        for state in orbit.states
    ]
    return magnitude(orbit.ends - ends)


def errors_of(orbit: Orbit, differs: float = 0.0) -> FloatArray:
    """Error estimates of the first state and the period, (m + 1,).

    These are the row sums of |J⁻¹|, with the Jacobian J of shooting, times the largest of the gaps,
    rounding, and ``differs``, which may be :func:`difference`.
    """
    size = orbit.field.size
    _, rows = phase(orbit, orbit.guess)(orbit)
    inverse = np.linalg.pinv(orbit.slopes(rows), rcond=1e-12)
    sums: FloatArray = np.abs(inverse[np.r_[0:size, -1]]).sum(axis=1)
    return sums * max(orbit.largest_gap, rounding(orbit), differs)


def error_of(orbit: Orbit, differs: float = 0.0) -> float:
    """The largest of :func:`errors_of`."""
    return magnitude(errors_of(orbit, differs))


def extent(orbit: Orbit, units: FloatArray | float = 1.0) -> float:
    """Size of an orbit: the largest range of a component over extrema and mesh, in ``units``."""
    places = [*(extremum.state for extremum in orbit.extrema()), *orbit.states, *orbit.ends]
    states = orbit.field.periodic.unshifted(np.array(places))
    return float((np.ptp(states, axis=0) / units).max())


def rests(orbit: Orbit) -> bool:
    """True if a closed orbit in units of its motion is an equilibrium, which closes after any
    period, whatever the phase of a clock: its ranges are below 1e-9 or a hundred times its error.
    """
    low, high = orbit.bounds
    n = len(orbit.field.coordinates)
    moves = np.delete(high - low, n - 1) if orbit.field.clock else high - low
    return magnitude(moves) <= max(1e-9, 100.0 * error_of(orbit))


def growth(orbit: Orbit) -> float:
    """Largest derivative of the flow over one mesh interval."""
    return max(magnitude(each.by_state) for each in orbit.flow_results)


def rounding(orbit: Orbit) -> float:
    """Estimated rounding error of the gaps of an orbit: of the states, and of the period."""
    of_time = np.spacing(orbit.guess.interval) / 2 * magnitude([*map(orbit.rate, orbit.states)])
    return float(max(4e-16 * magnitude(orbit.states) * math.sqrt(orbit.period), of_time))
