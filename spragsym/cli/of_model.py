"""Commands about a model: the parameters of the one that ``--model``, or the file of ``--data``, names are their options."""

from __future__ import annotations

import copy
import inspect
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click
from click.core import ParameterSource

from ..errors import ParameterError
from ..models import load
from ..models.load import USUAL
from ..models.parameter_class import options_of
from ..models.parameters import Range, degrees
from .commands import Command, command
from .options import Number
from .units import Units

if TYPE_CHECKING:
    from ..models import Model
    from ..models.parameters import ParameterSet
    from ..report import Study

F = TypeVar("F", bound=Callable[..., Any])

TEXT = "Another model: the name of a shipped one, or a folder that `spragsym derive` wrote."
MODEL = f"{TEXT} Its parameters become options."
DATA = "Take the parameters, and the model, from the data of a brake, and answer in the units of that file."
TRUST = "Run the code of the folder that the file of --data names as its model."
METHOD = "Closed forms that a model brings, or the search that serves every model. Default: what is faster."


@dataclass(frozen=True)
class Case:
    """What a command is about.

    ``values`` of its parameters are radians, None for those that were not given and have no base value; ``start`` is the initial
    state, ``x0`` and the like, as the model takes it; ``ask`` goes with every question to the model.
    """

    model: Model
    values: dict[str, Any]
    start: dict[str, Any]
    units: Units
    ask: dict[str, Any]

    def set(self, *spanned: str, **changes: Any) -> ParameterSet:
        """The parameters; those that vary need no value."""
        values = {**self.values, **changes}
        self.require([name for name in values if name not in spanned and values[name] is None])
        p: ParameterSet = self.model.Parameters(**values)
        return p

    def require(self, missing: Sequence[str] | None = None) -> None:
        """An error that names the option of a parameter that has no value."""
        for name in [name for name, value in self.values.items() if value is None] if missing is None else missing:
            flag = options_of(self.model.about, name)[0]
            raise click.UsageError(f"Missing option {flag!r}: {name} has no base value in {self.model.name}")

    def has_closed(self, name: str) -> bool:
        """Whether the model brings a closed form for this, and it is not the search that is asked for."""
        return name in self.model.closed and self.ask.get("method") != "search"

    def searching(self, between: dict[str, Any], within: dict[str, Any] | None) -> dict[str, Any]:
        """How points are asked for: the method, and ranges of what varies and of coordinates where they were given."""
        return {**self.ask, **({"between": between} if between else {}), **({"within": within} if within else {})}

    def told(self) -> dict[str, Any]:
        """The parameters in the units of the answer."""
        titles = ((self.units.parameter(name), value) for name, value in self.values.items())
        return {title: None if value is None else unit * value for (title, unit), value in titles}


