"""Options of commands: the same name, meaning and range in every command; a command about a model
has an option for each parameter as well.
"""

from __future__ import annotations

import copy
import inspect
import itertools
import re
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import click
import numpy as np

from ..command_line import option_name, options_of
from ..core.errors import ParameterError
from ..models.load import USUAL, load
from ..models.model import Model
from ..models.parameters import (
    FINITE,
    NOT_NEGATIVE,
    POSITIVE,
    Range,
    as_number,
    as_numbers,
    degrees,
    shown,
)
from .case import Case, Span, in_degrees, study_of
from .output import is_typed, print_json, refuse

if TYPE_CHECKING:
    from ..report.study import Study

#: A decorator that adds an option to a command.
Decorator: TypeAlias = Callable[[Any], Any]


class Command(click.Command):
    """A command that refuses options that are empty or given twice (click takes the last one).

    Its help ends in the exit codes.
    """

    def __init__(self, *args: Any, **more: Any) -> None:
        super().__init__(*args, **more)
        self.help = inspect.cleandoc(self.help or "")
        if "Exit codes:" not in self.help:
            self.help += "\n\n\b\nExit codes: 0 done, 1 failed, 2 usage, 130 interrupted."

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        values, _, order = self.make_parser(ctx).parse_args(list(args))
        for one in () if ctx.resilient_parsing else order:
            given, times = values[one.name or ""], order.count(one)
            is_plain_flag = getattr(one, "is_flag", False) and not one.secondary_opts
            if times > 1 and not getattr(one, "multiple", False) and not is_plain_flag:
                raise click.BadParameter(f"it is given {times} times; give it once", ctx, one)
            if "" in (given if isinstance(given, list | tuple) else [given]):
                raise click.BadParameter("it is empty; leave it out, or give a value", ctx, one)
        return super().parse_args(ctx, args)

    def invoke(self, ctx: click.Context) -> object:
        """Run the command; an error about an argument of a Python function names its option."""
        try:
            return super().invoke(ctx)
        except ParameterError as error:
            name, sign, rest = str(error).partition(" = ")
            flags = {
                option.name: option.opts
                for option in self.params
                if isinstance(option, click.Option)
            }
            if type(error) is not ParameterError or name not in flags or not sign:
                raise
            raise ParameterError(f"{max(flags[name], key=len)} = {rest}") from error


#: As ``click.command``.
command = partial(click.command, cls=Command)

TEXT = "Another model: the name of a shipped one, or a folder that `spragsym derive` wrote."
TRUST = "Run the code of the page or the folder that a file names as its model."


# ParamType is generic in newer versions of click only.
class OneNumber(click.ParamType):  # type: ignore[type-arg,unused-ignore]
    """A number in a range; an error names the option as it is typed."""

    name = "float"

    def __init__(self, allowed: Range = FINITE) -> None:
        self.allowed = allowed

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> object:
        try:
            number = float(value)
        except ValueError:
            self.fail(f"{value!r} is not a number; give one in {self.allowed}")
        return as_number(_flag(param), number, self.allowed)


class NumberList(OneNumber):
    """A number, several numbers ``a,b,c``, or ``start:stop:count`` with equal steps and both ends;
    all in a range.
    """

    name = "numbers"

    def convert(
        self, value: object, param: click.Parameter | None, ctx: click.Context | None
    ) -> object:
        text = str(value)
        if "," not in text and ":" not in text:
            return super().convert(value, param, ctx)
        if re.fullmatch(r"\s*[+-]?(0,\d+|\d+,0\d+)\s*", text):
            one, two = text.replace(",", "."), text.replace(",", ".0,")
            self.fail(f"{value!r} may be one number or two; write {one}, or {two}")
        try:
            if ":" not in text:
                numbers = np.array([float(number) for number in text.split(",")])
            else:
                start, stop, count = text.split(":")
                most = 1_000_000
                if not 1 < int(count) <= most:
                    self.fail(
                        f"{value!r}: equal steps with both ends are 2 to {most} numbers; for "
                        "one give it alone"
                    )
                with np.errstate(all="ignore"):  # an infinite end, which the range refuses
                    numbers = np.linspace(float(start), float(stop), int(count))
        except ValueError:
            self.fail(
                f"{value!r} is neither numbers like 0.2,0.5 nor start:stop:count like 30:60:61"
            )
        as_numbers(_flag(param), numbers, self.allowed)
        return numbers


