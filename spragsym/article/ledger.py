"""Rows of the ledger of claims, one for each statement of the article: what is stated, what was
computed, what has changed since the record; and the report for a referee.
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

#: A computed value as it is recorded: a number, words, or a list of either.
Value: TypeAlias = float | int | str | list[float] | list[int] | list[str]
#: A row of the ledger of claims.
Row: TypeAlias = dict[str, Any]


@dataclass(frozen=True, kw_only=True)
class ArticleStatement:
    """A statement of the article and the computation that decides it: an entry of
    statements.toml.
    """

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
    #: What it means for those who use the article, if the statement does not hold as it stands.
    consequence: str = ""

    def row(self, holds: bool, values: dict[str, Value]) -> Row:
        """The statement's row of the ledger of claims, with the computed values."""
        test = self.test if "::" in self.test else f"tests/article/test_claims.py::{self.test}"
        row = vars(self) | {"test": test, "values": values}
        del row["computed"]
        if not holds:
            row |= {"outcome": f"does not hold: {self.outcome}", "status": "not reproduced"}
        return row


def printed() -> dict[str, Any]:
    """The derived ledger of the article's printed equations, ledger.json."""
    return json.loads(shipped_text("spragsym.generated", "ledger.json"))


STATEMENTS = tuple(
    ArticleStatement(id=id, **entry)
    for id, entry in tomllib.loads(shipped_text("spragsym.article", "statements.toml")).items()
)


def run(statements: Sequence[ArticleStatement]) -> list[Row]:
    """The row of every statement, computed now."""
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
    """The row of every statement with the committed values, for which all of them held."""
    values = json.loads(shipped_text("spragsym.article", "record.json"))
    return [statement.row(True, values[statement.id]) for statement in statements]


def drifted(rows: Sequence[Row], record: Sequence[Row]) -> list[str]:
    """Differences of rows from the recorded ones, a line each: in status, words, and numbers by
    more than their last digit.
    """
    before = {row["id"]: row for row in record}
    return sorted(
        f"{row['id']}: {line}" for row in rows for line in _differences(row, before[row["id"]])
    )


def record_text(rows: Sequence[Row]) -> str:
    """The text of record.json: the values of every row.

    Raises
    ------
    ConvergenceError
        If a row does not hold.
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
    """A number, or every number of a list, rounded to so many significant digits."""
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
    """Whether two values are equal; floats may differ by one unit of the last recorded digit, those
    below 1 by that of a number between 1 and 10.
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


#: Growth of the equilibria at 30° with the slope that the friction law has at V and d: μ₀, which
#: state, what (27) says of it, the largest real part of its eigenvalues.
PARADOX = (
    (0.5, "before the jump", "stable", -4.4e-6),
    (0.5, "after the jump", "stable", 4.9e-6),
    (0.8, "after the jump", "stable", 1.2e-5),
)


def page() -> str:
    """The referee's report in Markdown: reproduction.md, filled in (extra ``plot``)."""
    rows = printed()["rows"]
    claims = recorded()
    forms = shipped_text("spragsym.generated", "LEDGER.md")

    def both_forms(id: str) -> str:
        """The printed form of an equation above the derived one, as LEDGER.md shows them."""
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
