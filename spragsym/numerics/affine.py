"""Affine arithmetic for many boxes at once: numbers that know, to first order, how they depend on what varies over a box.

An :class:`Affine` stands for value + Σ terms_j ε_j ± error with every \\|ε_j\\| ≤ 1, one ε for each side of a box. Sums and
products keep the terms, so that what depends on a parameter twice is not widened twice, and what is lost is of second order in
the size of the box. Every rounding goes into the error: a sign that it leaves open is 0.
"""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np

from . import interval_functions
from .interval_arrays import FUNCTION_ULPS, FloatArray, Intervals, raised
from .jets import Functions, Jet
from .rounded import UNIT, Rounded

_SLACK, _TINY = 1.0 + 2.0**-45, 1e-320


class Affine(Rounded):
    """Numbers of ``n`` boxes: ``value`` and ``error`` of shape (n,), ``terms`` of shape (sides, n)."""

    __slots__ = ("terms",)

    def __init__(self, value: Any, terms: Any, error: Any = 0.0) -> None:
        super().__init__(value, error)
        self.terms = terms

    def _spread(self) -> Any:
        return np.abs(self.terms).sum(axis=0)

    def radius(self) -> Any:
        """How far from ``value`` the numbers reach."""
        return (self._spread() + self.error) * _SLACK

    def __add__(self, other: Any) -> Affine:
        if not isinstance(other, Affine):
            value = self.value + other
            return Affine(value, self.terms, (self.error + UNIT * np.abs(value)) * _SLACK)
        value, terms = self.value + other.value, self.terms + other.terms
        return Affine(value, terms, (self.error + other.error + _rounding(value, terms)) * _SLACK)

    def __neg__(self) -> Affine:
        return Affine(-self.value, -self.terms, self.error)

    def __mul__(self, other: Any) -> Affine:
        if not isinstance(other, Affine):
            value, terms = self.value * other, self.terms * other
            return Affine(value, terms, (np.abs(other) * self.error + _rounding(value, terms)) * _SLACK + _TINY)
        value = self.value * other.value
        left, right = np.abs(self.value), np.abs(other.value)
        own, others = self._spread(), other._spread()
        carried = left * other.error + right * self.error + (own + self.error) * (others + other.error)
        rounding = UNIT * (np.abs(value) + 3 * (left * others + right * own))
        terms = self.value * other.terms + other.value * self.terms
        return Affine(value, terms, (carried + rounding) * _SLACK + _TINY)

    def __truediv__(self, other: Any) -> Affine:
        if isinstance(other, Affine):
            return self.__mul__(other.reciprocal())
        value, terms = self.value / other, self.terms / other
        return Affine(value, terms, (self.error / np.abs(other) + _rounding(value, terms)) * _SLACK + _TINY)

    def __rtruediv__(self, other: Any) -> Affine:
        return self.reciprocal().__mul__(other)

    def reciprocal(self) -> Affine:
        """1/x: 1/m − (x − m)/m² and (x − m)²/(m² x) beyond that; an infinite error where 0 may be in x."""
        inverse = 1.0 / self.value
        reach = self.radius()
        least = np.abs(self.value) - reach
        size = np.abs(inverse)  # its square may be below the smallest float
        beyond = (reach * inverse) ** 2 / least
        # What the terms lose is below three of these units where they are small, and below what is of second order elsewhere.
        error = (size * (size * self.error) + beyond + 4 * UNIT * size) * _SLACK
        return Affine(inverse, -inverse * (inverse * self.terms), np.where(least > 0, error, np.inf))

    @classmethod
    def between(cls, interval: Intervals) -> Affine:
        """Anything in an interval, of which nothing is known but that."""
        middle = interval.middle
        error = np.maximum(interval.high - middle, middle - interval.low) * _SLACK + _TINY
        return cls(middle, np.zeros((1, *middle.shape)), np.where(np.isfinite(error), error, np.inf))

    def interval(self) -> Intervals:
        """The interval in which the numbers lie."""
        radius = self.radius()
        return Intervals(raised(np.stack([radius - self.value, radius + self.value])))

    @staticmethod
    def linear(x: Affine, middle: Affine, slopes: Intervals) -> Affine:
        """f(x) from f(m) at the value m of x, and f′ over all of x."""
        slope, reach = slopes.middle, x.radius()
        off = np.maximum(slopes.high - slope, slope - slopes.low) * reach
        terms = slope * x.terms
        rounding = UNIT * np.abs(terms).sum(axis=0)
        error = (np.abs(slope) * x.error + off + middle.error + rounding) * _SLACK + _TINY
        known = np.isfinite(error) & np.isfinite(middle.value)
        return Affine(np.where(known, middle.value, 0.0), np.where(known, terms, 0.0), np.where(known, error, np.inf))


def _rounding(value: Any, terms: Any) -> Any:
    return UNIT * (np.abs(value) + np.abs(terms).sum(axis=0))


def sides(low: FloatArray, high: FloatArray) -> list[Affine]:
    """One number for each side of boxes, whose corners have the shape (sides, n)."""
    middle = 0.5 * (low + high)
    half = np.maximum(np.nextafter(high - middle, np.inf), np.nextafter(middle - low, np.inf))
    half = np.where(high > low, half, 0.0)
    result = []
    for j in range(len(low)):
        terms = np.zeros(low.shape)
        terms[j] = half[j]
        result.append(Affine(middle[j], terms, np.zeros(low.shape[1])))
    return result


def cosine_and_sine(angle: Affine) -> tuple[Affine, Affine]:
    """Cosine and sine of an angle, to first order in what the angle depends on."""
    cosine, sine = np.cos(angle.value), np.sin(angle.value)
    reach = angle.radius()
    beyond = (0.5 * reach * reach + angle.error + 4 * FUNCTION_ULPS * UNIT * (1 + reach)) * _SLACK
    return Affine(cosine, -sine * angle.terms, beyond), Affine(sine, cosine * angle.terms, beyond)


def _through(name: str) -> Callable[[Affine], Affine]:
    """A function of affine numbers from itself and its slope, of intervals."""
    function = getattr(interval_functions, name)

    def through(x: Affine) -> Affine:
        with np.errstate(all="ignore"):
            slope = _INTERVALS.of(name, Jet.variable(x.interval(), 0, 1)).derivative(0)
            return Affine.linear(x, Affine.between(function(Intervals.point(x.value))), slope)

    return through


def _taken(value: Any) -> Affine:
    """A number as one without terms."""
    return value if isinstance(value, Affine) else Affine(np.full(1, float(value)), np.zeros((1, 1)))


class _Functions(Functions):
    #: π.
    pi = Affine.between(interval_functions.PI)

    def sign(self, value: Any) -> Affine:
        """−1, 0, 1."""
        return Affine.between(self.taken(value).interval().sign())


_INTERVALS = Functions(interval_functions, lambda value: value)
#: The one that is needed.
AFFINE = _Functions(
    SimpleNamespace(**{name: _through(name) for name in ("sqrt", "exp", "log", "tanh", "atan", "cos", "sin")}), _taken
)
