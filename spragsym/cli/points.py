"""States, folds, cusps and onsets as rows of a table and of JSON, and where it is not known whether there are more."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import click

from ..results.points import after_if_known
from .output import print_rows

if TYPE_CHECKING:
    from .of_model import Case

#: Of an onset what JSON has besides the table.
BESIDE = ("lyapunov", "lyapunov_error", "crossing", "why")


def points_of(case: Case, found: Any, after: bool = False) -> dict[str, Any]:
    """A row for each point, whether these are all, what was searched, and the undecided boxes; ``after`` at any cost."""
    names, following = [*found.vary, "kind", *found.columns], {}
    if hasattr(found, "criticality"):
        names += ["omega", "criticality", "when", *BESIDE]
    elif len(found.vary) == 1:
        names += ["ends", "when"]
        following = case.row(found.after if after else after_if_known(found), "_after")
    points = case.rows({name: getattr(found, name) for name in names}, **following, error=found.error.tolist())
    searched, *undecided = case.boxes([found.region, *found.undecided], (*case.model.coordinates, *found.vary))
    return {
        "points": points, "complete": bool(found.complete), "searched": searched, "undecided": undecided,
        "remarks": case.said(found.remarks),
    }  # fmt: skip


def print_points(title: str, told: Mapping[str, Any], where: Sequence[str]) -> None:
    """A table of points, and where it is not known whether there are more."""
    rows = told["points"]
    if rows or told["complete"]:
        shown = [{name: value for name, value in row.items() if name not in BESIDE} for row in rows]
        after = [name for name in (shown[0] if shown else ()) if "_after" in name]
        angles = (name for name in after if name.startswith("theta"))
        room = [*lengths(after), *lengths(shown[0] if shown else ()), "error", *angles, *after[::-1]]
        print_rows(f"{title} along {' and '.join(where)}", shown, list(dict.fromkeys(room)))
    lost = [row for row in rows if row.get("ends") in ("lower", "upper") and _is_lost(row)]
    if lost:
        everywhere = math.isinf(next(iter(told["searched"].values()))[0])  # as by closed forms: a search may be undecided
        known = "is left" if told["complete"] and everywhere else "was found"
        nowhere = ", ".join(f"{row[where[0]]:.6g}" for row in lost)
        click.echo(f"{title}: nothing stable in contact {known} to jump to at {' and '.join(where)} = {nowhere}")
    print_open(title, told)


def print_open(title: str, told: Mapping[str, Any]) -> None:
    """Whether these are all, and what is known of the rest."""
    if told["undecided"]:
        click.echo(f"{title}: not complete, {summed(told['undecided'])}")
    elif not told["complete"]:
        click.echo(f"{title}: not complete")
    for remark in told["remarks"]:
        click.echo(f"{title}: {remark}")


def _is_lost(row: Mapping[str, Any]) -> bool:
    return any(math.isnan(value) for name, value in row.items() if "_after" in name)


def lengths(columns: Sequence[str] | Mapping[str, Any]) -> list[str]:
    """Columns that a table without room for them leaves out: lengths of springs, which follow from coordinates."""
    return [name for name in columns if name == "L" or name.startswith("L_")]


def summed(boxes: Sequence[dict[str, Any]]) -> str:
    """How many boxes are undecided, and what holds them all; ``--json`` lists each."""
    titles = [title for title, ends in boxes[0].items() if isinstance(ends, list)]
    hull = ", ".join(
        f"{title} in [{min(box[title][0] for box in boxes):.8g}, {max(box[title][1] for box in boxes):.8g}]" for title in titles
    )
    return f"{'1 box is' if len(boxes) == 1 else f'{len(boxes)} boxes are'} undecided, within {hull}"
