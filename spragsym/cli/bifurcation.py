"""``spragsym bifurcation``: folds and onsets of flutter along one parameter, cusps in the plane of two."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import click
import numpy as np

import spragsym as ss

from ..errors import ParameterError
from ..progress import show_progress
from .drawings import drawable, written
from .of_model import Case, method, of_model
from .options import as_json
from .points import points_of, print_points
from .spans import Span, Typed, box, span, vary, within
from .tables import print_json
from .targets import force, refuse


@of_model(statics=True)
@vary(
    "A parameter, with a range as theta0=5:175. Of two, folds and onsets are looked for along the first, cusps in the plane of "
    "both; of one, no cusps. Default: {axes}.",
    multiple=True,
)
@within
@click.option("--undamped", is_flag=True, help="Onsets of flutter by (27), without dampers and the slope of the friction law.")
@method
@click.option(
    "--plot", type=click.Path(dir_okay=False, path_type=Path), metavar="FILE", help="Draw the bifurcation set (pdf, png, svg)."
)
@click.option(
    "--n", type=click.IntRange(2, 2000), default=60, show_default=True,
    help="Lines of either parameter on which --plot searches for folds, where there is no closed form.",
)  # fmt: skip
@force
@as_json
def bifurcation(
    case: Case, vary: tuple[Typed, ...], within: tuple[Typed, ...], undamped: bool, plot: Path | None, n: int, force: bool,
    json_output: bool,
) -> None:  # fmt: skip
    """All folds and flutter onsets along one parameter, and all cusps in the plane of two, proved.

    \b
    Examples:
      spragsym bifurcation
      spragsym bifurcation --alpha 0.7 --undamped --json
      spragsym bifurcation --plot folds.pdf
      spragsym bifurcation --data brake.toml
      spragsym bifurcation --model two_springs --vary theta0=10:80 --vary mu0=0:1

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    along = plane(case, vary, plot, force)
    line, (name, *_) = along[:1], (one.name for one in along)
    between, asked, p = line[0].between, box(case, within), case.set(name)
    ways = case.searching(between, asked)
    questions: dict[str, Callable[[], Any]] = {
        "folds": lambda: ss.folds(p, name, **ways),
        "onsets": lambda: ss.flutter_onsets(p, name, damping=False if undamped else None, **ways),
    }
    both, ranges = tuple(one.name for one in along), {key: ends for one in along for key, ends in one.between.items()}
    if len(along) == 2:
        questions["cusps"] = lambda: ss.cusps(case.set(*both), both, **case.searching(ranges, asked))
    elif not vary:
        click.echo(f"cusps are looked for in the plane of two parameters: --vary {name} --vary NAME", err=True)
    told, found = {}, {}
    for title, question in questions.items():
        with show_progress(f"searching for {title} along {' and '.join(both if title == 'cusps' else (name,))}"):
            found[title] = within_ranges(question())
        told[title] = points_of(case, found[title], along if title == "cusps" else line)
    if plot is not None:
        _draw(case, plot, both, ranges, found, n, undamped)
    if json_output:
        print_json({"model": case.model.name, "parameters": case.told(), **told})
        return
    for title, one in told.items():
        print_points(title.capitalize(), one, along if title == "cusps" else line)


def within_ranges(found: Any) -> Any:
    """Those points at which all that varies is in its range: closed forms know mirror images beyond it."""
    ranges, inside = [found.parameters.ranges[name] for name in found.vary], np.ones(len(found), dtype=np.bool_)
    for name, allowed in zip(found.vary, ranges, strict=True):
        inside &= allowed.inside(getattr(found, name))
    region, first = found.region.copy(), len(found.region) - len(found.vary)
    region[first:] = np.clip(region[first:].T, [one.low for one in ranges], [one.high for one in ranges]).T
    return replace(found.select(inside), region=region)


def plane(case: Case, vary: tuple[Typed, ...], plot: Path | None, force: bool) -> list[Span]:
    """What varies; refused, before anything is computed, are more than a plane, and what can't be drawn."""
    asked = vary or [Typed(name, name) for name in case.model.axes]
    along = [span(case, typed, "", begins=place > 0) for place, typed in enumerate(asked)]  # folds are at a value of the second
    if len(along) > 2 or len({one.name for one in along}) < len(along):
        raise ParameterError(f"--vary {' --vary '.join(typed.text for typed in vary)}: give one parameter, or two different ones")
    if plot is not None:
        drawable(plot)
    if plot is not None and len(along) < 2:
        raise ParameterError("--plot shows the plane of two parameters; give the second one with another --vary")
    refuse([] if plot is None else [plot], force)
    return along


def _draw(
    case: Case, path: Path, vary: tuple[str, ...], ranges: dict[str, Any], found: dict[str, Any], n: int, undamped: bool
) -> None:  # fmt: skip
    """The bifurcation set; by closed forms where the model has them for all of this plane.

    Curves of onsets where they are asked for, or were found along the first parameter, or where there are no folds to show.
    """
    from ..figures import bifurcation_figure
    from ..figures.labels import window

    p = case.set(*vary)
    closed = case.has_closed("bifurcation_set") and vary == case.model.axes and not ranges

    shown, onsets, plane = window(case.model, vary, ranges, found["cusps"]), None, " and ".join(vary)
    if undamped or len(found["onsets"]) or not (closed or len(found["folds"]) or len(found["cusps"])):
        with show_progress(f"searching for onsets in the plane of {plane}"):
            onsets = ss.onset_curves(p, vary, min(n, 30), damping=not undamped, between=shown)
    else:
        click.echo("the picture shows folds and cusps; spragsym onsets --plot shows where oscillation sets in", err=True)
    across, up = (case.units.axis(name) for name in vary)
    drawing = f"drawing folds{', onsets' if onsets else ''} and cusps in the plane of {plane}"
    written(
        path, drawing, lambda: bifurcation_figure(p, vary, between=None if closed else shown, n=n, onsets=onsets), [(across, up)]
    )
