"""Polynomials over rationals and balls: common divisors, Sturm's chains, interpolation.

Coefficients are listed lowest power first. They are Fractions or integers, for which every sign is exact, or balls, for
which a sign that can't be decided raises :class:`.balls.Undecided`, to be tried again with more bits.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from typing import Any, TypeAlias

from . import descartes
from .balls import Undecided, sign

#: A Fraction or a ball.
Coefficient: TypeAlias = Any
Polynomial: TypeAlias = tuple[Coefficient, ...]


def evaluate(polynomial: Sequence[Coefficient], t: Any) -> Any:
    """Horner's rule."""
    value = polynomial[-1]
    for coefficient in reversed(polynomial[:-1]):
        value = value * t + coefficient
    return value


def derivative(polynomial: Polynomial) -> Polynomial:
    """d/dt."""
    return tuple(power * coefficient for power, coefficient in enumerate(polynomial))[1:]


def sturm_chain(polynomial: Polynomial) -> list[Polynomial]:
    """The polynomial, its derivative, and negated remainders down to a constant, or to a common factor.

    Multiple roots, possible over exact coefficients only, count once.
    """
    chain = [_trimmed(polynomial)]
    chain.append(_trimmed(derivative(chain[0])))
    while remainder := _trimmed(_negated_remainder(chain[-2], chain[-1])):
        chain.append(remainder)
    return chain


def common_divisor(one: Polynomial, other: Polynomial) -> tuple[int, ...]:
    """The greatest common divisor with coprime integer coefficients; () if both are zero. Exact coefficients only."""
    dividend, divisor = primitive(one), primitive(other)
    if _coprime(dividend, divisor):
        return (1,)
    while divisor:
        dividend, divisor = divisor, primitive(_negated_remainder(dividend, divisor))
    return dividend


#: A prime; residues of it tell quickly that two polynomials have no common factor.
_PRIME = 2**61 - 1


def _coprime(one: tuple[int, ...], other: tuple[int, ...]) -> bool:
    """Whether residues prove that there is no common factor: it would be one of the residues as well, of the same degree."""
    dividend, divisor = ([value % _PRIME for value in polynomial] for polynomial in (one, other))
    if not (divisor and divisor[-1]):
        return False
    while len(divisor) > 1:
        inverse = pow(divisor[-1], -1, _PRIME)
        while len(dividend) >= len(divisor):
            factor = dividend.pop() * inverse % _PRIME
            for power, value in enumerate(divisor[:-1], start=1 - len(divisor)):  # from the end
                dividend[power] = (dividend[power] - factor * value) % _PRIME
        while dividend and not dividend[-1]:
            dividend.pop()
        dividend, divisor = divisor, dividend
    return bool(divisor)


def squarefree(polynomial: Polynomial) -> tuple[int, ...]:
    """The squarefree part, with the roots each once; exact coefficients only."""
    return without(polynomial, common_divisor(polynomial, derivative(polynomial)))


def without(polynomial: Polynomial, divisor: tuple[int, ...]) -> tuple[int, ...]:
    """A polynomial over one of coprime integers that divides it: coprime integers again (Gauss). Exact coefficients only."""
    rest, quotient = list(primitive(polynomial)), list[int]()
    if not divisor:
        return ()
    for shift in range(len(rest) - len(divisor), -1, -1):
        factor = rest.pop() // divisor[-1]
        quotient.append(factor)
        for power, coefficient in enumerate(divisor[:-1]):
            rest[shift + power] -= factor * coefficient
    return tuple(reversed(quotient))


def primitive(polynomial: Polynomial) -> tuple[int, ...]:
    """A positive multiple with coprime integers and no leading zero, () for zero; exact coefficients only."""
    common = math.lcm(*(value.denominator for value in polynomial))
    integers = [value.numerator * (common // value.denominator) for value in polynomial]
    while integers and not integers[-1]:
        integers.pop()
    divisor = math.gcd(*integers)
    return tuple(value // divisor for value in integers)


def has_root(polynomial: Polynomial, low: Fraction, high: Fraction) -> bool:
    """Whether an exact polynomial other than zero has a root in (low, high], or at low = high."""
    integers = primitive(polynomial)
    at_low, at_high = (descartes.sign_at(integers, end) for end in (low, high))
    if at_high == 0 or at_low * at_high < 0:
        return True
    return len(integers) > 1 and count_between(sturm_chain(integers), low, high) > 0


def _is_exact(polynomial: Polynomial) -> bool:
    return isinstance(polynomial[0], Fraction | int)


def _trimmed(polynomial: Polynomial) -> Polynomial:
    """Exact coefficients in their simplest form, which keeps remainders small; intervals only with a degree that is known."""
    if not polynomial or _is_exact(polynomial):
        return primitive(polynomial)
    if sign(polynomial[-1]) == 0:
        raise Undecided("a leading coefficient holds 0")
    return polynomial


def _negated_remainder(dividend: Polynomial, divisor: Polynomial) -> Polynomial:
    """−(dividend mod divisor), of integers a positive multiple; its degree is below the divisor's whatever the rounding."""
    rest, exact = list(dividend), _is_exact(divisor)
    lead = divisor[-1]
    for shift in range(len(dividend) - len(divisor), -1, -1):
        if exact:
            factor = rest.pop() * sign(lead)
            rest = [value * abs(lead) for value in rest]
        else:
            factor = rest.pop() / lead
        for power, coefficient in enumerate(divisor[:-1]):
            rest[shift + power] = rest[shift + power] - factor * coefficient
    return tuple(-value for value in rest)


def count_between(chain: list[Polynomial], low: Fraction, high: Fraction) -> int:
    """Number of different real roots in (low, high] from an exact chain."""
    return _variations(chain, low) - _variations(chain, high)


def _variations(chain: list[Polynomial], t: Fraction) -> int:
    signs = [value for polynomial in chain if (value := descartes.sign_at(polynomial, t))]
    return sum(left != right for left, right in itertools.pairwise(signs))


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
