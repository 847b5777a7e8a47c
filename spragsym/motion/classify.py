"""Classification of the limit of a motion, for trajectories, sweeps and basins.

A motion is judged by the limit that it approaches and by the rate at which it does, never by how alike two parts
of a window look: lift-off for good where the model knows it, rest at an equilibrium by its
linearization (:mod:`.rest`), and cycles by the closed orbit itself and its multipliers (:mod:`.cycles`), in this order.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ConvergenceError
from ..models.field import SETTLED, TURN
from .measures import Course
from .motions import Measured, Motions
from .periodic_orbit import Onward
from .problem import Event, Problem
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
    measured: Measured, motions: Motions, backend: str, tol: float = SETTLED
) -> Iterator[tuple[int, Outcome | Exception]]:
    """Outcomes of many motions, with their rows; those that are left out are the plain ``Outcome()``, or have stopped.

    Most short motions are: they hardly turn. They are told by what every other regime asks for first.
    """
    extent, moved = measured.high - measured.low, measured.last[:, 0] - measured.first[:, 0]
    aloft = keeps_apart(measured.events)
    aloft[aloft] = motions.field.aloft(motions.constants[aloft], measured.last[aloft])
    for row in np.flatnonzero(aloft).tolist():
        yield row, Outcome(Regime.LIFT_OFF, names=motions.field.components)
    turning = (0 in motions.field.around) & (np.abs(moved) > FEWEST * TURN)
    for row in np.flatnonzero(~aloft & ((measured.maxima >= FEWEST) | turning | is_still(moved, extent, tol))).tolist():
        problem = motions.problem(row)
        try:
            yield row, classify(measured.course(row), problem, Onward(problem, backend), tol)
        except (ConvergenceError, ArithmeticError) as error:
            yield row, error
