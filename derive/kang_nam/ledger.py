"""The ledger: how every printed statement of the article compares with the derivation, as JSON and
Markdown.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from enum import StrEnum
from pathlib import Path
from typing import Any

import mpmath
import sympy as sp

from .. import pages
from ..emit import targets
from ..statements import verdicts
from ..statements.papers import Paper
from ..statements.reading import Item, Verdict, read_paper, read_statement
from ..statements.tree import symbols, to_sympy
from . import article, explanations
from .free_body import DIGITS, ParameterPoint
from .theorem import Step


class Transfer(StrEnum):
    """What becomes of a statement of the article, with misprints repaired, for another page."""

    HOLDS = "holds"
    FAILS = "fails"
    NO_MEANING = "no meaning"


@dataclass(frozen=True)
class LedgerRow:
    """The outcome for one printed statement, in LaTeX and words; a field that does not apply is
    empty.

    ``derivation`` is the form in which the derivation gives it. ``derived`` is equal to that by
    exact algebra, and arranged as ``printed``, so that both can be compared by eye. A row is
    "failed" if the printed form is not equal to the derived one and no explanation holds; its
    ``derived`` is then ``derivation``. ``derived_by`` names the function of ``derive/``.
    """

    id: str
    where: str
    status: str
    derived_by: str
    printed: str
    derived: str
    derivation: str
    difference: str
    note: str = ""
    cause: str = ""
    evidence: str = ""
    consequence: str = ""
    limit: str = ""

    @property
    def is_as_printed(self) -> bool:
        """Whether the derived form is the printed one."""
        return self.status in ("confirmed", "definition")

    def recorded(self) -> dict[str, str]:
        """The row as data, without empty fields and without a derived form equal to the printed
        one.
        """
        return {
            name: text
            for name, text in asdict(self).items()
            if text and (name, text) != ("derived", self.printed)
        }


def run(paper: Paper | None = None) -> list[LedgerRow]:
    """Check every printed statement of the article, or of another paper, against its page."""
    paper = article.printed() if paper is None else paper
    model = pages.read(pages.SHIPPED / "kang_nam.py")
    _, statements = read_paper(paper, model)
    rows = verdicts.verdicts_on(paper, model, statements).rows
    pairs = zip(statements, rows, strict=True)
    return [_explained(row, _exact(item)) for item, row in pairs]


@dataclass(frozen=True)
class Judgement:
    """What becomes of one row for another page; the remark is the difference, or the reason."""

    id: str
    where: str
    status: str
    remark: str = ""


def judge(model: pages.PageModel) -> list[Judgement]:
    """Judge every row of the article for another page, in the article's order."""
    article_page = pages.read(pages.SHIPPED / "kang_nam.py")
    paper = verdicts.repaired(article.printed(), article_page)
    judgements = []
    transfer_of = dict.fromkeys(("confirmed", "definition", "approximation"), Transfer.HOLDS)
    transfer_of["failed"] = Transfer.FAILS
    for row in verdicts.check(paper, model, repair=False).rows:
        status = transfer_of.get(row.status, Transfer.NO_MEANING)
        remark = {
            Transfer.HOLDS: row.difference and row.evidence,
            Transfer.FAILS: row.difference,
        }
        judgements.append(Judgement(row.id, row.where, status, remark.get(status, row.evidence)))
    return judgements


def _exact(item: Item | Verdict) -> str:
    """LaTeX of the difference between an approximation and its exact form; empty if the exact form
    is not confirmed.
    """
    approximation = explanations.APPROXIMATIONS.get(item.statement.id)
    if approximation is None or isinstance(item, Verdict):
        return ""
    exact = read_statement(replace(item.statement, text=approximation.exact, limit=""), item.book)
    if isinstance(exact, Verdict) or verdicts.verdict_on(exact).status != "confirmed":
        return ""
    ours, theirs = item.equations[-1].left, exact.equations[-1].left
    names = {name: sp.Symbol(name) for name in symbols(ours) | symbols(theirs)}
    gap = to_sympy(ours, names) - to_sympy(theirs, names)
    return item.latex(sp.factor_terms(sp.expand(gap)))


def failures(rows: Sequence[LedgerRow]) -> list[LedgerRow]:
    """Rows that do not pass the check."""
    return [row for row in rows if row.status == "failed"]


