"""Classification of the limit of a motion, for trajectories, sweeps and basins.

A motion is judged by the limit that it approaches and by the rate at which it does, never by how alike two parts
of a window look: lift-off for good where the model knows it, rest at an equilibrium by its
linearization (:mod:`.rest`), and cycles by the closed orbit itself and its multipliers (:mod:`.cycles`), in this order.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ConvergenceError
from ..models.field import SETTLED, TURN
from .measures import Course
from .periodic_orbit import Onward
from .problem import Event, Motions, Problem
from .regimes import Outcome, Regime
from .rest import at_rest, is_still
from .return_map import FEWEST, on_cycle


def classify(course: Course, problem: Problem, onward: Onward, tol: float = SETTLED) -> Outcome:
    """The outcome of a motion, from what was measured of it after its transient, and how it goes on.

    ``tol`` is what may be left to the limit of a settled motion. The outcome is without ``equilibrium``, which
    :func:`~spragsym.statics.search.rest_index` finds for many at once.
    """
    stays = keeps_apart(course.events) and problem.field.aloft(np.array([problem.constants]), course.last[None])[0]
    if stays:
        found = Outcome(Regime.LIFT_OFF)
    else:
        found = at_rest(course, problem, tol) or on_cycle(course, problem, onward, tol) or Outcome()
    return replace(found, names=problem.field.components)


def keeps_apart(events: NDArray[np.intp]) -> Any:
    """Whether motions have neither lost contact nor regained it; events along the last axis."""
    return ~events[..., [Event.CONTACT_LOST, Event.CONTACT_REGAINED]].any(axis=-1)


def classified(
    found: Sequence[Course | Exception], motions: Motions, backend: str, tol: float = SETTLED
) -> Iterator[tuple[int, Outcome | Exception]]:
    """Outcomes of many motions, with their rows; those that are left out are the plain ``Outcome()``, or have stopped.

    Most short motions are: they hardly turn. They are told by what every other regime asks for first.
    """
    courses = {row: course for row, course in enumerate(found) if not isinstance(course, Exception)}
    apart = [row for row, course in courses.items() if keeps_apart(course.events)]
    aloft: Any = motions.field.aloft(motions.constants[apart], np.array([courses[row].last for row in apart])) if apart else []
    for row in (row for row, up in zip(apart, aloft, strict=True) if up):
        yield row, Outcome(Regime.LIFT_OFF, names=motions.field.components)
        del courses[row]
    for row, course in courses.items():
        moved = float(course.last[0] - course.first[0])
        turning = 0 in motions.field.around and abs(moved) > FEWEST * TURN
        if len(course.maxima) >= FEWEST or turning or is_still(moved, course.reach[1] - course.reach[0], tol):
            problem = motions.problem(row)
            try:
                yield row, classify(course, problem, Onward(problem, backend), tol)
            except (ConvergenceError, ArithmeticError) as error:
                yield row, error
