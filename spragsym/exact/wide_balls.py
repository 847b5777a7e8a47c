"""Arrays of balls with double-double middles: about 31 digits at some ten times the cost of floats, thousands at a time.

A number is a middle, the exact sum of two floats, and a radius. Every operation widens the radius by a bound on its own rounding,
as :mod:`spragsym.generated.double_double` states it. NaN is a ball of which nothing is known.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import double_double
from .double_double import DoubleDouble, chosen_of
from .interval_arrays import FloatArray, Intervals, exactly, raised
from .jets import Jet, JetFunctions
from .number_types import repeated_product

#: Unit of relative errors of double-double operations.
UNIT = 2.0**-106
#: Errors in units: of a sum, a product, a quotient, with room for terms of second order.
SUM, PRODUCT, QUOTIENT = 4.0, 8.0, 16.0
#: More than what underflow takes away.
TINY = 1e-290
#: What sums and products of a few floats may have lost by rounding, relatively.
ROOM = 1 + 2.0**-48
#: Absolute error of cosine and sine.
TURN = 2.0**-100
#: Sine of the width up to which a vector of balls has an angle.
MOST_OFF = 2.0**-6
#: Terms of the logarithm's series; those of cosine and sine, up to that power.
LOGARITHM, SINE = 6, 6
#: Beyond it the hyperbolic tangent is 1 in all digits.
FLAT = 60.0
#: Halvings of the argument of an exponential, and terms of its series then.
HALVINGS, TERMS = 10, 14


class WideBalls:
    """Balls of any shape.

    Examples
    --------
    >>> third = WideBalls.exact(np.array([1.0])) / 3
    >>> bool((third * 3 - 1).radius[0] < 1e-30)
    True
    """

    __slots__ = ("middle", "radius")
    __array_ufunc__ = None

    def __init__(self, middle: DoubleDouble, radius: FloatArray) -> None:
        self.middle, self.radius = middle, radius

    @classmethod
    def exact(cls, values: FloatArray) -> WideBalls:
        """Floats, without width."""
        return cls(DoubleDouble(values, np.zeros_like(values)), np.zeros_like(values))

    @classmethod
    def around(cls, intervals: Intervals) -> WideBalls:
        """Balls that hold intervals."""
        middle = intervals.middle
        radius = raised(np.maximum(*raised(intervals.ends + np.stack([middle, -middle]))))
        return cls(DoubleDouble(middle, np.zeros_like(middle)), radius)

    def intervals(self) -> Intervals:
        """Intervals that hold the balls."""
        off = raised(self.radius + np.abs(self.middle.low))
        return Intervals(raised(np.stack([off - self.middle.high, off + self.middle.high])))

    @classmethod
    def where(cls, chosen: NDArray[np.bool_], one: WideBalls, other: WideBalls) -> WideBalls:
        """Balls of the one where the flag is set, of the other elsewhere."""
        return cls(chosen_of(chosen, one.middle, other.middle), np.where(chosen, one.radius, other.radius))

    def taken(self, rows: NDArray[Any]) -> WideBalls:
        """Some of the balls."""
        return WideBalls(self.middle[rows], self.radius[rows])

    def signs(self) -> NDArray[np.int64]:
        """−1 or 1, and 0 where a ball holds 0 or nothing is known."""
        known = np.abs(self.middle.high) > ROOM * self.radius
        return np.where(known, np.sign(self.middle.high), 0.0).astype(np.int64)

    @property
    def size(self) -> FloatArray:
        """Not less than |x|."""
        out: FloatArray = (np.abs(self.middle.high) * ROOM + self.radius) * ROOM
        return out

    def __neg__(self) -> WideBalls:
        return WideBalls(-self.middle, self.radius)

    def __pos__(self) -> WideBalls:
        return self

    def __add__(self, other: Any) -> WideBalls:
        if isinstance(other, Jet):
            return NotImplemented
        if isinstance(other, int | float) and other == 0:
            return self
        two = _ball(other, self)
        return _rounded(self.middle + two.middle, self.radius + two.radius, SUM)

    __radd__ = __add__

    def __sub__(self, other: Any) -> WideBalls:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> WideBalls:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> WideBalls:
        if isinstance(other, Jet):
            return NotImplemented
        if isinstance(other, int | float):
            if other in (1, -1):
                return self if other == 1 else -self
            return _rounded(self.middle * exactly(other), self.radius * abs(other), PRODUCT)
        two = _ball(other, self)
        radius = np.abs(self.middle.high) * ROOM * two.radius + two.size * self.radius
        return _rounded(self.middle * two.middle, radius, PRODUCT)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> WideBalls:
        if isinstance(other, Jet):
            return NotImplemented
        two = _ball(other, self)
        least = np.abs(two.middle.high) / ROOM - two.radius
        middle = self.middle / two.middle
        radius = (self.radius + np.abs(middle.high) * ROOM * two.radius) / np.where(least > 0, least, np.nan)
        return _rounded(middle, radius, QUOTIENT)

    def __rtruediv__(self, other: Any) -> WideBalls:
        return _ball(other, self) / self

    def __pow__(self, power: int) -> WideBalls:
        if power < 0:
            return 1 / self**-power
        return repeated_product(self, power) if power else WideBalls.exact(np.ones_like(self.radius))

    def __abs__(self) -> WideBalls:
        return self * self.sign()

    def sign(self) -> WideBalls:
        """−1 or 1; NaN where a ball holds 0 and other numbers."""
        sign = np.sign(self.middle.high)
        known = (np.abs(self.middle.high) > ROOM * self.radius) | (self.size == 0)
        return WideBalls.exact(np.where(known, sign, np.nan))

    def sqrt(self) -> WideBalls:
        """Square root; NaN where a ball holds negative numbers. The error is that of its square over twice the root."""
        root = np.sqrt(self.middle)
        off = self - WideBalls(root, np.zeros_like(root.high)) ** 2
        radius = np.where(root.high > 0, off.size / (root.high / ROOM), np.where(self.size == 0, 0.0, np.nan))
        negative = self.middle.high / ROOM < self.radius
        return WideBalls(root, np.where(negative & (self.size > 0), np.nan, radius * ROOM))

    def exp(self) -> WideBalls:
        """Exponential, by Taylor's series of a part of the argument, and squares."""
        small = self * 2.0**-HALVINGS
        total = term = WideBalls.exact(np.ones_like(self.radius))
        for order in range(1, TERMS + 1):
            term = term * small / order
            total = total + term
        # What is left out is less than the last term, where the argument is less than 1 over the halvings.
        known = self.size < 2.0 ** (HALVINGS - 3)
        total = WideBalls(total.middle, np.where(known, total.radius + term.size, np.nan))
        for _ in range(HALVINGS):
            total = total * total
        return total