def _explained(found: verdicts.Row, exact: str) -> LedgerRow:
    """The ledger's row of a verdict, with the explanation of a misprint or an approximation.

    It is failed if a difference has no explanation, an explanation no difference, or the second
    derivation disagrees.
    """
    row = LedgerRow(
        found.id,
        found.where,
        found.status,
        found.derived_by,
        found.print,
        found.derived_latex,
        found.derived_latex,
        found.difference_latex or "0",
        found.note,
    )
    misprint = explanations.MISPRINTS.get(row.id)
    approximation = explanations.APPROXIMATIONS.get(row.id)
    if row.is_as_printed:
        if misprint or approximation:
            return _failed(row, "explained as one that differs, but the difference is zero")
        return replace(row, derived=row.printed)
    if row.status == "approximation" and approximation is not None:
        if not exact:
            return _failed(
                row, "the exact form given for this approximation is not the derived one"
            )
        exact_form, limit = approximation.exact, approximation.limit
        return replace(row, derived=exact_form, difference=exact, limit=limit)
    if row.status != "misprint":
        return _failed(row, found.evidence)
    kinds = tuple(str(edit["kind"]) for edit in found.edits)
    if misprint is None or kinds != misprint.edits or found.alternatives != 1:
        said = f"{found.repaired} is right, and nothing explains the difference"
        return _failed(replace(row, derived=found.repaired_latex), said)
    with mpmath.workdps(DIGITS):
        holds, evidence = misprint.evidence()
        if not holds:
            return _failed(row, f"the second derivation disagrees: {evidence}")
        return replace(
            row,
            derived=found.repaired_latex,
            cause=misprint.cause,
            evidence=evidence,
            consequence=misprint.consequence(ParameterPoint()),
        )


def _failed(row: LedgerRow, note: str) -> LedgerRow:
    return replace(row, status="failed", note=note)


@dataclass(frozen=True)
class Ledger:
    """Rows of the check, identities of the elimination, and the steps of three theorems."""

    rows: tuple[LedgerRow, ...]
    identities: dict[str, bool]
    theorem: tuple[Step, ...]
    lowest_fold: tuple[Step, ...]
    routh: tuple[Step, ...]


def as_dict(ledger: Ledger) -> dict[str, Any]:
    """The ledger as data for JSON."""
    return {
        "sympy": sp.__version__,
        "summary": summary(ledger.rows),
        "rows": [row.recorded() for row in ledger.rows],
        "identities": ledger.identities,
        "one_or_three": list(map(asdict, ledger.theorem)),
        "lowest_fold": list(map(asdict, ledger.lowest_fold)),
        "routh": list(map(asdict, ledger.routh)),
    }


def summary(rows: tuple[LedgerRow, ...]) -> dict[str, int]:
    """The number of rows of each status."""
    return dict(sorted(Counter(row.status for row in rows).items()))


def markdown(ledger: Ledger, header: str) -> str:
    """The ledger as a page in Markdown."""
    sections: dict[bool, list[str]] = {True: [], False: []}
    for row in ledger.rows:
        sections[row.is_as_printed] += _section(row)
    counts = (f"{count} {status}" for status, count in summary(ledger.rows).items())
    table = (
        f"| [{row.id}](#{row.id.lower()}) | {row.where} | {row.status} | "
        f"{row.derived_by and f'`{row.derived_by}`'} |"
        for row in ledger.rows
    )
    claims = (f"- {_mark(holds)} {claim}" for claim, holds in ledger.identities.items())
    words = {
        "header": header,
        "outcome": ", ".join(counts),
        "table": "\n".join(table),
        "different": "\n\n".join(sections[False]),
        "as_printed": "\n\n".join(sections[True]),
        "identities": "\n".join(claims),
        "one_or_three": _numbered(ledger.theorem),
        "lowest_fold": _numbered(ledger.lowest_fold),
        "routh": _numbered(ledger.routh),
    }
    text = Path(__file__).with_name("ledger.txt").read_text(encoding="utf-8")
    return targets.spoken(text, words)


def _numbered(steps: Sequence[Step]) -> str:
    """Steps of a proof, one a line."""
    lines = (f"{n}. {_mark(step.holds)} {step.claim}" for n, step in enumerate(steps, 1))
    return "\n".join(lines)


def _mark(holds: bool) -> str:
    return "proved:" if holds else "NOT PROVED:"


def _section(row: LedgerRow) -> list[str]:
    """The section of a row; of one that differs, the printed form stands above the derived one."""
    lines = [f"### {row.id}"]
    math = "```math\n{}\n```"
    if row.is_as_printed:
        lines.append(math.format(row.printed))
    else:
        both = rf"&\text{{printed:}} && {row.printed} \\" + "\n"
        both += rf"&\text{{derived:}} && {row.derived}"
        lines.append(f"{row.where}: **{row.status}**.")
        lines.append(math.format(f"\\begin{{aligned}}\n{both}\n\\end{{aligned}}"))
        lines += ["Printed less derived:", math.format(row.difference)]
    notes = {
        "Note": row.note,
        "Cause": row.cause,
        "Second derivation": row.evidence,
        "Consequence": row.consequence,
        "Limit": row.limit,
    }
    return [*lines, *(f"{title}: {text}." for title, text in notes.items() if text)]
