"""Exact polynomials, coefficients lowest power first: common divisors, squarefree parts, interpolation, real roots."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any, TypeAlias

from . import balls
from .balls import Interval
from .descartes import real_roots, sign_at
from .determinants import solved

#: A Fraction or a ball.
Coefficient: TypeAlias = Any
Polynomial: TypeAlias = tuple[Coefficient, ...]


def evaluate(polynomial: Sequence[Coefficient], t: Any) -> Any:
    """Horner's rule."""
    value = polynomial[-1]
    for coefficient in reversed(polynomial[:-1]):
        value = value * t + coefficient
    return value


def derivative(polynomial: Sequence[Coefficient]) -> Polynomial:
    """d/dt."""
    return tuple(power * coefficient for power, coefficient in enumerate(polynomial))[1:]


def common_divisor(one: Polynomial, other: Polynomial) -> tuple[int, ...]:
    """The greatest common divisor with coprime integer coefficients; () if both are zero."""
    dividend, divisor = primitive(one), primitive(other)
    if _coprime(dividend, divisor):
        return (1,)
    while divisor:
        dividend, divisor = divisor, primitive(_remainder(dividend, divisor))
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
    """The squarefree part, with the roots each once."""
    return without(polynomial, common_divisor(polynomial, derivative(polynomial)))


def without(polynomial: Polynomial, divisor: tuple[int, ...]) -> tuple[int, ...]:
    """A polynomial over one of coprime integers that divides it: coprime integers again (Gauss)."""
    rest, quotient = list(primitive(polynomial)), list[int]()
    if not divisor:
        return ()
    for shift in range(len(rest) - len(divisor), -1, -1):
        factor = rest.pop() // divisor[-1]
        quotient.append(factor)
        for power, coefficient in enumerate(divisor[:-1]):
            rest[shift + power] -= factor * coefficient
    return tuple(reversed(quotient))


def primitive(polynomial: Sequence[Coefficient]) -> tuple[int, ...]:
    """A positive multiple with coprime integers and no leading zero, () for zero."""
    common = math.lcm(*(value.denominator for value in polynomial))
    integers = [value.numerator * (common // value.denominator) for value in polynomial]
    while integers and not integers[-1]:
        integers.pop()
    divisor = math.gcd(*integers)
    return tuple(value // divisor for value in integers)


def has_root(polynomial: Polynomial, low: Fraction, high: Fraction) -> bool:
    """Whether a polynomial other than zero has a root in (low, high], or at low = high."""
    simple = squarefree(polynomial)
    return sign_at(simple, high) == 0 or (low < high and bool(real_roots(simple, low, high, 0)))


def _remainder(dividend: tuple[int, ...], divisor: tuple[int, ...]) -> list[int]:
    """A multiple of dividend mod divisor."""
    rest = list(dividend)
    for shift in range(len(dividend) - len(divisor), -1, -1):
        factor = rest.pop()
        rest = [value * divisor[-1] for value in rest]
        for power, coefficient in enumerate(divisor[:-1]):
            rest[shift + power] -= factor * coefficient
    return rest


@cache
def _interpolation(nodes: tuple[int, ...]) -> tuple[tuple[Fraction, ...], ...]:
    """Coefficients of the Lagrange polynomials of the nodes, exactly."""
    powers = [[Fraction(node) ** power for power in range(len(nodes))] for node in nodes]
    return tuple(tuple(solved(powers, [Fraction(node == other) for other in nodes])) for node in nodes)


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


@dataclass(frozen=True)
class Root:
    """A real root of a polynomial in (low, high], or of the reversed polynomial: then it is the reciprocal."""

    low: Fraction
    high: Fraction
    backward: bool

    def interval(self) -> Interval:
        """An interval that holds the root."""
        value = balls.between(self.low, self.high)
        return 1 / value if self.backward else value

    def is_of(self, polynomial: Polynomial) -> bool:
        """Whether it is one of a divisor of its polynomial."""
        return has_root(tuple(reversed(polynomial)) if self.backward else polynomial, self.low, self.high)


#: Ends of the two charts: no round numbers, where roots of symmetric parameters are.
_BELOW, _BETWEEN = Fraction(-1, 7), Fraction(13, 11)


def roots_on_the_line(polynomial: tuple[Any, ...], bits: int, *, positive: bool = False) -> list[Root]:
    """All real roots of a polynomial without multiple ones, or the positive ones only; arguments as of :func:`.real_roots`.

    Exact coefficients go with ``positive`` only: an end of a chart may be a root of theirs, where balls are undecided.
    """
    while positive and polynomial and isinstance(polynomial[0], int) and polynomial[0] == 0:
        polynomial = polynomial[1:]  # the root 0
    found: list[Root] = []
    if not polynomial:
        return found
    for chart, limit, backward in ((polynomial, _BETWEEN, False), (tuple(reversed(polynomial)), 1 / _BETWEEN, True)):
        for low, high in real_roots(chart, _BELOW if positive else -limit, limit, bits):
            at_the_end = backward and low == limit  # which the first chart has
            if not at_the_end and (high > 0 or not positive):
                found.append(Root(low, high, backward))
    return found
