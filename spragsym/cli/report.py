"""``spragsym report``: the data of a brake in, a verdict out."""

from __future__ import annotations

from pathlib import Path

import click

from ..errors import ParameterError
from .options import as_json
from .tables import print_json
from .targets import force, refuse


@click.command()
@click.argument("file", type=click.Path(path_type=Path))
@click.option("--html", type=click.Path(dir_okay=False, path_type=Path), metavar="PATH", help="Write one page with pictures.")
@click.option("--oscillation", is_flag=True, help="Also follow the motion: how hard it hits, from seconds to minutes.")
@click.option("--safety", type=float, default=1.2, show_default=True, help="Factor on the largest friction, for what to change.")
@force
@as_json
def report(file: Path, html: Path | None, oscillation: bool, safety: float, force: bool, json_output: bool) -> None:
    """A verdict on the brake whose data stand in FILE, with units and tolerances.

    \b
    Examples:
      spragsym report brake.toml
      spragsym report brake.toml --oscillation --html report.html

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    if html is not None and html.suffix.lower() not in (".html", ".htm"):
        raise ParameterError(f"--html {html}: the ending must be .html")
    refuse([] if html is None else [html], force)
    from ..studies import Study

    study = Study.from_file(file)
    found = study.report(oscillation=oscillation, safety=safety)
    if html is not None:
        found.to_html(html)
        click.echo(f"wrote {html}", err=True)
    if json_output:
        print_json(found.to_dict())
    else:
        click.echo(found.text())
