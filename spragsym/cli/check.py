"""``spragsym check``: the ledger, recomputed."""

from __future__ import annotations

import json
import sys
from importlib import resources

import click

from ..errors import MissingExtraError
from .options import as_json

_STYLES = {"confirmed": "green", "corrected": "yellow", "approximation": "cyan", "definition": "dim", "failed": "bold red"}


@click.command()
@as_json
def check(json_output: bool) -> None:
    """Hold every printed equation of the article against the derivation.

    Recomputes every row; nothing is read from a file but the committed ledger, to see that no row has changed.

    \b
    Examples:
      spragsym check
      spragsym check --json | jq '.[] | select(.status == "corrected")'

    \b
    Exit codes: 0 every row is as recorded; 1 a row is not; 2 usage.
    """
    try:
        from ..derive import check as derivation
    except ModuleNotFoundError as error:
        raise MissingExtraError("spragsym check", error.name or "sympy", "derive") from error
    rows = derivation.run()
    recorded = json.loads(resources.files("spragsym.generated").joinpath("ledger.json").read_text(encoding="utf-8"))
    changed = _changed([row.as_dict() for row in rows], recorded["rows"])
    if json_output:
        click.echo(json.dumps([row.as_dict() for row in rows], indent=1, ensure_ascii=False))
    else:
        _print_table(rows)
    for id in changed:
        click.echo(f"spragsym check: {id} is not as recorded in generated/ledger.json", err=True)
    for row in derivation.failures(rows):
        click.echo(f"spragsym check: {row.id} ({row.where}): {row.note}", err=True)
    if changed or derivation.failures(rows):
        sys.exit(1)


def _changed(rows: list[dict[str, str]], recorded: list[dict[str, str]]) -> list[str]:
    before = {row["id"]: row for row in recorded}
    now = {row["id"]: row for row in rows}
    return [id for id in sorted(before.keys() | now.keys()) if before.get(id) != now.get(id)]


def _print_table(rows: list[object]) -> None:
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table("row", "where", "status", "remark", box=None, pad_edge=False)
    for row in rows:
        remark = row.cause or row.limit or row.note  # type: ignore[attr-defined]
        status = row.status  # type: ignore[attr-defined]
        table.add_row(row.id, row.where, Text(status, style=_STYLES[status]), Text(remark))  # type: ignore[attr-defined]
    console = Console()
    console.print(table)
    for row in rows:
        if row.consequence:  # type: ignore[attr-defined]
            console.print(f"\n{row.id}: right is {row.right}\n  {row.consequence}", markup=False, highlight=False)  # type: ignore[attr-defined]
