"""Interval arithmetic of any precision, on Python's integers: the same bits on every machine, in
every thread.

A :class:`Ball` is an interval (mid ± rad) 2^exp of three integers. It carries the number of bits
that results of it are rounded to, and every rounding goes into ``rad``. Integers are exact, so
nothing here depends on a precision that is kept elsewhere.

python-flint's Arb and mpmath's intervals keep theirs in one variable for all threads
(``flint.ctx.prec``, ``mpmath.iv.prec``, and mpmath's memory of π in another): to set it changes
what the user's other threads compute meanwhile, which no lock of this package can prevent. At fifty
digits most of the time is Python's own, and a point costs 1.6 times what it would with Arb, at a
thousand digits 3.4 times. All precisions are in bits.
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

#: A :class:`Ball`, or what is made of balls and numbers beside them.
Interval: TypeAlias = Any

#: Bits of a radius: more would be of no use, and fewer would make it grow by rounding.
RADIUS_BITS = 30
#: Bits beyond those asked for, which absorb the roundings inside of a function.
GUARD_BITS = 16

_BITS: ContextVar[int] = ContextVar("bits", default=53)


class UndecidedSign(ArithmeticError):
    """A sign that the precision can't decide."""


#: Bits of the first try.
FIRST_BITS = 192


class Ball(Arithmetic):
    """All numbers (mid ± rad) 2^exp; results of it are rounded to ``bits`` bits, outward."""

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
            # What lies far below the last bit of the result goes into the radius, lest a wide gap
            # cost its number of bits.
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
        """−1 or 1; :class:`UndecidedSign` where the ball holds 0."""
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
    """The radius in units of 2^shift around a middle that is rounded down to them: rounded up, and
    a unit for the middle.
    """
    return 1 - (-radius >> shift)


def ball(value: float, bits: int) -> Ball:
    """An integer or float, exactly."""
    numerator, denominator = value.as_integer_ratio()
    return Ball(numerator, 0, 1 - denominator.bit_length(), bits)


def _as_ball(value: Number, bits: int) -> Ball | None:
    """A number that is exactly an integer over a power of two."""
    return ball(value, bits) if isinstance(value, int | float) else None


def _quotient(one: Ball, other: Ball) -> Ball:
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
    """Numbers made inside carry ``bits`` bits; each thread and each asynchronous task has its
    own.
    """
    token = _BITS.set(bits)
    try:
        yield
    finally:
        _BITS.reset(token)


