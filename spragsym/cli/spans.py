"""Ranges as typed: ``--vary NAME=FROM:TO``, with a number of values ``NAME=FROM:TO:COUNT``; ``--within NAME=FROM:TO``."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import click
import numpy as np
from click.core import ParameterSource

from ..errors import ParameterError
from ..models.parameter_class import options_of
from ..models.parameters import FloatArray, shown

if TYPE_CHECKING:
    from .of_model import Case

F = TypeVar("F", bound=Callable[..., Any])

#: Values from one end to the other, unless told otherwise; and how far an end may be, in the model's units.
COUNT, LARGEST = 11, 1e6


@dataclass(frozen=True)
class Typed:
    """What varies, as it was typed; numbers that were left out are None."""

    text: str
    name: str
    low: float | None = None
    high: float | None = None
    count: int | None = None


class Vary(click.ParamType):  # type: ignore[type-arg,unused-ignore]  # generic in some versions of click
    """``NAME``, ``NAME=FROM:TO`` or ``NAME=FROM:TO:COUNT``."""

    name = "range"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Typed:
        if isinstance(value, Typed):
            return value
        name, sign, rest = value.partition("=")
        numbers = rest.split(":")
        try:
            if sign and len(numbers) not in (2, 3):
                raise ValueError
            low, high = map(float, numbers[:2]) if sign else (None, None)
            count = int(numbers[2]) if len(numbers) == 3 else None
        except ValueError:
            self.fail(f"{value!r} is neither a name nor a range; give it as mu0=0:1, or with values as mu0=0:1:11", param, ctx)
        if count is not None and not 2 <= count <= 100_000:
            self.fail(f"{value!r}: values with both ends are 2 to 100000", param, ctx)
        if low is not None and low == high:
            self.fail(f"{value!r}: both ends are {shown(low)}; give two values", param, ctx)
        return Typed(value, name, low, high, count)


def vary(text: str, multiple: bool = False) -> Callable[[F], F]:
    """``--vary``, of one parameter or of several."""
    return click.option("--vary", type=Vary(), metavar="NAME[=FROM:TO]", multiple=multiple, help=text)


def within(function: F) -> F:
    """``--within``."""
    text = "Range of a coordinate to search, as {coordinate}=-5:5, in place of the model's own; angles in degrees. Repeatable."
    return click.option("--within", type=Vary(), multiple=True, metavar="NAME=FROM:TO", help=text)(function)


@dataclass(frozen=True)
class Span:
    """A parameter that varies, with what one of it is in the answer, and what it is called there; ends in radians, if given."""

    name: str
    unit: float
    title: str
    ends: tuple[float, float] | None
    count: int

    @property
    def between(self) -> dict[str, tuple[float, float]]:
        """The ends as a search takes them, the smaller first."""
        return {} if self.ends is None else {self.name: (min(self.ends), max(self.ends))}

    @property
    def values(self) -> FloatArray:
        """Values from one end to the other."""
        assert self.ends is not None  # asked for where it is needed
        low, high = (self.unit * end for end in self.ends)
        return np.linspace(low, high, self.count) / self.unit


def span(case: Case, typed: Typed | None, default: str, values: bool = False, begins: bool = False) -> Span:
    """What varies, by default a parameter whose whole range is meant; with ``values``, both ends are values themselves.

    With a range it has no value besides, unless it ``begins`` there.
    """
    typed = typed or Typed(default, default)
    name, unit, title = case.units.varied(typed.name)
    asked = typed.low is not None and not begins
    if asked and click.get_current_context().get_parameter_source(name) == ParameterSource.COMMANDLINE:
        flag = options_of(case.model.about, name)[0]
        raise ParameterError(f"{flag} gives {name} a value, and --vary {typed.text} varies it; leave one of the two out")
    allowed = case.model.Parameters.ranges[name]
    if typed.low is None or typed.high is None:
        return Span(name, unit, title, None, typed.count or COUNT)
    for end in (typed.low, typed.high):
        value = end / unit
        inside = allowed.contains(value) if values else allowed.low <= value <= allowed.high
        if inside and abs(value) > LARGEST:
            raise ParameterError(f"--vary {typed.text}: {title} = {end:g} is too far; give at most {LARGEST * unit:g} in size")
        if not inside:
            ends = case.model.Parameters.ranges[name] if name not in case.model.about["angles"] else _in_degrees(allowed)
            own = "" if name in case.model.about["angles"] or unit == 1 else f" is {name} = {value:g}, which"
            raise ParameterError(f"--vary {typed.text}: {title} = {end:g}{own} is not in {ends}")
    return Span(name, unit, title, (typed.low / unit, typed.high / unit), typed.count or COUNT)


def _in_degrees(allowed: Any) -> str:
    low, high = (shown(math.degrees(end)) for end in (allowed.low, allowed.high))
    return f"{'(' if allowed.open_low else '['}{low}, {high}{']' if allowed.closed_high else ')'}"


def box(case: Case, texts: Iterable[Typed]) -> dict[str, tuple[float, float]] | None:
    """Ranges of coordinates by name."""
    found = {}
    for typed in texts:
        if typed.low is None or typed.high is None:
            raise ParameterError(f"--within {typed.text} is no range; give it as {case.model.coordinates[0]}=0:1")
        unit = case.units.place(typed.name)[1] if typed.name in case.model.coordinates else 1.0
        found[typed.name] = (typed.low / unit, typed.high / unit)
    return found or None
