"""The referee's page, docs/reproduction.md, made from the committed records alone: every machine writes the same page."""

from __future__ import annotations

import json
import textwrap
from collections import Counter
from importlib import resources
from typing import Any

from ..assumed import D, V
from .ledger import recorded

#: Inputs that the article leaves open and we had to choose.
ASSUMPTIONS = (
    f"Belt speed V = {V} and steepness d = {D:g} of the friction law (10), for Figures 3 and 7. The article states neither; "
    "the figure `sensitivity` shows a decade of each.",
    "The motion of Figure 7 starts at rest. The article states x = y = 0 and no speed.",
    "The root mean square of Figure 7b is of x about zero, over 1500 < τ < 2000. The article states neither.",
    "Friction at steady sliding is μ₀, as in (12) and (14). By (10) it is μ₀ (1 − exp(−d V)), 0.7 % less for our V and d; "
    "`sliding_friction` gives it, and motions rest where it says.",
    "Stability is that of (27), without the damping that (10) brings: see Ziegler's paradox below.",
    "0 ≤ μ₀ ≤ 1 in Figures 11 to 14, and all ranges of axes. The article states none in its text.",
    "Figures 4 to 7 and 11 to 13 have the base values of Section 3 (μ₀ = 0.5, κ = α = 0.007, σ = 0.1, β = 0) wherever "
    "text and caption name no other.",
    "A contact that is lost is regained without impact: (7) and (11) as they stand.",
)

#: Statements that can be checked by reading only.
READ = (
    'Section 1, "Qin et al. [19]": in the list of references [19] is by Xu et al., and [18] and [20] are by Qin et al.',
    "Equations (18) and (19) write μ where (14) and Appendix A write μ_o; the ledger takes them for the same.",
)

_COMMANDS = (
    ("make derive", "derive, check every equation, write generated/"),
    ("spragsym check --again", "hold every printed equation against the derivation"),
    ("make check-claims", "compute every claim and hold it against the record"),
    ("make figures", "draw all figures into figures/"),
    ("spragsym check --report docs/reproduction.md", "write this page"),
    ("python -m spragsym.article", "write the record of the claims anew"),
    ("python -m spragsym.article measure", "measure time and memory anew"),
)

#: Growth of the states at 30°, for the friction's own slope at V and d: μ₀, what (27) says, largest real part of λ.
PARADOX = (
    (0.5, "before the jump", "stable", -4.4e-6),
    (0.5, "after the jump", "stable", 4.9e-6),
    (0.8, "after the jump", "stable", 1.2e-5),
)


def page() -> str:
    """The page, in Markdown."""
    ledger, claims, measured = _read("spragsym.generated", "ledger.json"), recorded(), _read(__package__, "measured.json")
    parts = [
        _head(ledger, claims), _claims_table(claims), _misprints(ledger["rows"]), _read_only(), _assumptions(), _paradox(),
        _rerun(), _measured(measured), _claims_in_full(claims), _equations(ledger["rows"]),
    ]  # fmt: skip
    return "\n".join(line for part in parts for line in [*part, ""]).rstrip() + "\n"


def _paradox() -> list[str]:
    """What damping by the friction law's own slope does to states that (27) calls stable."""
    lines = [
        "## Ziegler's paradox", "",
        f"Beside (27) the law (10) brings a damper, C₁₁ = n μ₀ d exp(−d V), here for V = {V} and d = {D:g}. It damps the motion "
        "along the belt alone. Where friction couples both directions that makes states grow which only oscillate without any "
        "damping: the article's own state after the jump is stable by (27) and unstable, very slowly, by (8). Figures and claims "
        "here hold to (27).",
        "", "| μ₀ | state at 30° | by (27) | largest real part of λ | command |", "|---|---|---|---|---|",
    ]  # fmt: skip
    lines += [
        f"| {mu0} | {state} | {word} | {growth:+.1e} | `spragsym equilibria --theta0 30 --mu0 {mu0}` |"
        for mu0, state, word, growth in PARADOX
    ]
    return lines


def _read(package: str | None, name: str) -> Any:
    assert package is not None
    return json.loads(resources.files(package).joinpath(name).read_text(encoding="utf-8"))


def _paragraph(text: str) -> list[str]:
    return [" ".join(textwrap.dedent(text).split())]


def _counts(rows: list[dict[str, Any]]) -> str:
    return ", ".join(f"{count} {status}" for status, count in sorted(Counter(row["status"] for row in rows).items()))


def _verdict(rows: list[dict[str, Any]], claims: list[dict[str, Any]]) -> str:
    """The outcome in one sentence, counted."""
    printed, stated = Counter(row["status"] for row in rows), Counter(row["status"] for row in claims)
    return (
        f"**The article's results can be reproduced: of its {len(rows)} equations, coefficients and definitions "
        f"{printed['confirmed'] + printed['definition']} stand as printed, {printed['approximation']} hold in a limit and "
        f"{printed['misprint']} are misprinted; of its {len(claims)} statements that can be computed "
        f"{stated['reproduced']} hold as stated, {stated['input not stated']} hold for inputs of ours that it does not give, "
        f"{stated['misprint']} name a wrong equation or figure, {stated['corrected']} are wrong in substance, and "
        f"{stated['not reproduced']} could not be reproduced.**"
    )


