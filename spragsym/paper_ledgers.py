"""Ledgers of a paper: verdicts on its equations as one page of HTML, and in LaTeX for a letter."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from typing import TYPE_CHECKING

from .core.shown import html_text, visible

if TYPE_CHECKING:
    from .derive.statements.verdicts import Row
    from .papers import PaperCheck

#: Verdicts in the order of a ledger, wrong ones first, with the class of their colour.
_KINDS = {
    "misprint": "bad",
    "failed": "bad",
    "convention": "warn",
    "approximation": "good",
    "confirmed": "good",
    "premise": "quiet",
    "definition": "quiet",
    "unread": "warn",
    "other": "quiet",
}
#: Commands of LaTeX in small letters that set mathematics, and neither read, write nor define.
_NAMES = """
alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa varkappa lambda mu
nu xi pi varpi rho varrho sigma varsigma tau upsilon phi varphi chi psi omega ell hbar imath
jmath re im infty partial nabla prime circ star ast bullet degree
frac dfrac tfrac cfrac sqrt binom left right middle big bigl bigr bigg biggl biggr langle rangle
lvert rvert vert lfloor rfloor lceil rceil lbrace rbrace lbrack rbrack mid
dot ddot dddot ddddot hat widehat bar tilde widetilde vec overline underline overbrace
underbrace overset underset stackrel check acute breve
mathbf mathrm mathit mathcal mathbb mathsf mathtt mathfrak mathscr boldsymbol bm rm bf it text
textrm textbf textit textsf mbox operatorname displaystyle textstyle scriptstyle
sin cos tan cot sec csc arcsin arccos arctan sinh cosh tanh coth exp ln log lg max min sup inf
lim limsup liminf det arg sgn sign dim ker gcd
cdot times div pm mp le leq leqslant ge geq geqslant ne neq approx equiv sim simeq cong propto
ll gg lt gt to rightarrow leftarrow leftrightarrow longrightarrow mapsto implies iff
in notin subset cup cap forall exists neg land lor wedge vee otimes oplus perp parallel
sum prod int iint iiint oint limits nolimits ldots cdots vdots ddots dots colon
quad qquad phantom begin end hline nonumber notag substack top intercal dagger
"""
_OF_MATHEMATICS = frozenset(_NAMES.split())
_STYLE = """
:root{--text:#1a1a1a;--page:#fff;--quiet:#595959;--line:#ccc;--good:#0072b2;--bad:#c04a00;
--warn:#8a6100;--mark:#fde3cf;--code:#f4f4f4}
@media screen and (prefers-color-scheme:dark){:root{--text:#e6e6e6;--page:#16181b;--quiet:#a8adb3;
--line:#444;--good:#6cb8e8;--bad:#ff9d5c;--warn:#e6b84c;--mark:#5a2f10;--code:#22262a}}
*{box-sizing:border-box}
body{font:16px/1.5 system-ui,sans-serif;color:var(--text);background:var(--page);max-width:58rem;
margin:2rem auto;padding:0 1rem}
h1{font-size:1.5rem;margin-bottom:.3rem}
.verdict{font-size:1.1rem;padding:.8rem 1rem;border-left:6px solid var(--good)}
.verdict.bad{border-color:var(--bad);color:inherit}.verdict.bad strong{color:var(--bad)}
.filters{display:flex;flex-wrap:wrap;gap:.3rem 1.2rem;padding:.6rem 0;margin:1rem 0;
border-block:1px solid var(--line)}
.filters label{display:inline-flex;gap:.4rem;align-items:center;min-height:1.5rem}
article{border-bottom:1px solid var(--line);padding:.8rem 0}
h2{font-size:1rem;margin:0;display:flex;flex-wrap:wrap;gap:.2rem .8rem;align-items:baseline}
h2 .where,dt{color:var(--quiet);font-weight:400}
.status{font-weight:700}.good{color:var(--good)}.bad{color:var(--bad)}.warn{color:var(--warn)}
.quiet{color:var(--quiet)}
.print{overflow-x:auto;padding:.5rem 0}.print math{font-size:1.15rem}
.edit,mark{background:var(--mark);color:inherit;border-radius:3px}
dl{display:grid;grid-template-columns:9rem minmax(0,1fr);gap:.2rem 1rem;margin:.4rem 0 0}
dd{margin:0;overflow-x:auto;overflow-wrap:anywhere}
dd math{display:inline math;math-style:normal;font-size:1.1rem}
code{font:.85rem/1.4 ui-monospace,monospace;background:var(--code);padding:.1rem .3rem;
overflow-wrap:anywhere}
.print code{white-space:pre-wrap}
summary{cursor:pointer;color:var(--quiet);padding:.2rem 0}
@media (max-width:40rem){dl{grid-template-columns:1fr}dt{margin-top:.3rem}}
@page{size:A4;margin:15mm}
@media print{html{font-size:10pt}body{margin:0;padding:0;max-width:none;font-size:1rem}
.filters{display:none}article{break-inside:avoid}
details::details-content{content-visibility:visible}
.print,dd{overflow:visible}}
""".strip()


def fields(row: Row) -> Mapping[str, str]:
    """Fields of a row, under titles."""
    # Fields of a row under titles, as a referee reads them.
    titles = {
        "print": "Printed",
        "read": "Read as",
        "derived": "Derived",
        "derived_by": "Derived by",
        "difference": "Printed less derived",
        "marked": "Edited at",
        "repaired": "Right",
        "evidence": "Evidence",
        "units": "Units",
        "cost": "Size",
        "note": "Note",
    }
    said = {title: str(getattr(row, name)) for name, title in titles.items()}
    if row.edits:
        edits = (f"{it['kind']}: {it['old']} becomes {it['new']}" for it in row.edits)
        said["Edit"] = "; ".join(edits)
        said["Repairs of this size"] = str(row.alternatives)
    if row.said_once_with:
        said["The same edit in"] = ", ".join(row.said_once_with)
    return {title: text for title, text in said.items() if text}


def as_page(found: PaperCheck) -> str:
    """One page of HTML, which loads nothing and runs nothing."""
    counts = Counter(found.status)
    title = html_text(found.paper or "Printed equations")
    shown = [it for it in _KINDS if counts[it]]
    hidden = "".join(f"body:has(#f-{it}:not(:checked)) .is-{it}{{display:none}}" for it in shown)
    wrong = sum(counts[it] for it, kind in _KINDS.items() if kind == "bad")
    first = "No equation was found wrong." if not wrong else f"{wrong} of {len(found.rows)} wrong."
    parts = [
        '<!doctype html><html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width,initial-scale=1">',
        '<meta name="color-scheme" content="light dark">',
        f"<title>{title}</title><style>{_STYLE}@media screen{{{hidden}}}</style></head><body>",
        f"<h1>{title}</h1>",
        f'<p class="verdict{" bad" * bool(wrong)}"><strong>{first}</strong> '
        f"{html_text(found.held_against)}</p>",
        f"<p>{html_text(found.judged)}</p>",
        *(f"<p>{html_text(it)}</p>" for it in found.conventions),
        '<div class="filters">',
        *(
            f'<label><input type="checkbox" id="f-{it}" checked>'
            f'<span class="{_KINDS[it]}">{it}</span> {counts[it]}</label>'
            for it in shown
        ),
        "</div><main>",
        *(_row(row, found.coordinates) for row in found.rows),
        "</main></body></html>",
    ]
    return "\n".join([*parts, ""])


def _row(row: Row, coordinates: tuple[str, ...]) -> str:
    """One statement: its verdict, the equation as printed, what is right, and the evidence."""
    from .derive.statements import mathml

    def typeset(latex: str) -> str | None:
        return _seen(mathml.typeset(latex))

    def rendered(text: str, names: tuple[str, ...]) -> str | None:
        return _seen(mathml.rendered(text, names))

    said = dict(fields(row))
    marked = said.pop("Edited at", "")
    source, right = said.pop("Printed", ""), said.pop("Right", "")
    is_latex = row.about != "code" and ("\\" in source or not said.get("Read as"))
    print_ = typeset(marked or source) or typeset(source) if is_latex else None
    if row.about == "code":
        said |= {"Edited at": marked} if marked else {}
        print_ = f"<code>{'<br>'.join(map(html_text, source.splitlines()))}</code>"
    print_ = print_ or rendered(source, coordinates) or _marked(marked or source)
    parts = [
        f'<article class="is-{row.status}"><h2><span>{html_text(row.id)}</span>'
        f'<span class="status {_KINDS[row.status]}">{row.status}</span>'
        f'<span class="where">{html_text(row.about)}</span>'
        f'<span class="where">{html_text(row.where)}</span></h2>',
        f'<div class="print">{print_}</div>' if source else "",
        "<dl>",
    ]
    if right:
        shown = (row.repaired_latex and typeset(row.repaired_latex)) or rendered(right, coordinates)
        parts.append(f"<dt>Right</dt><dd>{shown or _marked(right)}</dd>")
    for title in ("Evidence", "Units", "Size", "Note"):
        if text := said.pop(title, ""):
            parts.append(f"<dt>{title}</dt><dd>{html_text(text)}</dd>")
    parts.append("</dl>")
    if said:
        is_formula = ("Read as", "Derived", "Printed less derived")
        more = (
            f"<dt>{title}</dt><dd>"
            f"{(title in is_formula and rendered(text, coordinates)) or _marked(text)}</dd>"
            for title, text in said.items()
        )
        parts.append(f"<details><summary>In full</summary><dl>{''.join(more)}</dl></details>")
    return "".join([*parts, "</article>"])


def _seen(formula: str | None) -> str | None:
    """MathML in which no character hides or commands."""
    return None if formula is None else visible(formula)


def _marked(text: str) -> str:
    """A formula as it is spelled, with what stands between guillemets marked."""
    return f"<code>{html_text(text).replace('«', '<mark>').replace('»', '</mark>')}</code>"


def as_latex(found: PaperCheck) -> str:
    """What is wrong or not judged, as a section that a letter in LaTeX can include."""
    lines = [rf"\section*{{{_words(found.paper or 'Printed equations')}}}", ""]
    lines += [_words(found.held_against), _words(found.judged), ""]
    wrong = [row for row in found.rows if _KINDS[row.status] in ("bad", "warn")]
    if wrong:
        lines += [r"\begin{description}"]
        for row in wrong:
            where = f", {_words(row.where)}" if row.where else ""
            lines += [rf"\item[{_words(row.id)}{where}: {row.status}.]"]
            lines += _displayed("Printed:", row, row.print)
            lines += _displayed("Right:", row, row.repaired_latex or row.repaired)
            lines += [_words(row.evidence)] if row.evidence else []
        lines += [r"\end{description}"]
    return "\n".join([*lines, ""])


def _displayed(title: str, row: Row, text: str) -> list[str]:
    """An equation of a row in LaTeX; one that is none is shown letter by letter."""
    if not text:
        return []
    is_print = text == row.print and row.about != "code"
    is_latex = (is_print or text == row.repaired_latex) and "\\" in text
    plain = visible(text)
    if not is_latex or not _is_closed(plain):
        return [rf"{title} \texttt{{{_words(plain)}}}"]
    inside = rf"\begin{{aligned}}{plain}\end{{aligned}}" if "&" in plain else plain
    return [title, rf"\[{inside}\]"]


def _is_closed(latex: str) -> bool:
    """Whether braces close where they open, and nothing leaves mathematics."""
    depth = 0
    for part in latex.replace("\\{", "").replace("\\}", ""):
        depth += (part == "{") - (part == "}")
        if depth < 0 or part in "$%#":
            return False
    opened, closed = latex.count(r"\begin{"), latex.count(r"\end{")
    commands = {it.lower() for it in re.findall(r"\\([A-Za-z]+)", latex)}
    others = re.search(r"\^\^|\\[^A-Za-z,;:!>{}|\\ .&_]", latex)  # ^^5c is a backslash
    return depth == 0 and opened == closed and commands <= _OF_MATHEMATICS and not others


def _words(text: str) -> str:
    """Text in LaTeX that is no command."""
    signs: Mapping[str, str] = {
        "\\": r"\textbackslash{}",
        "~": r"\textasciitilde{}",
        "^": r"\textasciicircum{}",
        **{it: rf"\{it}" for it in "&%$#_{}"},
    }
    return "".join(signs.get(it, it) for it in visible(text))
