"""``spragsym export`` and ``derive``: the solver in another language, and a page carried through to a model's folder."""

from __future__ import annotations

from pathlib import Path

import click

from ..derive.emit.targets import languages
from ..derive.kang_nam.library import exported
from ..errors import ParameterError, StoreError
from ..files.writing import probe
from ..models import Model, load
from ..models.load import page_of
from . import options as o
from .output import refuse, write


@o.command()
@click.option("--model", "model_name", metavar="NAME|DIR", help=o.TEXT)
@click.option("--language", type=click.Choice(languages()), default="c", show_default=True, help="Language to write.")
@o.folder("Folder to write to, made if missing.")
@o.force
def export(model_name: str | None, language: str, out: Path, force: bool) -> None:
    """Write the solver in another language, with an example that runs.

    All equilibria with their stability, an error bound and a status, the generated algebra, the right-hand side, and a
    step in time across the kinks. JavaScript has folds, cusps and the surface as well. Of another model:
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
    texts = of_model(load(model_name), language) if model_name else exported(language)
    write({out / name: text for name, text in texts.items()}, force, made=True)
    for name in texts:
        click.echo(out / name)


def of_model(model: Model, language: str) -> dict[str, str]:
    """The functions of a model in the language, from its page: that of the package, or the one in its folder."""
    from ..derive import export as translation
    from ..derive import pages

    return translation.export(page_of(model, pages.SHIPPED), model.name, language)


@o.command()
@click.argument("page", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@o.folder("Folder to write.")
@o.force
def derive(page: Path, out: Path, force: bool) -> None:
    """Derive the model of a page, and write it to a folder.

    A page is a Python file that says a model's quantities, coordinates, energies, springs, contact and friction; it is run. The
    folder is what --model of other commands takes, and spragsym.load.

    \b
    Examples:
      spragsym derive my_brake.py --out my_brake

    \b
    Exit codes: 0 written; 1 the page can't be carried through; 2 usage, or a folder is in the way.
    """
    from ..derive import folder
    from ..derive.model import PageError

    refuse([out / "model.json"], force, made=True)
    try:
        count = folder.write_page(page, out)
    except PageError as error:
        raise click.ClickException(f"{error}; nothing was written") from error
    except FileExistsError as error:
        raise ParameterError(str(error)) from error
    except OSError as error:
        raise StoreError(f"{out} cannot be written: {error.strerror}; make room, or give another path") from error
    click.echo(f"wrote {count} files to {out}/", err=True)
    for name in sorted(path.name for path in out.iterdir() if path.is_file()):
        click.echo(out / name)
