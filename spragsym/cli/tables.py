"""Tables: styled on a terminal, plain in a pipe, never cut."""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..numerics.decimals import upward

if TYPE_CHECKING:
    from rich.console import RenderableType

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
    import click
    from rich.console import Console
    from rich.measure import Measurement

    wide = Console(highlight=False, width=PLAIN_WIDTH)
    if wide.is_terminal:
        out = Console(highlight=False)
        least = Measurement.get(wide, wide.options, thing).maximum if whole else 0
        out.width = max(out.width, least)
        out.print(thing)
        return
    with wide.capture() as captured:
        wide.print(thing)
    for line in captured.get().splitlines():
        click.echo(line.rstrip())


def print_table(
    title: str, header: Sequence[str], rows: Sequence[Sequence[object]], empty: str = "none", optional: Sequence[str] = ()
) -> None:
    """Print a table under a title; without rows, the title and the word ``empty``.

    Floats get as many digits as the line has room for, up to twelve; columns that are ``optional`` are left out, the first of
    them first, while it has none. ``--json`` gives all.
    """
    from rich.table import Table
    from rich.text import Text

    if title:
        show(Text(title, style="bold") if rows else Text(f"{title}: {empty}"))
    if not rows:
        return
    table = Table(box=None, pad_edge=False)
    fitted, fits = _fitted(header, rows)
    for name in optional:
        if not fits and name in header:
            place = header.index(name)
            header = [*header[:place], *header[place + 1 :]]
            rows = [[*row[:place], *row[place + 1 :]] for row in rows]
            fitted, fits = _fitted(header, rows)
    for name in header:
        table.add_column(Text(name), no_wrap=True)
    for row in fitted:
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
        fits = sum(widths) + 2 * (len(widths) - 1) <= room
        if fits:
            break
    return written, fits


def print_json(thing: Any) -> None:
    """Print JSON; NaN and infinities, which JSON does not have, become null."""
    import click

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
