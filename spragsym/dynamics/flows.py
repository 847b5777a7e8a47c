"""How a motion goes on, with derivatives of its flow: which integrator carries them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

from ..parameters import FloatArray
from . import integrators, variations_heyoka, variations_scipy
from .closed import OPEN, ROUGH, Closed, by_differences, closed_orbit, nearly_closed
from .course import Courses
from .field import Field
from .passage import Fly
from .problem import Problem
from .shooting import CLOSED
from .sprag import REACH

#: Tolerance of flows whose differences are taken, by heyoka's method and by others, and by how much an orbit may stay open.
FINE = {"heyoka": (1e-15, CLOSED)}
FINE_ELSE = (1e-12, OPEN)


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
    closed : callable
        ``closed(state, period, reach)``: the closed orbit near a state where x' = 0.
    """

    courses: Courses
    closed: Callable[[FloatArray, float, float], Closed]


def onward(problem: Problem, backend: str) -> Onward:
    """How the motion of a problem goes on, by the integrator that carries it."""

    courses, ends = integrators.flows(problem, backend)

    def closed(state: FloatArray, period: float, reach: float) -> Closed:
        field = replace(problem.field_of(REACH), constants=lambda *_: problem.constants)
        state, period = nearly_closed(field, ends, state, period, reach, ROUGH)
        if backend == "scipy":
            return closed_orbit(field, variations_scipy.Flight(field).fly, state, period, reach, CLOSED)
        rtol, precision = FINE.get(backend, FINE_ELSE)
        fine, there = integrators.flows(replace(problem, rtol=min(problem.rtol, rtol)), backend)
        state, period = nearly_closed(field, there, state, period, reach, precision)
        return closed_orbit(field, by_differences(field, fine), state, period, reach, precision)

    return Onward(courses, closed)
