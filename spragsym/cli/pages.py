"""``spragsym report`` and ``explore``: the verdict on a brake's data, and the explorer's page."""

from __future__ import annotations

import math
import os
import shlex
import sys
from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import spragsym as ss

from ..core.errors import ModelError, ParameterError
from ..core.progress import advance, show_progress
from ..files.storage import probe, put
from ..models.load import USUAL, load, shipped
from ..models.parameters import POSITIVE, ParameterSet
from . import options as o
from .case import Span, study_of
from .output import drawn, is_typed, print_json, print_rows, refuse, write

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..models import Model
    from ..report.over import Verdicts
    from ..report.study import Study


@o.command()
@click.argument("file", type=click.Path(path_type=Path), required=False)
@click.option("--example", is_flag=True, expose_value=False, help="Print a file to begin with.")
@click.option(
    "--model",
    metavar="NAME|DIR",
    help="Model of the example; or the folder that FILE names, whose code may run.",
)
@click.option(
    "--trust",
    is_flag=True,
    expose_value=False,
    help="Run the code of the folder that FILE names as its model.",
)
@o.file("--html", metavar="PATH", help="Write one page with pictures.")
@click.option(
    "--oscillation/--no-oscillation", default=True, help="Follow the motion: how hard it hits."
)
@click.option("--redesign/--no-redesign", default=True, help="Say what to change where it jumps.")
@click.option(
    "--safety",
    type=o.OneNumber(POSITIVE),
    default=1.2,
    help="Factor on the largest friction, for what to change.",
)
@o.over
@o.file("--csv", metavar="PATH", help="Write what --over tells, with units in the head.")
@o.plot("what --over tells")
@o.file(
    "--batch",
    metavar="CSV",
    help="A table with a row a brake: its head has keys of FILE, and cells what FILE has for them; "
    "FILE, if given, has what the brakes share.",
)
@o.file("--out", "-o", folder=True, metavar="FOLDER", help="Of --batch: where reports are written.")
@o.workers(1)
@o.force
@o.as_json
def report(
    file: Path | None,
    model: str | None,
    html: Path | None,
    over: tuple[Span, ...],
    csv: Path | None,
    plot: Path | None,
    batch: Path | None,
    out: Path | None,
    workers: int,
    **parts: Any,
) -> None:
    """A verdict on the brake whose data stand in FILE, with units and tolerances.

    \b
    Examples:
      spragsym report --example > brake.toml
      spragsym report --example --model two_springs > other.toml
      spragsym report brake.toml
      spragsym report brake.toml --html report.html
      spragsym report brake.toml --over theta0=40:70:31 --csv over.csv
      spragsym report brake.toml --batch brakes.csv --out reports -j 4
    """
    if is_typed("example"):
        from ..report.example import example

        click.echo(example(load(model or USUAL)), nl=False)
        return
    if (batch is None) != (out is None):
        raise click.UsageError(
            "--batch and --out belong together: --batch brakes.csv --out reports"
        )
    if batch is not None and out is not None:
        if any((html, over, csv, plot)):
            raise click.UsageError(
                "--batch writes pages and a summary; leave out --html, --over, --csv, --plot"
            )
        _batch(batch, out, file, workers, model or is_typed("trust"), parts)
        return
    if file is None:
        raise click.UsageError("FILE is missing; begin with spragsym report --example > brake.toml")
    if html is not None and html.suffix.lower() not in (".html", ".htm"):
        raise ParameterError(f"--html {html}: the ending must be .html")
    if over and html is not None:
        raise click.UsageError("--html is the page of one report; --plot draws what --over tells")
    if not over and (csv is not None or plot is not None):
        raise click.UsageError("--csv and --plot show what --over tells; give --over theta0=40:70")
    refuse([html, csv, plot])
    study = study_of(file, model, warn=False)  # the report has its own warnings
    if over:
        _over(study, over, csv, plot)
        return
    with show_progress(
        "computing the report (--no-oscillation and --no-redesign leave out two of its parts)"
    ):
        found = study.report(**parts)
    if o.is_json():
        print_json(found.to_dict())
    else:
        click.echo(found.text())
    if html is not None:
        with show_progress("drawing the page"):
            found.to_html(html)
        click.echo(f"wrote {html}", err=True)


