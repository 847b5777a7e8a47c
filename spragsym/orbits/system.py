"""A model at values of its parameters, with an integrator: its motions, its equilibria, how they are followed, and saddles."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

import numpy as np

from ..errors import ConvergenceError
from ..models.field import GAP, Field, Mode
from ..models.parameters import FloatArray, ParameterSet
from ..motion import Trajectory
from ..motion.classify import equilibrium_near
from ..motion.integrators import Flow
from ..motion.shooting import Conditions, Guess, Loop
from ..motion.simulation import motion_of
from ..motion.solution import Passage
from ..questions import model_of
from .arclength import Point, Setting, started
from .orbit import Cycle

#: Of a matrix of the motion about an equilibrium: relative error, with a margin.
ROUNDING = 1e-13


@dataclass(frozen=True)
class System:
    """A flow at values of the parameters, in the order of the field's."""

    flow: Flow
    values: tuple[float, ...]

    @classmethod
    def of(cls, p: ParameterSet, backend: str | None, **belt: float | None) -> System:
        """The system of a set of parameters, with values in place of some of its own."""
        return cls(Flow.of(model_of(p).field, backend), p.given(**belt).scalars(*p.ranges))

    @property
    def field(self) -> Field:
        """The field."""
        return self.flow.field

    @property
    def constants(self) -> tuple[float, ...]:
        """What the field's functions take."""
        return self.field.constants(self.values)

    def at(self, vary: str, value: float) -> System:
        """The system at another value of one parameter, which is checked."""
        self.field.check(vary, value)
        return replace(self, values=tuple(value if name == vary else own for name, own in self.named()))

    def named(self) -> list[tuple[str, float]]:
        """Parameters by name with their values."""
        return list(zip(self.field.parameters, self.values, strict=True))

    def motion(self, start: FloatArray, t_end: float, **options: Any) -> Trajectory:
        """The motion from a state."""
        return motion_of(self.field, self.values, start, t_end, backend=self.flow.backend, **options)

    def equilibrium(self, state: FloatArray) -> FloatArray:
        """The equilibrium that Newton's method finds from a state."""
        return equilibrium_near(self.field, self.constants, state[: len(self.field.coordinates)])

    def linearization(self, state: FloatArray) -> FloatArray:
        """The matrix of the motion about an equilibrium, shape (m, m)."""
        constants, numbers = self.constants, np.asarray(state).tolist()
        return self.field.matrix(numbers, constants, self.field.initial_mode(numbers, constants))


@dataclass(frozen=True)
class Saddle:
    """An equilibrium with one real direction of growth, and no other that is proved.

    ``direction`` and ``measure`` are right and left eigenvectors of the eigenvalue ``growth``, the product of which is 1:
    ``measure @ (state − saddle)`` grows as exp(growth τ). ``attracts`` is that all others are proved to have negative real parts.
    """

    state: FloatArray
    growth: float
    direction: FloatArray
    measure: FloatArray
    attracts: bool


def rounding_of(matrix: FloatArray) -> float:
    """What rounding may add to a real part of an eigenvalue of a matrix of well separated eigenvalues."""
    return float(ROUNDING * max(1.0, np.abs(matrix).max()))


def saddle_near(system: System, state: FloatArray) -> Saddle | None:
    """The saddle near a state; None where the equilibrium there has no direction of growth, or several."""
    place = system.equilibrium(state)
    eigenvalues, vectors, error = _spectrum(system.linearization(place))
    growing = np.flatnonzero(eigenvalues.real > error)
    if len(growing) != 1 or abs(eigenvalues[growing[0]].imag) > 0:
        return None
    which = int(growing[0])
    left = np.linalg.inv(vectors)[which].real
    right = vectors[:, which].real
    size = float(np.linalg.norm(right))
    attracts = bool((np.delete(eigenvalues.real + error, which) < 0).all())
    return Saddle(place, float(eigenvalues[which].real), right / size, left * size, attracts)


def decay_at(system: System, state: FloatArray) -> float:
    """−max Re λ of an equilibrium; 0 unless it is proved to attract."""
    eigenvalues, _, error = _spectrum(system.linearization(state))
    return float(-eigenvalues.real.max()) if (eigenvalues.real + error < 0).all() else 0.0


