"""Closed orbits by multiple shooting: Newton's method on the states between equal stretches of one
round, and the period.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np

from ..core.errors import ConvergenceError, ParameterError
from ..models.field import FLOATS, Field, Mode, Values
from ..models.parameters import FloatArray
from ..numerics.vectors import TURN, apart, magnitude, norm
from .integrators import Flow
from .lobatto import PiecewisePolynomial
from .multipliers import Multipliers, multipliers_of
from .scales import Scales, scaled, scales_of
from .solution import Crossing, Passage, Turn

#: Closed to this, relative to the largest number of the orbit.
CLOSED = 1e-12

#: A stretch whose derivatives grow beyond this is cut in two.
LARGEST_GROWTH = 100.0

#: Stretches in one round, at most; and of a guess.
MOST_STRETCHES, SPLIT = 64, 32

#: Stretches begin no nearer to a jump of the field than this share of the longest time between
#: jumps, each in its stretch.
CLEAR = 0.1

#: Where the first coordinate changes faster, it is not largest.
MOVES = 1e-8

#: States this close are one, whatever their errors.
ONE = 1e-10


@dataclass(frozen=True)
class Guess:
    """A loop that need not close: states (k, m) between its k equal stretches, period, and values
    of the parameters.

    Newton's method moves the parameters that are ``free`` too.
    """

    states: FloatArray
    period: float
    values: Values
    free: tuple[int, ...] = ()

    @property
    def stretch(self) -> float:
        """Time from one state to the next."""
        return self.period / len(self.states)

    def moved(self, step: FloatArray) -> Guess:
        """After a step in states, period and the free parameters."""
        size = self.states.size
        values = list(self.values)
        for index, change in zip(self.free, step[size + 1 :], strict=True):
            values[index] += float(change)
        states = self.states + step[:size].reshape(self.states.shape)
        return Guess(states, self.period + float(step[size]), tuple(values), self.free)

    def at(self, index: int, value: float) -> Guess:
        """The guess at another value of one parameter."""
        return replace(self, values=(*self.values[:index], value, *self.values[index + 1 :]))

    @property
    def varied(self) -> list[float]:
        """Values of the free parameters."""
        return [self.values[i] for i in self.free]

    @property
    def coordinates(self) -> FloatArray:
        """What Newton's method moves: states, period, free parameters."""
        return np.concatenate([self.states.ravel(), [self.period], self.varied])