#: π, as two floats and what these leave.
PI = WideBalls(DoubleDouble(np.array(np.pi), np.array(1.2246467991473532e-16)), np.array(4e-33))


def cosine_and_sine(angles: FloatArray) -> tuple[WideBalls, WideBalls]:
    """Of floats between 0 and π, both exclusive; NaN beyond."""
    radius = np.where((angles > 0) & (angles < np.pi), TURN, np.nan)
    cosine, sine = double_double.cosine_and_sine(angles)
    return WideBalls(cosine, radius), WideBalls(sine, radius)


def atan2(sine: WideBalls, cosine: WideBalls) -> WideBalls:
    """Angle of the vector (cosine, sine), from −π to π; NaN where balls are wide, or meet the ray on which it jumps.

    A float φ₀ near it, and the angle off that, whose sine is s cos φ₀ − c sin φ₀ over the vector's length.
    """
    near = np.arctan2(sine.middle.high, cosine.middle.high)
    level = near == 0
    c, s = cosine_and_sine(np.where(level, 1.0, np.abs(near)))
    one, none = WideBalls.exact(np.ones_like(near)), WideBalls.exact(np.zeros_like(near))
    c, s = WideBalls.where(level, one, c), WideBalls.where(level, none, WideBalls.where(near < 0, -s, s))
    length = (sine * sine + cosine * cosine).sqrt()
    off, along = (sine * c - cosine * s) / length, cosine * c + sine * s
    # The float is the angle of the middle to 16 digits: the sine of what is off is that itself, less than its third power away.
    known = (along.signs() > 0) & (off.size < MOST_OFF) & (np.abs(near) + 2 * off.size < np.pi)
    return WideBalls(off.middle, np.where(known, off.radius + off.size**3, np.nan)) + WideBalls.exact(near)


def atan(value: WideBalls) -> WideBalls:
    """Arc tangent."""
    return atan2(value, WideBalls.exact(np.ones_like(value.radius)))