def _spectrum(matrix: FloatArray) -> tuple[Any, Any, FloatArray]:
    """Eigenvalues with their vectors and errors: by how much more than the matrix each moves; infinite for a double one."""
    eigenvalues, vectors = np.linalg.eig(matrix)
    try:
        moves = np.linalg.norm(np.linalg.inv(vectors), axis=1) * np.linalg.norm(vectors, axis=0)
    except np.linalg.LinAlgError:
        moves = np.full(len(vectors), np.inf)
    return eigenvalues, vectors, np.asarray(rounding_of(matrix) * moves)


def growth_of_cycle(cycle: Cycle) -> float | None:
    """ln μ / T of the one multiplier beyond the unit circle; None unless it is proved that there is one, and one only."""
    sizes, error = np.abs(cycle.multipliers[1:]), cycle.multiplier_errors
    which = int(np.argmax(sizes))
    if not sizes[which] - error[which] > 1 or not (np.delete(sizes + error, which) < 1).all():
        return None
    return float(np.log(sizes[which]) / cycle.period)


@dataclass(frozen=True)
class Rest:
    """Equilibria, fixed points of the map that adds to a state its rates; ``mode`` is kept where it is given."""

    field: Field
    mode: Mode | None = None

    def started(self, system: System, state: FloatArray, index: int, span: float) -> Point:
        """An equilibrium of a system as a point from which it is followed in one parameter."""
        setting = Setting(replace(system.flow, other=self.fly), (index,), 1.0, (span,), event=_of_one_time)
        return started(setting, Guess(state[None], 1.0, system.values))

    def at(self, state: FloatArray, constants: tuple[float, ...]) -> tuple[list[float], tuple[float, ...], Mode]:
        """State, constants and mode, whose last numbers go with the place."""
        numbers = state.tolist()
        own = self.field.initial_mode(numbers, constants)
        kept = len(own) - self.field.ways
        return numbers, constants, (self.mode or own)[:kept] + own[kept:]

    def fly(self, state: FloatArray, constants: tuple[float, ...], _: float, directions: FloatArray) -> Passage:
        """The map with its derivatives."""
        there, by_parameters = self.at(state, constants), np.zeros((self.field.size, 2))
        n = len(self.field.coordinates)
        try:
            force = self.field.acceleration(*there, math)
            by_state = np.eye(self.field.size) + self.field.matrix(*there)
            by_parameters[n:] = np.array(self.field.by_parameters(*there, math), dtype=float) @ directions.T
        except ArithmeticError as error:
            raise ConvergenceError("there is no motion") from error
        return Passage(state + np.append(state[n:], force), by_state, by_parameters, (), ())

    def eigenvalues(self, point: Point) -> list[complex]:
        """Eigenvalues of the linearized motion."""
        there = self.at(point.loop.states[0], point.loop.constants)
        return [complex(value) for value in np.linalg.eigvals(self.field.matrix(*there))]

    def pairs(self, point: Point) -> float:
        """Product of the sums of all pairs of eigenvalues, each over its size: 0 where a pair is ± i ω."""
        pairs = combinations(self.eigenvalues(point), 2)
        return float(math.prod((one + other) / (abs(one) + abs(other) or 1.0) for one, other in pairs).real)

    def inside(self, point: Point) -> bool:
        """Whether a state is on this side of all kinks; the field jumps at the end of a torsion spring, or is smooth."""
        state, constants, mode = self.at(point.loop.states[0], point.loop.constants)
        kinks = (border for border in self.field.borders if border.kink and border.jumps is None)
        return all(border.sign(mode) * border.level(state, constants, mode) >= -2 * GAP for border in kinks)


def _of_one_time(setting: Setting, near: Loop, _: FloatArray) -> Conditions:
    """An equilibrium has no period: it stays 1."""
    row = np.eye(1, len(near.guess.coordinates(setting.free)), near.states.size)
    return lambda loop: (np.array([loop.period - 1.0]), row)