@dataclass(frozen=True)
class Loop:
    """A guess with its stretches integrated."""

    flow: Flow
    guess: Guess
    constants: Values
    passages: tuple[Passage, ...]

    @property
    def field(self) -> Field:
        """The field."""
        return self.flow.field

    @property
    def states(self) -> FloatArray:
        """States between the stretches."""
        return self.guess.states

    @property
    def state(self) -> FloatArray:
        """Where it begins."""
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

    def bound(self) -> Loop:
        """The loop with all parameters given, none free."""
        return replace(self, guess=replace(self.guess, free=()))

    @cached_property
    def ends(self) -> FloatArray:
        """Ends of the stretches, shape (k, m)."""
        return np.array([each.state for each in self.passages])

    @cached_property
    def gaps(self) -> FloatArray:
        """Ends of the stretches less the beginnings of the next: what comes around closes after
        whole turns.
        """
        return apart(self.ends, np.roll(self.states, -1, axis=0), self.field.around)

    @property
    def missed(self) -> float:
        """Largest gap."""
        return magnitude(self.gaps)

    @cached_property
    def winding(self) -> int:
        """Turns that the first coordinate makes in one round."""
        moved = float((self.ends - self.states)[:, 0].sum())
        return round(moved / TURN) if 0 in self.field.around else 0

    @cached_property
    def monodromy(self) -> FloatArray:
        """Derivative of one round by its start."""
        product = np.eye(self.field.size)
        for each in self.passages:
            product = each.by_state @ product
        return product

    @cached_property
    def multipliers(self) -> Multipliers:
        """Its Floquet multipliers."""
        flows = [self.rate(state) for state in self.states]
        return multipliers_of([each.by_state for each in self.passages], flows)

    def slopes(self, *rows: FloatArray) -> FloatArray:
        """Derivatives of the gaps by states, period and free parameters, (k m, k m + 1 +
        parameters), above further rows.
        """
        (k, m), parameters = self.states.shape, len(self.guess.free)
        matrix = np.zeros((k * m, k * m + 1 + parameters))
        for i, each in enumerate(self.passages):
            own, after = slice(i * m, (i + 1) * m), (i + 1) % k
            matrix[own, i * m : (i + 1) * m] += each.by_state
            matrix[own, after * m : (after + 1) * m] -= np.eye(m)
            matrix[own, k * m] = self.rate(each.state) / k
            matrix[own, k * m + 1 :] = each.by_parameters[:, :parameters]
        return np.vstack([matrix, *rows])

    def crossings(self) -> tuple[Crossing, ...]:
        """All crossings of one round, in time from its start."""
        return tuple(
            c._replace(t=c.t + i * self.guess.stretch)
            for i, each in enumerate(self.passages)
            for c in each.crossings
        )

    def tops(self) -> list[Turn]:
        """Turns at which the first coordinate is largest, the start first: where it is one it may
        be counted at neither end.
        """
        found = [turn for turn in self.turns() if turn.border == -1 and turn.direction < 0]
        start, n = self.state, len(self.field.coordinates)
        if found and abs(start[n]) < ONE and self.rate(start)[n] < 0:
            found.insert(0, found[0]._replace(t=0.0, state=start))
        return found

    def turns(self) -> tuple[Turn, ...]:
        """All turns of one round, with derivatives by the start of the round."""
        stretch, found, before = self.guess.stretch, [], np.eye(self.field.size)
        shift = np.zeros_like(self.passages[0].by_parameters)
        for i, each in enumerate(self.passages):
            found += [
                turn._replace(
                    t=turn.t + i * stretch,
                    by_state=turn.by_state @ before,
                    by_parameters=turn.by_parameters + turn.by_state @ shift,
                )
                for turn in each.turns
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
            math.fsum(each.integrals[i] for each in self.passages) / self.period for i in (0, 1)
        )
        if math.isnan(mean):
            samples = self.samples()
            x, weights = samples.states[0], samples.weights() / self.period
            mean, square = float((weights * x).sum()), float((weights * x**2).sum())
        return mean, math.sqrt(square)


def in_scales(loop: Loop) -> Loop:
    """A loop in units of its motion, in which shooting has its tolerances; itself where these
    are 1.
    """
    field, constants = loop.field, loop.constants
    if field.scales:
        return loop
    scales = scales_of(field, constants, loop.state.tolist())
    if scales.trivial:
        return loop
    return _converted(loop, scaled(field, scales), scales.inverse)


def natural(loop: Loop) -> Loop:
    """A loop in the units of the model."""
    field = loop.field
    return _converted(loop, field.natural, field.scales) if field.natural and field.scales else loop


def time_of(loop: Loop) -> float:
    """The unit of a loop's times, in that of the model."""
    return loop.field.scales.time if loop.field.scales else 1.0


def _converted(loop: Loop, field: Field, scales: Scales) -> Loop:
    guess = loop.guess
    states, period = guess.states * scales.states, guess.period * scales.time
    return replace(
        loop,
        flow=replace(loop.flow, field=field),
        guess=replace(guess, states=states, period=period),
        passages=tuple(map(scales.passage, loop.passages)),
    )


#: Further equations: ``conditions(loop)`` gives their values (r,) and slopes (r, unknowns).
Conditions: TypeAlias = Callable[[Loop], tuple[FloatArray, FloatArray]]


def rate(field: Field, state: Any, constants: Values) -> FloatArray:
    """The derivative of a state in time; not a number where there is none, as at the anchor of a
    spring.
    """
    mode = field.initial_mode(state, constants)
    n = len(field.coordinates)
    numbers = [float(value) for value in state]
    try:
        return np.array([*numbers[n:], *field.acceleration(numbers, constants, mode, FLOATS)])
    except ZeroDivisionError:
        return np.full(field.size, np.nan)


