"""Commands about a model: the parameters of the one that ``--model``, or the file of ``--data``, names are their options."""

from __future__ import annotations

import copy
import inspect
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np
from click.core import ParameterSource

from ..errors import ParameterError
from ..models import load
from ..models.load import USUAL
from ..models.model import options_of
from ..models.parameters import FloatArray, Range, degrees
from ..questions import has_closed_form
from . import options as o
from .output import drawable, print_json, refuse
from .units import Units

if TYPE_CHECKING:
    from ..models import Model
    from ..models.parameters import ParameterSet
    from ..report import Study

#: Values from one end of a range to the other, unless told otherwise; and how far an end may be, in the model's units.
COUNT, LARGEST = 11, 1e6


@dataclass(frozen=True)
class Span:
    """A parameter that varies, with what one of it is in the answer, and what it is called there; ends in radians, if given."""

    typed: str
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


@dataclass(frozen=True)
class Case(Units):
    """What a command is about, and in what units it answers.

    ``values`` of its parameters are radians, None for those that were not given and have no base value; ``start`` is the initial
    state, ``x0`` and the like, as the model takes it; ``ask`` goes with every question to the model; ``spans`` vary.
    """

    values: Mapping[str, Any] = field(default_factory=dict)
    start: Mapping[str, Any] = field(default_factory=dict)
    ask: Mapping[str, Any] = field(default_factory=dict)
    spans: tuple[Span, ...] = ()

    def set(self, *spanned: str, **changes: Any) -> ParameterSet:
        """The parameters; those that vary need no value."""
        values = {**self.values, **changes}
        self.require([name for name in values if name not in spanned and values[name] is None])
        return self.model.Parameters(**values)

    def require(self, missing: Sequence[str] | None = None) -> None:
        """An error that names the option of a parameter that has no value."""
        for name in [name for name, value in self.values.items() if value is None] if missing is None else missing:
            flag, number = options_of(self.model.about, name)[0], "DEGREES" if name in self.model.about["angles"] else "NUMBER"
            varying = f" while {' and '.join(span.name for span in self.spans)} varies" if self.spans else ""
            raise click.UsageError(f"{flag} has no value{varying}, and {self.model.name} no usual one; give {flag} {number}")

    def has_closed_form(self, question: Callable[..., Any], p: ParameterSet) -> bool:
        """Whether the model brings a closed form of a question, and it is not the search that is asked for."""
        return self.ask.get("method") != "search" and has_closed_form(question, p)

    @property
    def between(self) -> dict[str, tuple[float, float]]:
        """Ranges of what varies, where they were given."""
        return {name: ends for span in self.spans for name, ends in span.between.items()}

    def searching(self, *names: str) -> dict[str, Any]:
        """How points are asked for: the method, and ranges of what varies and of coordinates where they were given."""
        between = {name: ends for name, ends in self.between.items() if name in names}
        return {**self.ask, **({"between": between} if between else {})}

    @property
    def span(self) -> Span:
        """The first that varies."""
        return self.spans[0]

    def require_ends(self) -> None:
        """An error for a range that is missing."""
        if not self.spans or self.span.ends is None:
            typed = self.span.typed if self.spans else self.model.axes[-1]
            raise click.UsageError(f"--vary {typed}: from where to where? Give it as {typed}=FROM:TO")

    def of(self, name: str, end: str = "") -> tuple[str, float]:
        """What a column is called, and what one of it is in the answer: of what varies too."""
        for span in self.spans:
            if span.name == name and name not in self.model.coordinates:
                return span.title, span.unit
        return super().of(name, end)

    def told(self) -> dict[str, Any]:
        """The parameters, angles in degrees."""
        titles = ((*self.parameter(name), value) for name, value in self.values.items())
        return {title: None if value is None else unit * value for title, unit, value in titles}

    def parameter(self, name: str) -> tuple[str, float]:
        """What a parameter is called, and what one of it is there."""
        return (f"{name}_deg", math.degrees(1.0)) if name in self.model.about["angles"] else (name, 1.0)

    def boxes(self, boxes: Iterable[Any], names: Sequence[str], **about: Any) -> list[dict[str, Any]]:
        """Boxes that are not decided, each with the ends of what it says, in the units of the answer."""
        ends = ({name: tuple(map(float, pair)) for name, pair in zip(names, box, strict=True)} for box in boxes)
        return [{**about, **self.row(box)} for box in ends]

    def following(self, p: ParameterSet, near: Sequence[str]) -> ParameterSet:
        """A set of parameters that follows the state that ``--state`` chose, if it did."""
        chosen = {}
        for word in near:
            name, _, value = word.partition("=")
            try:
                chosen[name] = float(value) / self.state(name) if name in self.model.coordinates else math.nan
            except ValueError:
                chosen[name] = math.nan
            if not math.isfinite(chosen[name]):
                known = ", ".join(self.model.coordinates)
                raise click.UsageError(f"--state {word}: give NAME=VALUE, NAME one of {known}")
        return p.following(**chosen) if chosen else p

    def spanning(self, typed: o.Typed, values: bool, alone: bool) -> Span:
        """What varies as it was typed; with ``values``, both ends are values themselves.

        Where it stands ``alone`` a range has no value besides.
        """
        name, unit, title = self.varied(typed.name)
        asked = typed.low is not None and alone
        if asked and click.get_current_context().get_parameter_source(name) == ParameterSource.COMMANDLINE:
            flag = options_of(self.model.about, name)[0]
            raise ParameterError(f"{flag} gives {name} a value, and --vary {typed.text} varies it; leave one of the two out")
        allowed, count = self.model.Parameters.ranges[name], typed.count or COUNT
        if typed.low is None or typed.high is None:
            return Span(typed.name, name, unit, title, None, count)
        angle = name in self.model.about["angles"]
        for end in (typed.low, typed.high):
            value = end / unit
            if abs(value) > LARGEST and allowed.low <= value <= allowed.high:
                raise ParameterError(
                    f"--vary {typed.text}: {title} = {end:g} is too far; give at most {LARGEST * unit:g} in size"
                )
            if not (allowed.contains(value) if values else allowed.low <= value <= allowed.high):
                own = "" if angle or unit == 1 else f" is {name} = {value:g}, which"
                limits = _in_degrees(allowed) if angle else allowed
                raise ParameterError(f"--vary {typed.text}: {title} = {end:g}{own} is not in {limits}")
        return Span(typed.name, name, unit, title, (typed.low / unit, typed.high / unit), count)

    def box(self, texts: Sequence[o.Typed]) -> dict[str, tuple[float, float]]:
        """Ranges of coordinates by name."""
        found = {}
        for typed in texts:
            if typed.low is None or typed.high is None:
                raise ParameterError(f"--within {typed.text} is no range; give it as {self.model.coordinates[0]}=0:1")
            unit = self.of(typed.name)[1] if typed.name in self.model.coordinates else 1.0
            found[typed.name] = (typed.low / unit, typed.high / unit)
        return found


