"""A model at values of its parameters, with an integrator: its motions, what they come to, its
equilibria and saddles.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from dataclasses import field as attribute
from functools import cached_property
from itertools import combinations
from typing import Any

import numpy as np

from ..core.errors import ConvergenceError
from ..core.questions import model_of
from ..models.field import FLOATS, OVERSHOOT, Field, Mode, Values
from ..models.parameters import FloatArray, ParameterSet
from ..motion import Trajectory
from ..motion.classify import equilibrium_near
from ..motion.integrators import Flow
from ..motion.options import MotionOptions
from ..motion.regimes import Outcome, Regime, RestSets, same_limit
from ..motion.scales import MotionScales, scaled, scales_of
from ..motion.shooting import Conditions, Iterate, Orbit
from ..motion.simulation import motion_of
from ..motion.solution import FlowResult
from ..numerics.vectors import magnitude, norm
from .arclength import BranchPoint, Setting, started
from .orbit import Cycle


@dataclass(frozen=True)
class System:
    """A flow at values of the parameters, in the order of the field's."""

    flow: Flow
    values: Values
    options: MotionOptions = attribute(default_factory=MotionOptions)

    @classmethod
    def of(
        cls,
        p: ParameterSet,
        backend: str | None,
        options: MotionOptions | None = None,
        **values: float | None,
    ) -> System:
        """The system of a set of parameters, with values in place of some of its own."""
        options = options or MotionOptions()
        flow = Flow.of(model_of(p).field, backend, options.shooting)
        return cls(flow, p.given(**values).scalars(*p.ranges), options)

    @property
    def field(self) -> Field:
        """The field."""
        return self.flow.field

    @property
    def constants(self) -> Values:
        """Arguments of the field's functions."""
        return self.field.constants(self.values)

    def same_limit(self, one: Outcome, other: Outcome) -> bool | None:
        """Whether two motions have one limit; None where that is not known."""
        return same_limit(one, other, self.field, self.constants, self._sets_of_rest)

    @cached_property
    def _sets_of_rest(self) -> RestSets:
        named = zip(self.field.parameters, self.values, strict=True)
        return RestSets(self.field.parameter_set(**dict(named)))

    def at(self, vary: str, value: float) -> System:
        """The system at another value of one parameter, which is checked."""
        self.field.check(vary, value)
        return replace(
            self,
            values=tuple(
                value if name == vary else own
                for name, own in zip(self.field.parameters, self.values, strict=True)
            ),
        )

    def motion(self, start: FloatArray, t_end: float, **options: Any) -> Trajectory:
        """The motion from a state."""
        return motion_of(
            self.field, self.values, start, t_end, backend=self.flow.backend, **options
        )

    def scales(self, state: FloatArray) -> MotionScales:
        """Units of the motion from a state."""
        return scales_of(self.field, self.constants, state.tolist())

    def scaled(self, scales: MotionScales) -> System:
        """The system in these units; itself where all are 1."""
        if scales.trivial:
            return self
        return replace(self, flow=replace(self.flow, field=scaled(self.field, scales)))

    def mode(self, state: FloatArray) -> Mode:
        """The mode of a state."""
        return self.field.initial_mode(state.tolist(), self.constants)

    def equilibrium(self, near: FloatArray) -> FloatArray:
        """The equilibrium that Newton's method finds from the coordinates of a state or a place."""
        n = len(self.field.coordinates)
        start = np.concatenate([near[:n], np.zeros(n)])
        scales = self.scales(start)
        field = self.scaled(scales).field
        found = equilibrium_near(field, self.constants, (start / scales.states)[:n])
        return found * scales.states

    def linearization(self, state: FloatArray) -> FloatArray:
        """The matrix of the motion about an equilibrium, shape (m, m), in units of the motion."""
        scales = self.scales(state)
        matrix = self.field.matrix(state.tolist(), self.constants, self.mode(state))
        return matrix * scales.time * scales.states / scales.states[:, None]


