"""Real roots of polynomials, proved: Descartes' rule over exact coefficients, Sturm's theorem over intervals.

Coefficients are listed lowest power first. They are Fractions, for which every sign is exact, or intervals, for which a sign that
can't be decided raises :class:`Undecided`, to be tried again with more bits.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache, lru_cache
from typing import Any, TypeAlias

#: A Fraction or an interval.
Coefficient: TypeAlias = Any
Polynomial: TypeAlias = tuple[Coefficient, ...]
Sign: TypeAlias = Callable[[Coefficient], int]


class Undecided(ArithmeticError):
    """A sign that the coefficients' precision can't decide."""


def exact_sign(value: Fraction | int) -> int:
    """Sign of a rational."""
    return (value > 0) - (value < 0)


def evaluate(polynomial: Sequence[Coefficient], t: Any) -> Any:
    """Horner's rule."""
    value = polynomial[-1]
    for coefficient in reversed(polynomial[:-1]):
        value = value * t + coefficient
    return value


def derivative(polynomial: Polynomial) -> Polynomial:
    """d/dt."""
    return tuple(power * coefficient for power, coefficient in enumerate(polynomial))[1:]


def sturm_chain(polynomial: Polynomial, sign: Sign) -> list[Polynomial]:
    """The polynomial, its derivative, and negated remainders down to a constant, or to a common factor.

    Multiple roots, possible over exact coefficients only, count once.
    """
    chain = [_trimmed(polynomial, sign)]
    chain.append(_trimmed(derivative(chain[0]), sign))
    while remainder := _trimmed(_negated_remainder(chain[-2], chain[-1]), sign):
        chain.append(remainder)
    return chain


def common_divisor(one: Polynomial, other: Polynomial) -> Polynomial:
    """The greatest common divisor with coprime integer coefficients; () if both are zero. Exact coefficients only."""
    dividend, divisor = primitive(one), primitive(other)
    if len(dividend) < len(divisor):
        dividend, divisor = divisor, dividend
    if _coprime(dividend, divisor):
        return (Fraction(1),)
    while divisor:
        dividend, divisor = divisor, primitive(_negated_remainder(dividend, divisor))
    return dividend


#: A prime; residues of it tell quickly that two polynomials have no common factor.
_PRIME = 2**61 - 1


def _coprime(one: Polynomial, other: Polynomial) -> bool:
    """Whether residues prove that there is no common factor: it would be one of the residues as well."""
    dividend, divisor = ([value.numerator % _PRIME for value in polynomial] for polynomial in (one, other))
    if not (divisor and dividend[-1] and divisor[-1]):
        return False
    while len(divisor) > 1:
        inverse = pow(divisor[-1], -1, _PRIME)
        while len(dividend) >= len(divisor):
            factor, shift = dividend.pop() * inverse % _PRIME, len(dividend) + 1 - len(divisor)
            for power, value in enumerate(divisor[:-1]):
                dividend[shift + power] = (dividend[shift + power] - factor * value) % _PRIME
        while dividend and not dividend[-1]:
            dividend.pop()
        dividend, divisor = divisor, dividend
    return bool(divisor)


def squarefree(polynomial: Polynomial) -> Polynomial:
    """The same roots, each once; exact coefficients only."""
    return without(polynomial, common_divisor(polynomial, derivative(polynomial)))


def without(polynomial: Polynomial, divisor: Polynomial) -> Polynomial:
    """A polynomial over one that divides it; exact coefficients only."""
    dividend = primitive(polynomial)
    return dividend if len(divisor) <= 1 else primitive(_quotient(dividend, divisor))


def primitive(polynomial: Polynomial) -> Polynomial:
    """A positive multiple with coprime integers and no leading zero, () for zero; exact coefficients only."""
    return _trimmed(polynomial, exact_sign)


