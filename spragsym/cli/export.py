"""``spragsym export`` and ``derive``: the solver in another language, and a model page carried
through to a folder.
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import asdict
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

import click

from .. import derive as derive_package
from ..core.errors import MissingExtraError, ParameterError, StoreError
from ..derive.emit.targets import Start, continues, languages, packer
from ..derive.kang_nam.library import exported
from ..files.cache import cached, digest_of_folder
from ..files.storage import probe
from ..models import Model
from ..models.load import USUAL, load, page_of, shipped
from ..statics.search import steady_states
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
@click.option(
    "--fmi",
    type=click.Choice(["2", "3"]),
    help="Version of the standard of an FMU, 2.0 or 3.0; by default both: FMI 3.0 in the file "
    "--out, FMI 2.0 beside it with _fmi2 in its name.",
)
@o.trust
@o.force
def export(
    model_name: str | None,
    language: str,
    data: Path | None,
    out: Path,
    inputs: tuple[str, ...],
    fmi: str | None,
) -> None:
    """Write the solver in another language, with an example that runs.

    The article's solver, generated algebra and a step in time; of another model, and as an FMU, its
    forces and motion with their derivatives, derived from its model page (extra derive); for AUTO
    and Julia with proved states from which branches are continued. What was
    derived is kept in the user's cache folder, and derived again when page or package change.

    \b
    Examples:
      spragsym export --language c --out sprag
      spragsym export --model trolley --out trolley_c
      make -C sprag && ./sprag/example
      spragsym export --language auto --model trolley --out trolley_auto
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
    if fmi and not pack:
        raise ParameterError(
            f"--fmi: an export to {language} is no FMU; leave it out, or give --language fmu"
        )
    beside = {"3": out, "2": out.with_stem(f"{out.stem}_fmi2")}
    archives = {fmi: out} if fmi else beside
    for path in archives.values() if pack else (out / "file",):
        probe(path, made=True)
    study = study_of(data, model_name) if data else None
    name = study.model if study else model_name
    if name is None and (pack or continues(language)):
        name = USUAL
    if name:
        texts = _of_page(load(name), language, study.in_units() if study else None, inputs)
    else:
        texts = exported(language)
    try:
        files: dict[Path, str | bytes] = (
            {path: pack(texts, version) for version, path in archives.items()}
            if pack
            else {out / path: text for path, text in texts.items()}
        )
    except ChildProcessError as error:
        raise click.ClickException(f"{error}; nothing was written") from error
    write(files, made=True)
    for path in files:
        click.echo(path)


def _of_page(
    model: Model,
    language: str,
    data: Mapping[str, tuple[float, str, float]] | None,
    inputs: tuple[str, ...],
) -> dict[str, str]:
    """The files of a page's library: derived once from the same page by the same derivation."""
    derivation = Path(derive_package.__file__).parent
    page = page_of(model, derivation / "models")

    def derived() -> dict[str, str]:
        from ..derive import export as translation

        try:
            return translation.export(page, model.name, language, data, inputs, starts)
        except translation.UnknownInput as error:
            raise ParameterError(f"--input: {error}") from error

    starts = tuple(_starts(model)) if continues(language) else ()
    made_of = {
        "page": page.read_text(encoding="utf-8", errors="replace") if page.is_file() else "",
        "derivation": digest_of_folder(derivation),
        "sympy": version("sympy") if find_spec("sympy") else "",
        "called": (model.name, language, data, inputs, [asdict(start) for start in starts]),
    }
    return cached(made_of, derived)


def _starts(model: Model) -> Iterator[Start]:
    """The steady states at the base values, proved by search, each in its smooth regime; none where
    friction holds, or under a clock.
    """
    if model.clock:
        return
    _, p = model.cases()[0]
    values = {name: float(p[name]) for name in model.parameters}
    field, along = model.field, model.inclination or model.coefficient or model.parameters[0]
    constants = field.constants([values[name] for name in model.parameters])
    for touching, places, errors in steady_states(p):
        for count, (place, error) in enumerate(zip(places, errors, strict=True), 1):
            mode = field.exact(field.resting_mode(place.tolist(), constants))
            mode = tuple(map(int, field.regime(mode)))
            if 0 not in mode[len(model.contacts) :]:
                label = re.sub(r"\W+", "_", f"{touching} {count}")
                yield Start(label, along, values, tuple(place.tolist()), mode, float(error))


@o.command()
@click.argument("page", metavar="PAGE|NAME")
@o.folder("Folder to write.", required=False)
@o.file("--latex", metavar="FILE", help="Write the derivation as a text, in LaTeX.")
@o.file("--html", metavar="FILE", help="Write it as one page of HTML.")
@o.file("--statements", metavar="FILE", help="Write its equations for spragsym check.")
@o.force
def derive(
    page: str, out: Path | None, latex: Path | None, html: Path | None, statements: Path | None
) -> None:
    """Derive a model from its model page, and write it to a folder, or as a text.

    A model page is a Python file that says quantities, coordinates, energies, springs, contact and
    friction; it is run. The folder is what --model of other commands takes, and spragsym.load. The
    text has drawing, nomenclature, energies, equations of motion with units and scaled,
    equilibrium and linearization, numbered as in the appendix of a paper, of a page or of a shipped
    model.

    \b
    Examples:
      spragsym derive my_brake.py --out my_brake
      spragsym derive my_brake.py --latex appendix.tex --statements appendix.toml
      spragsym derive kang_nam --html kang_nam.html
    """
    if not any((out, latex, html, statements)):
        message = "give --out for a folder, --latex, --html or --statements for a text"
        raise click.UsageError(message)
    path = Path(page)
    if page in shipped():
        path = Path(derive_package.__file__).parent / "models" / f"{page}.py"
    elif not path.is_file():
        raise ParameterError(
            f"PAGE = {page}: there is no such file; give a page, or one of {', '.join(shipped())}"
        )
    refuse([None if out is None else out / "model.json"], made=True)
    refuse([latex, html, statements])
    if html is not None and find_spec("latex2mathml") is None:
        raise MissingExtraError("--html", "latex2mathml", "derive")
    texts = _texts(path, {latex: "latex", html: "html", statements: "statements"})
    if out is not None:
        _folder(path, out)
    write(texts)
    for name in texts:
        click.echo(f"wrote {name}", err=True)


def _texts(page: Path, kinds: Mapping[Path | None, str]) -> dict[Path, str]:
    """The derivation as texts, by file."""
    from ..derive import manuscript_files
    from ..derive.manuscript import manuscript
    from ..derive.model import PageError
    from ..derive.pages import read

    files = {path: kind for path, kind in kinds.items() if path is not None}
    if not files:
        return {}
    writers = {
        "latex": manuscript_files.as_latex,
        "html": manuscript_files.as_html,
        "statements": manuscript_files.as_statements,
    }
    try:
        found = manuscript(read(page))
    except PageError as error:
        raise click.ClickException(f"{error}; nothing was written") from error
    return {path: writers[kind](found) for path, kind in files.items()}


def _folder(page: Path, out: Path) -> None:
    """Derive a page and write its folder."""
    from ..derive import folder
    from ..derive.model import PageError

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
