"""Closed orbits by multiple shooting: Newton's method on the states between equal mesh intervals of
one round, and the period.
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
from ..models.field import Field, Mode, Values
from ..models.parameters import FloatArray
from ..numerics.vectors import TURN, apart, magnitude, norm
from .integrators import Flow
from .lobatto import PiecewisePolynomial
from .multipliers import Multipliers, multipliers_of
from .options import ShootingOptions
from .scales import MotionScales, scaled, scales_of
from .solution import Crossing, Extremum, FlowResult


@dataclass(frozen=True)
class Iterate:
    """An orbit that need not close yet: states (k, m) between its k equal mesh intervals, period,
    and values of the parameters.

    Newton's method moves the parameters that are ``free`` too.
    """

    states: FloatArray
    period: float
    values: Values
    free: tuple[int, ...] = ()

    @property
    def interval(self) -> float:
        """Time from one state to the next."""
        return self.period / len(self.states)

    def moved(self, step: FloatArray) -> Iterate:
        """After a step in states, period and the free parameters."""
        size = self.states.size
        values = list(self.values)
        for index, change in zip(self.free, step[size + 1 :], strict=True):
            values[index] += float(change)
        states = self.states + step[:size].reshape(self.states.shape)
        return Iterate(states, self.period + float(step[size]), tuple(values), self.free)

    def at(self, index: int, value: float) -> Iterate:
        """The guess at another value of one parameter."""
        return replace(self, values=(*self.values[:index], value, *self.values[index + 1 :]))

    @property
    def varied(self) -> list[float]:
        """Values of the free parameters."""
        return [self.values[i] for i in self.free]

    @property
    def coordinates(self) -> FloatArray:
        """Unknowns of Newton's method: states, period, free parameters."""
        return np.concatenate([self.states.ravel(), [self.period], self.varied])


