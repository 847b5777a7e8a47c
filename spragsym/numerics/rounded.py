"""Arrays of float64 with a proved bound on the error of each number: many points at once, for signs that must not be wrong.

A :class:`Rounded` stands for every number within ``error`` of ``value``. What generated algebra makes of them is again right:
each operation adds what it rounds. A sign that the bound leaves open is 0, and its point goes to
:mod:`spragsym.numerics.balls`.
"""

from __future__ import annotations

from typing import Any, TypeVar

import numpy as np

from .arithmetic import Arithmetic
from .interval_arrays import FUNCTION_ULPS, Int8Array

_Number = TypeVar("_Number")

#: Half a unit in the last place, relative.
UNIT = 2.0**-53
#: What an error bound itself may lose by the roundings of one operation, and the underflow of a product.
_SLACK, _TINY = 1.0 + 2.0**-49, 1e-320


def repeated_product(self: _Number, power: int) -> _Number:
    """A positive power, one product after the other: the ``__pow__`` of types for which only small powers occur."""
    result: Any = self
    for _ in range(power - 1):
        result = result * self
    return result


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


def cosine_and_sine(angle: Any) -> tuple[Rounded, Rounded]:
    """Cosine and sine of angles that are exact, with the error that NumPy's functions are taken to have."""
    cosine, sine = (Rounded(value, 2 * FUNCTION_ULPS * UNIT * abs(value) + _TINY) for value in (np.cos(angle), np.sin(angle)))
    return cosine, sine
