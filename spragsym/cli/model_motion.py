"""``spragsym simulate --model``, ``spragsym sweep --model`` and ``spragsym cycles --model``."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from .cycles import search, tell
from .motion import BACKEND, EACH, PLOT, RTOL, check_length, open_grid, print_summary, refuse_targets, run_sweep, summary_of
from .options import Axis, Number, as_json, window, workers
from .targets import force
from .with_model import parameter_options, parameters_of

if TYPE_CHECKING:
    from ..dynamics import Trajectory
    from ..models import Model


def _more(*decorators: Callable[[Any], Any]) -> list[click.Option]:
    """The options that decorators add."""

    def bare() -> None:
        """Nothing."""

    for decorator in decorators:
        decorator(bare)
    found: list[click.Option] = getattr(bare, "__click_params__", [])
    return found


def simulate_of(model: Model) -> tuple[list[click.Option], Callable[..., Any], str]:
    """Options and work of ``spragsym simulate`` for a model."""

    def simulate(
        t_end: float, transient: float, rtol: float, backend: str | None, estimate_error: bool, output: Path | None,
        plot: Path | None, force: bool, json_output: bool, **values: Any,
    ) -> None:  # fmt: skip
        p = model.Parameters(**parameters_of(model, values))
        refuse_targets(output, plot, force)
        check_length(t_end)
        tr = model.simulate(p, t_end=t_end, rtol=rtol, backend=backend, estimate_error=estimate_error, **values)
        summary = {"model": model.name, **summary_of(tr, transient)}
        if output is not None:
            tr.save(output)
        if plot is not None:
            _draw(tr, plot)
            click.echo(f"drew {plot}", err=True)
        print_summary(summary, json_output)

    error = click.option("--error", "estimate_error", is_flag=True, help="Estimate the error by a second run.")
    output = click.option("--output", "-o", type=click.Path(path_type=Path), help="Write the motion to FILE.nc or FILE.csv.")
    options = [
        *parameter_options(model, Number, start=True),
        *_more(_window(model), RTOL, BACKEND, error, output, PLOT, force, as_json),
    ]
    return options, simulate, "Integrate the motion from an initial state."


def _window(model: Model) -> Callable[[Any], Any]:
    """``--t-end --transient``, with the model's unit of time."""
    return partial(window, unit=model.about["scales"]["time"].replace("**", "^"))


def _draw(tr: Trajectory, path: Path) -> None:
    from ..figures import FORMATS, model_motion_figure
    from ..figures.style import house_style

    kind = path.suffix[1:]
    with house_style():
        model_motion_figure(tr).savefig(path, format=kind, metadata=FORMATS[kind])


def sweep_of(model: Model) -> tuple[list[click.Option], Callable[..., Any], str]:
    """Options and work of ``spragsym sweep`` for a model."""

    def sweep(quiet: bool, output: Path, force: bool, **values: Any) -> None:
        check_length(values["t_end"], EACH)
        starts = [f"{name}0" for name in (*model.coordinates, *model.rates)]
        axes = {**parameters_of(model, values), **{name: values.pop(name) for name in starts}}
        grid = dict(zip(axes, open_grid(list(axes.values())), strict=True))
        p = model.Parameters(**{name: grid.pop(name) for name in model.parameters})
        run_sweep(lambda: model.rms_sweep(p, **grid, **values, progress=not quiet, store=output), output, force)

    quiet = click.option("--quiet", "-q", is_flag=True, help="No progress bar.")
    output = click.option("--output", "-o", type=click.Path(path_type=Path), required=True, help="FILE.nc or FILE.csv.")
    options = [
        *parameter_options(model, Axis, start=True),
        *_more(_window(model), RTOL, BACKEND, workers(1), quiet, output, force),
    ]
    return options, sweep, "Simulate over a grid of parameters, to a file. Every option that takes numbers is an axis."


def cycles_of(model: Model) -> tuple[list[click.Option], Callable[..., Any], str]:
    """Options and work of ``spragsym cycles`` for a model."""
    state = (*model.coordinates, *model.rates)

    def unit_of(name: str) -> tuple[str, float, str]:
        return (name, math.degrees(1.0), f"{name}_deg") if name in model.about["angles"] else (name, 1.0, name)

    def cycles(**values: Any) -> None:
        p = model.Parameters(**parameters_of(model, values))
        tell(p, lambda near: model.cycle(p, near), len(state), unit_of, **values)

    place = ",".join(state).upper()
    options = [*parameter_options(model, Number), *_more(search(place, model.parameters), force, as_json)]
    return options, cycles, "A cycle of the motion with its multipliers; with --vary, a branch of cycles."
