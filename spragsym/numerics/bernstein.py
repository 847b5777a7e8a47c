"""Proved isolation of the positive roots of many polynomials of one degree, in float64, by
Descartes' rule of signs in the Bernstein basis.

The substitution t = τ w/(1 − w) maps 0 < w < 1 to t > 0. The coefficients in t, divided by the
binomial coefficients, are those of the Bernstein basis in w. On a part of the interval they follow
by de Casteljau's algorithm, as averages. The number of their sign changes tells whether a part
holds no root or exactly one (Vincent's theorem); otherwise the part is bisected. Each coefficient
has an error bound. A polynomial is undecided if a sign that is needed is not proved.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .affine import UNIT, Rounded, as_rounded
from .columns import ByColumn
from .interval_arrays import BoolArray, FloatArray, IndexArray, Int8Array, quiet

#: τ. With τ = 1, the roots of symmetric polynomials, at t = 1, would be at ends of parts.
SCALE = 1.0703125


@dataclass(frozen=True)
class Parts(ByColumn):
    """Parts of 0 < w < 1, with Bernstein coefficients ``value`` ± ``error``, shape (degree + 1,
    parts).

    ``row`` is the index of the polynomial.
    """

    row: IndexArray
    low: FloatArray
    width: FloatArray
    value: FloatArray
    error: FloatArray


@dataclass(frozen=True)
class PolynomialRoots:
    """Roots t of many polynomials, with proved error bounds.

    ``row`` is the index of the polynomial of each root, and ``rising`` the sign of the derivative
    there. ``undecided`` marks the polynomials without result.
    """

    row: IndexArray
    t: Rounded
    rising: Int8Array
    undecided: BoolArray


def positive_roots(coefficients: Sequence[Any], size: int) -> PolynomialRoots:
    """All positive roots of ``size`` polynomials, coefficients of the lowest power first.

    The roots of a decided polynomial are simple. They are in no order.
    """
    pending = _bernstein_form(coefficients, size)
    undecided = np.asarray(~np.isfinite(pending.value + pending.error).all(axis=0))
    found = []
    # Roots closer than 2^-30 need exact arithmetic.
    most_bisections = 30
    for depth in range(most_bisections + 1):
        none, one = _descartes(pending)
        found.append(pending[np.flatnonzero(one)])
        pending = pending[np.flatnonzero(~(none | one | undecided[pending.row]))]
        if not pending.row.size:
            break
        if depth == most_bisections:
            undecided[pending.row] = True
            break
        pending = _bisected(pending)
        half = pending.row.size // 2
        # If the sign at the cut is not proved, more bisections do not help.
        at_cut, error = pending.value[-1, :half], pending.error[-1, :half]
        undecided[pending.row[:half][np.abs(at_cut) <= error]] = True
    return _refined(found[0].concatenated(*found[1:]), undecided)


@dataclass(frozen=True)
class Signs:
    """Signs of many polynomials, each on a range: at its lower end, whether it is negative
    throughout, and whether it is positive somewhere.

    If a sign is not proved, ``at_low`` is 0; if neither of the others is, both are False.
    """

    at_low: Int8Array
    negative: BoolArray
    positive: BoolArray


def signs_between(
    coefficients: Sequence[Any], low: FloatArray, high: FloatArray, off: FloatArray
) -> Signs:
    """Signs of polynomials, lowest power first, between two values of w = t/(t + ``SCALE``), whose
    errors are at most ``off``.
    """
    size = low.size
    whole = _bernstein_form(coefficients, size)
    with quiet():
        upper = _subdivided(whole.value, low)[1]
        value = _subdivided(upper, np.clip((high - low) / (1 - low), 0.0, 1.0))[0]
    # Two subdivisions round as often as two evaluations. An error ε of w moves a value by at most
    # 2 · degree · ε times the largest coefficient.
    largest = np.abs(whole.value).max(axis=0)
    noise = whole.error.max(axis=0) + (len(value) - 1) * (16 * UNIT + 2 * off) * largest
    at_low = Rounded(value[0], noise).sign()
    negative, positive = np.isfinite(noise), np.zeros(size, dtype=bool)
    row = np.flatnonzero(negative)
    value = value[:, row]
    most_bisections = 6
    for depth in range(most_bisections + 1):
        limit = noise[row] * (1 + 0.1 * depth)
        positive[row[(value[0] > limit) | (value[-1] > limit)]] = True
        pending = ~((value < -limit).all(axis=0) | positive[row])
        row = row[pending]
        if depth == most_bisections or not row.size:
            break
        value = np.concatenate(_subdivided(value[:, pending]), axis=1)
        row = np.tile(row, 2)
    negative[row] = False
    return Signs(at_low, negative & ~positive, positive)


def _subdivided(value: FloatArray, t: FloatArray | float = 0.5) -> tuple[FloatArray, FloatArray]:
    """Coefficients on both sides of a cut between 0 and 1, by de Casteljau's algorithm.

    With t = 1/2 each average is rounded once.
    """
    upper, lower = value.copy(), np.empty_like(value)
    lower[0] = upper[0]
    for step in range(1, len(value)):
        upper[:-step] = upper[:-step] * (1 - t) + upper[1 : len(value) - step + 1] * t
        lower[step] = upper[0]
    return lower, upper


def _bernstein_form(coefficients: Sequence[Any], size: int) -> Parts:
    """Bernstein coefficients on 0 < w < 1, scaled by a power of 2 to at most 1."""
    degree = len(coefficients) - 1
    value, error = np.empty((degree + 1, size)), np.empty((degree + 1, size))
    for power, coefficient in enumerate(coefficients):
        scaled = as_rounded(coefficient) * (SCALE**power / math.comb(degree, power))
        value[power], error[power] = scaled.value, scaled.error
        error[power] += 2 * degree * UNIT * np.abs(value[power])  # the factor is rounded itself
    largest = np.abs(value).max(axis=0)
    exponent = -np.frexp(np.where((largest > 0) & np.isfinite(largest), largest, 1.0))[1]
    return Parts(
        np.arange(size),
        np.zeros(size),
        np.ones(size),
        np.ldexp(value, exponent),
        np.ldexp(error, exponent),
    )


def _descartes(parts: Parts) -> tuple[BoolArray, BoolArray]:
    """Masks of the parts without root, and of those with exactly one root, which is simple.

    One coefficient between two of opposite signs may have any sign: there is one change anyway.
    """
    signs = Rounded(parts.value, parts.error).sign()
    unknown = signs == 0
    number = unknown.sum(axis=0, dtype=np.int8)
    # An unknown sign is replaced by the one before it, so that it is no change; the first one stays
    # 0 and counts as a change.
    filled = signs.copy()
    filled[1:][unknown[1:]] = signs[:-1][unknown[1:]]
    changes = (filled[1:] != filled[:-1]).sum(axis=0, dtype=np.int8)
    between = ((signs[2:] * signs[:-2] < 0) & unknown[1:-1]).any(axis=0)
    ends_known = ~unknown[0] & ~unknown[-1]
    one = (changes == 1) & ends_known & ((number == 0) | ((number == 1) & between))
    return (changes == 0) & (number == 0), one


def _bisected(parts: Parts) -> Parts:
    """Both halves of each part, the lower ones first."""
    low_value, high_value = _subdivided(parts.value)
    degree = len(parts.value) - 1
    # ``degree`` averages, each rounded relative to its size; the averages of |value| bound these.
    spread = (parts.error + 1.01 * degree * UNIT * np.abs(parts.value)) * (1 + 2 * degree * UNIT)
    low_error, high_error = _subdivided(spread)
    half = 0.5 * parts.width
    lower = Parts(parts.row, parts.low, half, low_value, low_error)
    return lower.concatenated(Parts(parts.row, parts.low + half, half, high_value, high_error))


def _value_and_slope(value: FloatArray, t: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Values and derivatives at a point of each part, 0 ≤ t ≤ 1, by de Casteljau's algorithm.

    The value is rounded at most 4 · degree times, each relative to the largest coefficient.
    """
    value, degree = value.copy(), len(value) - 1
    for step in range(1, degree):
        value[:-step] += (value[1 : degree - step + 2] - value[:-step]) * t
    rise = value[1] - value[0]
    return value[0] + rise * t, degree * rise


