"""The outcome of the check, for machines (JSON) and for people (Markdown)."""

from collections import Counter
from dataclasses import asdict, dataclass
from typing import Any

import sympy as sp

from .check import Row
from .theorem import Step


#: Statuses of rows whose printed form is the derived one.
_AS_PRINTED = ("confirmed", "definition")


@dataclass(frozen=True)
class Ledger:
    """Rows of the check, the identities that the elimination rests on, and the steps of two
    theorems.
    """

    rows: tuple[Row, ...]
    identities: dict[str, bool]
    theorem: tuple[Step, ...]
    lowest_fold: tuple[Step, ...]


def as_dict(ledger: Ledger) -> dict[str, Any]:
    """For JSON."""
    return {
        "sympy": sp.__version__,
        "summary": summary(ledger.rows),
        "rows": [row.recorded() for row in ledger.rows],
        "identities": ledger.identities,
        "one_or_three": list(map(asdict, ledger.theorem)),
        "lowest_fold": list(map(asdict, ledger.lowest_fold)),
    }


def summary(rows: tuple[Row, ...]) -> dict[str, int]:
    """How many rows have each status."""
    return dict(sorted(Counter(row.status for row in rows).items()))


def markdown(ledger: Ledger, header: str) -> str:
    """A page that a referee can read."""
    lines = [
        "# Ledger: the article's equations against the derivation",
        "",
        header,
        "",
        "Every numbered equation, appendix coefficient and definition of J. Kang and J. Nam, "
        "*Minimal Model for Sprag-Slip "
        "Oscillation as Catastrophe-Type Behavior*, Applied Sciences 10 (2020) 2748, as "
        "printed, against what follows from "
        "energies and forces. Equality is decided by exact algebra modulo sin² + cos² = 1. "
        "What is derived stands in the "
        "arrangement of the print, so that the two can be compared by eye; ledger.json also "
        "has the form that the derivation itself "
        "arrives at, and leaves out a derived form that is the printed one.",
        "",
        "Shorthands: $B = \\beta + \\overline{n}$, $M = \\mu_o \\overline{n}$, $p = \\alpha + "
        "\\sigma$, $q = B + \\sigma$.",
        "",
        "Outcome: "
        + ", ".join(f"{count} {status}" for status, count in summary(ledger.rows).items())
        + ".",
        "",
        "| row | where | status | derived by |",
        "|---|---|---|---|",
        *(
            f"| [{row.id}](#{row.id.lower()}) | {row.where} | {row.status} | `{row.derived_by}` |"
            for row in ledger.rows
        ),
        "",
        "## Rows that differ from the print",
        "",
    ]
    for row in ledger.rows:
        if row.status not in _AS_PRINTED:
            lines += _section(row)
    lines += ["## Rows that stand as printed", "", "Printed and derived:", ""]
    for row in ledger.rows:
        if row.status in _AS_PRINTED:
            lines += _section(row)
    lines += [
        "## Identities",
        "",
        *(f"- {_mark(holds)} {claim}" for claim, holds in ledger.identities.items()),
        "",
    ]
    lines += [
        "## One or three",
        "",
        "For 0 < θ₀ < π, κ > 0, σ > 0, α, β ≥ 0 and every μ₀ ≥ 0 there are one or three "
        "steady-sliding equilibria, counted "
        "with multiplicity, and of three different ones the middle one is divergent. With s = "
        "sin θ and s* = s₀ − κ/σ, each "
        "step decided by exact algebra:",
        "",
        *(
            f"{number}. {_mark(step.holds)} {step.claim}"
            for number, step in enumerate(ledger.theorem, 1)
        ),
        "",
        "## The lowest fold",
        "",
        "For κ > 0, σ > 0 and α, β ≥ 0 the least friction at which, over 0 < θ₀ < π, the "
        "reference state ends is the least of: "
        "the cusps with 0 < θ₀ < π/2 and μ₀ ≥ 0; the points with 0 < θ₀ < π/2, μ₀ > 0 and f″ "
        "< 0 at which the curve of folds turns back, "
        "f = f′ = f_θ₀ = 0; the folds at θ₀ = 0 with μ₀ > 0 and f″ < 0. Where there is none "
        "of these it never ends:",
        "",
        *(
            f"{number}. {_mark(step.holds)} {step.claim}"
            for number, step in enumerate(ledger.lowest_fold, 1)
        ),
        "",
    ]
    return "\n".join(lines)


def side_by_side(printed: str, derived: str) -> list[str]:
    """Two forms, one above the other, as Markdown."""
    rows = [
        rf"&\text{{{name}:}} && {latex}"
        for name, latex in (("printed", printed), ("derived", derived))
    ]
    return ["```math", r"\begin{aligned}", rows[0] + r" \\", rows[1], r"\end{aligned}", "```"]


def _mark(holds: bool) -> str:
    return "proved:" if holds else "NOT PROVED:"


def _section(row: Row) -> list[str]:
    if row.status in _AS_PRINTED:
        lines = [f"### {row.id}", "", f"```math\n{row.printed}\n```", ""]
    else:
        lines = [
            f"### {row.id}",
            "",
            f"{row.where}: **{row.status}**.",
            "",
            *side_by_side(row.printed, row.derived),
            "",
        ]
        lines += ["Printed less derived:", "", f"```math\n{row.difference}\n```", ""]
    for title, text in (
        ("Note", row.note),
        ("Cause", row.cause),
        ("Second derivation", row.evidence),
        ("Consequence", row.consequence),
        ("Limit", row.limit),
    ):
        if text:
            lines += [f"{title}: {text}.", ""]
    return lines
