"""``spragsym simulate`` and ``spragsym sweep``: motion in time."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

import spragsym as ss

from ..errors import ParameterError
from ..models.parameters import FloatArray
from .drawings import drawable, written
from .of_model import Case, of_model
from .options import Axis, as_json, integrator, window, workers
from .tables import print_json
from .targets import force, refuse, resumed

if TYPE_CHECKING:
    from ..motion import Trajectory

#: Where a value came from that was typed.
COMMANDLINE = click.core.ParameterSource.COMMANDLINE
PLOT = click.option(
    "--plot", type=click.Path(dir_okay=False, path_type=Path), metavar="FILE", help="Draw the motion (pdf, png, svg)."
)
#: Longest motion that a command follows, in the model's unit of time: one is kept whole, those of a sweep followed to the end.
LONGEST = 2e6
#: Why it is bounded in a sweep.
EACH = "each motion of a sweep is followed to its end"


RTOL = click.option("--rtol", type=float, default=1e-10, show_default=True, help="Relative tolerance.")


@of_model(start=True)
@window
@RTOL
@integrator("heyoka", "compiled", "scipy")
@click.option("--error", "estimate_error", is_flag=True, help="Estimate the error by a second run at a tighter tolerance.")
@click.option("--output", "-o", type=click.Path(path_type=Path), help="Write the motion to FILE.nc or FILE.csv.")
@PLOT
@force
@as_json
def simulate(
    case: Case, t_end: float, transient: float | None, rtol: float, backend: str | None, estimate_error: bool,
    output: Path | None, plot: Path | None, force: bool, json_output: bool,
) -> None:  # fmt: skip
    """Integrate the motion from an initial state, by default from rest where all coordinates are 0.

    The article states neither the belt speed V nor the steepness d of the friction law: the defaults are an
    assumption. With --data, --t-end and --transient are in seconds, and the initial state in the file's units.

    \b
    Examples:
      spragsym simulate --theta0 49
      spragsym simulate --data brake.toml --t-end 0.5
      spragsym simulate --theta0 49 -V 0.2 --error -o run.nc
      spragsym simulate --model trolley --theta0 49

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    p, (t_end, transient) = case.set(), times(case, t_end, transient)
    refuse_targets(output, plot, force)
    tr = ss.simulate(p, t_end=t_end, rtol=rtol, backend=backend, estimate_error=estimate_error, **case.start)
    summary = {"model": case.model.name, **case.units.measured(summary_of(tr, transient))}
    if output is not None:
        tr.save(output)
    if plot is not None:
        _draw(case, tr, transient, plot)
    print_summary(summary, json_output)


def times(case: Case, t_end: float, transient: float | None, why: str = "all of a motion is kept") -> tuple[float, float]:
    """Until when, and from when on it is measured, in the model's unit of time; with a file they are typed in seconds."""
    second, of_file = case.units.time, case.units.study is not None
    typed = click.get_current_context().get_parameter_source("t_end") == COMMANDLINE
    t_end = t_end / second if typed else t_end
    transient = 0.75 * t_end if transient is None else transient / second
    if transient >= t_end:
        begins, ends = (f"{value * second:.9g}{' s' * of_file}" for value in (transient, t_end))
        raise ParameterError(f"--transient = {begins} is not below --t-end = {ends}; nothing would be left to measure")
    unit = case.model.about["scales"]["time"].replace("**", "^")
    if t_end > LONGEST:
        limit = f"{LONGEST:g} {unit}" + (f", which is {LONGEST * second:.3g} s" if of_file else "")
        raise ParameterError(f"--t-end is {t_end:g} {unit}, and {why}: give at most {limit}")
    if t_end > LONGEST / 20 and sys.stderr.isatty():
        click.echo(f"following the motion over {t_end:g} {unit}, for up to minutes; Ctrl-C ends it", err=True)
    return t_end, transient


def refuse_targets(output: Path | None, plot: Path | None, force: bool) -> None:
    """Refuse, before anything is computed, files for a motion and its picture that can't be written."""
    from ..files import storage

    if plot is not None:
        drawable(plot)
    refuse([one for one in (output, plot) if one is not None], force)
    if output is not None:
        storage.check_target(output, 10_000_000)