def _refined(parts: Parts, undecided: BoolArray) -> PolynomialRoots:
    """The root of each part, by Newton's method with bisection as a fallback.

    The error bound is a radius at whose ends opposite signs are proved.
    """
    degree = len(parts.value) - 1
    noise = parts.error.max(axis=0) + 8 * degree * UNIT * np.abs(parts.value).max(axis=0)
    rising = np.where(parts.value[-1] > 0, 1, -1).astype(np.int8)
    low, high = np.zeros(parts.row.size), np.ones(parts.row.size)
    root, slope = parts.value[0] / (parts.value[0] - parts.value[-1]), np.empty(parts.row.size)
    active = np.arange(parts.row.size)
    for _ in range(60):
        here = root[active]
        value, slope[active] = _value_and_slope(parts.value[:, active], here)
        below = value * rising[active] < 0
        low[active] = np.where(below, here, low[active])
        high[active] = np.where(below, high[active], here)
        newton = here - value / slope[active]
        inside = (newton > low[active]) & (newton < high[active])
        root[active] = np.where(inside, newton, 0.5 * (low[active] + high[active]))
        done = (np.abs(value) <= noise[active]) | (np.abs(root[active] - here) < UNIT)
        root[active[done]] = here[done]
        active = active[~done]
        if not active.size:
            break
    radius = 4 * noise / np.abs(slope) + 8 * UNIT
    for _ in range(5):
        left, right = np.maximum(root - radius, 0.0), np.minimum(root + radius, 1.0)
        # The signs at the ends of a part are known.
        proved = (left == 0.0) | (_value_and_slope(parts.value, left)[0] * rising < -noise)
        proved &= (right == 1.0) | (_value_and_slope(parts.value, right)[0] * rising > noise)
        if proved.all():
            break
        radius = np.where(proved, radius, 8 * radius)
    undecided = undecided.copy()
    undecided[parts.row[~proved]] = True
    keep = ~undecided[parts.row]
    low, root, error = parts.low[keep], (parts.width * root)[keep], (parts.width * radius)[keep]
    w = Rounded(low + root, error + 2 * UNIT)
    complement = Rounded((1 - low) - root, error + 2 * UNIT)
    return PolynomialRoots(parts.row[keep], w / complement * SCALE, rising[keep], undecided)
