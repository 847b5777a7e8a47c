"""``spragsym simulate``, ``sweep`` and ``fates``: motion in time, over a grid of parameters, and what it comes to."""

from pathlib import Path
from typing import Any

import click
import numpy as np

import spragsym as ss

from ..errors import ParameterError
from ..models.parameters import FloatArray
from ..progress import show_progress
from . import options as o
from .of_model import Case, of_model
from .output import drawn, refuse, resumed

#: Longest motion that a command follows, in the model's unit of time: one is kept whole, those of a sweep followed to the end.
LONGEST = 2e6


@of_model(start=True)
@o.t_end
@o.transient
@o.rtol
@o.backend("heyoka", "compiled", "scipy")
@click.option("--error", "estimate_error", is_flag=True, help="Estimate the error by a second run at a tighter tolerance.")
@o.file("--output", "-o", folder=True, help="Write the motion to FILE.nc or FILE.csv.")
@o.plot("the motion")
@o.force
@o.as_json
def simulate(
    case: Case, t_end: float, transient: float | None, output: Path | None, plot: Path | None, force: bool, **settings: Any
) -> Any:  # fmt: skip
    """Integrate the motion from an initial state, by default from rest where all coordinates are 0.

    The article states neither the belt speed V nor the steepness d of the friction law: the defaults are an
    assumption. With --data, --t-end and --transient are in seconds, and the initial state in the file's units.

    \b
    Examples:
      spragsym simulate --theta0 49
      spragsym simulate --data brake.toml --t-end 0.5
      spragsym simulate --theta0 49 -V 0.2 --error -o run.nc
      spragsym simulate --model trolley --theta0 49
    """
    from ..files import storage

    p, (t_end, transient) = case.set(), _times(case, t_end, transient, "all of a motion is kept")
    refuse([output], force)
    if output is not None:
        storage.check_target(output, 10_000_000)
    with show_progress("following the motion"):
        tr = ss.simulate(p, t_end=t_end, **case.start, **settings)
    summary = case.row(_summary(tr, transient))
    if output is not None:
        tr.save(output)
    if plot is not None:
        from ..figures import motion_figure
        from ..figures.motion_pictures import Units

        units = None if case.study is None else Units(1e3 * case.study.scales.length, case.study.scales.time, "mm")
        drawn(plot, "drawing the motion", lambda: motion_figure(tr, transient, units))

    def table() -> None:
        for name, value in {"model": case.model.name, **summary}.items():
            click.echo(f"{name:18} {value:.10g}" if isinstance(value, float) else f"{name:18} {value}")

    return summary, table


def _times(case: Case, t_end: float, transient: float | None, why: str) -> tuple[float, float]:
    """Until when, and from when on it is measured, in the model's unit of time; with a file they are typed in seconds."""
    second, of_file = case.time, case.study is not None
    typed = click.get_current_context().get_parameter_source("t_end") == click.core.ParameterSource.COMMANDLINE
    t_end = t_end / second if typed else t_end
    transient = 0.75 * t_end if transient is None else transient / second
    if transient >= t_end:
        begins, ends = (f"{value * second:.9g}{' s' * of_file}" for value in (transient, t_end))
        raise ParameterError(f"--transient = {begins} is not below --t-end = {ends}; nothing would be left to measure")
    unit = case.model.about["scales"]["time"].replace("**", "^")
    if t_end > LONGEST:
        limit = f"{LONGEST:g} {unit}" + (f", which is {LONGEST * second:.3g} s" if of_file else "")
        raise ParameterError(f"--t-end is {t_end:g} {unit}, and {why}: give at most {limit}")
    return t_end, transient


def _summary(tr: Any, transient: float) -> dict[str, Any]:
    """What is said of a motion."""
    late, first = tr.after(transient), tr.components[0]
    return {
        "rms": late.rms(0.0, of=first), "rms_about_mean": late.rms(0.0, of=first, about="mean"),
        "mean": late.mean(0.0, of=first), "largest": late.largest(0.0, of=first),
        "period": late.period(0.0), "converged": late.converged(0.0),
        **{kind.name.lower(): len(tr.events.of(kind)) for kind in ss.Event}, "backend": tr.backend,
        **({} if tr.error is None else {"error": float(tr.error.max())}),
    }  # fmt: skip


@of_model(kind=o.Axis, start=True)
@o.t_end
@o.transient
@o.rtol
@o.backend("heyoka", "compiled", "scipy")
@o.workers(1)
@o.quiet
@o.file("--output", "-o", "store", folder=True, required=True, help="FILE.nc or FILE.csv.")
@o.force
def sweep(case: Case, t_end: float, transient: float | None, quiet: bool, store: Path, force: bool, **settings: Any) -> None:
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
    """
    from ..motion.sweeps import Regime

    case.require()
    t_end, transient = _times(case, t_end, transient, "each motion of a sweep is followed to its end")
    p, start = _grid(case)
    with resumed(force):
        options = {**start, **settings, "t_end": t_end, "transient": transient, "progress": not quiet, "store": store}
        result = ss.rms_sweep(p, **options)
    counts = {regime: int(np.count_nonzero(result.regime == regime)) for regime in Regime}
    click.echo(f"{store}: " + ", ".join(f"{count} {regime.name.lower()}" for regime, count in counts.items() if count))
    if case.study is not None:
        unit, size = case.study.unit_of("m")
        click.echo(f"{store}: lengths are in units of {size:.4g} {unit}, times in {case.time:.6g} s")


def _grid(case: Case) -> tuple[Any, dict[str, FloatArray]]:
    """The parameters and the initial state, each axis of more than one number along a dimension of its own."""
    axes = {**case.values, **case.start}
    long = [name for name, axis in axes.items() if axis.size > 1]
    opened = dict(zip(long, np.ix_(*(axes[name] for name in long)), strict=True))
    grid = {name: opened.get(name, axis.reshape(()) if axis.size == 1 else axis) for name, axis in axes.items()}
    return case.model.Parameters(**{name: grid.pop(name) for name in case.values}), grid


@of_model(kind=o.Axis, start=True)
@click.option("--t-end", type=float, default=40_000.0, help="How long to follow it; exponents come after.")
@o.backend("heyoka", "scipy")
@o.workers(1)
@o.quiet
@o.file("--output", "-o", "store", folder=True, required=True, help="FILE.csv.")
@o.plot("the map")
@o.force
def fates(case: Case, quiet: bool, store: Path, plot: Path | None, force: bool, **settings: Any) -> None:
    """What motions come to: rest, a cycle, chaos, lift-off, or undecided, and why.

    Every parameter is an axis: a single number, a,b,c, or start:stop:count; a picture is of two that vary. Killed or interrupted,
    the same command goes on where it stopped; finished, it reads the file.

    \b
    Examples:
      spragsym fates --theta0 10:170:21 --mu0 0.1:1:10 -V 0.25 -o fates.csv --plot fates.pdf
    """
    from ..orbits import fate_map

    case.require()
    if plot is not None and sum(np.size(values) > 1 for values in case.values.values()) != 2:
        raise ParameterError(f"--plot {plot}: it draws a map over two parameters that vary; give two of them several values")
    p, start = _grid(case)
    begin = [float(value) for value in start.values()]
    with resumed(force):
        found = fate_map(p, start=begin, progress=not quiet, store=store, **settings)
    if plot is not None:
        from ..figures import fate_map_figure

        drawn(plot, "drawing the map", lambda: fate_map_figure(found))
    click.echo(f"{store}: " + ", ".join(f"{count} {name}" for name, count in found.count().items() if count))
