"""Tables: styled on a terminal, plain in a pipe, never cut."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rich.console import RenderableType

#: Columns where no terminal says how many: no line is broken.
PLAIN_WIDTH = 1000


def show(thing: RenderableType, whole: bool = False) -> None:
    """Print a table or a styled text on stdout, in a pipe without styles and without blanks at the ends of lines.

    What is ``whole`` is not fitted into a narrow terminal, which then breaks the lines itself.
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


def print_table(title: str, header: Sequence[str], rows: Sequence[Sequence[object]], empty: str = "none") -> None:
    """Print a table with a title, or the title and a word where it has no rows."""
    from rich.table import Table
    from rich.text import Text

    if title:
        show(Text(title, style="bold") if rows else Text(f"{title}: {empty}"))
    if not rows:
        return
    table = Table(box=None, pad_edge=False)
    for name in header:
        table.add_column(Text(name), no_wrap=True)
    for row in rows:
        table.add_row(*(cell if isinstance(cell, Text) else Text(str(cell)) for cell in row))
    show(table, whole=True)


def print_json(thing: Any) -> None:
    """Print JSON, in which a number that is none, or too large to be one, is null."""
    import click

    click.echo(json.dumps(_plain(thing), indent=1, ensure_ascii=False, allow_nan=False))


def _plain(thing: Any) -> Any:
    if isinstance(thing, dict):
        return {name: _plain(value) for name, value in thing.items()}
    if isinstance(thing, list | tuple):
        return [_plain(value) for value in thing]
    return None if isinstance(thing, float) and not math.isfinite(thing) else thing
