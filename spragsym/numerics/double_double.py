"""Arrays of double-double numbers, on which generated algebra runs as on arrays of floats.

The arithmetic is that of :mod:`spragsym.generated.double_double`; this module gives it NumPy's
operators. In operations with arrays of floats, these are exact. NumPy functions that would lose
digits silently are refused with a TypeError.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin
from numpy.typing import NDArray

from ..generated import double_double
from .arithmetic import Number
from .interval_arrays import FloatArray, Shape

Array = NDArray[Any]
#: Untyped, as its functions take any object with a high and a low part.
dd: Any = double_double


class DoubleDouble(NDArrayOperatorsMixin):
    """Array of numbers of 106 bits, each the exact sum of two doubles.

    ``high`` is the sum rounded to a double, ``low`` the rest.

    Examples
    --------
    >>> third = 1 / DoubleDouble(np.array([3.0]))
    >>> float((third * 3 - 1).high[0])
    0.0
    >>> third.low != 0
    array([ True])
    """

    __slots__ = ("high", "low")

    def __init__(self, high: FloatArray | float, low: FloatArray | float = 0.0) -> None:
        self.high, self.low = np.asarray(high, dtype=float), np.asarray(low, dtype=float)

    @property
    def shape(self) -> Shape:
        """Shape of the arrays."""
        return np.broadcast_shapes(self.high.shape, self.low.shape)

    @property
    def ndim(self) -> int:
        """Number of axes of the arrays."""
        return len(self.shape)

    def __getitem__(self, key: Any) -> DoubleDouble:
        return DoubleDouble(self.high[key], np.broadcast_to(self.low, self.shape)[key])

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> object:
        if method != "__call__" or options or ufunc not in _UFUNCS:
            return NotImplemented
        return _UFUNCS[ufunc](*inputs)

    def __array_function__(
        self, function: object, types: object, arguments: tuple[Any, ...], options: dict[str, Any]
    ) -> object:
        if options or function is not np.where:
            return NotImplemented
        flag, one, other = arguments
        return _of(dd.dd_where(flag, _wide(one), _wide(other)))


#: What an operation takes.
Operand: TypeAlias = DoubleDouble | FloatArray | float


def _of(pair: double_double.Wide) -> DoubleDouble:
    """Result of an operation, without the checks of the constructor, which take time."""
    out = object.__new__(DoubleDouble)
    out.high, out.low = pair
    return out


def _wide(value: Any) -> DoubleDouble:
    """A double-double as it is; a float, or an array of floats, as an exact double-double."""
    return value if isinstance(value, DoubleDouble) else DoubleDouble(value)


def _is_power_of_two(value: Number) -> bool:
    return isinstance(value, int | float) and math.frexp(abs(value))[0] == 0.5


def _sum(one: Number, other: Number) -> DoubleDouble:
    if not isinstance(one, DoubleDouble):
        one, other = other, one
    if isinstance(other, DoubleDouble):
        return _of(dd.dd_add(one, other))
    return _of(dd.dd_add_double(one, other))


def _product(one: Operand, other: Operand) -> DoubleDouble:
    if not isinstance(one, DoubleDouble):
        one, other = other, one
    if isinstance(other, DoubleDouble):
        return _of(dd.dd_multiply(one, other))
    if _is_power_of_two(other):
        return _of(dd.dd_scaled(one, float(other)))
    return _of(dd.dd_multiply_double(one, other))


def _quotient(one: Operand, other: Operand) -> DoubleDouble:
    if _is_power_of_two(other):
        return _product(one, 1.0 / other)
    return _of(dd.dd_divide(_wide(one), _wide(other)))


def _less(one: Number, other: Number) -> Array:
    return np.asarray(dd.dd_less(_wide(one), _wide(other)))


def _same(one: DoubleDouble, other: DoubleDouble) -> Array:
    return np.asarray((one.high == other.high) & (one.low == other.low))


_UFUNCS: dict[Any, Callable[..., Any]] = {
    np.add: _sum,
    np.subtract: lambda one, other: _sum(one, -other),
    np.multiply: _product,
    np.true_divide: _quotient,
    np.less: _less,
    np.greater: lambda one, other: _less(other, one),
    np.greater_equal: lambda one, other: _less(other, one) | _same(_wide(one), _wide(other)),
    np.maximum: lambda one, other: _of(dd.dd_larger(_wide(one), _wide(other))),
    np.minimum: lambda one, other: _of(dd.dd_smaller(_wide(one), _wide(other))),
    np.absolute: lambda value: _of(dd.dd_absolute(value)),
    np.negative: lambda value: DoubleDouble(-value.high, -value.low),
    np.sqrt: lambda value: _of(dd.dd_sqrt(value)),
}


def cosine_and_sine(angle: Array) -> tuple[DoubleDouble, DoubleDouble]:
    """Cosine and sine of doubles 0 < θ < π, to within about two bits of 106."""
    both = dd.dd_cosine_and_sine(angle)
    cosine = DoubleDouble(both.cosine_high, both.cosine_low)
    return cosine, DoubleDouble(both.sine_high, both.sine_low)
