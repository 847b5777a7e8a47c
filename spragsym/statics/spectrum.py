"""Types of equilibria by signs that are proved: whether all roots κ = −λ² of det(K − κ M) are real, and whether one is negative.

All are real where the leading minors of the Hankel matrix of their sums of powers are positive, and not all where one is negative
(Hermite); where K is symmetric they are in any case. Of a polynomial whose roots are all real, one is negative just if one of
their elementary symmetric functions is. Signs come from intervals around the state, and where these hold 0 from many digits.
"""

from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import Any, TypeAlias

import numpy as np

from ..numerics import balls
from ..numerics.arithmetic import Matrix, characteristic, determinant, hurwitz
from ..numerics.balls import XP as BALLS
from ..numerics.balls import Undecided, ball
from ..numerics.interval_arrays import BoolArray, FloatArray, Int8Array, Intervals, Shape, matrix, stacked
from ..numerics.precise_roots import as_balls, narrowed
from ..results.equilibria import Stability
from .mechanics.balance import NOTHING, Balance
from .mechanics.precise_balance import PreciseBalance
from .mechanics.state import State

#: Bits of the numbers where intervals of floats do not tell a sign.
BITS = 256
#: Numbers whose signs are asked for at a state of balls of so many bits.
Ask: TypeAlias = Callable[[State, int], Matrix]


def classified(balance: Balance, given: FloatArray, ends: FloatArray, alone: FloatArray) -> tuple[Int8Array, BoolArray]:
    """Codes of :class:`spragsym.Stability`, and whether each is proved; a sign that is not known counts as that of 0.

    ``given`` are parameters, shape (P, N), ``ends`` boxes with one equilibrium each, shape (2, n, N), the only one in those of
    ``alone``.
    """
    with np.errstate(all="ignore"):
        elementary, minors, conservative = _over(balance, balance.prepared(Intervals.point(given)), ends)
    codes, proved = _told(elementary, minors, conservative)
    for row in np.flatnonzero(~proved).tolist():
        again = _with_digits(balance, given[:, row], ends[:, :, row], alone[:, :, row], _types)
        if again is not None:
            codes[row : row + 1], proved[row : row + 1] = _told(again[0], again[1], conservative[row : row + 1])
    return codes, proved


def real(balance: Balance, parameters: Intervals, ends: FloatArray) -> BoolArray:
    """Boxes of coordinates and prepared parameters all over which all κ are proved to be real, those that meet included."""
    _, minors, conservative = _over(balance, parameters, ends)
    return np.asarray(conservative | (minors > 0).all(axis=0))


def _over(balance: Balance, parameters: Intervals, ends: FloatArray) -> tuple[Int8Array, Int8Array, BoolArray]:
    """Signs of the elementary symmetric functions and of Hermite's minors over boxes, and where K is symmetric."""
    at = State(balance, list(Intervals(ends)), balance.arguments(parameters), ends.shape[2:])
    elementary, minors = invariants(*(_rows(matrix(part, at.shape)) for part in (at.stiffness(), at.mass())))
    return _signs(elementary, at.shape), _signs(minors, at.shape), without_flutter(balance, parameters)


def without_flutter(balance: Balance, parameters: Intervals) -> BoolArray:
    """Parameters, of shape (…, N), for which all κ are real whatever the state is: K is symmetric, or one number."""
    shape = parameters.shape[1:]
    friction = stacked([balance.friction(balance.arguments(parameters))], shape)[0].magnitude
    # Without friction K is symmetric if the page's other forces have a potential; in lift-off there is no friction.
    symmetric = bool(balance.model.about.get("symmetric"))
    frictionless = (friction <= NOTHING) | (balance.opens and not balance.contact)
    return np.asarray((symmetric & frictionless) | (balance.n == 1))


def decay(
    balance: Balance, given: FloatArray, ends: FloatArray, alone: FloatArray, undamped: Int8Array, growth: FloatArray
) -> Int8Array:
    """What all λ of det(λ² M + λ C + K) = 0 do: 1 where it is proved that none grows, −1 that one does, 0 where it is not known.

    All decay just where the coefficients of that polynomial and Hurwitz's determinants are positive; where one of these is
    negative some λ has a positive real part, since without such all would be limits of positive ones. Where these are not told
    from 0, as of damping that is next to nothing, the same test right of half the ``growth`` of floats tells that one grows.
    Arguments as for :func:`classified`; ``undamped`` says the same of λ² M + K, which counts where C is 0: there every second
    coefficient is 0.
    """
    shape = ends.shape[2:]
    with np.errstate(all="ignore"):
        at = State(balance, list(Intervals(ends)), balance.over(Intervals.point(given)), shape)
        M, C, K = (matrix(part, shape) for part in (at.mass(), at.damping(), at.stiffness()))
        without = C.magnitude.max(axis=(0, 1)) <= NOTHING
        half = np.where(growth > 0, 0.5 * growth, 0.0)
        signs = [_signs(part, shape) for part in _routh_twice(_rows(M), _rows(C), _rows(K), Intervals.point(half))]
        found = np.where(without & (undamped != 0), undamped, _told_to_decay(signs)).astype(np.int8)
    for row in np.flatnonzero(found == 0).tolist():
        shift = ball(float(half[row]), BITS)

        def ask(at: State, bits: int, shift: Any = shift) -> Matrix:
            M, C, K = (as_balls(part, bits) for part in (at.mass(), at.damping(), at.stiffness()))
            return _routh_twice(M, C, K, shift)

        again = _with_digits(balance, given[:, row], ends[:, :, row], alone[:, :, row], ask)
        if again is not None:
            found[row : row + 1] = _told_to_decay(again)
    return found


