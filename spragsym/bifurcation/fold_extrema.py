"""Extrema and ends of curves of folds in a plane: where the second parameter is least or largest along a piece of one.

Between two of these values that are next to each other no curve begins, turns back or ends: each crosses every line there, and
one line shows them all.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from ..numerics.interval_arrays import FloatArray
from ..progress import doing
from ..results.points import Points
from ..statics.mechanics.balance import Balance
from ..statics.mechanics.forces import Model
from ..statics.regions import by_hand
from .bifurcation_conditions import FoldOnBorder, Turn
from .cusps import cusps
from .defining_systems import Condition
from .folds import folds
from .paths import OVER_BORDER
from .points import arranged, given_column, ranges, search


def extrema(
    model: Model, p: Any, vary: Sequence[str], between: Mapping[str, tuple[float, float]],
    within: Mapping[str, tuple[float, float]] | None = None,
) -> Iterator[tuple[str, Points]]:  # fmt: skip
    """Where curves of folds have extreme values of the second parameter or end, by kind, each proved.

    Parameters
    ----------
    model : Model
    p : Parameters
        Of the model, scalars; those that vary are not used.
    vary : pair of str
        Two parameters.
    between : mapping
        Ranges of the two, as for :func:`spragsym.bifurcation.folds.folds`.
    within : mapping, optional
        Ranges of coordinates, as for :func:`spragsym.statics.equilibria.equilibria`.

    Yields
    ------
    str, Points
        ``"cusp"``; ``"turn"``: F = 0, det K = 0 and w · ∂F/∂v = 0 for the first parameter v, with w K = 0; ``"end"``, at either
        end of the range of v; and ``"border"``, where folds leave a contact that opens.
    """
    over, along = vary
    spans, rest = ranges(model, vary, between), {name: ends for name, ends in between.items() if name != over}
    with doing("cusps over {} and {}", *vary):
        found = cusps(p, vary, between=between, within=within)
    yield "cusp", found
    balance = Balance(model, contact=True)
    # Where no state depends on one of the two, curves are straight along it.
    bends = set(vary) <= set(balance.balanced)
    if bends:
        yield "turn", isolated(balance, p, Turn(), vary, spans, within)
    for end in spans[0]:
        value = p.ranges[over].reached(float(end), float(spans[0, 1] - spans[0, 0]))
        yield "end", folds(p.replace(**{over: value}), along, between=rest, within=within)
    if balance.opens and bends:
        yield "border", isolated(Balance(model, contact=True, room=OVER_BORDER), p, FoldOnBorder(), vary, spans, within)


def isolated(
    balance: Balance, p: Any, condition: Condition, vary: Sequence[str], spans: FloatArray,
    within: Mapping[str, tuple[float, float]] | None = None,
) -> Points:  # fmt: skip
    """Points of one condition along one parameter or in the plane of two."""
    given = given_column(p, balance.parameters, vary)
    with doing("extrema and ends of curves over {}", " and ".join(vary)):
        found = search(balance, vary, condition, given, spans, asked=by_hand(balance.coordinates, within))
    return arranged(balance, p, vary, given, found, np.full(found.roots.point.size, "candidate"))
