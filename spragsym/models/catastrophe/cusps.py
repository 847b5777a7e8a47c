"""Cusps of a model in the plane of two parameters, each proved, and whether these are all."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...exact.determinants import cofactor
from ...exact.interval_arrays import Intervals
from ...exact.jets import variables
from ...results.points import Points
from ..mechanics.balance import Balance
from ..mechanics.forces import Model
from ..statics.regions import by_hand
from .bifurcation_conditions import Cusp, change
from .defining_systems import Augmented
from .points import Found, arranged, endless, given_column, picked, ranges, search


def cusps(
    model: Model,
    p: Any,
    vary: Sequence[str],
    *,
    between: Mapping[str, tuple[float, float]] | None = None,
    within: Mapping[str, tuple[float, float]] | None = None,
) -> Points:
    """Cusps in contact in the plane of two parameters, the others fixed; ``complete`` says whether these are all.

    Parameters
    ----------
    model : Model
    p : Parameters
        Of the model, scalars; those that vary are not used.
    vary : pair of str
        Two parameters.
    between : mapping, optional
        Their ranges, as for :func:`spragsym.models.catastrophe.folds.folds`.
    within : mapping, optional
        Ranges of coordinates, as for :func:`spragsym.models.statics.equilibria.equilibria`.

    Returns
    -------
    Points
        Of the kind ``"cusp"``.

    Notes
    -----
    Source: F = 0, det K = 0 and ∇(det K) · v = 0 with K v = 0, v a column of the adjugate of K.
    """
    spans = ranges(model, vary, between or {})
    balance = Balance(model, contact=True)
    given = given_column(p, balance.parameters, vary)
    found = isolated(balance, vary, given, spans, by_hand(balance.coordinates, within))
    kind = np.full(found.roots.point.size, "cusp")
    return arranged(balance, p, vary, given, found, kind, endless=endless(model, vary, between or {}))


def isolated(
    balance: Balance, vary: Sequence[str], given: NDArray[np.float64], spans: NDArray[np.float64],
    asked: NDArray[np.float64] | None = None,
) -> Found:  # fmt: skip
    """A box for each cusp, and what is left; arguments as of :func:`spragsym.models.catastrophe.points.search`."""
    found = search(balance, vary, Cusp(), given, spans, asked=asked)
    proved, unclear = told_apart(balance, vary, found, given)
    left = np.concatenate([found.roots.left, found.roots.ends[:, :, unclear]], axis=2)
    left_point = np.concatenate([found.roots.left_point, found.roots.point[unclear]])
    return replace(found, roots=replace(picked(found.roots, proved), left=left, left_point=left_point))


def told_apart(
    balance: Balance, vary: Sequence[str], found: Found, given: NDArray[np.float64], column: int = 0
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Which roots are cusps, and of which that is not known.

    A root is a cusp if the column in use is not 0 there, and none if det K changes along another column.
    """
    ends = found.roots.ends
    shape = ends.shape[2:]
    if not shape[0]:
        return np.zeros(0, dtype=np.bool_), np.zeros(0, dtype=np.bool_)
    with np.errstate(all="ignore"):
        system = Augmented(balance, vary, Cusp())
        fixed = system.prepared(Intervals.point(np.nan_to_num(given[:, found.roots.point])))
        at = system.state(variables(list(Intervals(ends)), 1), fixed, shape)
        K = at.slopes()
        n = balance.n
        nonzero = np.zeros(shape, dtype=np.bool_)
        for i in range(n):
            entry = cofactor(K, column, i)
            value = getattr(entry, "value", entry)
            nonzero |= ~value.holds_zero() if isinstance(value, Intervals) else np.full(shape, value != 0)
        none = np.zeros(shape, dtype=np.bool_)
        for other in set(range(n)) - {column}:
            none |= ~change(K, other).value.holds_zero()
    return nonzero & ~none, ~nonzero & ~none
