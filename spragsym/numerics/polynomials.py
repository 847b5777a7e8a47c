"""Polynomials, coefficients lowest power first: common divisors, squarefree parts, interpolation,
real roots.

Coefficients are integers or fractions, of which nothing is rounded, or balls, where
:class:`.balls.UndecidedSign` says that more bits are needed. Real roots are isolated by Descartes'
rule of signs, so that none is missed: intervals are halved, which only adds and shifts. At the end
the half-angle map, and roots of many polynomials in floats.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from ..core.type_variables import T
from . import balls
from .arithmetic import Number
from .balls import Ball, Interval, UndecidedSign
from .interval_arrays import ComplexArray, FloatArray

#: A Fraction or a ball.
Coefficient: TypeAlias = Any
Polynomial: TypeAlias = tuple[Coefficient, ...]


def evaluate(polynomial: Sequence[Coefficient], t: T) -> T:
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
    return _euclid(dividend, divisor, primitive)


#: A prime; residues of it tell quickly that two polynomials have no common factor.
_PRIME = 2**61 - 1


def _coprime(one: tuple[int, ...], other: tuple[int, ...]) -> bool:
    """Whether residues prove that there is no common factor: it would be one of the residues as
    well, of the same degree.
    """
    dividend, divisor = _residues(one), _residues(other)
    return len(other) == len(divisor) > 0 and len(_euclid(dividend, divisor, _residues)) == 1


def _residues(polynomial: Sequence[int]) -> tuple[int, ...]:
    return primitive([value % _PRIME for value in polynomial])


def _euclid(
    dividend: tuple[int, ...],
    divisor: tuple[int, ...],
    reduced: Callable[[list[int]], tuple[int, ...]],
) -> tuple[int, ...]:
    """Euclid's algorithm, with remainders as multiples that are ``reduced``."""
    while divisor:
        dividend, divisor = divisor, reduced(_remainder(dividend, divisor))
    return dividend


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
    return bool(_isolated(squarefree(polynomial), low, high)[1])


def _remainder(dividend: tuple[int, ...], divisor: tuple[int, ...]) -> list[int]:
    """A multiple of dividend mod divisor."""
    rest = list(dividend)
    for shift in range(len(dividend) - len(divisor), -1, -1):
        factor = rest.pop()
        rest = [value * divisor[-1] for value in rest]
        for power, coefficient in enumerate(divisor[:-1]):
            rest[shift + power] -= factor * coefficient
    return rest