def looped(flow: Flow, guess: Guess) -> Loop:
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
    stretch, directions = guess.stretch, np.eye(len(field.parameters))[[*free]]
    return Loop(
        flow,
        guess,
        constants,
        tuple(flow.fly(state, constants, stretch, directions) for state in guess.states),
    )


def solved(
    flow: Flow,
    guess: Guess,
    *conditions: Conditions,
    reach: float = np.inf,
    iterations: int = 12,
    precision: float = 1e-13,
    closed: float = CLOSED,
) -> Loop:
    """The closed loop near a guess under further conditions, as many as there are free parameters
    and one.

    ``reach`` bounds how far the states may move from the guess; steps below ``precision``, or as
    small as rounding, end it; ``closed`` is by how much the loop may stay open. Raises
    ConvergenceError where there is none.
    """
    start, size, before = guess, guess.states.size, np.inf
    loop = looped(flow, guess)
    for iteration in range(iterations):
        values, rows = zip(*(each(loop) for each in conditions), strict=True)
        residual = np.concatenate([loop.gaps.ravel(), *values])
        if magnitude(residual) <= rounding(loop):
            # of orbits that are not isolated, as where nothing damps, a step leads anywhere
            return loop
        try:
            step = np.linalg.solve(loop.slopes(*rows), -residual)
        except np.linalg.LinAlgError as error:
            raise ConvergenceError("Newton's method meets a singular matrix") from error
        width = magnitude(step)
        scale = 1 + max(magnitude(loop.states), loop.period)
        small = width <= precision * scale or (width <= 1e-8 * scale and width > 0.2 * before)
        # A stretch that could be cut no shorter carries what rounds at its beginning to its end, as
        # many times larger.
        carried = closed * max(1.0, growth(loop) / LARGEST_GROWTH)
        if small and magnitude(residual) <= carried * (1 + magnitude(loop.states)):
            return loop
        if iteration and width > 1e3 * before:
            break
        guess = loop.guess.moved(step)
        if magnitude(guess.states - start.states) > reach or not np.isfinite(step[:size]).all():
            break
        if not 0.5 < guess.period / start.period < 2:
            break
        loop, before = looped(flow, guess), width
    raise ConvergenceError("Newton's method finds no closed orbit there; start nearer to one")


def through(place: FloatArray, normal: FloatArray, guess: Guess) -> Conditions:
    """Phase condition of loops of as many stretches as a guess: the first state stays in a plane
    through a place.
    """
    row = np.zeros((1, len(guess.coordinates)))
    row[0, : len(normal)] = normal
    return lambda loop: (np.array([normal @ (loop.state - place)]), row)


def across(loop: Loop, place: FloatArray | None = None) -> Conditions:
    """The plane across the flow at the first state of a loop, through that or another place."""
    first = loop.state
    normal = loop.rate(first)
    place = first if place is None else place
    return through(place, normal / norm(normal), loop.guess)