def _span(typed: str) -> Span:
    """Parse ``NAME``, ``NAME=FROM:TO`` or ``NAME=FROM:TO:COUNT``."""
    name, sign, rest = typed.partition("=")
    if not sign:
        return Span(typed, name)
    try:
        low, high, *counts = rest.split(":")
        ends = float(low), float(high)
        (count,) = map(int, counts) if counts else (Span.count,)
    except ValueError as error:
        cure = f"give it as {name}=0:1, or with values as {name}=0:1:11"
        raise click.BadParameter(f"{typed!r} is neither a name nor a range; {cure}") from error
    if not 2 <= count <= 100_000:
        raise click.BadParameter(f"{typed!r}: values with both ends are 2 to 100000")
    if ends[0] == ends[1]:
        raise click.BadParameter(f"{typed!r}: both ends are {shown(ends[0])}; give two values")
    return Span(typed, name, ends, count)


def _flag(param: click.Parameter | None) -> str:
    """The long name of an option, for errors."""
    return "value" if param is None else max(param.opts, key=len)


def vary(text: str, several: bool = False) -> Decorator:
    """``--vary``, for one parameter or ``several``."""
    return click.option("--vary", type=_span, metavar="NAME[=FROM:TO]", multiple=several, help=text)


over: Decorator = click.option(
    "--over",
    type=_span,
    multiple=True,
    metavar="NAME=FROM:TO:COUNT",
    help="The verdict over a quantity, as theta0=40:70:31 in the unit of the file, or over two.",
)
within: Decorator = click.option(
    "--within",
    type=_span,
    multiple=True,
    metavar="NAME=FROM:TO",
    help="Range of a coordinate to search, as {coordinate}=-5:5, in place of the model's own; "
    "angles in degrees. Repeatable.",
)
followed: Decorator = click.option(
    "--state",
    "near",
    metavar="NAME=VALUE",
    multiple=True,
    help="Follow the stable state nearest to this coordinate, as x=1.6, in place of the reference "
    "state; may be repeated.",
)
method: Decorator = click.option(
    "--method",
    type=click.Choice(["closed", "search"]),
    help="Closed forms that a model brings, or the search that serves every model. Default: what "
    "is faster.",
)
undamped: Decorator = click.option(
    "--undamped",
    is_flag=True,
    help="Onsets by (27), without dampers and the slope of the friction law: where two modes meet.",
)
rtol: Decorator = click.option("--rtol", type=float, default=1e-10, help="Relative tolerance.")
t_end: Decorator = click.option(
    "--t-end",
    type=OneNumber(POSITIVE),
    default=2000.0,
    help="Until when, in {time}; with --data in seconds, as --transient.",
)
transient: Decorator = click.option(
    "--transient",
    type=OneNumber(NOT_NEGATIVE),
    help="What to leave out of RMS, largest displacement and period. Default: three quarters of "
    "--t-end.",
)
quiet: Decorator = click.option("--quiet", "-q", is_flag=True, help="No progress bar.")
trust: Decorator = click.option("--trust", is_flag=True, expose_value=False, help=TRUST)
force: Decorator = click.option(
    "--force", is_flag=True, expose_value=False, help="Overwrite files that are in the way."
)
as_json: Decorator = click.option(
    "--json",
    "json_output",
    is_flag=True,
    expose_value=False,
    help="Print JSON instead of a table.",
)


def is_json() -> bool:
    """Whether JSON is asked for."""
    return is_typed("json_output")


def file(*flags: str, folder: bool = False, exists: bool = False, **more: Any) -> Decorator:
    """An option for the path of a file; of a folder too if ``folder``."""
    return click.option(
        *flags, type=click.Path(dir_okay=folder, exists=exists, path_type=Path), **more
    )


def folder(text: str, *, required: bool = True) -> Decorator:
    """``--out``, the folder of commands that write several files."""
    kind = click.Path(file_okay=False, path_type=Path)
    return click.option("--out", "-o", type=kind, required=required, help=text)