def _batch(
    table: Path,
    folder: Path,
    base: Path | None,
    workers: int,
    trust: bool | str,
    options: dict[str, Any],
) -> None:
    """Write the reports of a table of brakes, and their summary by risk."""
    from ..figures.report_pages import batch_page, report_page  # they need the extra plot
    from ..report.batch import by_risk, read_batch, report_batch, summary_csv

    probe(folder / "index.html", made=True)
    brakes, found = read_batch(table), []
    with (
        advance(True, len(brakes), 0) as done,
        closing(
            report_batch(
                brakes,
                folder,
                base,
                page=report_page,
                trust=trust,
                workers=workers,
                options=options,
                force=is_typed("force"),
            )
        ) as reports,
    ):
        for one in reports:
            found.append(one)
            done()
    ranked = by_risk(found)
    risky, failed = sum(one.at_risk for one in ranked), [one for one in ranked if not one.told]
    about = f"{len(brakes)} brakes, {risky} at risk, {len(failed)} without a report; by risk"
    put(folder / "summary.csv", summary_csv(ranked))
    put(folder / "index.html", batch_page(ranked, f"Brakes of {table.name}", about))
    if o.is_json():
        print_json([one.columns() for one in ranked])
    else:
        names = ("name", "jump_at", "unit", "margin_percent", "probability", "motion")
        rows = [{name: _known(one.columns()[name]) for name in names} for one in ranked]
        print_rows(about, rows)
    for one in failed:
        click.echo(f"{one.brake.name}: {one.trouble}", err=True)
    click.echo(f"wrote {folder / 'index.html'}", err=True)
    if failed:
        click.get_current_context().exit(3)


def _over(study: Study, over: tuple[Span, ...], csv: Path | None, plot: Path | None) -> None:
    """Print the verdict over one quantity or two."""
    from ..report.over import verdicts_over

    names = [span.name for span in over]
    if len(set(names)) < len(names) or len(names) > 2 or any(one.ends is None for one in over):
        raise click.UsageError(
            "--over takes one quantity or two, each with its ends, as theta0=40:70:31"
        )
    with show_progress("asking for the verdict over a range"):
        found = verdicts_over(study, {one.name: one.values for one in over})
    rows = [dict(zip(found.titles, row, strict=True)) for row in found.rows]
    files = {} if csv is None else {csv: found.csv()}
    if o.is_json():
        print_json({"rows": rows, "onsets": found.onsets, "unsettled": found.unsettled})
    else:
        print_rows("", [{key: _known(one) for key, one in row.items()} for row in rows])
        for line in (*found.onsets, *filter(None, [found.unsettled])):
            click.echo(line)
    write(files)
    drawn(plot, "drawing the verdicts", lambda: _verdict_figure(found))


def _known(one: float | str | None) -> float | str:
    """A cell of a table; empty for NaN and None."""
    return "" if one is None or (isinstance(one, float) and math.isnan(one)) else one


def _verdict_figure(found: Verdicts) -> Figure:
    from ..figures.over import verdict_figure  # imported late: it needs the extra plot

    return verdict_figure(found)