def interpolate(function: Callable[[Fraction], Fraction], degree: int) -> tuple[int, ...]:
    """The polynomial of that degree through the values of ``function`` at integers about 0, as
    :func:`primitive` makes it.

    By Newton's differences, times degree! and the common denominator of the values, so that nothing
    but integers is added up.
    """
    nodes = range(-(degree // 2), degree - degree // 2 + 1)
    values = [function(Fraction(node)) for node in nodes]
    common = math.lcm(*(value.denominator for value in values))
    differences, leading = [int(value * common) for value in values], list[int]()
    for order in range(degree + 1):
        leading.append(differences[0] * math.perm(degree, degree - order))
        differences = [after - before for before, after in itertools.pairwise(differences)]
    found = list[int]()
    for node, value in zip(
        reversed(nodes), reversed(leading), strict=True
    ):  # Horner's rule, with t less each node
        found = [lower - node * one for lower, one in zip([0, *found], [*found, 0], strict=True)]
        found[0] += value
    return primitive(found)


@dataclass(frozen=True)
class RootOf:
    """A real root of a polynomial in (low, high], or of the reversed polynomial: then it is the
    reciprocal.
    """

    polynomial: Polynomial
    low: Fraction
    high: Fraction
    backward: bool = False

    def interval(self) -> Interval:
        """An interval that holds the root."""
        value = balls.between(self.low, self.high)
        return 1 / value if self.backward else value

    def is_of(self, polynomial: Polynomial) -> bool:
        """Whether it is one of a divisor of its polynomial."""
        return has_root(
            tuple(reversed(polynomial)) if self.backward else polynomial, self.low, self.high
        )

    def sign_of(
        self, value: Interval, exactly: Callable[[Fraction], Fraction], degree: int, what: str
    ) -> int:
        """The sign of an interval; 0 where what it encloses is 0 exactly, as a polynomial of that
        degree has this root too.
        """

        def vanishes() -> bool:
            return self.is_of(common_divisor(self.polynomial, interpolate(exactly, degree)))

        return balls.sign_or_zero(value, what, vanishes)


def roots_on_the_line(
    polynomial: tuple[Any, ...], bits: int, *, positive: bool = False
) -> list[RootOf]:
    """All real roots of a polynomial without multiple ones, or the positive ones only; arguments as
    of :func:`.real_roots`.

    Exact coefficients go with ``positive`` only: an end of a chart may be a root of theirs, where
    balls are undecided.
    """
    while positive and polynomial and isinstance(polynomial[0], int) and polynomial[0] == 0:
        polynomial = polynomial[1:]  # the root 0
    found: list[RootOf] = []
    if not polynomial:
        return found
    # Lower end of both charts where roots are positive: no round number, where roots of
    # symmetric parameters are.
    below = Fraction(-1, 7)
    # Where the charts meet, no round number either.
    between = Fraction(13, 11)
    for chart, limit, backward in (
        (polynomial, between, False),
        (tuple(reversed(polynomial)), 1 / between, True),
    ):
        for low, high in real_roots(chart, below if positive else -limit, limit, bits):
            at_the_end = backward and low == limit  # which the first chart has
            if not at_the_end and (high > 0 or not positive):
                found.append(RootOf(polynomial, low, high, backward))
    return found


def root_bound(polynomial: Sequence[int]) -> Fraction:
    """Upper bound of the absolute value of every root: Cauchy's bound."""
    return 1 + Fraction(max(map(abs, polynomial)), abs(polynomial[-1]))


class IsolatedRoot(NamedTuple):
    """The only root of its polynomial in [low, high]: inside, or at both where the two are
    equal.
    """

    low: Fraction
    high: Fraction


class _Cell(NamedTuple):
    """One root in the open interval (n, m)/2^k, or at n/2^k = m/2^k; and the sign between it and
    m/2^k, where that is asked.
    """

    n: int
    m: int
    k: int
    above: int = 0


def _sign(value: Fraction | Ball) -> int:
    """Sign of an integer or a ball; only an integer may be 0."""
    found = balls.sign(value)
    if not found and isinstance(value, Ball):
        raise UndecidedSign("a polynomial holds 0 where its sign is needed")
    return found


def real_roots(
    polynomial: tuple[Any, ...], low: Fraction, high: Fraction, bits: int
) -> list[IsolatedRoot]:
    """Every root in (low, high], ascending, to a width below 2^−bits, and below 2^−bits of a
    distance from 0 that is below 1.

    The polynomial has no multiple root there, or this does not end.
    """
    unit, cells = _isolated(polynomial, low, high)
    common, start, scale = _common(low, high)

    def at(n: int, k: int) -> Fraction:
        return Fraction((start << k) + scale * n, common << k)

    def lacking(n: int, k: int) -> int:
        """Number of halvings of (n, n + 1)/2^k that are still to be done; at most 0 if none is."""
        begin, one = (start << k) + scale * n, common << k
        distance = (
            min(abs(begin), abs(begin + scale), one) if begin > 0 or begin + scale < 0 else one
        )
        return (-((-scale << bits) // distance) - 1).bit_length()

    found = [_refined(cell, unit, lacking) for cell in cells]
    return sorted(IsolatedRoot(at(cell.n, cell.k), at(cell.m, cell.k)) for cell in found)


@lru_cache(maxsize=64)
def _isolated(
    polynomial: tuple[Any, ...], low: Fraction, high: Fraction
) -> tuple[list[Any], list[_Cell]]:
    """The polynomial in u, where t = low + (high − low) u, and a cell in u for each root in (low,
    high].

    Source: Descartes' rule in (0, 1) and halves of it: no change of sign, no root; one change, one
    root (Collins, Akritas 1976).
    """
    common, start, scale = _common(low, high)
    degree = len(polynomial) - 1
    about = shifted(
        [value * common ** (degree - power) for power, value in enumerate(polynomial)], start
    )
    unit = [value * scale**power for power, value in enumerate(about)]
    found = [] if _sign(sum(unit)) else [_Cell(1, 1, 0)]
    pending = [(unit, 0, 0)]
    while pending:
        local, n, k = pending.pop()
        signs = [sign for value in shifted(local[::-1]) if (sign := _sign(value))]
        changes = sum(left != right for left, right in itertools.pairwise(signs))
        if changes == 1:
            found.append(_Cell(n, n + 1, k, -(_sign(local[0]) or _sign(local[1]))))
        elif changes:
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


def shifted(coefficients: Sequence[Any], by: Number = 1) -> list[Any]:
    """Coefficients of the polynomial at u + ``by``."""
    values = list(coefficients)
    for start in range(len(values)):
        for power in range(len(values) - 2, start - 1, -1):
            values[power] += by * values[power + 1]
    return values


def _refined(cell: _Cell, polynomial: Sequence[Any], lacking: Callable[[int, int], int]) -> _Cell:
    """The root in a cell that lacks nothing and whose ends are no roots, or the root itself.

    The secant's guess is tried on a grid of 2^j parts of the cell, j twice as large where it is
    right, else half. Source: quadratic interval refinement, J. Abbott (2006).
    """
    n, m, k, above = cell
    if n == m:
        return cell

    def value(n: int, k: int) -> Coefficient:
        """2^(k degree) times the polynomial at n/2^k."""
        found, scale = polynomial[-1], 1
        for coefficient in reversed(polynomial[:-1]):
            scale <<= k
            found = found * n + coefficient * scale
        return found

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


def _share(low: Coefficient, high: Coefficient, j: int) -> int:
    """Part of 2^j, from below, in which the chord of values of opposite signs, or of their middles,
    crosses zero.
    """
    if isinstance(low, Ball):
        low, high = (sum(balls.ends(value)) for value in (low, high))
    return int((low * (1 << j)) // (low - high))


class OnCircle(NamedTuple):
    """cos θ, sin θ and their denominator 1 + t² at t = tan(θ/2)."""

    cosine: Any
    sine: Any
    scale: Any


def on_circle(t: Number) -> OnCircle:
    """The direction θ with tan(θ/2) = t, exactly for a rational t."""
    scale = 1 + t * t
    return OnCircle((1 - t) * (1 + t) / scale, 2 * t / scale, scale)


def in_t(function: Callable[[Any, Any], Any], degree: int) -> Callable[[Fraction], Fraction]:
    """(1 + t²)^degree times a function of that degree in cos θ and sin θ, which is a polynomial in
    t.
    """

    def value(t: Fraction) -> Fraction:
        c, s, scale = on_circle(t)
        return Fraction(function(c, s) * scale**degree)

    return value


def of_sine_in_t(polynomial: Sequence[int]) -> tuple[int, ...]:
    """(1 + t²)^degree times a polynomial in sin θ, lowest power first: its coefficients in t."""
    value, scale = [polynomial[-1]], [1]
    for coefficient in reversed(polynomial[:-1]):  # Horner's rule, times 1 + t² at each step
        scale = [one + other for one, other in zip([*scale, 0, 0], [0, 0, *scale], strict=True)]
        value = [
            2 * one + coefficient * other for one, other in zip([0, *value, 0], scale, strict=True)
        ]
    return tuple(value)


def by_power(coefficients: FloatArray) -> tuple[FloatArray, ...]:
    """Coefficients from the last axis, each ready to meet several arguments, as :func:`evaluate`
    takes them.
    """
    return tuple(np.moveaxis(coefficients, -1, 0)[..., None])


def eigenvalues(coefficients: FloatArray) -> FloatArray | ComplexArray:
    """All complex roots of each polynomial, lowest power first; 0 where its leading coefficient is
    too small for them.
    """
    degree = coefficients.shape[-1] - 1
    companion = np.zeros((*coefficients.shape[:-1], degree, degree))
    companion[..., range(1, degree), range(degree - 1)] = 1.0
    companion[..., :, -1] = -coefficients[..., :-1] / coefficients[..., -1:]
    companion[~np.isfinite(companion).all(axis=(-1, -2))] = 0.0
    return np.linalg.eigvals(companion)


def polished(coefficients: FloatArray, roots: FloatArray) -> FloatArray:
    """Three Newton steps on positive roots in ascending order, none longer than half the way to a
    neighbour or to 0.
    """
    polynomial = by_power(coefficients)
    slope = derivative(polynomial)
    for _ in range(3):
        step = evaluate(polynomial, roots) / evaluate(slope, roots)
        gap = np.fmin(np.diff(roots, axis=-1, append=np.inf), np.diff(roots, axis=-1, prepend=0.0))
        roots = np.where(np.abs(step) < 0.5 * gap, roots - step, roots)
    return roots
