"""``spragsym simulate`` and ``spragsym sweep``: motion in time."""

from __future__ import annotations

import json
import math
import warnings
from pathlib import Path
from typing import Any

import click
import numpy as np

from ..parameters import ARTICLE, NAMES, FloatArray, Parameters
from .options import as_json, belt, build, parameters, theta0

_BACKEND = click.option(
    "--backend",
    type=click.Choice(["heyoka", "scipy"]),
    help="Integrator. Default: heyoka where it is installed.",
)
_RTOL = click.option("--rtol", type=float, default=1e-10, show_default=True, help="Relative tolerance.")
_T_END = click.option(
    "--t-end", type=float, default=2000.0, show_default=True, help="Until when, in sqrt(m/k_c)."
)
_TRANSIENT = click.option(
    "--transient",
    type=float,
    default=1500.0,
    show_default=True,
    help="What to leave out of RMS, amplitude and period.",
)


def _start(function: Any) -> Any:
    """``--x0 --y0 --vx0 --vy0``."""
    for name, meaning in (
        ("vy0", "speed across it"),
        ("vx0", "speed along it"),
        ("y0", "place across it"),
        ("x0", "place along the belt"),
    ):
        function = click.option(
            f"--{name}", type=float, default=0.0, show_default=True, help=f"Initial {meaning}."
        )(function)
    return function


