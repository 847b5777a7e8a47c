"""Flows with derivatives: the integrator that carries them."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..errors import ConvergenceError
from ..models.field import REACH, Field
from ..models.parameters import FloatArray
from . import batch_heyoka, integrators
from .measures import Course
from .motions import Motions
from .periodic_orbit import Closed, closed_orbit, nearly_closed
from .problem import Problem, StiffError
from .segment import Fly, Passage, Turn
from .shooting import CLOSED, Loop
from .solution import Solution
from .with_heyoka import taylor_of
from .with_scipy import IMPLICIT, Flight

#: Tolerances of flows that closed orbits are found with: where differences stand for derivatives, and the finest of heyoka.
FINE, FINEST = 1e-12, 1e-15

#: Differences of a flow are taken over this; by how much an orbit that is found with them may stay open, at first and in the end.
STEP, ROUGH, OPEN = 1e-5, 1e-4, 1e-9

#: Tolerance by which SciPy follows a motion to where Newton's method can begin.
LOOSE = 1e-9

#: For each integrator the tolerance of its plain flow, how nearly orbits close by cheap derivatives, and how closely in the end.
PRECISIONS = {"heyoka": (FINEST, CLOSED, CLOSED), "compiled": (FINE, OPEN, OPEN), "scipy": (FINE, OPEN, CLOSED)}


def flow(field: Field, backend: str, derivatives: bool = True) -> Any:
    """An integrator of a field: it has ``fly`` and ``motion``."""
    return taylor_of(field, derivatives) if backend == "heyoka" else Flight(field, derivatives)


def motion_of_flow(field: Field, backend: str, start: FloatArray, constants: tuple[float, ...], t_end: float) -> Solution:
    """A motion by its samples; by an implicit method where steps collapse."""
    try:
        solution: Solution = flow(field, backend, derivatives=False).motion(start, constants, t_end)
    except StiffError:
        solution = Flight(field, False, 0, IMPLICIT, stiff=True).motion(start, constants, t_end)
    return solution


def follower(field: Field, backend: str) -> Any:
    """An integrator of a field without derivatives, for following a motion to where Newton's method can begin."""
    return Flight(field, False, rtol=LOOSE) if backend == "scipy" else flow(field, backend, derivatives=False)


def carrier(field: Field, backend: str | None) -> tuple[Fly, str]:
    """``fly`` of an integrator, and the integrator's name."""
    name = integrators.choose(backend, integrators.OF_ANY_MODEL)
    fly: Fly = flow(field, name).fly
    return fly, name


@dataclass(frozen=True)
class Onward:
    """How the motion of a problem goes on from any state, by an integrator."""

    problem: Problem
    backend: str

    @property
    def field(self) -> Field:
        """The field of the motion, with its own constants."""
        return replace(self.problem.field_of(REACH), constants=lambda *_: self.problem.constants)

    def _motions(self, states: FloatArray, duration: float) -> Motions:
        one = Motions.of([self.problem])
        return replace(one, constants=one.constants[[0] * len(states)], starts=states, t_end=duration, t_record=0.0)

    def courses(self, states: FloatArray, duration: float) -> list[Course]:
        """What is measured on the way from each of many states; an error where one of them cannot be continued."""
        found = integrators.measure(self._motions(states, duration), self.backend)
        for error in found.errors.values():
            raise error
        return [found.course(row) for row in range(len(states))]

    def ends(self, states: FloatArray, duration: float) -> FloatArray:
        """Where they end."""
        if self.backend == "heyoka":
            return batch_heyoka.ends(self._motions(states, duration))
        return np.array([course.last for course in self.courses(states, duration)])

    def _forward(self, state: FloatArray, _: Any, duration: float, __: Any) -> Passage:
        """``fly`` by forward differences of the plain flow."""
        last, *others = self.ends(np.vstack([state, state + STEP * np.eye(state.size)]), duration)
        return Passage(last, (np.array(others) - last).T / STEP, np.zeros((state.size, 2)), (), ())

    def _central(self, state: FloatArray, _: Any, duration: float, __: Any) -> Passage:
        """``fly`` by central differences of the plain flow; crossings are not reported."""
        m, off = state.size, STEP * np.eye(state.size)
        course, *others = self.courses(np.vstack([state, state + off, state - off]), duration)
        last = np.array([other.last for other in others])
        unknown = np.full((m, m), np.nan), np.full((m, 2), np.nan)
        turns = [Turn(t, -1, -1, top, *unknown) for t, top in zip(course.maxima_t.tolist(), course.maxima, strict=True)]
        return Passage(course.last, (last[:m] - last[m:]).T / (2 * STEP), np.zeros((m, 2)), (), tuple(turns))

    def roughly(self, state: FloatArray, fixed: int, period: float, reach: float, precision: float = ROUGH) -> Loop:
        """The closed orbit near a state of a section, where the number at the place ``fixed`` has its value, to some digits."""
        return nearly_closed(self.field, self._forward, state, fixed, period, reach, precision)

    def closed(self, state: FloatArray, fixed: int, period: float, reach: float) -> Closed:
        """The same to all digits."""
        rtol, near, precision = PRECISIONS[self.backend]
        fine = Onward(replace(self.problem, rtol=min(self.problem.rtol, rtol)), self.backend)
        # Most of Newton's steps by the plain flow: derivatives cost many times as much. Where that fails, all steps have them.
        with suppress(ConvergenceError):
            guess = fine.roughly(state, fixed, period, reach, near).guess
            state, period = guess.states[0], guess.period
        fly: Fly = fine._central
        if self.backend != "compiled":
            fly = (taylor_of if self.backend == "heyoka" else Flight)(self.field, directions=0).fly
        return closed_orbit(self.field, fly, state, fixed, period, reach, precision)
