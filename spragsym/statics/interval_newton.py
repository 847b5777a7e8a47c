"""Interval Newton with forces of many digits, for roots that floats know to few digits."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..numerics import contractors
from ..numerics.boxes import System
from ..numerics.certified_roots import relative_error
from ..numerics.interval_arrays import FloatArray, Intervals
from ..numerics.krawczyk import as_intervals, ball
from ..numerics.polynomials import Undecided
from .mechanics.precise_balance import BITS, TOLERANCE, Precise

#: Steps of interval Newton, of which each doubles the number of digits.
STEPS = 8


def refined(
    system: System,
    given: FloatArray,
    ends: FloatArray,
    point: NDArray[np.int64],
    precise: Precise,
    among: NDArray[np.bool_] | None = None,
) -> FloatArray:
    """Boxes that hold the same roots, narrower where the error is beyond :data:`.mechanics.precise_balance.TOLERANCE`.

    Only the forces at the middle of a box need digits: floats enclose the slopes well, and their errors shrink with the box.

    Parameters
    ----------
    given : ndarray
        Parameters, shape (parameters, points).
    ends : ndarray
        Boxes that hold one root each, shape (2, n, roots).
    point : ndarray
        The point of each.
    precise : callable
        The system at one point with a number of bits.
    among : ndarray of bool, optional
        Others that are narrowed, too.
    """
    ends = ends.copy()
    chosen = ~(relative_error(ends, Intervals(ends).middle) <= TOLERANCE)
    chosen = chosen if among is None else chosen | among
    with np.errstate(all="ignore"):
        for root in np.flatnonzero(chosen):
            here = slice(root, root + 1)
            column = given[:, point[root]]
            ends[:, :, here] = _narrowed(system, column, ends[:, :, here], precise)
    return ends


def _narrowed(system: System, given: FloatArray, ends: FloatArray, precise: Precise) -> FloatArray:
    """One box of shape (2, n, 1), as narrow as floats can say."""
    parameters, evaluate = system.prepared(Intervals.point(given[:, None])), precise(given, BITS[0])
    for _ in range(STEPS):
        box = Intervals(ends)
        middle = box.middle
        try:
            values = evaluate([ball(value, BITS[0]) for value in middle[:, 0].tolist()])
        except Undecided:
            break
        reach = contractors.distance(ends, middle)
        step = contractors.newton(as_intervals(values), system.jacobian(box, parameters), middle, reach)
        new = np.fmin(step.ends, ends)
        if not (new < ends).any():
            break
        ends = new
    return ends