@dataclass(frozen=True)
class Orbit:
    """An iterate with its mesh intervals integrated."""

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
        """Options of the orbit."""
        return self.flow.options

    @property
    def states(self) -> FloatArray:
        """States between the mesh intervals."""
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
        """The orbit with all parameters given, none free."""
        return replace(self, guess=replace(self.guess, free=()))

    @cached_property
    def ends(self) -> FloatArray:
        """Ends of the mesh intervals, shape (k, m)."""
        return np.array([each.state for each in self.flow_results])

    @cached_property
    def gaps(self) -> FloatArray:
        """Ends of the mesh intervals less the beginnings of the next: what comes around closes
        after whole turns.
        """
        return apart(self.ends, np.roll(self.states, -1, axis=0), self.field.periodic)

    @property
    def largest_gap(self) -> float:
        """Largest gap."""
        return magnitude(self.gaps)

    @cached_property
    def windings(self) -> dict[int, int]:
        """Turns in one round, by the places of coordinates that come around."""
        moved = (self.ends - self.states).sum(axis=0) / TURN
        return {index: round(float(moved[index])) for index in self.field.periodic}

    @property
    def winding(self) -> int:
        """Turns that the first coordinate makes in one round."""
        return self.windings.get(0, 0)

    @cached_property
    def bounds(self) -> tuple[FloatArray, FloatArray]:
        """Least and largest of every number of the state over one round, each of shape (m,)."""
        states = np.hstack(
            [
                self.flow.samples(each, self.constants, self.guess.interval).states
                for each in self.states
            ]
        )
        return states.min(axis=1), states.max(axis=1)

    @cached_property
    def errors(self) -> FloatArray:
        """Errors of the numbers of the state at its start, and of the period, (m + 1,)."""
        return errors_of(self)

    @cached_property
    def leads(self) -> bool:
        """Whether the leading coordinate moves, by more than its error."""
        lead = self.field.lead
        values = [extremum.state[lead] for extremum in self.extrema() if extremum.border == -1]
        extent = np.ptp([*values, *self.states[:, lead]])
        return bool(self.windings.get(lead, 0) or extent > self.options.moves * self.errors[lead])

    @cached_property
    def lead(self) -> int:
        """Place of the first coordinate that moves, by more than its error."""
        if self.field.lead == 0 and self.leads:
            return 0
        low, high = self.bounds
        return int((high - low > self.options.moves * self.errors[:-1]).argmax())

    def with_lead(self) -> Orbit:
        """The orbit with extrema of the first coordinate that moves."""
        lead = self.lead
        if lead == self.field.lead:
            return self
        return integrated(replace(self.flow, field=self.field.with_lead(lead)), self.guess)

    def at(self, t: float) -> FloatArray:
        """The state at a time of the round, from the nearest state before it."""
        interval = self.guess.interval
        which = min(int(t / interval), len(self.states) - 1)
        start, left = self.states[which], t - which * interval
        if not left > 1e-14 * interval:
            return start
        return self.flow.flow_map(start, self.constants, left).state

    @cached_property
    def monodromy(self) -> FloatArray:
        """Derivative of one round by its start."""
        product = np.eye(self.field.size)
        for each in self.flow_results:
            product = each.by_state @ product
        return product

    @property
    def sticks(self) -> bool:
        """Whether it stays on a border on its way: deviations across that end there."""
        borders = self.field.borders
        return bool(self.field.stays(self.mode(self.state))) or any(
            borders[crossing.border].stays and not crossing.sign for crossing in self.crossings()
        )

    @cached_property
    def multipliers(self) -> Multipliers:
        """Floquet multipliers of the orbit: where it sticks, the smallest one is 0, whatever
        rounding leaves.
        """
        m = self.field.deviations
        flows = [self.rate(state)[:m] for state in self.states]
        found = multipliers_of([each.by_state[:m, :m] for each in self.flow_results], flows)
        lasting = np.arange(len(found.others)) < len(found.others) - self.sticks
        return replace(
            found,
            others=np.where(lasting, found.others, 0.0),
            errors=np.where(lasting, found.errors, 0.0),
        )

    def slopes(self, *rows: FloatArray) -> FloatArray:
        """Derivatives of the gaps by states, period and free parameters, (k m, k m + 1 +
        parameters), above further rows.
        """
        (k, m), parameters = self.states.shape, len(self.guess.free)
        matrix = np.zeros((k * m, k * m + 1 + parameters))
        for i, each in enumerate(self.flow_results):
            own, after = slice(i * m, (i + 1) * m), (i + 1) % k
            matrix[own, i * m : (i + 1) * m] += each.by_state
            matrix[own, after * m : (after + 1) * m] -= np.eye(m)
            matrix[own, k * m] = self.rate(each.state) / k
            matrix[own, k * m + 1 :] = each.by_parameters[:, :parameters]
        return np.vstack([matrix, *rows])

    def crossings(self) -> tuple[Crossing, ...]:
        """All crossings of one round, in time from its start."""
        return tuple(
            c._replace(t=c.t + i * self.guess.interval)
            for i, each in enumerate(self.flow_results)
            for c in each.crossings
        )

    def maxima(self) -> list[Extremum]:
        """Turns at which the leading coordinate is largest, the start first: where it is one it may
        be counted at neither end.
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
        """The turn at which the leading coordinate is largest; of several that are alike but for
        rounding the one at which the next number of the state is.
        """
        # Numbers that differ by less are alike.
        found, near = self.maxima(), 1e-6 * extent(self)
        for index in (self.field.lead, self.field.lead + 1):
            most = max((turn.state[index] for turn in found), default=0.0)
            found = [turn for turn in found if turn.state[index] >= most - near]
        return next(iter(found), None)

    def extrema(self) -> tuple[Extremum, ...]:
        """All turns of one round, with derivatives by the start of the round."""
        interval, found, before = self.guess.interval, [], np.eye(self.field.size)
        shift = np.zeros_like(self.flow_results[0].by_parameters)
        for i, each in enumerate(self.flow_results):
            found += [
                extremum._replace(
                    t=extremum.t + i * interval,
                    by_state=extremum.by_state @ before,
                    by_parameters=extremum.by_parameters + extremum.by_state @ shift,
                )
                for extremum in each.extrema
            ]
            before, shift = each.by_state @ before, each.by_parameters + each.by_state @ shift
        return tuple(found)

    def samples(self) -> PiecewisePolynomial:
        """One round by the polynomials through its samples."""
        return self.flow.samples(self.state, self.constants, self.period)

    def moments(self) -> tuple[float, float]:
        """Mean and root mean square of the first coordinate; NaN where it turns around."""
        if self.winding:
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
    """An orbit in units of its motion, in which shooting has its tolerances; itself where these
    are 1.
    """
    field, constants = orbit.field, orbit.constants
    if field.scales:
        return orbit
    scales = scales_of(field, constants, orbit.state.tolist())
    if scales.trivial:
        return orbit
    return _converted(orbit, scaled(field, scales), scales.inverse)


def natural(orbit: Orbit) -> Orbit:
    """An orbit in the units of the model."""
    field = orbit.field
    return (
        _converted(orbit, field.natural, field.scales) if field.natural and field.scales else orbit
    )


def _converted(orbit: Orbit, field: Field, scales: MotionScales) -> Orbit:
    guess = orbit.guess
    states, period = guess.states * scales.states, guess.period * scales.time
    return replace(
        orbit,
        flow=replace(orbit.flow, field=field),
        guess=replace(guess, states=states, period=period),
        flow_results=tuple(map(scales.flow_result, orbit.flow_results)),
    )


#: Further equations: ``conditions(orbit)`` gives their values (r,) and slopes (r, unknowns).
Conditions: TypeAlias = Callable[[Orbit], tuple[FloatArray, FloatArray]]


def rate(field: Field, state: Sequence[float] | FloatArray, constants: Values) -> FloatArray:
    """The derivative of a state in time; not a number where there is none, as at the anchor of a
    spring.
    """
    numbers = [float(value) for value in state]
    try:
        return field.rates(numbers, constants, field.initial_mode(numbers, constants))
    except ZeroDivisionError:
        return np.full(field.size, np.nan)


def integrated(flow: Flow, guess: Iterate) -> Orbit:
    """A guess integrated."""
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
    """The closed orbit near a guess, which may be integrated already, under further conditions, as
    many as there are free parameters and one.

    ``reach`` bounds how far the states may move from the guess; ``options`` are those of the flow
    where none are given. Raises ConvergenceError where there is none.
    """
    options = options or flow.options
    orbit = integrated(flow, guess) if isinstance(guess, Iterate) else guess
    start, size, before = orbit.guess, orbit.states.size, np.inf
    for iteration in range(options.steps):
        values, rows = zip(*(each(orbit) for each in conditions), strict=True)
        residual = np.concatenate([orbit.gaps.ravel(), *values])
        if magnitude(residual) <= rounding(orbit):
            # of orbits that are not isolated, as where nothing damps, a step leads anywhere
            return orbit
        try:
            step = np.linalg.solve(orbit.slopes(*rows), -residual)
        except np.linalg.LinAlgError as error:
            raise ConvergenceError("Newton's method meets a singular matrix") from error
        width = magnitude(step)
        scale = 1 + max(magnitude(orbit.states), orbit.period)
        small = width <= options.last_step * scale or (
            width <= 1e-8 * scale and width > 0.2 * before
        )
        # An interval that could be subdivided no further carries what rounds at its beginning to
        # its end, as many times larger.
        carried = options.closed * max(1.0, growth(orbit) / options.growth)
        if small and magnitude(residual) <= carried * (1 + magnitude(orbit.states)):
            return orbit
        if iteration and width > 1e3 * before:
            break
        guess = orbit.guess.moved(step)
        if magnitude(guess.states - start.states) > reach or not np.isfinite(step[:size]).all():
            break
        if not 0.5 < guess.period / start.period < 2:
            break
        orbit, before = integrated(flow, guess), width
    raise ConvergenceError("Newton's method finds no closed orbit there; start nearer to one")


def through(point: FloatArray, normal: FloatArray, guess: Iterate) -> Conditions:
    """Phase condition of orbits of as many mesh intervals as a guess: the first state stays in a
    plane through a place.
    """
    row = np.zeros((1, len(guess.coordinates)))
    row[0, : len(normal)] = normal
    return lambda orbit: (np.array([normal @ (orbit.state - point)]), row)


def across(orbit: Orbit, point: FloatArray | None = None) -> Conditions:
    """The plane across the flow at the first state of an orbit, through that or another place."""
    first = orbit.state
    normal = orbit.rate(first)
    point = first if point is None else point
    return through(point, normal / norm(normal), orbit.guess)


def phase(orbit: Orbit, guess: Iterate) -> Conditions:
    """The phase of a guess at an orbit: where the leading coordinate is largest, if it begins
    there, or as it is.
    """
    m, speed = orbit.field.size, len(orbit.field.coordinates) + orbit.field.lead
    # Where the leading coordinate changes faster, it is not largest.
    if abs(guess.states[0, speed]) > 1e-8:
        return across(replace(orbit, guess=guess))
    return through(np.zeros(m), np.eye(m)[speed], guess)


def remeshed(orbit: Orbit, pieces: int, begin: float = 0.0) -> Iterate:
    """An orbit in ``pieces`` equal mesh intervals from the time ``begin`` on: each state from the
    nearest one before it.

    Carried once around from one state, the error of a strongly unstable orbit would grow beyond
    Newton's reach.
    """
    times = (begin + np.arange(pieces) * orbit.period / pieces) % orbit.period
    return replace(orbit.guess, states=np.array([orbit.at(t) for t in times.tolist()]))


def refined_mesh(orbit: Orbit, first: bool = False) -> Iterate | None:
    """The orbit in twice as many mesh intervals where the derivatives over one have grown large;
    None elsewhere, and where it has as many as it may, or a ``first`` guess.
    """
    options, pieces = orbit.options, len(orbit.states)
    if growth(orbit) <= options.growth:
        return None
    most = min(options.intervals, options.first_intervals) if first else options.intervals
    return remeshed(orbit, 2 * pieces) if pieces < most else None


def off_jumps(orbit: Orbit) -> Orbit:
    """The orbit, or where it begins as it passes a jump of the field, which derivatives then lack,
    from a little later on.
    """
    flows = [orbit.rate(state) for state in orbit.states]
    ends = zip(orbit.flow_results, flows, [*flows[1:], flows[0]], strict=True)
    if not orbit.field.sticking_borders or all(
        norm(each.by_state @ one - due) < orbit.options.trivial * norm(due)
        for each, one, due in ends
    ):
        return orbit
    # How far from a jump of the field it is looked how far from all of them an orbit may
    # begin, in mesh intervals.
    return integrated(orbit.flow, remeshed(orbit, len(orbit.states), 0.3 * orbit.guess.interval))


def offset_from_jumps(orbit: Orbit) -> float:
    """Time by which a mesh is shifted so that its intervals begin farthest from jumps of the field;
    0 where none begins near one.

    A state on the wrong side of a jump goes another way: Newton's method does not take the states
    of mesh intervals across.
    """
    interval, borders = orbit.guess.interval, orbit.field.borders
    times = sorted(
        crossing.t % interval for crossing in orbit.crossings() if borders[crossing.border].slopes
    )
    if not times:
        return 0.0
    width, begin = max((later - t, t) for t, later in pairwise([*times, times[0] + interval]))
    # Mesh intervals begin no nearer to a jump of the field than this share of the longest
    # time between jumps, each in its interval.
    return (
        (begin + width / 2) % interval if min(times[0], interval - times[-1]) < 0.1 * width else 0.0
    )


def subdivided(flow: Flow, guess: Iterate) -> Orbit:
    """A guess integrated, in as many mesh intervals as its growth asks for."""
    orbit = integrated(flow, guess)
    while cut := refined_mesh(orbit, first=True):
        orbit = integrated(flow, cut)
    return orbit


def least_period(orbit: Orbit) -> Orbit:
    """The orbit over its least period: rounds are one if they differ by no more than the orbit's
    error.

    Close to where it came out of a doubling, the rounds of an orbit of twice the period differ by
    very little. Every prime number of rounds is tried that there may be, by :func:`_most_rounds`.
    """
    most = _most_rounds(orbit)
    for rounds in (k for k in range(2, most + 1) if all(k % j for j in range(2, k))):
        if any(turns % rounds for turns in orbit.windings.values()):
            continue
        if (shorter := _divided(orbit, rounds)) is not None:
            return least_period(shorter)
    return orbit


def _most_rounds(orbit: Orbit) -> int:
    """Most rounds that an orbit may consist of.

    A coordinate that turns around makes a whole turn in each, and the leading one is largest once
    at least, unless a border hides that. Every one goes up and down by its range, no faster than
    it does anywhere.
    """
    maxima = len(orbit.maxima()) if orbit.leads and not orbit.windings.get(orbit.field.lead) else 0
    most = [abs(turns) for turns in (*orbit.windings.values(), maxima) if turns]
    if 1 in most:
        return 1
    low, high = orbit.bounds
    n, options = len(orbit.field.coordinates), orbit.options
    for index in range(n):
        extent = float(high[index] - low[index])
        if extent > options.moves * orbit.errors[index] and not orbit.windings.get(index):
            up, down = high[n + index], -low[n + index]
            most.append(
                int((1 + options.same_range) * orbit.period / (extent / up + extent / down))
            )
    return min(most, default=1)


def _divided(orbit: Orbit, rounds: int) -> Orbit | None:
    """The orbit over a part of its period, if it closes after that; None where it does not.

    Every number of the state has its own range and error. Beside a state at which an orbit all but
    rests any time closes it: the shorter one has the same ranges, or is another.
    """
    errors, ranges, options = orbit.errors[:-1], _ranges(orbit), orbit.options
    off = np.abs(apart(orbit.at(orbit.period / rounds), orbit.state, orbit.field.periodic))
    if not (off <= np.maximum(options.same_state * ranges, 10 * errors)).all():
        return None
    near = options.same_range * ranges + options.moves * errors
    with suppress(ConvergenceError):
        guess = Iterate(orbit.state[None], orbit.period / rounds, orbit.values)
        guess = subdivided(orbit.flow, guess).guess
        try:
            shorter = closed_orbit(orbit.flow, guess, phase(orbit, guess), reach=magnitude(near))
        except ConvergenceError:
            # where nothing damps orbits are not isolated, and Newton's matrix is singular
            shorter = integrated(orbit.flow, guess)
        if (np.abs(_ranges(shorter) - ranges) <= near).all():
            return shorter
    return None


def _ranges(orbit: Orbit) -> FloatArray:
    """Ranges of all numbers of the state, a turn of those that turn around."""
    low, high = orbit.bounds
    ranges = high - low
    ranges[[index for index, turns in orbit.windings.items() if turns]] = TURN
    return ranges


def difference(orbit: Orbit) -> float:
    """The largest distance between ends of mesh intervals with and without derivatives: what the
    step control of either missed.
    """
    ends = [
        orbit.flow.plain(state, orbit.constants, orbit.guess.interval).state
        for state in orbit.states
    ]
    return magnitude(orbit.ends - ends)


def errors_of(orbit: Orbit, differs: float = 0.0) -> FloatArray:
    """Errors of the first state's numbers and of the period: row sums of the inverse of Newton's
    matrix, times what does not close, rounding, or ``differs``.
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
    """Range of the turns of an orbit: the largest of all components, in their units."""
    states = [*(extremum.state for extremum in orbit.extrema()), *orbit.states, *orbit.ends]
    return float((np.ptp(states, axis=0) / units).max())


def growth(orbit: Orbit) -> float:
    """Largest derivative over one mesh interval."""
    return max(magnitude(each.by_state) for each in orbit.flow_results)


def rounding(orbit: Orbit) -> float:
    """Size of what rounding adds to the gaps of an orbit."""
    return 4e-16 * magnitude(orbit.states) * math.sqrt(orbit.period)
