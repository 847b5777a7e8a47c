"""Proof that friction holds a state of rest in every phase of a clock.

A model with a clock is driven periodically. At rest only the clock's phase moves. Interval
arithmetic encloses the forces over each of :data:`PHASES` parts of a period, with the coordinates
in a box. The state is held if in each part the holding friction stays below its limit, the other
contacts keep their modes, and vanishing sliding speeds leave no coordinate free to move.
"""

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

#: Number of parts of a clock's period over which forces are enclosed.
PHASES = 1024


class _Enclosed(Intervals):
    """Intervals that bring the functions (sin, sqrt, ...) with which a field is evaluated."""

    namespace = XP


def held_in_every_phase(field: Field, constants: Values, state: FloatArray) -> bool:
    """True if friction is proved to hold all states near ``state`` at rest, in every phase of the
    clock, and the other contacts to keep their modes.

    False for a state whose rates are not negligible, and where the proof fails.
    """
    n, at_rest = len(field.coordinates), state.copy()
    at_rest[n:-1] = 0.0
    units = scales_of(field, constants, state.tolist()).states
    # Rates below this, in units of the motion, are taken for rest.
    negligible = 1e-9
    if magnitude((state - at_rest) / units) > negligible:
        return False
    return held_along(field, constants, at_rest, at_rest, negligible * units[:n])


def held_ahead(
    field: Field, constants: Values, first: FloatArray, last: FloatArray, reach: float
) -> FloatArray | None:
    """The nearest state that friction is proved to hold in every phase, straight ahead of a motion
    that goes from ``first`` to ``last`` and creeps: by less than ``reach``, in units of the motion,
    and with no farther to go. None if there is none.

    Where a force passes the limit of friction by a little in each turn, the mass comes to rest at
    that limit, but never is there.
    """
    n = len(field.coordinates) - 1
    units = scales_of(field, constants, last.tolist()).states[:n]
    moved = (last - first)[:n] / units
    if not 0 < magnitude(moved) <= reach:
        return None

    def ahead(share: float) -> FloatArray:
        place = last[:n] + share * reach * units * moved / magnitude(moved)
        return np.array([*field.at_rest([*place.tolist(), last[n]], constants)])

    low, high = 0.0, 1.0
    if not held_in_every_phase(field, constants, ahead(high)):
        return None
    for _ in range(20):
        middle = (low + high) / 2
        if held_in_every_phase(field, constants, ahead(middle)):
            high = middle
        else:
            low = middle
    return ahead(high)


def held_along(
    field: Field, constants: Values, one: FloatArray, other: FloatArray, radius: FloatArray
) -> bool:
    """True if the proof succeeds for all states of rest on the straight segment from ``one`` to
    ``other``, and around it up to ``radius`` (n,) in each coordinate.
    """
    n, mode = len(field.coordinates), field.initial_mode(one.tolist(), constants)
    if not field.stays(mode):
        return False
    phases = np.linspace(0.0, rounded_outward(np.array(TURN)), PHASES + 1)
    margin = np.zeros(one.size)  # rates are exact
    margin[:n] = radius
    # Shorter pieces of the segment give smaller boxes, and so tighter enclosures.
    nodes = np.linspace(one, other, 2 if (one == other).all() else 33)
    enclosed_constants = [
        Intervals(rounded_outward(np.array([[-number], [number]]), 64.0)) if number else number
        for number in constants
    ]
    # More than the relative rounding error of a half-width.
    rounding = 1e-9
    for begin, end in pairwise(nodes):
        middle, half = (begin + end) / 2, np.abs(end - begin) / 2
        ends = ends_around(
            np.repeat(middle[:, None], PHASES, axis=1), (margin + half * (1 + rounding))[:, None]
        )
        ends[:, n - 1] = -phases[:-1], phases[1:]
        boxes = [_Enclosed(row) for row in np.moveaxis(ends, 1, 0)]
        if not _keeps_mode(field, mode, boxes, enclosed_constants):
            return False
        if not _has_full_rank(field, mode, boxes, enclosed_constants):
            return False
    return True


def _has_full_rank(field: Field, mode: Mode, states: Sequence[Any], given: Sequence[Any]) -> bool:
    """True if vanishing sliding speeds leave only the clock moving, over boxes of states.

    The matrix A of the derivatives of the held sliding speeds by the rates must have full column
    rank. That is so if ‖1 − R A‖ < 1 for some matrix R; here R is an approximate pseudo-inverse of
    the midpoint of A, whose rows and columns are scaled to size 1. The norm is required to be
    below 1/2, which covers the rounding of the sums.
    """
    n, stays = len(field.coordinates), [each for each in field.stays(mode) if each.slopes]
    with quiet():
        rows = [each.slopes(states, given, mode)[n : 2 * n - 1] for each in stays if each.slopes]
        entries = stacked([entry for row in rows for entry in row], (PHASES,))
        middle = entries.middle[:, 0].reshape(len(rows), n - 1)
        row_sizes = np.abs(middle).max(axis=1, keepdims=True, initial=NEGLIGIBLE)
        column_sizes = np.abs(middle / row_sizes).max(axis=0, initial=NEGLIGIBLE)
        column_sizes = np.exp2(np.round(np.log2(column_sizes)))  # powers of 2 divide exactly
        inverse = np.linalg.pinv(middle / row_sizes / column_sizes) / row_sizes.T
        norms = np.zeros((n - 1, PHASES))
        for i, j in np.ndindex(n - 1, n - 1):
            entry = Intervals.point(np.full(PHASES, -1.0 * (i == j)))
            for k in range(len(rows)):
                entry = entry + entries[k * (n - 1) + j] * float(inverse[i, k] / column_sizes[j])
            norms[i] = norms[i] + entry.magnitude
    return bool((norms < 0.5).all())


def _keeps_mode(field: Field, mode: Mode, states: Sequence[Any], given: Sequence[Any]) -> bool:
    """True if a mode lasts over boxes of states: they lie on each border on which the mode stays,
    and inside all others.
    """
    stays = field.stays(mode)
    with quiet():
        for border in field.borders:
            level = border.level(states, given, mode)
            if border in stays:
                if as_intervals(level, (PHASES,)).magnitude.max() > NEGLIGIBLE:
                    return False
            elif border.kink:
                inside = as_intervals(level * border.sign(mode), (PHASES,))
                if not (inside.low > 0).all():
                    return False
    return True
