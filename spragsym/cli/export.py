"""``spragsym export``: the solver in another language."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..derive.emit.targets import languages
from ..derive.kang_nam.library import exported
from ..errors import MissingExtraError
from ..files.writing import probe, put
from ..models.load import page_of
from .commands import command
from .of_model import TEXT
from .targets import force, holds, refuse

if TYPE_CHECKING:
    from ..models import Model


@command()
@click.option("--model", "model_name", metavar="NAME|DIR", help=TEXT)
@click.option("--language", type=click.Choice(languages()), default="c", show_default=True, help="Language to write.")
@click.option(
    "--out",
    "-o",
    type=click.Path(path_type=Path, file_okay=False),
    required=True,
    help="Folder to write to, made if missing.",
)
@force
def export(model_name: str | None, language: str, out: Path, force: bool) -> None:
    """Write the solver in another language, with an example that runs.

    All equilibria with their stability, an error bound and a status, the generated algebra, the right-hand side, and a
    step in time across the kinks. JavaScript and MATLAB have folds, cusps and the surface as well. Of another model:
    its forces with first and second derivatives, its motion with Jacobians, borders, energy and powers, derived anew from
    its page (extra derive).

    \b
    Examples:
      spragsym export --language c --out sprag
      spragsym export --model trolley --out trolley_c
      make -C sprag && ./sprag/example
      spragsym export --language javascript --out web
      spragsym export --language matlab --out octave

    \b
    Exit codes: 0 written; 1 the folder can't be written; 2 usage, or a file that differs is in the way.
    """
    probe(out / "file", made=True)
    texts = _of_name(model_name, language) if model_name else exported(language)
    changed = {name: text for name, text in texts.items() if not holds(out / name, text)}
    refuse((out / name for name in changed), force, made=True)
    for name, text in changed.items():
        put(out / name, text, made=True)
    for name in texts:
        click.echo(out / name)


def _of_name(name: str, language: str) -> dict[str, str]:
    from ..models import load

    return of_model(load(name), language)


def of_model(model: Model, language: str) -> dict[str, str]:
    """The functions of a model in the language, from its page: that of the package, or the one in its folder."""
    try:
        from ..derive import export as translation
        from ..derive import pages
    except ModuleNotFoundError as error:
        raise MissingExtraError("spragsym export --model", error.name or "sympy", "derive") from error
    return translation.export(page_of(model, pages.SHIPPED), model.name, language)
