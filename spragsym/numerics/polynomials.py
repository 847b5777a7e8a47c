"""Polynomials in one variable, with coefficients from the lowest power on: greatest common
divisors, squarefree parts, interpolation, isolation and refinement of real roots.

Coefficients are integers or fractions, which are exact, or balls; with balls
:class:`.balls.UndecidedSign` means that more bits are needed. Real roots are isolated by Descartes'
rule of signs with bisection (Collins and Akritas), which misses none. At the end of the module: the
half-angle substitution t = tan(θ/2), and roots of many polynomials in floats.
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
    """Value of a polynomial at t, by Horner's rule."""
    value = polynomial[-1]
    for coefficient in reversed(polynomial[:-1]):
        value = value * t + coefficient
    return value


def derivative(polynomial: Sequence[Coefficient]) -> Polynomial:
    """Coefficients of the derivative."""
    return tuple(power * coefficient for power, coefficient in enumerate(polynomial))[1:]


def common_divisor(one: Polynomial, other: Polynomial) -> tuple[int, ...]:
    """Greatest common divisor, with coprime integer coefficients; () if both are zero."""
    dividend, divisor = primitive(one), primitive(other)
    if _coprime(dividend, divisor):
        return (1,)
    return _euclid(dividend, divisor, primitive)


#: A prime modulo which it is quickly shown that two polynomials have no common factor.
_PRIME = 2**61 - 1


def _coprime(one: tuple[int, ...], other: tuple[int, ...]) -> bool:
    """True if the polynomials modulo the prime have no common factor. Then they have none
    themselves, as its residue would be one, of the same degree.
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
    """Euclid's algorithm with pseudo-remainders, each simplified by ``reduced``."""
    while divisor:
        dividend, divisor = divisor, reduced(_remainder(dividend, divisor))
    return dividend


def squarefree(polynomial: Polynomial) -> tuple[int, ...]:
    """The squarefree part: the same roots, all simple."""
    return without(polynomial, common_divisor(polynomial, derivative(polynomial)))


