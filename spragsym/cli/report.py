"""``spragsym report``: the data of a brake in, a verdict out."""

from pathlib import Path

import click

from ..errors import ParameterError
from ..models.parameters import POSITIVE
from ..progress import show_progress
from . import options as o
from .output import print_json, refuse


@o.command()
@click.argument("file", type=click.Path(path_type=Path), required=False)
@click.option("--example", is_flag=True, help="Print a file to begin with.")
@click.option("--model", metavar="NAME|DIR", help="Model of the example; or the folder that FILE names, whose code may run.")
@click.option("--trust", is_flag=True, help="Run the code of the folder that FILE names as its model.")
@o.file("--html", metavar="PATH", help="Write one page with pictures.")
@click.option("--oscillation/--no-oscillation", default=True, help="Follow the motion: how hard it hits.")
@click.option("--redesign/--no-redesign", default=True, help="Say what to change where it jumps.")
@click.option(
    "--safety",
    type=o.Number(POSITIVE),
    default=1.2,
    help="Factor on the largest friction, for what to change.",
)
@o.force
@o.as_json
def report(
    file: Path | None, example: bool, model: str | None, trust: bool, html: Path | None, oscillation: bool, redesign: bool,
    safety: float, force: bool, json_output: bool,
) -> None:  # fmt: skip
    """A verdict on the brake whose data stand in FILE, with units and tolerances.

    \b
    Examples:
      spragsym report --example > brake.toml
      spragsym report --example --model two_springs > other.toml
      spragsym report brake.toml
      spragsym report brake.toml --html report.html
    """
    if example:
        from ..models.load import USUAL, load
        from ..report.brake_files import example as text_of

        click.echo(text_of(load(model or USUAL)), nl=False)
        return
    if file is None:
        raise click.UsageError("FILE is missing; begin with spragsym report --example > brake.toml")
    if html is not None and html.suffix.lower() not in (".html", ".htm"):
        raise ParameterError(f"--html {html}: the ending must be .html")
    refuse([] if html is None else [html], force)
    from ..report.brake_files import read_brake
    from ..report.reports import Asked, Report

    study = read_brake(file, trust or model or False)  # the report has its own warnings
    if model not in (None, study.model):
        raise click.UsageError(f"--model {model}: {file} is about {study.model}; leave --model out")
    options = [flag for flag, asked in (("--no-oscillation", oscillation), ("--no-redesign", redesign)) if asked]
    less = f" ({' and '.join(options)} {'leave' if len(options) > 1 else 'leaves'} out what takes longest)" if options else ""
    found = Report(study, Asked(redesign=redesign, oscillation=oscillation, safety=safety))
    blocks = found.blocks()

    def computed() -> str | None:
        with show_progress(f"computing the report{less}"):
            return next(blocks, None)

    for block in iter(computed, None):
        if not json_output:
            click.echo(block)
    if json_output:
        print_json(found.to_dict())
    if html is not None:
        with show_progress("drawing the page"):
            found.to_html(html)
        click.echo(f"wrote {html}", err=True)
