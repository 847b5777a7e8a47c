"""Cubics whose last coefficient is an interval: roots told apart, none lost, and none invented."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from spragsym.exact import cubics as subject
from spragsym.exact.cubics import Cubics
from spragsym.exact.double_double import DoubleDouble
from spragsym.exact.interval_arrays import Intervals
from spragsym.exact.wide_balls import WideBalls


def isolated(*given):
    """NumPy's warnings are for the caller to silence."""
    with np.errstate(all="ignore"):
        return subject.isolated(*given)


def wide(numbers):
    """Fractions in double-double, to 2⁻¹⁰⁴."""
    high = np.array([float(number) for number in numbers])
    low = np.array([float(number - Fraction(float(top))) for number, top in zip(numbers, high, strict=True)])
    return WideBalls(DoubleDouble(high, low), np.abs(high) * 2.0**-104)


def cubics(rows, spread=0.0):
    """From exact coefficients, the last one known up to a part of itself."""
    c0, c1, c2, c3 = (list(column) for column in zip(*rows, strict=True))
    bend = np.array([float(value) for value in c2])
    last = np.array([float(value) for value in c3])
    off = np.abs(last) * (spread + 2.0**-50)
    return Cubics(
        wide(c0), wide(c1), Intervals.between(bend - np.abs(bend) * 2.0**-50, bend + np.abs(bend) * 2.0**-50),
        Intervals.between(last - off, last + off),
    )  # fmt: skip


def product(roots, factor=Fraction(1)):
    """Coefficients of factor (h − a)(h − b)(h − c)."""
    a, b, c = roots
    return -factor * a * b * c, factor * (a * b + a * c + b * c), -factor * (a + b + c), factor


def within(low, high, root):
    return Fraction(float(low)) < root < Fraction(float(high))


@pytest.mark.parametrize("gap", [Fraction(1, 2**k) for k in (3, 10, 20, 27)])
@pytest.mark.parametrize("factor", [Fraction(1), Fraction(-3, 7)])
def test_three_roots_of_any_distance_are_told_apart(gap, factor):
    roots = [-gap, gap / 7, 2 * gap]
    low, high, guess, number, failed = isolated(cubics([product(roots, factor)]), np.array([-0.3]), np.array([0.31]))
    assert not failed.any()
    order = np.argsort(low)
    assert number.tolist() == [0, 0, 0]
    for place, root in zip(order, roots, strict=True):
        assert within(low[place], high[place], root)
        assert abs(guess[place] / float(root) - 1) < 1e-6
    assert (high[order][:-1] <= low[order][1:]).all()


@pytest.mark.parametrize("off", [Fraction(1, 10**k) for k in (6, 12, 20, 26)])
def test_two_roots_or_none_are_decided_at_the_extremum(off):
    # h² ∓ off, about a point that is the extremum to 1e-17 only, with a last coefficient that is not known at all.
    rows = [(sign * off, Fraction(1, 10**17), Fraction(1), Fraction(1, 8)) for sign in (-1, 1)]
    low, high, _, number, failed = isolated(cubics(rows, spread=1.0), np.full(2, -0.25), np.full(2, 0.25))
    assert not failed.any()
    assert number.tolist() == [0, 0]
    for place, sign in zip(np.argsort(low), (-1, 1), strict=True):
        assert low[place] < sign * float(off) ** 0.5 < high[place]


def test_a_double_root_and_what_is_unknown_are_not_decided():
    rows = [(Fraction(0), Fraction(0), Fraction(1), Fraction(0)), (Fraction(1, 10**40), Fraction(0), Fraction(1), Fraction(0))]
    known = cubics(rows)
    *_, number, failed = isolated(known, np.full(2, -0.25), np.full(2, 0.25))
    assert failed[0]
    assert number.tolist() == []
    nothing = Cubics(known.value, known.slope, Intervals(np.full((2, 2), np.nan)), known.last)
    *_, failed = isolated(nothing, np.full(2, -0.25), np.full(2, 0.25))
    assert failed.all()


def test_whatever_the_last_coefficient_is_within_its_bounds_the_roots_are_in_the_spans():
    rng = np.random.default_rng(5)
    count, spread = 400, 0.02
    rows = [
        [Fraction(float(value)) for value in part]
        for part in np.stack([10.0 ** -rng.uniform(2, 9, count) * rng.choice([-1, 1], count), 10.0 ** -rng.uniform(2, 6, count)
                              * rng.choice([-1, 1], count), rng.normal(0, 0.1, count), rng.normal(0, 1, count)], axis=1)
    ]  # fmt: skip
    low, high, _, number, failed = isolated(cubics(rows, spread), np.full(count, -0.2), np.full(count, 0.2))
    assert failed.mean() < 0.2
    compared = 0
    for k in np.flatnonzero(~failed):
        spans = [(low[place], high[place]) for place in np.flatnonzero(number == k)]
        c0, c1, c2, c3 = map(float, rows[k])
        for part in (-spread, 0.0, spread):
            roots = np.roots([c3 * (1 + part), c2, c1, c0])
            real = roots[np.abs(roots.imag) < 1e-9].real
            inside = real[np.abs(real) < 0.2]
            compared += inside.size
            assert len(inside) == len(spans), (k, part)
            assert all(any(one <= root <= two for one, two in spans) for root in inside)
    assert compared > 500
