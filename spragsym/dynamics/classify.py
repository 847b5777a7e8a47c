"""What a motion comes to: one classifier for trajectories, sweeps and basins.

A motion is judged by the limit that it approaches and by the rate at which it does, never by how alike two parts
of a window look: lift-off for good in a well of the energy (:mod:`.lift_off`), rest at an equilibrium by its
linearization (:mod:`.rest`), and cycles as fixed points of a return map (:mod:`.cycles`), in this order.
"""

from __future__ import annotations

from .course import Course, Flow
from .cycles import on_cycle
from .lift_off import lifted_for_good
from .problem import Problem
from .regimes import SETTLED, Outcome, Regime
from .rest import at_rest


def classify(course: Course, problem: Problem, flow: Flow, tol: float = SETTLED) -> Outcome:
    """The outcome of a motion, from what was measured of it.

    Parameters
    ----------
    course : Course
        The motion after its transient.
    problem : Problem
        Its constants and tolerance.
    flow : callable
        ``flow(state, duration)`` goes on from any state, and gives the Course.
    tol : float
        What may be left to the limit of a settled motion.

    Returns
    -------
    Outcome
        Without ``equilibrium``, which :func:`~spragsym.dynamics.rest.index_of` finds for many at once.
    """
    if lifted_for_good(course, problem):
        return Outcome(Regime.LIFT_OFF)
    return at_rest(course, problem, tol) or on_cycle(course, problem, flow, tol) or Outcome()
