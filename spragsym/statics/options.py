"""Options of the search for equilibria, and for points at which they change."""

from __future__ import annotations

from dataclasses import dataclass

from ..core.options import limit, option
from ..numerics.boxes import BoxOptions
from ..numerics.precise_roots import DigitOptions


@dataclass(frozen=True)
class SearchOptions(BoxOptions, DigitOptions):
    """Options of a search for states. None of them decides what is true: smaller limits leave more
    undecided, and larger ones take longer.

    Parameters
    ----------
    tolerance : float
        Bound on the error, over 1 or the size of the state, up to which a state counts as settled
        by floats; others are narrowed with many digits.
    bits, root_bits : int
        Bits of the forces where roots are looked for with many digits, twice as many if these do
        not do, and bits of a root that is known, and of what it is asked for there.
    clusters : int, optional
        Clusters of undecided boxes of a point that are looked at with many digits. Left out, 24 of
        equilibria, and 12 of points along a parameter.
    open_parts : int
        Parts of a cluster that are left open beyond which more bits are not tried.
    open_clusters : int
        Clusters of a point of which that many parts are left, after which others are told as one
        box.
    folded : int
        Undecided boxes of a point beyond which they are told as the one around them.
    near : float
        Half-width of the region that is searched where no bound on the states is shown, in units of
        the largest length of the model.
    rounds, cell_rounds, sweeps, halvings : int
        Rounds in which rows of the forces bound one another's coordinates, in the whole plane and
        in cells of one coordinate; times that each is cut into cells; and times that ranges of
        parameters are halved.
    stalled : float
        Share of all widths that a round may leave, where all are bounded, after which there are no
        more: the search contracts on its own.
    scattered : int
        Undecided boxes beyond which they are not taken to lie around points.
    stiff : float
        Stiffness of a spring, over that of the contact, from which on states are looked for around
        its anchor first.
    samples : int
        Values of a parameter between which floats look for onsets where the search is not complete.
    budget, node_budget, narrow, margin, shrunk, spread, small, pole, pieces
        Of the search over boxes: how many are looked at for one point, and when one is halved; see
        :class:`spragsym.numerics.boxes.BoxOptions`.
    depth, parts
        Of the search with many digits: times that a box is halved, and parts that are looked at.

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
    folded: int = limit(2000)
    near: float = option(10.0, 1e-3)
    rounds: int = limit(200)
    cell_rounds: int = limit(8)
    sweeps: int = limit(4)
    halvings: int = limit(7)
    stalled: float = option(0.8, 0.01, 0.999)
    scattered: int = limit(500, 0)
    stiff: float = option(3e3, 0.0)
    samples: int = limit(61, 2)
