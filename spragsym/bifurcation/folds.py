"""Folds of a model along one parameter, and cusps in the plane of two, each proved, and whether
these are all.
"""

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
    """Folds in contact along one parameter, the others fixed; ``complete`` of the result says
    whether these are all.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; the one that varies is not used.
    vary : str, optional
        A parameter; without it ``theta0``, or the model's first one.
    between : mapping, optional
        Its range, as ``{"mu0": (0.0, 2.0)}``. Without it the parameter's own range; one without an
        end is searched to ten times the larger of its base value and its own, and to 10 at least,
        which the result says.
    within : mapping, optional
        Ranges of coordinates, as for :func:`spragsym.equilibria`.
    options : SearchOptions, optional
        Tolerances and limits of the search, which asks for it where a closed form would answer.
    method : {"auto", "closed", "search"}
        A closed form if the model brings one for these arguments, the closed form only, or the
        search.

    Returns
    -------
    Points
        Of the kind ``"fold"``: two equilibria meet and vanish there; or ``"pitchfork"``: three
        become one, all of them in one point, in a model that is its own mirror image. Of several
        contacts these of every combination of touches, and where one combination meets another:
        ``"passes"`` or ``"border_fold"``, see :mod:`spragsym.bifurcation.borders`. Other
        degenerate points are no regular roots and stay among the undecided boxes. Closed forms of
        the article's model know all folds with L > 0, y < 0 and the parameter in its range, to
        1e-12.

    Raises
    ------
    ParameterError
        For a ``vary`` that is not a parameter, or a parameter that is missing or an array.
    ConvergenceError
        At parameters of the article's model so close to a coincidence that 6144 bits do not tell it
        from one.

    Notes
    -----
    Source: F = 0 and det K = 0 in coordinates and parameter. At a regular root of them the
    parameter moves the state across the fold and the fold is quadratic: otherwise their Jacobian
    would be singular. Pitchforks: :mod:`spragsym.bifurcation.singularities`. Of the article's
    model: f = f′ = 0, see :mod:`spragsym.kang_nam.folds`.

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
    from .singularities import folds_of  # where a closed form answers nothing of it is loaded

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
    """Cusps in contact in the plane of two parameters, the others fixed; ``complete`` says whether
    these are all.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; those that vary are not used.
    vary : pair of str, optional
        Two parameters; without it ``theta0`` and ``mu0``.
    between, within, options, method
        As for :func:`spragsym.folds`.

    Returns
    -------
    Points
        Of the kind ``"cusp"``. Closed forms of the article's model, in the plane of θ₀ and μ₀, know
        all cusps with L > 0, θ₀ in (−π, π] and μ₀ of either sign, sorted by ``mu0``.

    Raises
    ------
    ParameterError, ParameterTypeError
        For parameters that are missing or no scalars.

    Notes
    -----
    Source: F = 0, det K = 0 and ∇(det K) · v = 0 with K v = 0, v a column of the adjugate of K. Of
    the article's model: f = f′ = f″ = 0, one polynomial of degree 9 in sin θ, see
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
