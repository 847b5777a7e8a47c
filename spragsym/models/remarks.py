"""What is known of boxes of equilibria that are left undecided, in plain words."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..exact.interval_arrays import FloatArray, Intervals, stacked
from .balance import Balance

#: A box no wider than this, over the size of its coordinates, is one place to floats.
ONE_PLACE = 1e-9

ANCHOR = "hold the anchor of a spring, where its force has no value: an equilibrium may be nearer to it than floats tell"
BORDER = "hold places where the contact just touches: whether an equilibrium lies on this side of the border is not known"
PLACE = "are one place each to floats: a double equilibrium may be there, two very near ones, or none"
LINE = "lie along places where the forces are 0 to rounding: a line of equilibria, or a few on it that floats do not tell apart"


def remarks(balance: Balance, given: FloatArray, left: FloatArray, point: NDArray[np.int64]) -> tuple[str, ...]:
    """One sentence for each kind of box.

    Parameters
    ----------
    given : ndarray
        Parameters, shape (parameters, points).
    left : ndarray
        −low and high, shape (2, n, boxes).
    point : ndarray
        The point of each box.
    """
    count = point.size
    if not count:
        return ()
    with np.errstate(all="ignore"):
        q = list(Intervals(left))
        values = balance.arguments(balance.prepared(Intervals.point(given[:, point])))
        anchor = np.zeros(count, dtype=np.bool_)
        for dx, dy in balance.anchors(q, values, (count,)):
            anchor |= dx.holds_zero() & dy.holds_zero()
        gap = stacked([balance.gap(q, values)], (count,))[0]
        border = gap.holds_zero() if balance.opens else np.zeros(count, dtype=np.bool_)
        narrow = ((left[0] + left[1]) <= ONE_PLACE * np.maximum(1.0, np.abs(left).max(axis=0))).all(axis=0)
    border &= ~anchor
    narrow &= ~(anchor | border)
    kinds = ((anchor, ANCHOR), (border, BORDER), (narrow, PLACE), (~(anchor | border | narrow), LINE))
    return tuple(f"{which.sum()} of {count} undecided boxes {text}" for which, text in kinds if which.any())