@o.command()
@o.file(
    "--out",
    "-o",
    folder=True,
    default=Path("explorer.html"),
    help="File to write; a name without an ending gets .html, and in a folder it is explorer.html.",
)
@o.file(
    "--data", exists=True, metavar="FILE", help="Begin at your own data, a file like brake.toml."
)
@click.option(
    "--model",
    metavar="NAME|DIR",
    help=f"Model to explore: a shipped one, or a folder of `spragsym derive`.  [default: {USUAL}]",
)
@click.option(
    "--onsets",
    is_flag=True,
    help="With the map of stability, at the values that the page begins with; takes some seconds.",
)
@click.option(
    "--no-open",
    "unopened",
    is_flag=True,
    help="Only write it; otherwise the browser opens it, where there is a display.",
)
@o.trust
@o.method
@o.force
def explore(
    out: Path,
    data: Path | None,
    model: str | None,
    onsets: bool,
    unopened: bool,
    method: str | None,
) -> None:
    """Write the explorer, one page that computes in the browser and needs no network, and open it.

    It shows the mechanism, how many states there are over a plane of two parameters, the states
    along one of them and at a point, and the motion in time. A state carried along a path follows
    its branch, and jumps where that ends. With --data, all numbers are typed and shown in the
    units of the file.

    Of the article's model the states are proved where double precision vouches for them, and its
    folds, cusps and the surface of all equilibria are drawn. Of another model they are searched by
    Newton's method, and the page says so; making it takes the extra derive.

    \b
    Examples:
      spragsym explore
      spragsym explore --data brake.toml
      spragsym explore --model two_springs --onsets --out two_springs.html
      spragsym explore --out web/explorer.html --no-open
    """
    study = None if data is None else study_of(data, model)
    chosen = load(study.model if study is not None else model or USUAL)
    if method == "closed" and chosen.search is chosen:
        raise ModelError(f"{chosen.name} brings no closed forms; leave --method out")
    if out.is_dir():
        out /= "explorer.html"
    elif not out.suffix:  # by which browsers take a file for a page
        out = out.with_name(f"{out.name}.html")
    probe(out, made=True)
    write(
        {out: page(chosen.search if method == "search" else chosen, study, onsets)},
        made=True,
    )
    click.echo(out)
    if unopened:
        return
    if (
        sys.platform in ("win32", "darwin")
        or os.environ.get("DISPLAY")
        or os.environ.get("WAYLAND_DISPLAY")
    ):
        import webbrowser  # a report needs none of what it loads

        webbrowser.open(out.resolve().as_uri())
    else:
        click.echo(f"there is no display; open {out} in a browser", err=True)


def page(model: Model, study: Study | None = None, onsets: bool = False) -> str:
    """The explorer's page of a model, at the user's data if there are any."""
    _, p = model.cases()[0]
    about: dict[str, Any] = {}
    if study is not None:
        p = study.kind.parameter_set(study.values)
        about = {"presets": [(f"Your data: {study.source}", p)], **_units(study)}
    from ..explorer import explorer_page

    drawn = _map(model, p, study) if onsets else ("", "")
    return explorer_page(model, **about, onsets=drawn)


def _map(model: Model, p: ParameterSet, study: Study | None) -> tuple[str, str]:
    """The figure of onset curves of a model, and the command that prints their numbers."""
    from ..figures.planes import draw_onset_curves
    from ..figures.report_pages import picture
    from ..figures.style import window

    if len(model.plane) != 2:
        raise ParameterError(
            f"--onsets: {model.name} has no two parameters of its equilibria; leave it out"
        )
    ends = window(p, model.plane, {})
    lines = 20  # of either parameter, on which onsets are sought
    with show_progress("searching for onsets (--onsets)"):
        found = ss.onset_curves(p, model.plane, lines, between=ends)
    if study is None:
        taken = f"--model {shlex.quote(model.where)}"
    else:
        taken = f"--data {shlex.quote(study.source)}"
        if model.where not in shipped():
            taken += " --trust"
    spans = (
        one if model.is_angle(one) else f"{one}={ends[one][0]:g}:{ends[one][1]:g}"
        for one in model.plane
    )
    command = " ".join(
        ["spragsym onsets", taken, *(f"--vary {span}" for span in spans), f"--n {lines} --json"]
    )
    return picture(lambda ax: draw_onset_curves(found, ax)), command


def _units(study: Study) -> dict[str, Any]:
    """The units of the user's file for the page, and the sentence that says so."""
    kind, (length, size), scales = study.kind, study.unit_of("m"), study.scales
    parameters = {
        name: (quantity, *study.unit_of(kind.units[quantity], quantity)[::-1])
        for quantity, name in kind.parameters.items()
        if quantity in study.quantities and kind.units[quantity] not in ("rad", "1")
    }
    fixed = ", ".join(f"{name} = {study.shown(name)}" for name in kind.bases)
    units = {
        "length": (size, length),
        "time": (scales.time, "s"),
        "force": (scales.force, "N"),
        "parameters": parameters,
    }
    source = (
        f"In the units of {study.source}, at its {fixed}; the model's own number stands beside "
        "each quantity."
    )
    return {"units": units, "source": source}
