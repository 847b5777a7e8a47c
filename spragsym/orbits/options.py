"""Options of branches of cycles."""

from __future__ import annotations

from dataclasses import dataclass

from ..core.options import Options, option


@dataclass(frozen=True)
class BranchOptions(Options):
    """Options of pseudo-arclength continuation of closed orbits.

    Steps are measured in arclength, with the units: states in those of the motion, the period of
    the first orbit, and half the parameter's range.

    Parameters
    ----------
    first_step, longest_step, shortest_step : float
        First and longest step. The branch ends if a step shorter than the last one is needed.
    kink : float
        A bend within this length counts as a kink of the branch, which shorter steps do not
        resolve.
    straight : float
        Smallest cosine of the angle between a step and the tangents at its ends.
    straighter : float
        Steps grow faster if this cosine is above ``straighter``.
    move : float
        Largest change of the states in one step.
    share : float
        Largest change of the states in one step, relative to the orbit's extent. It keeps Newton's
        method from converging to an equilibrium, which is a closed orbit of any period.
    vanished : float
        An orbit has shrunk onto an equilibrium if its extent, itself and relative to that of the
        first orbit, is below this.
    shrunk : float
        The same limit of the relative extent at a fold of the branch.
    long_period : float
        A branch ends as homoclinic if its period exceeds so many periods of the first orbit, and
        the orbit comes to rest at some place.
    still : float
        An orbit comes to rest where its rate is below this.
    event_step : float
        A step with an event that cannot be located is shortened down to this length.
    located : float
        Accuracy in arclength with which an event is located.
    meeting : float
        A doubled orbit meets the cycle of half its period if the distance of its halves, relative
        to its extent, is below this.
    scatter : float
        Safety factor: how much the scatter of an event's location, computed from a few orbits,
        contributes to its error.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> found = ss.cycle(ss.Parameters.article(theta0=np.radians(42)), V=0.5, d=10.0)
    >>> options = ss.BranchOptions(longest_step=0.02)
    >>> over = {"theta0": np.radians([41.9, 42.1])}
    >>> branch = ss.cycle_branch(found, "theta0", between=over, options=options)
    >>> len(branch.values) > 80
    True
    """

    first_step: float = option(0.004, 1e-15)
    longest_step: float = option(0.08, 1e-15)
    shortest_step: float = option(1e-9, 1e-15)
    kink: float = option(1e-6, 0.0)
    straight: float = option(0.97, 0.0, 1.0)
    straighter: float = option(0.995, 0.0, 1.0)
    move: float = option(0.5, 1e-12)
    share: float = option(0.3, 1e-12, 1.0)
    vanished: float = option(1e-3, 1e-12, 1.0)
    shrunk: float = option(0.1, 1e-12, 1.0)
    long_period: float = option(6.0, 1.0)
    still: float = option(2e-3, 0.0)
    event_step: float = option(1e-5, 1e-12)
    located: float = option(1e-11, 1e-15)
    meeting: float = option(1e-3, 0.0, 1.0)
    scatter: float = option(10.0, 1.0)
