"""Sizes and differences of vectors, some of whose numbers may be angles that come around."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from .interval_arrays import FloatArray

#: A turn of a coordinate that comes around.
TURN = 2 * np.pi
#: Where it begins: no angle that models have, so that rounding decides no state's turn.
BEGIN = -np.pi + 0.012345


def magnitude(numbers: ArrayLike) -> float:
    """The largest of some numbers, in size."""
    return float(np.abs(numbers).max())


def norm(numbers: ArrayLike) -> float:
    """The Euclidean norm of some numbers."""
    return float(np.linalg.norm(numbers))


def apart(one: ArrayLike, other: ArrayLike, periodic: Sequence[int]) -> FloatArray:
    """One state less another, numbers along the last axis; of coordinates that come ``periodic``
    the shorter way.
    """
    off: FloatArray = np.subtract(one, other, dtype=float)
    for place in periodic:
        off[..., place] -= TURN * np.round(off[..., place] / TURN)
    return off


def in_one_turn(state: FloatArray, periodic: Sequence[int]) -> FloatArray:
    """The state with periodic coordinates in the turn from :data:`BEGIN` on."""
    found = np.array(state, dtype=float)
    for place in periodic:
        found[..., place] -= TURN * np.floor((found[..., place] - BEGIN) / TURN)
    return found
