"""Floats with proved error bounds, and affine arithmetic.

A :class:`Rounded` is an array of floats, each with a bound of its error. Operations add the error
of their rounding, so that the results of generated algebra have proved bounds too. A sign that the
bound leaves open is 0; the caller decides it in :mod:`spragsym.numerics.balls`.

An :class:`Affine` is an affine form value + Σ terms_j ε_j ± error with noise symbols
\\|ε_j\\| ≤ 1. All forms share the symbols, one for each side of a box. Sums and products keep the
terms. So two factors that depend on the same parameter do not widen the result twice, as they do in
interval arithmetic; the overestimation is of second order in the size of the box. Roundings go into
``error``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from types import SimpleNamespace
from typing import Any, Self, TypeAlias

import numpy as np

from . import interval_arrays
from .arithmetic import Arithmetic, Number, repeated_product
from .interval_arrays import (
    FUNCTION_ULPS,
    BoolArray,
    FloatArray,
    IndexArray,
    Int8Array,
    Intervals,
    Shape,
    quiet,
    rounded_outward,
)
from .jets import Functions, Jet
from .tape import Tape

#: Half a unit in the last place, relative.
UNIT = 2.0**-53
#: Factor that covers the roundings of one operation in the computation of an error bound.
_SLACK = 1.0 + 2.0**-45
#: Summand that covers the underflow of a product.
_TINY = 1e-320


#: One float for each box, or the same for all.
Real: TypeAlias = float | FloatArray


class _Zero(Arithmetic):
    """The terms of numbers without terms: a 0 that needs no arrays."""

    __array_ufunc__ = None

    def __neg__(self) -> Self:
        return self

    def __add__(self, other: Number) -> Any:
        return other

    def __mul__(self, other: Number) -> Self:
        return self

    __truediv__ = __mul__


_ZERO = _Zero()


class Rounded(Arithmetic):
    """Numbers ``value`` ± ``error``, arrays of one shape; ints and floats in operations are
    exact.
    """

    __slots__ = ("error", "value")
    __array_ufunc__ = None  # array * number calls __rmul__

    terms: Any = _ZERO

    def __init__(self, value: Real, error: Real = 0.0) -> None:
        self.value: Any = value
        self.error: Any = error

    def radius(self) -> FloatArray:
        """Largest distance of the numbers from ``value``."""
        return (_spread(self) + self.error) * _SLACK

    def __add__(self, other: Number) -> Rounded:
        if not isinstance(other, Rounded):
            return _rounded(self.value + other, self.terms, self.error)
        return _rounded(
            self.value + other.value, self.terms + other.terms, self.error + other.error
        )

    def __neg__(self) -> Rounded:
        return _number(-self.value, -self.terms, self.error)

    def __mul__(self, other: Any) -> Rounded:
        if not isinstance(other, Rounded):
            return _rounded(self.value * other, self.terms * other, self.error * abs(other) + _TINY)
        left, right = abs(self.value), abs(other.value)
        error, terms = left * other.error + (right + other.error) * self.error + _TINY, _ZERO
        if self.terms is not _ZERO or other.terms is not _ZERO:
            own, others = _spread(self), _spread(other)
            # The left factors may be _ZERO, whose own operators must be called, not NumPy's.
            error = (
                error
                + own * (others + other.error)
                + others * self.error
                + (others * left + own * right) * (2 * UNIT)
            )
            terms = other.terms * self.value + self.terms * other.value
        return _rounded(self.value * other.value, terms, error)

    def __truediv__(self, other: Number) -> Rounded:
        other = as_rounded(other)
        value = self.value / other.value
        size, reach, quotient = abs(other.value), other.radius(), abs(value)
        least = size - reach
        # With the values v of x and w of y, and q = v/w,
        # x/y = q + (x − q y)/w + (x − q y)(1/y − 1/w),
        # |1/y − 1/w| ≤ |y − w| / (|w| (|w| − |y − w|)).
        rounding = (_spread(other) * quotient + _spread(self)) * (4 * UNIT)
        # The error of products that underflow is divided by w too.
        own = (rounding + (self.error + quotient * other.error) + _TINY) / size
        found = _number(value, (self.terms - other.terms * value) / other.value, own)
        error = (
            own + (_spread(found) + own) * (reach / least) + UNIT * quotient
        ) * _SLACK**3 + _TINY
        found.error = np.where(least > 0, error, np.inf)
        return found

    def __rtruediv__(self, other: Real) -> Rounded:
        return Rounded(other) / self

    __pow__ = repeated_product

    def sqrt(self) -> Rounded:
        """Square roots; the error is infinite where the argument may be negative."""
        reach = self.radius()
        value = np.sqrt(np.maximum(self.value, 0.0))
        # |√a − √m| ≤ |a − m|/√m
        error = (reach / value + UNIT * value) * _SLACK**2
        return Rounded(value, np.where(self.value > reach, error, np.inf))

    def rows(self, index: IndexArray | BoolArray | slice) -> Rounded:
        """Selected points; a scalar is the same at all points."""
        if np.ndim(self.value) == 0:
            return self
        return Rounded(self.value[index], np.broadcast_to(self.error, np.shape(self.value))[index])

    def sign(self) -> Int8Array:
        """Signs that are proved, −1 or 1; 0 where none is, or for NaN."""
        reach = self.radius()
        above, below = self.value > reach, -self.value > reach
        return np.asarray(above, dtype=np.int8) - np.asarray(below, dtype=np.int8)


class Affine(Rounded):
    """Affine forms of N boxes: ``value`` and ``error`` of shape (…, N), ``terms`` of shape (noise
    symbols, …, N).
    """

    __slots__ = ("terms",)

    def __init__(self, value: Real, terms: FloatArray, error: Real = 0.0) -> None:
        super().__init__(value, error)
        self.terms = terms

    @classmethod
    def between(cls, interval: Intervals) -> Affine:
        """The form without terms that encloses an interval."""
        middle = interval.middle
        error = np.maximum(interval.high - middle, middle - interval.low) * _SLACK + _TINY
        return cls(
            middle, np.zeros((1, *middle.shape)), np.where(np.isfinite(error), error, np.inf)
        )

    @classmethod
    def stacked(cls, entries: Sequence[Any], shape: Shape) -> Affine:
        """Entries, forms or floats for boxes of the given shape, as one form with a new first
        axis.
        """
        rows = [
            one if isinstance(one, Affine) else Affine(one, np.zeros((1, *shape)))
            for one in entries
        ]
        sides = max(row.terms.shape[0] for row in rows)
        terms = np.zeros((sides, len(rows), *shape))
        for column, row in enumerate(rows):
            terms[: row.terms.shape[0], column] = row.terms
        value = np.stack([np.broadcast_to(row.value, shape) for row in rows])
        error = np.stack([np.broadcast_to(row.error, shape) for row in rows])
        return cls(value, terms, error)

    def __getitem__(self, index: object) -> Affine:
        index = index if isinstance(index, tuple) else (index,)
        return Affine(self.value[index], self.terms[(slice(None), *index)], self.error[index])

    def __abs__(self) -> Affine:
        return Affine.linear(
            self, Affine.between(abs(Intervals.point(self.value))), self.interval().sign()
        )

    def interval(self) -> Intervals:
        """The interval of all values of the form."""
        radius = self.radius()
        return Intervals(rounded_outward(np.stack([radius - self.value, radius + self.value])))

    @staticmethod
    def linear(x: Affine, middle: Affine, slopes: Intervals) -> Affine:
        """f(x) by the mean value form, from f at the value of x and ``slopes`` f′ over all of x."""
        slope, reach = slopes.middle, x.radius()
        nonlinear = np.maximum(slopes.high - slope, slope - slopes.low) * reach
        terms = slope * x.terms
        rounding = UNIT * np.abs(terms).sum(axis=0)
        error = (np.abs(slope) * x.error + nonlinear + middle.error + rounding) * _SLACK + _TINY
        finite = np.isfinite(error) & np.isfinite(middle.value)
        return Affine(
            np.where(finite, middle.value, 0.0),
            np.where(finite, terms, 0.0),
            np.where(finite, error, np.inf),
        )


def _number(value: Real, terms: FloatArray | _Zero, error: Real) -> Rounded:
    return Rounded(value, error) if isinstance(terms, _Zero) else Affine(value, terms, error)


def _rounded(value: Any, terms: FloatArray | _Zero, error: Real) -> Rounded:
    """A number with the error of one rounding added."""
    if isinstance(terms, _Zero):
        return Rounded(value, (error + UNIT * abs(value)) * _SLACK)
    return Affine(value, terms, (error + UNIT * (np.abs(terms).sum(axis=0) + abs(value))) * _SLACK)


def as_rounded(value: Any) -> Rounded:
    """A number as it is; an int or float as an exact number."""
    return value if isinstance(value, Rounded) else Rounded(value)


def _spread(number: Rounded) -> object:
    """Sum of the terms' absolute values."""
    return np.abs(number.terms).sum(axis=0) if isinstance(number, Affine) else _ZERO


