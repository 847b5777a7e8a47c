"""Options of continuation along a parameter or a curve."""

from __future__ import annotations

from dataclasses import dataclass, field

from ..core.options import Options, limit, option
from ..statics.options import SearchOptions


@dataclass(frozen=True)
class ContinuationOptions(Options):
    """Options of paths of states, of the tubes that prove them, and of curves in a plane.

    No option decides what is true: with smaller limits more is undecided.

    Parameters
    ----------
    search : SearchOptions
        Options of the search for states and bifurcation points.
    first_step, least_step : float
        First and least step of a tube, as a share of the whole way.
    steps, turn_steps, steep_steps : int
        Most steps of a tube along the parameter, across a fold, and where the curve is steep.
    half_width : float
        Least half-width of a tube, over the size of its coordinates.
    inflations : int
        Times that a tube is widened before its step is reduced.
    inflation : float
        Share of its width by which a tube is widened.
    newton_steps, secant_steps : int
        Most steps of Newton's method in the middle of a tube, and of the secant method towards a
        fold.
    segments : int
        Most segments of a tube towards a fold.
    fold_distance : float
        Distance from a fold at which the states beside it are computed, over its value or 1, or
        over the largest value of the path if that is less.
    halvings : int
        Times that a step is halved to match branches.
    open_steps : int
        Unmatched steps beyond which none is halved any more.
    smoothness : float
        Largest distance of a curve from the straight line between two of its points, over the
        ranges of the parameters.
    deviation : float
        Largest distance of the point half-way between two points from the Hermite cubic, over
        their distance: beyond it they lie on different curves.
    refinements : int
        Times that points are added between neighbours to make a curve smooth.
    pace, least_pace : float
        First and least step of pseudo-arclength continuation at the end of a chain of points, over
        the ranges.
    paces : int
        Most steps of it.
    turn : float
        Cosine of the largest change of direction within a step.
    undamped : float
        C over K up to which an undecided state is reported as next to undamped.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> p = ss.Parameters.article(theta0=np.radians(49.0))
    >>> options = ss.ContinuationOptions(fold_distance=1e-4)
    >>> path = ss.quasi_static_path(p, "mu0", np.linspace(0.0, 0.6, 7), options=options)
    >>> len(path.jumps)
    1
    """

    search: SearchOptions = field(default_factory=SearchOptions)
    first_step: float = option(2.0**-5, 2.0**-20, 1.0)
    least_step: float = option(2.0**-14, 2.0**-40, 1.0)
    steps: int = limit(4000)
    turn_steps: int = limit(60)
    steep_steps: int = limit(100)
    half_width: float = option(1e-9, 1e-14, 1e-3)
    inflations: int = limit(6)
    inflation: float = option(0.1, 1e-3, 1.0)
    newton_steps: int = limit(6, 2)
    secant_steps: int = limit(40)
    segments: int = limit(4000)
    fold_distance: float = option(1e-3, 1e-9, 0.1)
    halvings: int = limit(40, 0)
    open_steps: int = limit(500)
    smoothness: float = option(2e-4, 1e-8, 0.1)
    deviation: float = option(0.01, 1e-6, 0.1)
    refinements: int = limit(7, 0)
    pace: float = option(0.02, 1e-6, 0.5)
    least_pace: float = option(1e-6, 1e-12, 0.5)
    paces: int = limit(60)
    turn: float = option(0.9, 0.0, 1.0)
    undamped: float = option(1e-6, 0.0, 1.0)

    @property
    def given_search(self) -> SearchOptions | None:
        """Options of the search; None if all are defaults, so that closed forms may answer."""
        return None if self.search == SearchOptions() else self.search