def log(value: WideBalls) -> WideBalls:
    """Natural logarithm: y + log(1 + z) for a float y near it and z = x e^−y − 1; NaN for balls that are wide."""
    near = np.where(value.middle.high > 0, np.log(np.maximum(value.middle.high, TINY)), np.nan)
    z = value * WideBalls.exact(-near).exp() - 1
    series = WideBalls.exact(np.zeros_like(near))
    for order in range(LOGARITHM, 0, -1):
        series = series * -z + _ball(1.0, value) / order
    total = series * z
    # What is left out is less than twice its first term where z is small.
    rest = 2 * z.size ** (LOGARITHM + 1)
    return WideBalls(total.middle, np.where(z.size < MOST_OFF, total.radius + rest, np.nan)) + WideBalls.exact(near)


def tanh(value: WideBalls) -> WideBalls:
    """Hyperbolic tangent, 1 − 2/(e^2x + 1); beyond :data:`FLAT` it is ±1, off by less than 2e^(−2x)."""
    far = np.abs(value.middle.high) / ROOM - value.radius > FLAT
    near = WideBalls.where(far, WideBalls.exact(np.zeros_like(value.radius)), value)
    found = 1 - 2 / ((near * 2).exp() + 1)
    sign = np.sign(value.middle.high)
    return WideBalls.where(
        far, WideBalls(DoubleDouble(sign, np.zeros_like(sign)), np.full_like(sign, 2 * np.exp(-2 * FLAT) * ROOM)), found
    )


def _waves(angle: WideBalls) -> tuple[WideBalls, WideBalls]:
    """Cosine and sine: those of a float φ between −π and π that is near the angle less whole turns, turned by what is left."""
    turns = np.rint(angle.middle.high / (2 * np.pi))
    known = np.abs(turns) < 2.0**40
    reduced = angle - PI * 2 * WideBalls.exact(np.where(known, turns, np.nan))
    near = reduced.middle.high
    level = near == 0
    one, none = WideBalls.exact(np.ones_like(near)), WideBalls.exact(np.zeros_like(near))
    c, s = cosine_and_sine(np.where(level, 1.0, np.abs(near)))
    c, s = WideBalls.where(level, one, c), WideBalls.where(level, none, WideBalls.where(near < 0, -s, s))
    off = reduced - WideBalls.exact(near)
    square = off * off
    cosine, sine = one, one
    for order in range(SINE, 1, -2):
        cosine, sine = one - cosine * square / (order * (order - 1)), one - sine * square / (order * (order + 1))
    sine = sine * off
    # The series alternate, and what is left out is less than the next term.
    rest = np.where(off.size < 1, off.size ** (SINE + 2), np.nan)
    cosine, sine = (WideBalls(part.middle, part.radius + rest) for part in (cosine, sine))
    return c * cosine - s * sine, s * cosine + c * sine


def _taken(value: Any) -> WideBalls:
    return value if isinstance(value, WideBalls) else WideBalls.exact(np.asarray(value, dtype=float))


def _ball(value: Any, like: WideBalls) -> WideBalls:
    if isinstance(value, WideBalls):
        return value
    return WideBalls.exact(np.broadcast_to(np.asarray(value, dtype=float), like.radius.shape))


def _rounded(middle: DoubleDouble, radius: NDArray[np.float64], units: float) -> WideBalls:
    """With the rounding of one operation; overflow makes NaN of the middle, and so of all that follows."""
    return WideBalls(middle, (radius + np.abs(middle.high) * (units * UNIT)) * ROOM + TINY)


class Functions(JetFunctions):
    """``xp`` of generated functions for these balls."""

    #: π.
    pi = PI

    @staticmethod
    def sign(value: Any) -> Any:
        """−1 or 1."""
        return value.sign() if isinstance(value, WideBalls) else np.sign(value)

    @staticmethod
    def abs(value: Any) -> Any:
        """Absolute value."""
        return abs(value)


#: The one that is needed.
XP = Functions(
    {
        "sqrt": WideBalls.sqrt, "exp": WideBalls.exp, "log": log, "tanh": tanh, "atan": atan, "atan2": atan2,
        "cos": lambda angle: _waves(angle)[0], "sin": lambda angle: _waves(angle)[1],
    },
    _taken,
)  # fmt: skip
