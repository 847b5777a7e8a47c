"""Decimals with bounds: whatever is written encloses what was given, in rational arithmetic."""

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest

from spragsym import precise
from spragsym.numerics.decimals import exactly, float_above, rounded_decimal, upward


@pytest.mark.parametrize("digits", [None, 1, 2, 10, 25, 60, 200])
def test_decimals_enclose_an_interval(digits: int | None) -> None:
    rng = np.random.default_rng(3)
    for _ in range(300):
        middle = Fraction(
            int(rng.integers(-(10**9), 10**9)), int(rng.integers(1, 10**9))
        ) * Fraction(10) ** int(rng.integers(-30, 30))
        half = Fraction(int(rng.integers(0, 10**6)), int(rng.integers(1, 10**6))) * Fraction(
            10
        ) ** int(rng.integers(-250, 5))
        text, error = rounded_decimal(middle, half, digits)
        assert abs(Fraction(text) - middle) + half <= Fraction(error)
        if digits is not None and middle:
            rounding = abs(middle) * Fraction(10) ** (1 - digits)
            assert Fraction(error) <= Fraction(12, 10) * (half + rounding)
        elif half:
            assert Fraction(error) <= Fraction(12, 10) * half


def test_bounds_are_rounded_up() -> None:
    rng = np.random.default_rng(4)
    for value in (
        *rng.uniform(0, 1, 200),
        *np.exp(rng.uniform(-700, 700, 200)),
        9.95,
        9.9999,
        0.0,
        5e-324,
    ):
        assert Fraction(upward(float(value))) >= Fraction(float(value))
        assert float(upward(float(value))) <= 1.1001 * value or value < 1e-320
    assert upward(math.inf) == "inf"
    assert upward(math.nan) == "nan"
    assert all(Fraction(float_above(Fraction(1, n))) >= Fraction(1, n) for n in range(1, 300))


@pytest.mark.parametrize("dps", [10, 25, 60, 200])
def test_what_precise_prints_is_within_what_it_proves(dps: int) -> None:
    """Against 60 digits more; the default of digits, and few of them."""
    (found,), (truth,) = (
        precise.equilibria(theta0_deg="49", dps=digits) for digits in (dps, dps + 60)
    )
    cusps, exact = (precise.cusps(dps=digits) for digits in (dps, dps + 60))
    for one, true in ((found, truth), *zip(cusps, exact, strict=True)):
        for digits in (None, 1, 7, dps, dps + 5):
            for name, (text, error) in one.decimals(digits).items():
                value = getattr(true, name)
                assert abs(Fraction(text) - exactly(value)) <= Fraction(error) + Fraction(
                    1, 10 ** (dps + 55)
                ), name
        assert all(str(decimal) in repr(one) for decimal in one.decimals().values())
    text, error = rounded_decimal(mpmath.mpf("1.5"), 0, 1)
    assert abs(Fraction(text) - Fraction(3, 2)) <= Fraction(error)
