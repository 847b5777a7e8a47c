"""``spragsym equilibria --model`` and ``spragsym bifurcation --model``."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import click

from ..errors import ParameterError
from .options import Number
from .tables import busy, print_json, print_table
from .targets import refuse
from .with_model import parameter_options, without

if TYPE_CHECKING:
    from ..models import Model


#: Ranges by the names of their parameters.
Spans: TypeAlias = dict[str, tuple[float, float]]


def json_option() -> click.Option:
    """``--json``."""
    return click.Option(["--json", "json_output"], is_flag=True, help="Print JSON instead of a table.")


def within_option(model: Model) -> click.Option:
    """``--within``."""
    return click.Option(
        ["--within"],
        multiple=True,
        metavar="NAME=FROM:TO",
        help=f"Range of a coordinate to search, as {model.coordinates[0]}=-5:5, in place of the model's own. Repeatable.",
    )


def box_of(model: Model, texts: Sequence[str]) -> Spans | None:
    """``--within NAME=FROM:TO`` as ranges by name."""
    return dict(_span_of("--within", text) for text in texts) or None


def _span_of(option: str, text: str) -> tuple[str, tuple[float, float]]:
    """``NAME=FROM:TO``."""
    try:
        name, ends = text.split("=")
        low, high = map(float, ends.split(":"))
    except ValueError:
        raise ParameterError(f"{option} {text} is no range; give it as mu0=0:1, a name and both ends") from None
    return name, (low, high)


def _summed(title: str, names: Sequence[str], lows: Sequence[Sequence[float]], highs: Sequence[Sequence[float]]) -> str:
    """How many boxes are undecided, and what holds them all; --json lists each."""
    low = [min(ends) for ends in zip(*lows, strict=True)]
    high = [max(ends) for ends in zip(*highs, strict=True)]
    hull = ", ".join(f"{name} in [{a:.8g}, {b:.8g}]" for name, a, b in zip(names, low, high, strict=True))
    boxes = "1 box is" if len(lows) == 1 else f"{len(lows)} boxes are"
    return f"{title}: not complete, {boxes} undecided, within {hull}"


def bifurcation_of(model: Model) -> tuple[list[click.Option], Callable[..., Any], str]:
    """Options and work of ``spragsym bifurcation`` for a model."""

    def bifurcation(
        vary: str,
        along: str | None,
        between: tuple[str, ...],
        within: tuple[str, ...],
        json_output: bool,
        plot: Path | None,
        n: int,
        force: bool,
        **values: Any,
    ) -> None:
        if along is None:  # the other one of the two
            along = {second: first}.get(vary, second)
        both = (vary, along)
        if vary == along:
            raise ParameterError(f"--along {along} and --vary are the same; give another parameter, or --along '' for none")
        box = box_of(model, within)
        spans = _spans(model, between, both if along else (vary,))
        if plot is not None:
            check(plot, along, force)
        one, two = (without(model, which, dict(values)) for which in ((vary,), both if along else (vary,)))
        span = {name: ends for name, ends in spans.items() if name == vary}
        asked: dict[str, Callable[[], Any]] = {
            "folds": lambda: model.folds(one, vary, between=span, within=box),
            "flutter onsets": lambda: model.flutter_onsets(one, vary, between=span, within=box),
        }
        if along:
            asked["cusps"] = lambda: model.cusps(two, both, between=spans, within=box)
        found: dict[str, Any] = {}
        for title, search in asked.items():
            with busy(f"searching for {title} along {vary if title != 'cusps' else f'{vary} and {along}'}"):
                found[title] = search()
            if not json_output:
                print_points(model, title, found[title])
        if json_output:
            print_json({"model": model.name, **{title: points_of(model, points) for title, points in found.items()}})
        if plot is not None:
            draw(plot, two, both, spans, found["cusps"], n)

    def check(plot: Path, along: str, force: bool) -> None:
        if plot.suffix not in (".pdf", ".png", ".svg"):
            raise ParameterError(f"--plot {plot}: the ending must be .pdf, .png or .svg")
        if not along:
            raise ParameterError("--plot shows the plane of two parameters; give the second one with --along")
        refuse([plot], force)

    def draw(plot: Path, p: Any, vary: tuple[str, str], spans: Spans, cusps: Any, n: int) -> None:
        from ..figures import FORMATS, model_figure
        from ..figures.models import window
        from ..figures.style import house_style

        kind = plot.suffix[1:]
        with house_style(), busy(f"drawing folds and cusps in the plane of {' and '.join(vary)}"):
            figure = model_figure(model, p, vary, between=window(model, vary, spans, cusps), n=n)
            figure.savefig(plot, format=kind, metadata=FORMATS[kind])
        click.echo(f"drew {plot}", err=True)

    first, second = (*model.axes, "", "")[:2]
    plot = click.Option(
        ["--plot"],
        type=click.Path(dir_okay=False, path_type=Path),
        metavar="FILE",
        help="Draw the bifurcation set (pdf, png, svg).",
    )
    options = [
        *(optional(option) for option in parameter_options(model, Number)),
        click.Option(
            ["--vary", "vary"], default=first, show_default=True, help="Parameter along which folds and onsets are looked for."
        ),
        click.Option(["--along", "along"], help=f"Second parameter, for cusps; empty for none. Default: {second or 'none'}."),
        click.Option(
            ["--between"],
            multiple=True,
            metavar="NAME=FROM:TO",
            help="Range to search of either parameter, as mu0=0:1; angles in degrees. A narrow one is quick. Repeatable.",
        ),
        within_option(model),
        json_option(),
        plot,
        click.Option(
            ["--n"],
            type=click.IntRange(2, 2000),
            default=60,
            show_default=True,
            help="Lines of either parameter on which --plot looks for folds: a closed curve between two lines is not seen.",
        ),
        click.Option(["--force"], is_flag=True, help="Overwrite files that are in the way."),
    ]
    return options, bifurcation, "All folds and flutter onsets along one parameter, and all cusps in the plane of two, proved."


def _spans(model: Model, texts: Sequence[str], vary: Sequence[str]) -> Spans:
    """``--between NAME=FROM:TO`` as ranges by name, angles in radians."""
    spans = {}
    for text in texts:
        name, (low, high) = _span_of("--between", text)
        if name not in vary:
            raise ParameterError(f"--between {text}: {name} does not vary; {' and '.join(vary)} can have a range")
        unit = math.degrees(1.0) if name in model.about["angles"] else 1.0
        spans[name] = (low / unit, high / unit)
    return spans


def optional(option: click.Option) -> click.Option:
    """What varies need not be given."""
    option.required = False
    return option


def points_of(model: Model, points: Any) -> dict[str, Any]:
    """Points at which equilibria change, and the boxes that are not decided, in the units of Python."""
    names = (*points.vary, *model.coordinates)
    rows = [
        {
            **{name: float(getattr(points, name)[row]) for name in names},
            "kind": str(points.kind[row]),
            "error": float(points.error[row]),
            **_danger(points, row),
        }
        for row in range(len(points))
    ]
    boxes = [{name: box[i].tolist() for i, name in enumerate((*model.coordinates, *points.vary))} for box in points.undecided]
    return {
        "points": rows,
        "complete": bool(points.complete),
        "searched": {name: ends.tolist() for name, ends in zip((*model.coordinates, *points.vary), points.region, strict=True)},
        "undecided": boxes,
        "remarks": list(points.remarks),
    }


def _danger(points: Any, row: int) -> dict[str, Any]:
    """How dangerous an onset is, where a pair crosses: None for numbers that there are not."""
    if points.kind[row] != "hopf":
        return {}
    numbers = {name: float(getattr(points, name)[row]) for name in ("lyapunov", "lyapunov_error", "crossing")}
    known = {name: value if math.isfinite(value) else None for name, value in numbers.items()}
    return {"criticality": str(points.criticality[row]), **known, "why": points.why[row]}


def print_points(model: Model, title: str, points: Any) -> None:
    """A table of points, angles in degrees, and where it is not known whether there are more."""
    import numpy as np

    units = {name: math.degrees(1.0) for name in model.about["angles"]}
    names = (*points.vary, *model.coordinates)
    columns = [*(units.get(name, 1.0) * getattr(points, name) for name in names), points.kind]
    hopf = "hopf" in points.kind
    columns += [points.criticality] if hopf else []
    rows = [tuple(column[row].item() for column in columns) for row in range(len(points))]
    header = (*(f"{name}_deg" if name in units else name for name in names), "kind", *(["criticality"] if hopf else []))
    if rows or points.complete:
        print_table(title.capitalize(), header, rows)
    unknowns = (*model.coordinates, *points.vary)
    scale = np.array([units.get(name, 1.0) for name in unknowns])
    shown = tuple(f"{name}_deg" if name in units else name for name in unknowns)
    if len(points.undecided):
        click.echo(_summed(title, shown, *(scale * points.undecided[:, :, end] for end in (0, 1))))
    elif not points.complete:
        click.echo(f"{title}: not complete")
    for remark in points.remarks:
        click.echo(f"{title}: {remark}")
