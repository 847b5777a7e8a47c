"""``spragsym derive``: a page, carried through to a folder that ``--model`` and ``spragsym.load`` take."""

from __future__ import annotations

from pathlib import Path

import click

from ..errors import MissingExtraError, ParameterError, StoreError
from .commands import command
from .targets import force, refuse


@command()
@click.argument("page", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@click.option("--out", "-o", type=click.Path(path_type=Path, file_okay=False), required=True, help="Folder to write.")
@force
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
    try:
        from ..derive import folder
        from ..derive.model import PageError
    except ModuleNotFoundError as error:
        raise MissingExtraError("spragsym derive", error.name or "sympy", "derive") from error
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
