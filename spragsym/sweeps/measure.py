"""What is measured of one motion of a sweep, or why there is nothing to measure."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from ..dynamics import flows, integrators
from ..dynamics.classify import classify
from ..dynamics.course import Course
from ..dynamics.lift_off import wells
from ..dynamics.problem import MAX_STEPS, Problem, check_start, constants_of, out_of_range
from ..errors import ConvergenceError, ParameterError
from ..files.journal import Record
from ..parameters import NAMES, Parameters

#: What is measured of every motion after its transient.
AVERAGES = ("rms", "spread", "amplitude", "mean", "mean_y", "contact_lost", "slip_reversed")

#: What a record says, after those, about the limit of the motion.
LIMITS = ("period", "rate", "distance", "cycle_mean", "cycle_rms", "cycle_x", "cycle_y", "cycle_vy")

#: Numbers that a file and a result hold.
REPORTED = (*AVERAGES, *LIMITS)

#: A record holds these numbers, then the code of the regime and the place of the equilibrium.
MEASURED = (*REPORTED, "regime", "rest_x", "rest_y")

INPUTS = (*NAMES, "V", "d", "x0", "y0", "vx0", "vy0")


@dataclass(frozen=True)
class Settings:
    """What all motions of a sweep share."""

    t_end: float
    transient: float
    rtol: float
    backend: str
    max_steps: int = MAX_STEPS


#: The motion of a point whose values were validated with the whole sweep's; to be sent to other processes.
ProblemOf: TypeAlias = Callable[[Settings, tuple[Any, ...]], Problem]


def measured(problem_of: ProblemOf, settings: Settings, point: tuple[Any, ...]) -> Record:
    """One record. What the motion itself makes impossible is its reason; whatever else goes wrong is raised."""
    try:
        problem = problem_of(settings, point)
    except ParameterError as error:  # arrays were validated before: what is left is a start at the anchor
        return _no_result(error)
    try:
        with np.errstate(all="ignore"):  # numbers out of range show in the result
            values = _values(problem, settings.backend)
    except ConvergenceError as error:
        return _no_result(error)
    except ArithmeticError:
        return _no_result(out_of_range())
    needed = [value for name, value in zip(AVERAGES, values, strict=False) if name != "mean_y" or len(problem.start) > 2]
    if not np.isfinite(needed).all():
        return _no_result(out_of_range())
    return values, ""


def _no_result(error: Exception) -> Record:
    return [], f"{type(error).__name__}: {' '.join(str(error).split())}"


def article_problem(settings: Settings, point: tuple[Any, ...]) -> Problem:
    """The motion of a point of the article's model: its inputs, and its wells above the belt where they are known."""
    *parameters, V, d, x0, y0, vx0, vy0 = point[: len(INPUTS)]
    check_start(parameters[0], x0, y0)
    constants, known = constants_of(tuple(parameters), V, d), point[len(INPUTS) :]
    return Problem(
        constants, (x0, y0, vx0, vy0), settings.t_end, settings.transient, settings.rtol, settings.max_steps,
        wells=known[0] if known else None,
    )  # fmt: skip


def article_wells(points: list[tuple[float, ...]]) -> list[tuple[Any, ...]]:
    """What points of the article's model are told besides their inputs: all wells at once."""
    if not points:
        return []
    values = np.array(points).T
    return [(known,) for known in wells(Parameters(**dict(zip(NAMES, values, strict=False))))]


def _values(problem: Problem, backend: str) -> list[float]:
    """The measured values of a motion, in the order of MEASURED."""
    course = integrators.measure(problem, backend)
    outcome = classify(course, problem, flows.onward(problem, backend))
    return [*_averages(course), *(float(getattr(outcome, name)) for name in MEASURED[len(AVERAGES) :])]


def _averages(course: Course) -> list[float]:
    """The measured values after the transient, in the order of AVERAGES."""
    mean, spread = course.moments()
    amplitude = max(map(abs, course.x_extrema.tolist()))
    mean_y = float(course.integrals[-1, 2]) / (course.end - course.begin) if len(course.first) > 2 else math.nan
    lost, _, *reversals = course.events.tolist()
    return [math.hypot(mean, spread), spread, amplitude, mean, mean_y, lost, sum(reversals)]