def _in_degrees(allowed: Range, remedy: str = "") -> Range:
    return replace(allowed, low=math.degrees(allowed.low), high=math.degrees(allowed.high), remedy=remedy)


class OfModel(o.Command):
    """A command whose options are its own and one for each parameter of a model; its work is given a :class:`Case`.

    Parameters are of the type ``kind``. With ``start`` each number of the initial state has an option too. ``statics`` of a brake
    takes the friction that works at the speed of its belt. ``--vary``, ``--within`` and ``--method`` come with the case; where
    ``values`` are asked for, the ends of a range are values themselves; the first ``spanned`` ranges have no value besides. Files
    of ``--plot`` are looked at before anything is computed. The work gives what JSON says, and what prints the table.

    Texts of help may name ``{time}``, the unit of time, ``{axes}``, what varies unless told otherwise, ``{last}`` of them,
    ``{coordinate}``, the first, and ``{state}``, all of the initial state. What ``--vary`` names there is its default.
    """

    def __init__(
        self, *args: Any, kind: Callable[[Range], Any] = o.Number, start: bool = False, statics: bool = False,
        values: bool = False, spanned: int = 1, **more: Any,
    ) -> None:  # fmt: skip
        super().__init__(*args, **more)
        self.kind, self.start, self.statics, self.own = kind, start, statics, self.params
        self.values, self.spanned = values, spanned
        self.text = self.help
        self._be_about(load(USUAL))

    def _be_about(self, model: Model) -> None:
        self.model = model
        words = {
            "time": model.about["scales"]["time"].replace("**", "^"), "axes": " and ".join(model.axes),
            "last": "".join(model.axes[-1:]),
            "coordinate": model.coordinates[0], "state": ",".join((*model.coordinates, *model.rates)).upper(),
        }  # fmt: skip
        data = "Take the parameters, and the model, from the data of a brake, and answer in the units of that file."
        asked = [
            click.Option(["--model"], metavar="NAME|DIR", help=f"{o.TEXT} Its parameters become options."),
            click.Option(["--data"], metavar="FILE", help=data),
            click.Option(["--trust"], is_flag=True, help=o.TRUST),
        ]
        for option in asked:
            option.expose_value = False
        self.params = [*self._parameters(), *self._start(), *(_worded(option, words) for option in self.own), *asked]
        of = "" if model.name == USUAL else f"\n\nOf the model {model.name}: {model.about['summary']}"
        self.help = f"{self.text}{of}"

    def make_context(
        self, info_name: str | None, args: list[str], parent: click.Context | None = None, **extra: Any
    ) -> click.Context:
        """With the options of the model that the arguments name."""
        path, name, about = _value_of(args, "--data"), _value_of(args, "--model"), self
        if path is not None:
            study = study_of(path, name, "--trust" in args)
            name, extra = study.model, extra | {"default_map": self._defaults(study), "obj": study}
        name = USUAL if name is None else name
        if name != self.model.where:
            about = copy.copy(self)
            about._be_about(load(name))
        return super(OfModel, about).make_context(info_name, args, parent, **extra)

    def work(self, ctx: click.Context) -> Any:
        """Do the work, about the case that the parameters are."""
        return ctx.invoke(self._work, ctx)

    def _work(self, ctx: click.Context) -> None:
        given, units = ctx.params, Case(self.model, ctx.obj)
        values = {name: given.pop(name) for name in self.model.parameters}
        for entry in self.model.about["parameters"]:
            name = entry["name"]
            if name in self.model.about["angles"]:
                values[name] = None if values[name] is None else np.radians(values[name])
            elif ctx.obj and name == entry["quantity"] and ctx.get_parameter_source(name) == ParameterSource.COMMANDLINE:
                # A quantity of the file that is typed by its own name is in the file's unit, as that of --vary is.
                values[name] = values[name] / units.varied(name)[1]
        start = {f"{name}0": given.pop(f"{name}0") / units.state(name) for name in self._state()}
        ask = {"method": given.pop("method", None), "within": units.box(given.pop("within", ()))}
        asked = given.pop("vary", None) or [o.Typed(name, name) for name in self._varies()]
        typed = [asked] if isinstance(asked, o.Typed) else asked
        spans = tuple(units.spanning(one, self.values, place < self.spanned) for place, one in enumerate(typed))
        case = Case(self.model, ctx.obj, values, start, {name: one for name, one in ask.items() if one}, spans)
        json_output, plot = given.pop("json_output", False), given.get("plot")
        assert self.callback is not None  # each has its work
        takes_force = "force" in inspect.signature(self.callback).parameters
        drawable(plot)
        refuse([plot], given.get("force", False) if takes_force else given.pop("force", False))
        done = self.callback(case, **given)
        if done is not None:
            told, tables = done
            if json_output:
                print_json({"model": self.model.name, **told})
            else:
                tables()

    def _varies(self) -> tuple[str, ...]:
        """What varies unless told otherwise, as the help of ``--vary`` says."""
        text = next((str(getattr(option, "help", "")) for option in self.own if option.name == "vary"), "")
        return self.model.axes if "{axes}" in text else self.model.axes[-1:] if "{last}" in text else ()

    def _parameters(self) -> list[click.Option]:
        options = []
        for entry in self.model.about["parameters"]:
            name, default = entry["name"], self.model.base.get(entry["name"])
            allowed, meaning = self.model.Parameters.ranges[name], f"{entry['meaning'][:1].upper()}{entry['meaning'][1:]}"
            if name in self.model.about["angles"]:
                allowed = _in_degrees(allowed, f"give the {entry['meaning']} in degrees")
                meaning, default = f"{meaning}, degrees", None if default is None else degrees(default)
            exact = default is not None and float(f"{default:.7g}") == default
            # Click puts a default that is told in words into parentheses.
            rounded = "" if default is None or exact else f"  [default: {default:.7g}]"
            flags = (*options_of(self.model.about, name), name)
            options.append(
                click.Option(flags, type=self.kind(allowed), default=default, show_default=exact, help=f"{meaning}.{rounded}")
            )
        return options

    def _state(self) -> tuple[str, ...]:
        return (*self.model.coordinates, *self.model.rates) if self.start else ()

    def _start(self) -> list[click.Option]:
        kind, si = self.kind(Range(-math.inf)), Units(self.model).si
        texts = ((name, f"Initial {name}{', degrees' if si[name] == 'rad' else ''}.") for name in self._state())
        return [click.Option([f"--{name}0", f"{name}0"], type=kind, default=0.0, help=text) for name, text in texts]

    def _defaults(self, study: Study) -> dict[str, str]:
        """The values of a file, as options take them: of statics with the friction that works."""
        kind, p = study.kind, study.at_work if self.statics and study.moves else study.dimensionless
        if not self.statics and not study.moves:
            raise ParameterError(
                f'--data {study.source}: there is no motion without belt speed and creep; add V = "1.2 m/s" and d = "10 s/m"'
            )
        values = {name: float(getattr(p, name)) for quantity, name in kind.parameters.items() if quantity in study.quantities}
        return {name: str(degrees(value) if name in kind.about["angles"] else value) for name, value in values.items()}


def of_model(**options: Any) -> Callable[[Callable[..., Any]], OfModel]:
    """A command about a model: ``click.command`` with the common options."""
    return o.command(cls=OfModel, **options)


def _worded(option: click.Parameter, words: dict[str, str]) -> click.Parameter:
    """An option with the words of a model in its help."""
    other = copy.copy(option)
    for text in ("help", "metavar"):
        if "{" in (getattr(option, text, None) or ""):
            setattr(other, text, getattr(option, text).format(**words))
    return other


def _value_of(args: Sequence[str], flag: str) -> str | None:
    """The value of an option, if it is there and a value follows."""
    for place, word in enumerate(args):
        if word == flag and place + 1 < len(args):
            return args[place + 1]
        if word.startswith(f"{flag}="):
            return word.partition("=")[2]
    return None


def study_of(path: str | Path, model: str | None, trust: bool) -> Study:
    """The data of a brake, for the model that the command names if it names one."""
    from ..report import Study

    study = Study.from_file(path, trust=trust or model or False)
    if model not in (None, study.model):
        raise ParameterError(f"--model {model}: {path} is about {study.model}; leave one of the two out")
    return study
