"""How a motion goes on, and the periodic orbit near it with the derivative of its return map, by Newton's method."""

from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from ..errors import ConvergenceError
from ..models.field import REACH, Field
from ..models.parameters import FloatArray
from . import batch_heyoka, integrators
from .flows import Flow
from .measures import Course
from .problem import Problem
from .segment import Fly, Passage, Turn
from .shooting import CLOSED, Guess, Loop, once_round, rate, solved, through
from .with_heyoka import taylor_of
from .with_scipy import Flight

#: Tolerances of flows that closed orbits are found with: where differences stand for derivatives, and the finest of heyoka.
FINE, FINEST = 1e-12, 1e-15

#: Differences of a flow are taken over this; by how much an orbit that is found with them may stay open.
STEP, OPEN = 1e-5, 1e-9

#: For each integrator the tolerance of its plain flow, how nearly orbits close by cheap derivatives, and how closely in the end.
PRECISIONS = {"heyoka": (FINEST, CLOSED, CLOSED), "compiled": (FINE, OPEN, OPEN), "scipy": (FINE, OPEN, CLOSED)}


@dataclass(frozen=True)
class Closed:
    """A closed orbit by its state (2 n,) on a section, all over which the number at the place ``fixed`` has one value.

    The ``slope``, (2 n − 1, 2 n − 1), is the derivative of the return in the other numbers; its eigenvalues are the multipliers.
    """

    state: FloatArray
    period: float
    slope: FloatArray
    fixed: int


def section(states: FloatArray, fixed: int) -> FloatArray:
    """States of a section without the number that is ``fixed`` there: x, y, y' for two coordinates where x' = 0."""
    return np.delete(states, fixed, axis=-1)


@dataclass(frozen=True)
class Onward:
    """How the motion of a problem goes on from any state, by an integrator."""

    problem: Problem
    backend: str

    @property
    def field(self) -> Field:
        """The field of the motion, with its own constants."""
        return replace(self.problem.field_of(REACH), constants=lambda *_: self.problem.constants)

    def _motions(self, states: FloatArray, duration: float) -> list[Problem]:
        return [replace(self.problem, start=tuple(state), t_end=duration, t_record=0.0) for state in states.tolist()]

    def courses(self, states: FloatArray, duration: float) -> list[Course]:
        """What is measured on the way from each of many states; an error where one of them cannot be continued."""
        courses = list[Course]()
        for course in integrators.measure(self._motions(states, duration), self.backend):
            if isinstance(course, Exception):
                raise course
            courses.append(course)
        return courses

    def ends(self, states: FloatArray, duration: float) -> FloatArray:
        """Final states of the motions from many states."""
        if self.backend == "heyoka":
            return batch_heyoka.ends(self._motions(states, duration))
        return np.array([course.last for course in self.courses(states, duration)])

    def _forward(self, state: FloatArray, _: object, duration: float, __: object) -> Passage:
        """``fly`` by forward differences of the plain flow."""
        last, *others = self.ends(np.vstack([state, state + STEP * np.eye(state.size)]), duration)
        return Passage(last, (np.array(others) - last).T / STEP, np.zeros((state.size, 2)), (), ())

    def _central(self, state: FloatArray, _: object, duration: float, __: object) -> Passage:
        """``fly`` by central differences of the plain flow; crossings are not reported."""
        m, off = state.size, STEP * np.eye(state.size)
        course, *others = self.courses(np.vstack([state, state + off, state - off]), duration)
        last = np.array([other.last for other in others])
        unknown = np.full((m, m), np.nan), np.full((m, 2), np.nan)
        turns = [Turn(t, -1, -1, top, *unknown) for t, top in zip(course.maxima_t.tolist(), course.maxima, strict=True)]
        return Passage(course.last, (last[:m] - last[m:]).T / (2 * STEP), np.zeros((m, 2)), (), tuple(turns))

    def _near(self, fly: Fly, state: FloatArray, fixed: int, period: float, reach: float, precision: float) -> Loop:
        """The closed orbit to a precision that begins on the section of a state."""
        on_section = through(state, np.eye(state.size)[fixed], state.size + 1)
        flow, guess = Flow(self.field, self.backend, fly), Guess(state[None], period, ())
        return solved(flow, guess, on_section, reach=reach, precision=precision, closed=precision)

    def closed(self, state: FloatArray, fixed: int, period: float, reach: float) -> Closed:
        """The closed orbit to all digits, with the derivative of its return; ConvergenceError without one within ``reach``."""
        rtol, near, precision = PRECISIONS[self.backend]
        fine = Onward(replace(self.problem, rtol=min(self.problem.rtol, rtol)), self.backend)
        # Most of Newton's steps by the plain flow: derivatives cost many times as much. Where that fails, all steps have them.
        with suppress(ConvergenceError):
            guess = fine._near(fine._forward, state, fixed, period, reach, near).guess
            state, period = guess.states[0], guess.period
        fly: Fly = fine._central
        if self.backend != "compiled":
            fly = (taylor_of if self.backend == "heyoka" else Flight)(self.field, directions=0).fly
        try:
            loop = once_round(self._near(fly, state, fixed, period, reach, precision))
        except (OverflowError, ValueError) as error:
            raise ConvergenceError("Newton's method left the range of numbers") from error
        place = loop.states[0]
        flow = rate(self.field, place, loop.constants)
        if flow[fixed] == 0:
            raise ConvergenceError("the orbit does not pass through the section")
        back = np.eye(place.size)
        back[:, fixed] -= flow / flow[fixed]  # along the flow to the section again
        slope = section(section(back @ loop.monodromy, fixed).T, fixed).T
        return Closed(place, loop.period, slope, fixed)
