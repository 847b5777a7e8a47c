"""``spragsym bifurcation``: cusps, folds, flutter onsets and critical frictions in one table."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import click

from ..errors import ParameterError
from ..parameters import shown
from .commands import command
from .data import data, length
from .options import as_json, build, parameters
from .tables import print_json, print_table
from .targets import force, refuse
from .with_model import ForModels, made_for, model_option


@command(cls=ForModels)
@model_option
@parameters
@as_json
@click.option(
    "--plot", type=click.Path(dir_okay=False, path_type=Path), metavar="FILE", help="Draw the bifurcation set (pdf, png, svg)."
)
@force
@data
def bifurcation(json_output: bool, plot: Path | None, force: bool, **values: float) -> None:
    """Cusps, folds at the given friction, flutter onsets, and the critical frictions.

    For a flutter onset, branch is the rank of the equilibrium by theta, from 0, and side says where it flutters: 1 at larger
    theta0, -1 at smaller theta0.

    \b
    Examples:
      spragsym bifurcation
      spragsym bifurcation --alpha 0.7 --json
      spragsym bifurcation --plot folds.pdf
      spragsym bifurcation --data brake.toml
      spragsym bifurcation --model two_springs

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    if plot is not None and plot.suffix not in (".pdf", ".png", ".svg"):
        raise ParameterError(f"--plot {plot}: the ending must be .pdf, .png or .svg")
    refuse([] if plot is None else [plot], force)
    summary = _summary(values)
    if plot is not None:
        from ..figures import FORMATS, bifurcation_figure
        from ..figures.style import house_style

        kind = plot.suffix[1:]
        with house_style():
            bifurcation_figure(build(None, **values)).savefig(plot, format=kind, metadata=FORMATS[kind])
        click.echo(f"drew {plot}", err=True)
    if json_output:
        print_json(summary)
        return
    place = tuple(name + length()[1] for name in ("x", "y"))
    for title, name, header in (
        ("Cusps in contact, mirror images included", "cusps", ("theta0_deg", "mu0", "theta_deg", *place)),
        (f"Folds at mu0 = {shown(values['mu0'])}", "folds", ("theta0_deg", "theta_deg", *place)),
        (f"Flutter onsets at mu0 = {shown(values['mu0'])}", "flutter", ("theta0_deg", "theta_deg", *place, "branch", "side")),
    ):
        print_table(title, header, [[row[column] for column in header] for row in summary[name]])
    print_table("Critical frictions", ("", "mu"), [
        ("mu_cr, linear sprag model: poles above it", _or(summary["mu_cr"], "out of range")),
        ("mu_lowest: no jump from small deformation below it", _or(summary["mu_lowest"], "none")),
        ("mu_cusp: the lowest cusp", _or(summary["mu_cusp"], "none")),
    ])  # fmt: skip


def _or(value: float | None, word: str) -> float | str:
    return word if value is None else value


def _summary(values: dict[str, float]) -> dict[str, Any]:
    import numpy as np

    from .. import catastrophe
    from ..catastrophe import flutter_points as flutter

    p = build(None, **values)
    found, turns, onsets = catastrophe.cusps(p), catastrophe.folds(p), flutter.flutter_onsets(p)
    lowest, cusp = catastrophe.critical_friction(p), float(catastrophe.cusp_friction(p))
    with np.errstate(all="ignore"):  # stiffnesses of very different size
        linear = float(catastrophe.linear_critical_friction(p))

    size, end = length()
    units = {name: (math.degrees(1.0), "_deg") for name in ("theta0", "theta")} | dict.fromkeys(("L", "x", "y"), (size, end))

    def rows(points: Any, names: tuple[str, ...]) -> list[dict[str, float]]:
        return [
            {
                name + units.get(name, (1.0, ""))[1]: getattr(points, name)[i].item() * units[name][0]
                if name in units
                else getattr(points, name)[i].item()
                for name in names
            }
            for i in range(points.theta0.size)
        ]

    return {
        "parameters": values,
        "cusps": rows(found, ("theta0", "mu0", "theta", "L", "x", "y")),
        "folds": rows(turns, ("theta0", "theta", "L", "x", "y")),
        "flutter": rows(onsets, ("theta0", "theta", "L", "x", "y", "branch", "side")),
        "mu_cr": linear if math.isfinite(linear) else None,
        "mu_lowest": float(lowest) if lowest.kind else None,
        "theta0_lowest_deg": math.degrees(lowest.theta0) if lowest.kind else None,
        "kind_lowest": lowest.kind or None,
        "mu_cusp": None if math.isinf(cusp) else cusp,
    }


made_for(bifurcation, "model_statics", "bifurcation_of")
