"""Types of equilibria by signs that are proved: whether all roots κ = −λ² of det(K − κ M) are real, and whether one is negative.

All are real where the leading minors of the Hankel matrix of their sums of powers are positive, and not all where one is negative
(Hermite); where K is symmetric they are in any case. Of a polynomial whose roots are all real, one is negative just if one of
their elementary symmetric functions is. Signs come from intervals around the state, and where these hold 0 from many digits.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..exact import contractors
from ..exact.ball_functions import XP as BALLS
from ..exact.interval_arrays import FloatArray, Intervals, stacked
from ..exact.intervals import Ball, Balls
from ..exact.polynomials import Undecided
from ..statics.solver import Stability
from .balance import NOTHING, Balance, matrix
from .conditions import Polynomial, determinant
from .precise import PreciseBalance, ball

#: Bits of the numbers where intervals of floats do not tell a sign, and steps of Newton's method.
BITS, STEPS = 256, 40
#: Step of Newton's method after which there is no further one.
ENOUGH = Fraction(1, 2**160)


def classified(
    balance: Balance, given: FloatArray, ends: FloatArray, alone: FloatArray
) -> tuple[NDArray[np.int8], NDArray[np.bool_]]:
    """Codes of :class:`spragsym.Stability`, and whether each is proved; a sign that is not known counts as that of 0.

    Parameters
    ----------
    given : ndarray
        Parameters, shape (P, N).
    ends : ndarray
        Boxes with one equilibrium each, shape (2, n, N).
    alone : ndarray
        Larger boxes in which that is the only one.
    """
    shape = ends.shape[2:]
    with np.errstate(all="ignore"):
        parameters = balance.prepared(Intervals.point(given))
        q, values = list(Intervals(ends)), balance.arguments(parameters)
        K = matrix(balance.by_coordinate("forces_jacobian", q, balance.directions(q, values, shape), values), shape)
        parts = invariants(list(map(list, K)), list(map(list, matrix(balance.mass(q, values), shape))))
        elementary, minors = (_signs(part, shape) for part in parts)
        friction = stacked([balance.friction(values)], shape)[0].magnitude
    # Without friction K is symmetric if the page's other forces have a potential; in lift-off there is no friction.
    symmetric = bool(balance.model.about.get("symmetric"))
    conservative = symmetric & ((friction <= NOTHING) | (balance.opens and not balance.contact))
    codes, proved = _told(elementary, minors, conservative)
    for row in np.flatnonzero(~proved).tolist():
        again = _with_digits(balance, given[:, row], ends[:, :, row], alone[:, :, row])
        if again is not None:
            codes[row : row + 1], proved[row : row + 1] = _told(*again, conservative[row : row + 1])
    return codes, proved


def invariants(K: Sequence[Sequence[Any]], M: Sequence[Sequence[Any]]) -> tuple[list[Any], list[Any]]:
    """Elementary symmetric functions e₁ … eₙ of the κ, and the minors of sizes 2 to n of Hermite's matrix, of any number type."""
    n = len(K)
    rows = [[Polynomial([K[i][j], -M[i][j]]) for j in range(n)] for i in range(n)]
    # det(K − κ M) = det M Π (κ_i − κ): the coefficient of κᵏ is (−1)ᵏ e_{n−k} det M.
    coefficients = [(-1) ** k * value for k, value in enumerate(determinant(rows).padded(n + 1))]
    e = [1, *(coefficients[n - k] / coefficients[n] for k in range(1, n + 1))]
    sums: list[Any] = [n]
    for k in range(1, 2 * n - 1):
        newton: Any = (-1) ** (k - 1) * k * e[k] if k <= n else 0
        for i in range(1, min(k - 1, n) + 1):
            newton = newton + (-1) ** (i - 1) * e[i] * sums[k - i]
        sums.append(newton)
    hermite = [[sums[i + j] for j in range(n)] for i in range(n)]
    return e[1:], [determinant([row[:size] for row in hermite[:size]]) for size in range(2, n + 1)]


def _signs(values: Sequence[Any], shape: tuple[int, ...]) -> NDArray[np.int8]:
    if not values:
        return np.zeros((0, *shape), dtype=np.int8)
    known = stacked(values, shape)
    return (known.low > 0).astype(np.int8) - (known.high < 0).astype(np.int8)