def summary_of(tr: Any, transient: float) -> dict[str, Any]:
    """What is said of a motion."""
    from ..motion import Event

    late = tr.after(transient)
    summary: dict[str, Any] = {
        "rms": late.rms(0.0, of=tr.components[0]), "rms_about_mean": late.rms(0.0, of=tr.components[0], about="mean"),
        "mean": late.mean(0.0, of=tr.components[0]), "largest": late.largest(0.0, of=tr.components[0]),
        "period": late.period(0.0), "converged": late.converged(0.0),
        **{kind.name.lower(): len(tr.events.of(kind)) for kind in Event}, "backend": tr.backend,
    }  # fmt: skip
    if tr.error is not None:
        summary["error"] = float(tr.error.max())
    return summary


def print_summary(summary: dict[str, Any], json_output: bool) -> None:
    """As a list or as JSON."""
    if json_output:
        print_json(summary)
        return
    for name, value in summary.items():
        click.echo(f"{name:18} {value:.10g}" if isinstance(value, float) else f"{name:18} {value}")


def _draw(case: Case, tr: Trajectory, transient: float, path: Path) -> None:
    from ..figures import motion_figure
    from ..figures.motion_pictures import Units

    study = case.units.study
    units = None if study is None else Units(1e3 * study.scales.length, study.scales.time, "mm")
    written(path, "drawing the motion", lambda: motion_figure(tr, transient, units))


@of_model(kind=Axis, start=True)
@window
@RTOL
@integrator("heyoka", "compiled", "scipy")
@workers(1)
@click.option("--quiet", "-q", is_flag=True, help="No progress bar.")
@click.option("--output", "-o", type=click.Path(path_type=Path), required=True, help="FILE.nc or FILE.csv.")
@force
def sweep(case: Case, t_end: float, transient: float | None, quiet: bool, output: Path, force: bool, **settings: Any) -> None:
    """Simulate over a grid of parameters, to a file.

    Every option that takes numbers is an axis: a single number, a,b,c, or start:stop:count. The grid is all
    combinations. Killed or interrupted, the same command goes on where it stopped; finished, it reads the
    file. The file holds theta0 in radians, and in degrees as theta0_deg.

    \b
    Examples:
      spragsym sweep --theta0 30:60:61 -o rms.nc
      spragsym sweep --theta0 30:60:61 -V 0.2,0.5,1 -j 2 -o rms.csv
      spragsym sweep --data brake.toml --theta0 40:60:21 -o rms.nc
      spragsym sweep --model stribeck --theta0 30:60:61 -o rms.nc

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    case.require()
    t_end, transient = times(case, t_end, transient, EACH)
    p, start = grid_of(case)
    options = {**start, **settings, "t_end": t_end, "transient": transient, "progress": not quiet, "store": output}
    run_sweep(lambda: ss.rms_sweep(p, **options), output, force)
    study = case.units.study
    if study is not None:
        unit, size = study.unit_of("m")
        click.echo(f"{output}: lengths are in units of {size:.4g} {unit}, times in {study.scales.time:.6g} s")


def grid_of(case: Case) -> tuple[Any, dict[str, FloatArray]]:
    """The parameters and the initial state, each axis of more than one number along a dimension of its own."""
    axes = {**case.values, **case.start}
    grid = dict(zip(axes, open_grid(list(axes.values())), strict=True))
    return case.model.Parameters(**{name: grid.pop(name) for name in case.values}), grid


def run_sweep(run: Callable[[], Any], output: Path, force: bool) -> None:
    """Run a sweep to its file, and say what its motions came to."""
    from ..motion.sweeps import Regime

    with resumed(force):
        result = run()
    counts = {regime: int(np.count_nonzero(result.regime == regime)) for regime in Regime}
    click.echo(f"{output}: " + ", ".join(f"{count} {regime.name.lower()}" for regime, count in counts.items() if count))


def open_grid(axes: list[FloatArray]) -> list[FloatArray]:
    """Axes of more than one number along dimensions of their own, the others as single numbers."""
    long = [i for i, axis in enumerate(axes) if axis.size > 1]
    opened = dict(zip(long, np.ix_(*(axes[i] for i in long)), strict=True))
    return [opened.get(i, axis.reshape(()) if axis.size == 1 else axis) for i, axis in enumerate(axes)]
