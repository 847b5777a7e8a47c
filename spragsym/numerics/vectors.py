"""Norms of vectors, and differences of states with periodic angles."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from .interval_arrays import FloatArray


class WholeTurns(dict[int, Mapping[int, int]]):
    """Rotations and shifts that leave a model unchanged.

    For the index of a periodic angle, the number of turns that each angle makes with it, itself
    included. ``shifts``, (r, m), are orthonormal directions along which a state may be shifted by
    any amount.
    """

    def __init__(
        self, turns: Mapping[int, Mapping[int, int]] | None = None, shifts: ArrayLike = ()
    ) -> None:
        super().__init__(turns or {})
        self.shifts: FloatArray = np.array(shifts, dtype=float)

    def scaled(self, units: FloatArray) -> WholeTurns:
        """The same of states in these units."""
        if not len(self.shifts):
            return self
        return WholeTurns(self, np.linalg.qr((self.shifts / units).T)[0].T)

    def unshifted(self, states: FloatArray) -> FloatArray:
        """States, along the last axis, without their components along the shifts."""
        if not len(self.shifts):
            return states
        rows = self.shifts[:, : states.shape[-1]]
        found: FloatArray = states - (states @ rows.T) @ rows
        return found


#: Period of an angle.
TURN = 2 * np.pi
#: Lower end of the turn to which angles are reduced. States are not near it by symmetry, so that
#: rounding does not decide to which turn they belong.
TURN_BEGIN = -np.pi + 0.012345


def magnitude(numbers: ArrayLike) -> float:
    """Largest absolute value (maximum norm)."""
    return float(np.abs(numbers).max())


def norm(numbers: ArrayLike) -> float:
    """Euclidean norm."""
    return float(np.linalg.norm(numbers))


def state_difference(one: ArrayLike, other: ArrayLike, periodic: WholeTurns) -> FloatArray:
    """``one`` − ``other``, states along the last axis, modulo turns and shifts: periodic angles
    differ by at most half a turn.
    """
    found: FloatArray = np.subtract(one, other, dtype=float)
    for index, turns_with in periodic.items():
        _rotate_back(found, np.round(found[..., index] / TURN), turns_with)
    return periodic.unshifted(found)


def in_one_turn(
    state: ArrayLike, periodic: WholeTurns, begin: ArrayLike = TURN_BEGIN
) -> FloatArray:
    """The state modulo turns, each periodic angle in the turn that begins at ``begin``."""
    found = np.array(state, dtype=float)
    begins = np.broadcast_to(begin, found.shape)
    for index, turns_with in periodic.items():
        turns = np.floor((found[..., index] - begins[..., index]) / TURN)
        _rotate_back(found, turns, turns_with)
    return found


def makes_turns(index: int, periodic: WholeTurns) -> bool:
    """Whether an angle moves in a rotation that leaves the model unchanged."""
    return any(index in turns_with for turns_with in periodic.values())


def _rotate_back(state: FloatArray, turns: FloatArray, turns_with: Mapping[int, int]) -> None:
    for index, count in turns_with.items():
        state[..., index] -= TURN * (count * turns)
