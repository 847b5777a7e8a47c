"""The namespace ``xp`` of generated functions for :class:`spragsym.exact.intervals.Ball` and jets of balls."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from .intervals import GUARD_BITS, Ball, Balls
from .jets import Jet, argument, constant, turned
from .polynomials import Undecided

_BALLS = Balls()


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
    """Angle of a vector of balls, from −π to π."""
    up, right = (_BALLS.sign(part) for part in (sine, cosine))
    if right > 0 and (not up or _size(sine) <= _size(cosine)):
        return _BALLS.atan(sine / cosine)
    if not up:
        raise Undecided("the angle of balls that meet the ray on which it jumps")
    half = _BALLS.atan(Ball(1, 0, 0, sine.bits)) * 2
    return (half if up > 0 else -half) - _BALLS.atan(cosine / sine)


def _size(value: Ball) -> int:
    """n with |x| < 2^n all over the ball."""
    return (abs(value.mid) + value.rad).bit_length() + value.exp


def cosine_and_sine(angle: Any) -> tuple[Any, Any]:
    """Of a ball, or of a jet of balls."""
    if not isinstance(angle, Jet):
        return _BALLS.cos_sin(angle)
    pair = _BALLS.cos_sin(angle.value)
    return angle.cos(pair), angle.sin(pair)


class Functions:
    """``xp`` for balls."""

    @staticmethod
    def sqrt(value: Any) -> Any:
        """Square root."""
        if isinstance(value, Jet):
            return value.sqrt(Functions.sqrt(value.value))
        return _BALLS.sqrt(value if isinstance(value, Ball) else _BALLS.exact(Fraction(value)))

    @staticmethod
    def exp(value: Any) -> Any:
        """Exponential."""
        if isinstance(value, Jet):
            return value.exp(Functions.exp(value.value))
        return exp(value if isinstance(value, Ball) else _BALLS.exact(Fraction(value)))

    @staticmethod
    def atan2(sine: Any, cosine: Any) -> Any:
        """Angle of the vector (cosine, sine), from −π to π; :class:`Undecided` where the balls meet the ray on which it jumps."""
        if isinstance(sine, Jet) or isinstance(cosine, Jet):
            return argument(*turned(sine, cosine)) + atan2(constant(sine), constant(cosine))
        return atan2(sine, cosine)

    @staticmethod
    def sign(value: Any) -> int:
        """−1 or 1; :class:`Undecided` where the ball holds 0."""
        found = _BALLS.sign(value.value if isinstance(value, Jet) else value)
        if not found:
            raise Undecided("the sign of a ball that holds 0")
        return found

    @classmethod
    def abs(cls, value: Any) -> Any:
        """Absolute value."""
        return value if cls.sign(value) > 0 else -value


#: The one that is needed.
XP = Functions()
