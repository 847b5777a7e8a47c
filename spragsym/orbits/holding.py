"""Rest under a clock: friction holds a state in every phase, by forces enclosed over a turn."""

from __future__ import annotations

import numpy as np

from ..models.parameters import FloatArray
from ..numerics.interval_arrays import Intervals, ends_around, quiet, rounded_outward
from ..numerics.vectors import TURN, magnitude
from ..statics.balance import NOTHING
from ..statics.forces import as_intervals
from ..statics.namespaces import XP
from .system import System

#: Parts of a turn of the clock over which forces are enclosed.
PHASES = 1024

#: What is left of a motion that rests, in its units: all states within it are held.
ROOM = 1e-9


class _Enclosed(Intervals):
    """Intervals that say to a field in which functions it is to be computed."""

    namespace = XP


def held_in_every_phase(system: System, state: FloatArray) -> bool:
    """Whether friction holds all coordinates but the clock's about a state, on belts
    that stand still, in every phase; other contacts then keep their modes.
    """
    field, units, constants = system.field, system.scales(state).states, system.constants
    n, still = len(field.coordinates), state.copy()
    still[n:-1] = 0.0
    if magnitude((state - still) / units) > ROOM:
        return False
    mode = system.mode(still)
    stays = field.stays(mode)
    across = [border.slopes(still.tolist(), constants, mode) for border in stays if border.slopes]
    if not across:
        return False
    speeds = np.array(across, dtype=float)[:, n : 2 * n - 1]
    if np.linalg.matrix_rank(speeds) < n - 1:
        return False
    edges = np.linspace(0.0, rounded_outward(np.array(TURN)), PHASES + 1)
    # Speeds are 0, and places and the clock's rate known to within the room.
    reach = np.where(np.arange(still.size) < n, ROOM * units, 0.0)[:, None]
    ends = ends_around(np.repeat(still[:, None], PHASES, axis=1), reach)
    ends[:, n - 1] = -edges[:-1], edges[1:]
    around = [_Enclosed(row) for row in np.moveaxis(ends, 1, 0)]
    given = [
        Intervals(rounded_outward(np.array([[-one], [one]]), 64.0)) if one else one
        for one in constants
    ]
    with quiet():
        for border in field.borders:
            level = border.level(around, given, mode)
            if border in stays:
                if as_intervals(level, (PHASES,)).magnitude.max() > NOTHING:
                    return False
            elif (
                border.kink
                and not (as_intervals(level * border.sign(mode), (PHASES,)).low > 0).all()
            ):
                return False
    return True
