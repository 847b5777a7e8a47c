"""What a command about a model is about: parameters, what varies, and the units of the answer,
degrees or those of a file.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import click
import numpy as np

from ..command_line import option_name, options_of
from ..core.errors import ParameterError, hint
from ..display import columns_of_class, own_name
from ..models.model import Model
from ..models.parameters import FloatArray, ParameterSet, Range, Ranges, as_number
from ..models.quantities import Quantities, quantities
from ..results import Equilibria
from ..results.result import titled
from .output import is_typed

if TYPE_CHECKING:
    from ..report.study import Study

#: What JSON and a table say of one thing, by its columns; a title, and what one of the model's own
#: units is there.
Row: TypeAlias = dict[str, Any]
Titled: TypeAlias = tuple[str, float]


@dataclass(frozen=True)
class Span:
    """Range of what varies, as it was typed; of a case a parameter, with what one of it is in the
    answer, and what it is called there.

    Its ends, if given, are as typed, and of a case the model's own.
    """

    typed: str
    name: str
    ends: tuple[float, float] | None = None
    #: Values from one end to the other.
    count: int = 11
    unit: float = 1.0
    title: str = ""

    @property
    def values(self) -> FloatArray:
        """Values from one end to the other."""
        assert self.ends is not None  # asked for where it is needed
        low, high = (self.unit * end for end in self.ends)
        return np.linspace(low, high, self.count) / self.unit


@dataclass(frozen=True)
class Case:
    """Subject of a command, and the units of its answer.

    ``values`` of its parameters are radians, None for those that were not given and have no base
    value; ``start`` is the initial state, ``x0`` and the like, as the model takes it; ``ask`` goes
    with every question to the model; ``spans`` vary.
    """

    model: Model
    study: Study | None = None
    values: Mapping[str, Any] = field(default_factory=dict)
    start: Mapping[str, Any] = field(default_factory=dict)
    ask: Mapping[str, Any] = field(default_factory=dict)
    spans: tuple[Span, ...] = ()

    def set(self, *spanned: str, **changes: Any) -> ParameterSet:
        """The parameters; those that vary need no value."""
        values = {**self.values, **changes}
        self.require(values, spanned)
        return (self.model.search if self.ask.get("method") == "search" else self.model).Parameters(
            **values
        )

    def require(self, values: Mapping[str, Any], spanned: Sequence[str] = ()) -> None:
        """An error that names the option of a parameter that has no value, and is not one of those
        that vary.
        """
        for name in (
            name for name, value in values.items() if value is None and name not in spanned
        ):
            flag = options_of(self.model.about, name)[0]
            number = "DEGREES" if self.model.is_angle(name) else "NUMBER"
            varying = f" while {' and '.join(self.names)} varies" if self.spans else ""
            raise click.UsageError(
                f"{flag} has no value{varying}, and {self.model.name} no usual one; give "
                f"{flag} {number}"
            )

    @property
    def between(self) -> Ranges:
        """Ranges of what varies, where they were given, the smaller end first."""
        return {span.name: (min(span.ends), max(span.ends)) for span in self.spans if span.ends}

    def searching(self, *names: str) -> dict[str, Any]:
        """Arguments by which points are asked for: the method, and ranges of what varies and of
        coordinates where they were given.
        """
        return {
            **self.ask,
            "between": {name: ends for name, ends in self.between.items() if name in names} or None,
        }

    @property
    def span(self) -> Span:
        """The first that varies."""
        return self.spans[0]

    @property
    def names(self) -> tuple[str, ...]:
        """The parameters that vary."""
        return tuple(span.name for span in self.spans)

    def require_ends(self) -> None:
        """An error for a range that is missing."""
        if not self.spans or self.span.ends is None:
            typed = self.span.typed if self.spans else self.model.axes[-1]
            raise click.UsageError(
                f"--vary {typed}: from where to where? Give it as {typed}=FROM:TO"
            )

    def parameter_row(self) -> Row:
        """The parameters, angles in degrees."""
        titles = ((*self.parameter(name), value) for name, value in self.values.items())
        return {title: None if value is None else unit * value for title, unit, value in titles}

    def parameter(self, name: str) -> Titled:
        """Title of a parameter, and what one of it is there."""
        return self._titled(name, "rad" if self.model.is_angle(name) else "1")

    def boxes(self, boxes: Iterable[Any], names: Sequence[str], **about: Any) -> list[Row]:
        """Boxes that are not decided, each with the ends of what it says, in the units of the
        answer.
        """
        return [{**about, **self.row(dict(zip(names, box, strict=True)))} for box in boxes]

    def following(self, p: ParameterSet, near: Sequence[str]) -> ParameterSet:
        """A set of parameters that follows the state that ``--state`` chose, if it did."""
        ones, chosen = {name: self.of(name)[1] for name in self.model.coordinates}, {}
        for word in near:
            name, _, value = word.partition("=")
            try:
                chosen[name] = as_number(name, float(value)) / ones[name]
            except (KeyError, ValueError) as error:
                raise click.UsageError(
                    f"--state {word}: give NAME=VALUE, NAME one of {', '.join(ones)}"
                ) from error
        return p.following(**chosen) if chosen else p

    def spanning(self, span: Span, values: bool, alone: bool) -> Span:
        """Ranges of what varies, from what was typed; with ``values``, both ends are values
        themselves.

        Where it stands ``alone`` a range has no value besides.
        """
        name, title, unit = self.varied(span.name)
        found = replace(span, name=name, unit=unit, title=title)
        if span.ends is None:
            return found
        if alone and is_typed(option_name(name)):
            flag = options_of(self.model.about, name)[0]
            raise ParameterError(
                f"{flag} gives {name} a value, and --vary {span.typed} varies it; leave one "
                "of the two out"
            )
        allowed, angle = self.model.Parameters.ranges[name], self.model.is_angle(name)
        # How far an end may be, in the model's units.
        largest = 1e6
        for end in span.ends:
            value = end / unit
            if abs(value) > largest and allowed.low <= value <= allowed.high:
                raise ParameterError(
                    f"--vary {span.typed}: {title} = {end:g} is too far; give at most "
                    f"{largest * unit:g} in size"
                )
            if not (allowed.contains(value) if values else allowed.low <= value <= allowed.high):
                own = "" if angle or unit == 1 else f" is {name} = {value:g}, which"
                limits = in_degrees(allowed) if angle else allowed
                raise ParameterError(
                    f"--vary {span.typed}: {title} = {end:g}{own} is not in {limits}"
                )
        low, high = span.ends
        return replace(found, ends=(low / unit, high / unit))

    def box(self, spans: Sequence[Span]) -> Ranges:
        """Ranges of coordinates by name."""
        found = {}
        for span in spans:
            if span.ends is None:
                raise ParameterError(
                    f"--within {span.typed} is no range; give it as {self.model.coordinates[0]}=0:1"
                )
            unit, (low, high) = self.of(span.name)[1], span.ends
            found[span.name] = (low / unit, high / unit)
        return found

    @property
    def kind(self) -> Quantities:
        """The quantities of its model."""
        return quantities(self.model.where)

    @property
    def quantity_of(self) -> dict[str, str]:
        """Of each parameter the quantity of a file that it is."""
        return {name: quantity for quantity, name in self.kind.parameters.items()}

    @property
    def time(self) -> float:
        """Unit of time in the answer: seconds, with a file."""
        return 1.0 if self.study is None else self.study.scales.time

    def of(self, name: str, kind: type = Equilibria, end: str = "") -> Titled:
        """The title of a column of a class of results, and what one of the model's own units is,
        printed or typed.

        Angles are degrees, their rates are not.
        """
        for span in self.spans:
            if span.name == name:
                return span.title, span.unit
        columns = columns_of_class(kind, self.model)
        dimension = columns[name].dimension if name in columns else "1"
        return self._titled(name + end, dimension)

    def row(self, values: Mapping[str, Any], kind: type = Equilibria, end: str = "") -> Row:
        """Columns of a class of results, each under the name that says its unit, codes as words."""
        columns, found = columns_of_class(kind, self.model), {}
        for name, value in values.items():
            title, size = self.of(name, kind, end)
            codes = columns[name].codes if name in columns else None
            if codes is not None:
                found[title] = [codes(code).name.lower() for code in value]
            else:
                found[title] = _scaled(value, size)
        return found

    def rows(
        self,
        columns: Mapping[str, Any],
        kind: type = Equilibria,
        **more: Sequence[Any] | FloatArray,
    ) -> list[Row]:
        """Rows of columns of one length, and of those that have no unit."""
        own = {own_name(self.model, name): values for name, values in more.items()}
        titled_columns = {**self.row(columns, kind), **own}
        return [
            dict(zip(titled_columns, row, strict=True))
            for row in zip(*titled_columns.values(), strict=True)
        ]

    def varied(self, name: str) -> tuple[str, str, float]:
        """A parameter, or with a file its quantity: the parameter, its title, and what one of it is
        there.
        """
        kind = self.kind
        if name in self.model.parameters and (
            self.study is None or kind.parameters.get(name) != name
        ):
            return name, *self.parameter(name)
        if name in kind.parameters:
            if self.study is None:
                cure = (
                    "without --data the parameters have no units; give --vary "
                    f"{kind.parameters[name]}"
                )
                raise ParameterError(f"--vary {name}: {cure}")
            return kind.parameters[name], *self._titled(name, kind.units[name], name)
        if name in kind.bases:
            raise ParameterError(
                f"--vary {name}: it is a unit of the model, and several parameters change "
                "with it; write a file for each value"
            )
        names = list(
            dict.fromkeys([*self.model.parameters, *(kind.parameters if self.study else ())])
        )
        raise click.UsageError(
            f"--vary: {name!r} is not one of {', '.join(names)}{hint(name, names)}"
        )

    def axis(self, name: str, before: str = "", after: str = "") -> Titled | None:
        """Title of an axis of a figure for a parameter or a coordinate, and what one of the model's
        own is there.

        None without a file, and of angles, which figures show in degrees.
        """
        if self.study is None or self.model.is_angle(name):
            return None
        from ..figures.style import symbol

        quantity, si = self.quantity_of.get(name, ""), self.model.columns[name].dimension
        unit, size = ("", 1.0) if si == "1" else self.study.unit_of(si, quantity)
        return f"{before}${symbol(quantity or name)}${f' ({unit})' if unit else ''}{after}", size

    def said(self, remarks: Iterable[str]) -> list[str]:
        """Remarks with what they say of parameters and coordinates in the units of the file."""
        return [str(text) if self.study is None else self.study.said(text) for text in remarks]

    def _titled(self, title: str, si: str, quantity: str = "") -> Titled:
        """A title with its unit, and what one of the model's own units is there."""
        return titled(title, si, self.study, quantity)


def _scaled(value: object, size: float) -> Any:
    """A value, or all of several, in a unit; a complex number as its two parts."""
    array = np.asarray(value)
    if array.dtype.kind == "c":
        array = np.stack([array.real, array.imag], axis=-1)
    return (size * array if array.dtype.kind == "f" else array).tolist()


def in_degrees(allowed: Range, remedy: str = "") -> Range:
    return replace(
        allowed, low=math.degrees(allowed.low), high=math.degrees(allowed.high), remedy=remedy
    )


def study_of(
    path: str | Path, model: str | None, *, trust: bool | None = None, warn: bool = True
) -> Study:
    """The data of a brake, for the model that the command names if it names one; with warnings of
    what numbers may mean.
    """
    from ..report.data import read_brake

    trust = is_typed("trust") if trust is None else trust
    study = read_brake(path, trust or model or False)
    if warn:
        study.with_warnings()
    plain = study.undamped().model
    if model not in (None, study.model, plain):
        raise ParameterError(f"--model {model}: {path} is about {plain}; leave one of the two out")
    return study
