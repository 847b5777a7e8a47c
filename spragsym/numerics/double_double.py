"""Double-double numbers as NumPy sees them: generated algebra runs on arrays of them as on arrays of floats.

The arithmetic itself is generated. What meets an ordinary array gives a double-double, and the array is taken as exact; what is
no arithmetic, comparison or choice is refused, so that no digit is lost unseen.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..generated import double_double

Array = NDArray[Any]
#: Its functions take whatever has a high and a low part.
dd: Any = double_double


class DoubleDouble:
    """Arrays of numbers of 106 bits, each the exact sum of two doubles, ``high`` nearest to the sum.

    Examples
    --------
    >>> third = 1 / DoubleDouble(np.array([3.0]))
    >>> float((third * 3 - 1).high[0])
    0.0
    >>> third.low != 0
    array([ True])
    """

    __slots__ = ("high", "low")

    def __init__(self, high: Any, low: Any = 0.0) -> None:
        self.high, self.low = np.asarray(high, dtype=np.float64), np.asarray(low, dtype=np.float64)

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the arrays."""
        return np.broadcast_shapes(self.high.shape, self.low.shape)

    @property
    def ndim(self) -> int:
        """Number of axes of the arrays."""
        return len(self.shape)

    def each(self, change: Callable[[Array], Array]) -> DoubleDouble:
        """A change of place or shape, of both parts."""
        return DoubleDouble(change(self.high), change(np.broadcast_to(self.low, self.shape)))

    def __getitem__(self, key: Any) -> DoubleDouble:
        return self.each(lambda part: np.asarray(part[key]))

    def __neg__(self) -> DoubleDouble:
        return DoubleDouble(-self.high, -self.low)

    def __abs__(self) -> DoubleDouble:
        return _of(dd.dd_absolute(self))

    def __add__(self, other: Any) -> DoubleDouble:
        if isinstance(other, DoubleDouble):
            return _of(dd.dd_add(self, other))
        return _of(dd.dd_add_double(self, other))

    __radd__ = __add__

    def __sub__(self, other: Any) -> DoubleDouble:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> DoubleDouble:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> DoubleDouble:
        if isinstance(other, DoubleDouble):
            return _of(dd.dd_multiply(self, other))
        if _is_power_of_two(other):
            return _of(dd.dd_scaled(self, float(other)))
        return _of(dd.dd_multiply_double(self, other))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> DoubleDouble:
        if _is_power_of_two(other):
            return _of(dd.dd_scaled(self, 1.0 / other))
        return _of(dd.dd_divide(self, _wide(other)))

    def __rtruediv__(self, other: Any) -> DoubleDouble:
        return _of(dd.dd_divide(_wide(other), self))

    def __lt__(self, other: Any) -> Array:
        return np.asarray(dd.dd_less(self, _wide(other)))

    def __gt__(self, other: Any) -> Array:
        return np.asarray(dd.dd_less(_wide(other), self))

    def __ge__(self, other: Any) -> Array:
        least = _wide(other)
        return np.asarray(dd.dd_less(least, self) | ((self.high == least.high) & (self.low == least.low)))

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        if method != "__call__" or options or ufunc not in _UFUNCS:
            return NotImplemented
        return _UFUNCS[ufunc](*inputs)

    def __array_function__(self, function: Any, types: Any, arguments: tuple[Any, ...], options: dict[str, Any]) -> Any:
        if options or function is not np.where:
            return NotImplemented
        return chosen_of(*arguments)


def _of(pair: double_double.Wide) -> DoubleDouble:
    """What an operation has made, as it is: its parts are floats already."""
    out = object.__new__(DoubleDouble)
    out.high, out.low = pair
    return out


def _wide(value: Any) -> DoubleDouble:
    """A double-double as it is, anything else as an exact number."""
    return value if isinstance(value, DoubleDouble) else DoubleDouble(value)


def _is_power_of_two(value: Any) -> bool:
    return isinstance(value, int | float) and math.frexp(abs(value))[0] == 0.5


def chosen_of(flag: Any, one: Any, other: Any) -> DoubleDouble:
    """The one where the flag is set, the other elsewhere."""
    return _of(dd.dd_where(flag, _wide(one), _wide(other)))


def _or_reversed(plain: Callable[[Any, Any], Any], reverse: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
    return lambda one, other: plain(one, other) if isinstance(one, DoubleDouble) else reverse(other, one)


def _square_root(value: DoubleDouble) -> DoubleDouble:
    return _of(dd.dd_sqrt(value))


_UFUNCS: dict[Any, Callable[..., Any]] = {
    np.add: _or_reversed(DoubleDouble.__add__, DoubleDouble.__radd__),
    np.subtract: _or_reversed(DoubleDouble.__sub__, DoubleDouble.__rsub__),
    np.multiply: _or_reversed(DoubleDouble.__mul__, DoubleDouble.__rmul__),
    np.true_divide: _or_reversed(DoubleDouble.__truediv__, DoubleDouble.__rtruediv__),
    np.less: _or_reversed(DoubleDouble.__lt__, DoubleDouble.__gt__),
    np.greater: _or_reversed(DoubleDouble.__gt__, DoubleDouble.__lt__),
    np.maximum: lambda one, other: _of(dd.dd_larger(_wide(one), _wide(other))),
    np.minimum: lambda one, other: _of(dd.dd_smaller(_wide(one), _wide(other))),
    np.absolute: DoubleDouble.__abs__,
    np.negative: DoubleDouble.__neg__,
    np.sqrt: _square_root,
}


def cosine_and_sine(angle: Array) -> tuple[DoubleDouble, DoubleDouble]:
    """cos and sin of doubles 0 < θ < π, exact to the last two bits or so."""
    both = dd.dd_cosine_and_sine(angle)
    return DoubleDouble(both.cosine_high, both.cosine_low), DoubleDouble(both.sine_high, both.sine_low)
