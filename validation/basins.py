"""Points of stable manifolds by simulations of another integrator: on the boundary of a basin, or
not.

To either side of a point of ``basin_boundary``, 1e-6 across the curve, motions are followed over 40
000 time units: at a boundary their averages differ by far more than they change; where both sides
are said to come to one attractor, they agree. Last found: points said to be on a boundary although
nearer starts come to one attractor (5b4d0b77).
"""

from typing import Any

import numpy as np

import spragsym as ss
from tests.oracles.random_motions import basin_of
from validation.fates import ALIKE, apart, differ, settled

CASES = 30
ASIDE = 1e-6
#: Words for a side of which it is not known what it comes to.
OPEN = ("nothing", "as rounding decides", "nearer by")


def judge(number: int, _: np.random.Generator) -> dict[str, Any]:
    """One curve: of each point whether it is said to be boundary, what either side comes to, and
    whether that is confirmed.
    """
    p = basin_of(number)
    try:
        found = ss.basin_boundary(p, step=0.05, points=2)
    except (ss.errors.ParameterError, ss.errors.ConvergenceError):
        return {"kind": "refused", "wrong": []}
    values = dict(zip(p.ranges, p.scalars(*p.ranges), strict=True))
    wrong, undecided = [], 0
    for i, point in enumerate(found.points):
        along = found.points[min(i + 1, len(found.points) - 1)] - found.points[max(i - 1, 0)]
        across = np.array([-along[1], along[0]]) / np.linalg.norm(along)
        starts = [
            [x, 0.0, vx, 0.0] for x, vx in (point + sign * ASIDE * across for sign in (-1, 1))
        ]
        sides = [settled(values, start)[0] for start in starts]
        off, within = apart(*sides)
        told = found.sides[i].tolist()
        unsaid = any(word in text for text in told for word in OPEN)
        undecided += unsaid
        if not (differ(*sides) if found.boundary[i] else unsaid or off < max(3 * within, ALIKE)):
            wrong.append(
                f"point {i}, boundary {bool(found.boundary[i])}, {told}: averages differ by "
                f"{off:.2g}, change by {within:.1g}"
            )
    return {"kind": "curve", "wrong": wrong, "points": len(found.points), "undecided": undecided}
