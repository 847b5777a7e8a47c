"""Folds, cusps and onsets as rows of a table and of JSON, and where it is not known whether there are more."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import click

from .spans import Span
from .states import boxes_of, placed, summed, unless_room
from .tables import print_table

if TYPE_CHECKING:
    from .of_model import Case

#: Of an onset what JSON has besides the table.
BESIDE = ("lyapunov", "lyapunov_error", "crossing", "why")


def points_of(case: Case, found: Any, along: Sequence[Span]) -> dict[str, Any]:
    """A row for each point, whether these are all, what was searched, and the boxes that are not decided."""
    names = (*case.model.coordinates, *found.vary)
    (region,) = boxes_of(case, [found.region], names)
    undecided = boxes_of(case, found.undecided, names)
    for one in (region, *undecided):
        for name, span in zip(found.vary, along, strict=True):
            title, unit = case.units.varied(name)[::-1][:2]
            one[span.title] = [span.unit / unit * end for end in one.pop(title)]
    return {
        "points": [_row(case, found, row, along) for row in range(len(found))],
        "complete": bool(found.complete), "searched": region, "undecided": undecided, "remarks": case.units.said(found.remarks),
    }  # fmt: skip


def _row(case: Case, found: Any, row: int, along: Sequence[Span]) -> dict[str, Any]:
    at = {span.title: span.unit * float(getattr(found, span.name)[row]) for span in along}
    places = placed(case.units, found.columns, lambda name: getattr(found, name)[row])
    told: dict[str, Any] = {**at, "kind": str(found.kind[row]), **places}
    if hasattr(found, "criticality"):
        omega, per = case.units.rate("omega")
        told |= {omega: per * float(found.omega[row]), "criticality": str(found.criticality[row]), "when": str(found.when[row])}
        told |= {name: getattr(found, name)[row] for name in BESIDE}
    elif len(along) == 1:
        told |= {"ends": str(found.ends[row]), "when": str(found.when[row])}
        told |= placed(case.units, found.columns, lambda name: found.after[name][row], "_after")
    return {name: value.item() if hasattr(value, "item") else value for name, value in told.items()} | {
        "error": float(found.error[row])
    }


def print_points(title: str, told: dict[str, Any], along: Sequence[Span]) -> None:
    """A table of points, and where it is not known whether there are more."""
    rows, where = told["points"], " and ".join(span.title for span in along)
    if rows or told["complete"]:
        header = [name for name in (rows[0] if rows else ()) if name not in BESIDE]
        after = [name for name in header if "_after" in name]
        room = [
            *unless_room(after)[:-1],
            *unless_room(header),
            *(name for name in after if name.startswith("theta")),
            *after[::-1],
        ]
        print_table(
            f"{title} along {where}", header, [[row[name] for name in header] for row in rows], optional=list(dict.fromkeys(room))
        )
    nowhere = [f"{row[along[0].title]:.6g}" for row in rows if row.get("ends") in ("lower", "upper") and _lost(row)]
    if nowhere:
        known = "is left" if told["complete"] else "was found"
        click.echo(f"{title}: nothing stable in contact {known} to jump to at {where} = {', '.join(nowhere)}")
    if told["undecided"]:
        click.echo(f"{title}: not complete, {summed(told['undecided'])}")
    elif not told["complete"]:
        click.echo(f"{title}: not complete")
    for remark in told["remarks"]:
        click.echo(f"{title}: {remark}")


def _lost(row: Mapping[str, Any]) -> bool:
    return any(math.isnan(value) for name, value in row.items() if "_after" in name)