def phase(loop: Loop, guess: Guess) -> Conditions:
    """The phase of a guess at an orbit: where the first coordinate is largest, if it begins there,
    or as it is.
    """
    m = loop.field.size
    if abs(guess.states[0, m // 2]) > MOVES:
        return across(replace(loop, guess=guess))
    return through(np.zeros(m), np.eye(m)[m // 2], guess)


def recut(loop: Loop, pieces: int, begin: float = 0.0) -> Guess:
    """A loop in ``pieces`` equal stretches from the time ``begin`` on: each state from the nearest
    one before it.

    Carried once around from one state, the error of a strongly unstable orbit would grow beyond
    Newton's reach.
    """
    guess, stretch, states = loop.guess, loop.guess.stretch, []
    for i in range(pieces):
        t = (begin + i * guess.period / pieces) % guess.period
        which = min(int(t / stretch), len(guess.states) - 1)
        left = t - which * stretch
        start = guess.states[which]
        states.append(
            loop.flow.fly(start, loop.constants, left).state if left > 1e-14 * stretch else start
        )
    return replace(guess, states=np.array(states))


def finer(loop: Loop, most: int = MOST_STRETCHES) -> Guess | None:
    """The loop in twice as many stretches where the derivatives over one have grown large; None
    elsewhere, and of ``most``.
    """
    pieces = len(loop.states)
    return recut(loop, 2 * pieces) if growth(loop) > LARGEST_GROWTH and pieces < most else None


def clear(loop: Loop) -> float:
    """How long after its states stretches begin that do so farthest from jumps of the field; 0
    where none begins near one.

    A state on the wrong side of a jump goes another way: Newton's method does not take the states
    of stretches across.
    """
    stretch, borders = loop.guess.stretch, loop.field.borders
    times = sorted(
        crossing.t % stretch for crossing in loop.crossings() if borders[crossing.border].slopes
    )
    if not times:
        return 0.0
    width, begin = max((later - t, t) for t, later in pairwise([*times, times[0] + stretch]))
    return (
        (begin + width / 2) % stretch if min(times[0], stretch - times[-1]) < CLEAR * width else 0.0
    )


def split(flow: Flow, guess: Guess) -> Loop:
    """A guess integrated, in as many stretches as its growth asks for."""
    loop = looped(flow, guess)
    while cut := finer(loop, SPLIT):
        loop = looped(flow, cut)
    return loop


def once_round(loop: Loop) -> Loop:
    """The orbit over its least period: rounds are one if they differ by no more than the orbit's
    error.

    Close to where it came out of a doubling, the rounds of an orbit of twice the period differ by
    very little. They are told by where the first coordinate is largest, or by borders where it
    rests while it is.
    """
    period, tops, n = loop.period, loop.tops(), len(loop.field.coordinates)
    marks = [top for top in tops if loop.rate(top.state)[n] < 0] or loop.crossings()
    if not (tops and marks):
        return loop
    scale = np.ptp([turn.state for turn in loop.turns()], axis=0) + 1e-3
    first, *others = marks
    for other in others:
        if (other.t - first.t) * len(marks) < period / 2:
            # rounds have a mark each at least: this is the same one, at the end of a stretch and
            # where the next begins
            continue
        share = period / (other.t - first.t)
        off = np.abs(apart(other.state, first.state, loop.field.around))
        alike = (off / scale).max() < 1e-5 and abs(share - round(share)) < 1e-4 and round(share) > 1
        if alike and off.max() <= max(ONE, 10 * error_of(loop)):
            guess = Guess(first.state[None], period / round(share), loop.values)
            with suppress(ConvergenceError):
                return solved(loop.flow, guess, phase(loop, guess), reach=1e-3)
            with suppress(
                ConvergenceError
            ):  # where nothing damps orbits are not isolated, and Newton's matrix is singular
                shorter = looped(loop.flow, guess)
                if shorter.missed <= CLOSED * (1 + magnitude(loop.states)):
                    return shorter
    return loop


def difference(loop: Loop) -> float:
    """The largest distance between ends of stretches with and without derivatives: what the step
    control of either missed.
    """
    ends = [
        loop.flow.plain(state, loop.constants, loop.guess.stretch).state for state in loop.states
    ]
    return magnitude(loop.ends - ends)


def error_of(loop: Loop, differs: float = 0.0) -> float:
    """Largest row sum of the inverse of Newton's matrix, times what does not close, rounding, or
    ``differs``.
    """
    size = loop.field.size
    _, rows = phase(loop, loop.guess)(loop)
    inverse = np.linalg.pinv(loop.slopes(rows), rcond=1e-12)
    wanted = np.r_[0:size, -1]
    return float(
        np.abs(inverse[wanted]).sum(axis=1).max() * max(loop.missed, rounding(loop), differs)
    )


def extent(loop: Loop) -> float:
    """How far apart the turns of an orbit are: the largest of all components."""
    states = [*(turn.state for turn in loop.turns()), *loop.states, *loop.ends]
    return float(np.ptp(states, axis=0).max())


def growth(loop: Loop) -> float:
    """Largest derivative over one stretch."""
    return max(magnitude(each.by_state) for each in loop.passages)


def rounding(loop: Loop) -> float:
    """What rounding adds to the gaps of a loop, about."""
    return 4e-16 * magnitude(loop.states) * math.sqrt(loop.period)
