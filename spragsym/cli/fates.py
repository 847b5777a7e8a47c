"""``spragsym fates``: what motions come to, over a grid of parameters."""

from __future__ import annotations

from pathlib import Path

import click
import numpy as np

from ..errors import ParameterError
from .drawings import written
from .motion import grid_of
from .of_model import Case, of_model
from .options import Axis, integrator, workers
from .targets import force, refuse, resumed


@of_model(kind=Axis, start=True)
@click.option("--t-end", type=float, default=40_000.0, show_default=True, help="How long to follow it; exponents come after.")
@integrator("heyoka", "scipy")
@workers(1)
@click.option("--quiet", "-q", is_flag=True, help="No progress bar.")
@click.option("--output", "-o", type=click.Path(path_type=Path), required=True, help="FILE.csv.")
@click.option("--plot", type=click.Path(dir_okay=False, path_type=Path), metavar="FILE", help="Draw the map (pdf, png, svg).")
@force
def fates(
    case: Case, t_end: float, backend: str | None, workers: int, quiet: bool, output: Path, plot: Path | None, force: bool
) -> None:
    """What motions come to: rest, a cycle, chaos, lift-off, or undecided, and why.

    Every parameter is an axis: a single number, a,b,c, or start:stop:count; a picture is of two that vary. Killed or interrupted,
    the same command goes on where it stopped; finished, it reads the file.

    \b
    Examples:
      spragsym fates --theta0 10:170:21 --mu0 0.1:1:10 -V 0.25 -o fates.csv --plot fates.pdf

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    from ..orbits import fate_map

    case.require()
    varied = [name for name, values in case.values.items() if np.size(values) > 1]
    if plot is not None and (plot.suffix not in (".pdf", ".png", ".svg") or len(varied) != 2):
        raise ParameterError(f"--plot {plot}: it draws a map over two parameters that vary, and the ending is .pdf, .png or .svg")
    refuse([] if plot is None else [plot], force)
    p, start = grid_of(case)
    begin = [float(value) for value in start.values()]
    with resumed(force):
        found = fate_map(p, start=begin, t_end=t_end, backend=backend, workers=workers, progress=not quiet, store=output)
    if plot is not None:
        from ..figures import fate_map_figure

        written(plot, "drawing the map", lambda: fate_map_figure(found))
    click.echo(f"{output}: " + ", ".join(f"{count} {name}" for name, count in found.count().items() if count))
