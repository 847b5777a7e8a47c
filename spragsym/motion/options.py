"""Options of motions and of closed orbits."""

from __future__ import annotations

from dataclasses import dataclass, field

from ..core.options import Options, limit, option


@dataclass(frozen=True)
class ShootingOptions(Options):
    """Options of multiple shooting: Newton's method for a closed orbit. The unknowns are the states
    at the beginning of equal mesh intervals, and the period. Numbers are in the motion's own units
    (:mod:`spragsym.motion.scales`).

    Parameters
    ----------
    steps : int
        Maximum number of Newton steps.
    last_step : float
        Newton's method has converged when its step is this small, relative to the orbit.
    closed : float
        Largest gap between neighbouring mesh intervals of a solution, relative to its states.
    first_intervals, intervals : int
        Maximum number of mesh intervals of a first guess, and of an orbit.
    growth : float
        Mesh intervals are halved while deviations grow by more than this factor over one of them.
    trivial : float
        Largest error of the trivial multiplier, which is 1. Beyond it the derivatives of the flow
        are too inaccurate, and no orbit is returned.
    neutral : float
        Multipliers whose modulus differs from 1 by less than this do not decide stability.
    moves : float
        A coordinate counts as moving if its range exceeds this many times the orbit's error.
    same_state, same_range : float
        An orbit is reduced to a fraction of its period if the states after that fraction, and the
        ranges over it, differ by less than these. Both are relative to the ranges of the orbit.

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
    """Options of the long-run behaviour of a motion: its limit, its fate, the parameter at which
    the fate changes, and its Lyapunov exponents. Lengths and times are in the motion's own units.

    Parameters
    ----------
    shooting : ShootingOptions
        Options of the search for closed orbits.
    settled : float
        A motion has settled when its distance to its limit is this share of its own extent.
    decay_maxima : int
        Minimum number of maxima from which a decay rate is estimated.
    returns : int
        Minimum number of returns to a section from which a cycle is detected.
    close : float
        A cycle is searched for when two returns are this close, relative to the motion's extent.
    missed : float
        A motion counts as converging to a cycle while the linearized return map predicts its next
        return with at most this error, relative to its distance at the return before.
    noise : float
        Amplitude, in tolerances of a step, that an integrator leaves of a motion at rest.
    times : tuple of float
        A fate is judged at the first of these times, and again at the next while it is undecided;
        under a fast clock after a hundred turns already, and after eight times as many each. No
        further one is begun that would take a million steps.
    rtol, finer_rtol : float
        Relative tolerances of the motions that are judged, and of their repetition, which shows the
        effect of rounding.
    parted : float
        Two motions have diverged when their distance exceeds this.
    neighbours : int
        Number of motions that are followed beside an irregular one.
    offset : float
        Initial distance of these neighbours.
    bracket : float
        Width to which the parameter at which a fate changes is bracketed, relative to its range.
    hovers : float
        A motion hovers at a saddle when it is this close to it, relative to the extent of a saddle
        that is a cycle.
    longest : float
        Total time of all motions in one search for a change of fate.
    seconds : float
        Processor time after which a search for a boundary, of fates or of basins, begins no
        further motion.
    span : float
        Time over which Lyapunov exponents are averaged.
    interval : float
        Time between two orthonormalizations of the deviations.
    lost : float
        The interval is halved if the ratio of two deviations falls below this, where rounding
        would destroy the smaller one.
    significance : float
        An exponent differs from 0 if it is more than this many half-widths of its 95 % confidence
        interval away.
    least_error : float
        Error of an exponent that integration errors may cause.
    still : float
        A motion is at rest when the speed of the flow is below this.
    decays : float
        A motion has settled after this many times 1/rate of its slowest deviation.
    steady : float
        A motion drifts steadily if its velocity changes by less than this share in 1/rate of the
        slowest deviation.

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
    seconds: float = option(30.0, 0.0)
    span: float = option(4000.0, 1.0)
    interval: float = option(5.0, 1e-6)
    lost: float = option(1e-10, 1e-15, 0.1)
    significance: float = option(2.0, 1.0)
    least_error: float = option(1e-10, 0.0)
    still: float = option(1e-9, 0.0)
    decays: float = option(5.0, 1.0)
    steady: float = option(1e-6, 0.0)
