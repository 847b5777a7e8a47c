"""Whether a branch of cycles comes back to its first cycle: closed, the other way round, or at a
mirror image of it. Cycles are compared as sets of states, so that their phase does not matter.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ..core.errors import ConvergenceError
from ..models.parameters import FloatArray
from ..motion.shooting import extent
from ..numerics.vectors import TURN
from .arclength import BranchPoint, turning, zero_of
from .events import DetectedEvent
from .orbit import SAME_STATES, Cycle, apart, cycle_of, same_cycle, units_of

#: Kind of the event at which a branch is closed.
CLOSED = "closed"

#: Reasons for which a branch ends that comes back.
CLOSES = "it comes back to its first cycle: the branch is closed"
RETRACES = "it comes back to its first cycle in the other direction, and would retrace itself"
MIRRORED = (
    "it comes to the mirror image of its first cycle; beyond are mirror images of its other cycles"
)

#: Up to so many coordinates mirrors may exchange some; of more, mirrors change all signs.
MOST_EXCHANGED = 5


def returned(
    start: BranchPoint, point: BranchPoint, ahead: BranchPoint, length: float
) -> tuple[BranchPoint, DetectedEvent] | None:
    """The point between two points of a branch at which it comes back to its first cycle, and the
    end there; None if it does not.
    """

    def beyond(at: BranchPoint) -> float:
        return at.value - start.value

    if not beyond(point) or beyond(point) * beyond(ahead) > 0:
        return None
    try:
        back = zero_of(beyond, point, ahead, length)
        one, other = cycle_of(start.orbit), cycle_of(back.orbit)
    except ConvergenceError:
        return None
    if same_cycle(one, other):
        forth = turning(start) * turning(back) > 0
        kind, how = (CLOSED, CLOSES) if forth else ("end", RETRACES)
    elif is_mirrored(one, other):
        kind, how = "end", MIRRORED
    else:
        return None
    return back, DetectedEvent(kind, back.orbit, abs(beyond(back)), how=how)


def is_mirrored(one: Cycle, other: Cycle) -> bool:
    """True if a mirror maps one cycle to the other, at the same values of the parameters.

    A mirror changes signs of coordinates about a centre, and may exchange coordinates. The phase of
    a clock stays, or is shifted by half a turn. The cycles themselves tell the centre.
    """
    if abs(one.period / other.period - 1) >= SAME_STATES or one.orbit.shifted.any():
        return False
    size = max(extent(each.orbit, units_of(one)) for each in (one, other))
    n, clock = len(one.field.coordinates), bool(one.field.clock)
    means, windings = [_means(each) for each in (one, other)], one.orbit.windings
    turning = [index for index, turns in windings.items() if turns]
    for order, signs in _mirrors(n - clock):
        places, sign = [*order, *range(n - clock, n)], np.array([*signs, *[1] * clock])
        centre = means[0] - sign * means[1][places]
        centre[turning] = 0.0
        columns, both = [*places, *(n + i for i in places)], np.tile(sign, 2)
        for shift in (0.0, TURN / 2) if clock else (0.0,):
            if clock:
                centre[-1] = shift
            images = both * other.orbit.states[:, columns] + np.append(centre, np.zeros(n))
            if apart(one, images) < SAME_STATES * size:
                return True
    return False


def _means(cycle: Cycle) -> FloatArray:
    """Means of all coordinates over a period."""
    samples, n = cycle.samples, len(cycle.field.coordinates)
    means: FloatArray = samples.states[:n] @ samples.weights() / cycle.period
    return means


def _mirrors(n: int) -> Iterator[tuple[Sequence[int], Sequence[int]]]:
    """All maps of n coordinates, but the identity, that exchange some and change signs, and that
    done twice are the identity: image i is a sign times the coordinate of an index.
    """
    if n > MOST_EXCHANGED:
        yield range(n), [-1] * n
        return
    found: list[tuple[list[int], list[int]]] = [([0] * n, [0] * n)]
    for i in range(n):
        grown = []
        for order, signs in found:
            if signs[i]:  # exchanged with one before
                grown.append((order, signs))
                continue
            for j in (k for k in range(i, n) if not signs[k]):
                for sign in (-1, 1):
                    places, changed = order.copy(), signs.copy()
                    places[i], places[j], changed[i], changed[j] = j, i, sign, sign
                    grown.append((places, changed))
        found = grown
    yield from (each for each in found if each != ([*range(n)], [1] * n))
