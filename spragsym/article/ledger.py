"""Rows of the ledger of claims: what is stated, what was computed, and what has drifted; and the
referee's page of them.
"""

from __future__ import annotations

import json
import math
import tomllib
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from ..core.errors import ConvergenceError
from ..core.progress import doing
from ..files.text import filled, shipped_text
from .assumed import D, V

#: What a row may hold: numbers, words, or lists of them.
Value: TypeAlias = float | int | str | list[float] | list[int] | list[str]
#: A row of the ledger of claims.
Row: TypeAlias = dict[str, Any]


@dataclass(frozen=True, kw_only=True)
class ArticleStatement:
    """A statement of the article and the computation that decides it, as statements.toml has it."""

    id: str
    where: str
    stated: str
    computed: str | list[Any]  #: a function of computed.py, with its arguments if it has any
    outcome: str  #: in words, if the computation holds
    status: str = "reproduced"  #: if the computation holds
    digits: int = 12  #: of the computed numbers
    tolerance: str = "none: a yes or no"
    command: str
    test: str  #: in tests/article/test_claims.py, unless its file is named
    #: For those who use the article, where a statement does not hold as it stands.
    consequence: str = ""

    def row(self, holds: bool, values: dict[str, Value]) -> Row:
        """A row of the ledger of claims: what is stated and what was found."""
        test = self.test if "::" in self.test else f"tests/article/test_claims.py::{self.test}"
        row = vars(self) | {"test": test, "values": values}
        del row["computed"]
        if not holds:
            row |= {"outcome": f"does not hold: {self.outcome}", "status": "not reproduced"}
        return row


def printed() -> dict[str, Any]:
    """The ledger of the printed equations, as it was derived."""
    return json.loads(shipped_text("spragsym.generated", "ledger.json"))


STATEMENTS = tuple(
    ArticleStatement(id=id, **entry)
    for id, entry in tomllib.loads(shipped_text("spragsym.article", "statements.toml")).items()
)


def run(statements: Sequence[ArticleStatement]) -> list[Row]:
    """Compute the row of every statement; nothing is read from the record."""
    from . import computed

    rows = []
    for statement in statements:
        name, *arguments = (
            [statement.computed] if isinstance(statement.computed, str) else statement.computed
        )
        with doing(statement.id):
            holds, values = getattr(computed, name)(*arguments)
        rows.append(
            statement.row(
                bool(holds),
                {name: rounded(value, statement.digits) for name, value in values.items()},
            )
        )
    return rows


def recorded(statements: Sequence[ArticleStatement] = STATEMENTS) -> list[Row]:
    """The rows of statements with the committed values: each held when they were written."""
    values = json.loads(shipped_text("spragsym.article", "record.json"))
    return [statement.row(True, values[statement.id]) for statement in statements]


def drifted(rows: Sequence[Row], record: Sequence[Row]) -> list[str]:
    """Differences from the record, one line each: statuses, words, and numbers beyond their
    digits.
    """
    before = {row["id"]: row for row in record}
    return sorted(
        f"{row['id']}: {line}" for row in rows for line in _differences(row, before[row["id"]])
    )


def record_text(rows: Sequence[Row]) -> str:
    """The record as JSON, numbers rounded to their digits; rows that do not hold can't be
    recorded.
    """
    if lost := [row["id"] for row in rows if row["status"] == "not reproduced"]:
        raise ConvergenceError(
            f"{', '.join(lost)}: not reproduced; mend the statement in statements.toml, or "
            "what computes it"
        )
    return (
        json.dumps({row["id"]: row["values"] for row in rows}, indent=1, ensure_ascii=False) + "\n"
    )


def rounded(value: object, digits: int) -> Value:
    """A number, or several, to so many digits; of some numbers of a row fewer are known than of the
    others.
    """
    if isinstance(value, np.ndarray | list | tuple):
        items: list[Any] = [rounded(item, digits) for item in value]
        return items
    if isinstance(value, float | np.floating):
        return float(f"{float(value):.{digits}g}")
    if isinstance(value, np.integer | int) and not isinstance(value, bool):
        return int(value)
    return str(value)


def _differences(now: Row, before: Row) -> list[str]:
    words = [
        f"{name} is {new!r}, not {before[name]!r}"
        for name, new in now.items()
        if name != "values" and new != before[name]
    ]
    new, old = now["values"], before["values"]
    return words + [
        f"{name} = {new.get(name)}, not {old.get(name)}"
        for name in {**new, **old}
        if not _close(new.get(name), old.get(name), now["digits"])
    ]


def _close(one: object, other: object, digits: int) -> bool:
    """Whether values are equal; floats may differ by a unit of the last recorded digit, those below
    1 by that unit of 1.
    """
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(
            _close(a, b, digits) for a, b in zip(one, other, strict=True)
        )
    if isinstance(one, float) and isinstance(other, float):
        return abs(one - other) <= 1.01 * 10.0 ** (1 - digits) * 10.0 ** math.floor(
            math.log10(max(abs(other), 1.0))
        )
    return bool(one == other)


#: Growth of the states at 30°, for the friction's own slope at V and d: μ₀, what (27) says, largest
#: real part of λ.
PARADOX = (
    (0.5, "before the jump", "stable", -4.4e-6),
    (0.5, "after the jump", "stable", 4.9e-6),
    (0.8, "after the jump", "stable", 1.2e-5),
)


def page() -> str:
    """The page, in Markdown: reproduction.md, filled in (extra ``plot``)."""
    rows = printed()["rows"]
    claims = recorded()
    forms = shipped_text("spragsym.generated", "LEDGER.md")

    def both_forms(id: str) -> str:
        """Printed form above the derived one, as the ledger's page shows the row."""
        section = forms.partition(f"\n### {id}\n")[2]
        return section[section.index("```math") :].partition("\n```\n")[0] + "\n```"

    equations, stated = (Counter(row["status"] for row in those) for those in (rows, claims))
    return filled(
        "spragsym.article",
        "reproduction.md",
        "the report on the article",
        rows=rows,
        claims=claims,
        printed=equations,
        stated=stated,
        paradox=PARADOX,
        V=V,
        d=f"{D:g}",
        both_forms=both_forms,
    )
