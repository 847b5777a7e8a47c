"""``spragsym simulate`` and ``spragsym sweep``: motion in time."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from ..errors import ParameterError
from ..parameters import ARTICLE, NAMES, RANGES, FloatArray, Parameters, Range
from .commands import command
from .data import current, data, in_units, length, own_units
from .options import BELT, DEGREES, Axis, Number, as_json, belt, build, parameters, theta0, window, workers
from .tables import print_json
from .targets import force, refuse, resumed
from .with_model import ForModels, made_for, model_option

if TYPE_CHECKING:
    from ..dynamics import Trajectory

BACKEND = click.option(
    "--backend",
    type=click.Choice(["heyoka", "compiled", "scipy"]),
    help="Integrator. Default: heyoka where it is installed, else the compiled one.",
)
PLOT = click.option(
    "--plot", type=click.Path(dir_okay=False, path_type=Path), metavar="FILE", help="Draw the motion (pdf, png, svg)."
)
#: Longest motion that a command follows, in sqrt(m/k_c): a single one is kept whole, those of a sweep are followed to their ends.
LONGEST = 2e6
#: Why it is bounded in a sweep.
EACH = "each motion of a sweep is followed to its end"

RTOL = click.option("--rtol", type=float, default=1e-10, show_default=True, help="Relative tolerance.")


def start(function: Any) -> Any:
    """``--x0 --y0 --vx0 --vy0``."""
    for name, meaning in (
        ("vy0", "speed across it"),
        ("vx0", "speed along it"),
        ("y0", "place across it"),
        ("x0", "place along the belt"),
    ):
        function = click.option(f"--{name}", type=Number(), default=0.0, show_default=True, help=f"Initial {meaning}.")(function)
    return function


@command(cls=ForModels)
@model_option
@theta0
@parameters
@belt
@start
@window
@RTOL
@BACKEND
@click.option(
    "--error",
    "estimate_error",
    is_flag=True,
    help="Estimate the error by a second run at a tighter tolerance.",
)
@click.option("--output", "-o", type=click.Path(path_type=Path), help="Write the motion to FILE.nc or FILE.csv.")
@PLOT
@force
@data
@as_json
def simulate(
    theta0_deg: float, V: float, d: float, t_end: float, transient: float, rtol: float, backend: str | None,
    estimate_error: bool, output: Path | None, plot: Path | None, force: bool, json_output: bool, **values: float,
) -> None:  # fmt: skip
    """Integrate the motion from an initial state, by default from rest at x = y = 0.

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
    from ..dynamics import simulate as integrate

    p = build(theta0_deg, **{name: values.pop(name) for name in ARTICLE})
    times, values = own_units({"t_end": t_end, "transient": transient}, values)
    t_end, transient = times["t_end"], times["transient"]
    check_length(t_end)
    refuse_targets(output, plot, force)
    tr = integrate(
        p, V=V, d=d, t_end=t_end, rtol=rtol, backend=backend, estimate_error=estimate_error, **values  # type: ignore[arg-type]  # values by name, of several types
    )  # fmt: skip
    summary = in_units(summary_of(tr, transient))
    if output is not None:
        tr.save(output)
    if plot is not None:
        _draw(tr, transient, plot)
        click.echo(f"drew {plot}", err=True)
    print_summary(summary, json_output)


def check_length(t_end: float, why: str = "all of a motion is kept") -> None:
    """Refuse a motion that memory can't hold, or that would last for days, and say on a terminal that a long one lasts."""
    if t_end > LONGEST:
        study = current()
        limit = f"{LONGEST:g} sqrt(m/k_c)" + ("" if study is None else f", which is {LONGEST * study.scales.time:.3g} s")
        raise ParameterError(f"--t-end is {t_end:g} sqrt(m/k_c), and {why}: give at most {limit}")
    if t_end > LONGEST / 20 and sys.stderr.isatty():
        click.echo(f"following the motion over {t_end:g} sqrt(m/k_c), for up to minutes; Ctrl-C ends it", err=True)


def refuse_targets(output: Path | None, plot: Path | None, force: bool) -> None:
    """Refuse, before anything is computed, files for a motion and its picture that can't be written."""
    from ..files import storage

    if plot is not None and plot.suffix not in (".pdf", ".png", ".svg"):
        raise ParameterError(f"--plot {plot}: the ending must be .pdf, .png or .svg")
    refuse([one for one in (output, plot) if one is not None], force)
    if output is not None:
        storage.check_target(output, 10_000_000)