def exact(value: Fraction) -> Ball:
    """A small interval around a rational: the number itself where its digits fit."""
    numerator, denominator, bits = value.numerator, value.denominator, _BITS.get()
    if denominator & (denominator - 1) == 0:
        return Ball(numerator, 0, 1 - denominator.bit_length(), bits)
    shift = max(0, bits + denominator.bit_length() - numerator.bit_length())
    return Ball((numerator << shift) // denominator, 1, -shift, bits)


def between(low: Fraction, high: Fraction) -> Ball:
    """An interval that holds [low, high]."""
    return union(exact(low), exact(high))


def union(one: Ball, other: Ball) -> Ball:
    """An interval that holds both."""
    exp = min(one.exp, other.exp)
    m, r = one.mid << one.exp - exp, one.rad << one.exp - exp
    n, s = other.mid << other.exp - exp, other.rad << other.exp - exp
    low, high = min(m - r, n - s), max(m + r, n + s)
    return Ball(low + high, high - low, exp - 1, one.bits)


def middle(value: Ball) -> Ball:
    """Midpoint of a ball, as an interval without width."""
    return Ball(value.mid, 0, value.exp, value.bits)


def ends(value: Ball | Fraction | int) -> tuple[Fraction, Fraction]:
    """Lower and upper end, exactly; of a rational that itself."""
    if not isinstance(value, Ball):
        return Fraction(value), Fraction(value)
    low, high = value.mid - value.rad, value.mid + value.rad
    if value.exp >= 0:
        return Fraction(low << value.exp), Fraction(high << value.exp)
    return Fraction(low, 1 << -value.exp), Fraction(high, 1 << -value.exp)


def sign(value: Ball | Fraction | int) -> int:
    """−1 or 1 where a ball or rational has that sign; 0 for 0, and where a ball holds 0."""
    if isinstance(value, Ball):
        return 1 if value.mid > value.rad else -1 if value.mid < -value.rad else 0
    return (value > 0) - (value < 0)


def cos_sin(angle: Ball) -> tuple[Ball, Ball]:
    """Cosine and sine: each changes by no more than the angle does."""
    if not angle.mid:
        return 1 + angle, angle
    wanted = angle.bits + GUARD_BITS
    places = wanted + _leading_zeros(angle)
    cosine, sine, error = _cos_sin(angle.mid, angle.exp, places)
    # Near a multiple of π/2 one of them is small: again, with the bits that it lacks, if the angle
    # is known so well.
    lacking = wanted - min(cosine.bit_length(), sine.bit_length())
    if not angle.rad and lacking > GUARD_BITS // 2:
        places += lacking
        cosine, sine, error = _cos_sin(angle.mid, angle.exp, places)
    spread = error + _shifted(angle.rad, angle.exp + places)
    return Ball(cosine, spread, -places, angle.bits), Ball(sine, spread, -places, angle.bits)


def sqrt(value: Ball) -> Ball:
    """Square root; :class:`UndecidedSign` where the interval holds negative numbers."""
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
    """Arc tangent, which changes by no more than its argument does; of a large one through its
    reciprocal.
    """
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
    """Angle of a vector of balls, from −π to π; :class:`UndecidedSign` where they meet the ray on
    which it jumps.
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
    """Exponential: Taylor's series of the argument over 2^halvings, squared as often.

    The argument is cut to at most 2^-8, so that what is dropped after a term is less than that
    term.
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
    """Natural logarithm: y + log(1 + z) for a float y near it and z = x e^−y − 1, by Taylor's
    series.
    """
    if value.mid <= 2 * value.rad:
        raise UndecidedSign("the logarithm of a ball that holds 0, or nearly does")
    bits = value.bits + GUARD_BITS
    near = math.log(value.mid) + value.exp * math.log(2)
    y = ball(near, bits)
    z = Ball(value.mid, value.rad, value.exp, bits) * exp(-y) - 1
    total, power, order = z, z, 1
    # z is below 2/3: all that is left out together is less than three times its first term.
    while _size(power) > -bits and order < bits:
        order += 1
        power = power * -z
        total = total + power / order
    total = total + Ball(0, 3, _size(power), bits) + y
    return Ball(total.mid, total.rad, total.exp, value.bits)


def tanh(value: Ball) -> Ball:
    """Hyperbolic tangent, 1 − 2/(e^2x + 1), with the bits that it lacks near 0."""
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
    """Run ``attempt(bits)`` with more and more bits until every sign that it needs is decided."""
    bits = max(FIRST_BITS, int(3.4 * digits) + 96)
    while True:
        with precision(bits):
            try:
                return attempt(bits)
            except (UndecidedSign, ZeroDivisionError) as reason:
                # Bits of the last try.
                if bits >= 6144:
                    raise ConvergenceError(
                        f"{what}: {bits} bits do not decide it ({reason}); the parameters are "
                        "degenerate, "
                        "change one of them a little"
                    ) from None
        bits *= 2


def decided(value: Interval, what: str) -> int:
    """The sign of an interval that must have one."""
    return sign_or_zero(value, what, lambda: False)


def sign_or_zero(value: Interval, what: str, vanishes: Callable[[], bool]) -> int:
    """The sign of an interval; 0 only where it holds 0 and ``vanishes()`` says that the number in
    it is exactly 0.
    """
    result = sign(value)
    if result == 0 and not vanishes():
        raise UndecidedSign(what)
    return result


def as_floats(intervals: Iterable[Interval]) -> tuple[list[float], float]:
    """The middles of intervals as floats, infinite beyond float64, and a bound on |error| / max(1,
    |value|) of all of them.
    """
    # Digits that an interval must have to become a float.
    middles, worst, _ = as_numbers(intervals, 15)
    # Half a unit in the last place of a float, 1.11e-16, and what is lost where the first term is
    # rounded and in the sum, 1e-30.
    return list(map(float, middles)), float(worst) + 1.2e-16


def as_numbers(
    intervals: Iterable[Interval], digits: int | None
) -> tuple[list[mpmath.mpf], Fraction, Fraction]:
    """The middles of intervals with every bit that they have, and bounds on |error| / max(1,
    |value|) and |error| of all.
    """
    middles, error, radius = [], Fraction(0), Fraction(0)
    for low, high in map(ends, intervals):
        middle, half = (low + high) / 2, (high - low) / 2
        # Over the smallest that the value may be, so that it is a bound over the true one as well.
        error, radius = max(error, half / max(Fraction(1), abs(middle) - half)), max(radius, half)
        middles.append(as_mpf(middle))
    if digits is not None and error > Fraction(1, 10**digits):
        raise UndecidedSign(f"an error of {float(error):.1e}")
    return middles, rounded_up(error), rounded_up(radius)


def as_mpf(value: Fraction) -> mpmath.mpf:
    """An integer over a power of two as an mpf, every bit of it, whatever ``mpmath.mp.prec`` is."""
    if value.denominator & (value.denominator - 1):
        raise ValueError(f"{value} has no finite number of bits")
    return mpmath.mp.make_mpf(
        mpmath.libmp.from_man_exp(value.numerator, 1 - value.denominator.bit_length())
    )


def rounded_up(bound: Fraction) -> Fraction:
    """A number of few bits that is not below ``bound`` ≥ 0."""
    shift = bound.denominator.bit_length() - bound.numerator.bit_length() + RADIUS_BITS
    return math.ceil(bound * Fraction(2) ** shift) * Fraction(2) ** -shift


def _leading_zeros(value: Ball) -> int:
    """Number of binary places after the point before the first digit of the middle."""
    return max(0, -value.exp - value.mid.bit_length())


def _size(value: Ball) -> int:
    """n with |x| < 2^n all over the ball."""
    return (abs(value.mid) + value.rad).bit_length() + value.exp


def _shifted(radius: int, places: int) -> int:
    """At least radius · 2^places."""
    return -_shifted_down(-radius, places)


def _shifted_down(value: int, places: int) -> int:
    """value · 2^places, rounded down."""
    return value << places if places >= 0 else value >> -places


# ----------------------------------------------------------------------------- functions of
# fixed-point numbers
#
# x stands for x 2^−places. Products are rounded down, so that each is off by less than one unit.


def _cos_sin(mid: int, exp: int, places: int) -> tuple[int, int, int]:
    """Cosine and sine of mid · 2^exp, and a bound on the error of both, in units of 2^−places.

    Taylor's series of the angle over 2^halvings, then the square of cos + i sin as often: each
    doubles an error, and adds less than two units to it.
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
    # Each of order/2 terms is off by less than three units, as are x and the rest of the series,
    # and the cosine by no more.
    error = (5 * order // 2 + 16) << halvings
    down = inner - places
    return cosine >> down, sine >> down, _rounded(error, down)


def _atan(x: int, places: int) -> tuple[int, int]:
    """Arc tangent of x, itself off by less than one unit, and a bound on its error.

    atan x = 2 atan(x / (1 + √(1 + x²))), as often as pays, then Taylor's series. Each reduction
    halves an error, and adds less than three units to it.
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
    # Each of order/2 terms is off by less than two units; x's own unit, of 2^−places, is as large
    # in the arc tangent.
    error = ((order + 16) << halvings) + (1 << inner - places)
    down = inner - places
    return (result << halvings) >> down, _rounded(error, down)


@lru_cache(maxsize=64)
def _pi_fixed(places: int) -> int:
    """π to less than two units."""
    inner = places + 2 * GUARD_BITS
    return 4 * _atan(1 << inner, inner)[0] >> 2 * GUARD_BITS
