"""Real roots of polynomials with integer coefficients by Descartes' rule of signs: exact, and none is missed.

Coefficients are listed lowest power first. Nothing here is rounded. Intervals are halved, which only adds and shifts; a chain of
Sturm's, whose coefficients grow with the square of the degree, is slower by far at degree 16.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

from .refinement import Cell, refine


class Root(NamedTuple):
    """The only root of its polynomial in [low, high]: inside, or at both where the two are equal."""

    low: Fraction
    high: Fraction


def sign(value: Fraction | int) -> int:
    """Sign of a rational."""
    return (value > 0) - (value < 0)


def sign_at(polynomial: Sequence[int], t: Fraction) -> int:
    """Sign of the polynomial at a rational."""
    return sign(_homogeneous(polynomial, t.numerator, t.denominator))


def real_roots(polynomial: tuple[int, ...], low: Fraction, high: Fraction, bits: int) -> list[Root]:
    """Every root in (low, high], ascending, to a width below 2^−bits, and below 2^−bits of a distance from 0 that is below 1.

    The polynomial has no multiple root there, or this does not end.
    """
    unit, cells = _isolated(polynomial, low, high)
    scale = high - low

    def at(n: int, k: int) -> Fraction:
        return low + scale * Fraction(n, 1 << k)

    def lacking(n: int, k: int) -> int:
        ends = at(n, k), at(n + 1, k)
        distance = min(map(abs, ends)) if ends[0] > 0 or ends[1] < 0 else Fraction(1)
        return (math.ceil(scale * Fraction(2) ** (bits - k) / min(distance, Fraction(1))) - 1).bit_length()

    def value(n: int, k: int) -> int:
        return _homogeneous(unit, n, 1 << k)

    found = [refine(cell, value, sign, _share, lacking) for cell in cells]
    return sorted(Root(at(cell.n, cell.k), at(cell.m, cell.k)) for cell in found)


@lru_cache(maxsize=64)
def _isolated(polynomial: tuple[int, ...], low: Fraction, high: Fraction) -> tuple[list[int], list[Cell]]:
    """The polynomial in u, where t = low + (high − low) u, and a cell in u for each root in (low, high].

    Source: Descartes' rule in (0, 1) and halves of it: no change of sign, no root; one change, one root (Collins, Akritas 1976).
    """
    unit = _between_0_and_1(polynomial, low, high)
    found = [Cell(1, 1, 0)] if sum(unit) == 0 else []
    pending = [(unit, 0, 0)]
    while pending:
        local, n, k = pending.pop()
        changes = _sign_changes(_shifted_by_1(local[::-1]))
        if changes == 1:
            found.append(Cell(n, n + 1, k, -sign(local[0] or local[1])))
        elif changes:
            degree = len(local) - 1
            left = [value << (degree - power) for power, value in enumerate(local)]
            right = _shifted_by_1(left)
            if right[0] == 0:
                found.append(Cell(2 * n + 1, 2 * n + 1, k + 1))
            pending += [(left, 2 * n, k + 1), (right, 2 * n + 1, k + 1)]
    return unit, found


def _between_0_and_1(polynomial: tuple[int, ...], low: Fraction, high: Fraction) -> list[int]:
    """Coefficients of a positive multiple of the polynomial in u."""
    common = math.lcm(low.denominator, high.denominator)
    start, scale = int(low * common), int((high - low) * common)
    values: list[int] = []
    for power, coefficient in enumerate(reversed(polynomial)):  # Horner's rule with polynomials in u, times common^power
        values = [start * one + scale * other for one, other in zip([*values, 0], [0, *values], strict=True)]
        values[0] += coefficient * common**power
    return values


def _shifted_by_1(coefficients: Sequence[int]) -> list[int]:
    """Coefficients of the polynomial at u + 1."""
    values = list(coefficients)
    for start in range(len(values)):
        for power in range(len(values) - 2, start - 1, -1):
            values[power] += values[power + 1]
    return values


def _sign_changes(coefficients: Sequence[int]) -> int:
    signs = [value > 0 for value in coefficients if value]
    return sum(left != right for left, right in itertools.pairwise(signs))


def _homogeneous(coefficients: Sequence[int], numerator: int, denominator: int) -> int:
    """denominator^degree times the polynomial at numerator/denominator."""
    value, power = coefficients[-1], 1
    for coefficient in reversed(coefficients[:-1]):
        power *= denominator
        value = value * numerator + coefficient * power
    return value


def _share(low: int, high: int, j: int) -> int:
    """Part of 2^j, from below, in which the chord of values of opposite signs crosses zero."""
    return (low << j) // (low - high)