def has_root(polynomial: Polynomial, low: Fraction, high: Fraction) -> bool:
    """Whether an exact polynomial other than zero has a root in (low, high], or at low = high."""
    if len(polynomial) <= 1:
        return False
    if low == high:
        return _sign_at(primitive(polynomial), low, exact_sign) == 0
    return count_between(sturm_chain(polynomial, exact_sign), low, high, exact_sign) > 0


def _trimmed(polynomial: Polynomial, sign: Sign) -> Polynomial:
    """Without leading zeros, which only exact coefficients can be known to have, and over those without a common factor."""
    coefficients = list(polynomial)
    while coefficients and sign(coefficients[-1]) == 0:
        if not isinstance(coefficients[-1], Fraction | int):
            raise Undecided("a leading coefficient holds 0")
        coefficients.pop()
    exact = bool(coefficients) and isinstance(coefficients[0], Fraction | int)
    return _primitive(tuple(coefficients)) if exact else tuple(coefficients)


def _primitive(polynomial: tuple[Fraction, ...]) -> Polynomial:
    """A positive multiple with coprime integers, which keeps the remainders small."""
    common = math.lcm(*(value.denominator for value in polynomial))
    integers = [value.numerator * (common // value.denominator) for value in polynomial]
    divisor = math.gcd(*integers)
    return tuple(Fraction(value // divisor) for value in integers)


def _negated_remainder(dividend: Polynomial, divisor: Polynomial) -> Polynomial:
    """−(dividend mod divisor), whose degree is below the divisor's whatever the rounding."""
    rest = list(dividend)
    for shift in range(len(dividend) - len(divisor), -1, -1):
        factor = rest.pop() / divisor[-1]
        for power, coefficient in enumerate(divisor[:-1]):
            rest[shift + power] = rest[shift + power] - factor * coefficient
    return tuple(-value for value in rest)


def _quotient(dividend: Polynomial, divisor: Polynomial) -> Polynomial:
    rest, quotient = list(dividend), []
    for shift in range(len(dividend) - len(divisor), -1, -1):
        factor = rest.pop() / divisor[-1]
        quotient.append(factor)
        for power, coefficient in enumerate(divisor[:-1]):
            rest[shift + power] -= factor * coefficient
    return tuple(reversed(quotient))


def _sign_at(polynomial: Polynomial, t: Any, sign: Sign) -> int:
    """Sign of a polynomial, in integers where all is exact."""
    if isinstance(t, Fraction) and isinstance(polynomial[0], Fraction):
        return exact_sign(_homogeneous([value.numerator for value in polynomial], t.numerator, t.denominator))
    return sign(evaluate(polynomial, t))


def _homogeneous(coefficients: Sequence[int], numerator: int, denominator: int) -> int:
    """denominator^degree times the polynomial at numerator/denominator."""
    value, power = coefficients[-1], 1
    for coefficient in reversed(coefficients[:-1]):
        power *= denominator
        value = value * numerator + coefficient * power
    return value


def count_between(chain: list[Polynomial], low: Coefficient, high: Coefficient, sign: Sign) -> int:
    """Number of different real roots in (low, high]."""
    return _variations(chain, low, sign) - _variations(chain, high, sign)


def _variations(chain: list[Polynomial], t: Coefficient, sign: Sign) -> int:
    signs = []
    for polynomial in chain:
        value = _sign_at(polynomial, t, sign)
        if value == 0 and not isinstance(t, Fraction):
            raise Undecided("a Sturm function holds 0 at an end")
        if value:
            signs.append(value)
    return sum(left != right for left, right in itertools.pairwise(signs))


def real_roots(
    polynomial: Polynomial, low: Fraction, high: Fraction, sign: Sign, number: Callable[[Fraction], Coefficient], bits: int
) -> list[tuple[Fraction, Fraction]]:
    """Every different real root in (low, high], ascending, each in an interval (left, right] of width below 2^−bits.

    Exact coefficients: isolated by Descartes' rule of signs, to that width relative to the root. Intervals: by Sturm's theorem.

    Parameters
    ----------
    polynomial : tuple
        Without multiple roots (see :func:`squarefree`), Fractions or intervals.
    sign : callable
        −1, 0 or 1; 0 for an interval that holds 0.
    number : callable
        Makes a coefficient of a rational.
    """
    if isinstance(polynomial[0], Fraction):
        return _exact_roots(primitive(polynomial), low, high, bits)
    chain = sturm_chain(polynomial, sign)
    found: list[tuple[Fraction, Fraction]] = []
    pending = [(low, high, count_between(chain, number(low), number(high), sign))]
    while pending:
        left, right, count = pending.pop()
        if count == 1:
            found.append(_bisect(chain[0], left, right, sign, number, bits))
        elif count > 1:
            middle = _split(left, right)
            below = count_between(chain, number(left), number(middle), sign)
            pending += [(left, middle, below), (middle, right, count - below)]
    return sorted(found)


def _split(left: Fraction, right: Fraction) -> Fraction:
    """A dyadic point inside, off the middle, where a root at a round number would be."""
    return left + (right - left) * Fraction(1021, 2048)


def _narrow(width: Fraction, low: Fraction, high: Fraction, bits: int) -> bool:
    """Whether an interval is below 2^−bits, over its distance from 0 where it does not hold 0."""
    distance = min(abs(low), abs(high)) if low > 0 or high < 0 else Fraction(1)
    return bool(width * 2**bits <= min(distance, Fraction(1)))


def _bisect(
    polynomial: Polynomial, left: Fraction, right: Fraction, sign: Sign, number: Callable[[Fraction], Coefficient], bits: int
) -> tuple[Fraction, Fraction]:
    """Narrow an interval (left, right] that holds one simple root."""
    above = sign(evaluate(polynomial, number(right)))
    if above == 0:
        raise Undecided("the polynomial holds 0 at an end")
    while right - left > Fraction(1, 2**bits):
        middle = (left + right) / 2
        value = sign(evaluate(polynomial, number(middle)))
        if value == 0:
            raise Undecided("the polynomial holds 0 near a root")
        left, right = (left, middle) if value == above else (middle, right)
    return left, right


def _exact_roots(polynomial: Polynomial, low: Fraction, high: Fraction, bits: int) -> list[tuple[Fraction, Fraction]]:
    """:func:`real_roots` over integers."""
    scale = high - low
    unit = _between_0_and_1([value.numerator for value in polynomial], low, scale)
    cells = [*_isolated(tuple(unit)), *([(1, 1, 0)] if sum(unit) == 0 else [])]
    return sorted(_refine(unit, cell, low, scale, bits) for cell in cells)


@lru_cache(maxsize=64)
def _isolated(unit: tuple[int, ...]) -> tuple[tuple[int, int, int], ...]:
    """(n, m, k) for each simple root in (0, 1): it lies in (n, m)/2^k, or is n/2^k = m/2^k.

    Source: Descartes' rule in (0, 1) and halves of it: no change of sign, no root; one change, one root (Collins, Akritas 1976).
    """
    found = []
    pending = [(list(unit), 0, 0)]
    while pending:
        polynomial, n, k = pending.pop()
        changes = _sign_changes(_shifted_by_1(polynomial[::-1]))
        if changes == 1:
            found.append((n, n + 1, k))
        elif changes > 1:
            degree = len(polynomial) - 1
            left = [value << (degree - power) for power, value in enumerate(polynomial)]
            right = _shifted_by_1(left)
            if right[0] == 0:
                found.append((2 * n + 1, 2 * n + 1, k + 1))
            pending += [(left, 2 * n, k + 1), (right, 2 * n + 1, k + 1)]
    return tuple(found)


def _shifted_by_1(coefficients: Sequence[int]) -> list[int]:
    """Coefficients of the polynomial at u + 1."""
    values = list(coefficients)
    for start in range(len(values) - 1):
        for power in range(len(values) - 2, start - 1, -1):
            values[power] += values[power + 1]
    return values


def _sign_changes(coefficients: Sequence[int]) -> int:
    signs = [value > 0 for value in coefficients if value]
    return sum(left != right for left, right in itertools.pairwise(signs))


def _refine(
    unit: list[int], cell: tuple[int, int, int], start: Fraction, scale: Fraction, bits: int
) -> tuple[Fraction, Fraction]:
    """Narrow a cell with one root: the secant's guess on a grid of 2^m cells, m twice as large when right, else half.

    Source: quadratic interval refinement, J. Abbott (2006).
    """
    n, last, k = cell

    def at(numerator: int) -> Fraction:
        return start + scale * Fraction(numerator, 1 << k)

    if n == last:
        return at(n), at(n)
    # At the ends there may be other roots, which belong to their own cells: the sign just inside the right one decides.
    above = exact_sign(_homogeneous(unit, last, 1 << k)) or -exact_sign(_homogeneous(_derivative(unit), last, 1 << k))
    m = 1
    while True:
        low, high = (_homogeneous(unit, end, 1 << k) for end in (n, n + 1))
        if high and _narrow(scale / 2**k, at(n), at(n + 1), bits):
            return at(n), at(n + 1)
        m = m if low and high else 1
        guess = (n << m) + (1 if m == 1 else min(max((low << m) // (low - high), 1), (1 << m) - 1))
        value = _homogeneous(unit, guess, 1 << k + m) * above
        if value == 0:
            k += m
            return at(guess), at(guess)
        step = -1 if value > 0 else 1
        if m == 1 or value * _homogeneous(unit, guess + step, 1 << k + m) * above < 0:
            n, k, m = guess + min(step, 0), k + m, 2 * m
        else:
            m //= 2


def _derivative(coefficients: Sequence[int]) -> list[int]:
    return [power * value for power, value in enumerate(coefficients)][1:]


def _between_0_and_1(coefficients: Sequence[int], left: Fraction, scale: Fraction) -> list[int]:
    """Integer coefficients of a positive multiple of the polynomial in u, where t = left + scale u."""
    shifted: list[Fraction] = []
    for coefficient in reversed(coefficients):  # Horner's rule with polynomials in u
        times = [value * left for value in shifted] + [Fraction(0)]
        for power, value in enumerate(shifted):
            times[power + 1] += value * scale
        times[0] += coefficient
        shifted = times
    common = math.lcm(*(value.denominator for value in shifted))
    return [int(value * common) for value in shifted]


@cache
def _interpolation(nodes: tuple[int, ...]) -> tuple[tuple[Fraction, ...], ...]:
    """Coefficients of the Lagrange polynomials of the nodes, exactly."""
    rows = []
    for i, node in enumerate(nodes):
        basis = [Fraction(1)]
        for j, other in enumerate(nodes):
            if i != j:
                shifted = [Fraction(0), *basis]
                basis = [a - other * b for a, b in zip(shifted, [*basis, Fraction(0)], strict=True)]
                basis = [value / (node - other) for value in basis]
        rows.append(tuple(basis))
    return tuple(rows)


def interpolate(
    function: Callable[[Fraction], Coefficient], degree: int, number: Callable[[Fraction], Coefficient]
) -> Polynomial:
    """The polynomial of that degree through the values of ``function`` at integers about 0."""
    nodes = tuple(range(-(degree // 2), degree - degree // 2 + 1))
    basis = _interpolation(nodes)
    values = [function(Fraction(node)) for node in nodes]
    return tuple(
        sum(
            (value * number(row[power]) for value, row in zip(values[1:], basis[1:], strict=True)),
            values[0] * number(basis[0][power]),
        )
        for power in range(degree + 1)
    )