def summary_of(tr: Any, transient: float) -> dict[str, Any]:
    """What is said of a motion."""
    from ..dynamics import Event

    late = tr.after(transient)
    summary: dict[str, Any] = {
        "rms": late.rms(0.0, of=tr.components[0]), "rms_about_mean": late.rms(0.0, of=tr.components[0], about="mean"),
        "mean": late.mean(0.0, of=tr.components[0]), "amplitude": late.amplitude(0.0, of=tr.components[0]),
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


def _draw(tr: Trajectory, transient: float, path: Path) -> None:
    from ..figures import FORMATS, motion_figure
    from ..figures.motion_pictures import Units
    from ..figures.style import house_style

    kind, study = path.suffix[1:], current()
    units = None if study is None else Units(length()[0], study.scales.time, study.quantities["L_0"].unit)
    with house_style():
        motion_figure(tr, transient, units).savefig(path, format=kind, metadata=FORMATS[kind])


def axes(function: Any) -> Any:
    """Every parameter as an axis of the grid."""
    axes: list[tuple[tuple[str, ...], float | None, Range, str]] = [
        (("--theta0", "theta0_deg"), None, DEGREES, "Inclination, degrees.")
    ]
    axes += [((f"--{name}",), value, RANGES[name], f"Parameter {name}.") for name, value in ARTICLE.items()]
    axes += [((flag, short, name), default, allowed, text) for flag, short, name, default, allowed, text in reversed(BELT)]
    for names, default, allowed, text in reversed(axes):
        required, kind = default is None, Axis(allowed)
        function = click.option(*names, type=kind, default=default, required=required, show_default=True, help=text)(function)
    return function


@command(cls=ForModels)
@model_option
@axes
@start
@window
@RTOL
@BACKEND
@workers(1)
@click.option("--quiet", "-q", is_flag=True, help="No progress bar.")
@click.option("--output", "-o", type=click.Path(path_type=Path), required=True, help="FILE.nc or FILE.csv.")
@force
@data
def sweep(
    V: FloatArray, d: FloatArray, t_end: float, transient: float, rtol: float, backend: str | None,
    workers: int, quiet: bool, output: Path, force: bool, **values: Any,
) -> None:  # fmt: skip
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

    from ..sweeps import rms_sweep

    start = {name: values.pop(name) for name in ("x0", "y0", "vx0", "vy0")}
    times, start = own_units({"t_end": t_end, "transient": transient}, start)
    check_length(times["t_end"], EACH)
    axes = {"theta0": np.radians(values.pop("theta0_deg")), **values, "V": V, "d": d}
    grid = dict(zip(axes, open_grid(list(axes.values())), strict=True))
    p = Parameters(**{name: grid[name] for name in NAMES})
    settings: dict[str, Any] = {"rtol": rtol, "backend": backend, "workers": workers, **times}
    run_sweep(lambda: rms_sweep(p, grid["V"], grid["d"], **start, **settings, progress=not quiet, store=output), output, force)
    study = current()
    if study is not None:
        scales = study.scales
        click.echo(f"{output}: lengths are in units of {study.shown('L_0', scales.length)}, times in {scales.time:.6g} s")


def run_sweep(run: Callable[[], Any], output: Path, force: bool) -> None:
    """Run a sweep to its file, and say what its motions came to."""
    from ..sweeps import Regime

    with resumed(output, force), warnings.catch_warnings():
        warnings.showwarning = lambda message, *_: click.echo(f"spragsym: warning: {message}", err=True)
        result = run()
    counts = {regime: int(np.count_nonzero(result.regime == regime)) for regime in Regime}
    click.echo(f"{output}: " + ", ".join(f"{count} {regime.name.lower()}" for regime, count in counts.items() if count))


def open_grid(axes: list[FloatArray]) -> list[FloatArray]:
    """Axes of more than one number along dimensions of their own, the others as single numbers."""
    long = [i for i, axis in enumerate(axes) if axis.size > 1]
    opened = dict(zip(long, np.ix_(*(axes[i] for i in long)), strict=True))
    return [opened.get(i, axis.reshape(()) if axis.size == 1 else axis) for i, axis in enumerate(axes)]


made_for(simulate, "model_motion", "simulate_of")
made_for(sweep, "model_motion", "sweep_of")