def sides(low: FloatArray, high: FloatArray) -> list[Affine]:
    """One form for each side of boxes, with a noise symbol of its own; corners have the shape
    (sides, N).
    """
    middle = 0.5 * (low + high)
    half = np.maximum(np.nextafter(high - middle, np.inf), np.nextafter(middle - low, np.inf))
    terms = np.eye(len(low))[:, :, None] * np.where(high > low, half, 0.0)
    return [Affine(*side, np.zeros(low.shape[1])) for side in zip(middle, terms, strict=True)]


def cosine_and_sine(angle: Any) -> tuple[Any, Any]:
    """Cosine and sine of an affine angle, linearized, or of floats, as :class:`Rounded`."""
    if not isinstance(angle, Affine):
        return _of_library(np.cos(angle)), _of_library(np.sin(angle))
    cosine, sine, reach = np.cos(angle.value), np.sin(angle.value), angle.radius()
    error = (0.5 * reach * reach + angle.error + 4 * FUNCTION_ULPS * UNIT * (1 + reach)) * _SLACK
    return Affine(cosine, -sine * angle.terms, error), Affine(sine, cosine * angle.terms, error)


def _of_library(value: Any) -> Rounded:
    """A value of an elementary function, with the error of the library."""
    return Rounded(value, 2 * FUNCTION_ULPS * UNIT * abs(value) + _TINY)


