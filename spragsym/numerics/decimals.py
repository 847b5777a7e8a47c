"""Numbers in decimal digits with bounds that hold for the digits: a rounding to decimals is part of
the bound beside it.
"""

from __future__ import annotations

import decimal
import math
from fractions import Fraction
from typing import NamedTuple

#: Significant digits of a bound.
BOUND_DIGITS = 2


class Decimal(NamedTuple):
    """A number in decimal digits, and a bound on how far the number that is meant is from it: both
    as text.
    """

    text: str
    error: str

    def __str__(self) -> str:
        return f"{self.text} ± {self.error}"


def exactly(value: float | str | Fraction) -> Fraction:
    """The rational number that an int, a float, a Fraction, an mpf or a decimal text is."""
    if not hasattr(value, "_mpf_"):
        return Fraction(value)
    from mpmath import libmp  # heavy, and only who has loaded it has such numbers

    return Fraction(*map(int, libmp.to_rational(value._mpf_)))


def rounded_decimal(
    value: Fraction | float, error: Fraction | float, digits: int | None = None
) -> Decimal:
    """A number that is known to ``error``, in decimals, with a bound that covers the rounding too.

    ``digits`` are significant ones; by default as many as the error leaves: one beyond its first.

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
        # Significant digits of a number that is known exactly, where fewer than all are
        # written.
        places = 20 - 1 - _power(middle)
    text = _rounded(middle, places)
    return Decimal(text, upward(abs(Fraction(text) - middle) + half))


def upward(bound: Fraction | float) -> str:
    """A bound ≥ 0 in few decimals, as ``f"{bound:.1e}"`` writes it, but never less than it is.

    >>> upward(1.6449e-14), upward(0.0), upward(float("inf")), upward(9.99)
    ('1.7e-14', '0.0e+00', 'inf', '1.0e+01')
    """
    if isinstance(bound, float) and not math.isfinite(bound):
        return f"{bound:g}"
    mantissa, power = f"{_cut(exactly(bound), decimal.ROUND_UP):.{BOUND_DIGITS - 1}e}".split("e")
    return f"{mantissa}e{int(power) if bound else 0:+03d}"


def float_above(bound: Fraction) -> float:
    """A float that is not below."""
    found = float(bound)
    return found if Fraction(found) >= bound else math.nextafter(found, math.inf)


def _cut(value: Fraction, rounding: str) -> decimal.Decimal:
    """A number to :data:`BOUND_DIGITS` significant digits."""
    context = decimal.Context(BOUND_DIGITS, rounding, decimal.MIN_EMIN, decimal.MAX_EMAX)
    return context.divide(decimal.Decimal(value.numerator), decimal.Decimal(value.denominator))


def _power(value: Fraction) -> int:
    """n with 10ⁿ ≤ |value| < 10ⁿ⁺¹; 0 of 0."""
    return _cut(value, decimal.ROUND_DOWN).adjusted()


def _rounded(value: Fraction, places: int) -> str:
    """A number to so many decimal places; negative places leave zeros in front of the point."""
    return f"{decimal.Decimal(f'{round(value * Fraction(10) ** places)}e{-places}'):f}"
