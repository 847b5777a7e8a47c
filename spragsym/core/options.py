"""Options of algorithms: frozen dataclasses of tolerances and limits, with a range for each
field.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, fields
from numbers import Integral, Real
from typing import Any

from .errors import ParameterError, ParameterTypeError
from .type_variables import T


def option(default: T, low: float, high: float = math.inf, kind: type = Real) -> T:
    """A field of options with values in [low, high]; the default is always allowed.

    Values are of the ``kind`` Real or Integral; tuples of these if the default is a tuple.
    """
    made: Callable[..., T] = field
    return made(default=default, metadata={"low": low, "high": high, "kind": kind})


def limit(default: T, low: int = 1, high: float = math.inf) -> T:
    """A field of options that is a whole number."""
    return option(default, low, high, Integral)


@dataclass(frozen=True)
class Options:
    """Base class of options; the fields are checked when they are set.

    Raises
    ------
    ParameterTypeError
        For a value that is no number, or no whole one where only these are allowed.
    ParameterError
        For a number out of its range.
    """

    def __post_init__(self) -> None:
        for option_field in fields(self):
            value = getattr(self, option_field.name)
            default = option_field.default
            is_default = type(value) is type(default) and value == default
            if option_field.metadata and not is_default:
                _check(
                    f"{type(self).__name__}: {option_field.name}",
                    value,
                    option_field.default,
                    **option_field.metadata,
                )


def _check(name: str, value: Any, default: object, low: float, high: float, kind: type) -> None:
    """Raise unless a value is of its kind and in its range."""
    remedy = "leave it out" if default is None else f"leave it out for {default}"
    if isinstance(default, tuple):
        if not isinstance(value, tuple) or not value:
            raise ParameterTypeError(f"{name} = {value!r:.60} is no tuple of numbers; {remedy}")
        for i, each in enumerate(value):
            _check(f"{name}[{i}]", each, None, low, high, kind)
        return
    is_of_kind = isinstance(value, kind) and not isinstance(value, bool)
    if not is_of_kind:
        what = "whole number" if kind is Integral else "number"
        raise ParameterTypeError(f"{name} = {value!r:.60} is no {what}; {remedy}")
    if not low <= value <= high:
        end = f"{low:g} or more" if math.isinf(high) else f"in [{low:g}, {high:g}]"
        raise ParameterError(f"{name} = {value!r:.60} is not {end}; {remedy}")
