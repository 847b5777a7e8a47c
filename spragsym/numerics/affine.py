"""Floats with a proved bound on the error of each, and affine arithmetic: numbers that know how they depend on what varies.

A :class:`Rounded` stands for every number within ``error`` of ``value``, for many points at once. What generated algebra makes of
them is again right: each operation adds what it rounds. A sign that the bound leaves open is 0, and its point goes to
:mod:`spragsym.numerics.balls`.

An :class:`Affine` stands for value + Σ terms_j ε_j ± error with every \\|ε_j\\| ≤ 1, one ε for each side of a box. Sums and
products keep the terms, so that what depends on a parameter twice is not widened twice, and what is lost is of second order in
the size of the box. Every rounding goes into the error: a sign that it leaves open is 0.
"""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np

from . import interval_arrays
from .arithmetic import Arithmetic, repeated_product
from .interval_arrays import FUNCTION_ULPS, FloatArray, Int8Array, Intervals, raised
from .jets import Functions, Jet

#: Half a unit in the last place, relative.
UNIT = 2.0**-53
#: What an error bound itself may lose by the roundings of one operation, and the underflow of a product.
_SLACK, _TINY = 1.0 + 2.0**-45, 1e-320


class Rounded(Arithmetic):
    """Numbers ``value`` ± ``error``, arrays of one shape; operations with ints and floats take these as exact."""

    __slots__ = ("error", "value")
    __array_ufunc__ = None  # an array on the left leaves the operation to the right

    def __init__(self, value: Any, error: Any = 0.0) -> None:
        self.value, self.error = value, error

    def radius(self) -> Any:
        """How far from ``value`` the numbers reach."""
        return self.error

    def __add__(self, other: Any) -> Rounded:
        if isinstance(other, Rounded):
            value = self.value + other.value
            return Rounded(value, (self.error + other.error + UNIT * abs(value)) * _SLACK)
        value = self.value + other
        return Rounded(value, (self.error + UNIT * abs(value)) * _SLACK)

    def __neg__(self) -> Rounded:
        return Rounded(-self.value, self.error)

    def __mul__(self, other: Any) -> Rounded:
        if isinstance(other, Rounded):
            value, size = self.value * other.value, abs(other.value)
            carried = abs(self.value) * other.error + (size + other.error) * self.error
            return Rounded(value, (carried + UNIT * abs(value)) * _SLACK + _TINY)
        value = self.value * other
        return Rounded(value, (abs(other) * self.error + UNIT * abs(value)) * _SLACK + _TINY)

    def __truediv__(self, other: Any) -> Rounded:
        divisor = other if isinstance(other, Rounded) else Rounded(other)
        value = self.value / divisor.value
        least = abs(divisor.value) - divisor.error
        # |a/b − v/w| ≤ (|δa| + |v/w| |δb|) / (|w| − |δb|), and v/w is rounded.
        carried = (self.error + abs(value) * divisor.error) / least
        error = (carried + UNIT * abs(value)) * _SLACK**3 + _TINY
        return Rounded(value, np.where(least > 0, error, np.inf))

    def __rtruediv__(self, other: Any) -> Rounded:
        return Rounded(other) / self

    __pow__ = repeated_product

    def sqrt(self) -> Rounded:
        """Square roots; an infinite error where negative numbers may be among them."""
        least = self.value - self.error
        value = np.sqrt(np.maximum(self.value, 0.0))
        # |√a − √m| ≤ |a − m|/√m
        error = (self.error / value + UNIT * value) * _SLACK**2
        return Rounded(value, np.where(least > 0, error, np.inf))

    def rows(self, index: Any) -> Rounded:
        """Some of the numbers; of a single number, that."""
        if np.ndim(self.value) == 0:
            return self
        return Rounded(self.value[index], np.broadcast_to(self.error, np.shape(self.value))[index])

    def sign(self) -> Int8Array:
        """−1 or 1 where all that it stands for has that sign, else 0; 0 for NaN."""
        reach = self.radius()
        above, below = self.value > reach, -self.value > reach
        return np.asarray(above, dtype=np.int8) - np.asarray(below, dtype=np.int8)


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


def cosine_and_sine(angle: Any) -> tuple[Any, Any]:
    """Cosine and sine of an angle, to first order in what it depends on; of floats, which are exact, as :class:`Rounded`."""
    cosine, sine = (wave(angle.value if isinstance(angle, Affine) else angle) for wave in (np.cos, np.sin))
    if not isinstance(angle, Affine):
        one, other = (Rounded(value, 2 * FUNCTION_ULPS * UNIT * abs(value) + _TINY) for value in (cosine, sine))
        return one, other
    reach = angle.radius()
    beyond = (0.5 * reach * reach + angle.error + 4 * FUNCTION_ULPS * UNIT * (1 + reach)) * _SLACK
    return Affine(cosine, -sine * angle.terms, beyond), Affine(sine, cosine * angle.terms, beyond)


def _through(name: str) -> Callable[[Affine], Affine]:
    """A function of affine numbers from itself and its slope, of intervals."""
    function = getattr(interval_arrays, name)

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
    pi = Affine.between(interval_arrays.PI)

    def sign(self, value: Any) -> Affine:
        """−1, 0, 1."""
        return Affine.between(self.taken(value).interval().sign())


_INTERVALS = Functions(interval_arrays, lambda value: value)
#: The one that is needed.
AFFINE = _Functions(
    SimpleNamespace(**{name: _through(name) for name in ("sqrt", "exp", "log", "tanh", "atan", "cos", "sin")}), _taken
)
