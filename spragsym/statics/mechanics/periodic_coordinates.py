"""Periodic coordinates: solutions that differ by 2π are one, and the search goes a little beyond one period."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...models.field import BEGIN, TURN
from ...numerics.certified_roots import Roots
from ...numerics.interval_arrays import FloatArray
from .balance import Balance

#: Where the turn ends; the search goes beyond it at both ends.
END = BEGIN + TURN


def once_around(balance: Balance, found: Roots) -> Roots:
    """Roots and boxes that are left, without those whose image after a turn is there too.

    What meets an end of the turn itself, of which this can't be said, is among the boxes that are left.
    """
    if not balance.around:
        return found
    beyond, across = _parted(found.ends, balance.around)
    hidden, _ = _parted(found.left, balance.around)
    open_ = across & ~beyond
    return found.kept(~beyond & ~across, ~hidden).besides(found.ends[:, :, open_], found.point[open_])


def _parted(ends: FloatArray, around: list[int]) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Boxes that lie beyond the turn with one of these unknowns, and boxes that meet an end of it."""
    low, high = -ends[0, around], ends[1, around]
    beyond = np.logical_or.reduce((low > END) | (high < BEGIN))
    across = np.logical_or.reduce((low <= END) & (high >= END) | (low <= BEGIN) & (high >= BEGIN))
    return np.asarray(beyond), np.asarray(across)
