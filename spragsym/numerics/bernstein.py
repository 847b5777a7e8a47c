"""The positive roots of many polynomials of one degree, isolated with proof in float64: Descartes'
rule in Bernstein's basis.

With t = τ w/(1 − w) the half line t > 0 is 0 < w < 1, and the coefficients of a polynomial in t
over the binomials are those of Bernstein's basis in w. On a part of that interval the coefficients
are averages of those on the whole (de Casteljau), and their signs tell whether the part holds no
root or exactly one (Descartes, Vincent). Each coefficient carries a bound on its error; a
polynomial is given back as undecided where that bound leaves open a sign that is needed.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .affine import UNIT, Rounded, as_rounded
from .columns import ByColumn
from .interval_arrays import BoolArray, FloatArray, IndexArray, Int8Array, quiet

#: τ: no round number, so that roots of symmetric polynomials, at t = 1, lie inside of a part and
#: not at an end.
SCALE = 1.0703125


@dataclass(frozen=True)
class Parts(ByColumn):
    """Parts of 0 < w < 1, each with the coefficients of its row's polynomial there, of shape
    (degree + 1, parts).
    """

    row: IndexArray
    low: FloatArray
    width: FloatArray
    value: FloatArray
    error: FloatArray


@dataclass(frozen=True)
class PolynomialRoots:
    """Roots of many polynomials: rows, t with a radius that is proved, and the sign of the slope
    there; and undecided rows.
    """

    row: IndexArray
    t: Rounded
    rising: Int8Array
    undecided: BoolArray


def positive_roots(coefficients: Sequence[Any], size: int) -> PolynomialRoots:
    """Every positive root of ``size`` polynomials, lowest power first: of rows that are decided
    all, simple, in no order.
    """
    pending = _beginning(coefficients, size)
    undecided = np.asarray(~np.isfinite(pending.value + pending.error).all(axis=0))
    found = []
    # Halvings after which a row is undecided: roots closer than 2^-30 are for exact
    # arithmetic.
    most_halvings = 30
    for depth in range(most_halvings + 1):
        none, one = _descartes(pending)
        found.append(pending[np.flatnonzero(one)])
        pending = pending[np.flatnonzero(~(none | one | undecided[pending.row]))]
        if not pending.row.size:
            break
        if depth == most_halvings:
            undecided[pending.row] = True
            break
        pending = _halved(pending)
        half = pending.row.size // 2
        # Lower halves whose value at the cut has no sign: more halvings would not give it one.
        undecided[
            pending.row[:half][np.abs(pending.value[-1, :half]) <= pending.error[-1, :half]]
        ] = True
    return _refined(found[0].concatenated(*found[1:]), undecided)


@dataclass(frozen=True)
class Signs:
    """Signs of many polynomials on a part each: at its lower end; whether all of it is negative, or
    some of it positive.

    What the bounds leave open is 0 and neither.
    """

    at_low: Int8Array
    negative: BoolArray
    positive: BoolArray


def signs_between(
    coefficients: Sequence[Any], low: FloatArray, high: FloatArray, off: FloatArray
) -> Signs:
    """Signs of polynomials, lowest power first, between places in w = t/(t + ``SCALE``), which are
    known to ``off``.
    """
    size = low.size
    whole = _beginning(coefficients, size)
    with quiet():
        upper = _cut(whole.value, low)[1]
        value = _cut(upper, np.clip((high - low) / (1 - low), 0.0, 1.0))[0]
    # Two cuts round as often as two evaluations. A place off by ε moves a value by 2 · degree · ε
    # times the largest coefficient.
    largest = np.abs(whole.value).max(axis=0)
    noise = whole.error.max(axis=0) + (len(value) - 1) * (16 * UNIT + 2 * off) * largest
    at_low = Rounded(value[0], noise).sign()
    negative, positive = np.isfinite(noise), np.zeros(size, dtype=bool)
    row = np.flatnonzero(negative)
    value = value[:, row]
    # Halvings of a part after which its signs are left open.
    halvings = 6
    for halving in range(halvings + 1):
        limit = noise[row] * (1 + 0.1 * halving)
        positive[row[(value[0] > limit) | (value[-1] > limit)]] = True
        pending = ~((value < -limit).all(axis=0) | positive[row])
        row = row[pending]
        if halving == halvings or not row.size:
            break
        value = np.concatenate(_cut(value[:, pending]), axis=1)
        row = np.tile(row, 2)
    negative[row] = False
    return Signs(at_low, negative & ~positive, positive)


def _cut(value: FloatArray, t: FloatArray | float = 0.5) -> tuple[FloatArray, FloatArray]:
    """Coefficients on both sides of a place between 0 and 1, by de Casteljau's rule; halved, each
    average is rounded once.
    """
    upper, lower = value.copy(), np.empty_like(value)
    lower[0] = upper[0]
    for step in range(1, len(value)):
        upper[:-step] = upper[:-step] * (1 - t) + upper[1 : len(value) - step + 1] * t
        lower[step] = upper[0]
    return lower, upper


def _beginning(coefficients: Sequence[Any], size: int) -> Parts:
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
    """Parts that hold no root, and those that hold exactly one, a simple one. An open sign between
    two that differ changes nothing.
    """
    signs = Rounded(parts.value, parts.error).sign()
    unknown = signs == 0
    number = unknown.sum(axis=0, dtype=np.int8)
    # An open sign repeats the one before it, so that it is no change; the first one has none before
    # it and counts as a change.
    filled = signs.copy()
    filled[1:][unknown[1:]] = signs[:-1][unknown[1:]]
    changes = (filled[1:] != filled[:-1]).sum(axis=0, dtype=np.int8)
    between = ((signs[2:] * signs[:-2] < 0) & unknown[1:-1]).any(axis=0)
    inside = ~unknown[0] & ~unknown[-1]
    return (changes == 0) & (number == 0), (changes == 1) & inside & (
        (number == 0) | ((number == 1) & between)
    )


def _halved(parts: Parts) -> Parts:
    """Both halves of each part, the lower ones first. A halving rounds ``degree`` times, at most by
    the largest value there.
    """
    low_value, high_value = _cut(parts.value)
    degree = len(parts.value) - 1
    # Each average is rounded relative to itself; the averages of the sizes bound those of the
    # values.
    spread = (parts.error + 1.01 * degree * UNIT * np.abs(parts.value)) * (1 + 2 * degree * UNIT)
    low_error, high_error = _cut(spread)
    half = 0.5 * parts.width
    lower = Parts(parts.row, parts.low, half, low_value, low_error)
    return lower.concatenated(Parts(parts.row, parts.low + half, half, high_value, high_error))


def _at(value: FloatArray, t: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Polynomials at a place between 0 and 1, and their slopes, by de Casteljau's rule.

    It rounds the value no more than 4 · degree times, each relative to the largest coefficient.
    """
    value, degree = value.copy(), len(value) - 1
    for step in range(1, degree):
        value[:-step] += (value[1 : degree - step + 2] - value[:-step]) * t
    rise = value[1] - value[0]
    return value[0] + rise * t, degree * rise


