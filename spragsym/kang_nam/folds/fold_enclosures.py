"""Points of the surface with f = f′ = 0, enclosed."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from ...numerics import polynomials
from ...numerics.balls import Interval, as_floats, atan2, decided, sign_or_zero
from ..quartic import kernel


class Angles(NamedTuple):
    """cos θ, sin θ, cos θ₀ and sin θ₀."""

    c: Interval
    s: Interval
    c0: Interval
    s0: Interval


@dataclass(frozen=True)
class Point:
    """A point of the surface with f = f′ = 0, in intervals: parameters in the order of ``NAMES``, direction and state."""

    parameters: tuple[Interval, ...]
    theta: Interval
    L: Interval
    x: Interval
    y: Interval

    def row(self) -> tuple[float, ...]:
        """Middles as floats, and the largest error, the rounding to float included."""
        values, error = as_floats((*self.parameters, self.theta, self.L, self.x, self.y))
        return (*values, error)


@dataclass(frozen=True)
class SineRoot:
    """sin θ of a point: an interval (low, high] around one root of an exact polynomial, or low = high."""

    polynomial: polynomials.Polynomial
    low: Fraction
    high: Fraction

    def sign_of(self, value: Interval, numerator: Callable[[Fraction], Fraction], degree: int, what: str) -> int:
        """The sign of an interval; 0 where what it encloses, a function of sin θ known by its numerator, is 0 exactly."""

        def vanishes() -> bool:
            if self.low == self.high:
                return numerator(self.low) == 0
            other = polynomials.interpolate(numerator, degree, Fraction)
            return polynomials.has_root(polynomials.common_divisor(self.polynomial, other), self.low, self.high)

        return sign_or_zero(value, what, vanishes)


def in_contact(angles: Angles, mu0: Interval, values: tuple[Interval, ...]) -> Iterator[Point]:
    """The point at κ, α, σ, β with its state, if it is in contact with L > 0."""
    kappa, _, sigma, beta = values
    L, x, y = kernel.state(*angles, kappa, sigma, beta, 1)
    if decided(L, "L = 0") > 0 and decided(y, "y = 0") < 0:
        yield Point((atan2(angles.s0, angles.c0), mu0, *values), atan2(angles.s, angles.c), L, x, y)
