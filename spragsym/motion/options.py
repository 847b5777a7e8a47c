"""Options of motions and of closed orbits."""

from __future__ import annotations

from dataclasses import dataclass, field

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
    neutral : float
        Distance of a multiplier's size from 1 within which it decides nothing about stability.
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
    neutral: float = option(1e-7, 0.0, 0.1)
    moves: float = option(100.0, 1.0)
    same_state: float = option(1e-10, 0.0, 1.0)
    same_range: float = option(0.1, 0.0, 1.0)


@dataclass(frozen=True)
class MotionOptions(Options):
    """Options of what a motion comes to: its limit, its fate, where that changes, and its Lyapunov
    exponents. Lengths and times are in units of the motion.

    Parameters
    ----------
    shooting : ShootingOptions
        Of the closed orbits that are looked for.
    settled : float
        Share of a motion's reach that may be left to the limit of one that has settled.
    decay_maxima : int
        Fewest maxima in a window from which a decay is read.
    returns : int
        Fewest returns in a window in which a cycle is seen.
    close : float
        Distance of two returns, over the extent of the motion, up to which the cycle is looked for.
    missed : float
        Error of the linearized return map, over the distance at the return before, up to which the
        motion nears a cycle as that says.
    noise : float
        What an integrator leaves of a motion at rest, in tolerances of a step.
    times : tuple of float
        A fate is judged at the first of these times, and again at the next as long as it is
        undecided.
    rtol, finer_rtol : float
        Relative tolerances of the motions that are judged, the second of which tells what rounding
        does to those of the first.
    parted : float
        Distance of two motions beyond which they have parted.
    neighbours : int
        Motions beside one that is irregular which are followed as well.
    offset : float
        How far beside it they begin.
    bracket : float
        Share of the values of a parameter to which the change of a fate is narrowed.
    hovers : float
        Distance from a saddle, over the extent of one that is a cycle, below which a motion hovers
        at it.
    longest : float
        Time that the motions of one search for a change are followed in all.
    span : float
        Time that a motion is followed for its exponents.
    interval : float
        Time between two orthonormalizations of the deviations.
    lost : float
        Ratio of two deviations below which the smaller is lost in rounding: the interval is halved.
    significance : float
        Half-widths of its 95 % interval beyond which an exponent is told from 0.
    least_error : float
        What errors of integration may add to an exponent.
    still : float
        Speed of the flow below which a motion is at rest.
    decays : float
        Decays of the slowest deviation by 1/e after which a motion has settled.
    steady : float
        Change of the velocity in such a decay, over its size, up to which a motion drifts steadily.

    Examples
    --------
    >>> import spragsym as ss
    >>> options = ss.MotionOptions(times=(50.0,))
    >>> p = ss.load("stick_slip").Parameters(V=2.5)
    >>> ss.fate(p).kind, ss.fate(p, options=options).kind
    ('rest', 'undecided')
    """

    shooting: ShootingOptions = field(default_factory=ShootingOptions)
    settled: float = option(1e-4, 1e-12, 0.1)
    decay_maxima: int = limit(8, 4)
    returns: int = limit(3, 3)
    close: float = option(0.05, 1e-12, 0.5)
    missed: float = option(0.25, 0.0, 1.0)
    noise: float = option(100.0, 1.0)
    times: tuple[float, ...] = option((2000.0, 10_000.0, 40_000.0), 1e-3)
    rtol: float = option(1e-12, 1e-13, 1e-2)
    finer_rtol: float = option(1e-13, 1e-13, 1e-2)
    parted: float = option(1e-3, 1e-12)
    neighbours: int = limit(4)
    offset: float = option(1e-6, 1e-15)
    bracket: float = option(1e-13, 1e-15, 1e-3)
    hovers: float = option(0.05, 1e-12, 1.0)
    longest: float = option(5e6, 1.0)
    span: float = option(4000.0, 1.0)
    interval: float = option(5.0, 1e-6)
    lost: float = option(1e-10, 1e-15, 0.1)
    significance: float = option(2.0, 1.0)
    least_error: float = option(1e-10, 0.0)
    still: float = option(1e-9, 0.0)
    decays: float = option(5.0, 1.0)
    steady: float = option(1e-6, 0.0)
