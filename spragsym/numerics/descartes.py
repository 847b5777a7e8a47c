"""Real roots of polynomials by Descartes' rule of signs: none is missed.

Coefficients are listed lowest power first: integers, of which nothing is rounded, or balls, where :class:`.balls.Undecided` says
that more bits are needed. Intervals are halved, which only adds and shifts.
"""

import itertools
import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

from . import balls
from .balls import Ball, Undecided


class Root(NamedTuple):
    """The only root of its polynomial in [low, high]: inside, or at both where the two are equal."""

    low: Fraction
    high: Fraction


class _Cell(NamedTuple):
    """One root in the open interval (n, m)/2^k, or at n/2^k = m/2^k; and the sign between it and m/2^k, where that is asked."""

    n: int
    m: int
    k: int
    above: int = 0


def _sign(value: Any) -> int:
    """Sign of an integer or a ball; only an integer may be 0."""
    found = balls.sign(value)
    if not found and isinstance(value, Ball):
        raise Undecided("a polynomial holds 0 where its sign is needed")
    return found


def sign_at(polynomial: Sequence[int], t: Fraction) -> int:
    """Sign of the polynomial at a rational."""
    return _sign(_homogeneous(polynomial, t.numerator, t.denominator))


def real_roots(polynomial: tuple[Any, ...], low: Fraction, high: Fraction, bits: int) -> list[Root]:
    """Every root in (low, high], ascending, to a width below 2^−bits, and below 2^−bits of a distance from 0 that is below 1.

    The polynomial has no multiple root there, or this does not end.
    """
    unit, cells = _isolated(polynomial, low, high)
    common, start, scale = _common(low, high)

    def at(n: int, k: int) -> Fraction:
        return Fraction((start << k) + scale * n, common << k)

    def lacking(n: int, k: int) -> int:
        """How many times (n, n + 1)/2^k has to be halved yet; at most 0 if never."""
        begin, one = (start << k) + scale * n, common << k
        distance = min(abs(begin), abs(begin + scale), one) if begin > 0 or begin + scale < 0 else one
        return (-((-scale << bits) // distance) - 1).bit_length()

    found = [_refined(cell, unit, lacking) for cell in cells]
    return sorted(Root(at(cell.n, cell.k), at(cell.m, cell.k)) for cell in found)


@lru_cache(maxsize=64)
def _isolated(polynomial: tuple[Any, ...], low: Fraction, high: Fraction) -> tuple[list[Any], list[_Cell]]:
    """The polynomial in u, where t = low + (high − low) u, and a cell in u for each root in (low, high].

    Source: Descartes' rule in (0, 1) and halves of it: no change of sign, no root; one change, one root (Collins, Akritas 1976).
    """
    unit = _between_0_and_1(polynomial, low, high)
    found = [] if _sign(sum(unit)) else [_Cell(1, 1, 0)]
    pending = [(unit, 0, 0)]
    while pending:
        local, n, k = pending.pop()
        changes = _sign_changes(shifted(local[::-1]))
        if changes == 1:
            found.append(_Cell(n, n + 1, k, -(_sign(local[0]) or _sign(local[1]))))
        elif changes:
            degree = len(local) - 1
            left = [value * (1 << degree - power) for power, value in enumerate(local)]
            right = shifted(left)
            if not _sign(right[0]):
                found.append(_Cell(2 * n + 1, 2 * n + 1, k + 1))
            pending += [(left, 2 * n, k + 1), (right, 2 * n + 1, k + 1)]
    return unit, found


def _common(low: Fraction, high: Fraction) -> tuple[int, int, int]:
    """The least common denominator, and times that the lower end and the width."""
    common = math.lcm(low.denominator, high.denominator)
    return common, int(low * common), int((high - low) * common)


def _between_0_and_1(polynomial: tuple[Any, ...], low: Fraction, high: Fraction) -> list[Any]:
    """Coefficients of a positive multiple of the polynomial in u."""
    common, start, scale = _common(low, high)
    values: list[Any] = []
    for power, coefficient in enumerate(reversed(polynomial)):  # Horner's rule with polynomials in u, times common^power
        values = [start * one + scale * other for one, other in zip([*values, 0], [0, *values], strict=True)]
        values[0] += coefficient * common**power
    return values


def shifted(coefficients: Sequence[Any], by: Any = 1) -> list[Any]:
    """Coefficients of the polynomial at u + ``by``."""
    values = list(coefficients)
    for start in range(len(values)):
        for power in range(len(values) - 2, start - 1, -1):
            values[power] += by * values[power + 1]
    return values


def _sign_changes(coefficients: Sequence[Any]) -> int:
    signs = [sign for value in coefficients if (sign := _sign(value))]
    return sum(left != right for left, right in itertools.pairwise(signs))


def _homogeneous(coefficients: Sequence[Any], numerator: int, denominator: int) -> Any:
    """denominator^degree times the polynomial at numerator/denominator."""
    value, power = coefficients[-1], 1
    for coefficient in reversed(coefficients[:-1]):
        power *= denominator
        value = value * numerator + coefficient * power
    return value


def _refined(cell: _Cell, polynomial: Sequence[Any], lacking: Callable[[int, int], int]) -> _Cell:
    """The root in a cell that lacks nothing and whose ends are no roots, or the root itself.

    The secant's guess is tried on a grid of 2^j parts of the cell, j twice as large where it is right, else half.
    Source: quadratic interval refinement, J. Abbott (2006).
    """
    n, m, k, above = cell
    if n == m:
        return cell

    def value(n: int, k: int) -> Any:
        return _homogeneous(polynomial, n, 1 << k)

    low, high = value(n, k), value(n + 1, k)
    j = 1
    while True:
        open_ends = _sign(low) != 0 and _sign(high) != 0  # else another root sits on an end
        wanted = lacking(n, k)
        if wanted <= 0 and open_ends:
            return _Cell(n, n + 1, k, above)
        j = min(j, wanted) if open_ends else 1
        guess = (n << j) + (1 if j == 1 else _share(low, high, j))
        middle = value(guess, k + j)
        side = _sign(middle)
        if side == 0:
            return _Cell(guess, guess, k + j)
        left = side == above
        other = value(guess - 1 if left else guess + 1, k + j)
        if j == 1 or _sign(other) == -side:
            n, k, j = guess - 1 if left else guess, k + j, 2 * j
            low, high = (other, middle) if left else (middle, other)
        else:
            j //= 2


def _share(low: Any, high: Any, j: int) -> int:
    """Part of 2^j, from below, in which the chord of values of opposite signs, or of their middles, crosses zero."""
    if isinstance(low, Ball):
        low, high = (sum(balls.ends(value)) for value in (low, high))
    return int((low * (1 << j)) // (low - high))
