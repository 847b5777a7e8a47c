"""``spragsym folds --model``, ``path --model`` and ``critical --model``."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import click

from ..errors import ParameterError
from .model_statics import box_of, json_option, optional, points_of, print_points, within_option
from .options import Number
from .states import words_of
from .tables import busy, print_json, print_path, print_table
from .with_model import parameter_options, without

if TYPE_CHECKING:
    from ..models import Model


def folds_of(model: Model) -> tuple[list[click.Option], Callable[..., Any], str]:
    """Options and work of ``spragsym folds`` for a model."""

    def folds(
        vary: str, low: float | None, high: float | None, within: tuple[str, ...], json_output: bool, **values: Any
    ) -> None:
        box = box_of(model, within)
        p = without(model, (vary,), values)
        between = None if low is high is None else {vary: _span(model, vary, low, high)}
        with busy(f"searching for folds along {vary}"):
            found = model.folds(p, vary, between=between, within=box)
        if json_output:
            print_json({"model": model.name, "vary": vary, **points_of(model, found)})
        else:
            print_points(model, "folds", found)

    options = [
        *_common(model, "Parameter along which folds are looked for."),
        *_ends("its range", "its range", None),
        within_option(model),
        json_option(),
    ]
    return options, folds, "All folds along one parameter, proved: where two equilibria meet."


def path_of(model: Model) -> tuple[list[click.Option], Callable[..., Any], str]:
    """Options and work of ``spragsym path`` for a model."""

    def path(vary: str, low: float, high: float, points: int, json_output: bool, **values: Any) -> None:
        import numpy as np

        if low == high:
            raise ParameterError(f"--from {low:g} and --to are the same; give two values")
        unit, title = _unit(model, vary), _title(model, vary)
        p = without(model, (vary,), values)
        with busy(f"following a state along {vary}"):
            found = model.quasi_static_path(p, vary, np.linspace(low, high, points) / unit)
        states = [
            {title: float(unit * value), **words, **{name: float(getattr(found, name)[row]) for name in model.coordinates}}
            for row, (value, words) in enumerate(zip(found.values, words_of(found), strict=True))
        ]  # fmt: skip
        jumps = [
            {title: unit * jump.value, "kind": jump.kind,
             **{f"{name}_before": jump.before[name] for name in model.coordinates},
             **{f"{name}_after": jump.after[name] for name in model.coordinates}}
            for jump in found.jumps
        ]  # fmt: skip
        print_path({"model": model.name, "vary": vary}, states, jumps, json_output)

    count = click.Option(
        ["--points"], type=click.IntRange(2, 100_000), default=11, show_default=True, help="Values, the ends included."
    )
    options = [*_common(model, "Parameter that moves."), *_ends("First", "Last", (0.0, 1.0)), count, json_option()]
    return options, path, "The state of small deformation, followed as one parameter moves: where it goes and where it jumps."


def critical_of(model: Model) -> tuple[list[click.Option], Callable[..., Any], str]:
    """Options and work of ``spragsym critical`` for a model."""

    def critical(vary: str, low: float | None, high: float | None, json_output: bool, **values: Any) -> None:
        from ..models.paths import first_end

        p = without(model, (vary,), values)
        ends = _span(model, vary, low, high)
        unit, title = _unit(model, vary), _title(model, vary)
        found = first_end(model, p, vary, ends)
        told = {"model": model.name, "vary": vary, "from": unit * ends[0], "to": unit * ends[1]}
        if json_output:
            jump = (
                None if found is None else {title: unit * found.value, "kind": found.kind, **found.before, "error": found.error}
            )
            print_json({**told, "jump": jump})
        elif found is None:
            click.echo(f"no jump from {title} = {unit * ends[0]:g} to {unit * ends[1]:g}")
        else:
            header = (f"{title} at the first jump", "kind", *model.coordinates)
            print_table("", header, [(unit * found.value, found.kind, *(found.before[name] for name in model.coordinates))])

    options = [
        *_common(model, "Parameter that moves."), *_ends("the lower end of its range", "the upper end", None), json_option(),
    ]  # fmt: skip
    return options, critical, "Where the state of small deformation jumps first as one parameter moves one way."


def _common(model: Model, meaning: str) -> list[click.Option]:
    """The parameters, none of which is required, and what varies."""
    first = model.axes[-1]
    vary = click.Option(["--vary"], default=first, show_default=True, help=meaning)
    return [*(optional(option) for option in parameter_options(model, Number)), vary]


def _ends(first: str, last: str, defaults: tuple[float, float] | None) -> list[click.Option]:
    """``--from`` and ``--to``; degrees for angles."""
    texts = [f"{first} value", f"{last} value"] if defaults else [f"Without it {first}", f"Without it {last}"]
    return [
        click.Option(
            [flag, name], type=Number(), default=defaults[i] if defaults else None, show_default=defaults is not None,
            help=f"{texts[i]}; degrees for angles.",
        )
        for i, (flag, name) in enumerate((("--from", "low"), ("--to", "high")))
    ]  # fmt: skip


def _span(model: Model, vary: str, low: float | None, high: float | None) -> tuple[float, float]:
    """First and last value in the model's unit; what is not given is the end of the parameter's range."""
    from ..models.points import ranges

    ends: list[float] = ranges(model, (vary,), {})[0].tolist()
    unit = _unit(model, vary)
    if vary in model.about["angles"]:
        # An end that does not belong to the range: the next float does, and there is none between them.
        (entry,) = [entry for entry in model.about["parameters"] if entry["name"] == vary]
        ends[0] = math.nextafter(ends[0], math.inf) if entry["low_open"] else ends[0]
        ends[1] = math.nextafter(ends[1], -math.inf) if entry["high_open"] else ends[1]
    given = [ends[i] if value is None else value / unit for i, value in enumerate((low, high))]
    if given[0] == given[1]:
        raise ParameterError(f"--from and --to are both {unit * given[0]:g}; give two values")
    return given[0], given[1]


def _unit(model: Model, name: str) -> float:
    return math.degrees(1.0) if name in model.about["angles"] else 1.0


def _title(model: Model, name: str) -> str:
    return f"{name}_deg" if name in model.about["angles"] else name
