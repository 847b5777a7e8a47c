"""What a motion comes to: one classifier for trajectories, sweeps and basins.

A motion is judged by the limit that it approaches and by the rate at which it does, never by how alike two parts
of a window look: lift-off for good in a well of the energy (:mod:`.lift_off`), rest at an equilibrium by its
linearization (:mod:`.rest`), and cycles by the closed orbit itself and its multipliers (:mod:`.cycles`), in this order.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from ..errors import ConvergenceError
from . import flows
from .cycles import FEWEST, on_cycle
from .flows import Onward
from .lift_off import is_lifted, lifted_for_good, wells_of
from .measures import Course
from .motions import Measured, Motions
from .problem import Problem
from .regimes import SETTLED, Outcome, Regime
from .rest import at_rest, is_still


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
        Without ``equilibrium``, which :func:`~spragsym.dynamics.rest.rest_index` finds for many at once.
    """
    if lifted_for_good(course, problem):
        return Outcome(Regime.LIFT_OFF)
    return at_rest(course, problem, tol) or on_cycle(course, problem, onward, tol) or Outcome()


def classified(
    measured: Measured, motions: Motions, backend: str, tol: float = SETTLED
) -> Iterator[tuple[int, Outcome | Exception]]:
    """Outcomes of many motions, with their rows; those that are left out are the plain ``Outcome()``, or have stopped.

    Most short motions are: they hardly turn. They are told by what every other regime asks for first.
    """
    extent, moved = measured.high - measured.low, measured.last[:, 0] - measured.first[:, 0]
    lifted = is_lifted(measured.last, measured.events) if motions.starts.shape[1] > 2 else np.zeros(len(motions), dtype=bool)
    known = wells_of(motions, np.flatnonzero(lifted).tolist())
    lifted[:] = False
    lifted[[row for row, found in known.items() if found]] = True
    for row in np.flatnonzero(lifted | (measured.maxima >= FEWEST) | is_still(moved, extent, tol)).tolist():
        problem = replace(motions.problem(row), wells=known.get(row))
        try:
            yield row, classify(measured.course(row), problem, flows.onward(problem, backend), tol)
        except (ConvergenceError, ArithmeticError) as error:
            yield row, error
