"""Measures of one motion of a sweep, or the reason why there are none."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from ...errors import ConvergenceError, ParameterError
from ...files.journal import Record
from ...models.model_field import field_of
from .. import integrators
from ..classify import classify
from ..measures import Course
from ..periodic_orbit import Onward
from ..problem import MAX_STEPS, Problem, check_direction, out_of_range


def reported(coordinates: Sequence[str], rates: Sequence[str]) -> tuple[str, ...]:
    """Numbers that a file and a result hold, by names of the model; a record holds these, then the code of the regime.

    Of the first coordinate after the transient, and means of the others; then about the limit, from ``period`` on: an equilibrium
    by its place, a cycle by one state.
    """
    return (
        "rms", "spread", "largest", "mean", *(f"mean_{name}" for name in coordinates[1:]), "contact_lost", "slip_reversed",
        "period", "rate", "distance", "cycle_mean", "cycle_rms", *(f"rest_{name}" for name in coordinates),
        *(f"cycle_{name}" for name in (*coordinates, *rates)),
    )  # fmt: skip


@dataclass(frozen=True)
class Settings:
    """What all motions of a sweep share."""

    t_end: float
    transient: float
    rtol: float
    backend: str
    max_steps: int = MAX_STEPS


def measured(model: Any, settings: Settings, points: Sequence[tuple[float, ...]]) -> list[Record]:
    """A record each. What a motion itself makes impossible is its reason; whatever else goes wrong is raised."""
    records, problems, count = dict[int, Record](), dict[int, Problem](), len(model.parameters)
    given = settings.t_end, settings.transient, settings.rtol, settings.max_steps, partial(field_of, model)
    for i, point in enumerate(points):
        problems[i] = problem = Problem(model.field.constants(point[:count]), point[count:], *given)
        try:
            check_direction(model, problem.constants, problem.start)
        except ParameterError as error:
            records[i] = _no_result(error)
            del problems[i]
    with np.errstate(all="ignore"):  # numbers out of range show in the result
        courses = integrators.measure(list(problems.values()), settings.backend) if problems else []
        for (i, problem), course in zip(problems.items(), courses, strict=True):
            records[i] = _record(course, problem, settings.backend)
    return [records[i] for i in range(len(points))]


def _record(course: Course | Exception, problem: Problem, backend: str) -> Record:
    if isinstance(course, Exception):
        return _no_result(course)
    values, names, n = _averages(course), problem.field.components, len(problem.field.coordinates)
    if not np.isfinite(values).all():
        return _no_result(out_of_range())
    try:
        outcome = classify(course, problem, Onward(problem, backend))
    except (ConvergenceError, ArithmeticError) as error:
        return _no_result(error)
    told = vars(outcome) | outcome.places()
    of_limit = (told[name] for name in (*reported(names[:n], names[n:])[len(values) :], "regime"))
    return [float(value) for value in (*values, *of_limit)], ""


def _no_result(error: Exception) -> Record:
    error = out_of_range() if isinstance(error, ArithmeticError) else error
    return [], f"{type(error).__name__}: {' '.join(str(error).split())}"


def _averages(course: Course) -> list[float]:
    """The measured values after the transient, in the order of :func:`reported`."""
    mean, spread = course.moments()
    lost, _, *reversals = course.events
    return [math.hypot(mean, spread), spread, max(map(abs, course.reach)), *course.means, lost, sum(reversals)]
