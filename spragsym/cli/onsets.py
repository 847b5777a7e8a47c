"""``spragsym onsets``: curves of Hopf points in the plane of two parameters, gentle or dangerous: a map of stability."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

import spragsym as ss

from ..errors import ParameterError
from ..progress import show_progress
from .bifurcation import plane
from .drawings import written
from .of_model import Case, of_model
from .options import as_json
from .spans import Span, Typed, vary
from .states import boxes_of, placed, summed
from .tables import print_json, print_table
from .targets import force

if TYPE_CHECKING:
    from ..bifurcation.hopf_curves import OnsetCurve, OnsetCurves


@of_model(statics=True)
@vary("A parameter, with a range as theta0=5:175; give two. Default: {axes}.", multiple=True)
@click.option(
    "--undamped", is_flag=True, help="By (27), without dampers and the slope of the friction law: where two modes meet."
)
@click.option(
    "--plot", type=click.Path(dir_okay=False, path_type=Path), metavar="FILE", help="Draw the map of stability (pdf, png, svg)."
)
@click.option(
    "--n",
    type=click.IntRange(2, 2000),
    default=30,
    show_default=True,
    help="Lines of either parameter on which they are sought.",
)
@force
@as_json
def onsets(
    case: Case, vary: tuple[Typed, ...], undamped: bool, plot: Path | None, n: int, force: bool, json_output: bool
) -> None:  # fmt: skip
    """Where oscillation sets in over the plane of two parameters, gently or with a knock: a map of stability.

    Onsets are Hopf points with all damping, that of the friction law included; on curves of them those points too at which their
    kind changes (GH) and at which they meet folds (BT, ZH) and each other (HH).

    \b
    Examples:
      spragsym onsets --vary theta0=20:60 --vary mu0=0:1
      spragsym onsets --model stick_slip --vary V=0:1 --vary zeta=0:2 --plot map.pdf
      spragsym onsets --model mode_coupling --vary sigma=0.1:2 --vary mu0=0:2 --undamped --plot map.pdf

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    along = plane(case, vary, plot, force)
    if len(along) != 2:
        raise ParameterError(f"onsets of {case.model.name} are curves in a plane; give two different parameters with --vary")
    names = tuple(one.name for one in along)
    between = {name: ends for one in along for name, ends in one.between.items()}
    with show_progress(f"searching for onsets in the plane of {' and '.join(names)}"):
        found = ss.onset_curves(case.set(*names), names, n, damping=not undamped, between=between)
    if plot is not None:
        from ..figures import stability_figure

        across, up = (case.units.axis(name) for name in names)
        written(plot, f"drawing onsets in the plane of {' and '.join(names)}", lambda: stability_figure(found), [(across, up)])
    curves = [{"criticality": curve.criticality.tolist(), **_columns(case, curve, along)} for curve in found.curves]
    points = _points(case, found, along)
    undecided, remarks = boxes_of(case, list(found.undecided), (*case.model.coordinates, *names)), case.units.said(found.remarks)
    if json_output:
        told = {"curves": curves, "points": points, "complete": found.complete, "undecided": undecided, "remarks": remarks}
        print_json({"model": case.model.name, "parameters": case.told(), **told})
        return
    rows = [[number, *_summary(curve, along)] for number, curve in enumerate(curves, 1)]
    header = ["curve", "points", *(f"{span.title} {end}" for span in along for end in ("from", "to")), "onset"]
    print_table("Onsets", header, rows)
    titles = [span.title for span in along]
    print_table("Points on them", ["kind", *titles], [[row["kind"], *(row[title] for title in titles)] for row in points])
    if undecided:
        click.echo(f"Onsets: not complete, {summed(undecided)}")
    elif not found.complete:
        click.echo("Onsets: not complete")
    for remark in remarks:
        click.echo(f"Onsets: {remark}")
    click.echo(f"Onsets: sought on {n} lines of either parameter; a curve that closes between two of them is not seen")


def _columns(case: Case, curve: OnsetCurve, along: Sequence[Span]) -> dict[str, list[float]]:
    """A curve in the units of the answer."""
    omega, per = case.units.rate("omega")
    every = {span.title: span.unit * getattr(curve, span.name) for span in along}
    for name in case.model.coordinates:
        title, unit = case.units.place(name)
        every[title] = unit * getattr(curve, name)
    every |= {omega: per * curve.omega, "lyapunov": curve.lyapunov, "lyapunov_error": curve.lyapunov_error}
    return {title: column.tolist() for title, column in every.items()}


def _points(case: Case, found: OnsetCurves, along: Sequence[Span]) -> list[dict[str, Any]]:
    """Points at which two conditions hold, and those at which the kind of the onset changes."""
    names = (*(span.name for span in along), *case.model.coordinates, "error")
    points = {name: getattr(found.points, name) for name in names}
    rows = [(str(kind), {name: column[row] for name, column in points.items()}) for row, kind in enumerate(found.points.kind)]
    rows += [("GH", {name: found.changes[name][row] for name in names}) for row in range(len(found.changes["error"]))]
    return [
        {
            "kind": kind,
            **{span.title: span.unit * float(at[span.name]) for span in along},
            **placed(case.units, case.model.coordinates, at.__getitem__),
            "error": float(at["error"]),
        }
        for kind, at in rows
    ]


def _summary(curve: dict[str, Any], along: Sequence[Span]) -> list[Any]:
    """How many points, between which values, and of which kinds."""
    ends = [end(curve[span.title]) for span in along for end in (np.min, np.max)]
    kinds = [kind for kind in ("gentle", "dangerous", "undecided") if kind in curve["criticality"]]
    return [len(curve["criticality"]), *map(float, ends), ", ".join(kinds)]
