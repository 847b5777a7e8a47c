"""A model at given values of its parameters, with an integrator (:class:`System`): its motions,
their fates (:class:`FateVerdict`), and its equilibria, which may be saddles (:class:`Saddle`) and
can be continued as fixed points (:class:`FixedPoints`).
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
from ..core.remarks import Amount, At, Remark
from ..models.field import FLOATS, OVERSHOOT, Field, Mode, Values
from ..models.parameters import FloatArray, ParameterSet
from ..motion import Trajectory
from ..motion.classify import equilibrium_near
from ..motion.integrators import Flow
from ..motion.options import MotionOptions
from ..motion.problem import MANY_STEPS, check_range
from ..motion.regimes import Outcome, Regime, RestSets, same_limit
from ..motion.scales import MotionScales, scaled, scales_of
from ..motion.shooting import Conditions, Iterate, Orbit
from ..motion.simulation import motion_of
from ..motion.solution import FlowResult
from ..numerics.vectors import TURN, magnitude, norm
from .arclength import BranchPoint, Setting, started
from .orbit import Cycle


@dataclass(frozen=True)
class System:
    """A flow at given values of the parameters, in the order of the field."""

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
        """The system of a set of parameters, some of which are replaced by ``values``."""
        options = options or MotionOptions()
        flow = Flow.of(model_of(p).field, backend, options.shooting)
        return cls(flow, p.given(**values).scalars(*p.ranges), options)

    @property
    def field(self) -> Field:
        """The field."""
        return self.flow.field

    @property
    def constants(self) -> Values:
        """Constants that the field's functions take."""
        return self.field.constants(self.values)

    def same_limit(self, one: Outcome, other: Outcome) -> bool | None:
        """True if two motions have the same limit; None if that is not known."""
        return same_limit(one, other, self.field, self.constants, self._sets_of_rest)

    @cached_property
    def _sets_of_rest(self) -> RestSets:
        named = zip(self.field.parameters, self.values, strict=True)
        return RestSets(self.field.parameter_set(**dict(named)))

    def at(self, vary: str, value: float) -> System:
        """The system at another value of one parameter; ParameterError if it is not allowed."""
        self.field.check(vary, value)
        values = list(self.values)
        values[self.field.parameters.index(vary)] = value
        return replace(self, values=tuple(values))

    def motion(self, start: FloatArray, t_end: float, **options: Any) -> Trajectory:
        """The motion from a state to ``t_end``."""
        return motion_of(
            self.field, self.values, start, t_end, backend=self.flow.backend, **options
        )

    def scales(self, state: FloatArray) -> MotionScales:
        """Units of the motion from a state."""
        return scales_of(self.field, self.constants, state.tolist())

    def looks(self, scales: MotionScales, t_end: float = math.inf) -> list[float]:
        """Times up to ``t_end`` at which a fate is judged: those of the options, and before them
        under a fast clock, of which a motion has to follow each turn, a hundred turns and so on.
        """
        times = [t * scales.time for t in self.options.times]
        if self.field.clock:
            early = 100 * TURN / self.field.clock(self.constants)
            while early < times[0] / 4:
                times.append(early)
                early *= 8
        return [*(t for t in sorted(times) if t <= t_end / 2), *[t_end] * (t_end < math.inf)]

    def beside(self, state: FloatArray, share: float) -> FloatArray:
        """A state that deviates by a share of the units of the motion, as anything but the rate of
        a clock may.
        """
        free = np.arange(state.size) < self.field.deviations
        return state + free * share * self.scales(state).states

    def scaled(self, scales: MotionScales) -> System:
        """The system in units of ``scales``."""
        if scales.trivial:
            return self
        return replace(self, flow=replace(self.flow, field=scaled(self.field, scales)))

    def mode(self, state: FloatArray) -> Mode:
        """The mode of a state."""
        return self.field.initial_mode(state.tolist(), self.constants)

    def resting_mode(self, state: FloatArray) -> Mode:
        """The mode of an equilibrium."""
        position = state[: len(self.field.coordinates)]
        return self.field.resting_mode(position.tolist(), self.constants)

    def comes_to_a_border(self, state: FloatArray) -> bool:
        """True if a motion that goes on steadily from a state will leave its mode."""
        numbers, constants, mode = state.tolist(), self.constants, self.mode(state)
        velocity = magnitude(state[self.field.size // 2 :] / self.scales(state).places)
        return any(
            -border.sign(mode) * self.field.level_rate(border, numbers, constants, mode)
            > self.options.steady * velocity
            for border in self.field.borders
        )

    def equilibrium(self, near: FloatArray) -> FloatArray:
        """The equilibrium found by Newton's method from a state or its coordinates; (m,)."""
        n = len(self.field.coordinates)
        start = np.concatenate([near[:n], np.zeros(n)])
        scales = self.scales(start)
        field = self.scaled(scales).field
        found = equilibrium_near(field, self.constants, (start / scales.states)[:n])
        return found * scales.states

    def linearization(self, state: FloatArray) -> FloatArray:
        """Jacobian of the motion at an equilibrium, (m, m), in units of the motion."""
        scales = self.scales(state)
        matrix = self.field.matrix(state.tolist(), self.constants, self.resting_mode(state))
        return matrix * scales.time * scales.states / scales.states[:, None]


@dataclass(frozen=True)
class FateVerdict:
    """Fate of a motion as judged at time ``t``, when its state is ``end``. ``otherwise`` describes
    the fate of a motion that starts within rounding of it, if that differs.
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
        """True if the motion approaches an attractor, whatever the rounding."""
        return bool(self.kind.attractor) and not self.otherwise

    def described(self) -> Remark:
        """The fate as text, to follow "it comes to"."""
        found = self.outcome
        limit = Remark("nothing that is decided by t = {}", Amount(self.t, "s", "g"))
        if self.kind == Regime.EQUILIBRIUM:
            coordinates = zip(found.names, found.rest, strict=False)
            places = [At(name, (value,), ".6g") for name, value in coordinates]
            limit = Remark("rest at " + ", ".join("{}" for _ in places), *places)
        elif self.kind == Regime.LIMIT_CYCLE:
            limit = Remark("a cycle of period {}", Amount(found.period, "s"))
        elif self.kind == Regime.LIFT_OFF:
            limit = Remark("lift-off")
        if self.otherwise:
            limit = Remark("{} or, as rounding decides, to {}", limit, self.otherwise)
        return limit


def judged(
    system: System,
    start: FloatArray,
    *,
    times: Sequence[float] | None = None,
    rtol: float | None = None,
) -> FateVerdict:
    """Fate of the motion from a state, judged at each of ``times`` until it is decided. By default
    these are those of the options, and later ones while what friction holds is carried slowly.
    """
    state, begun, options, scales = start, 0.0, system.options, system.scales(start)
    looks = list(times or system.looks(scales))
    while True:
        t_end = looks.pop(0)
        motion = system.motion(state, t_end - begun, rtol=options.rtol if rtol is None else rtol)
        check_range(system.field, motion.state[:, -1], scales.states)
        outcome = motion.outcome(0.5 * (t_end - begun), options=options)
        verdict = FateVerdict(outcome, motion.state[:, -1].copy(), t_end)
        if not looks and not times and _is_slow(system, motion, scales.time):
            looks = [10 * t_end]
        if verdict.decided or not looks or _is_long(motion, looks[0] - t_end):
            return verdict
        state, begun = verdict.end, t_end


def _is_long(motion: Trajectory, left: float) -> bool:
    """Whether to go on for a time would take so many steps that an explicit method may leave it to
    the implicit one, which takes a hundred times as long for each.
    """
    duration = float(motion.t[-1] - motion.t[0])
    return not motion.implicit and len(motion.samples.steps) * left > MANY_STEPS * duration


def _is_slow(system: System, motion: Trajectory, unit: float) -> bool:
    """True if hardly anything has happened in a motion, but something will."""
    events = 0 if motion.events is None else len(motion.events)
    mean_step = motion.t[-1] / len(motion.samples.steps)
    will = events or system.comes_to_a_border(motion.state[:, -1])
    return bool(mean_step > 10 * unit and events < 100 and will and motion.t[-1] < 1e15 * unit)


def verified(
    system: System, start: FloatArray, verdict: FateVerdict, alike: Callable[[FateVerdict], bool]
) -> FateVerdict:
    """The verdict, made undecided if rounding may change it.

    Motions with two tolerances are compared. If they diverge, as irregular ones do, the finer one
    and several that start within rounding are judged, too: all fates must be ``alike``.
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
        beside = system.beside(start, i * options.rtol)
        neighbour = judged(system, beside, rtol=rtols[0 if i else 1])
        if not neighbour.decided:  # it may need more time
            later = judged(system, neighbour.end)
            neighbour = replace(later, t=neighbour.t + later.t)
        if not neighbour.decided or not alike(neighbour):
            return replace(verdict, otherwise=neighbour.described())
    return verdict


@dataclass(frozen=True)
class Saddle:
    """An equilibrium with exactly one eigenvalue of significantly positive real part, ``growth``,
    which is real.

    ``left_eigenvector`` belongs to it, normalized to 1 for the unit right eigenvector:
    ``left_eigenvector @ (state − saddle)`` grows as exp(growth τ). ``attracts`` is True if all
    other eigenvalues have significantly negative real parts.
    """

    state: FloatArray
    growth: float
    left_eigenvector: FloatArray
    attracts: bool


def rounding_of(matrix: FloatArray) -> float:
    """Bound of the rounding error of well separated eigenvalues of a matrix, with a margin."""
    return 1e-13 * max(1.0, magnitude(matrix))


class TooUnstableError(ConvergenceError):
    """A saddle has three unstable directions or more: its stable manifold bounds no basin."""


def saddle_near(system: System, state: FloatArray) -> Saddle:
    """The saddle near a state, by Newton's method; ConvergenceError if the equilibrium does not
    have exactly one unstable direction, TooUnstableError if it has another odd number of them.
    """
    rest = system.equilibrium(state)
    eigenvalues, vectors, error = spectrum(system, rest)
    growing = np.flatnonzero(eigenvalues.real > error)
    if len(growing) > 1 and len(growing) % 2:
        raise TooUnstableError(f"the saddle has {len(growing)} unstable directions")
    if len(growing) != 1 or abs(eigenvalues[growing[0]].imag) > 0:
        raise ConvergenceError("the equilibrium is no saddle")
    which = int(growing[0])
    left_eigenvector = np.linalg.inv(vectors)[which].real * norm(vectors[:, which].real)
    attracts = bool((np.delete(eigenvalues.real + error, which) < 0).all())
    return Saddle(rest, float(eigenvalues[which].real), left_eigenvector, attracts)


def spectrum(system: System, state: FloatArray) -> tuple[Any, Any, FloatArray]:
    """Eigenvalues at an equilibrium, right eigenvectors (columns), and errors of the eigenvalues:
    rounding times the condition number of each, infinite for a double one.
    """
    scales, matrix = system.scales(state), system.linearization(state)
    eigenvalues, vectors = np.linalg.eig(matrix)
    try:
        with np.errstate(over="ignore"):  # nearly parallel eigenvectors: infinite, too
            condition = np.linalg.norm(np.linalg.inv(vectors), axis=1)
            condition = condition * np.linalg.norm(vectors, axis=0)
    except np.linalg.LinAlgError:
        condition = np.full(len(vectors), np.inf)
    error = rounding_of(matrix) * condition / scales.time
    return eigenvalues / scales.time, scales.states[:, None] * vectors, error


def growth_of_cycle(cycle: Cycle) -> float | None:
    """Growth rate ln |μ| / T of a saddle cycle, whose multiplier μ is the only one outside the unit
    circle; None unless that is certain within the errors.
    """
    found = cycle.orbit.multipliers
    sizes, error = np.abs(found.others), cycle.multiplier_errors[found.held :]
    which = int(np.argmax(sizes))
    if not sizes[which] - error[which] > 1 or not (np.delete(sizes + error, which) < 1).all():
        return None
    return float(np.log(sizes[which]) / cycle.period)


@dataclass(frozen=True)
class FixedPoints:
    """Equilibria as closed orbits of period 1, for the continuation of branches.

    The flow map is replaced by the map u → u + u̇(u), of which equilibria are the fixed points. The
    rates are those in ``mode``, if it is given, else in the state's own mode.
    """

    field: Field
    mode: Mode | None = None

    def started(self, system: System, state: FloatArray, index: int, span: float) -> BranchPoint:
        """First point of a branch of equilibria in one parameter, of range 2 ``span``."""
        setting = Setting(
            replace(system.flow, other=self.flow_map), (index,), 1.0, (span,), _of_one_time
        )
        return started(setting, Iterate(state[None], 1.0, system.values))

    def at(self, state: FloatArray, constants: Values) -> tuple[list[float], Values, Mode]:
        """Arguments of the field's functions: state, constants and mode. The last numbers of a
        mode, of torsion springs, are always those of the state.
        """
        numbers = state.tolist()
        own = self.field.initial_mode(numbers, constants)
        fixed = len(own) - self.field.torsion_sides
        return numbers, constants, (self.mode or own)[:fixed] + own[fixed:]

    def flow_map(
        self, state: FloatArray, constants: Values, _: float, directions: FloatArray
    ) -> FlowResult:
        """The map u → u + u̇(u) with its derivatives, as :meth:`Flow.flow_map`."""
        arguments = self.at(state, constants)
        by_parameters = np.zeros((self.field.size, len(directions)))
        n = len(self.field.coordinates)
        try:
            end = state + self.field.rates(*arguments)
            by_state = np.eye(self.field.size) + self.field.matrix(*arguments)
            slopes = np.array(self.field.by_parameters(*arguments, FLOATS), dtype=float)
        except ArithmeticError as error:
            raise ConvergenceError("there is no motion") from error
        by_parameters[n:] = slopes @ directions.T
        return FlowResult(end, by_state, by_parameters, (), ())

    def eigenvalues(self, point: BranchPoint) -> list[complex]:
        """Eigenvalues of the linearized motion."""
        arguments = self.at(point.orbit.state, point.orbit.constants)
        return [complex(value) for value in np.linalg.eigvals(self.field.matrix(*arguments))]

    def pairs(self, point: BranchPoint) -> float:
        """Test function of a Hopf point: product of λ + μ over all pairs of eigenvalues, each
        divided by |λ| + |μ|. It is 0 for a pair ± i ω.
        """
        pairs = combinations(self.eigenvalues(point), 2)
        return float(
            math.prod((one + other) / (abs(one) + abs(other) or 1.0) for one, other in pairs).real
        )

    def inside(self, point: BranchPoint) -> bool:
        """True if the state is within its mode with respect to all kinks at which the field is
        continuous.
        """
        state, constants, mode = self.at(point.orbit.state, point.orbit.constants)
        kinks = (border for border in self.field.borders if border.kink and border.jumps is None)
        return all(
            border.sign(mode) * border.level(state, constants, mode) >= -2 * OVERSHOOT
            for border in kinks
        )


def _of_one_time(_: Setting, near: Orbit, __: FloatArray) -> Conditions:
    """Condition in place of the phase, which an equilibrium does not have: the period is 1."""
    row = np.eye(1, len(near.guess.coordinates), near.states.size)
    return lambda orbit: (np.array([orbit.period - 1.0]), row)
