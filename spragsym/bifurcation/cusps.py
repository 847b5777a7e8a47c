"""Cusps of any model in the plane of two parameters: the public function."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ..models.parameters import ParameterSet
from ..questions import Method, question
from ..results.points import Points


@question
def cusps(
    p: ParameterSet,
    vary: Sequence[str] | None = None,
    *,
    between: Mapping[str, tuple[float, float]] | None = None,
    within: Mapping[str, tuple[float, float]] | None = None,
    method: Method = "auto",
) -> Points:
    """Cusps in contact in the plane of two parameters, the others fixed; ``complete`` says whether these are all.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; those that vary are not used.
    vary : pair of str, optional
        Two parameters; without it ``theta0`` and ``mu0``.
    between, within, method
        As for :func:`spragsym.folds`.

    Returns
    -------
    Points
        Of the kind ``"cusp"``. Closed forms of the article's model, in the plane of θ₀ and μ₀, know all cusps with L > 0, θ₀ in
        (−π, π] and μ₀ of either sign, sorted by ``mu0``.

    Raises
    ------
    ParameterError, ParameterTypeError
        For parameters that are missing or no scalars.

    Notes
    -----
    Source: F = 0, det K = 0 and ∇(det K) · v = 0 with K v = 0, v a column of the adjugate of K. Of the article's model: f = f′ =
    f″ = 0, one polynomial of degree 9 in sin θ, see :mod:`spragsym.kang_nam.folds.cusp_points`.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> found = ss.cusps(ss.Parameters.article())
    >>> print(np.degrees(found.theta0[2]), found.mu0[2])
    68.02095850774431 0.20093178180509003
    """
    from .cusp_search import isolated  # where a closed form answers nothing of it is loaded
    from .families import Family
    from .points import arranged

    family = Family.of(p, p.model.two(vary), between, within)
    found = isolated(family)
    return arranged(family, found, np.full(found.roots.point.size, "cusp"))
