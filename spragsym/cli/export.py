"""``spragsym export``: the solver in another language."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import click

from .targets import force, holds, refuse

#: What an export in C consists of; the last two are the example.
_FILES = {"c": ("spragsym.h", "spragsym.c", "Makefile", "main.c")}


@click.command()
@click.option(
    "--language", type=click.Choice(sorted(_FILES)), default="c", show_default=True, help="Language to write."
)
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    required=True,
    help="Folder to write to, made if missing.",
)
@force
def export(language: str, out: Path, force: bool) -> None:
    """Write the solver, a makefile and an example that runs.

    C99 without allocation or global state: all equilibria with their stability and an error bound, K, the
    equations of motion and their Jacobian, and one step in real time.

    \b
    Examples:
      spragsym export --language c --out sprag
      make -C sprag && ./sprag/example

    \b
    Exit codes: 0 written; 1 the folder can't be written; 2 usage, or a file that differs is in the way.
    """
    texts = {name: _text(language, name) for name in _FILES[language]}
    changed = {name: text for name, text in texts.items() if not holds(out / name, text)}
    refuse((out / name for name in changed), force)
    out.mkdir(parents=True, exist_ok=True)
    for name, text in changed.items():
        (out / name).write_text(text, encoding="utf-8", newline="\n")
    for name in texts:
        click.echo(out / name)


def _text(language: str, name: str) -> str:
    return resources.files("spragsym.generated").joinpath(language, name).read_text(encoding="utf-8")
