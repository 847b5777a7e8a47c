"""Roots near singular Jacobians, many boxes at once: cubics whose roots are known."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt
from typing import Any

import numpy as np
import pytest

from spragsym.exact import many_reductions, reduction
from spragsym.exact.interval_arrays import Intervals
from spragsym.exact.intervals import Balls
from spragsym.exact.jets import constant, gradient, variables
from spragsym.exact.wide_balls import WideBalls

#: Distances of three roots from each other.
GAPS = np.array([1e-3, 1e-5, 1e-7])


def system(gaps):
    """x³ − gap² x = y and y = x²/1024: the roots of x³ − x²/1024 − gap² x."""

    def evaluate(rows, q):
        x, y = q
        gap = exact(gaps[rows], x)
        return [x**3 - x * (gap * gap) - y, y - x**2 * 2.0**-10]

    return System(evaluate)


@dataclass(frozen=True)
class System:
    """Equations, and their slopes by jets."""

    values: Callable[[np.ndarray, Sequence[Any]], Sequence[Any]]

    def slopes(self, rows, q):
        return [gradient(row, len(q)) for row in self.values(rows, variables(q, 1))]


def exact(values, like):
    """Floats in the numbers of a computation."""
    return WideBalls.exact(values) if isinstance(constant(like), WideBalls) else Intervals.point(values)


def roots_of(gap):
    """In Python's rationals, to 1e-20 and better."""
    g, c = Fraction(float(gap)), Fraction(1, 1024)
    disc = c * c + 4 * g * g
    root = Fraction(isqrt(int(disc * 10**80)), 10**40)
    return sorted([(c - root) / 2, Fraction(0), (c + root) / 2])


def boxes_and_slopes(count):
    boxes = np.repeat(np.array([[0.011, 0.0001], [0.0107, 0.00012]])[:, :, None], count, axis=2)
    return boxes, np.repeat(np.array([[0.0, -1.0], [0.0, 1.0]])[:, :, None], count, axis=2)


def test_three_roots_close_together_are_told_apart():
    boxes, slopes = boxes_and_slopes(GAPS.size)
    found = many_reductions.reduced_roots(system(GAPS), boxes, slopes)
    assert not found.open.any()
    for number, gap in enumerate(GAPS):
        mine = np.flatnonzero(found.box == number)
        ends = found.ends[:, 0, mine]
        order = np.argsort(ends[1])
        want = roots_of(gap)
        assert len(order) == 3
        for row, exact in zip(order, want, strict=True):
            assert Fraction(-float(ends[0, row])) <= exact <= Fraction(float(ends[1, row]))
            assert ends[0, row] + ends[1, row] < 1e-15


def test_a_double_root_stays_open():
    boxes, slopes = boxes_and_slopes(1)

    def evaluate(rows, q):
        x, y = q
        return [x**2 - y, y + 0]

    found = many_reductions.reduced_roots(System(evaluate), boxes, slopes)
    assert found.open.all()


def test_what_is_no_function_of_one_unknown_stays_open():
    """The circle about 0 and the lines y = ±x/2: over the whole of them neither unknown is a function of the other."""
    circle = System(lambda rows, q: [q[0] ** 2 + q[1] ** 2 - 1, q[1] ** 2 * 4 - q[0] ** 2])
    slopes = np.array([[[1e-9], [0.0]], [[0.0], [1.0]]])
    for levels in (1, 6):
        found = many_reductions.reduced_roots(circle, np.full((2, 2, 1), 2.0), slopes, levels)
        assert found.open.all()


def test_no_root_is_no_root():
    boxes, slopes = boxes_and_slopes(2)

    def evaluate(rows, q):
        x, y = q
        return [x**2 - y + exact(np.array([1e-20, 1e-10])[rows], x), y + 0]

    found = many_reductions.reduced_roots(System(evaluate), boxes, slopes)
    assert not found.open.any()
    assert found.box.size == 0


@pytest.mark.parametrize("gap", GAPS)
def test_many_digits_find_the_same(gap):
    boxes, slopes = boxes_and_slopes(1)
    found = many_reductions.reduced_roots(system(np.array([gap])), boxes, slopes)

    def evaluate(q):
        x, y = q
        g = Balls().exact(Fraction(float(gap)))
        return [x**3 - x * (g * g) - y, y - x**2 * Balls().exact(Fraction(1, 1024))]

    with Balls().precision(200):
        known = reduction.reduced_roots(evaluate, [(-0.011, 0.0107), (-0.0001, 0.00012)], slopes[:, :, 0], 200)
    assert len(known.roots) == found.box.size == 3