def _rows(part: Intervals) -> list[list[Any]]:
    return list(map(list, part))


def _types(at: State, bits: int) -> Matrix:
    """:func:`invariants` of balls."""
    return invariants(*(as_balls(part, bits) for part in (at.stiffness(), at.mass())))


def _routh_twice(M: Matrix, C: Matrix, K: Matrix, shift: Any) -> list[list[Any]]:
    """:func:`_routh` for the imaginary axis, and for the line right of it by ``shift``."""
    moved = [[k + shift * (c + shift * m) for m, c, k in zip(*rows, strict=True)] for rows in zip(M, C, K, strict=True)]
    damped = [[c + 2 * shift * m for m, c in zip(*rows, strict=True)] for rows in zip(M, C, strict=True)]
    return [_routh(M, C, K), _routh(M, damped, moved)]


def _routh(M: Matrix, C: Matrix, K: Matrix) -> list[Any]:
    """The coefficients, and all determinants of Hurwitz but the first and the last, which add nothing."""
    a = characteristic(K, C, M)
    return [*a, *(hurwitz(a, size) for size in range(2, len(a) - 1))]


def _told_to_decay(signs: Sequence[Int8Array]) -> Int8Array:
    """1 where nothing grows, −1 where something does, by the signs of :func:`_routh_twice`; of the second that it grows only."""
    here, beyond = (np.where((part > 0).all(axis=0), 1, np.where((part < 0).any(axis=0), -1, 0)) for part in signs)
    return np.where(here != 0, here, np.minimum(beyond, 0)).astype(np.int8)


def invariants(K: Matrix, M: Matrix) -> tuple[list[Any], list[Any]]:
    """Elementary symmetric functions e₁ … eₙ of the κ, and the minors of sizes 2 to n of Hermite's matrix, of any number type."""
    n = len(K)
    # det(K + κ M) = det M Π (κ_i + κ): the coefficient of κᵏ is e_{n−k} det M.
    coefficients = characteristic(K, M)
    e = [1, *(coefficients[n - k] / coefficients[n] for k in range(1, n + 1))]
    sums: list[Any] = [n]
    for k in range(1, 2 * n - 1):
        newton: Any = (-1) ** (k - 1) * k * e[k] if k <= n else 0
        for i in range(1, min(k - 1, n) + 1):
            newton = newton + (-1) ** (i - 1) * e[i] * sums[k - i]
        sums.append(newton)
    hermite = [[sums[i + j] for j in range(n)] for i in range(n)]
    return e[1:], [determinant([row[:size] for row in hermite[:size]]) for size in range(2, n + 1)]


def _signs(values: Sequence[Any], shape: Shape) -> Int8Array:
    if not values:
        return np.zeros((0, *shape), dtype=np.int8)
    known = stacked(values, shape)
    return (known.low > 0).astype(np.int8) - (known.high < 0).astype(np.int8)


def _told(elementary: Int8Array, minors: Int8Array, conservative: BoolArray) -> tuple[Int8Array, BoolArray]:
    """Codes, and whether the signs that are known decide them; 0 for a sign that is not known."""
    flutter = (minors < 0).any(axis=0) & ~conservative
    real = conservative | (minors > 0).all(axis=0)
    divergent = (elementary < 0).any(axis=0)
    code = np.where(flutter, Stability.FLUTTER, np.where(divergent, Stability.DIVERGENT, Stability.STABLE)).astype(np.int8)
    return code, flutter | (real & (divergent | (elementary > 0).all(axis=0)))


def _with_digits(
    balance: Balance, given: FloatArray, box: FloatArray, alone: FloatArray, ask: Ask
) -> list[Int8Array] | None:  # fmt: skip
    """Signs at one state with many digits, of what is asked; None where the box around the state can't be made smaller."""
    precise = PreciseBalance(balance, given, BITS)
    q = narrowed(precise, box, alone)
    with suppress(Undecided, ZeroDivisionError):
        return None if q is None else _signs_at(precise, q, ask)
    return None


def type_at(precise: PreciseBalance, q: Sequence[Any]) -> Stability:
    """The type of a state of balls; :class:`Undecided` where a sign that it takes is not decided."""
    balance, (elementary, minors) = precise.balance, _signs_at(precise, q, _types)
    low, high = balls.ends(as_balls([[balance.friction(precise.arguments, BALLS)]], precise.bits)[0][0])
    without = (low == 0 == high) | (balance.opens and not balance.contact)
    code, proved = _told(elementary, minors, np.array([bool(balance.model.about.get("symmetric")) and bool(without)]))
    if not proved[0]:
        raise Undecided("a state on the border of its type")
    return Stability(int(code[0]))


def _signs_at(precise: PreciseBalance, q: Sequence[Any], ask: Ask) -> list[Int8Array]:
    """Signs of what is asked of a state of balls."""
    parts = ask(precise.state(q), precise.bits)
    return [np.array([[balls.sign(value)] for value in part], dtype=np.int8).reshape(-1, 1) for part in parts]
