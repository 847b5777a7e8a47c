"""Options of closed orbits."""

from __future__ import annotations

from dataclasses import dataclass

from ..core.options import Options, limit, option


@dataclass(frozen=True)
class ShootingOptions(Options):
    """Options of closed orbits by multiple shooting: Newton's method on the states between equal
    mesh intervals of one round, and the period. Numbers are in units of the motion.

    Parameters
    ----------
    steps : int
        Most steps of Newton's method.
    last_step : float
        Step that ends it, over the largest number of the orbit.
    closed : float
        Gap that an orbit may leave open, over the largest number of its states.
    first_intervals, intervals : int
        Most mesh intervals of a first guess, and of an orbit.
    growth : float
        Growth of deviations over one mesh interval beyond which it is halved.
    trivial : float
        Largest distance of the trivial multiplier from 1: with a larger one the derivatives of the
        flow are not resolved, and there is no answer.
    moves : float
        A coordinate moves on an orbit if its range is so many of the orbit's errors.
    same_state, same_range : float
        Difference between states, and between ranges, over the ranges of the orbit, below which a
        part of a period is taken for a whole one.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> p = ss.Parameters.article(theta0=np.radians(42))
    >>> options = ss.ShootingOptions(growth=10.0)
    >>> found = ss.cycle(p, V=0.5, d=10.0, options=options)
    >>> round(found.period, 6)
    34.26737
    """

    steps: int = limit(12)
    last_step: float = option(1e-13, 0.0, 1.0)
    closed: float = option(1e-12, 1e-15, 1.0)
    first_intervals: int = limit(32)
    intervals: int = limit(64)
    growth: float = option(100.0, 1.0)
    trivial: float = option(1e-4, 0.0, 1.0)
    moves: float = option(100.0, 1.0)
    same_state: float = option(1e-10, 0.0, 1.0)
    same_range: float = option(0.1, 0.0, 1.0)
