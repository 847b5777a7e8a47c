"""Scales of a motion, and the motion in units of them.

An integrator's absolute tolerances, how far beyond a border a mode is left, and which speed is no
speed, are numbers beside 1. They hold for a motion whose numbers are of order 1: so every motion is
carried in units of its own. These are powers of four, which scale without rounding; 1 is kept for
numbers between 1/32 and 32, so that motions of a common size are carried as they are.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from itertools import chain, repeat
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..models.field import FLOATS, Border, Field, Mode, Values, Vector
from ..models.parameters import FloatArray
from ..numerics.arithmetic import Number
from ..numerics.vectors import TURN
from .lobatto import PiecewisePolynomial

if TYPE_CHECKING:
    from .measures import MotionStatistics
    from .problem import Problem
    from .regimes import Outcome
    from .solution import Crossing, Extremum, FlowResult, Solution


@dataclass(frozen=True)
class MotionScales:
    """Units of a motion: of each coordinate, of time, of the level of each border, and of each
    square root that its accelerations take, as of a spring's length, in their order.

    Times, states and what is made of them are given back in the model's units by what is called
    as they are, as ``scales.solution(scaled)``; :attr:`inverse` takes them the other way.
    """

    places: tuple[float, ...]
    time: float
    levels: tuple[float, ...]
    roots: tuple[float, ...] = ()

    @property
    def trivial(self) -> bool:
        """All units are 1."""
        return {self.time, *self.places, *self.levels, *self.roots} == {1.0}

    @cached_property
    def states(self) -> FloatArray:
        """Units of coordinates and rates, (2 n,)."""
        places = np.array(self.places)
        return np.concatenate([places, places / self.time])

    @property
    def length(self) -> float:
        """The largest unit of a coordinate."""
        return max(self.places)

    @property
    def inverse(self) -> MotionScales:
        """Units that take numbers of the model to those of the scaled motion."""
        return MotionScales(
            tuple(1.0 / unit for unit in self.places),
            1.0 / self.time,
            tuple(1.0 / unit for unit in self.levels),
            tuple(1.0 / unit for unit in self.roots),
        )

    def problem(self, problem: Problem) -> Problem:
        """A problem in these units."""
        start = np.array(problem.start, dtype=float) / self.states
        return replace(
            problem,
            start=tuple(start.tolist()),
            t_end=problem.t_end / self.time,
            t_record=problem.t_record / self.time,
            field_of=lambda reach: scaled(problem.field_of(reach), self),
            scales=self,
        )

    def samples(self, samples: PiecewisePolynomial) -> PiecewisePolynomial:
        """A motion by its samples."""
        return PiecewisePolynomial(self.time * samples.t, self.states[:, None] * samples.states)

    def crossing(self, it: Crossing) -> Crossing:
        """A border passed."""
        return it._replace(t=self.time * it.t, state=self.states * it.state)

    def solution(self, solution: Solution) -> Solution:
        """A motion with its crossings."""
        return replace(
            solution,
            samples=self.samples(solution.samples),
            crossings=tuple(map(self.crossing, solution.crossings)),
        )

    def _by_state(self, matrix: FloatArray) -> FloatArray:
        return matrix * self.states[:, None] / self.states if matrix.size else matrix

    def _by_parameters(self, matrix: FloatArray) -> FloatArray:
        return matrix * self.states[:, None] if matrix.size else matrix

    def extremum(self, it: Extremum) -> Extremum:
        """An extremum with its derivatives."""
        return it._replace(
            t=self.time * it.t,
            state=self.states * it.state,
            by_state=self._by_state(it.by_state),
            by_parameters=self._by_parameters(it.by_parameters),
        )

    def flow_result(self, it: FlowResult) -> FlowResult:
        """A flow over a time with its derivatives."""
        length = self.places[0]
        first, square = it.integrals
        return replace(
            it,
            state=self.states * it.state,
            by_state=self._by_state(it.by_state),
            by_parameters=self._by_parameters(it.by_parameters),
            crossings=tuple(map(self.crossing, it.crossings)),
            extrema=tuple(map(self.extremum, it.extrema)),
            integrals=(self.time * length * first, self.time * length**2 * square),
        )

    def statistics(self, it: MotionStatistics) -> MotionStatistics:
        """Quantities measured on a motion."""
        length = self.places[it.lead]
        others = np.delete(self.places, it.lead)
        low, high = it.reach
        return replace(
            it,
            begin=self.time * it.begin,
            end=self.time * it.end,
            first=self.states * it.first,
            last=self.states * it.last,
            maxima_t=self.time * it.maxima_t,
            maxima=self.states * it.maxima,
            integrals=self.time * np.array([length, length**2, *others]) * it.integrals,
            minima=self.states * it.minima,
            reach=(length * low, length * high),
            passages_t=self.time * it.passages_t,
            passages=self.states * it.passages,
        )

    def outcome(self, it: Outcome) -> Outcome:
        """The limit of a motion; the distance to rest is a length, that to a cycle a share."""
        length = self.places[0]
        return replace(
            it,
            rest=tuple((self.states[: len(it.rest)] * it.rest).tolist()),
            rate=it.rate / self.time,
            distance=it.distance * (self.length if it.rest else 1.0),
            period=it.period * self.time,
            cycle_mean=it.cycle_mean * length,
            cycle_rms=it.cycle_rms * length,
            cycle=tuple((self.states[: len(it.cycle)] * it.cycle).tolist()),
        )


def scales_of(field: Field, constants: Values, start: Sequence[float]) -> MotionScales:
    """Scales of the motion from a state.

    The unit of time is that of the fastest stiffness, 1/√|∂q″/∂q|; where nothing is stiff, that of
    the damping, or of what changes the speed at the start. Coordinates of one unit share theirs.
    Lengths have the largest undeformed length of a spring along a line, or else, as other
    coordinates, the largest of the coordinates at the start, of how far they go at its rates and
    accelerations, there or where an angle is turned by its unit, in the unit of time, and of the
    way on which friction that holds is used up,
    unless an angle uses it up within a turn.
    Angles have the unit 1. Of a motion about which this says nothing all units are 1, and
    of a field that does not tell the units of its coordinates.

    Parameters
    ----------
    field : Field
    constants : tuple of float
    start : sequence of float, length 2 n

    Returns
    -------
    Scales

    Examples
    --------
    >>> import spragsym as ss
    >>> from spragsym.motion.scales import scales_of
    >>> p = ss.load("coulomb_stick_slip").Parameters(mu_s=6e5, mu_k=4e5, V=5e5)
    >>> field = p.model.field
    >>> scales_of(field, field.constants(p.scalars(*p.model.parameters)), (0.0, 0.0)).places
    (1048576.0,)
    """
    state, n = [float(value) for value in start], len(field.coordinates)
    if not field.units:
        return MotionScales((1.0,) * n, 1.0, (1.0,) * len(field.borders))
    lengths = field.lengths(state, constants)
    try:
        time, ways = _time_and_ways(field, constants, state)
    except (ArithmeticError, ValueError):  # the motion has no rates at the start
        time, ways = 1.0, np.abs(state[:n])
    places = []
    for unit in field.units:
        alike = [way for way, other in zip(ways, field.units, strict=True) if other == unit]
        sizes = lengths if unit == "m" and lengths else alike
        places.append(1.0 if unit == "rad" else _power(max(sizes)))
    found = MotionScales(tuple(places), _power(time), (1.0,) * len(field.borders))
    levels = (_level(border, field, constants, state, found) for border in field.borders)
    return replace(found, levels=tuple(levels), roots=_roots(field, constants, state, found))


def _time_and_ways(field: Field, constants: Values, state: list[float]) -> tuple[float, FloatArray]:
    """The unit of time, and how far each coordinate goes in it."""
    n = len(field.coordinates)
    positions, rates = np.abs(state[:n]), np.abs(state[n:])
    alike = np.array([[one == other for one in field.units] for other in field.units])
    turning = np.array([unit == "rad" for unit in field.units])
    stiff, damped, pull = 0.0, 0.0, np.zeros(n)
    for mode in _modes(field, constants, state):
        slopes = field.matrix(state, constants, mode)[n:]
        acceleration = field.rates(state, constants, mode)[n:]
        stiff = max(stiff, float(np.abs(slopes[:, :n][alike]).max()))
        damped = max(damped, float(np.abs(slopes[:, n:][alike]).max()))
        turned = np.abs(slopes[:, :n][:, turning]).max(axis=1, initial=0.0)
        pull = np.max([pull, np.abs(acceleration), turned], axis=0)
    fastest = float(rates.max())
    rate = math.sqrt(stiff) or damped or (float(pull.max()) / fastest if fastest else 0.0)
    if not 0.0 < rate < math.inf:
        return 1.0, np.max([positions, rates, pull], axis=0)
    ways = np.max([positions, rates / rate, pull / rate**2], axis=0)
    for border in field.borders:
        if border.stays or not border.slopes:
            continue
        held = next(mode for mode in field.modes if border.sign(mode))
        level, slopes = (each(state, constants, held) for each in (border.level, border.slopes))
        steepest = dict.fromkeys(field.units, 0.0)
        for unit, slope in zip(field.units, slopes, strict=False):
            steepest[unit] = max(steepest[unit], abs(slope))
        if steepest.get("rad", 0.0) * TURN > abs(level):
            continue  # within a turn an angle uses it up, however far the others would have to go
        for i, unit in enumerate(field.units):
            if steepest[unit]:
                ways[i] = max(ways[i], abs(level) / steepest[unit])
    return 1.0 / rate, ways


def _modes(field: Field, constants: Values, state: list[float]) -> set[Mode]:
    """Modes in which the motion begins or may go on."""
    return {field.initial_mode(state, constants), field.mode_at_rest(state, constants)}


def _level(
    border: Border, field: Field, constants: Values, state: list[float], scales: MotionScales
) -> float:
    """The unit of a border's level: by how much it changes over the units of the state."""
    if not border.kink:
        return 1.0
    n, units = len(field.coordinates), scales.states.tolist()
    mode = next((mode for mode in field.modes if border.sign(mode)), field.modes[0])
    sizes = [0.0]
    for share in (0.0, 1.0):
        at = [value + share * unit for value, unit in zip(state[:n], units, strict=False)]
        for i in range(n):
            rates = [0.0] * n
            pulls = rates.copy()
            rates[i] = units[n + i]
            pulls[i] = units[n + i] / scales.time
            try:
                rate = border.rate([*at, *rates], pulls, constants, mode)
            except (ArithmeticError, ValueError):
                continue
            sizes.append(abs(float(rate)) * scales.time)
    return _power(max(sizes))


