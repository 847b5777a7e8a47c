"""Adaptive precision: bits are added until every sign that an answer needs is certified; an interval as a float or an angle."""

from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import TypeVar

import mpmath

from ..errors import ConvergenceError
from . import balls
from .balls import Interval, Undecided, as_mpf, rounded_up, sign

#: Bits of the first try and of the last.
FIRST_BITS, MAXIMUM_BITS = 192, 6144
#: Digits that an interval must have to become a float.
FLOAT_DIGITS = 15

T = TypeVar("T")


def with_enough_bits(digits: int, attempt: Callable[[int], T], what: str) -> T:
    """Run ``attempt(bits)`` with more and more bits until every sign that it needs is decided."""
    bits = max(FIRST_BITS, int(3.4 * digits) + 96)
    while True:
        with balls.precision(bits):
            try:
                return attempt(bits)
            except (Undecided, ZeroDivisionError) as reason:
                if bits >= MAXIMUM_BITS:
                    raise ConvergenceError(
                        f"{what}: {bits} bits do not decide it ({reason}); the parameters are degenerate, "
                        "change one of them a little"
                    ) from None
        bits *= 2


def decided(value: Interval, what: str) -> int:
    """The sign of an interval that must have one."""
    result = sign(value)
    if result == 0:
        raise Undecided(what)
    return result


def sign_or_zero(value: Interval, what: str, vanishes: Callable[[], bool]) -> int:
    """The sign of an interval; 0 only where it holds 0 and ``vanishes()`` says that the number in it is exactly 0."""
    result = sign(value)
    if result == 0 and not vanishes():
        raise Undecided(what)
    return result


def as_floats(intervals: Iterable[Interval]) -> tuple[list[float], float]:
    """The middles of intervals as floats, infinite beyond float64, and a bound on |error| / max(1, |value|) of all of them."""
    middles, worst, _ = as_numbers(intervals, FLOAT_DIGITS)
    # Half a unit in the last place of a float, 1.11e-16, and what is lost where the first term is rounded and in the sum, 1e-30.
    return list(map(float, middles)), float(worst) + 1.2e-16


def as_numbers(
    intervals: Iterable[Interval], digits: int | None
) -> tuple[list[mpmath.mpf], Fraction, Fraction]:  # fmt: skip
    """The middles of intervals with every bit that they have, and bounds on |error| / max(1, |value|) and |error| of all."""
    middles, error, radius = [], Fraction(0), Fraction(0)
    for low, high in map(balls.ends, intervals):
        middle, half = (low + high) / 2, (high - low) / 2
        # Over the smallest that the value may be, so that it is a bound over the true one as well.
        error, radius = max(error, half / max(Fraction(1), abs(middle) - half)), max(radius, half)
        middles.append(as_mpf(middle))
    if digits is not None and error > Fraction(1, 10**digits):
        raise Undecided(f"an error of {float(error):.1e}")
    return middles, rounded_up(error), rounded_up(radius)
