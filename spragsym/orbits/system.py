"""A model at values of its parameters, with an integrator: its motions, and its equilibria by Newton's method."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..models.field import Field
from ..models.parameters import FloatArray, ParameterSet
from ..motion import Trajectory
from ..motion.flows import Flow
from ..motion.rest import equilibrium_near
from ..motion.simulation import motion_of
from ..questions import model_of


def differences(function: Callable[[FloatArray], FloatArray], place: FloatArray, step: Any) -> FloatArray:
    """Central differences of a function by each number of a place, along the last axis."""
    ways = np.eye(len(place)) * step
    return np.stack([(function(place + way) - function(place - way)) / (2 * way.max()) for way in ways], axis=-1)


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
