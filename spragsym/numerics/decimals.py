"""Decimal texts of numbers with error bounds, which cover the rounding to decimals."""

from __future__ import annotations

import decimal
import math
from fractions import Fraction
from typing import NamedTuple

#: Significant digits of a bound.
BOUND_DIGITS = 2


class Decimal(NamedTuple):
    """A number in decimal digits, and a bound of its error, both as text."""

    text: str
    error: str

    def __str__(self) -> str:
        return f"{self.text} ± {self.error}"


def exactly(value: float | str | Fraction) -> Fraction:
    """The exact value of an int, a float, a Fraction, an mpf or a decimal text."""
    if not hasattr(value, "_mpf_"):
        return Fraction(value)
    from mpmath import libmp  # slow to import, but already imported where there is an mpf

    return Fraction(*map(int, libmp.to_rational(value._mpf_)))


def rounded_decimal(
    value: Fraction | float, error: Fraction | float, digits: int | None = None
) -> Decimal:
    """A number with the given error in decimals; the bound covers the error and the rounding.

    ``digits`` is the number of significant digits. By default the last one is that of the second
    significant digit of the error.

    Examples
    --------
    >>> from fractions import Fraction
    >>> rounded_decimal(Fraction(1, 3), Fraction(1, 10**6))
    Decimal(text='0.33333333', error='1.1e-06')
    >>> str(rounded_decimal(Fraction(2, 3), 0, digits=4))
    '0.6667 ± 3.4e-05'
    """
    middle, half = exactly(value), exactly(error)
    if digits is not None:
        places = digits - 1 - _power(middle)
    elif half:
        places = BOUND_DIGITS - _power(half)
    else:
        significant = 20  # an exact number may have very many digits
        places = significant - 1 - _power(middle)
    text = _rounded(middle, places)
    return Decimal(text, upward(abs(Fraction(text) - middle) + half))


def upward(bound: Fraction | float) -> str:
    """A bound ≥ 0 rounded up to two significant digits, in the format ``f"{bound:.1e}"``.

    >>> upward(1.6449e-14), upward(0.0), upward(float("inf")), upward(9.99)
    ('1.7e-14', '0.0e+00', 'inf', '1.0e+01')
    """
    if isinstance(bound, float) and not math.isfinite(bound):
        return f"{bound:g}"
    mantissa, power = f"{_cut(exactly(bound), decimal.ROUND_UP):.{BOUND_DIGITS - 1}e}".split("e")
    return f"{mantissa}e{int(power) if bound else 0:+03d}"


def float_above(bound: Fraction) -> float:
    """The float next to a bound that is not below it."""
    found = float(bound)
    return found if Fraction(found) >= bound else math.nextafter(found, math.inf)


def _cut(value: Fraction, rounding: str) -> decimal.Decimal:
    """A number rounded to :data:`BOUND_DIGITS` significant digits."""
    context = decimal.Context(BOUND_DIGITS, rounding, decimal.MIN_EMIN, decimal.MAX_EMAX)
    return context.divide(decimal.Decimal(value.numerator), decimal.Decimal(value.denominator))


def _power(value: Fraction) -> int:
    """Exponent n with 10ⁿ ≤ |value| < 10ⁿ⁺¹; 0 for the value 0."""
    return _cut(value, decimal.ROUND_DOWN).adjusted()


def _rounded(value: Fraction, places: int) -> str:
    """Text of a number rounded to decimal places; negative places round digits before the point."""
    scaled = round(value * Fraction(10) ** places)
    return f"{decimal.Decimal(f'{scaled}e{-places}'):f}"
