"""A box of coordinates that holds all equilibria: springs to ground and inclined springs pull back harder than all else pushes.

A spring's force is its stiffness times the vector between its ends, linear in the coordinates, less its stiffness times its
undeformed length along a unit vector, which is bounded. So with unit vectors left free in [−1, 1]² the balance bounds the
coordinates.
"""

from __future__ import annotations

import numpy as np

from ..exact.interval_arrays import FloatArray, Intervals, raised
from .balance import Balance

#: The plane, as far as it is looked at.
FAR = 1e60
#: Half-width of the region where no bound can be shown, in units of the scale of length.
NEAR = 10.0
#: What the region is wider than it had to be, at each end.
ROOM = 1e-6
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
        directions = [Intervals(np.ones((2, count))) for _ in range(3 * balance.springs)]
        for place in range(balance.springs):
            directions[3 * place + 2] = Intervals(np.stack([np.zeros(count), np.full(count, FAR)]))
        directions += [Intervals(np.full((2, count), raised(np.array(np.pi)))) for _ in balance.torsions]
        for _ in range(ROUNDS):
            before = ends
            ends = balance.by_rows(Intervals(ends), values, directions)
            ends = balance.with_directions(Intervals(ends), values, directions)
            widths, widths_before = ends.sum(axis=0), before.sum(axis=0)
            if (widths >= (BOUNDED if (ends < FAR * 1e-6).all() else ENOUGH) * widths_before).all():
                break
    proved = np.logical_and.reduce(ends < FAR * 1e-6)
    # With room, so that no equilibrium of a linear model lies on the end of a region without width.
    wider = np.minimum(raised(ends + ROOM), balance.border[:, :, None])
    out: FloatArray = np.where(proved, wider, np.minimum(NEAR, balance.border[:, :, None]))
    return out, bool(proved.all())