def _refined(parts: Parts, undecided: BoolArray) -> PolynomialRoots:
    """Each root by Newton's rule, or by halving where that leaves its part; and a radius at whose
    ends the signs differ.
    """
    degree = len(parts.value) - 1
    noise = parts.error.max(axis=0) + 8 * degree * UNIT * np.abs(parts.value).max(axis=0)
    rising = np.where(parts.value[-1] > 0, 1, -1).astype(np.int8)
    low, high = np.zeros(parts.row.size), np.ones(parts.row.size)
    root, slope = parts.value[0] / (parts.value[0] - parts.value[-1]), np.empty(parts.row.size)
    active = np.arange(parts.row.size)
    for _ in range(60):
        here = root[active]
        value, slope[active] = _at(parts.value[:, active], here)
        below = value * rising[active] < 0
        low[active], high[active] = (
            np.where(below, here, low[active]),
            np.where(below, high[active], here),
        )
        fresh = here - value / slope[active]
        inside = (fresh > low[active]) & (fresh < high[active])
        root[active] = np.where(inside, fresh, 0.5 * (low[active] + high[active]))
        done = (np.abs(value) <= noise[active]) | (np.abs(root[active] - here) < UNIT)
        root[active[done]] = here[done]
        active = active[~done]
        if not active.size:
            break
    radius = 4 * noise / np.abs(slope) + 8 * UNIT
    for _ in range(5):
        left, right = np.maximum(root - radius, 0.0), np.minimum(root + radius, 1.0)
        # At the ends of a part the signs are known.
        proved = (left == 0.0) | (_at(parts.value, left)[0] * rising < -noise)
        proved &= (right == 1.0) | (_at(parts.value, right)[0] * rising > noise)
        if proved.all():
            break
        radius = np.where(proved, radius, 8 * radius)
    undecided = undecided.copy()
    undecided[parts.row[~proved]] = True
    keep = ~undecided[parts.row]
    low, root, error = parts.low[keep], (parts.width * root)[keep], (parts.width * radius)[keep]
    w, complement = (Rounded(value, error + 2 * UNIT) for value in (low + root, (1 - low) - root))
    return PolynomialRoots(parts.row[keep], w / complement * SCALE, rising[keep], undecided)
