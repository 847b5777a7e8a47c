"""The referee's page, docs/reproduction.md, made from the committed records alone: every machine writes the same page."""

import json
from collections import Counter
from collections.abc import Mapping

from ..assumed import D, V
from ..files.text import filled
from .ledger import package_text, recorded

#: Growth of the states at 30°, for the friction's own slope at V and d: μ₀, what (27) says, largest real part of λ.
PARADOX = (
    (0.5, "before the jump", "stable", -4.4e-6),
    (0.5, "after the jump", "stable", 4.9e-6),
    (0.8, "after the jump", "stable", 1.2e-5),
)


def page() -> str:
    """The page, in Markdown: reproduction.md, filled in (extra ``plot``)."""
    rows, claims = json.loads(package_text("ledger.json", "spragsym.generated"))["rows"], recorded()
    forms = package_text("LEDGER.md", "spragsym.generated")

    def both_forms(id: str) -> str:
        """What is printed above what is derived, as the ledger's page shows the row."""
        section = forms.partition(f"\n### {id}\n")[2]
        return section[section.index("```math") :].partition("\n```\n")[0] + "\n```"

    printed, stated = (Counter(row["status"] for row in those) for those in (rows, claims))
    return filled(
        "spragsym.article", "reproduction.md", "the report on the article", rows=rows, claims=claims, printed=printed,
        stated=stated, measured=json.loads(package_text("measured.json")), paradox=PARADOX, V=V, d=f"{D:g}",
        both_forms=both_forms, counts=_counts,
    )  # fmt: skip


def _counts(statuses: Mapping[str, int]) -> str:
    return ", ".join(f"{count} {status}" for status, count in sorted(statuses.items()))
