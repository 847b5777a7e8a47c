"""Extrema and ends of curves of folds in a plane: where the second parameter is least or largest along a piece of one.

Between two of these values that are next to each other no curve begins, turns back or ends: each crosses every line there, and
one line shows them all.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from ..progress import doing
from ..results.points import Points
from .bifurcation_conditions import FOLD_ON_BORDER, TURN
from .cusps import cusps
from .families import Family
from .folds import folds
from .points import OVER_BORDER, isolated


def extrema(
    p: Any, vary: Sequence[str], between: Mapping[str, tuple[float, float]],
    within: Mapping[str, tuple[float, float]] | None = None,
) -> Iterator[tuple[str, Points]]:  # fmt: skip
    """Where curves of folds have extreme values of the second parameter or end, by kind, each proved; arguments as of ``folds``.

    Kinds are ``"cusp"``; ``"turn"``: F = 0, det K = 0 and w · ∂F/∂v = 0 for the first parameter v, with w K = 0; ``"end"``, at
    either end of the range of v; and ``"border"``, where folds leave a contact that opens.
    """
    over, along = vary
    family, rest = Family.of(p, vary, between, within), {name: ends for name, ends in between.items() if name != over}
    with doing("cusps over {} and {}", *vary):
        found = cusps(p, vary, between=between, within=within)
    yield "cusp", found
    # Where no state depends on one of the two, curves are straight along it.
    bends = set(vary) <= set(family.balance.balanced)
    if bends:
        yield "turn", isolated(family, TURN, "turn")
    low, high = family.spans[0].tolist()
    for end in (low, high):
        value = p.ranges[over].reached(end, high - low)
        yield "end", folds(p.replace(**{over: value}), along, between=rest, within=within)
    if family.balance.opens and bends:
        yield "border", isolated(Family.of(p, vary, between, within, room=OVER_BORDER), FOLD_ON_BORDER, "border")
