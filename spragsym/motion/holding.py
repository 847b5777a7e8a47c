"""Rest under a clock: friction holds a state in every phase, by forces enclosed over a turn."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from ..models.field import Field, Mode, Values
from ..models.parameters import FloatArray
from ..numerics.interval_arrays import (
    Intervals,
    ends_around,
    quiet,
    rounded_outward,
    stacked,
)
from ..numerics.vectors import TURN, magnitude
from ..statics.balance import NEGLIGIBLE
from ..statics.forces import as_intervals
from ..statics.namespaces import XP
from .scales import scales_of

#: Parts of a turn of the clock over which forces are enclosed.
PHASES = 1024


class _Enclosed(Intervals):
    """Intervals that say to a field in which functions it is to be computed."""

    namespace = XP


def held_in_every_phase(field: Field, constants: Values, state: FloatArray) -> bool:
    """Whether friction holds all coordinates but the clock's about a state, on belts that stand
    still, in every phase; other contacts then keep their modes.
    """
    n, still = len(field.coordinates), state.copy()
    still[n:-1] = 0.0
    units = scales_of(field, constants, state.tolist()).states
    # What is left of a motion that rests, in its units: all states within it are held.
    left = 1e-9
    if magnitude((state - still) / units) > left:
        return False
    return held_along(field, constants, still, still, left * units[:n])


def held_along(
    field: Field, constants: Values, one: FloatArray, other: FloatArray, room: FloatArray
) -> bool:
    """The same of all places within the room of the straight line between two states without
    speeds.
    """
    n, mode = len(field.coordinates), field.initial_mode(one.tolist(), constants)
    if not field.stays(mode):
        return False
    edges = np.linspace(0.0, rounded_outward(np.array(TURN)), PHASES + 1)
    # Speeds are 0, and places and the clock's rate known to within the room.
    reach = np.zeros(one.size)
    reach[:n] = room
    # Parts of a line between two places over which they are.
    pieces = np.linspace(one, other, 2 if (one == other).all() else 33)
    given = [
        Intervals(rounded_outward(np.array([[-number], [number]]), 64.0)) if number else number
        for number in constants
    ]
    # Of the halves of a part, generously.
    rounding = 1e-9
    for begin, end in pairwise(pieces):
        middle, half = (begin + end) / 2, np.abs(end - begin) / 2
        ends = ends_around(
            np.repeat(middle[:, None], PHASES, axis=1), (reach + half * (1 + rounding))[:, None]
        )
        ends[:, n - 1] = -edges[:-1], edges[1:]
        enclosures = [_Enclosed(row) for row in np.moveaxis(ends, 1, 0)]
        if not (
            _is_held(field, mode, enclosures, given) and _stills(field, mode, enclosures, given)
        ):
            return False
    return True


def _stills(field: Field, mode: Mode, states: Sequence[Any], given: Sequence[Any]) -> bool:
    """Whether over boxes of states nothing moves but the clock where the sliding speeds that are
    held are 0: their derivatives A by the rates have full rank. That is so where |1 − R A| < 1 for
    any R; it is found in floats, of the middles with rows and columns of the size 1, and what is
    less than 1/2 is less than 1 whatever the rounding of a sum.
    """
    n, stays = len(field.coordinates), [each for each in field.stays(mode) if each.slopes]
    with quiet():
        rows = [each.slopes(states, given, mode)[n : 2 * n - 1] for each in stays if each.slopes]
        entries = stacked([entry for row in rows for entry in row], (PHASES,))
        middle = entries.middle[:, 0].reshape(len(rows), n - 1)
        sizes = np.abs(middle).max(axis=1, keepdims=True, initial=NEGLIGIBLE)
        widths = np.abs(middle / sizes).max(axis=0, initial=NEGLIGIBLE)
        widths = np.exp2(np.round(np.log2(widths)))  # so that quotients are exact
        inverse, off = np.linalg.pinv(middle / sizes / widths) / sizes.T, np.zeros((n - 1, PHASES))
        for i, j in np.ndindex(n - 1, n - 1):
            total = Intervals.point(np.full(PHASES, -1.0 * (i == j)))
            for k in range(len(rows)):
                total = total + entries[k * (n - 1) + j] * float(inverse[i, k] / widths[j])
            off[i] = off[i] + total.magnitude
    return bool((off < 0.5).all())


def _is_held(field: Field, mode: Mode, states: Sequence[Any], given: Sequence[Any]) -> bool:
    """Whether a mode lasts over boxes of states: what stays on a border is on it, and all else is
    inside.
    """
    stays = field.stays(mode)
    with quiet():
        for border in field.borders:
            level = border.level(states, given, mode)
            if border in stays:
                if as_intervals(level, (PHASES,)).magnitude.max() > NEGLIGIBLE:
                    return False
            elif (
                border.kink
                and not (as_intervals(level * border.sign(mode), (PHASES,)).low > 0).all()
            ):
                return False
    return True