def _head(ledger: Any, claims: list[dict[str, Any]]) -> list[str]:
    return [
        "# Reproduction",
        "",
        _verdict(ledger["rows"], claims),
        "",
        *_paragraph("""Generated by `spragsym check --report docs/reproduction.md` from generated/ledger.json and
        spragsym/article/record.json. Do not edit."""),
        "",
        *_paragraph("""What follows holds J. Kang and J. Nam, *Minimal Model for Sprag-Slip Oscillation as Catastrophe-Type
        Behavior*, Applied Sciences 10 (2020) 2748, against a derivation from energies and forces, and against computation.
        **No picture of the article was at hand**: figures and statements are reproduced from its text and its equations. So
        nothing here says that a curve is the same as a printed one."""),
        "",
        f"- Equations, coefficients and definitions: {_counts(ledger['rows'])}.",
        f"- Statements of the text that can be computed: {_counts(claims)}.",
        *_paragraph("""- For design the news is in the rows [fig-7-oscillation](#fig-7-oscillation) and
        [fig-7b-fate](#fig-7b-fate): the oscillation coexists with stable sliding, far below the catastrophe, and the jump of
        Figure 7b is not the catastrophe."""),
        "",
        *_paragraph("""*Reproduced*: it holds as stated, within the tolerance given. *Misprint*: a sign, a
        letter or the number of an equation or figure is wrong in print, and the rest of the article shows what is meant.
        *Corrected*: wrong in substance; what is right is another number, or holds for fewer cases, and is given.
        *Input not stated*: it holds for values of ours, and the article does not say for which of its own. Every outcome
        is recomputed in continuous integration, which fails when a status, or a number beyond the digits given, is not as
        recorded."""),
    ]


def _claims_table(claims: list[dict[str, Any]]) -> list[str]:
    return [
        "## Claims",
        "",
        "| row | where | stated | status |",
        "|---|---|---|---|",
        *(f"| [{row['id']}](#{_anchor(row['id'])}) | {row['where']} | {row['stated']} | {row['status']} |" for row in claims),
    ]


def _anchor(id: str) -> str:
    return id.lower().replace(".", "")


def _misprints(rows: list[dict[str, str]]) -> list[str]:
    page = resources.files("spragsym.generated").joinpath("LEDGER.md").read_text(encoding="utf-8")
    lines = ["## Misprints and approximations", ""]
    for row in rows:
        if row["status"] == "misprint":
            lines += [f"### {row['where']} ({row['id']})", "", *_side_by_side(row["id"], page), ""]
            lines += [f"Cause: {row['cause']}. Consequence: {row['consequence']}.", ""]
        elif row["status"] == "approximation":
            lines += [f"### {row['where']} ({row['id']}): an approximation", "", *_side_by_side(row["id"], page), ""]
            lines += [f"It is what the derivation gives in the limit {row['limit']}.", ""]
    return lines[:-1]


def _side_by_side(id: str, page: str) -> list[str]:
    """What is printed above what is derived, as the ledger's page shows the row."""
    section = page.partition(f"\n### {id}\n")[2]
    return [*section[section.index("```math") :].partition("\n```\n")[0].splitlines(), "```"]


def _read_only() -> list[str]:
    return ["## Seen by reading, not computed", "", *(f"- {text}" for text in READ)]


def _assumptions() -> list[str]:
    return ["## Assumptions of ours", "", *(f"- {text}" for text in ASSUMPTIONS)]


def _rerun() -> list[str]:
    return [
        "## How to run it again",
        "",
        "`make` sets up a virtual environment by itself; with `pip install '.[all]'` the commands work as they are.",
        "",
        "| command | does |",
        "|---|---|",
        *(f"| `{command}` | {meaning} |" for command, meaning in _COMMANDS),
    ]


def _measured(measured: dict[str, Any]) -> list[str]:
    return [
        "## Time and memory",
        "",
        f"As committed in spragsym/article/measured.json; {measured['machine']}. Other work shared the machine: CPU time counts.",
        "",
        "| command | wall clock, s | CPU, s | largest process, MB |",
        "|---|---|---|---|",
        *(f"| `{row['command']}` | {row['wall']:.0f} | {row['cpu']:.0f} | {row['megabytes']:.0f} |" for row in measured["rows"]),
    ]


def _claims_in_full(claims: list[dict[str, Any]]) -> list[str]:
    lines = ["## Claims in full", ""]
    for row in claims:
        lines += [f"### {row['id']}", "", f"{row['where']}: {row['stated']}.", "", f"**{row['status']}**: {row['outcome']}.", ""]
        lines += [f"Consequence: {row['consequence']}.", ""] if row["consequence"] else []
        lines += [f"- {name}: {_shown(value)}" for name, value in row["values"].items()]
        lines += [f"- digits of these numbers: {row['digits']}; tolerance: {row['tolerance']}"]
        lines += [f"- shown by `{row['command']}`, guarded by `{row['test']}`", ""]
    return lines[:-1]


def _shown(value: Any) -> str:
    return ", ".join(map(_shown, value)) if isinstance(value, list) else str(value)


def _remark(row: dict[str, str]) -> str:
    return next((row[name] for name in ("cause", "limit", "note") if name in row), "")


def _equations(rows: list[dict[str, str]]) -> list[str]:
    return [
        "## Equations",
        "",
        "In full, with both forms and their difference, in [generated/LEDGER.md](../generated/LEDGER.md).",
        "",
        "| row | where | status | remark |",
        "|---|---|---|---|",
        *(f"| {row['id']} | {row['where']} | {row['status']} | {_remark(row)} |" for row in rows),
    ]
