"""The namespace ``xp`` of generated functions for :class:`spragsym.numerics.balls.Ball` and jets of balls."""

import math
import sys
from fractions import Fraction
from typing import Any

from . import balls
from .balls import GUARD_BITS, Ball, Undecided, ball
from .jets import Functions, constant

sqrt, atan = balls.sqrt, balls.atan


def exp(value: Ball) -> Ball:
    """Exponential: Taylor's series of the argument over 2^halvings, squared as often.

    The argument is cut to at most 2^-8, so that what is dropped after a term is less than that term.
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


def atan2(sine: Ball, cosine: Ball) -> Ball:
    """Angle of a vector of balls, from −π to π; :class:`Undecided` where they meet the ray on which it jumps."""
    up, right = (balls.sign(part) for part in (sine, cosine))
    if right > 0 and (not up or _size(sine) <= _size(cosine)):
        return atan(sine / cosine)
    if not up:
        raise Undecided("the angle of balls that meet the ray on which it jumps")
    half = atan(Ball(1, 0, 0, sine.bits)) * 2
    return (half if up > 0 else -half) - atan(cosine / sine)


def _size(value: Ball) -> int:
    """n with |x| < 2^n all over the ball."""
    return (abs(value.mid) + value.rad).bit_length() + value.exp


def cos(angle: Ball) -> Ball:
    """Cosine."""
    return balls.cos_sin(angle)[0]


def sin(angle: Ball) -> Ball:
    """Sine."""
    return balls.cos_sin(angle)[1]


def log(value: Ball) -> Ball:
    """Natural logarithm: y + log(1 + z) for a float y near it and z = x e^−y − 1, by Taylor's series."""
    if value.mid <= 2 * value.rad:
        raise Undecided("the logarithm of a ball that holds 0, or nearly does")
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


def _taken(value: Any) -> Ball:
    return value if isinstance(value, Ball) else balls.exact(Fraction(value))


class _Functions(Functions):
    @property
    def pi(self) -> Ball:
        """π."""
        return balls.pi()

    @staticmethod
    def sign(value: Any) -> int:
        """−1 or 1; :class:`Undecided` where the ball holds 0."""
        found = balls.sign(constant(value))
        if not found:
            raise Undecided("the sign of a ball that holds 0")
        return found

    @classmethod
    def abs(cls, value: Any) -> Any:
        """Absolute value."""
        return value if cls.sign(value) > 0 else -value


#: ``xp`` for balls.
XP = _Functions(sys.modules[__name__], _taken)
