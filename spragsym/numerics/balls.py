"""Ball arithmetic of any precision, on Python's integers: the same bits on every machine and in
every thread.

A :class:`Ball` is an interval (mid ± rad) 2^exp with three integers. It carries the precision, in
bits, to which results are rounded; every rounding error is added to ``rad``.

Why not python-flint's Arb or mpmath's intervals: they keep their precision in one variable for all
threads (``flint.ctx.prec``, ``mpmath.iv.prec``, and mpmath its cache of π in another). Setting it
changes what the user's other threads compute meanwhile, which no lock of this package can prevent.
With fifty digits a point takes 1.6 times as long as with Arb, with a thousand digits 3.4 times.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from fractions import Fraction
from functools import lru_cache
from typing import Any, TypeAlias

import mpmath

from ..core.errors import ConvergenceError
from ..core.type_variables import T
from .arithmetic import Arithmetic, Number
from .jets import Functions

#: A :class:`Ball`, or a rational number.
Interval: TypeAlias = Any

#: Bits of a radius: fewer would let it grow by rounding, more would be useless.
RADIUS_BITS = 30
#: Additional bits with which functions compute internally.
GUARD_BITS = 16

_BITS: ContextVar[int] = ContextVar("bits", default=53)


class UndecidedSign(ArithmeticError):
    """A sign that the precision does not decide."""


#: Precision of the first attempt.
FIRST_BITS = 192


class Ball(Arithmetic):
    """The interval (mid ± rad) 2^exp; results are rounded outward to ``bits`` bits."""

    __slots__ = ("bits", "exp", "mid", "rad")

    def __init__(self, mid: int, rad: int, exp: int, bits: int) -> None:
        shift = mid.bit_length() - bits
        if rad.bit_length() - RADIUS_BITS > shift:
            shift = rad.bit_length() - RADIUS_BITS
        if shift > 0:
            mid, rad, exp = mid >> shift, _rounded(rad, shift), exp + shift
        self.mid, self.rad, self.exp, self.bits = mid, rad, exp, bits

    def __add__(self, other: Any) -> Ball:
        if not isinstance(other, Ball) and (other := _as_ball(other, self.bits)) is None:
            return NotImplemented
        one, other = (self, other) if self.exp >= other.exp else (other, self)
        m = one.mid
        r = one.rad
        n = other.mid
        s = other.rad
        exp = other.exp
        gap = one.exp - other.exp
        if gap:
            if not (m or r):
                return Ball(n, s, exp, self.bits)
            if not (n or s):
                return Ball(m, r, one.exp, self.bits)
            # Bits far below the last one of the result go into the radius: otherwise a wide gap
            # would make long integers.
            drop = gap - self.bits - 2 * GUARD_BITS
            if drop > 0:
                n, s, exp, gap = n >> drop, _rounded(s, drop), exp + drop, gap - drop
            m, r = m << gap, r << gap
        return Ball(m + n, r + s, exp, self.bits)

    def __neg__(self) -> Ball:
        return Ball(-self.mid, self.rad, self.exp, self.bits)

    def __abs__(self) -> Ball:
        return Ball(abs(self.mid), self.rad, self.exp, self.bits)

    def sign(self) -> int:
        """−1 or 1; raises :class:`UndecidedSign` if the ball contains 0."""
        return decided(self, "the sign of a ball that holds 0")

    def __mul__(self, other: Any) -> Ball:
        if isinstance(other, int):
            return Ball(self.mid * other, self.rad * abs(other), self.exp, self.bits)
        if not isinstance(other, Ball) and (other := _as_ball(other, self.bits)) is None:
            return NotImplemented
        m, n, r, s = self.mid, other.mid, self.rad, other.rad
        return Ball(m * n, abs(m) * s + (abs(n) + s) * r, self.exp + other.exp, self.bits)

    def __truediv__(self, other: Any) -> Ball:
        if not isinstance(other, Ball) and (other := _as_ball(other, self.bits)) is None:
            return NotImplemented
        return _quotient(self, other)

    def __rtruediv__(self, other: Number) -> Ball:
        dividend = _as_ball(other, self.bits)
        return NotImplemented if dividend is None else _quotient(dividend, self)

    def __pow__(self, power: int) -> Ball:
        if not isinstance(power, int):
            return NotImplemented
        if power < 0:
            return 1 / self**-power
        result, square = Ball(1, 0, 0, self.bits), self
        while power:
            result = result * square if power & 1 else result
            power >>= 1
            square = square * square if power else square
        return result

    def __repr__(self) -> str:
        return f"Ball(({self.mid} ± {self.rad}) * 2**{self.exp})"


def _rounded(radius: int, shift: int) -> int:
    """Radius in units of 2^shift, rounded up, plus one unit for the midpoint, which is rounded
    down.
    """
    return 1 - (-radius >> shift)


def ball(value: float, bits: int) -> Ball:
    """The exact ball of an integer or float."""
    numerator, denominator = value.as_integer_ratio()
    return Ball(numerator, 0, 1 - denominator.bit_length(), bits)


def _as_ball(value: Number, bits: int) -> Ball | None:
    """The exact ball of an integer or float; None for other types."""
    return ball(value, bits) if isinstance(value, int | float) else None


def _quotient(one: Ball, other: Ball) -> Ball:
    """Quotient of two balls; UndecidedSign if the divisor contains 0."""
    m, n, r, s = one.mid, other.mid, one.rad, other.rad
    least = abs(n) - s
    if least <= 0:
        raise UndecidedSign("an interval that holds 0 divides")
    shift = max(0, one.bits + n.bit_length() - m.bit_length())
    quotient, rest = divmod(m << shift, n)
    rad = 1 if rest else 0
    if r or s:
        # |a/b − m/n| = |a n − m b| / |b n| ≤ (|n| r + |m| s) / (|n| (|n| − s))
        rad -= -((abs(n) * r + abs(m) * s) << shift) // (abs(n) * least)
    return Ball(quotient, rad, one.exp - other.exp - shift, one.bits)


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Context in which new balls have a precision of ``bits`` bits; separate for each thread and
    each asynchronous task.
    """
    token = _BITS.set(bits)
    try:
        yield
    finally:
        _BITS.reset(token)