def _roots(
    field: Field, constants: Values, state: list[float], scales: MotionScales
) -> tuple[float, ...]:
    """Units of square roots: of the largest value of each where the state is, and a unit off."""
    units, sampled = scales.states.tolist(), list[list[float]]()
    for share in (-1.0, 0.0, 1.0):
        at, seen = [v + share * unit for v, unit in zip(state, units, strict=True)], list[float]()

        def sqrt(value: float, seen: list[float] = seen) -> float:
            seen.append(math.sqrt(value))
            return seen[-1]

        xp = SimpleNamespace(**{**vars(FLOATS), "sqrt": sqrt})
        try:
            field.acceleration(at, constants, field.initial_mode(at, constants), xp)
        except (ArithmeticError, ValueError):
            continue
        sampled.append(seen)
    return tuple(_power(max(values)) for values in zip(*sampled, strict=False))


def _power(value: float) -> float:
    """The unit nearest to a number; 1 for 0."""
    # Binary digits beyond which a unit is not 1.
    if not 0.0 < value < math.inf or abs(math.log2(value)) <= 5:
        return 1.0
    # Binary digits between one unit and the next.
    digits = 2
    return math.ldexp(1.0, digits * round(math.log2(value) / digits))


def _times(values: Iterable[Any], factors: Iterable[float]) -> list[Any]:
    return [value * factor for value, factor in zip(values, factors, strict=False)]


