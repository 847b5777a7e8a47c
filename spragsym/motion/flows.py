"""How a motion goes on, with derivatives of its flow: which integrator carries them."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

from ..errors import ConvergenceError
from ..models.field import REACH, Field
from ..models.parameters import FloatArray
from . import integrators, with_heyoka, with_scipy
from .measures import Courses, Ends
from .periodic_orbit import OPEN, ROUGH, Closed, by_differences, by_forward_differences, closed_orbit, nearly_closed
from .problem import Problem
from .segment import Fly
from .shooting import CLOSED

#: Tolerances of flows that closed orbits are found with: where differences stand for derivatives, and the finest of heyoka.
FINE, FINEST = 1e-12, 1e-15

#: Tolerance by which SciPy follows a motion to where Newton's method can begin.
LOOSE = 1e-9

#: For each integrator the tolerance of its plain flow, how nearly orbits close by cheap derivatives, and how closely in the end.
PRECISIONS = {"heyoka": (FINEST, CLOSED, CLOSED), "compiled": (FINE, OPEN, OPEN), "scipy": (FINE, OPEN, CLOSED)}


def flow(field: Field, backend: str, derivatives: bool = True) -> Any:
    """An integrator of a field: it has ``fly`` and ``motion``."""
    return with_heyoka.taylor_of(field, derivatives) if backend == "heyoka" else with_scipy.Flight(field, derivatives)


def follower(field: Field, backend: str) -> Any:
    """An integrator of a field without derivatives, for following a motion to where Newton's method can begin."""
    return with_scipy.Flight(field, False, rtol=LOOSE) if backend == "scipy" else flow(field, backend, derivatives=False)


def carrier(field: Field, backend: str | None) -> tuple[Fly, str]:
    """``fly`` of an integrator, and the integrator's name."""
    name = integrators.choose(backend, integrators.OF_ANY_MODEL)
    fly: Fly = flow(field, name).fly
    return fly, name


@dataclass(frozen=True)
class Onward:
    """How a motion goes on from any state.

    Attributes
    ----------
    courses : callable
        ``courses(states, duration)``: what is measured on the way from each of many states.
    ends : callable
        ``ends(states, duration)``: where they end.
    roughly : callable
        ``roughly(state, fixed, period, reach)``: the closed orbit near a state of a section, where the number at the place
        ``fixed`` has its value, to some digits: its state, its period, and the derivative of one round.
    closed : callable
        ``closed(state, fixed, period, reach)``: the same to all digits.
    """

    courses: Courses
    ends: Ends
    roughly: Callable[[FloatArray, int, float, float], tuple[FloatArray, float, FloatArray]]
    closed: Callable[[FloatArray, int, float, float], Closed]


def onward(problem: Problem, backend: str) -> Onward:
    """How the motion of a problem goes on, by the integrator that carries it."""

    courses, ends = integrators.flows(problem, backend)

    def field() -> Field:
        return replace(problem.field_of(REACH), constants=lambda *_: problem.constants)

    def roughly(state: FloatArray, fixed: int, period: float, reach: float) -> tuple[FloatArray, float, FloatArray]:
        loop = nearly_closed(field(), by_forward_differences(field(), ends), state, fixed, period, reach, ROUGH)
        return loop.guess.states[0], loop.guess.period, loop.monodromy

    def closed(state: FloatArray, fixed: int, period: float, reach: float) -> Closed:
        rtol, near, precision = PRECISIONS[backend]
        fine, fine_ends = integrators.flows(replace(problem, rtol=min(problem.rtol, rtol)), backend)
        # Most of Newton's steps by the plain flow: derivatives cost many times as much. Where that fails, all steps have them.
        with suppress(ConvergenceError):
            guess = nearly_closed(field(), by_forward_differences(field(), fine_ends), state, fixed, period, reach, near).guess
            state, period = guess.states[0], guess.period
        return closed_orbit(field(), derived(fine), state, fixed, period, reach, precision)

    def derived(fine: Courses) -> Fly:
        """The flow with its derivatives."""
        if backend == "heyoka":
            return with_heyoka.taylor_of(field(), directions=0).fly
        if backend == "scipy":
            return with_scipy.Flight(field()).fly
        return by_differences(field(), fine)

    return Onward(courses, ends, roughly, closed)
