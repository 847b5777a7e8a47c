"""What a motion comes to: one classifier for trajectories, sweeps and basins.

A motion is judged by the limit that it approaches and by the rate at which it does, never by how alike two parts
of a window look: lift-off for good in a well of the energy (:mod:`.lift_off`), rest at an equilibrium by its
linearization (:mod:`.rest`), and cycles by the closed orbit itself and its multipliers (:mod:`.cycles`), in this order.
"""

from __future__ import annotations

from .course import Course
from .cycles import on_cycle
from .flows import Onward
from .lift_off import lifted_for_good
from .problem import Problem
from .regimes import SETTLED, Outcome, Regime
from .rest import at_rest


def classify(course: Course, problem: Problem, onward: Onward, tol: float = SETTLED) -> Outcome:
    """The outcome of a motion, from what was measured of it.

    Parameters
    ----------
    course : Course
        The motion after its transient.
    problem : Problem
        Its constants and tolerance.
    onward : Onward
        How it goes on from any state.
    tol : float
        What may be left to the limit of a settled motion.

    Returns
    -------
    Outcome
        Without ``equilibrium``, which :func:`~spragsym.dynamics.rest.index_of` finds for many at once.
    """
    if lifted_for_good(course, problem):
        return Outcome(Regime.LIFT_OFF)
    return at_rest(course, problem, tol) or on_cycle(course, problem, onward, tol) or Outcome()