@cache
def scaled(field: Field, scales: MotionScales) -> Field:
    """A field in units of its scales; parameters and forces stay as they are."""
    units, time = scales.states.tolist(), scales.time
    faster = [time**2 / length for length in scales.places]
    slower = [1.0 / factor for factor in faster]
    inner = field.sized(scales.levels).with_lead(field.lead) if field.sized else field

    def at(state: Vector) -> list[Any]:
        return _times(state, units)

    def elsewhere(function: Callable[..., Any] | None) -> Any:
        return function and (lambda state, *rest: function(at(state), *rest))

    def rows(function: Callable[..., Any], columns: Sequence[float]) -> Callable[..., Any]:
        def found(state: Vector, *rest: Any) -> list[list[Any]]:
            whole = (_times(row, columns) for row in function(at(state), *rest))
            return [_times(row, repeat(factor)) for row, factor in zip(whole, faster, strict=True)]

        return found

    def border(that: Border, size: float) -> Border:
        def rate(state: Vector, accelerations: Vector, *rest: Any) -> Number:
            return that.rate(at(state), _times(accelerations, slower), *rest) * (time / size)

        def slopes(state: Vector, *rest: Any) -> list[Any]:
            assert that.slopes is not None
            own = _times(that.slopes(at(state), *rest), chain(units, repeat(1.0)))
            return _times(own, repeat(1.0 / size))

        return replace(
            that,
            level=lambda state, *rest: that.level(at(state), *rest) * (1.0 / size),
            rate=rate,
            beyond=lambda mode, *given: that.beyond(mode, *map(at, given[:1]), *given[1:]),
            jumps=elsewhere(that.jumps),
            slopes=slopes if that.slopes else None,
            stays=elsewhere(that.stays),
        )

    pulls, above = elsewhere(inner.acceleration), inner.airborne
    return replace(
        inner,
        name=f"{field.name}:{scales.places}:{time}:{scales.levels}:{scales.roots}",
        acceleration=lambda *given: _times(pulls(*given), faster),
        jacobian=rows(inner.jacobian, units),
        by_parameters=rows(inner.by_parameters, [1.0] * len(field.parameters)),
        borders=tuple(map(border, inner.borders, scales.levels)),
        initial_mode=elsewhere(inner.initial_mode),
        forces=tuple(
            (name, lambda states, constants, force=force: force(np.array(at(states)), constants))
            for name, force in inner.forces
        ),
        airborne=above and (lambda constants, state: above(constants, state * scales.states)),
        lengths=lambda *_: (),
        natural=field,
        scales=scales,
    )
