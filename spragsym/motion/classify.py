"""Classification of the limit of a motion, for trajectories, sweeps and basins.

A motion is judged by the limit that it approaches and by the rate at which it does, never by how alike two parts
of a window look: lift-off for good where the model knows it, rest at an equilibrium by its
linearization (:mod:`.rest`), and cycles by the closed orbit itself and its multipliers (:mod:`.cycles`), in this order.
"""

from dataclasses import replace

from ..models.field import SETTLED
from .measures import Course
from .periodic_orbit import Onward
from .problem import Event, Problem
from .regimes import Outcome, Regime
from .rest import at_rest
from .return_map import on_cycle


def classify(course: Course, problem: Problem, onward: Onward, tol: float = SETTLED) -> Outcome:
    """The outcome of a motion, from what was measured of it after its transient, and how it goes on.

    ``tol`` is what may be left to the limit of a settled motion. The outcome is without ``equilibrium``, which
    :func:`~spragsym.statics.search.rest_index` finds for many at once.
    """
    apart = not course.events[[Event.CONTACT_LOST, Event.CONTACT_REGAINED]].any()
    if apart and problem.field.aloft and problem.field.aloft(problem.constants, course.last):
        found = Outcome(Regime.LIFT_OFF)
    else:
        found = at_rest(course, problem, tol) or on_cycle(course, problem, onward, tol) or Outcome()
    return replace(found, names=problem.field.components)
