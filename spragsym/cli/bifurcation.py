"""``spragsym bifurcation``, ``folds`` and ``onsets``: folds, cusps, and onsets of oscillation."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import click
import numpy as np

import spragsym as ss

from ..core.errors import ParameterError
from ..core.progress import show_progress
from ..display import own_name
from ..results.points import UNSTABLE, Points, after_if_known
from . import options as o
from .case import Case, Row
from .output import drawn, print_rows


@o.of_model(varies=1, statics=True)
@o.vary(
    "What varies: a parameter, with --data a quantity of the file too; with a range as "
    "mu0=0:1. Default: {last}."
)
@o.within
@o.method
@o.as_json
def folds(case: Case) -> object:
    """All folds along one parameter, proved: which state ends there, when, and where it jumps to.

    \b
    Examples:
      spragsym folds --theta0 40
      spragsym folds --data brake.toml --vary k_x
      spragsym folds --model two_springs --theta0 40 --vary mu0=0:1
    """
    along = case.span
    with show_progress(f"searching for folds along {along.name}"):
        answer = points_of(
            case,
            ss.folds(case.set(along.name), along.name, **case.searching(along.name)),
            after=True,
        )
    return {"vary": along.title, **answer}, lambda: print_points(
        case, "Folds", answer, [along.title]
    )


@o.of_model(varies=2, statics=True)
@o.vary(
    "A parameter, with a range as theta0=5:175. Of two, folds and onsets are looked for along "
    "the first, cusps in the plane of "
    "both; of one, no cusps. Default: {axes}.",
    several=True,
)
@o.within
@o.undamped
@o.method
@o.plot("the bifurcation set")
@o.lines(
    60,
    "Lines of either parameter on which --plot searches for folds, where there is no closed form.",
)
@o.force
@o.as_json
def bifurcation(case: Case, undamped: bool, plot: Path | None, n: int) -> object:
    """All folds and flutter onsets along one parameter, and all cusps in the plane of two, proved.

    \b
    Examples:
      spragsym bifurcation
      spragsym bifurcation --alpha 0.7 --undamped --json
      spragsym bifurcation --plot folds.pdf
      spragsym bifurcation --data brake.toml
      spragsym bifurcation --model two_springs --vary theta0=10:80 --vary mu0=0:1
    """
    names, name = case.names, case.span.name
    if len(names) > 1:
        case.model.two(names)
    elif plot is not None:
        raise ParameterError(
            "--plot shows the plane of two parameters; give the second one with another --vary"
        )
    found: dict[str, Any] = {}

    def search(title: str, along: Sequence[str], question: Callable[..., Any], **more: Any) -> None:
        with show_progress(f"searching for {title} along {' and '.join(along)}"):
            points = question(
                case.set(*along),
                along[0] if len(along) == 1 else along,
                **case.searching(*along),
                **more,
            )
        # Closed forms give mirror images beyond the ranges of the parameters too.
        ranges = [points.parameters.ranges[name] for name in along]
        low, high = np.array([(one.low, one.high) for one in ranges]).T[..., None]
        found[title] = points.between(np.clip(points.region[-len(along) :], low, high))

    search("folds", names[:1], ss.folds)
    search("onsets", names[:1], ss.flutter_onsets, damping=False if undamped else None)
    if len(names) == 2:
        search("cusps", names, ss.cusps)
    elif len(case.model.axes) > 1:
        click.echo(
            f"cusps are looked for in the plane of two parameters: --vary {name} --vary NAME",
            err=True,
        )
    if plot is not None:
        _draw(case, plot, names, found, n, undamped)
    answer = {title: points_of(case, one) for title, one in found.items()}

    def tables() -> None:
        titles = [span.title for span in case.spans]
        for title, one in answer.items():
            print_points(case, title.capitalize(), one, titles[: len(found[title].vary)])

    return {"parameters": case.parameter_row(), **answer}, tables


def _draw(
    case: Case, path: Path, vary: tuple[str, ...], found: dict[str, Any], n: int, undamped: bool
) -> None:
    """Draw the bifurcation set.

    Curves of onsets are drawn if they are asked for, if there are onsets along the first parameter,
    or if there are no folds.
    """
    from ..figures.style import window

    p, ranges = case.set(*vary), case.between
    shown = window(p, vary, ranges, lambda: found["cusps"])
    onsets = None
    plane = " and ".join(vary)
    if undamped or len(found["onsets"]) or not (len(found["folds"]) or len(found["cusps"])):
        with show_progress(f"searching for onsets in the plane of {plane}"):
            onsets = ss.onset_curves(
                p, vary, min(n, 30), damping=False if undamped else None, between=shown
            )
    else:
        click.echo(
            "the picture shows folds and cusps; spragsym onsets --plot shows where "
            "oscillation sets in",
            err=True,
        )
    drawing = f"drawing folds{', onsets' if onsets else ''} and cusps in the plane of {plane}"
    figure = partial(ss.figures.bifurcation_figure, p, vary, between=shown, n=n, onsets=onsets)
    drawn(path, drawing, figure, lambda: [[*map(case.axis, vary)]])


@o.of_model(varies=2, statics=True, spanned=2)
@o.vary("A parameter, with a range as theta0=5:175; give two. Default: {axes}.", several=True)
@o.undamped
@o.plot("the map of stability")
@o.lines(30, "Lines of either parameter on which they are sought.")
@o.force
@o.as_json
def onsets(case: Case, undamped: bool, plot: Path | None, n: int) -> object:
    """Onsets of oscillation over the plane of two parameters, supercritical or subcritical: a map
    of stability.

    Onsets are Hopf points with all damping, that of the friction law included; on curves of them
    those points too at which their kind changes (GH) and at which they meet folds (BT, ZH) and each
    other (HH).

    \b
    Examples:
      spragsym onsets --vary theta0=20:60 --vary mu0=0:1
      spragsym onsets --model stick_slip --vary V=0:1 --vary zeta=0:2 --plot map.pdf
      spragsym onsets --model mode_coupling --vary sigma=0.1:2 --vary mu0=0:2 --undamped
    """
    names = case.model.two(case.names)
    plane, coordinates = f"in the plane of {' and '.join(names)}", case.model.coordinates
    with show_progress(f"searching for onsets {plane}"):
        found = ss.onset_curves(
            case.set(*names), names, n, damping=False if undamped else None, between=case.between
        )
    drawn(
        plot,
        f"drawing onsets {plane}",
        lambda: ss.figures.stability_figure(found),
        lambda: [[*map(case.axis, names)]],
    )
    own = partial(own_name, case.model)
    forms = map(own, ("omega", "lyapunov", "lyapunov_error"))
    beside = [*map(own, UNSTABLE)]
    columns = (own("criticality"), own("onset"), *names, *coordinates, *forms, *beside)
    curves = [
        case.row({name: curve[name] for name in columns}, ss.results.Onsets)
        for curve in found.curves
    ]
    # Codimension-two points, and those at which the criticality changes.
    places = (*names, *coordinates)
    special = {name: [*found.points[name], *found.changes[name]] for name in places}
    between = found.changes[own("error")]
    kinds, errors = [*found.points.kind, *["GH"] * len(between)], [*found.points.error, *between]
    numbers = {
        own(name): [*getattr(found.points, name), *found.changes[own(name)]] for name in UNSTABLE
    }
    columns_of_points = {own("kind"): kinds, **special, **numbers, own("error"): errors}
    points = case.rows(columns_of_points, ss.results.Onsets)
    answer = {
        "curves": curves,
        "points": points,
        "complete": found.complete,
        "undecided": case.boxes(found.undecided, (*coordinates, *names)),
        "remarks": case.said(found.remarks),
    }

    def tables() -> None:
        titles = [span.title for span in case.spans]
        print_rows(
            "Onsets",
            [
                {
                    "curve": number,
                    "points": len(curve[own("criticality")]),
                    **{
                        f"{title} {end}": pick(curve[title])
                        for title in titles
                        for end, pick in (("from", min), ("to", max))
                    },
                    **{
                        name: ", ".join(dict.fromkeys(curve[own(name)]))
                        for name in ("criticality", "onset")
                    },
                }
                for number, curve in enumerate(curves, 1)
            ],
        )
        print_rows(
            "Points on them",
            [{title: row[title] for title in (own("kind"), *titles, *beside)} for row in points],
        )
        print_open("Onsets", answer)
        click.echo(
            f"Onsets: sought on {n} lines of either parameter; a curve that closes between "
            "two of them is not seen"
        )

    return {"parameters": case.parameter_row(), **answer}, tables


def points_of(case: Case, found: Points, after: bool = False) -> Row:
    """Rows of the points, whether these are all, what was searched, and the undecided boxes.

    With ``after``, the states that are jumped to are searched if they are not known.
    """
    alone = len(found.vary) == 1
    onsets, following = isinstance(found, ss.results.Onsets), {}
    if alone and not onsets:
        following = case.row(found.after if after else after_if_known(found), end="_after")

    def ours(*rows: str) -> dict[str, Any]:
        columns = (each for each in found.schema if each.row in rows)
        return {own_name(case.model, each.name): each.value(found) for each in columns}

    columns = {
        **{name: found[name] for name in found.vary},
        **ours("before"),
        **{name: found[name] for name in found.state_columns},
        **(ours("behind", "beside") if alone or onsets else {}),
    }
    points = case.rows(columns, ss.results.Onsets, **following, error=found.error)
    searched, *undecided = case.boxes(
        [found.region, *found.undecided], (*case.model.coordinates, *found.vary)
    )
    return {
        "points": points,
        "complete": bool(found.complete),
        "searched": searched,
        "undecided": undecided,
        "remarks": case.said(found.remarks),
    }


def print_points(case: Case, title: str, found: Mapping[str, Any], where: Sequence[str]) -> None:
    """Print a table of points, folds without a state to jump to, and what is undecided."""
    rows = found["points"]
    if rows or found["complete"]:
        shown = [case.without_beside(row, ss.results.Onsets) for row in rows]
        names = [*shown[0]] if shown else []
        after = [name for name in names if "_after" in name]
        room = [*left_out_first(case, names), *after[::-1]]
        heading = f"{title} along {' and '.join(where)}"
        print_rows(heading, shown, room, case.formats)
    without_target = [
        row
        for row in rows
        if row.get(own_name(case.model, "ends")) in ("lower", "upper")
        and any(math.isnan(value) for name, value in row.items() if "_after" in name)
    ]
    if without_target:
        # Closed forms cover all states; a search covers its region only.
        everywhere = math.isinf(next(iter(found["searched"].values()))[0])
        said = "is left" if found["complete"] and everywhere else "was found"
        nowhere = ", ".join(f"{row[where[0]]:.6g}" for row in without_target)
        click.echo(
            f"{title}: nothing stable in contact {said} to jump to at {' and '.join(where)} "
            f"= {nowhere}"
        )
    print_open(title, found)


def print_open(title: str, found: Mapping[str, Any]) -> None:
    """Print what is undecided, and the remarks."""
    if found["undecided"]:
        click.echo(f"{title}: not complete, {summed(found['undecided'])}")
    elif not found["complete"]:
        click.echo(f"{title}: not complete")
    for remark in found["remarks"]:
        click.echo(f"{title}: {remark}")


def left_out_first(case: Case, columns: Collection[str]) -> list[str]:
    """Columns that a table leaves out if it is too wide, in this order: lengths of springs, which
    follow from the coordinates, the error, and directions of springs before and after a jump.
    """
    model, jump = case.model, ("_before", "_after")
    springs = [name for name in model.places if name not in model.coordinates]

    def titles(dimension: str, ends: Iterable[str]) -> list[str]:
        names = [name for name in springs if model.columns[name].dimension == dimension]
        return [case.of(name, end=end)[0] for end in ends for name in names]

    found = [*titles("m", (*jump, "")), own_name(model, "error"), *titles("rad", jump)]
    return [title for title in found if title in columns]


def summed(boxes: Sequence[Row]) -> str:
    """The number of undecided boxes, and their hull, as text."""
    titles = [title for title, ends in boxes[0].items() if isinstance(ends, list)]
    hull = ", ".join(
        f"{title} in [{min(box[title][0] for box in boxes):.8g}, "
        f"{max(box[title][1] for box in boxes):.8g}]"
        for title in titles
    )
    return (
        f"{'1 box is' if len(boxes) == 1 else f'{len(boxes)} boxes are'} undecided, within {hull}"
    )
