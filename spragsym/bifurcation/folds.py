"""Folds of a model along one parameter, and cusps in the plane of two: the public functions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..core.questions import Method, question
from ..models.parameters import ParameterSet, Ranges
from ..results import Points

if TYPE_CHECKING:
    from ..statics.options import SearchOptions


@question
def folds(
    p: ParameterSet,
    vary: str | None = None,
    *,
    between: Ranges | None = None,
    within: Ranges | None = None,
    options: SearchOptions | None = None,
    method: Method = "auto",
) -> Points:
    """All folds in contact along one parameter, each proved.

    Where several contacts can all open, remarks name those of states in which none touches.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; the value of the one that varies is not used.
    vary : str, optional
        The parameter; by default ``theta0``, or the model's first one.
    between : mapping, optional
        Its range, as ``{"mu0": (0.0, 2.0)}``; by default the range of the page. An infinite
        range is searched to ten times the larger of the base value and the own value, and at least
        to 10; the result says so.
    within : mapping, optional
        Ranges of coordinates, as for :func:`spragsym.equilibria`.
    options : SearchOptions, optional
        Tolerances and limits of the search. If given, the search answers instead of a closed form.
    method : {"auto", "closed", "search"}
        A closed form if the model has one for these arguments and else the search; only the closed
        form; or only the search.

    Returns
    -------
    Points
        ``complete`` says whether these are all. The kind is ``"fold"`` where two equilibria meet
        and vanish, and ``"pitchfork"`` where three become one, in a model that is its own mirror
        image. With several contacts, these are points of all combinations of touching contacts, and
        the kinds ``"passes"`` and ``"border_fold"`` are points where one combination meets another,
        see :mod:`spragsym.bifurcation.borders`. Other degenerate points are no regular roots and
        remain undecided boxes. Closed forms of the article's model give all folds with L > 0, y < 0
        and the parameter in its range, to 1e-12.

    Raises
    ------
    ParameterError
        For a ``vary`` that is not a parameter, or a parameter that is missing or an array.
    ConvergenceError
        At parameters of the article's model so near to a coincidence that 6144 bits do not separate
        them from it.

    Notes
    -----
    Source: F = 0 and det K = 0 in coordinates and parameter. At a regular root the fold is
    quadratic, and the parameter unfolds it: otherwise the Jacobian would be singular. Pitchforks:
    :mod:`spragsym.bifurcation.singularities`. The article's model: f = f′ = 0, see
    :mod:`spragsym.kang_nam.folds`.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> found = ss.folds(ss.Parameters.article())
    >>> print(np.degrees(found.theta0))
    [ 44.5593177  155.05941879]
    >>> print(ss.folds(ss.Parameters.article(mu0=0.0, alpha=0.0)).kind)
    ['pitchfork' 'pitchfork']
    >>> p = ss.load("cubic_contact").Parameters()
    >>> found = ss.folds(p, vary="theta0", between={"theta0": (0.5, 1.5)})
    >>> np.degrees(found.theta0).round(2).tolist(), found.complete
    ([44.59], True)
    """
    from .singularities import folds_of  # not loaded where a closed form answers

    return folds_of(p, p.model.one(vary), between, within, options)


@question
def cusps(
    p: ParameterSet,
    vary: Sequence[str] | None = None,
    *,
    between: Ranges | None = None,
    within: Ranges | None = None,
    options: SearchOptions | None = None,
    method: Method = "auto",
) -> Points:
    """All cusps in contact in the plane of two parameters, each proved.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; the values of those that vary are not used.
    vary : pair of str, optional
        Two parameters, by default ``theta0`` and ``mu0``.
    between, within, options, method
        As for :func:`spragsym.folds`.

    Returns
    -------
    Points
        ``complete`` says whether these are all. The kind is ``"cusp"``. Closed forms of the
        article's model, in the plane of θ₀ and μ₀, give all cusps with L > 0, θ₀ in (−π, π] and μ₀
        of either sign, sorted by ``mu0``.

    Raises
    ------
    ParameterError, ParameterTypeError
        For parameters that are missing or no scalars.

    Notes
    -----
    Source: F = 0, det K = 0 and ∇(det K) · v = 0 with K v = 0, where v is a column of the adjugate
    of K. The article's model: f = f′ = f″ = 0, one polynomial of degree 9 in sin θ, see
    :mod:`spragsym.kang_nam.cusps`.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> found = ss.cusps(ss.Parameters.article())
    >>> print(np.degrees(found.theta0[2]), found.mu0[2])
    68.02095850774431 0.20093178180509003
    """
    from .singularities import cusps_of

    return cusps_of(p, p.model.two(vary), between, within, options)