@dataclass(frozen=True)
class FateVerdict:
    """Fate of a motion, seen at ``t``, where it is at ``end``; ``otherwise`` is what one within
    rounding comes to.
    """

    outcome: Outcome
    end: FloatArray
    t: float
    otherwise: str = ""

    @property
    def kind(self) -> Regime:
        """EQUILIBRIUM, LIMIT_CYCLE, LIFT_OFF or UNSETTLED."""
        return self.outcome.limit

    @property
    def decided(self) -> bool:
        """Whether it is seen to come to an attractor."""
        return bool(self.kind.attractor) and not self.otherwise

    def described(self) -> str:
        """Verdict in words."""
        found, limit = self.outcome, f"nothing that is decided by t = {self.t:g}"
        if self.kind == Regime.EQUILIBRIUM:
            coordinates = zip(found.names, found.rest, strict=False)
            limit = "rest at " + ", ".join(f"{name} = {value:.6g}" for name, value in coordinates)
        elif self.kind == Regime.LIMIT_CYCLE:
            limit = f"a cycle of period {found.period:.6g}"
        elif self.kind == Regime.LIFT_OFF:
            limit = "lift-off"
        return limit + (f" or, as rounding decides, to {self.otherwise}" if self.otherwise else "")


def judged(
    system: System,
    start: FloatArray,
    *,
    times: Sequence[float] | None = None,
    rtol: float | None = None,
) -> FateVerdict:
    """Fate of the motion from a state, looked at later and later as long as that is undecided."""
    state, begun, options = start, 0.0, system.options
    for t_end in times or [t * system.scales(start).time for t in options.times]:
        motion = system.motion(state, t_end - begun, rtol=options.rtol if rtol is None else rtol)
        outcome = motion.outcome(0.5 * (t_end - begun), options=options)
        verdict = FateVerdict(outcome, motion.state[:, -1].copy(), t_end)
        if verdict.decided:
            break
        state, begun = verdict.end, t_end
    return verdict


def verified(
    system: System, start: FloatArray, verdict: FateVerdict, alike: Callable[[FateVerdict], bool]
) -> FateVerdict:
    """A verdict, or an undecided one where rounding decides it.

    That is where motions by two tolerances part on their way, as irregular ones do, and the finer
    one, or one of some that begin within rounding, comes to something that is not ``alike``.
    """
    if not verdict.decided:
        return verdict
    scales, options = system.scales(start), system.options
    times = np.arange(0.0, verdict.t, scales.time)
    rtols = options.rtol, options.finer_rtol
    one, other = (system.motion(start, verdict.t, rtol=rtol)(times) for rtol in rtols)
    if not magnitude((one - other) / scales.states[:, None]) > options.parted:
        return verdict
    for i in range(options.neighbours + 1):
        off = i * options.rtol * scales.states
        beside = judged(system, start + off, rtol=rtols[0 if i else 1])
        if not beside.decided:  # it may only take longer
            later = judged(system, beside.end)
            beside = replace(later, t=beside.t + later.t)
        if not beside.decided or not alike(beside):
            return replace(verdict, otherwise=beside.described())
    return verdict


@dataclass(frozen=True)
class Saddle:
    """An equilibrium with one real direction of growth, and no other that is proved.

    ``left_eigenvector``, the left eigenvector of the eigenvalue ``growth``, is 1 along the right
    one's direction: ``left_eigenvector @ (state − saddle)`` grows as exp(growth τ). ``attracts`` is
    that all other eigenvalues are proved to have negative real parts.
    """

    state: FloatArray
    growth: float
    left_eigenvector: FloatArray
    attracts: bool


def rounding_of(matrix: FloatArray) -> float:
    """Largest rounding error of a real part of an eigenvalue of a matrix of well separated
    eigenvalues.
    """
    # Of a matrix of the motion about an equilibrium: relative error, with a margin.
    return 1e-13 * max(1.0, magnitude(matrix))


def saddle_near(system: System, state: FloatArray) -> Saddle:
    """The saddle near a state; ConvergenceError where the equilibrium there has no direction of
    growth, or several.
    """
    rest = system.equilibrium(state)
    eigenvalues, vectors, error = spectrum(system, rest)
    growing = np.flatnonzero(eigenvalues.real > error)
    if len(growing) != 1 or abs(eigenvalues[growing[0]].imag) > 0:
        raise ConvergenceError("the equilibrium is no saddle")
    which = int(growing[0])
    left_eigenvector = np.linalg.inv(vectors)[which].real * norm(vectors[:, which].real)
    attracts = bool((np.delete(eigenvalues.real + error, which) < 0).all())
    return Saddle(rest, float(eigenvalues[which].real), left_eigenvector, attracts)