def _told(
    elementary: NDArray[np.int8], minors: NDArray[np.int8], conservative: NDArray[np.bool_]
) -> tuple[NDArray[np.int8], NDArray[np.bool_]]:
    """Codes, and whether the signs that are known decide them; 0 for a sign that is not known."""
    flutter = (minors < 0).any(axis=0) & ~conservative
    real = conservative | (minors > 0).all(axis=0)
    divergent = (elementary < 0).any(axis=0)
    code = np.where(flutter, Stability.FLUTTER, np.where(divergent, Stability.DIVERGENT, Stability.STABLE)).astype(np.int8)
    return code, flutter | (real & (divergent | (elementary > 0).all(axis=0)))


def _with_digits(
    balance: Balance, given: FloatArray, box: FloatArray, alone: FloatArray
) -> tuple[NDArray[np.int8], NDArray[np.int8]] | None:
    """The signs at one state with many digits; None where the box around it can't be made smaller."""
    precise = PreciseBalance(balance, given, BITS)
    try:
        q = _narrowed(precise, box, alone)
        if q is None:
            return None
        directions = balance.plain_directions(q, precise.values, BALLS)
        K = balance.by_coordinate("forces_jacobian", q, directions, precise.values, BALLS)
        parts = invariants(_as_balls(K), _as_balls(balance.mass(q, precise.values, BALLS)))
    except (Undecided, ZeroDivisionError):
        return None
    elementary, minors = (np.array([[Balls().sign(value)] for value in part], dtype=np.int8).reshape(-1, 1) for part in parts)
    return elementary, minors


def _narrowed(precise: PreciseBalance, box: FloatArray, alone: FloatArray) -> list[Ball] | None:
    """A box of balls around the root in a box of floats; both of shape (2, n).

    Newton's method leads to a point z. Where |1 − Y J| is at most 1/2 in a box of half-width r around z, and r not less than
    2 |Y F(z)|, the operator x − Y F(x) maps that box into itself: so it holds a root, the only one of ``alone``.
    """
    z = [ball(float(value), BITS) for value in Intervals(box).middle]
    for _ in range(STEPS):
        Y = _inverse(_slopes(precise, z))
        step = [_dot(row, precise.forces(z)) for row in Y]
        size = _norm(step)
        if size <= ENOUGH:
            return _proved(precise, z, 2 * size, Y, alone)
        z = [Balls().middle(part - change) for part, change in zip(z, step, strict=True)]
    return None


def _proved(
    precise: PreciseBalance, z: Sequence[Ball], r: Fraction, Y: Sequence[Sequence[Ball]], alone: FloatArray
) -> list[Ball] | None:
    """The box of half-width r around z if it is shown to hold the root."""
    with Balls().precision(BITS):
        around = [part + Balls().between(-r, r) for part in z]
    columns = list(zip(*_slopes(precise, around), strict=True))
    off = [[_dot(row, column) - int(i == j) for j, column in enumerate(columns)] for i, row in enumerate(Y)]
    within = all(
        Fraction(-float(low)) <= Balls().ends(part)[0] and Balls().ends(part)[1] <= Fraction(float(high))
        for part, (low, high) in zip(around, alone.T, strict=True)
    )
    return around if within and max(map(_norm, off)) <= Fraction(1, 2) else None


def _slopes(precise: PreciseBalance, q: Sequence[Ball]) -> list[list[Ball]]:
    """Slopes of the forces in a box."""
    balance = precise.balance
    return _as_balls(
        balance.call("forces_jacobian", q, balance.plain_directions(q, precise.values, BALLS), precise.values, BALLS)
    )


def _inverse(rows: Sequence[Sequence[Ball]]) -> list[list[Ball]]:
    """The inverse of the matrix of middles, roughly, of balls without width."""
    middles = np.array([[float(sum(Balls().ends(entry)) / 2) for entry in row] for row in rows])
    with np.errstate(all="ignore"):
        return [[ball(float(entry), BITS) for entry in row] for row in contractors.inverse(middles[:, :, None])[:, :, 0]]


def _dot(row: Sequence[Ball], column: Sequence[Ball]) -> Ball:
    return sum((a * b for a, b in zip(row, column, strict=True)), Ball(0, 0, 0, BITS))


def _norm(values: Sequence[Ball]) -> Fraction:
    """Bound on the sum of |x|."""
    return sum((max(map(abs, Balls().ends(value))) for value in values), Fraction(0))


def _as_balls(rows: Sequence[Sequence[Any]]) -> list[list[Ball]]:
    """Entries that are numbers as balls, too."""
    return [[entry if isinstance(entry, Ball) else ball(float(entry), BITS) for entry in row] for row in rows]
