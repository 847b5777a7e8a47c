"""Options of onsets of models of matrices."""

from __future__ import annotations

from dataclasses import dataclass

from ..core.options import Options, limit, option


@dataclass(frozen=True)
class MatrixOptions(Options):
    """Options of the search for onsets of squeal; with smaller limits more is undecided.

    Parameters
    ----------
    terms : int
        Terms of the power series about a middle, on which the stretches are proved.
    least : float
        Share of the range below which a gap is not halved any more.
    middles : int
        Most eigenbases.

    Examples
    --------
    >>> import spragsym as ss
    >>> ss.MatrixOptions(middles=200).terms
    9
    """

    terms: int = limit(9, 2, 40)
    least: float = option(1e-11, 1e-15, 0.1)
    middles: int = limit(10_000)
