"""Folds of a model along one parameter, each proved, and whether these are all."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ..models.parameters import ParameterSet
from ..questions import Method, question
from ..remarks import At, Remark
from ..results.points import Points

if TYPE_CHECKING:
    from .families import Family
    from .points import Found


@question
def folds(
    p: ParameterSet,
    vary: str | None = None,
    *,
    between: Mapping[str, tuple[float, float]] | None = None,
    within: Mapping[str, tuple[float, float]] | None = None,
    method: Method = "auto",
) -> Points:
    """Folds in contact along one parameter, the others fixed; ``complete`` of the result says whether these are all.

    Parameters
    ----------
    p : Parameters
        Of any model, scalars; the one that varies is not used.
    vary : str, optional
        A parameter; without it ``theta0``, or the model's first one.
    between : mapping, optional
        Its range, as ``{"mu0": (0.0, 2.0)}``. Without it the parameter's own range; one without an end is searched to ten times
        the base value, and to 10 at least, which the result says.
    within : mapping, optional
        Ranges of coordinates, as for :func:`spragsym.equilibria`.
    method : {"auto", "closed", "search"}
        A closed form if the model brings one for these arguments, the closed form only, or the search.

    Returns
    -------
    Points
        Of the kind ``"fold"``: two equilibria meet and vanish there; or ``"pitchfork"``: three become one, all of them in one
        point, in a model that is its own mirror image. Other degenerate points are no regular roots and stay among the undecided
        boxes. Closed forms of the article's model know all folds with L > 0, y < 0 and the parameter in its range, to 1e-12.

    Raises
    ------
    ParameterError
        For a ``vary`` that is not a parameter, or a parameter that is missing or an array.
    ConvergenceError
        At parameters of the article's model so close to a coincidence that 6144 bits do not tell it from one.

    Notes
    -----
    Source: F = 0 and det K = 0 in coordinates and parameter. At a regular root of them the parameter moves the state across the
    fold and the fold is quadratic: otherwise their Jacobian would be singular. Pitchforks:
    :mod:`spragsym.bifurcation.symmetry`. Of the article's model: f = f′ = 0, see
    :mod:`spragsym.kang_nam.folds.fold_points`.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> found = ss.folds(ss.Parameters.article())
    >>> print(np.degrees(found.theta0))
    [ 44.5593177  155.05941879]
    >>> print(ss.folds(ss.Parameters.article(mu0=0.0, alpha=0.0)).kind)
    ['pitchfork' 'pitchfork']
    >>> found = ss.folds(ss.load("cubic_contact").Parameters(), vary="theta0", between={"theta0": (0.5, 1.5)})
    >>> np.degrees(found.theta0).round(2).tolist(), found.complete
    ([44.59], True)
    """
    from .bifurcation_conditions import FOLD  # where a closed form answers nothing of it is loaded
    from .families import Family
    from .points import arranged, search
    from .symmetry import with_pitchforks

    family = Family.of(p, (p.model.one(vary),), between, within)
    found, pitchforks = with_pitchforks(family, search(family, FOLD))
    kind = np.where(np.arange(found.roots.point.size) < found.roots.point.size - pitchforks, "fold", "pitchfork")
    if family.vary[0] in family.balance.balanced:
        return arranged(family, found, kind, remarks=_remarks(family, found))
    return arranged(replace(family, endless=()), found, kind, remarks=(f"{family.vary[0]} moves no equilibrium",))


def _remarks(family: Family, found: Found) -> tuple[str, ...]:
    """Remarks on undecided boxes at an end of the range where det K is 0 for every state."""
    from .bifurcation_conditions import FOLD
    from .defining_systems import Augmented
    from .degenerate_ends import vanishes

    left, system, (vary,) = found.roots.left, Augmented(family, FOLD), family.vary
    remarks = []
    for end in family.spans[0] if left.shape[2] else ():
        here = left[:, :, (-left[0, -1] <= end) & (end <= left[1, -1])]
        if here.shape[2] and vanishes(system, float(end), here).any():
            why = "det K is 0 in every state: equilibria there form curves, or there are none"
            cure = f"for folds beside it give between with another end for {vary}"
            remarks.append(Remark(f"at {{}} {why}; {cure}", At(vary, (float(end),), "g")))
    return tuple(remarks)