class OfModel(Command):
    """A command whose options are its own and one for each parameter of a model; its work is given a :class:`Case`.

    Parameters are of the type ``kind``. With ``start`` each number of the initial state has an option too. ``statics`` of a brake
    takes the friction that works at the speed of its belt. Texts of help may name ``{time}``, the unit of time, ``{axes}``, what
    varies unless told otherwise, ``{last}`` of them, ``{coordinate}``, the first, and ``{state}``, all of the initial state.
    """

    def __init__(
        self, *args: Any, kind: Callable[[Range], Any] = Number, start: bool = False, statics: bool = False, **more: Any
    ) -> None:
        super().__init__(*args, **more)
        self.kind, self.start, self.statics, self.own = kind, start, statics, self.params
        self.text = inspect.cleandoc(self.help or "")
        self._be_about(load(USUAL))

    def _be_about(self, model: Model) -> None:
        self.model = model
        words = {
            "time": model.about["scales"]["time"].replace("**", "^"), "axes": " and ".join(model.axes),
            "last": "".join(model.axes[-1:]),
            "coordinate": model.coordinates[0], "state": ",".join((*model.coordinates, *model.rates)).upper(),
        }  # fmt: skip
        asked = [click.Option(["--model"], metavar="NAME|DIR", expose_value=False, help=MODEL)]
        asked.append(click.Option(["--data"], metavar="FILE", expose_value=False, help=DATA))
        asked.append(click.Option(["--trust"], is_flag=True, expose_value=False, help=TRUST))
        self.params = [*self._parameters(), *self._start(), *(_worded(option, words) for option in self.own), *asked]
        of = "" if model.name == USUAL else f"\n\nOf the model {model.name}: {model.about['summary']}"
        self.help = f"{self.text}{of}"

    def of_model(self, model: Model) -> OfModel:
        """The same command about another model."""
        other = copy.copy(self)
        other._be_about(model)
        return other

    def make_context(
        self, info_name: str | None, args: list[str], parent: click.Context | None = None, **extra: Any
    ) -> click.Context:
        """With the options of the model that the arguments name."""
        path, name = _value_of(args, "--data"), _value_of(args, "--model")
        if path is not None:
            study = study_of(path, name, "--trust" in args)
            name, extra = study.model, extra | {"default_map": self._defaults(study), "obj": study}
        name = USUAL if name is None else name
        about = self if name == self.model.where else self.of_model(load(name))
        return super(OfModel, about).make_context(info_name, args, parent, **extra)

    def invoke(self, ctx: click.Context) -> Any:
        """Do the work, about the case that the parameters are."""
        import numpy as np

        angles = self.model.about["angles"]
        values = {name: ctx.params.pop(name) for name in self.model.parameters}
        radians = {name: np.radians(values[name]) for name in angles if values[name] is not None}
        method, units = ctx.params.pop("method", None), Units(self.model, ctx.obj)
        if ctx.obj is not None:
            # A quantity of the file that is typed by its own name is in the file's unit, as that of --vary is.
            for entry in self.model.about["parameters"]:
                name, typed = entry["name"], ctx.get_parameter_source(entry["name"]) == ParameterSource.COMMANDLINE
                if typed and name == entry["quantity"] and name not in angles:
                    values[name] = values[name] / units.varied(name)[1]
        start = {f"{name}0": ctx.params.pop(f"{name}0") / units.state(name) for name in self._state()}
        case = Case(self.model, values | radians, start, units, {"method": method} if method else {})
        assert self.callback is not None  # each has its work
        return ctx.invoke(partial(self.callback, case), **ctx.params)

    def _parameters(self) -> list[click.Option]:
        ranges, base = self.model.Parameters.ranges, self.model.base
        options = []
        for entry in self.model.about["parameters"]:
            name, allowed, default = entry["name"], ranges[entry["name"]], base.get(entry["name"])
            meaning = f"{entry['meaning'][0].upper()}{entry['meaning'][1:]}"
            if name in self.model.about["angles"]:
                remedy = f"give the {entry['meaning']} in degrees"
                low, high = math.degrees(allowed.low), math.degrees(allowed.high)
                allowed = Range(low, high, allowed.open_low, remedy, allowed.closed_high)
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
        angles = [entry["name"] for entry in self.model.about["coordinates"] if entry["unit"] == "rad"]
        options = []
        for name in self._state():
            text = f"Initial {name}{', degrees' if name in angles else ''}."
            kind = self.kind(Range(-math.inf))
            options.append(click.Option([f"--{name}0", f"{name}0"], type=kind, default=0.0, show_default=True, help=text))
        return options

    def _defaults(self, study: Study) -> dict[str, str]:
        """The values of a file, as options take them."""
        from ..report.quantities import share

        model, moves, p = study.kind.model, study.moves, study.kind.parameter_set(study.values)
        if not self.statics and not moves:
            raise ParameterError(
                f'--data {study.source}: there is no motion without belt speed and creep; add V = "1.2 m/s" and d = "10 s/m"'
            )
        if self.statics and moves and "mu0" in model.parameters:
            p = p.replace(mu0=p.mu0 * share(model, p))
        given = {name for quantity, name in study.kind.parameters.items() if quantity in study.quantities}
        values = {name: float(getattr(p, name)) for name in given}
        return {name: str(degrees(value) if name in model.about["angles"] else value) for name, value in values.items()}


def of_model(**options: Any) -> Callable[[Callable[..., Any]], OfModel]:
    """As ``click.command``, for a command about a model."""
    return command(cls=OfModel, **options)


def followed(function: F) -> F:
    """``--state``."""
    text = "Follow the stable state nearest to this coordinate, as x=1.6, in place of the reference state; may be repeated."
    return click.option("--state", "near", metavar="NAME=VALUE", multiple=True, help=text)(function)


def following(case: Case, p: ParameterSet, near: Sequence[str]) -> ParameterSet:
    """A set of parameters that follows the state that ``--state`` chose, if it did."""
    chosen = {}
    for word in near:
        name, _, value = word.partition("=")
        known = case.model.coordinates
        try:
            chosen[name] = float(value) / case.units.state(name) if name in known else math.nan
        except ValueError:
            chosen[name] = math.nan
        if not math.isfinite(chosen[name]):
            raise click.UsageError(f"--state {word}: give NAME=VALUE, NAME one of {', '.join(known)}")
    return p.following(**chosen) if chosen else p


def method(function: F) -> F:
    """``--method``."""
    return click.option("--method", type=click.Choice(["closed", "search"]), help=METHOD)(function)


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
