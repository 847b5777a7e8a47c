"""Real roots of polynomials, proved: Sturm's count over exact or interval coefficients, and an enclosure of every root.

Coefficients are listed lowest power first. They are Fractions, for which every sign is exact, or intervals, for which a sign that
can't be decided raises :class:`Undecided`, to be tried again with more bits.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from typing import Any, TypeAlias

#: A Fraction or an interval.
Coefficient: TypeAlias = Any
Polynomial: TypeAlias = tuple[Coefficient, ...]
Sign: TypeAlias = Callable[[Coefficient], int]


class Undecided(ArithmeticError):
    """A sign that the coefficients' precision can't decide."""


def exact_sign(value: Fraction) -> int:
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


def squarefree(polynomial: Polynomial) -> Polynomial:
    """The same roots, each once; exact coefficients only."""
    chain = sturm_chain(polynomial, exact_sign)
    return _quotient(chain[0], chain[-1])


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
    common = math.lcm(*(Fraction(value).denominator for value in polynomial))
    integers = [int(value * common) for value in polynomial]
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


def count_between(chain: list[Polynomial], low: Coefficient, high: Coefficient, sign: Sign) -> int:
    """Number of different real roots in (low, high]."""
    return _variations(chain, low, sign) - _variations(chain, high, sign)


def _variations(chain: list[Polynomial], t: Coefficient, sign: Sign) -> int:
    signs = []
    for polynomial in chain:
        value = sign(evaluate(polynomial, t))
        if value == 0 and not isinstance(t, Fraction):
            raise Undecided("a Sturm function holds 0 at an end")
        if value:
            signs.append(value)
    return sum(left != right for left, right in itertools.pairwise(signs))


def real_roots(
    polynomial: Polynomial, low: Fraction, high: Fraction, sign: Sign, number: Callable[[Fraction], Coefficient], bits: int
) -> list[tuple[Fraction, Fraction]]:
    """Every different real root in (low, high], ascending, each in an interval of width at most 2^−bits.

    Parameters
    ----------
    polynomial : tuple
        Without multiple roots (see :func:`squarefree`), Fractions or intervals.
    sign : callable
        −1, 0 or 1; 0 for an interval that holds 0.
    number : callable
        Makes a coefficient of a rational.
    """
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


def _bisect(
    polynomial: Polynomial, left: Fraction, right: Fraction, sign: Sign, number: Callable[[Fraction], Coefficient], bits: int
) -> tuple[Fraction, Fraction]:
    """Narrow an interval (left, right] that holds one simple root."""
    above = sign(evaluate(polynomial, number(right)))
    if above == 0:
        if isinstance(number(right), Fraction):
            return right, right
        raise Undecided("the polynomial holds 0 at an end")
    while right - left > Fraction(1, 2**bits):
        middle = (left + right) / 2
        value = sign(evaluate(polynomial, number(middle)))
        if value == 0:
            if isinstance(number(middle), Fraction):
                return middle, middle
            raise Undecided("the polynomial holds 0 near a root")
        left, right = (left, middle) if value == above else (middle, right)
    return left, right


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
