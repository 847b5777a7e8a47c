"""The half-angle map t = tan(θ/2), over rationals and intervals, and polynomials in cos θ and sin θ as polynomials in t."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any, NamedTuple


class OnCircle(NamedTuple):
    """cos θ, sin θ and their denominator 1 + t² at t = tan(θ/2)."""

    cosine: Any
    sine: Any
    scale: Any


def on_circle(t: Any) -> OnCircle:
    """The direction θ with tan(θ/2) = t, exactly for a rational t."""
    scale = 1 + t * t
    return OnCircle((1 - t) * (1 + t) / scale, 2 * t / scale, scale)


def in_t(function: Callable[[Any, Any], Any], degree: int) -> Callable[[Fraction], Fraction]:
    """(1 + t²)^degree times a function of that degree in cos θ and sin θ, which is a polynomial in t."""

    def value(t: Fraction) -> Fraction:
        c, s, scale = on_circle(t)
        return Fraction(function(c, s) * scale**degree)

    return value


def of_sine_in_t(polynomial: Sequence[int]) -> tuple[int, ...]:
    """(1 + t²)^degree times a polynomial in sin θ, lowest power first: its coefficients in t."""
    value, scale = [polynomial[-1]], [1]
    for coefficient in reversed(polynomial[:-1]):  # Horner's rule, times 1 + t² at each step
        scale = [one + other for one, other in zip([*scale, 0, 0], [0, 0, *scale], strict=True)]
        value = [2 * one + coefficient * other for one, other in zip([0, *value, 0], scale, strict=True)]
    return tuple(value)
