"""A box of coordinates that holds all equilibria: springs to ground and inclined springs pull back harder than all else pushes.

A spring's force is its stiffness times the vector between its ends, linear in the coordinates, less its stiffness times its
undeformed length along a unit vector, which is bounded. So with unit vectors left free in [−1, 1]² the balance bounds the
coordinates.

A torsion spring pulls across its line with k_t φ/l, |φ| ≤ π. Either l is less than 1 (:data:`LENGTH`), and the mass is that near
to the anchor, or the force is at most k_t π, and the coordinates are bounded as without it. The hull of both holds all
equilibria.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..exact.interval_arrays import FloatArray, Intervals, raised
from .balance import Balance

#: The plane, as far as it is looked at.
FAR = 1e60
#: Half-width of the region where no bound can be shown, in units of the scale of length.
NEAR = 10.0
#: What the region is wider than it had to be, at each end.
ROOM = 1e-6
#: Length of the line of a torsion spring from which on its force is bounded, in units of the scale of length.
LENGTH = 1.0
#: Upper bound of the angle that it turns by.
HALF_TURN = 3.1415926535897936
#: Rounds of contraction: each row bounds its coordinate from those that are bounded already.
ROUNDS = 12
#: No more rounds where one leaves so much of all widths: before all are bounded, and then, since the search contracts on its own.
ENOUGH, BOUNDED = 0.999, 0.8


def region(balance: Balance, bounds: Intervals) -> tuple[FloatArray, bool]:
    """A box for each point, as −low and high, shape (2, n, N), and whether it is proved to hold all equilibria of all points.

    Parameters
    ----------
    bounds : Intervals
        Parameters, shape (P, N).
    """
    count = bounds.shape[1]
    with np.errstate(all="ignore"):
        parameters = balance.prepared(bounds)
        values = balance.arguments(parameters)
        ends = np.minimum(FAR, np.broadcast_to(balance.border[:, :, None], (2, balance.n, count)))
        directions = _any_direction(balance, count)
        for _ in range(ROUNDS):
            before = ends
            ends = balance.by_rows(Intervals(ends), values, directions)
            ends = balance.with_directions(Intervals(ends), values, directions)
            if balance.model.about.get("waves"):
                ends = balance.with_waves(Intervals(ends), values, directions)
            widths, widths_before = ends.sum(axis=0), before.sum(axis=0)
            if (widths >= (BOUNDED if (ends < FAR * 1e-6).all() else ENOUGH) * widths_before).all():
                break
        ends = np.maximum(ends, _near_anchors(balance, ends, values))
    proved = np.logical_and.reduce(ends < FAR * 1e-6)
    # With room, so that no equilibrium of a linear model lies on the end of a region without width.
    wider = np.minimum(raised(ends + ROOM), balance.border[:, :, None])
    out: FloatArray = np.where(proved, wider, np.minimum(NEAR, balance.border[:, :, None]))
    return out, bool(proved.all())


def _any_direction(balance: Balance, count: int) -> list[Intervals]:
    """Cosines, sines and lengths of all lines, and angles by which torsion springs turn, as far as they can be."""
    directions = [Intervals(np.ones((2, count))) for _ in range(3 * balance.springs)]
    for place in range(balance.springs):
        shortest = LENGTH if place in balance.torsions else 0.0
        directions[3 * place + 2] = Intervals(np.stack([np.full(count, -shortest), np.full(count, FAR)]))
    return directions + [Intervals(np.full((2, count), HALF_TURN)) for _ in balance.torsions]


def _near_anchors(balance: Balance, ends: FloatArray, values: Mapping[str, Any]) -> FloatArray:
    """Hull of the places where a torsion spring's line is shorter than :data:`LENGTH`; without bounds where that is not known."""
    hull = np.full(ends.shape, -np.inf)
    for spring in balance.torsions:
        chart = balance.model.about["springs"][spring]["chart"]
        places = [balance.coordinates.index(name) for name in chart or ()]
        if len(places) < balance.n:
            hull[:] = np.inf
            break
        q: list[Any] = [0] * balance.n
        anchor = balance.anchors(q, values, ends.shape[2:])[spring]
        for place, end in zip(places, anchor, strict=True):
            hull[:, place] = np.maximum(hull[:, place], raised(end.ends + LENGTH))
    out: FloatArray = np.minimum(hull, balance.border[:, :, None])
    return out