@click.command()
@theta0
@parameters
@belt
@_start
@_T_END
@_TRANSIENT
@_RTOL
@_BACKEND
@click.option(
    "--error",
    "estimate_error",
    is_flag=True,
    help="Estimate the error by a second run at a tighter tolerance.",
)
@click.option(
    "--output", "-o", type=click.Path(path_type=Path), help="Write the motion to FILE.nc or FILE.csv."
)
@as_json
def simulate(
    theta0_deg: float, V: float, d: float, t_end: float, transient: float, rtol: float, backend: str | None,
    estimate_error: bool, output: Path | None, json_output: bool, **values: float,
) -> None:  # fmt: skip
    """Integrate the motion from an initial state, by default from rest at x = y = 0.

    The article states neither the belt speed V nor the steepness d of the friction law: the defaults are an
    assumption.

    \b
    Examples:
      spragsym simulate --theta0 49
      spragsym simulate --theta0 49 -V 0.2 --error -o run.nc

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    from .. import storage
    from ..dynamics import Event
    from ..dynamics import simulate as integrate

    p = build(theta0_deg, **{name: values.pop(name) for name in ARTICLE})
    if output is not None:
        storage.check_target(output, 10_000_000)
    tr = integrate(
        p, V=V, d=d, t_end=t_end, rtol=rtol, backend=backend, estimate_error=estimate_error, **values  # type: ignore[arg-type]
    )  # fmt: skip
    late = tr.after(transient)
    assert tr.events is not None
    summary: dict[str, Any] = {
        "rms": late.rms(0.0), "rms_about_mean": late.rms(0.0, about="mean"), "mean": late.mean(0.0),
        "amplitude": late.amplitude(0.0), "period": late.period(0.0), "converged": late.converged(0.0),
        **{kind.name.lower(): len(tr.events.of(kind)) for kind in Event}, "backend": tr.backend,
    }  # fmt: skip
    if tr.error is not None:
        summary["error"] = float(tr.error.max())
    if output is not None:
        tr.save(output)
    if json_output:
        click.echo(json.dumps(_plain(summary), indent=1))
    else:
        for name, value in summary.items():
            click.echo(f"{name:16} {value:.10g}" if isinstance(value, float) else f"{name:16} {value}")


class Axis(click.ParamType):  # type: ignore[type-arg,unused-ignore]  # generic in some versions of click
    """Numbers ``a,b,c``, or ``start:stop:count`` for equal steps, ends included."""

    name = "numbers"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> FloatArray:
        if isinstance(value, float | int):
            return np.array([float(value)])
        try:
            if ":" in value:
                start, stop, count = value.split(":")
                return np.linspace(float(start), float(stop), int(count))
            return np.array([float(number) for number in value.split(",")])
        except ValueError:
            self.fail(
                f"{value!r} is neither numbers like 0.2,0.5 nor start:stop:count like 30:60:61", param, ctx
            )


def _axes(function: Any) -> Any:
    """Every parameter as an axis of the grid."""
    axes: list[tuple[str, str, float | None, str]] = [
        ("--theta0", "theta0_deg", None, "Inclination, degrees.")
    ]
    axes += [(f"--{name}", name, value, f"Parameter {name}.") for name, value in ARTICLE.items()]
    for flag, name, default, text in reversed(axes):
        function = click.option(
            flag, name, type=Axis(), default=default, required=default is None, show_default=True, help=text
        )(function)  # fmt: skip
    function = click.option(
        "--creep",
        "-d",
        "d",
        type=Axis(),
        default=10.0,
        show_default=True,
        help="Steepness d of the friction law. Our assumption.",
    )(function)
    return click.option(
        "--speed",
        "-V",
        "V",
        type=Axis(),
        default=0.5,
        show_default=True,
        help="Belt speed V. Our assumption.",
    )(function)


@click.command()
@_axes
@_start
@_T_END
@_TRANSIENT
@_RTOL
@_BACKEND
@click.option("--workers", "-j", type=int, default=1, show_default=True, help="Processes; -1 for one a core.")
@click.option("--quiet", "-q", is_flag=True, help="No progress bar.")
@click.option("--output", "-o", type=click.Path(path_type=Path), required=True, help="FILE.nc or FILE.csv.")
def sweep(
    V: FloatArray, d: FloatArray, t_end: float, transient: float, rtol: float, backend: str | None,
    workers: int, quiet: bool, output: Path, **values: Any,
) -> None:  # fmt: skip
    """Simulate over a grid of parameters, to a file.

    Every option that takes numbers is an axis: a single number, a,b,c, or start:stop:count. The grid is all
    combinations. Killed or interrupted, the same command goes on where it stopped.

    \b
    Examples:
      spragsym sweep --theta0 30:60:61 -o rms.nc
      spragsym sweep --theta0 30:60:61 -V 0.2,0.5,1 -j 2 -o rms.csv

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    from ..sweeps import Regime, rms_sweep

    start = {name: values.pop(name) for name in ("x0", "y0", "vx0", "vy0")}
    axes = {"theta0": np.radians(values.pop("theta0_deg")), **values, "V": V, "d": d}
    grid = dict(zip(axes, _open_grid(list(axes.values())), strict=True))
    p = Parameters(**{name: grid[name] for name in NAMES})
    with warnings.catch_warnings():
        warnings.showwarning = lambda message, *_: click.echo(f"spragsym: warning: {message}", err=True)
        result = rms_sweep(
            p, grid["V"], grid["d"], **start, t_end=t_end, transient=transient, rtol=rtol, backend=backend,
            workers=workers, progress=not quiet, store=output,
        )  # fmt: skip
    counts = {regime: int(np.count_nonzero(result.regime == regime)) for regime in Regime}
    click.echo(
        f"{output}: "
        + ", ".join(f"{count} {regime.name.lower()}" for regime, count in counts.items() if count)
    )


def _open_grid(axes: list[FloatArray]) -> list[FloatArray]:
    """Axes of more than one number along dimensions of their own, the others as single numbers."""
    long = [i for i, axis in enumerate(axes) if axis.size > 1]
    opened = dict(zip(long, np.ix_(*(axes[i] for i in long)), strict=True))
    return [opened.get(i, axis.reshape(()) if axis.size == 1 else axis) for i, axis in enumerate(axes)]


def _plain(summary: dict[str, Any]) -> dict[str, Any]:
    """NaN is not JSON."""
    return {
        name: None if isinstance(value, float) and math.isnan(value) else value
        for name, value in summary.items()
    }
