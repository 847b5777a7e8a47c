"""Real roots in 0 < v < 1 of a polynomial with integer coefficients, by Descartes' rule of signs: exact, and none is missed.

Coefficients are listed lowest power first. Nothing here is rounded. Sturm's chain, in ``polynomials``, counts for intervals too,
but its coefficients grow with the square of the degree. Here intervals are halved, which only adds and shifts: at degree 16 that
is faster by far.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeAlias

Polynomial: TypeAlias = tuple[int, ...]

#: Primes modulo which common factors are looked for first: where there is none modulo a prime, there is none.
_PRIMES = (2**61 - 1, 2**89 - 1, 2**107 - 1)


@dataclass(frozen=True)
class Root:
    """The only root of its polynomial in [low, high]: inside, or at both where the two are equal."""

    low: Fraction
    high: Fraction

    @property
    def exact(self) -> bool:
        """Whether the root is known exactly."""
        return self.low == self.high


def primitive(coefficients: Iterable[Fraction | int]) -> Polynomial:
    """A positive multiple with coprime integers and without leading zeros; empty for the zero polynomial."""
    values = [Fraction(value) for value in coefficients]
    common = math.lcm(*(value.denominator for value in values))
    integers = [int(value * common) for value in values]
    while integers and integers[-1] == 0:
        integers.pop()
    divisor = math.gcd(*integers)
    return tuple(value // divisor for value in integers)


def derivative(polynomial: Polynomial) -> Polynomial:
    """d/dv."""
    return tuple(power * coefficient for power, coefficient in enumerate(polynomial))[1:]


def sign_at(polynomial: Sequence[int], v: Fraction) -> int:
    """Sign of the value at a rational."""
    value, power = 0, 1
    for coefficient in reversed(polynomial):
        value = value * v.numerator + coefficient * power
        power *= v.denominator
    return (value > 0) - (value < 0)


# --------------------------------------------------------------------------------------------- common factors


def common_factor(one: Polynomial, other: Polynomial) -> Polynomial:
    """The greatest common divisor, primitive; ``(1,)`` where there is none."""
    if not other:
        return primitive(one)
    if any(one[-1] % prime and _coprime_modulo(one, other, prime) for prime in _PRIMES):
        return (1,)
    while other:
        one, other = other, primitive(_remainder(one, other))
    return one


def _coprime_modulo(one: Sequence[int], other: Sequence[int], prime: int) -> bool:
    """Whether two polynomials have no common factor modulo a prime, by Euclid's algorithm."""
    high, low = ([value % prime for value in polynomial] for polynomial in (one, other))
    while any(low):
        while low[-1] == 0:
            low.pop()
        inverse = pow(low[-1], -1, prime)
        while len(high) >= len(low):
            factor, shift = high[-1] * inverse % prime, len(high) - len(low)
            high[shift:] = [(value - factor * part) % prime for value, part in zip(high[shift:], low, strict=True)]
            high.pop()
        high, low = low, high
    return len(high) == 1


def _remainder(dividend: Sequence[int], divisor: Sequence[int]) -> list[int]:
    """A multiple of the remainder, in integers."""
    rest = list(dividend)
    while len(rest) >= len(divisor):
        shift, factor = len(rest) - len(divisor), rest[-1]
        rest = [value * divisor[-1] for value in rest]
        for power, value in enumerate(divisor):
            rest[shift + power] -= factor * value
        rest.pop()
    return rest


def quotient(dividend: Polynomial, divisor: Polynomial) -> Polynomial:
    """A multiple of the quotient of two polynomials of which the second divides the first."""
    rest, result = [Fraction(value) for value in dividend], []
    for shift in range(len(dividend) - len(divisor), -1, -1):
        factor = rest.pop() / divisor[-1]
        result.append(factor)
        for power, value in enumerate(divisor[:-1]):
            rest[shift + power] -= factor * value
    return primitive(reversed(result))


# ------------------------------------------------------------------------------------------------------ roots


def isolate(polynomial: Polynomial) -> list[Root]:
    """Every root with 0 < v < 1, ascending; the polynomial has no multiple root there, or this does not end."""
    found: list[Root] = []
    pending = [(list(polynomial), 0, 0)]  # P((place + v)/2^depth) up to a factor
    while pending:
        local, place, depth = pending.pop()
        if local[0] == 0:
            if place:
                at = Fraction(place, 2**depth)
                found.append(Root(at, at))
            local = local[1:]
        changes = _variations(_shifted(local[::-1]))
        if changes == 1:
            found.append(Root(Fraction(place, 2**depth), Fraction(place + 1, 2**depth)))
        elif changes > 1:
            degree = len(local) - 1
            left = [value << (degree - power) for power, value in enumerate(local)]
            pending += [(left, 2 * place, depth + 1), (_shifted(left), 2 * place + 1, depth + 1)]
    return [_off_the_ends(polynomial, root) for root in sorted(found, key=lambda root: root.low)]


def _off_the_ends(polynomial: Polynomial, root: Root) -> Root:
    """The same root between ends that are no roots."""
    low, high = root.low, root.high
    while not root.exact and not (sign_at(polynomial, low) and sign_at(polynomial, high)):
        middle = (low + high) / 2
        value = sign_at(polynomial, middle)
        if value == 0:
            return Root(middle, middle)
        # A neighbour sits on an end: just inside of that end the sign is that of the slope there.
        at_low = sign_at(polynomial, low) or sign_at(derivative(polynomial), low)
        low, high = (middle, high) if value == at_low else (low, middle)
    return Root(low, high)


def refine(polynomial: Polynomial, root: Root, bits: int) -> Root:
    """The same root in an interval no wider than 2^−bits."""
    low, high = root.low, root.high
    if root.exact:
        return root
    at_low = sign_at(polynomial, low)
    width = high - low
    tolerance = Fraction(1, 2**bits)
    steps = 1
    while width > tolerance:
        # A cell of the secant's root, of 2^steps that the interval is cut into; halving where that misses.
        pieces = 2**steps
        cell = _secant(polynomial, low, high, pieces)
        left, right = low + width * cell / pieces, low + width * (cell + 1) / pieces
        signs = sign_at(polynomial, left), sign_at(polynomial, right)
        for value, at in zip(signs, (left, right), strict=True):
            if value == 0:
                return Root(at, at)
        if signs[0] == at_low and signs[1] == -at_low:
            low, high, steps = left, right, 2 * steps
        elif signs[0] == at_low:
            low, steps = right, max(1, steps // 2)
        else:
            high, steps = left, max(1, steps // 2)
        width = high - low
    return Root(low, high)


def _secant(polynomial: Polynomial, low: Fraction, high: Fraction, pieces: int) -> int:
    """Which of so many equal cells of the interval the chord crosses zero in."""
    at_low, at_high = (abs(_value(polynomial, end)) for end in (low, high))
    return min(pieces - 1, int(pieces * at_low / (at_low + at_high)))


def _value(polynomial: Sequence[int], v: Fraction) -> Fraction:
    value, power = 0, 1
    for coefficient in reversed(polynomial):
        value = value * v.numerator + coefficient * power
        power *= v.denominator
    return Fraction(value, power // v.denominator)


def _shifted(coefficients: list[int]) -> list[int]:
    """P(v + 1)."""
    values = list(coefficients)
    for start in range(len(values) - 1):
        for power in range(len(values) - 2, start - 1, -1):
            values[power] += values[power + 1]
    return values


def _variations(coefficients: Iterable[int]) -> int:
    signs = [value > 0 for value in coefficients if value]
    return sum(left != right for left, right in itertools.pairwise(signs))
