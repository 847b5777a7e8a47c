"""``spragsym export`` and ``derive``: the solver in another language, and a model page carried
through to a folder.
"""

from pathlib import Path

import click

from ..derive.emit.targets import languages, packer
from ..derive.kang_nam.library import exported
from ..errors import ParameterError, StoreError
from ..files.storage import probe
from ..models.load import USUAL, load, page_of
from . import options as o
from .case import study_of
from .output import refuse, write


@o.command()
@click.option("--model", "model_name", metavar="NAME|DIR", help=o.TEXT)
@click.option("--language", type=click.Choice(languages()), default="c", help="Language to write.")
@o.file(
    "--data",
    exists=True,
    metavar="FILE",
    help="In the units of a file like brake.toml; of an FMU only.",
)
@o.file(
    "--out",
    "-o",
    folder=True,
    required=True,
    help="Folder to write to, made if missing; of an FMU a file.",
)
@click.option(
    "--input",
    "inputs",
    multiple=True,
    metavar="NAME",
    help="Of an FMU: a quantity that other models drive, as a belt speed; may be repeated.",
)
@o.trust
@o.force
def export(
    model_name: str | None,
    language: str,
    data: Path | None,
    out: Path,
    inputs: tuple[str, ...],
    trust: bool,
    force: bool,
) -> None:
    """Write the solver in another language, with an example that runs.

    The article's solver, generated algebra and a step in time; of another model, and as an FMU, its
    forces and motion with their derivatives, derived anew from its model page (extra derive).

    \b
    Examples:
      spragsym export --language c --out sprag
      spragsym export --model trolley --out trolley_c
      make -C sprag && ./sprag/example
      spragsym export --language fmu --data brake.toml --input V --out brake.fmu
    """
    pack = packer(language)
    if data and not pack:
        raise ParameterError(
            f"--data: an export to {language} has no units; leave it out, or give --language fmu"
        )
    if inputs and not pack:
        raise ParameterError(
            f"--input: an export to {language} has functions, whose arguments all quantities are; "
            "leave it out, or give --language fmu"
        )
    probe(out if pack else out / "file", made=True)
    study = study_of(data, model_name, trust) if data else None
    name = study.model if study else model_name or (USUAL if pack else None)
    if name:
        from ..derive import export as translation
        from ..derive import pages

        page = page_of(load(name), pages.SHIPPED)
        data_in_units = study.in_units() if study else None
        try:
            texts = translation.export(page, load(name).name, language, data_in_units, inputs)
        except translation.UnknownInput as error:
            raise ParameterError(f"--input: {error}") from error
    else:
        texts = exported(language)
    try:
        files = {out: pack(texts)} if pack else {out / path: text for path, text in texts.items()}
    except ChildProcessError as error:
        raise click.ClickException(f"{error}; nothing was written") from error
    write(files, force, made=True)
    for path in files:
        click.echo(path)


@o.command()
@click.argument("page", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@o.folder("Folder to write.")
@o.force
def derive(page: Path, out: Path, force: bool) -> None:
    """Derive a model from its model page, and write it to a folder.

    A model page is a Python file that says quantities, coordinates, energies, springs, contact and
    friction; it is run. The folder is what --model of other commands takes, and spragsym.load.

    \b
    Examples:
      spragsym derive my_brake.py --out my_brake
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
        raise StoreError(
            f"{out} cannot be written: {error.strerror}; make room, or give another path"
        ) from error
    click.echo(f"wrote {count} files to {out}/", err=True)
    for name in sorted(path.name for path in out.iterdir() if path.is_file()):
        click.echo(out / name)
