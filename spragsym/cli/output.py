"""Output of commands: tables, styled on a terminal, plain in a pipe, never cut; JSON; and files, none overwritten unasked."""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..errors import ParameterError, TargetError
from ..files.stored import overwriting
from ..files.writing import probe, put
from ..numerics.decimals import upward
from ..progress import show_progress

if TYPE_CHECKING:
    from rich.console import RenderableType

    from ..figures.labels import Shown
    from ..figures.style import Sheet

#: Width of the output in a pipe: so wide that no line is broken.
PLAIN_WIDTH = 100_000
#: Width that a table of numbers fits into, unless the terminal is wider.
WIDTH = 80
#: Most and fewest digits of a number in a table: as many as the line has room for.
MOST_DIGITS, LEAST_DIGITS = 12, 5


def show(thing: RenderableType, whole: bool = False) -> None:
    """Print a table or a styled text on stdout, in a pipe without styles and without blanks at the ends of lines.

    If ``whole``, it is not squeezed into a narrow terminal, which then breaks the lines itself.
    """
    from rich.console import Console
    from rich.measure import Measurement

    wide = Console(highlight=False, width=PLAIN_WIDTH)
    if wide.is_terminal:
        out = Console(highlight=False)
        out.width = max(out.width, Measurement.get(wide, wide.options, thing).maximum if whole else 0)
        out.print(thing)
        return
    with wide.capture() as captured:
        wide.print(thing)
    for line in captured.get().splitlines():
        click.echo(line.rstrip())


def print_rows(title: str, rows: Sequence[Mapping[str, Any]], optional: Sequence[str] = ()) -> None:
    """Print a table of rows that have the same columns."""
    print_table(title, tuple(rows[0]) if rows else (), [tuple(row.values()) for row in rows], optional)


def print_table(title: str, header: Sequence[str], rows: Sequence[Sequence[object]], optional: Sequence[str] = ()) -> None:
    """Print a table under a title; without rows, the title and ``none``.

    Floats get as many digits as the line has room for, up to twelve; columns that are ``optional`` are left out, the first of
    them first, while it has none. ``--json`` gives all.
    """
    from rich.table import Table
    from rich.text import Text

    if title:
        show(Text(title, style="bold") if rows else Text(f"{title}: none"))
    if not rows:
        return
    (written, fits), header = _fitted(header, rows), list(header)
    for name in optional:
        if not fits and name in header:
            place = header.index(name)
            del header[place]
            rows = [[*row[:place], *row[place + 1 :]] for row in rows]
            written, fits = _fitted(header, rows)
    table = Table(box=None, pad_edge=False)
    for name in header:
        table.add_column(Text(name), no_wrap=True)
    for row in written:
        table.add_row(*(cell if isinstance(cell, Text) else Text(str(cell)) for cell in row))
    show(table, whole=True)


def _fitted(header: Sequence[str], rows: Sequence[Sequence[object]]) -> tuple[list[list[object]], bool]:
    """The rows with their floats written so that the table is no wider than the line, and whether it is not."""
    from rich.cells import cell_len
    from rich.console import Console

    console = Console()
    room = max(WIDTH, console.width if console.is_terminal else 0)
    for digits in range(MOST_DIGITS, LEAST_DIGITS - 1, -1):
        written = [
            [
                cell if not isinstance(cell, float) else upward(cell) if name == "error" else f"{cell:.{digits}g}"
                for name, cell in zip(header, row, strict=True)
            ]
            for row in rows
        ]
        widths = [max(cell_len(str(cell)) for cell in column) for column in zip(header, *written, strict=True)]
        if fits := sum(widths) + 2 * (len(widths) - 1) <= room:
            break
    return written, fits


def print_json(thing: Any) -> None:
    """Print JSON; NaN and infinities, which JSON does not have, become null."""
    # Where the stream can't write Greek letters, JSON has an escape for them.
    click.echo(json.dumps(_plain(thing), indent=1, ensure_ascii=not writes_unicode(sys.stdout), allow_nan=False))


def writes_unicode(stream: Any) -> bool:
    """Whether the stream can write every character."""
    return (getattr(stream, "encoding", None) or "utf-8").lower().replace("-", "").startswith("utf")


def _plain(thing: Any) -> Any:
    if isinstance(thing, dict):
        return {name: _plain(value) for name, value in thing.items()}
    if isinstance(thing, list | tuple):
        return [_plain(value) for value in thing]
    return None if isinstance(thing, float) and not math.isfinite(thing) else thing


def refuse(paths: Iterable[Path | None], force: bool, *, made: bool = False) -> None:
    """Raise, before any work, if one of the files exists, unless it is to be overwritten, or if it can't be written."""
    targets = [path for path in paths if path is not None]
    found = [str(path) for path in targets if path.exists()]
    if found and not force:
        exist = "exists" if len(found) == 1 else "exist"
        raise TargetError(f"{', '.join(found)} {exist}; nothing was written; use --force to overwrite, or give another path")
    for path in targets:
        probe(path, made=made)


def write(files: Mapping[Path, Any], force: bool, *, made: bool = False) -> bool:
    """Write texts or bytes to files, but where they are; whether there were others. Refused if a file is in the way."""
    data = {path: held.encode() if isinstance(held, str) else held for path, held in files.items()}
    changed = {path: held for path, held in data.items() if not (path.is_file() and path.read_bytes() == held)}
    refuse(changed, force, made=made)
    for path, held in changed.items():
        put(path, held, made=made)
    return bool(changed)


@contextmanager
def resumed(force: bool) -> Iterator[None]:
    """Work that goes on in its file where it stopped; with ``force`` whatever is there, which stays until that is done."""
    try:
        with overwriting(force):
            yield
    except TargetError as error:
        raise TargetError(f"{error}, or use --force to overwrite") from error


def drawable(path: Path | None) -> None:
    """Raise for a file of a kind that figures are not written in."""
    if path is not None and path.suffix not in (".pdf", ".png", ".svg"):
        raise ParameterError(f"--plot {path}: the ending must be .pdf, .png or .svg")


def drawn(path: Path, part: str, make: Callable[[], Sheet], axes: Iterable[tuple[Shown | None, Shown | None]] = ()) -> None:
    """Draw a figure in its house's style, and write it; ``axes`` says of each panel what its two axes show, None as it is."""
    from ..figures.files import picture
    from ..figures.labels import in_units
    from ..figures.style import house_style

    with house_style(), show_progress(part):
        figure = make()
        for ax, shown in zip(figure.axes, axes, strict=False):
            for axis, one in zip((ax.xaxis, ax.yaxis), shown, strict=True):
                in_units(axis, one)
        put(path, picture(figure, path.suffix[1:]))
    click.echo(f"drew {path}", err=True)
