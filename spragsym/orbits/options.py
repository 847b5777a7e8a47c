"""Options of branches of cycles."""

from __future__ import annotations

from dataclasses import dataclass

from ..core.options import Options, option


@dataclass(frozen=True)
class BranchOptions(Options):
    """Options of pseudo-arclength continuation. Lengths of steps are those of the arc: in states,
    shares of the period and halves of the parameter's range.

    Parameters
    ----------
    first_step, longest_step, shortest_step : float
        Length of the first step, of the longest, and of that below which a branch is given up.
    kink : float
        Length within which a bend is a kink of the branch, and not followed by shorter steps.
    straight : float
        Cosine of the largest angle between a step and the tangents at its ends.
    straighter : float
        That of a smaller one, at which steps become longer faster.
    move : float
        Largest change of the states in one step.
    share : float
        That change over the orbit's extent: an equilibrium is a closed orbit of every period, onto
        which Newton's method may not fall.
    vanished : float
        Extent of an orbit, and its share of the first one's, below which it has shrunk onto an
        equilibrium.
    shrunk : float
        That share where the parameter turns back.
    long_period : float
        Periods of the first cycle beyond which a branch ends, if its cycle comes to rest somewhere.
    still : float
        Slowest rate of an orbit at which it is said to come to rest.
    event_step : float
        Step beyond which one is made shorter in which an event is not located.
    located : float
        Length to which an event is located.
    meeting : float
        Distance of the halves of an orbit, over its extent, below which it meets the cycle of half
        its period.
    scatter : float
        Times that the scatter of an event or of an end counts in its error: of few orbits it is
        less than rounding may make it.

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
