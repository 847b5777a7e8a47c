"""Rows of the ledger of claims: what is stated, what was computed, and what has drifted from the record."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from enum import StrEnum
from importlib import resources
from typing import Any, TypeAlias

import numpy as np

from ..progress import doing

#: What a row may hold: numbers, words, or lists of them.
Value: TypeAlias = float | int | str | list[float] | list[int] | list[str]


class Status(StrEnum):
    """Outcome of a statement."""

    REPRODUCED = "reproduced"
    MISPRINT = "misprint"  #: a wrong number of an equation or a figure; what is meant holds
    CORRECTED = "corrected"  #: wrong in substance: another number is right, or it holds for fewer cases
    NOT_REPRODUCED = "not reproduced"
    NOT_STATED = "input not stated"


@dataclass(frozen=True)
class Found:
    """The result of a computation: whether the row's outcome holds, and the values behind it."""

    holds: bool
    values: dict[str, Value]


@dataclass(frozen=True)
class Statement:
    """A statement of the article and the computation that decides it."""

    id: str
    where: str
    stated: str
    compute: Callable[[], Found]
    outcome: str  #: in words, if the computation holds
    test: str  #: in tests/article/test_claims.py
    command: str
    status: Status = Status.REPRODUCED  #: if the computation holds
    digits: int = 12  #: of the computed numbers
    tolerance: str = "none: a yes or no"
    consequence: str = ""  #: for those who use the article, where a statement does not hold as it stands


@dataclass(frozen=True)
class Row:
    """One row of the ledger of claims."""

    id: str
    where: str
    stated: str
    outcome: str
    status: str
    digits: int
    tolerance: str
    command: str
    test: str
    consequence: str = ""
    values: dict[str, Value] = field(default_factory=dict)

    def as_dict(self) -> dict[str, Any]:
        """For JSON."""
        return asdict(self)


def run(statements: Sequence[Statement]) -> list[Row]:
    """Compute every row; nothing is read from the record."""
    rows = []
    for statement in statements:
        with doing(statement.id):
            rows.append(_row(statement))
    return rows


def recorded() -> list[dict[str, Any]]:
    """The committed rows."""
    text = resources.files(__package__).joinpath("record.json").read_text(encoding="utf-8")
    rows: list[dict[str, Any]] = json.loads(text)
    return rows


def drifted(rows: Sequence[Row], record: Sequence[dict[str, Any]]) -> list[str]:
    """What differs from the record, one line each: rows, statuses, words, and numbers beyond their digits."""
    before = {row["id"]: row for row in record}
    now = {row.id: row.as_dict() for row in rows}
    lines = [f"{id}: is not in the record" for id in now if id not in before]
    lines += [f"{id}: is in the record, but is no longer computed" for id in before if id not in now]
    for id in now.keys() & before.keys():
        lines += [f"{id}: {line}" for line in _differences(now[id], before[id])]
    return sorted(lines)


def record_text(rows: Sequence[Row]) -> str:
    """The record as JSON, numbers rounded to their digits."""
    return json.dumps([row.as_dict() for row in rows], indent=1, ensure_ascii=False) + "\n"


def _row(statement: Statement) -> Row:
    found = statement.compute()
    return Row(
        id=statement.id,
        where=statement.where,
        stated=statement.stated,
        outcome=statement.outcome if found.holds else "does not hold: " + statement.outcome,
        status=str(statement.status if found.holds else Status.NOT_REPRODUCED),
        digits=statement.digits,
        tolerance=statement.tolerance,
        command=statement.command,
        test=f"tests/article/test_claims.py::{statement.test}",
        consequence=statement.consequence,
        values={name: _rounded(value, statement.digits) for name, value in found.values.items()},
    )


def _rounded(value: Any, digits: int) -> Value:
    if isinstance(value, np.ndarray | list | tuple):
        items: list[Any] = [_rounded(item, digits) for item in value]
        return items
    if isinstance(value, float | np.floating):
        return float(f"{float(value):.{digits}g}")
    return int(value) if isinstance(value, np.integer | int) and not isinstance(value, bool) else str(value)


def _differences(now: dict[str, Any], before: dict[str, Any]) -> list[str]:
    words = [
        f"{name} is {now[name]!r}, not {before.get(name)!r}" for name in now if name != "values" and now[name] != before.get(name)
    ]
    old = before.get("values", {})
    names = {**now["values"], **old}
    return words + [
        f"{name} = {now['values'].get(name)}, not {old.get(name)}"
        for name in names
        if not _close(now["values"].get(name), old.get(name), now["digits"])
    ]


def _close(one: Any, other: Any, digits: int) -> bool:
    """Whether values are equal; floats may differ by a unit of the last recorded digit, those below 1 by that unit of 1."""
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(_close(a, b, digits) for a, b in zip(one, other, strict=True))
    if isinstance(one, float) and isinstance(other, float):
        return abs(one - other) <= 1.01 * 10.0 ** (1 - digits) * 10.0 ** math.floor(math.log10(max(abs(other), 1.0)))
    return bool(one == other)
