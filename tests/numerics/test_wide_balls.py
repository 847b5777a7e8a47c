"""Balls with double-double middles against mpmath."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

from spragsym.exact.interval_arrays import Intervals
from spragsym.exact.wide_balls import WideBalls, cosine_and_sine

NUMBERS = np.random.default_rng(5).uniform(0.01, 3.0, (2, 300))


def holds(ball: WideBalls, exact: list[mp.mpf], digits: float) -> None:
    """Every ball holds its number, and is as narrow as digits say."""
    for high, low, radius, value in zip(ball.middle.high, ball.middle.low, ball.radius, exact, strict=True):
        assert abs(mp.mpf(float(high)) + mp.mpf(float(low)) - value) <= mp.mpf(float(radius))
        assert radius <= digits * max(1, abs(value))


@pytest.mark.parametrize(
    ("operation", "digits"),
    [
        (lambda a, b: a + b, 1e-30),
        (lambda a, b: a - b, 1e-30),
        (lambda a, b: a * b, 1e-30),
        (lambda a, b: a / b, 1e-28),
        (lambda a, b: 1 / (a + 2) - 3 * b, 1e-29),
        (lambda a, b: a**3 - b**-2, 1e-24),
    ],
)
def test_arithmetic(operation, digits):
    a, b = NUMBERS
    with mp.workdps(60):
        holds(
            operation(WideBalls.exact(a), WideBalls.exact(b)),
            [operation(*map(mp.mpf, pair)) for pair in NUMBERS.T.tolist()],
            digits,
        )


@pytest.mark.parametrize(("name", "digits"), [("sqrt", 1e-29), ("exp", 1e-26)])
def test_functions(name, digits):
    third = [mp.mpf(float(a)) for a in NUMBERS[0]]
    with mp.workdps(60):
        holds(getattr(WideBalls.exact(NUMBERS[0]) / 3, name)(), [getattr(mp, name)(value / 3) for value in third], digits)
        holds(-(WideBalls.exact(NUMBERS[0]).exp() - 1).sign(), [mp.mpf(-1)] * len(third), 1e-30)


def test_cosine_and_sine():
    with mp.workdps(60):
        for ball, function in zip(cosine_and_sine(NUMBERS[0]), (mp.cos, mp.sin), strict=True):
            holds(ball, [function(mp.mpf(float(value))) for value in NUMBERS[0]], 1e-29)
    assert np.isnan(cosine_and_sine(np.array([0.0, 4.0]))[0].radius).all()


def test_to_intervals_and_back():
    ball = WideBalls.exact(NUMBERS[0]) / 3
    box = ball.intervals()
    assert (box.low <= ball.middle.high).all()
    assert (box.high >= ball.middle.high).all()
    assert box.width.max() < 1e-15
    back = WideBalls.around(Intervals.between(np.array([1.0]), np.array([2.0])))
    assert back.middle.high[0] == 1.5
    assert back.radius[0] >= 0.5


def test_what_is_not_known_is_nan():
    wide = WideBalls.around(Intervals.between(np.array([-1.0]), np.array([2.0])))
    assert np.isnan((1 / wide).radius).all()
    assert np.isnan(wide.sqrt().radius).all()
    assert np.isnan(wide.sign().middle.high).all()
