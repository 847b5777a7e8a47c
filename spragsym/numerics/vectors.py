"""Sizes and differences of vectors, some of whose numbers may be angles that come around."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .interval_arrays import FloatArray

#: Turns after which all is as before: by the place of an angle that makes one, the turns of each
#: angle that moves with it, its own among them.
WholeTurns: TypeAlias = Mapping[int, Mapping[int, int]]
#: A turn of a coordinate that comes around.
TURN = 2 * np.pi
#: Where it begins: no angle that models have, so that rounding decides no state's turn.
TURN_BEGIN = -np.pi + 0.012345


def magnitude(numbers: ArrayLike) -> float:
    """The largest of some numbers, in size."""
    return float(np.abs(numbers).max())


def norm(numbers: ArrayLike) -> float:
    """The Euclidean norm of some numbers."""
    return float(np.linalg.norm(numbers))


def apart(one: ArrayLike, other: ArrayLike, periodic: WholeTurns) -> FloatArray:
    """One state less another, numbers along the last axis, less whole turns: each angle that comes
    around the shorter way.
    """
    off: FloatArray = np.subtract(one, other, dtype=float)
    for index, moved in periodic.items():
        _turned_back(off, np.round(off[..., index] / TURN), moved)
    return off


def in_one_turn(
    state: ArrayLike, periodic: WholeTurns, begin: ArrayLike = TURN_BEGIN
) -> FloatArray:
    """The state less whole turns, each angle that comes around in the one from ``begin`` on."""
    found = np.array(state, dtype=float)
    begins = np.broadcast_to(begin, found.shape)
    for index, moved in periodic.items():
        _turned_back(found, np.floor((found[..., index] - begins[..., index]) / TURN), moved)
    return found


def makes_turns(index: int, periodic: WholeTurns) -> bool:
    """Whether an angle moves in a turn after which all is as before."""
    return any(index in moved for moved in periodic.values())


def _turned_back(state: FloatArray, turns: FloatArray, moved: Mapping[int, int]) -> None:
    for index, count in moved.items():
        state[..., index] -= TURN * (count * turns)
