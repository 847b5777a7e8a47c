"""``spragsym squeal``: the verdict on a brake of matrices."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..core.errors import ParameterError
from ..core.progress import show_progress
from ..numerics.decimals import upward
from . import options as o
from .case import Row, Span
from .output import drawn, print_json, print_rows, refuse, wrapped, write

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..models.parameters import FloatArray
    from ..report.squeal import SquealReport, SquealStudy


@o.command()
@click.argument("file", type=click.Path(path_type=Path), required=False)
@o.file("--example", folder=True, metavar="FOLDER", help="Write the files of a brake there.")
@o.file("--html", metavar="PATH", help="Write one page with pictures.")
@o.over
@o.plot("frequencies and damping ratios over the parameter, or the map of --over")
@o.force
@o.as_json
def squeal(
    file: Path | None,
    example: Path | None,
    html: Path | None,
    over: tuple[Span, ...],
    plot: Path | None,
) -> None:
    """Every onset of squeal of the brake whose matrices FILE names, proved.

    FILE has a table [matrices] with the files of mass, stiffness, and friction or contact pairs,
    and [parameters] with the range of what varies, as mu = "[0, 0.8]".

    \b
    Examples:
      spragsym squeal --example brake
      spragsym squeal brake/brake.toml
      spragsym squeal brake.toml --html squeal.html
      spragsym squeal brake.toml --json --plot modes.svg
      spragsym squeal brake.toml --over contact=0.5:2:7 --plot map.svg
    """
    if example is not None:
        from ..matrices.example import example_files

        write({example / name: text for name, text in example_files().items()}, made=True)
        click.echo(example / "brake.toml")
        return
    if file is None:
        raise click.UsageError("FILE is missing; begin with spragsym squeal --example brake")
    from ..report.squeal import read_squeal

    if html is not None and html.suffix.lower() not in (".html", ".htm"):
        raise ParameterError(f"--html {html}: the ending must be .html")
    if plot is not None and plot.suffix not in (".pdf", ".png", ".svg"):
        raise ParameterError(f"--plot {plot}: the ending must be .pdf, .png or .svg")
    if over and (html is not None or len(over) > 1 or over[0].ends is None):
        raise click.UsageError("--over takes one parameter with its ends, and --plot, not --html")
    refuse([html, plot])
    if over:
        _over(read_squeal(file), over[0], plot)
        return
    with show_progress("onsets of squeal"):
        found = read_squeal(file).report()
    if o.is_json():
        print_json(found.to_dict())
    else:
        click.echo(wrapped(found.verdict()))
        name = found.study.vary
        columns = (name, "frequency_hz", "kind", "direction", "error", "partner_hz", "full_model")
        rows = [{column: row[column] for column in columns if column in row} for row in found.rows]
        print_rows(f"Onsets along {name}", rows, formats={"error": upward})
        for line in found.remarks():
            click.echo(wrapped(line))
    drawn(plot, "drawing the modes", lambda: _figure(found))
    if html is not None:
        with show_progress("drawing the page"):
            write({html: _page(found)})
        click.echo(f"wrote {html}", err=True)


def _over(study: SquealStudy, over: Span, plot: Path | None) -> None:
    """Print the onsets at each value of another parameter."""
    with show_progress("onsets of squeal over another parameter"):
        found = study.over(over.name, over.values)
    columns = (study.vary, "frequency_hz", "kind", "direction", "error")
    rows = [
        {over.name: value} | {column: row[column] for column in columns}
        for value, onsets in found
        for row in onsets
        if study.of_band(row["frequency_hz"])
    ]
    gaps = [value for value, onsets in found if not onsets.complete]
    if o.is_json():
        print_json(
            {"over": over.name, "values": over.values.tolist(), "onsets": rows, "incomplete": gaps}
        )
    else:
        print_rows(f"Onsets along {study.vary}", rows, formats={"error": upward})
        click.echo(
            f"These are all onsets at {len(found)} values of {over.name}: proved for the matrices "
            "as they are; values between these are not asked."
            if not gaps
            else f"Undecided in parts at {', '.join(f'{one:g}' for one in gaps)}."
        )
    drawn(plot, "drawing the map", lambda: _map(study, over.name, rows, over.values))


def _map(study: SquealStudy, name: str, rows: list[Row], values: FloatArray) -> Figure:
    from ..figures.squeal import map_figure  # imported late: it needs the extra plot

    return map_figure(study, name, rows, values)


def _figure(found: SquealReport) -> Figure:
    from ..figures.squeal import squeal_figure  # imported late: it needs the extra plot

    return squeal_figure(found.onsets, found.study.band)


def _page(found: SquealReport) -> str:
    from ..figures.squeal import squeal_page

    return squeal_page(found)
