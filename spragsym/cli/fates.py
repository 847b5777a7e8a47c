"""``spragsym fates``: what motions come to, over a grid of parameters."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click
import numpy as np

from ..errors import ParameterError
from ..parameters import Parameters
from .commands import command
from .motion import BACKEND, axes, open_grid, start
from .options import workers
from .targets import force, refuse, resumed


@command()
@axes
@start
@click.option("--t-end", type=float, default=40_000.0, show_default=True, help="How long to follow a motion.")
@BACKEND
@workers(1)
@click.option("--quiet", "-q", is_flag=True, help="No progress bar.")
@click.option("--output", "-o", type=click.Path(path_type=Path), required=True, help="FILE.csv.")
@click.option("--plot", type=click.Path(dir_okay=False, path_type=Path), metavar="FILE", help="Draw the map (pdf, png, svg).")
@force
def fates(
    t_end: float, backend: str | None, workers: int, quiet: bool, output: Path, plot: Path | None, force: bool, **values: Any
) -> None:
    """What motions come to: rest, a cycle, chaos, lift-off, or undecided, and why.

    Every parameter is an axis: a single number, a,b,c, or start:stop:count; the map is of theta0 and mu0. Killed or interrupted,
    the same command goes on where it stopped; finished, it reads the file.

    \b
    Examples:
      spragsym fates --theta0 10:170:21 --mu0 0.1:1:10 -V 0.25 -o fates.csv --plot fates.pdf

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    from ..cycles import fate_map

    begin = [values.pop(name) for name in ("x0", "y0", "vx0", "vy0")]
    values["theta0"] = np.radians(values.pop("theta0_deg"))
    grid = {name: values[name] for name in Parameters.ranges}
    if plot is not None and (plot.suffix not in (".pdf", ".png", ".svg") or min(grid["theta0"].size, grid["mu0"].size) < 2):
        raise ParameterError(f"--plot {plot}: it draws a map over --theta0 and --mu0, and the ending is .pdf, .png or .svg")
    refuse([] if plot is None else [plot], force)
    opened = dict(zip(grid, open_grid(list(grid.values())), strict=True))
    with resumed(output, force):
        found = fate_map(
            Parameters(**opened), start=begin, t_end=t_end, backend=backend, workers=workers, progress=not quiet, store=output
        )
    if plot is not None:
        from ..figures import FORMATS, fate_map_figure
        from ..figures.style import house_style

        kind = plot.suffix[1:]
        with house_style():
            fate_map_figure(found).savefig(plot, format=kind, metadata=FORMATS[kind])
    click.echo(f"{output}: " + ", ".join(f"{count} {name}" for name, count in found.count().items() if count))
