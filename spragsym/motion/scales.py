"""Nondimensionalization of a motion: its characteristic scales, and the field in units of them.

Absolute tolerances, the distance beyond a border at which a mode is left, and the speed below which
nothing moves, are meant for numbers of order 1. So every motion is integrated in units of its own
scales. The units are powers of four, which convert without rounding. The unit is 1 for scales
between 1/32 and 32, so that motions of a common size are integrated as they are.
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

from ..models.field import FLOATS, Border, Field, Values, Vector
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
    square root in the accelerations, as of a spring's length, in the order of evaluation.

    A method converts an object of the same name to the model's units, as in
    ``scales.solution(scaled)``; those of :attr:`inverse` convert the other way. Only
    :meth:`problem` converts from the model's units.
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
        """Reciprocal units, which convert from the model's units to these."""
        return MotionScales(
            tuple(1.0 / unit for unit in self.places),
            1.0 / self.time,
            tuple(1.0 / unit for unit in self.levels),
            tuple(1.0 / unit for unit in self.roots),
        )

    def problem(self, problem: Problem) -> Problem:
        """A problem in the model's units converted to these."""
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
        """Samples of a motion."""
        return PiecewisePolynomial(self.time * samples.t, self.states[:, None] * samples.states)

    def crossing(self, it: Crossing) -> Crossing:
        """A border crossing."""
        return it._replace(t=self.time * it.t, state=self.states * it.state)

    def solution(self, solution: Solution) -> Solution:
        """A motion with its crossings."""
        return replace(
            solution,
            samples=self.samples(solution.samples),
            crossings=tuple(map(self.crossing, solution.crossings)),
        )

    def _state(self, it: Extremum | FlowResult) -> dict[str, Any]:
        """A state and its derivatives, which may be empty."""
        units = self.states[:, None]
        return {
            "state": self.states * it.state,
            "by_state": it.by_state * units / self.states if it.by_state.size else it.by_state,
            "by_parameters": it.by_parameters * units
            if it.by_parameters.size
            else it.by_parameters,
        }

    def extremum(self, it: Extremum) -> Extremum:
        """An extremum with its derivatives."""
        return it._replace(t=self.time * it.t, **self._state(it))

    def flow_result(self, it: FlowResult) -> FlowResult:
        """A flow map with its derivatives."""
        length = self.places[0]
        first, square = it.integrals
        return replace(
            it,
            **self._state(it),
            crossings=tuple(map(self.crossing, it.crossings)),
            extrema=tuple(map(self.extremum, it.extrema)),
            integrals=(self.time * length * first, self.time * length * length * square),
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
        """The limit of a motion. The distance to rest is a length, that to a cycle is relative."""
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
    """Scales of the motion from an initial state.

    The unit of time is that of the largest stiffness, 1/√|∂q″/∂q|. Without stiffness it is that of
    the damping, 1/|∂q″/∂q′|, or else the time in which accelerations change the initial rates.

    Angles have the unit 1. Other coordinates with the same physical unit share one scale. For
    lengths it is the largest undeformed length of a spring along a line, if there is one. Otherwise
    it is the largest of: the initial coordinates; the distances covered in the unit of time at the
    initial rates, at the initial accelerations, and at those that a turn of an angle by 1 adds; the
    displacement that exhausts a holding friction, unless an angle exhausts it within a turn.

    All units are 1 if none of these is positive, or if the field does not state the units of its
    coordinates.

    Parameters
    ----------
    field : Field
    constants : tuple of float
    start : sequence of float, length 2 n

    Returns
    -------
    MotionScales

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
        time, distances = _time_and_distances(field, constants, state)
    except (ArithmeticError, ValueError):  # the field is undefined at the start
        time, distances = 1.0, np.abs(state[:n])
    places = []
    for unit in field.units:
        same_unit = [
            way for way, other in zip(distances, field.units, strict=True) if other == unit
        ]
        sizes = lengths if unit == "m" and lengths else same_unit
        places.append(1.0 if unit == "rad" else _power(max(sizes)))
    found = MotionScales(tuple(places), _power(time), (1.0,) * len(field.borders))
    levels = (_level(border, field, constants, state, found) for border in field.borders)
    return replace(found, levels=tuple(levels), roots=_roots(field, constants, state, found))


def _time_and_distances(
    field: Field, constants: Values, state: list[float]
) -> tuple[float, FloatArray]:
    """The unit of time, and the distance that each coordinate covers in it, (n,)."""
    n = len(field.coordinates)
    positions, rates = np.abs(state[:n]), np.abs(state[n:])
    same_unit = np.array([[one == other for one in field.units] for other in field.units])
    angles = np.array([unit == "rad" for unit in field.units])
    stiffness, damping, acceleration = 0.0, 0.0, np.zeros(n)
    # The mode in which the motion begins, and that at rest with all contacts closed, on the sides
    # on which each slides: on the other one a smooth friction law may be as large as exp(reach).
    begin, still = field.initial_mode(state, constants), field.at_rest(state[:n], constants)
    sides = zip(
        field.initial_mode(still, constants), field.mode_at_rest(state, constants), strict=True
    )
    rest = tuple(-1 if here < 0 else closed for here, closed in sides)
    for at, mode in ((state, begin), (still, rest)):
        jacobian = field.matrix(at, constants, mode)[n:]
        initial = np.abs(field.rates(at, constants, mode)[n:])
        stiffness = max(stiffness, float(np.abs(jacobian[:, :n][same_unit]).max()))
        damping = max(damping, float(np.abs(jacobian[:, n:][same_unit]).max()))
        by_angle = np.abs(jacobian[:, :n][:, angles]).max(axis=1, initial=0.0)
        acceleration = np.max([acceleration, initial, by_angle], axis=0)
    speed = float(rates.max())
    rate = math.sqrt(stiffness) or damping or (float(acceleration.max()) / speed if speed else 0.0)
    if not 0.0 < rate < math.inf:
        return 1.0, np.max([positions, rates, acceleration], axis=0)
    distances = np.max([positions, rates / rate, acceleration / rate**2], axis=0)
    for border in field.borders:
        if border.stays or not border.slopes:
            continue
        # The level is the reserve of a holding friction; displacements use it up.
        held = next(mode for mode in field.modes if border.sign(mode))
        level = border.level(state, constants, held)
        steepest = dict.fromkeys(field.units, 0.0)
        for unit, slope in zip(field.units, border.slopes(state, constants, held), strict=False):
            steepest[unit] = max(steepest[unit], abs(slope))
        if steepest.get("rad", 0.0) * TURN > abs(level):
            continue
        for i, unit in enumerate(field.units):
            if steepest[unit]:
                distances[i] = max(distances[i], abs(level) / steepest[unit])
    return 1.0 / rate, distances


def _level(
    border: Border, field: Field, constants: Values, state: list[float], scales: MotionScales
) -> float:
    """The unit of a border's level: its change over the units of the state.

    The change is the level's rate times the unit of time, for one coordinate at a time with unit
    rate and acceleration, at the state and one unit away from it.
    """
    if not border.kink:
        return 1.0
    n, units = len(field.coordinates), scales.states.tolist()
    mode = next((mode for mode in field.modes if border.sign(mode)), field.modes[0])
    changes = [0.0]
    for offset in (0.0, 1.0):
        position = [value + offset * unit for value, unit in zip(state[:n], units, strict=False)]
        for i in range(n):
            rates = [0.0] * n
            accelerations = rates.copy()
            rates[i] = units[n + i]
            accelerations[i] = units[n + i] / scales.time
            try:
                rate = border.rate([*position, *rates], accelerations, constants, mode)
            except (ArithmeticError, ValueError):
                continue
            changes.append(abs(float(rate)) * scales.time)
    return _power(max(changes))


def _roots(
    field: Field, constants: Values, state: list[float], scales: MotionScales
) -> tuple[float, ...]:
    """Units of the square roots in the accelerations: of the largest value of each, at the state
    and one unit to either side.
    """
    units, sampled = scales.states.tolist(), list[list[float]]()
    for offset in (-1.0, 0.0, 1.0):
        at = [v + offset * unit for v, unit in zip(state, units, strict=True)]
        values = list[float]()

        def sqrt(value: float, values: list[float] = values) -> float:
            values.append(math.sqrt(value))
            return values[-1]

        xp = SimpleNamespace(**{**vars(FLOATS), "sqrt": sqrt})
        try:
            field.acceleration(at, constants, field.initial_mode(at, constants), xp)
        except (ArithmeticError, ValueError):
            continue
        sampled.append(values)
    return tuple(_power(max(values)) for values in zip(*sampled, strict=False))


def _power(value: float) -> float:
    """The power of four nearest to a scale; 1 for scales between 1/32 and 32, and for 0."""
    if not 0.0 < value < math.inf or abs(math.log2(value)) <= 5:
        return 1.0
    return math.ldexp(1.0, 2 * round(math.log2(value) / 2))


def _times(values: Iterable[Any], factors: Iterable[float]) -> list[Any]:
    return [value * factor for value, factor in zip(values, factors, strict=False)]


@cache
def scaled(field: Field, scales: MotionScales) -> Field:
    """The field in units of ``scales``: its functions take and return scaled numbers. Parameters
    and forces keep the model's units.
    """
    units, time = scales.states.tolist(), scales.time
    # Factors of the accelerations to scaled units, and back.
    to_scaled = [time**2 / length for length in scales.places]
    to_model = [1.0 / factor for factor in to_scaled]
    inner = field.sized(scales.levels).with_lead(field.lead) if field.sized else field

    def at(state: Vector) -> list[Any]:
        return _times(state, units)

    def of_scaled(function: Callable[..., Any] | None) -> Any:
        return function and (lambda state, *rest: function(at(state), *rest))

    def rows(function: Callable[..., Any], columns: Sequence[float]) -> Callable[..., Any]:
        def converted(state: Vector, *rest: Any) -> list[list[Any]]:
            matrix = (_times(row, columns) for row in function(at(state), *rest))
            pairs = zip(matrix, to_scaled, strict=True)
            return [_times(row, repeat(factor)) for row, factor in pairs]

        return converted

    def border(that: Border, size: float) -> Border:
        def rate(state: Vector, accelerations: Vector, *rest: Any) -> Number:
            return that.rate(at(state), _times(accelerations, to_model), *rest) * (time / size)

        def slopes(state: Vector, *rest: Any) -> list[Any]:
            assert that.slopes is not None
            own = _times(that.slopes(at(state), *rest), chain(units, repeat(1.0)))
            return _times(own, repeat(1.0 / size))

        return replace(
            that,
            level=lambda state, *rest: that.level(at(state), *rest) * (1.0 / size),
            rate=rate,
            beyond=lambda mode, *given: that.beyond(mode, *map(at, given[:1]), *given[1:]),
            jumps=of_scaled(that.jumps),
            slopes=slopes if that.slopes else None,
            stays=of_scaled(that.stays),
        )

    acceleration, airborne = of_scaled(inner.acceleration), inner.airborne
    return replace(
        inner,
        name=f"{field.name}:{scales.places}:{time}:{scales.levels}:{scales.roots}",
        acceleration=lambda *given: _times(acceleration(*given), to_scaled),
        jacobian=rows(inner.jacobian, units),
        by_parameters=rows(inner.by_parameters, [1.0] * len(field.parameters)),
        borders=tuple(map(border, inner.borders, scales.levels)),
        initial_mode=of_scaled(inner.initial_mode),
        friction_holds=of_scaled(inner.friction_holds),
        periodic=inner.periodic.scaled(scales.states),
        forces=tuple(
            (name, lambda states, constants, force=force: force(np.array(at(states)), constants))
            for name, force in inner.forces
        ),
        airborne=airborne and (lambda constants, state: airborne(constants, state * scales.states)),
        lengths=lambda *_: (),
        natural=field,
        scales=scales,
    )
