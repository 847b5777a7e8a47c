"""Equilibria of the motion as closed orbits are: followed by pseudo-arclength, with their eigenvalues."""

import math
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from ..errors import ConvergenceError
from ..models.field import GAP, Field, Mode
from ..models.parameters import FloatArray
from ..motion.segment import Passage
from ..motion.shooting import Conditions, Guess, Loop
from .arclength import Point, Setting, started
from .system import System


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
