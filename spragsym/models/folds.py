"""All folds of a model along one parameter, proved."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from .balance import Balance, Model
from .conditions import Fold
from .points import ModelPoints, arranged, given_column, ranges, search
from .symmetry import with_pitchforks


def folds(model: Model, p: Any, vary: str, *, between: Mapping[str, tuple[float, float]] | None = None) -> ModelPoints:
    """All folds in contact along one parameter, the others fixed.

    Parameters
    ----------
    model : Model
    p : Parameters
        Of the model, scalars; the one that varies is not used.
    vary : str
        A parameter.
    between : mapping, optional
        Its range, as ``{"mu0": (0.0, 2.0)}``. Without it the parameter's own range, which ends at ten times the base value, and
        at 10 at least, if it has no end.

    Returns
    -------
    ModelPoints
        Of the kind ``"fold"``: two equilibria meet and vanish there; or ``"pitchfork"``: three become one, all of them in one
        point, in a model that is its own mirror image. Other degenerate points are no regular roots and stay among the undecided
        boxes.

    Notes
    -----
    Source: F = 0 and det K = 0 in coordinates and parameter. At a regular root of them the parameter moves the state across the
    fold and the fold is quadratic: otherwise their Jacobian would be singular. Pitchforks: :mod:`spragsym.models.symmetry`.
    """
    balance = Balance(model, contact=True)
    spans = ranges(model, (vary,), between or {})
    given = given_column(p, balance.parameters, (vary,))
    found = search(balance, (vary,), Fold(), given, spans)
    found, pitchforks = with_pitchforks(balance, vary, given, spans[0], found)
    kind = np.where(np.arange(found.roots.point.size) < found.roots.point.size - pitchforks, "fold", "pitchfork")
    return arranged(balance, (vary,), given, found, kind)
