"""``--model``: the same commands for any model, with the model's own parameters as options."""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from ..errors import ParameterError
from ..models.parameters import options_of
from ..parameters import Range, degrees

if TYPE_CHECKING:
    from ..models import Model

F = TypeVar("F", bound=Callable[..., Any])

TEXT = "Another model: the name of a shipped one, or a folder that `spragsym derive` wrote."


class ForModels(click.Command):
    """A command whose options and work are another's where ``--model`` is given.

    ``of_model(model)`` makes that other command.
    """

    of_model: Callable[[Model], click.Command]

    def make_context(
        self, info_name: str | None, args: list[str], parent: click.Context | None = None, **extra: Any
    ) -> click.Context:
        chosen = _chosen(args)
        if chosen is None:
            return super().make_context(info_name, args, parent, **extra)
        from ..models import load

        return self.of_model(load(chosen).search).make_context(info_name, args, parent, **extra)


def _chosen(args: Sequence[str]) -> str | None:
    """The value of ``--model``, if there is one and a value follows."""
    for place, word in enumerate(args):
        if word == "--model" and place + 1 < len(args):
            return args[place + 1]
        if word.startswith("--model="):
            return word.partition("=")[2]
    return None


def model_option(function: F) -> F:
    """``--model``, which :class:`ForModels` has read before options are."""
    return click.option(
        "--model", "model_name", metavar="NAME|DIR", expose_value=False, help=f"{TEXT} Its parameters become options."
    )(function)


def parameter_options(model: Model, kind: Callable[[Range], Any], start: bool = False) -> list[click.Option]:
    """An option for each parameter, angles in degrees; and for each number of the initial state, if asked for."""
    ranges, base = model.Parameters.ranges, model.base
    options = [
        click.Option(
            ["--model", "model_name"], metavar="NAME|DIR", expose_value=False, help=f"{TEXT} Its parameters become options."
        )
    ]
    for entry in model.about["parameters"]:
        name, allowed = entry["name"], ranges[entry["name"]]
        meaning = f"{entry['meaning'][0].upper()}{entry['meaning'][1:]}"
        default = base.get(name)
        if name in model.about["angles"]:
            allowed = Range(math.degrees(allowed.low), math.degrees(allowed.high), allowed.open_low, "", allowed.closed_high)
            meaning, default = f"{meaning}, degrees", None if default is None else degrees(default)
        flags = (*options_of(model.about, name), name)
        given: dict[str, Any] = {"required": True}
        if default is not None:
            exact = float(f"{default:.7g}") == default
            given = {"default": default, "show_default": exact or f"{default:.7g}"}
        options.append(click.Option(flags, type=kind(allowed), help=f"{meaning}.", **given))
    if start:
        options += [
            click.Option(
                [f"--{name}0", f"{name}0"], type=kind(Range(-math.inf)), default=0.0, show_default=True, help=f"Initial {name}."
            )
            for name in (*model.coordinates, *model.rates)
        ]
    return options


def parameters_of(model: Model, values: dict[str, Any]) -> Any:
    """Takes the parameters out of a command's values: angles in degrees there, radians here."""
    import numpy as np

    taken = {name: values.pop(name) for name in model.parameters}
    angles = {name for name in model.about["angles"] if taken[name] is not None}
    return {name: np.radians(value) if name in angles else value for name, value in taken.items()}


def without(model: Model, vary: Sequence[str], values: dict[str, Any]) -> Any:
    """The parameters, those that vary left out."""
    for name in vary:
        if name not in model.parameters:
            raise ParameterError(f"{name} is not a parameter of {model.name}; choose among {', '.join(model.parameters)}")
    for name in model.parameters:
        if values[name] is None and name not in vary:
            raise ParameterError(
                f"{name} has no base value in {model.name}, and does not vary here; give {options_of(model.about, name)[0]}"
            )
    return model.Parameters(**{name: None if name in vary else value for name, value in parameters_of(model, values).items()})


def page_of(model: Model, shipped: Path) -> Path:
    """Where the page of a model stands: among the shipped ones, or in its folder."""
    return shipped / f"{model.name}.py" if model.where == model.name else Path(model.where) / "page.py"


def made_for(command: Any, module: str, function: str) -> None:
    """Give a command its form for models: ``function(model)`` of a module has options, what is done, and a sentence about it."""

    def build(model: Model) -> click.Command:
        options, done, text = getattr(importlib.import_module(f".{module}", __package__), function)(model)
        summary = f"{text}\n\nOf the model {model.name}: {model.about['summary']}"
        return click.Command(
            command.name, params=list(options), callback=done, help=summary, context_settings=command.context_settings
        )

    command.of_model = build
