"""Functions of laws in every number type that evaluates a model, against mpmath with more digits
than any of them has.
"""

import itertools
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest

from spragsym.numerics import balls
from spragsym.numerics.balls import XP as BALLS
from spragsym.numerics.balls import Ball
from spragsym.numerics.interval_arrays import Intervals
from spragsym.numerics.jets import Jet
from spragsym.statics.namespaces import XP as BOXES

#: Each function, and arguments: about 0 and far from it, and where it is 1 or 0.
ARGUMENTS = {
    "exp": (0.0, 1e-300, -1e-9, 0.3, -0.7, 5.0, -40.0, 60.0),
    "log": (1.0, 1.0 + 1e-9, 1e-30, 0.3, 0.9999, 2.0, 1e20),
    "tanh": (0.0, 1e-300, 1e-9, -1e-4, 0.3, -1.0, 17.0, -45.0, 300.0),
    "atan": (0.0, 1e-200, 1e-9, -1e-4, 0.3, -1.0, 17.0, -1e12),
    "cos": (0.0, 1e-9, 0.3, -1.5707963267948966, 3.0, -3.2, 17.0, 1000.0),
    "sin": (0.0, 1e-9, 0.3, -1.5707963267948966, 3.0, -3.2, 17.0, 1000.0),
    "sqrt": (5e-324, 1e-310, 2.0**-1022, 1e-30, 0.3, 2.0, 1e20),
}


@pytest.fixture(autouse=True)
def digits() -> Iterator[None]:
    with mpmath.workdps(130), balls.precision(160):
        yield


def true(name: str, x: Any) -> mpmath.mpf:
    return getattr(mpmath, name)(mpmath.mpf(x))


def ends(value: Any) -> tuple[mpmath.mpf, mpmath.mpf]:
    """Of the one number that it is."""
    if isinstance(value, Ball):
        # two
        return tuple(mpmath.mpf(end.numerator) / end.denominator for end in balls.ends(value))  # type: ignore[return-value]
    return mpmath.mpf(float(value.low[0])), mpmath.mpf(float(value.high[0]))


#: How a float becomes a number of each type, its functions, and the width allowed, relative to what
#: is larger, the value or 1.
TYPES: dict[str, tuple[Callable[[float], Any], Any, float]] = {
    "intervals": (lambda x: Intervals.point([x]), BOXES, 2e-14),
    "balls": (lambda x: balls.exact(Fraction(x)), BALLS, 2.0**-150),
}


@pytest.mark.parametrize("kind", TYPES)
def test_a_function_holds_its_value_and_little_else(kind: str) -> None:
    made, functions, width = TYPES[kind]
    for name, x in ((name, x) for name, places in ARGUMENTS.items() for x in places):
        with np.errstate(all="ignore"):
            low, high = ends(getattr(functions, name)(made(x)))
        value = true(name, x)
        assert low <= value <= high, (name, x)
        # What is halved for a series and then squared, or less whole turns, loses the digits of its
        # size.
        assert high - low <= width * max(abs(value), 1) * max(
            abs(x), abs(value) if name == "log" else 1, 1
        ), (name, x)
    low, high = ends((abs(Jet.variable(made(-0.3), 0, 2)) * made(1.0)).derivative(0))
    assert low <= -1 <= high < 0


@pytest.mark.parametrize("kind", TYPES)
@pytest.mark.parametrize("name", ARGUMENTS)
def test_derivatives_of_a_function(kind: str, name: str) -> None:
    made, functions, width = TYPES[kind]
    places = [x or 0.25 for x in ARGUMENTS[name] if not 0 < abs(x) < 1e-100 and abs(x) < 50]
    for x, order in itertools.product(places, (1, 2, 3)):
        with np.errstate(all="ignore"):
            jet = getattr(functions, name)(Jet.variable(made(x), 0, 3))
        low, high = ends(jet.derivative(*(0,) * order))
        value = mpmath.diff(
            getattr(mpmath, name),
            mpmath.mpf(x),
            order,
            h=mpmath.mpf(abs(x)) * mpmath.mpf(10) ** -25,
        )
        close = (
            mpmath.mpf(10) ** -40 * max(1, abs(value))
            if abs(x) > 1e-3
            else mpmath.mpf(10) ** -20 * max(1, abs(value))
        )
        assert low - close <= value <= high + close, (x, order)
        assert high - low <= 1e3 * width * max(abs(value), 1) + close, (x, order)


@pytest.mark.parametrize("name", ARGUMENTS)
def test_balls_of_arguments_hold_all_values(name: str) -> None:
    for x, r in ((0.5, 1e-3), (0.3, 1e-12), (2.0, 1e-20), (1.0, 2.0**-60), (3.0, 1e-5)):
        ball = balls.between(Fraction(x) - Fraction(r), Fraction(x) + Fraction(r))
        low, high = ends(getattr(BALLS, name)(ball))
        size = max(abs(true(name, x)), 1)
        for share in (-1, -0.3, 0.5, 1):
            assert low <= true(name, mpmath.mpf(x) + share * mpmath.mpf(r)) <= high
        assert high - low <= 60 * r * size + 2.0**-150 * size


def test_numbers_without_width_are_as_right_as_others() -> None:
    """A number of the page, as the 2 of sqrt(2), is no exact float after its root."""
    for functions in (BOXES, BALLS):
        low, high = ends(functions.sqrt(2))
        assert low < mpmath.sqrt(2) < high
        low, high = ends(functions.pi)
        assert low < mpmath.pi < high


def test_a_root_by_exponential_and_logarithm_begins_at_zero() -> None:
    with np.errstate(all="ignore"):
        found = BOXES.exp(BOXES.log(Intervals.between([0.0, 0.0, -1e-18], [0.0, 8.0, 1e-3])) / 3)
    assert (found.low == 0).all()
    assert found.high[0] < 1e-300
    assert found.high[1] == pytest.approx(2.0, rel=1e-14)
    assert found.high[2] == pytest.approx(0.1, rel=1e-13)
