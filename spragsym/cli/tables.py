"""Tables: styled on a terminal, plain in a pipe, never cut."""

from __future__ import annotations

from collections.abc import Sequence

PLAIN_WIDTH = 200


def print_table(title: str, header: Sequence[str], rows: Sequence[Sequence[object]], empty: str = "none") -> None:
    """Print a table with a title, or the title and a word where it has no rows."""
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    console = Console(highlight=False)
    if not console.is_terminal:
        console = Console(highlight=False, width=PLAIN_WIDTH)
    if title:
        console.print(Text(title, style="bold") if rows else Text(f"{title}: {empty}"))
    if not rows:
        return
    table = Table(box=None, pad_edge=False)
    for name in header:
        table.add_column(Text(name), no_wrap=True)
    for row in rows:
        table.add_row(*(cell if isinstance(cell, Text) else Text(str(cell)) for cell in row))
    console.print(table)
