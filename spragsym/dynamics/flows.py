"""How a motion goes on, with derivatives of its flow: which integrator carries them."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

from ..errors import ConvergenceError
from ..parameters import FloatArray
from . import integrators, variations_heyoka, variations_scipy
from .closed import OPEN, ROUGH, Closed, by_differences, closed_orbit, nearly_closed
from .course import Courses
from .field import Field
from .passage import Fly
from .problem import Problem
from .shooting import CLOSED
from .sprag import REACH

#: Tolerances of flows that closed orbits are found with: for differences that stand for derivatives, and as fine as heyoka goes.
FINE, FINEST = 1e-12, 1e-15


def flow(field: Field, backend: str, derivatives: bool = True) -> Any:
    """An integrator of a field: it has ``fly`` and ``sample``."""
    return variations_heyoka.compiled(field, derivatives) if backend == "heyoka" else variations_scipy.flight(field, derivatives)


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
    roughly : callable
        ``roughly(state, period, reach)``: the closed orbit near a state where x' = 0, to some digits: its state, its period, and
        the derivative of one round.
    closed : callable
        ``closed(state, period, reach)``: the same to all digits.
    """

    courses: Courses
    roughly: Callable[[FloatArray, float, float], tuple[FloatArray, float, FloatArray]]
    closed: Callable[[FloatArray, float, float], Closed]


def onward(problem: Problem, backend: str) -> Onward:
    """How the motion of a problem goes on, by the integrator that carries it."""

    courses, ends = integrators.flows(problem, backend)

    def roughly(state: FloatArray, period: float, reach: float) -> tuple[FloatArray, float, FloatArray]:
        loop = nearly_closed(field(), ends, state, period, reach, ROUGH)
        return loop.guess.states[0], loop.guess.period, loop.monodromy

    def field() -> Field:
        return replace(problem.field_of(REACH), constants=lambda *_: problem.constants)

    def closed(state: FloatArray, period: float, reach: float) -> Closed:
        if backend == "scipy":
            return closed_orbit(field(), variations_scipy.Flight(field()).fly, state, period, reach, CLOSED)
        rtol, precision = (FINEST, CLOSED) if backend == "heyoka" else (FINE, OPEN)
        fine, fine_ends = integrators.flows(replace(problem, rtol=min(problem.rtol, rtol)), backend)
        # Most of Newton's steps by the plain flow: derivatives cost many times as much. Where differences fail it is all of them.
        with suppress(ConvergenceError):
            near = nearly_closed(field(), fine_ends, state, period, reach, precision).guess
            state, period = near.states[0], near.period
        fly = variations_heyoka.compiled(field(), directions=0).fly if backend == "heyoka" else by_differences(field(), fine)
        return closed_orbit(field(), fly, state, period, reach, precision)

    return Onward(courses, roughly, closed)