def exact(value: Fraction) -> Ball:
    """A ball around a rational, which is exact for an integer over a power of two."""
    numerator, denominator, bits = value.numerator, value.denominator, _BITS.get()
    if denominator & (denominator - 1) == 0:
        return Ball(numerator, 0, 1 - denominator.bit_length(), bits)
    shift = max(0, bits + denominator.bit_length() - numerator.bit_length())
    return Ball((numerator << shift) // denominator, 1, -shift, bits)


def between(low: Fraction, high: Fraction) -> Ball:
    """A ball that contains [low, high]."""
    return union(exact(low), exact(high))


def union(one: Ball, other: Ball) -> Ball:
    """A ball that contains both."""
    exp = min(one.exp, other.exp)
    m, r = one.mid << one.exp - exp, one.rad << one.exp - exp
    n, s = other.mid << other.exp - exp, other.rad << other.exp - exp
    low, high = min(m - r, n - s), max(m + r, n + s)
    return Ball(low + high, high - low, exp - 1, one.bits)


def middle(value: Ball) -> Ball:
    """The midpoint of a ball, as an exact ball."""
    return Ball(value.mid, 0, value.exp, value.bits)


def ends(value: Ball | Fraction | int) -> tuple[Fraction, Fraction]:
    """Lower and upper end, exactly; for a rational, the number twice."""
    if not isinstance(value, Ball):
        return Fraction(value), Fraction(value)
    low, high = value.mid - value.rad, value.mid + value.rad
    if value.exp >= 0:
        return Fraction(low << value.exp), Fraction(high << value.exp)
    return Fraction(low, 1 << -value.exp), Fraction(high, 1 << -value.exp)


def sign(value: Ball | Fraction | int) -> int:
    """−1 or 1 if a ball or rational has that sign; 0 for 0, and for a ball that contains 0."""
    if isinstance(value, Ball):
        return 1 if value.mid > value.rad else -1 if value.mid < -value.rad else 0
    return (value > 0) - (value < 0)


def is_exactly_zero(value: Ball | Fraction | int) -> bool:
    """Whether a number is known to be 0: a rational 0, or a ball of radius 0 about it."""
    return value.mid == value.rad == 0 if isinstance(value, Ball) else value == 0


def cos_sin(angle: Ball) -> tuple[Ball, Ball]:
    """Cosine and sine. The radius is that of the angle, as both have Lipschitz constant 1."""
    if not angle.mid:
        return 1 + angle, angle
    wanted = angle.bits + GUARD_BITS
    places = wanted + _leading_zeros(angle)
    cosine, sine, error = _cos_sin(angle.mid, angle.exp, places)
    # Near a multiple of π/2 one of them is small: compute again with more bits, if the angle is
    # exact.
    lacking = wanted - min(cosine.bit_length(), sine.bit_length())
    if not angle.rad and lacking > GUARD_BITS // 2:
        places += lacking
        cosine, sine, error = _cos_sin(angle.mid, angle.exp, places)
    spread = error + _shifted(angle.rad, angle.exp + places)
    return Ball(cosine, spread, -places, angle.bits), Ball(sine, spread, -places, angle.bits)


def sqrt(value: Ball) -> Ball:
    """Square root; :class:`UndecidedSign` if the ball contains negative numbers."""
    if value.mid < value.rad:
        raise UndecidedSign("the square root of an interval that holds negative numbers")
    if not value.mid:
        return value
    shift = max(0, 2 * value.bits - value.mid.bit_length())
    shift += (value.exp - shift) % 2
    root = math.isqrt(value.mid << shift)
    # |√a − √m| = |a − m| / (√a + √m) ≤ |a − m| / √m
    return Ball(root, 1 - (-(value.rad << shift) // root), (value.exp - shift) // 2, value.bits)


def atan(value: Ball) -> Ball:
    """Arc tangent, which has Lipschitz constant 1; of large arguments by ±π/2 − atan(1/x)."""
    if value.mid.bit_length() + value.exp > 1 and abs(value.mid) > value.rad:
        half = _pi(value.bits) * 0.5
        return (half if value.mid > 0 else -half) - atan(1 / value)
    if not value.mid:
        return value
    places = value.bits + GUARD_BITS + _leading_zeros(value)
    result, error = _atan(_shifted_down(value.mid, value.exp + places), places)
    return Ball(result, error + _shifted(value.rad, value.exp + places), -places, value.bits)


def pi() -> Ball:
    """π."""
    return _pi(_BITS.get())


def _pi(bits: int) -> Ball:
    return Ball(_pi_fixed(bits + GUARD_BITS), 2, -(bits + GUARD_BITS), bits)


def atan2(sine: Ball, cosine: Ball) -> Ball:
    """Angle of a vector of balls in [−π, π]; :class:`UndecidedSign` if it may be on the branch
    cut.
    """
    up, right = (sign(part) for part in (sine, cosine))
    if right > 0 and (not up or _size(sine) <= _size(cosine)):
        return atan(sine / cosine)
    if not up:
        raise UndecidedSign("the angle of balls that meet the ray on which it jumps")
    half = atan(Ball(1, 0, 0, sine.bits)) * 2
    return (half if up > 0 else -half) - atan(cosine / sine)


def cos(angle: Ball) -> Ball:
    """Cosine."""
    return cos_sin(angle)[0]


def sin(angle: Ball) -> Ball:
    """Sine."""
    return cos_sin(angle)[1]


def exp(value: Ball) -> Ball:
    """Exponential: Taylor series of x / 2^halvings, then as many squarings.

    The reduced argument is at most 2^-8, so that the remainder is less than the last term.
    """
    halvings = max(0, value.mid.bit_length() + value.exp, value.rad.bit_length() + value.exp) + 8
    bits = value.bits + halvings + GUARD_BITS
    small = Ball(value.mid, value.rad, value.exp - halvings, bits)
    total, term, order = Ball(1, 0, 0, bits), Ball(1, 0, 0, bits), 0
    while _size(term) > -bits:
        order += 1
        term = term * small / order
        total = total + term
    total = total + Ball(0, 1, _size(term) + 1, bits)
    for _ in range(halvings):
        total = total * total
    return Ball(total.mid, total.rad, total.exp, value.bits)


def log(value: Ball) -> Ball:
    """Natural logarithm y + log(1 + z), with a float y ≈ log x and z = x e^−y − 1, by Taylor
    series.
    """
    if value.mid <= 2 * value.rad:
        raise UndecidedSign("the logarithm of a ball that holds 0, or nearly does")
    bits = value.bits + GUARD_BITS
    near = math.log(value.mid) + value.exp * math.log(2)
    y = ball(near, bits)
    z = Ball(value.mid, value.rad, value.exp, bits) * exp(-y) - 1
    total, power, order = z, z, 1
    # |z| < 2/3: the remainder is less than three times its first term.
    while _size(power) > -bits and order < bits:
        order += 1
        power = power * -z
        total = total + power / order
    total = total + Ball(0, 3, _size(power), bits) + y
    return Ball(total.mid, total.rad, total.exp, value.bits)


def tanh(value: Ball) -> Ball:
    """Hyperbolic tangent 1 − 2/(e^2x + 1), with additional bits near 0, where it cancels."""
    bits = value.bits + max(0, min(-_size(value), 4 * value.bits)) + GUARD_BITS
    found = 1 - 2 / (exp(Ball(value.mid, value.rad, value.exp + 1, bits)) + 1)
    return Ball(found.mid, found.rad, found.exp, value.bits)


def _taken(value: Fraction | float | Ball) -> Ball:
    return value if isinstance(value, Ball) else exact(Fraction(value))


class _BallFunctions(Functions):
    @property
    def pi(self) -> Ball:
        """π."""
        return pi()


#: ``xp`` of generated functions for balls and jets of them.
XP = _BallFunctions(sys.modules[__name__], _taken)


def with_enough_bits(digits: int, attempt: Callable[[int], T], what: str) -> T:
    """Result of ``attempt(bits)``, with twice as many bits as long as it raises UndecidedSign;
    ConvergenceError beyond 6144 bits, which names ``what`` is computed.
    """
    bits = max(FIRST_BITS, int(3.4 * digits) + 96)
    while True:
        with precision(bits):
            try:
                return attempt(bits)
            except (UndecidedSign, ZeroDivisionError) as reason:
                if bits >= 6144:
                    raise ConvergenceError(
                        f"{what}: {bits} bits do not decide it ({reason}); the parameters are "
                        "degenerate, "
                        "change one of them a little"
                    ) from None
        bits *= 2


def decided(value: Interval, what: str) -> int:
    """The sign, −1 or 1, of an interval; UndecidedSign with the text ``what`` if it contains 0."""
    return sign_or_zero(value, what, lambda: False)


def sign_or_zero(value: Interval, what: str, vanishes: Callable[[], bool]) -> int:
    """The sign of the number that an interval encloses: 0 if the interval contains 0 and
    ``vanishes()``, which must prove that the number is 0; else UndecidedSign.
    """
    result = sign(value)
    if result == 0 and not vanishes():
        raise UndecidedSign(what)
    return result


def as_floats(intervals: Iterable[Interval]) -> tuple[list[float], float]:
    """Midpoints of intervals as floats, infinite beyond float64, and a bound of |error| / max(1,
    |value|) for all; UndecidedSign if one has less than 15 digits.
    """
    middles, worst, _ = as_numbers(intervals, 15)
    # Rounding to a float adds 1.11e-16, and the rounding of the bound itself less than 1e-30.
    return list(map(float, middles)), float(worst) + 1.2e-16


def as_numbers(
    intervals: Iterable[Interval], digits: int | None
) -> tuple[list[mpmath.mpf], Fraction, Fraction]:
    """Exact midpoints of intervals, and bounds of |error| / max(1, |value|) and of |error| for all;
    UndecidedSign if the first exceeds 10^−digits.
    """
    middles, error, radius = [], Fraction(0), Fraction(0)
    for low, high in map(ends, intervals):
        middle, half = (low + high) / 2, (high - low) / 2
        # Relative to the smallest |value| in the interval.
        error, radius = max(error, half / max(Fraction(1), abs(middle) - half)), max(radius, half)
        middles.append(as_mpf(middle))
    if digits is not None and error > Fraction(1, 10**digits):
        raise UndecidedSign(f"an error of {float(error):.1e}")
    return middles, rounded_up(error), rounded_up(radius)


def as_mpf(value: Fraction) -> mpmath.mpf:
    """An integer over a power of two as an exact mpf, whatever ``mpmath.mp.prec`` is."""
    if value.denominator & (value.denominator - 1):
        raise ValueError(f"{value} has no finite number of bits")
    return mpmath.mp.make_mpf(
        mpmath.libmp.from_man_exp(value.numerator, 1 - value.denominator.bit_length())
    )


def rounded_up(bound: Fraction) -> Fraction:
    """``bound`` ≥ 0 rounded up to few bits."""
    shift = bound.denominator.bit_length() - bound.numerator.bit_length() + RADIUS_BITS
    return math.ceil(bound * Fraction(2) ** shift) * Fraction(2) ** -shift


def _leading_zeros(value: Ball) -> int:
    """Number of zeros between the binary point and the first bit of the midpoint."""
    return max(0, -value.exp - value.mid.bit_length())


def _size(value: Ball) -> int:
    """Smallest known n with |x| < 2^n for all x in the ball."""
    return (abs(value.mid) + value.rad).bit_length() + value.exp


def _shifted(radius: int, places: int) -> int:
    """radius · 2^places, rounded up."""
    return -_shifted_down(-radius, places)


def _shifted_down(value: int, places: int) -> int:
    """value · 2^places, rounded down."""
    return value << places if places >= 0 else value >> -places


# Functions of fixed-point numbers: the integer x represents x · 2^−places. Products are rounded
# down, with an error below one unit.


def _cos_sin(mid: int, exp: int, places: int) -> tuple[int, int, int]:
    """Cosine and sine of mid · 2^exp, and a bound of their errors, in units of 2^−places.

    Taylor series of the angle / 2^halvings, then as many squarings of cos + i sin. Each doubles the
    error and adds less than two units.
    """
    halvings = max(0, mid.bit_length() + exp + math.isqrt(places) // 2)
    inner = places + halvings + GUARD_BITS
    x = _shifted_down(mid, exp - halvings + inner)
    square = x * x >> inner
    sine, term, order = x, x, 1
    while abs(term) > 1:
        order += 2
        term = -(term * square >> inner) // (order * (order - 1))
        sine += term
    cosine = math.isqrt((1 << 2 * inner) - sine * sine)
    for _ in range(halvings):
        cosine, sine = (cosine * cosine - sine * sine) >> inner, 2 * cosine * sine >> inner
    # Each of the order/2 terms has an error below three units, as have x and the remainder; the
    # error of the cosine is no larger.
    error = (5 * order // 2 + 16) << halvings
    down = inner - places
    return cosine >> down, sine >> down, _rounded(error, down)


def _atan(x: int, places: int) -> tuple[int, int]:
    """Arc tangent of x, which may have an error of one unit, and a bound of the result's error.

    Several reductions atan x = 2 atan(x / (1 + √(1 + x²))), then the Taylor series. Each reduction
    halves the error and adds less than three units.
    """
    halvings = 2 + math.isqrt(places) // 3
    inner = places + halvings + GUARD_BITS
    one, x = 1 << inner, x << inner - places
    halvings = max(0, halvings - max(0, inner - x.bit_length()))
    for _ in range(halvings):
        x = (x << inner) // (one + math.isqrt((one << inner) + x * x))
    square = x * x >> inner
    power, result, order = x, x, 1
    while abs(power) > 1:
        power = -(power * square >> inner)
        order += 2
        result += power // order
    # Each of the order/2 terms has an error below two units; that of x, 2^−places, is not
    # amplified.
    error = ((order + 16) << halvings) + (1 << inner - places)
    down = inner - places
    return (result << halvings) >> down, _rounded(error, down)


@lru_cache(maxsize=64)
def _pi_fixed(places: int) -> int:
    """π · 2^places, with an error below two units."""
    inner = places + 2 * GUARD_BITS
    return 4 * _atan(1 << inner, inner)[0] >> 2 * GUARD_BITS
