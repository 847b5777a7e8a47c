"""Output of commands: tables, styled on a terminal, plain in a pipe, never cut; JSON; and files,
none overwritten unasked.
"""

from __future__ import annotations

import itertools
import json
import math
import shutil
import sys
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

from ..core.errors import TargetError
from ..core.progress import show_progress
from ..display import aligned
from ..files.storage import OVERWRITING, probe, put
from ..numerics.decimals import upward

if TYPE_CHECKING:
    from ..figures.style import Shown


def line_width() -> int:
    """Width of the terminal; 0 in a pipe, where no line is broken."""
    return (
        shutil.get_terminal_size().columns if sys.stdout is not None and sys.stdout.isatty() else 0
    )


def wrapped(text: str, indent: int = 0) -> str:
    """A text for a line of the terminal, of which the first characters are taken; further lines
    begin below its first word.
    """
    # Least width of a text beside others.
    room = max(line_width() - indent, 20)
    return f"\n{' ' * indent}".join(textwrap.wrap(text, room)) if line_width() else text


def print_rows(
    title: str,
    rows: Sequence[Mapping[str, Any]],
    optional: Sequence[str] = (),
    error: str = "error",
) -> None:
    """Print a table of rows that have the same columns under a title; without rows, the title and
    ``none``.

    Floats get as many digits as the line has room for, up to twelve; columns that are ``optional``
    are left out, the first of them first, while it has none. ``--json`` gives all. The column
    ``error`` has bounds, of two digits.
    """
    if title:
        click.echo(click.style(title, bold=True) if rows else f"{title}: none")
    if rows:
        columns = _fitted(
            [(name, [row[name] for row in rows]) for name in rows[0]], optional, error
        )
        head, *lines = aligned(list(zip(*columns, strict=True)))
        if head.strip():
            click.secho(head, bold=True)
        click.echo("\n".join(lines))


def _fitted(
    columns: Sequence[tuple[str, Sequence[object]]], optional: Sequence[str], error: str
) -> list[list[str]]:
    """Each column as its name and its cells, together no wider than the line if that can be."""
    written: list[list[str]] = []
    # Digits in any case.
    least_digits = 5
    # Digits of a number in a table, where the line has room for them.
    for left_out, digits in itertools.product(
        range(len(optional) + 1), range(12, least_digits - 1, -1)
    ):
        used = ((name, cells) for name, cells in columns if name not in optional[:left_out])
        written = [
            [name, *(_written(name, cell, digits, error) for cell in cells)] for name, cells in used
        ]
        # Width that a table of numbers fits into, unless the terminal is wider.
        if sum(max(map(len, column)) + 2 for column in written) - 2 <= max(80, line_width()):
            break
    return written


def _written(name: str, cell: object, digits: int, error: str) -> str:
    if not isinstance(cell, float):
        return str(cell)
    if name == error:
        return upward(cell)
    if name.startswith("growth"):
        return f"{cell:.1e}"
    return f"{cell:.{digits}g}"


def print_json(thing: object) -> None:
    """Print JSON; NaN and infinities, which JSON does not have, become null."""
    # Where the stream can't write Greek letters, JSON has an escape for them.
    escaped = not (getattr(sys.stdout, "encoding", None) or "utf").lower().startswith("utf")
    click.echo(json.dumps(_plain(thing), indent=1, ensure_ascii=escaped, allow_nan=False))


def _plain(thing: object) -> object:
    if isinstance(thing, dict):
        return {name: _plain(value) for name, value in thing.items()}
    if isinstance(thing, list | tuple):
        return [_plain(value) for value in thing]
    return None if isinstance(thing, float) and not math.isfinite(thing) else thing


def is_typed(option: str) -> bool:
    """Whether an option stands on the command line."""
    return click.get_current_context().get_parameter_source(option) == ParameterSource.COMMANDLINE


def refuse(paths: Iterable[Path | None], *, made: bool = False) -> None:
    """Raise, before any work, if one of the files exists, unless it is to be overwritten, or if it
    can't be written.
    """
    targets = [path for path in paths if path is not None]
    found = [str(path) for path in targets if path.exists()]
    if found and not is_typed("force"):
        exist = "exists" if len(found) == 1 else "exist"
        raise TargetError(
            f"{', '.join(found)} {exist}; nothing was written; use --force to overwrite, or "
            "give another path"
        )
    for path in targets:
        probe(path, made=made)


def write(files: Mapping[Path, Any], *, made: bool = False) -> bool:
    """Write texts or bytes to files, but where they are; whether there were others. Refused if a
    file is in the way.
    """
    data = {path: held.encode() if isinstance(held, str) else held for path, held in files.items()}
    changed = {
        path: held
        for path, held in data.items()
        if not (path.is_file() and path.read_bytes() == held)
    }
    refuse(changed, made=made)
    for path, held in changed.items():
        put(path, held, made=made)
    return bool(changed)


@contextmanager
def resumed() -> Iterator[None]:
    """Work that goes on in its file where it stopped; with ``--force`` whatever is there, which
    stays until that is done.
    """
    token = OVERWRITING.set(is_typed("force"))
    try:
        yield
    except TargetError as error:
        raise TargetError(f"{error}, or use --force to overwrite") from error
    finally:
        OVERWRITING.reset(token)


def drawn(
    path: Path | None,
    part: str,
    make: Callable[[], Any],
    axes: Callable[[], Iterable[Sequence[Shown | None]]] = tuple,
) -> None:
    """Draw a figure if its file is asked for; ``axes`` says of each panel what its two axes show,
    None as it is.
    """
    if path is None:
        return
    from ..figures.style import house_style, in_units, picture

    with house_style(), show_progress(part):
        figure = make()
        for ax, shown in zip(figure.axes, axes(), strict=False):
            for axis, one in zip((ax.xaxis, ax.yaxis), shown, strict=True):
                in_units(axis, one)
        put(path, picture(figure, path.suffix[1:]))
    click.echo(f"drew {path}", err=True)