def without(polynomial: Polynomial, divisor: tuple[int, ...]) -> tuple[int, ...]:
    """Quotient of a polynomial by a divisor with coprime integer coefficients; its coefficients are
    coprime integers, too (Gauss's lemma).
    """
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
    """The positive multiple with coprime integer coefficients, without leading zeros; () for
    zero.
    """
    common = math.lcm(*(value.denominator for value in polynomial))
    integers = [value.numerator * (common // value.denominator) for value in polynomial]
    while integers and not integers[-1]:
        integers.pop()
    divisor = math.gcd(*integers)
    return tuple(value // divisor for value in integers)


def has_root(polynomial: Polynomial, low: Fraction, high: Fraction) -> bool:
    """True if a polynomial other than zero has a root in (low, high], or at low = high."""
    return bool(_isolated(squarefree(polynomial), low, high)[1])


def _remainder(dividend: tuple[int, ...], divisor: tuple[int, ...]) -> list[int]:
    """Pseudo-remainder: a multiple of dividend mod divisor with integer coefficients."""
    rest = list(dividend)
    for shift in range(len(dividend) - len(divisor), -1, -1):
        factor = rest.pop()
        rest = [value * divisor[-1] for value in rest]
        for power, coefficient in enumerate(divisor[:-1]):
            rest[shift + power] -= factor * coefficient
    return rest


def interpolate(function: Callable[[Fraction], Fraction], degree: int) -> tuple[int, ...]:
    """The :func:`primitive` polynomial of a degree that agrees with ``function`` at degree + 1
    integers around 0, up to a factor.

    By Newton's divided differences, multiplied by degree! and by the common denominator of the
    values, so that all numbers are integers.
    """
    nodes = range(-(degree // 2), degree - degree // 2 + 1)
    values = [function(Fraction(node)) for node in nodes]
    common = math.lcm(*(value.denominator for value in values))
    differences, leading = [int(value * common) for value in values], list[int]()
    for order in range(degree + 1):
        leading.append(differences[0] * math.perm(degree, degree - order))
        differences = [after - before for before, after in itertools.pairwise(differences)]
    found = list[int]()
    # Horner's rule with factors t − node.
    for node, value in zip(reversed(nodes), reversed(leading), strict=True):
        found = [lower - node * one for lower, one in zip([0, *found], [*found, 0], strict=True)]
        found[0] += value
    return primitive(found)


@dataclass(frozen=True)
class RootOf:
    """A real root of ``polynomial``, in (low, high]; if ``backward``, its reciprocal is in (low,
    high].
    """

    polynomial: Polynomial
    low: Fraction
    high: Fraction
    backward: bool = False

    def interval(self) -> Interval:
        """A ball that contains the root."""
        value = balls.between(self.low, self.high)
        return 1 / value if self.backward else value

    def is_of(self, polynomial: Polynomial) -> bool:
        """True if the root is one of ``polynomial``, a divisor of its own."""
        chart = tuple(reversed(polynomial)) if self.backward else polynomial
        return has_root(chart, self.low, self.high)

    def sign_of(
        self, value: Interval, exactly: Callable[[Fraction], Fraction], degree: int, what: str
    ) -> int:
        """The sign of a polynomial of a ``degree`` at this root, which ``value`` encloses.

        ``exactly`` gives its values at rationals, with which it is decided whether it is 0 at the
        root. ``what`` names it in the error.
        """

        def vanishes() -> bool:
            return self.is_of(common_divisor(self.polynomial, interpolate(exactly, degree)))

        return balls.sign_or_zero(value, what, vanishes)


def roots_on_the_line(
    polynomial: tuple[Any, ...], bits: int, *, positive: bool = False
) -> list[RootOf]:
    """All real roots, or all positive ones, of a polynomial without multiple roots, to ``bits`` as
    in :func:`.real_roots`.

    Two charts: roots t up to a limit, and reciprocals 1/t of larger ones, as roots of the reversed
    polynomial. Exact coefficients are allowed for ``positive`` only: with balls a root at an end of
    a chart is undecided.
    """
    while positive and polynomial and isinstance(polynomial[0], int) and polynomial[0] == 0:
        polynomial = polynomial[1:]  # the root 0
    found: list[RootOf] = []
    if not polynomial:
        return found
    # Ends of the charts are no round numbers, which are roots for symmetric parameters.
    below, between = Fraction(-1, 7), Fraction(13, 11)
    for chart, limit, backward in (
        (polynomial, between, False),
        (tuple(reversed(polynomial)), 1 / between, True),
    ):
        for low, high in real_roots(chart, below if positive else -limit, limit, bits):
            in_both = backward and low == limit
            if not in_both and (high > 0 or not positive):
                found.append(RootOf(polynomial, low, high, backward))
    return found


def root_bound(polynomial: Sequence[int]) -> Fraction:
    """Cauchy's bound of the absolute value of every root."""
    return 1 + Fraction(max(map(abs, polynomial)), abs(polynomial[-1]))


class IsolatedRoot(NamedTuple):
    """Interval [low, high] with exactly one root, in its interior or, if low = high, equal to
    it.
    """

    low: Fraction
    high: Fraction


class _Cell(NamedTuple):
    """A cell with exactly one root: the open interval (n, m)/2^k, or the point n/2^k = m/2^k.
    ``above`` is the sign of the polynomial between the root and m/2^k.
    """

    n: int
    m: int
    k: int
    above: int = 0


def _sign(value: Fraction | Ball) -> int:
    """Sign of an integer, or of a ball, where it must not be 0."""
    found = balls.sign(value)
    if not found and isinstance(value, Ball):
        raise UndecidedSign("a polynomial holds 0 where its sign is needed")
    return found


def real_roots(
    polynomial: tuple[Any, ...], low: Fraction, high: Fraction, bits: int
) -> list[IsolatedRoot]:
    """All roots in (low, high], ascending, in intervals of a width below 2^−bits × min(1, distance
    from 0).

    The polynomial must have no multiple root there: otherwise this does not end.
    """
    unit, cells = _isolated(polynomial, low, high)
    common, start, scale = _common(low, high)

    def at(n: int, k: int) -> Fraction:
        return Fraction((start << k) + scale * n, common << k)

    def lacking(n: int, k: int) -> int:
        """Number of bisections of (n, n + 1)/2^k that are still needed; 0 or less if none is."""
        begin, one = (start << k) + scale * n, common << k
        distance = one
        if begin > 0 or begin + scale < 0:
            distance = min(abs(begin), abs(begin + scale), one)
        return (-((-scale << bits) // distance) - 1).bit_length()

    found = [_refined(cell, unit, lacking) for cell in cells]
    return sorted(IsolatedRoot(at(cell.n, cell.k), at(cell.m, cell.k)) for cell in found)


@lru_cache(maxsize=64)
def _isolated(
    polynomial: tuple[Any, ...], low: Fraction, high: Fraction
) -> tuple[list[Any], list[_Cell]]:
    """The polynomial in u, with t = low + (high − low) u, and a cell in u for each root in (low,
    high].

    Source: Collins and Akritas (1976). Descartes' rule on (0, 1) and on halves of it: without sign
    changes there is no root, with one change exactly one root.
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
    """The common denominator of both ends; the lower end and the width multiplied by it."""
    common = math.lcm(low.denominator, high.denominator)
    return common, int(low * common), int((high - low) * common)


def shifted(coefficients: Sequence[Any], by: Number = 1) -> list[Any]:
    """Coefficients of the polynomial p(u + by): Taylor shift."""
    values = list(coefficients)
    for start in range(len(values)):
        for power in range(len(values) - 2, start - 1, -1):
            values[power] += by * values[power + 1]
    return values


def _refined(cell: _Cell, polynomial: Sequence[Any], lacking: Callable[[int, int], int]) -> _Cell:
    """The cell refined until ``lacking`` is at most 0 and its ends are no roots; or the root
    itself.

    Source: quadratic interval refinement, J. Abbott (2006). The cell is divided into 2^j parts, and
    the part at the secant's zero is tried; j is doubled if it contains the root, else halved.
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
    """Index of the part, of 2^j, in which the chord between values of opposite signs crosses
    zero.
    """
    if isinstance(low, Ball):
        low, high = (sum(balls.ends(value)) for value in (low, high))
    return int((low * (1 << j)) // (low - high))


class OnCircle(NamedTuple):
    """cos θ, sin θ and their denominator 1 + t², for t = tan(θ/2)."""

    cosine: Any
    sine: Any
    scale: Any


def on_circle(t: Number) -> OnCircle:
    """cos θ and sin θ for tan(θ/2) = t, exact for a rational t."""
    scale = 1 + t * t
    return OnCircle((1 - t) * (1 + t) / scale, 2 * t / scale, scale)


def in_t(function: Callable[[Any, Any], Any], degree: int) -> Callable[[Fraction], Fraction]:
    """The polynomial (1 + t²)^degree f(cos θ, sin θ) in t = tan(θ/2), as a function of t; f is a
    polynomial of that degree.
    """

    def value(t: Fraction) -> Fraction:
        c, s, scale = on_circle(t)
        return Fraction(function(c, s) * scale**degree)

    return value


def of_sine_in_t(polynomial: Sequence[int]) -> tuple[int, ...]:
    """Coefficients in t = tan(θ/2) of (1 + t²)^degree p(sin θ), for the coefficients of p."""
    value, scale = [polynomial[-1]], [1]
    for coefficient in reversed(polynomial[:-1]):  # Horner's rule, times 1 + t² at each step
        scale = [one + other for one, other in zip([*scale, 0, 0], [0, 0, *scale], strict=True)]
        value = [
            2 * one + coefficient * other for one, other in zip([0, *value, 0], scale, strict=True)
        ]
    return tuple(value)


def by_power(coefficients: FloatArray) -> tuple[FloatArray, ...]:
    """Coefficients along the last axis as a tuple of arrays with a new last axis, for
    :func:`evaluate` at several arguments per polynomial.
    """
    return tuple(np.moveaxis(coefficients, -1, 0)[..., None])


def eigenvalues(coefficients: FloatArray) -> FloatArray | ComplexArray:
    """All complex roots of polynomials (…, degree + 1), as eigenvalues of the companion matrix,
    (…, degree); 0 if that overflows because of a small leading coefficient.
    """
    degree = coefficients.shape[-1] - 1
    companion = np.zeros((*coefficients.shape[:-1], degree, degree))
    companion[..., range(1, degree), range(degree - 1)] = 1.0
    companion[..., :, -1] = -coefficients[..., :-1] / coefficients[..., -1:]
    companion[~np.isfinite(companion).all(axis=(-1, -2))] = 0.0
    return np.linalg.eigvals(companion)


def polished(coefficients: FloatArray, roots: FloatArray) -> FloatArray:
    """Positive roots, ascending, improved by three Newton steps. Steps longer than half the
    distance to a neighbour or to 0 are omitted.
    """
    polynomial = by_power(coefficients)
    slope = derivative(polynomial)
    for _ in range(3):
        step = evaluate(polynomial, roots) / evaluate(slope, roots)
        gap = np.fmin(np.diff(roots, axis=-1, append=np.inf), np.diff(roots, axis=-1, prepend=0.0))
        roots = np.where(np.abs(step) < 0.5 * gap, roots - step, roots)
    return roots
