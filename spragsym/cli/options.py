"""Options that commands share: one name, one meaning and one range everywhere."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any, TypeVar

import click
import numpy as np

from ..errors import ParameterError
from ..models.parameters import FINITE, NOT_NEGATIVE, POSITIVE, FloatArray, Range, as_number, as_numbers

F = TypeVar("F", bound=Callable[..., Any])

#: Numbers of an axis.
MOST = 1_000_000


class Number(click.ParamType):  # type: ignore[type-arg,unused-ignore]  # generic in some versions of click
    """A number in a range; an error names the option as it is typed."""

    name = "float"

    def __init__(self, allowed: Range = FINITE) -> None:
        self.allowed = allowed

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        try:
            number = float(value)
        except ValueError:
            self.fail(f"{value!r} is not a number", param, ctx)
        return as_number(_flag(param), number, self.allowed)


class Axis(click.ParamType):  # type: ignore[type-arg,unused-ignore]  # generic in some versions of click
    """Numbers ``a,b,c``, or ``start:stop:count`` for equal steps, ends included; each in a range."""

    name = "numbers"

    def __init__(self, allowed: Range = FINITE) -> None:
        self.allowed = allowed

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> FloatArray:
        if re.fullmatch(r"\s*[+-]?(0,\d+|\d+,0\d+)\s*", str(value)):
            self.fail(
                f"{value!r} may be one number or two; write {value.replace(',', '.')}, or {value.replace(',', '.0,')}", param, ctx
            )
        try:
            numbers = self._numbers(str(value))
        except ValueError:
            self.fail(f"{value!r} is neither numbers like 0.2,0.5 nor start:stop:count like 30:60:61", param, ctx)
        if numbers is None:
            self.fail(f"{value!r}: equal steps with both ends are 2 to {MOST} numbers; for one give it alone", param, ctx)
        as_numbers(_flag(param), numbers if numbers.size > 1 else numbers[0], self.allowed)
        return numbers

    def _numbers(self, text: str) -> FloatArray | None:
        if ":" not in text:
            return np.array([float(number) for number in text.split(",")])
        start, stop, count = text.split(":")
        with np.errstate(all="ignore"):  # an infinite end, which the range refuses
            return np.linspace(float(start), float(stop), int(count)) if 1 < int(count) <= MOST else None


class Numbers(Number):
    """A number, or numbers as :class:`Axis` takes them."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        if isinstance(value, str) and ("," in value or ":" in value):
            return Axis(self.allowed).convert(value, param, ctx)
        return super().convert(value, param, ctx)


class Workers(click.ParamType):  # type: ignore[type-arg,unused-ignore]  # generic in some versions of click
    """A number of processes, or -1 for one per core."""

    name = "integer"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> int:
        try:
            count = int(value)
        except ValueError:
            self.fail(f"{value!r} is not a number of processes", param, ctx)
        if count < 1 and count != -1:
            raise ParameterError(f"{_flag(param)} {count} is not a number of processes; give 1 or more, or -1 for one a core")
        return count


def _flag(param: click.Parameter | None) -> str:
    """The option by its long name."""
    return "value" if param is None else max(param.opts, key=len)


def window(function: F) -> F:
    """``--t-end --transient``: until when a motion is integrated, and from when on it is measured."""
    text = "What to leave out of RMS, largest displacement and period. Default: three quarters of --t-end."
    function = click.option("--transient", type=Number(NOT_NEGATIVE), help=text)(function)
    text = "Until when, in {time}; with --data in seconds, as --transient."
    return click.option("--t-end", type=Number(POSITIVE), default=2000.0, show_default=True, help=text)(function)


def integrator(*names: str) -> Callable[[F], F]:
    """``--backend``: of those that a command can use, the first that is there."""
    text = f"Integrator. Default: the first of {', '.join(names)} that is installed."
    return click.option("--backend", type=click.Choice(names), help=text)


def workers(default: int) -> Callable[[F], F]:
    """``-j --workers``."""
    text = "Processes; -1 for one a core."
    return click.option("--workers", "-j", type=Workers(), default=default, show_default=True, help=text)


def as_json(function: F) -> F:
    """``--json``."""
    return click.option("--json", "json_output", is_flag=True, help="Print JSON instead of a table.")(function)