def plot(what: str) -> Decorator:
    """``--plot``."""
    return file("--plot", metavar="FILE", help=f"Draw {what} (pdf, png, svg).")


def lines(default: int, text: str) -> Decorator:
    """``--n``."""
    return click.option("--n", type=click.IntRange(2, 500), default=default, help=text)


def backend(*names: str) -> Decorator:
    """``--backend``, with the integrators that a command can use."""
    text = f"Integrator. Default: the first of {', '.join(names)} that is installed."
    return click.option("--backend", type=click.Choice(names), help=text)


def workers(default: int) -> Decorator:
    """``-j --workers``."""
    return click.option(
        "--workers", "-j", type=int, default=default, help="Processes; -1 for one a core."
    )


class OfModel(Command):
    """A command about a model: it has an option for each parameter, and its function is given a
    :class:`Case`.

    The function returns the data for JSON, and a function that prints the table. ``--vary``,
    ``--within`` and ``--method`` become part of the case. A file of ``--plot`` is checked before
    anything is computed.

    Parameters
    ----------
    kind : type of click
        Type of the parameters' options: a number or a list of numbers.
    start : bool
        Whether the initial state has options.
    statics : bool
        Whether the command is about equilibria: data of a brake then give the friction at the speed
        of its belt; without ``varies`` both ends of a range must be allowed values.
    spanned : int
        Number of ranges, the first ones, whose parameters must not have a value too.
    varies : int
        Number of axes that vary without ``--vary``, counted from the last one.

    Notes
    -----
    Help texts may hold ``{time}``, the unit of time, ``{axes}``, the parameters that vary by
    default, ``{last}``, the last of these, ``{coordinate}``, the first one, and ``{state}``, the
    components of the initial state.
    """

    def __init__(
        self,
        *args: Any,
        kind: Callable[[Range], Any] = OneNumber,
        start: bool = False,
        statics: bool = False,
        spanned: int = 1,
        varies: int = 0,
        **more: Any,
    ) -> None:
        super().__init__(*args, **more)
        self.kind, self.start, self.statics, self.own = kind, start, statics, self.params
        self.spanned, self.varies = spanned, varies
        self.text, self.work = self.help, self.callback
        self._be_about(load(USUAL))

    def _be_about(self, model: Model) -> None:
        """Set the options and the help of a model."""
        self.model = model
        words = {
            "time": model.about["scales"]["time"].replace("**", "^"),
            "axes": " and ".join(model.axes),
            "last": "".join(model.axes[-1:]),
            "coordinate": model.coordinates[0],
            "state": ",".join(model.components).upper(),
        }
        kind = self.kind(FINITE)
        start = [
            click.Option(
                [f"--{name}0", f"{name}0"],
                type=kind,
                default=0.0,
                help=f"Initial {name}{', degrees' * model.is_angle(name)}.",
            )
            for name in model.starting
            if self.start
        ]
        # These choose the model, and are evaluated before the others.
        about = [
            click.Option(
                ["--model"],
                metavar="NAME|DIR",
                help=f"{TEXT} Its parameters become options.",
                expose_value=False,
            ),
            click.Option(
                ["--data"],
                metavar="FILE",
                expose_value=False,
                help="Take the parameters, and the model, from the data of a brake, and answer "
                "in the units of that file.",
            ),
            click.Option(["--trust"], is_flag=True, help=TRUST, expose_value=False),
        ]
        self.params = [
            *self._parameters(),
            *start,
            *(_worded(option, words) for option in self.own),
            *about,
        ]
        self.help, self.callback = self.text, self._work
        if model.name != USUAL:
            self.help = f"{self.text}\n\nOf the model {model.name}: {model.about['summary']}"

    def make_context(
        self,
        info_name: str | None,
        args: list[str],
        parent: click.Context | None = None,
        **extra: Any,
    ) -> click.Context:
        """The context with the options of the model that the arguments name."""
        path, name, about = _value_of(args, "--data"), _value_of(args, "--model"), self
        if path is not None:
            study = study_of(path, name, trust="--trust" in args)
            name, extra = study.model, extra | {"default_map": self._defaults(study), "obj": study}
        name = USUAL if name is None else name
        if name != self.model.where:
            about = copy.copy(self)
            about._be_about(load(name))
        return super(OfModel, about).make_context(info_name, args, parent, **extra)

    def _work(self, **given: Any) -> None:
        """Make the case from the options, and call the command's function."""
        ctx = click.get_current_context()
        units = Case(self.model, ctx.obj)
        values = {}
        for entry in self.model.about["parameters"]:
            value = given.pop(option_name(name := entry["name"]))
            if value is not None and self.model.is_angle(name):
                value = np.radians(value)
            elif ctx.obj and name == entry["quantity"] and is_typed(option_name(name)):
                # Typed by the name of a quantity of the file, it is in the file's unit.
                value = value / units.varied(name)[2]
            values[name] = value
        start = {
            f"{name}0": given.pop(f"{name}0") / units.of(name)[1]
            for name in self.model.starting
            if self.start
        }
        ask = {"method": given.pop("method", None), "within": units.box(given.pop("within", ()))}
        usual = self.model.axes[-self.varies :] if self.varies else ()
        asked = given.pop("vary", None) or [Span(name, name) for name in usual]
        asked = [asked] if isinstance(asked, Span) else asked
        spans = tuple(
            units.spanning(one, self.statics and not self.varies, index < self.spanned)
            for index, one in enumerate(asked)
        )
        ask = {name: one for name, one in ask.items() if one}
        case = Case(self.model, ctx.obj, values, start, ask, spans)
        plot = given.get("plot")
        assert self.work is not None
        if plot is not None and plot.suffix not in (".pdf", ".png", ".svg"):
            raise ParameterError(f"--plot {plot}: the ending must be .pdf, .png or .svg")
        refuse([plot])
        done = self.work(case, **given)
        if done is not None:
            answer, tables = done
            if is_json():
                print_json({"model": self.model.name, **answer})
            else:
                tables()

    def _parameters(self) -> Iterator[click.Option]:
        for entry in self.model.about["parameters"]:
            name, default = entry["name"], entry["base"]
            allowed = self.model.Parameters.ranges[name]
            meaning = f"{entry['meaning'][:1].upper()}{entry['meaning'][1:]}"
            if self.model.is_angle(name):
                allowed = in_degrees(allowed, f"give the {entry['meaning']} in degrees")
                meaning = f"{meaning}, degrees"
                default = None if default is None else degrees(default)
            exact = default is not None and float(f"{default:.7g}") == default
            # Click puts a default that is told in words into parentheses.
            rounded = "" if default is None or exact else f"  [default: {default:.7g}]"
            flags = (*options_of(self.model.about, name), option_name(name))
            yield click.Option(
                flags,
                type=self.kind(allowed),
                default=default,
                show_default=exact,
                help=f"{meaning}.{rounded}",
            )

    def _defaults(self, study: Study) -> dict[str, str]:
        """The values of a file, as options take them: of statics with the friction that works."""
        kind = study.kind
        p = study.operating_point if self.statics and study.moves else study.dimensionless
        if not self.statics and not study.moves:
            raise ParameterError(
                f"--data {study.source}: there is no motion without belt speed and creep; add "
                'V = "1.2 m/s" and d = "10 s/m"'
            )
        values = {
            name: float(p[name])
            for quantity, name in kind.parameters.items()
            if quantity in study.quantities
        }
        return {
            option_name(name): str(degrees(value) if name in kind.about["angles"] else value)
            for name, value in values.items()
        }


#: A command about a model: ``click.command`` with the common options.
of_model = partial(command, cls=OfModel)


def _worded(option: click.Parameter, words: dict[str, str]) -> click.Parameter:
    """A copy of an option with a model's words in its help."""
    other = copy.copy(option)
    for name in ("help", "metavar"):
        if text := getattr(option, name, None):
            setattr(other, name, text.format(**words))
    return other


def _value_of(args: Sequence[str], flag: str) -> str | None:
    """The value of an option among arguments; None without option or value."""
    for word, following in itertools.zip_longest(args, args[1:]):
        name, sign, value = word.partition("=")
        if name == flag:
            return value if sign else following
    return None
