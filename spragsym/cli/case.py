"""The case of a command about a model: its parameters, the ranges that vary, and the units of the
answer, degrees or those of a file.
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
from ..numerics.decimals import upward
from ..results import Equilibria
from ..results.result import titled
from .output import Formats, is_typed

if TYPE_CHECKING:
    from ..report.study import Study

#: A row of JSON or a table, by column.
Row: TypeAlias = dict[str, Any]
#: The title of a column, and the factor from the model's unit to that of the answer.
Titled: TypeAlias = tuple[str, float]


@dataclass(frozen=True)
class Span:
    """A range of --vary, --within or --over.

    As parsed, ``name`` and ``ends`` are as typed. In a case, ``name`` is a parameter and ``ends``
    are in the model's units.
    """

    typed: str
    name: str
    ends: tuple[float, float] | None = None
    count: int = 11  #: number of values
    unit: float = 1.0  #: factor from the model's unit to that of the answer
    title: str = ""  #: title of the parameter in the answer

    @property
    def values(self) -> FloatArray:
        """Equally spaced values from one end to the other, in units of the model."""
        assert self.ends is not None
        low, high = (self.unit * end for end in self.ends)
        return np.linspace(low, high, self.count) / self.unit


@dataclass(frozen=True)
class Case:
    """What a command about a model is asked, and the units of its answer."""

    model: Model
    study: Study | None = None  #: the data of --data, whose units the answer has
    #: the parameters, in radians; None for one without value and base value
    values: Mapping[str, Any] = field(default_factory=dict)
    start: Mapping[str, Any] = field(default_factory=dict)  #: the initial state, as ``x0``
    ask: Mapping[str, Any] = field(default_factory=dict)  #: arguments of every question
    spans: tuple[Span, ...] = ()  #: the parameters that vary

    def set(self, *spanned: str, **changes: Any) -> ParameterSet:
        """The set of parameters with changes; those in ``spanned`` need no value."""
        values = {**self.values, **changes}
        self.require(values, spanned)
        model = self.model.search if self.ask.get("method") == "search" else self.model
        return model.Parameters(**values)

    def require(self, values: Mapping[str, Any], spanned: Sequence[str] = ()) -> None:
        """Raise for the first parameter without a value, unless it varies; the error names its
        option.
        """
        for name, value in values.items():
            if value is not None or name in spanned:
                continue
            flag = options_of(self.model.about, name)[0]
            number = "DEGREES" if self.model.is_angle(name) else "NUMBER"
            varying = f" while {' and '.join(self.names)} varies" if self.spans else ""
            raise click.UsageError(
                f"{flag} has no value{varying}, and {self.model.name} no usual one; give "
                f"{flag} {number}"
            )

    @property
    def between(self) -> Ranges:
        """The given ranges of parameters that vary, the smaller end first."""
        return {span.name: (min(span.ends), max(span.ends)) for span in self.spans if span.ends}

    def searching(self, *names: str) -> dict[str, Any]:
        """Arguments of a question for points: the method, and the given ranges of these names."""
        return {
            **self.ask,
            "between": {name: ends for name, ends in self.between.items() if name in names} or None,
        }

    @property
    def span(self) -> Span:
        """The first range."""
        return self.spans[0]

    @property
    def names(self) -> tuple[str, ...]:
        """The parameters that vary."""
        return tuple(span.name for span in self.spans)

    def require_ends(self) -> None:
        """Raise if the first range has no ends."""
        if not self.spans or self.span.ends is None:
            typed = self.span.typed if self.spans else self.model.axes[-1]
            raise click.UsageError(
                f"--vary {typed}: from where to where? Give it as {typed}=FROM:TO"
            )

    def parameter_row(self) -> Row:
        """The parameters in units of the answer, by title."""
        titles = ((*self.parameter(name), value) for name, value in self.values.items())
        return {title: None if value is None else unit * value for title, unit, value in titles}

    def parameter(self, name: str) -> Titled:
        """The title of a parameter, and the factor to its unit."""
        return self._titled(name, "rad" if self.model.is_angle(name) else "1")

    def boxes(self, boxes: Iterable[Any], names: Sequence[str], **about: Any) -> list[Row]:
        """Rows of undecided boxes with their ends, in units of the answer."""
        return [{**about, **self.row(dict(zip(names, box, strict=True)))} for box in boxes]

    def following(self, p: ParameterSet, near: Sequence[str]) -> ParameterSet:
        """The set of parameters that follows the state of ``--state``, if one is given."""
        units_of, chosen = {name: self.of(name)[1] for name in self.model.coordinates}, {}
        for word in near:
            name, _, value = word.partition("=")
            try:
                chosen[name] = as_number(name, float(value)) / units_of[name]
            except (KeyError, ValueError) as error:
                raise click.UsageError(
                    f"--state {word}: give NAME=VALUE, NAME one of {', '.join(units_of)}"
                ) from error
        return p.following(**chosen) if chosen else p

    def spanning(self, span: Span, values: bool, alone: bool) -> Span:
        """A range in units of the model, from one as typed.

        With ``values`` both ends must be allowed values. With ``alone`` the parameter must not have
        a value as well.

        Raises
        ------
        ParameterError
            If an end is not allowed.
        """
        name, title, unit = self.varied(span.name)
        of_parameter = replace(span, name=name, unit=unit, title=title)
        if span.ends is None:
            return of_parameter
        if alone and is_typed(option_name(name)):
            flag = options_of(self.model.about, name)[0]
            raise ParameterError(
                f"{flag} gives {name} a value, and --vary {span.typed} varies it; leave one "
                "of the two out"
            )
        allowed, angle = self.model.Parameters.ranges[name], self.model.is_angle(name)
        largest = 1e6  # size of an end, in units of the model
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
        return replace(of_parameter, ends=(low / unit, high / unit))

    def box(self, spans: Sequence[Span]) -> Ranges:
        """Ranges of coordinates by name, in units of the model."""
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
        """The quantities of the model."""
        return quantities(self.model.where)

    @property
    def quantity_of(self) -> dict[str, str]:
        """The quantity of a file for each parameter."""
        return {name: quantity for quantity, name in self.kind.parameters.items()}

    @property
    def time(self) -> float:
        """The model's unit of time in seconds with a file, else 1."""
        return 1.0 if self.study is None else self.study.scales.time

    def of(self, name: str, kind: type = Equilibria, end: str = "") -> Titled:
        """The title of a column of a class of results, and the factor to its unit.

        Angles are in degrees, their rates are not.
        """
        for span in self.spans:
            if span.name == name:
                return span.title, span.unit
        columns = columns_of_class(kind, self.model)
        dimension = columns[name].dimension if name in columns else "1"
        return self._titled(name + end, dimension)

    def row(self, values: Mapping[str, Any], kind: type = Equilibria, end: str = "") -> Row:
        """Columns of a class of results in units of the answer, by title; codes are words."""
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
        """Rows of columns of one length; ``more`` are columns without units."""
        named_by_page = {own_name(self.model, name): values for name, values in more.items()}
        titled_columns = {**self.row(columns, kind), **named_by_page}
        return [
            dict(zip(titled_columns, row, strict=True))
            for row in zip(*titled_columns.values(), strict=True)
        ]

    def varied(self, name: str) -> tuple[str, str, float]:
        """The parameter that is meant by a name of --vary, its title, and the factor to its unit.

        With a file the name may be that of a quantity.
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
        """The title of an axis of a figure, and the factor to its unit.

        None without a file, and for angles, which figures show in degrees anyway.
        """
        if self.study is None or self.model.is_angle(name):
            return None
        from ..figures.style import symbol

        quantity, si = self.quantity_of.get(name, ""), self.model.columns[name].dimension
        unit, size = ("", 1.0) if si == "1" else self.study.unit_of(si, quantity)
        return f"{before}${symbol(quantity or name)}${f' ({unit})' if unit else ''}{after}", size

    @property
    def formats(self) -> Formats:
        """How tables write bounds, two digits that are rounded up, and growth rates, two digits."""
        error, growth = (self.of(own_name(self.model, name))[0] for name in ("error", "growth"))
        return {error: upward, growth: "{:.1e}".format}

    def without_beside(self, row: Row, kind: type) -> Row:
        """A row without the columns of a class of results that stand in no table."""
        columns = columns_of_class(kind, self.model).items()
        left_out = {self.of(name, kind)[0] for name, each in columns if each.row == "beside"}
        return {title: value for title, value in row.items() if title not in left_out}

    def said(self, remarks: Iterable[str]) -> list[str]:
        """Remarks with their numbers in the units of the file."""
        return [str(text) if self.study is None else self.study.said(text) for text in remarks]

    def _titled(self, title: str, si: str, quantity: str = "") -> Titled:
        """A title with its unit, and the factor from the model's unit to it."""
        return titled(title, si, self.study, quantity)


def _scaled(value: object, size: float) -> Any:
    """A value or an array times a factor, as numbers and lists; a complex number as two parts."""
    array = np.asarray(value)
    if array.dtype.kind == "c":
        array = np.stack([array.real, array.imag], axis=-1)
    return (size * array if array.dtype.kind == "f" else array).tolist()


def in_degrees(allowed: Range, remedy: str = "") -> Range:
    """A range of an angle in degrees."""
    return replace(
        allowed, low=math.degrees(allowed.low), high=math.degrees(allowed.high), remedy=remedy
    )


def study_of(
    path: str | Path, model: str | None, *, trust: bool | None = None, warn: bool = True
) -> Study:
    """Read the data of a brake; warns of numbers that may be mistaken.

    Raises
    ------
    ParameterError
        If the command names a model that the file is not about.
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
