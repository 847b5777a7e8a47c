"""Roots that are proved but known to few digits, as with stiff springs: interval Newton with many digits on the box of each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from ..exact.certified_roots import Roots
from ..exact.elimination import solved
from ..exact.interval_arrays import FloatArray
from ..exact.intervals import Ball, Balls
from ..exact.jets import constant, gradient, variables
from ..exact.polynomials import Undecided
from ..exact.reduction import Evaluate, largest_pivot
from .balance import Balance
from .precise import BITS, TOLERANCE, PreciseBalance

_BALLS = Balls()
#: Steps on one root: each squares the width.
STEPS = 8


def refined(balance: Balance, given: FloatArray, found: Roots) -> Roots:
    """The same roots, those with an error beyond the tolerance in narrower boxes where the forces are regular there.

    Every box holds one root, and interval Newton loses none: the narrower box holds it too.

    Parameters
    ----------
    given : ndarray
        Parameters, shape (parameters, points).
    """
    poor = np.flatnonzero(~(found.error <= TOLERANCE))
    if not poor.size:
        return found
    ends = found.ends.copy()
    for row in poor.tolist():
        forces = PreciseBalance(balance, given[:, found.point[row]], BITS[0]).forces
        ends[:, :, row] = np.minimum(ends[:, :, row], _narrowed(forces, ends[:, :, row]))
    return replace(found, ends=ends)


def _narrowed(forces: Evaluate, ends: FloatArray) -> FloatArray:
    """A box within a box, as −low and high, with the same root."""
    box = [(-Fraction(low), Fraction(high)) for low, high in ends.T.tolist()]
    with _BALLS.precision(BITS[0]):
        for _ in range(STEPS):
            try:
                new = _step(forces, box)
            except (Undecided, ZeroDivisionError):
                break
            narrower = any(2 * (b - a) < high - low for (a, b), (low, high) in zip(new, box, strict=True))
            box = new
            if not narrower:
                break
    sides = np.array([[-float(low) for low, _ in box], [float(high) for _, high in box]])
    out: FloatArray = np.nextafter(sides, np.inf)
    return out


def _step(forces: Evaluate, box: Sequence[tuple[Fraction, Fraction]]) -> list[tuple[Fraction, Fraction]]:
    """A box that holds middle − J(box)⁻¹ forces(middle), as the root does."""
    n = len(box)
    middles = [(low + high) / 2 for low, high in box]
    rows = forces(variables([_BALLS.between(low, high) for low, high in box], 1))
    values = [constant(value) for value in forces([_BALLS.exact(middle) for middle in middles])]
    steps = solved([gradient(row, n) for row in rows], values, largest_pivot)
    out = []
    for (low, high), middle, step in zip(box, middles, steps, strict=True):
        least, most = _BALLS.ends(step) if isinstance(step, Ball) else (Fraction(step), Fraction(step))
        out.append((max(low, middle - most), min(high, middle - least)))
        if out[-1][0] > out[-1][1]:  # can't happen: the box holds a root
            raise ArithmeticError("a box with a root has none")
    return out
