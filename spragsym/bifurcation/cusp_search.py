"""A box around each cusp of a model in the plane of two parameters, and the boxes left undecided."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..numerics import contractors
from ..numerics.certified_roots import Roots, concatenated, different
from ..numerics.determinants import cofactor
from ..numerics.interval_arrays import Intervals
from ..numerics.jets import variables
from ..statics.mechanics.balance import Balance
from ..statics.mechanics.precise_balance import clusters
from .bifurcation_conditions import change, cusp
from .defining_systems import Augmented
from .points import Found, search
from .symmetry import MANY


def isolated(
    balance: Balance, vary: Sequence[str], given: NDArray[np.float64], spans: NDArray[np.float64],
    asked: NDArray[np.float64] | None = None,
) -> Found:  # fmt: skip
    """A box for each cusp, and what is left; arguments as of :func:`spragsym.bifurcation.points.search`."""
    found = search(balance, vary, cusp(), given, spans, asked=asked)
    roots = _cusps(balance, vary, found, given, 0)
    for column in range(1, balance.n):
        # A cusp at which a column of the adjugate is 0, as on a mirror, is a double root with it, and regular with another one.
        hulls = clusters(roots.left, roots.left_point)[0] if roots.left_point.size <= MANY else roots.left[:, :, :0]
        for hull in np.moveaxis(hulls, 2, 0):
            spans = np.stack([-hull[0], hull[1]], axis=-1)[balance.n :]
            again = search(balance, vary, cusp(column), given, spans, asked=hull[:, : balance.n])
            more = _cusps(balance, vary, again, given, column)
            if not more.left_point.size:
                open_ = ~contractors.within(roots.left, hull[:, :, None])
                roots = different(concatenated([roots.kept(left=open_), more], roots.ends.shape[1]), found.region)
    return replace(found, roots=roots)


def _cusps(balance: Balance, vary: Sequence[str], found: Found, given: NDArray[np.float64], column: int) -> Roots:
    """The roots that are cusps, and those of which that is not known among what is left."""
    proved, unclear = told_apart(balance, vary, found, given, column)
    return found.roots.kept(proved).besides(found.roots.ends[:, :, unclear], found.roots.point[unclear])


def told_apart(
    balance: Balance, vary: Sequence[str], found: Found, given: NDArray[np.float64], column: int
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Which roots are cusps, and of which that is not known.

    A root is a cusp if the column in use is not 0 there, and none if det K changes along another column.
    """
    ends = found.roots.ends
    shape = ends.shape[2:]
    if not shape[0]:
        return np.zeros(0, dtype=np.bool_), np.zeros(0, dtype=np.bool_)
    with np.errstate(all="ignore"):
        system = Augmented(balance, vary, cusp(column))
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
