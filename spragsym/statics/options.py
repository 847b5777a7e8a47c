"""Options of the search for equilibria, and for points at which they change."""

from __future__ import annotations

from dataclasses import dataclass

from ..core.options import limit, option
from ..numerics.boxes import BoxOptions
from ..numerics.precise_roots import DigitOptions


@dataclass(frozen=True)
class SearchOptions(BoxOptions, DigitOptions):
    """Options of a search for states.

    No option decides what is true: smaller limits leave more undecided, larger limits take longer.

    Parameters
    ----------
    tolerance : float
        Largest error, relative to 1 or the size of the state, of a state that floats settle; others
        are narrowed in ball arithmetic.
    bits, root_bits : int
        Bits of ball arithmetic: in a search for roots, doubled once if they do not suffice, and at
        a root that is known.
    clusters : int, optional
        Most clusters of undecided boxes at one point that ball arithmetic treats; by default 24 for
        equilibria, and 12 for bifurcation points along a parameter.
    open_parts : int
        Undecided parts of a cluster beyond which more bits are not tried.
    open_clusters : int
        Clusters at one point with that many undecided parts, after which further clusters are left
        as one undecided box each.
    near : float
        Half-width of the searched region where no bound on the states is proved, in units of the
        largest length of the model.
    rounds, cell_rounds, sweeps, halvings : int
        Effort to prove a bound on the states: contractions over the whole plane, and over a cell of
        one coordinate; times that each coordinate is cut into cells; and times that ranges of
        parameters are halved.
    stalled : float
        The contractions end when a round leaves more than this share of all widths, once all are
        finite.
    scattered : int
        Undecided boxes beyond which they are not assumed to lie around isolated points.
    stiff : float
        Stiffness of a spring over that of the contact beyond which states are first searched in
        polar coordinates around its anchor.
    samples : int
        Values of a parameter between which floats look for onsets if the search is not complete.
    budget, seconds, folded, node_budget, narrow, margin, shrunk, spread, small, pole, pieces
        Options of the search over boxes: how many boxes, or how much time, one point may take, and
        when a box is halved; see :class:`spragsym.numerics.boxes.BoxOptions`.
    depth, parts
        Options of the search in ball arithmetic: most halvings of a box, and most parts.

    Examples
    --------
    >>> import spragsym as ss
    >>> few = ss.SearchOptions(budget=3, pieces=1, clusters=0)
    >>> ss.folds(ss.Parameters.article(), options=few).complete
    False
    """

    tolerance: float = option(1e-12, 0.0, 1e-3)
    bits: int = limit(160, 64)
    root_bits: int = limit(256, 64)
    clusters: int | None = limit(None, 0)
    open_parts: int = limit(32, 0)
    open_clusters: int = limit(3, 0)
    near: float = option(10.0, 1e-3)
    rounds: int = limit(200)
    cell_rounds: int = limit(8)
    sweeps: int = limit(4)
    halvings: int = limit(7)
    stalled: float = option(0.8, 0.01, 0.999)
    scattered: int = limit(500, 0)
    stiff: float = option(3e3, 0.0)
    samples: int = limit(61, 2)
