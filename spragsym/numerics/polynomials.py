"""Real roots of polynomials, proved: Descartes' rule over exact coefficients, Sturm's theorem over intervals.

Coefficients are listed lowest power first. They are Fractions or integers, for which every sign is exact, or intervals, for
which a sign that can't be decided raises :class:`Undecided`, to be tried again with more bits.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from typing import Any, TypeAlias

from . import descartes
from .refinement import Cell, refine

#: A Fraction or an interval.
Coefficient: TypeAlias = Any
Polynomial: TypeAlias = tuple[Coefficient, ...]
Sign: TypeAlias = Callable[[Coefficient], int]

exact_sign = descartes.sign


class Undecided(ArithmeticError):
    """A sign that the coefficients' precision can't decide."""


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
    """The same roots, each once; exact coefficients only."""
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
    return len(integers) > 1 and count_between(sturm_chain(integers, exact_sign), low, high, exact_sign) > 0


def _is_exact(polynomial: Polynomial) -> bool:
    return isinstance(polynomial[0], Fraction | int)


def _trimmed(polynomial: Polynomial, sign: Sign) -> Polynomial:
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
            factor = rest.pop() * exact_sign(lead)
            rest = [value * abs(lead) for value in rest]
        else:
            factor = rest.pop() / lead
        for power, coefficient in enumerate(divisor[:-1]):
            rest[shift + power] = rest[shift + power] - factor * coefficient
    return tuple(-value for value in rest)


def _sign_at(polynomial: Polynomial, t: Any, sign: Sign) -> int:
    """Sign of a polynomial, in integers where all is exact."""
    if _is_exact(polynomial):
        return descartes.sign_at(polynomial, t)
    return sign(evaluate(polynomial, t))


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
        Without multiple roots (see :func:`squarefree`), Fractions, integers or intervals.
    sign : callable
        −1, 0 or 1; 0 for an interval that holds 0.
    number : callable
        Makes a coefficient of a rational.
    """
    if _is_exact(polynomial):
        return list(descartes.real_roots(primitive(polynomial), low, high, bits))
    chain = sturm_chain(polynomial, sign)
    found: list[tuple[Fraction, Fraction]] = []
    pending = [(low, high, count_between(chain, number(low), number(high), sign))]
    while pending:
        left, right, count = pending.pop()
        if count == 1:
            found.append(_refined(polynomial, left, right, sign, number, bits))
        elif count > 1:
            middle = _split(left, right)
            below = count_between(chain, number(left), number(middle), sign)
            pending += [(left, middle, below), (middle, right, count - below)]
    return sorted(found)


def _split(left: Fraction, right: Fraction) -> Fraction:
    """A dyadic point inside, off the middle, where a root at a round number would be."""
    return left + (right - left) * Fraction(1021, 2048)


def _refined(
    polynomial: Polynomial, left: Fraction, right: Fraction, sign: Sign, number: Callable[[Fraction], Coefficient], bits: int
) -> tuple[Fraction, Fraction]:
    """Narrow an interval (left, right] that holds one simple root of a polynomial with interval coefficients."""
    scale = right - left

    def at(n: int, k: int) -> Fraction:
        return left + scale * Fraction(n, 1 << k)

    def value(n: int, k: int) -> Coefficient:
        return evaluate(polynomial, number(at(n, k)))

    def decided(value: Coefficient) -> int:
        if not (result := sign(value)):
            raise Undecided("the polynomial holds 0 near a root")
        return result

    def share(low: Coefficient, high: Coefficient, j: int) -> int:
        """The integer below 2^j low/(low − high), bit by bit: of an interval only signs are known here."""
        whole, part = low / (low - high) * (1 << j), 0
        for bit in reversed(range(j)):
            part += (1 << bit) if sign(whole - (part + (1 << bit))) > 0 else 0
        return part

    def lacking(_: int, k: int) -> int:
        return (math.ceil(scale * Fraction(2) ** (bits - k)) - 1).bit_length()

    cell = refine(Cell(0, 1, 0, decided(value(1, 0))), value, decided, share, lacking)
    return at(cell.n, cell.k), at(cell.m, cell.k)


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
