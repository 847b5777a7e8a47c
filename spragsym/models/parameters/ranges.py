"""Validation of arguments: numbers and arrays of numbers within a range."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...errors import ParameterError, ParameterTypeError
from ...numerics.interval_arrays import BoolArray, FloatArray

#: How far inside an end that a range does not hold a value is taken, over its length.
INSIDE = 2.0**-40


@dataclass(frozen=True)
class Range:
    """Allowed values of an argument."""

    low: float
    high: float = math.inf
    open_low: bool = False
    remedy: str = ""
    closed_high: bool = False

    def contains(self, value: float) -> bool:
        """Whether a number is allowed."""
        above = value > self.low if self.open_low else value >= self.low
        return math.isfinite(value) and above and (value <= self.high if self.closed_high else value < self.high)

    def reached(self, end: float, length: float = 1.0) -> float:
        """An end, or a value next to it where the range does not hold it, by the length of what is searched."""
        if self.contains(end):
            return end
        return end + INSIDE * length * (1 if end <= self.low else -1)

    def inside(self, values: FloatArray) -> BoolArray:
        """Where numbers are allowed."""
        above = values > self.low if self.open_low else values >= self.low
        below = values <= self.high if self.closed_high else values < self.high
        return np.isfinite(values) & above & below

    def __str__(self) -> str:
        low = "(" if self.open_low or math.isinf(self.low) else "["
        return f"{low}{_bound(self.low)}, {_bound(self.high)}{']' if self.closed_high else ')'}"


def shown(value: float) -> str:
    """The shortest decimal that reads back as the same number, whole numbers without a point: ``-0.3``, ``200``."""
    return repr(float(value)).removesuffix(".0")


def _bound(value: float) -> str:
    named = {math.pi: "pi", math.pi / 2: "pi/2", -math.pi: "-pi", -math.pi / 2: "-pi/2"}
    return named.get(value) or shown(value)


POSITIVE = Range(0.0, open_low=True)
NOT_NEGATIVE = Range(0.0)
FINITE = Range(-math.inf)


def as_numbers(name: str, value: ArrayLike, allowed: Range = FINITE) -> FloatArray:
    """``value`` as a float64 array of any shape, or an error that names the argument.

    Texts, booleans, complex numbers, objects, ragged lists, masked values, units and named dimensions are a ParameterTypeError;
    NaN, infinities and numbers out of range a ParameterError.
    """
    if type(value) is float and allowed.contains(value):  # most are
        single: FloatArray = np.array(value)
        single.setflags(write=False)
        return single
    _check_plain(name, value)
    if isinstance(value, np.ma.MaskedArray):
        if np.ma.is_masked(value):
            raise ParameterTypeError(
                f"{name} has {int(np.ma.getmaskarray(value).sum())} masked values, and a masked value has no equilibria; "
                f"use {name}.compressed(), or {name}.filled(...) with a number"
            )
        value = value.data
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ParameterTypeError(f"{name} is not an array of numbers ({error}); give one number or a regular array") from error
    if array.dtype.kind not in "iuf":
        raise ParameterTypeError(
            f"{name} = {_short(value)} is of type {array.dtype}; it must be real numbers, not {_kind(array)}"
        )
    array = array.astype(np.float64)
    inside = allowed.inside(array)
    if not inside.all():
        index = tuple(int(i) for i in np.argwhere(~inside)[0]) if array.ndim else ()
        place = f"{name}[{', '.join(map(str, index))}]" if index else name
        more = int(np.count_nonzero(~inside)) - 1
        raise ParameterError(
            f"{place} = {shown(array[index].item())} is not in {allowed}"
            + (f", nor are {more} more of its values" if more else "")
            + (f": {allowed.remedy}" if allowed.remedy else "")
        )
    array.setflags(write=False)
    return array


def _check_plain(name: str, value: object) -> None:
    """No units and no named dimensions, which an array would lose without a word."""
    unit = str(getattr(value, "units", getattr(value, "unit", "")))
    if unit not in ("", "dimensionless", "radian", "rad") and hasattr(value, "magnitude" if hasattr(value, "units") else "value"):
        raise ParameterTypeError(
            f"{name} is in {unit}, and units are not converted here; give its number in one system of units, angles in radians"
        )
    dimensions = getattr(value, "dims", ())
    if dimensions and hasattr(value, "values"):
        raise ParameterTypeError(
            f"{name} has the dimensions {', '.join(map(str, dimensions))}, and arrays broadcast by their shapes here; give "
            f"{name}.values, or xarray.broadcast(...) first"
        )


def as_number(name: str, value: ArrayLike, allowed: Range = FINITE) -> float:
    """``value`` as one float; as :func:`as_numbers`, and an error for anything but a single number."""
    array = as_numbers(name, value, allowed)
    if array.ndim:
        raise ParameterTypeError(f"{name} has the shape {array.shape}; one number is needed here")
    return float(array)


def as_count(name: str, value: object, least: int = 1) -> int:
    """``value`` as an integer of at least so much."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or value < least:
        raise ParameterError(f"{name} = {value!r} is not an integer of {least} or more")
    return int(value)


def _short(value: object) -> str:
    text = repr(value)
    return text if len(text) <= 40 else text[:37] + "..."


def _kind(array: NDArray[Any]) -> str:
    return {"U": "text", "S": "bytes", "b": "booleans", "c": "complex numbers", "O": "objects or ragged lists"}.get(
        array.dtype.kind, str(array.dtype)
    )


def degrees(angle: float) -> float:
    """An angle in degrees: the shortest number that is the same in radians, so that what was given in degrees comes back.

    Examples
    --------
    >>> math.degrees(math.radians(30.0)), degrees(math.radians(30.0))
    (29.999999999999996, 30.0)
    """
    value = math.degrees(angle)
    candidates = (float(f"{value:.{digits}g}") for digits in (14, 15, 16))
    return next((candidate for candidate in candidates if math.radians(candidate) == angle), value)