def _through(name: str) -> Callable[[Affine], Affine]:
    """An elementary function of affine forms, by the mean value form."""
    function = getattr(interval_arrays, name)
    intervals = Functions(interval_arrays, lambda value: value)

    def through(x: Affine) -> Affine:
        with quiet():
            slope = intervals.of(name, Jet.variable(x.interval(), 0, 1)).derivative(0)
            return Affine.linear(x, Affine.between(function(Intervals.point(x.value))), slope)

    return through


def _taken(value: float | Affine) -> Affine:
    """An affine form as it is; a float as a form without terms."""
    return (
        value if isinstance(value, Affine) else Affine(np.full(1, float(value)), np.zeros((1, 1)))
    )


def evaluated(recorded: Tape, given: Affine, intervals: Intervals) -> Affine:
    """Results of a tape, shape (outputs, N); its inputs are forms of shape (rows, N), and
    intervals.
    """
    error = np.broadcast_to(given.error, given.value.shape)
    return Affine(*recorded.affine(given.value, given.terms, error, intervals))


class _AffineFunctions(Functions):
    pi = Affine.between(interval_arrays.PI)

    def sign(self, value: Number) -> Affine:
        """The sign, as a form that encloses it."""
        return Affine.between(self.taken(value).interval().sign())


#: Functions of affine forms, for generated code.
AFFINE = _AffineFunctions(
    SimpleNamespace(
        **{name: _through(name) for name in ("sqrt", "exp", "log", "tanh", "atan", "cos", "sin")}
    ),
    _taken,
)