def spectrum(system: System, state: FloatArray) -> tuple[Any, Any, FloatArray]:
    """Eigenvalues of the motion about an equilibrium with their vectors and errors: by how much
    more than the matrix each moves; infinite for a double one.
    """
    scales, matrix = system.scales(state), system.linearization(state)
    eigenvalues, vectors = np.linalg.eig(matrix)
    try:
        with np.errstate(over="ignore"):  # vectors that are one but for rounding: infinite, too
            moves = np.linalg.norm(np.linalg.inv(vectors), axis=1) * np.linalg.norm(vectors, axis=0)
    except np.linalg.LinAlgError:
        moves = np.full(len(vectors), np.inf)
    error = rounding_of(matrix) * moves / scales.time
    return eigenvalues / scales.time, scales.states[:, None] * vectors, error


def growth_of_cycle(cycle: Cycle) -> float | None:
    """ln μ / T of the one multiplier beyond the unit circle; None unless it is proved that there is
    one, and one only.
    """
    sizes, error = np.abs(cycle.multipliers[1:]), cycle.multiplier_errors
    which = int(np.argmax(sizes))
    if not sizes[which] - error[which] > 1 or not (np.delete(sizes + error, which) < 1).all():
        return None
    return float(np.log(sizes[which]) / cycle.period)


@dataclass(frozen=True)
class FixedPoints:
    """Equilibria, fixed points of the map that adds to a state its rates; ``mode`` is kept where it
    is given.
    """

    field: Field
    mode: Mode | None = None

    def started(self, system: System, state: FloatArray, index: int, span: float) -> BranchPoint:
        """An equilibrium of a system as a point from which it is followed in one parameter."""
        setting = Setting(
            replace(system.flow, other=self.flow_map), (index,), 1.0, (span,), _of_one_time
        )
        return started(setting, Iterate(state[None], 1.0, system.values))

    def at(self, state: FloatArray, constants: Values) -> tuple[list[float], Values, Mode]:
        """State, constants and mode, whose last numbers go with the place."""
        numbers = state.tolist()
        own = self.field.initial_mode(numbers, constants)
        kept = len(own) - self.field.torsion_sides
        return numbers, constants, (self.mode or own)[:kept] + own[kept:]

    def flow_map(
        self, state: FloatArray, constants: Values, _: float, directions: FloatArray
    ) -> FlowResult:
        """The map with its derivatives."""
        there = self.at(state, constants)
        by_parameters = np.zeros((self.field.size, len(directions)))
        n = len(self.field.coordinates)
        try:
            end = state + self.field.rates(*there)
            by_state = np.eye(self.field.size) + self.field.matrix(*there)
            by_parameters[n:] = (
                np.array(self.field.by_parameters(*there, FLOATS), dtype=float) @ directions.T
            )
        except ArithmeticError as error:
            raise ConvergenceError("there is no motion") from error
        return FlowResult(end, by_state, by_parameters, (), ())

    def eigenvalues(self, point: BranchPoint) -> list[complex]:
        """Eigenvalues of the linearized motion."""
        there = self.at(point.orbit.state, point.orbit.constants)
        return [complex(value) for value in np.linalg.eigvals(self.field.matrix(*there))]

    def pairs(self, point: BranchPoint) -> float:
        """Product of the sums of all pairs of eigenvalues, each over its size: 0 where a pair is ±
        i ω.
        """
        pairs = combinations(self.eigenvalues(point), 2)
        return float(
            math.prod((one + other) / (abs(one) + abs(other) or 1.0) for one, other in pairs).real
        )

    def inside(self, point: BranchPoint) -> bool:
        """Whether a state is on this side of all kinks; the field jumps at the end of a torsion
        spring, or is smooth.
        """
        state, constants, mode = self.at(point.orbit.state, point.orbit.constants)
        kinks = (border for border in self.field.borders if border.kink and border.jumps is None)
        return all(
            border.sign(mode) * border.level(state, constants, mode) >= -2 * OVERSHOOT
            for border in kinks
        )


def _of_one_time(_: Setting, near: Orbit, __: FloatArray) -> Conditions:
    """An equilibrium has no period: it stays 1."""
    row = np.eye(1, len(near.guess.coordinates), near.states.size)
    return lambda orbit: (np.array([orbit.period - 1.0]), row)
