"""``spragsym check`` and ``figures``: how the article, or another paper, compares with derivation
and computation; and the article's figures.
"""

import difflib
import inspect
import itertools
import re
import sys
from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import asdict
from pathlib import Path
from typing import Any

import click

from ..article.drawn import DRAWN
from ..core.errors import ParameterError, one_of
from ..core.progress import advance, show_progress
from ..core.shown import visible
from ..core.type_variables import T
from ..display import aligned
from ..models.load import load, page_of
from . import options as o
from .output import is_typed, print_json, refuse, wrapped, write


@o.command()
@click.argument(
    "paper", required=False, type=click.Path(exists=True, dir_okay=False, path_type=Path)
)
@o.as_json
@click.option("--claims", is_flag=True, help="The statements of the text instead of the equations.")
@click.option(
    "--row",
    "only",
    multiple=True,
    metavar="ROW",
    help="Only this row, or rows that begin so: eq-9, fig-7. Repeatable.",
)
@click.option(
    "--again",
    is_flag=True,
    help="Derive or compute the rows anew, and compare them with what is committed.",
)
@o.file("--report", help="Write the report on both, from what is committed.")
@click.option(
    "--model",
    "model_name",
    metavar="NAME|DIR|PAGE",
    help=f"{o.TEXT} What holds of the article for it; the page of PAPER.",
)
@click.option("--draft", is_flag=True, help="Draft a file of statements from PAPER, its source.")
@o.file(
    "--out", folder=True, help="Folder for the ledger of PAPER (.md, .tex, .html); file of a draft."
)
@click.option(
    "--row-limit",
    type=click.FloatRange(0.0, min_open=True),
    default=10.0,
    show_default=True,
    metavar="SECONDS",
    help="Processor time that a row of PAPER may take; beyond that it is unread.",
)
@o.trust
@o.force
def check(
    paper: Path | None,
    claims: bool,
    only: tuple[str, ...],
    again: bool,
    report: Path | None,
    model_name: str | None,
    draft: bool,
    out: Path | None,
    row_limit: float,
) -> None:
    """Show how every printed equation of the article, or of PAPER, compares with the derivation.

    With --claims every statement of the article's text compares with computation. PAPER is a file
    of statements (TOML), held against its page: each is confirmed, or the misprint is found. A page
    is a program: one that PAPER names runs with --trust, one that you name with --model.

    With --draft PAPER is a source, in TeX, Markdown, doconce or a notebook: each displayed equation
    becomes a statement, with a guess of what it is about.

    Rows come from the committed ledger at once; with --again each is derived or computed anew, and
    compared with it.

    \b
    Examples:
      spragsym check
      spragsym check --row eq-9
      spragsym check --again
      spragsym check --claims --row fig-7
      spragsym check --json | jq '.[] | select(.status == "misprint")'
      spragsym check --report docs/reproduction.md
      spragsym check --model cubic_contact --row eq-11
      spragsym check --draft paper.tex --out paper.toml
      spragsym check paper.toml --model page.py --out ledger

    \b
    Exit codes: 0 every row is as recorded or expected; 1 a row is not; 2 usage; 3 a row of PAPER
    could not be read, and all others are as expected.
    """
    if draft:
        if paper is None or claims or again or only or report or model_name:
            raise click.UsageError(
                "--draft is of the source of a paper alone; give its file, and --out"
            )
        _draft(paper, out)
        return
    if paper is not None:
        if claims or again or report is not None:
            raise click.UsageError("a paper is checked without --claims, --again and --report")
        _check_paper(paper, model_name, only, out, row_limit)
        return
    if out is not None:
        raise click.UsageError(
            "--out is about a paper; name its file, as spragsym check paper.toml"
        )
    if again and (model_name is not None or report is not None):
        raise click.UsageError(
            "--again is about rows of the article; leave it or "
            f"{'--report' if report else '--model'} out"
        )
    if model_name is not None and (claims or report is not None):
        raise click.UsageError(
            f"{'--claims' if claims else '--report'} is about the article's own model; leave "
            "--model out"
        )
    if model_name is not None:
        _check_model(model_name, only)
    elif report is not None:
        from ..article.ledger import page

        wrote = write({report: page()})
        click.echo(f"wrote {report}" if wrote else f"{report} is as it should be", err=True)
    else:
        rows, wrong = (_claims if claims else _equations)(only, again)
        if o.is_json():
            print_json(rows)
        elif only and not claims:
            for row in rows:
                _print_in_full(row["id"], row["status"], _fields(row))
        else:
            _print_table(rows)
        for line in wrong:
            click.echo(f"spragsym check: {line}", err=True)
        if not again:
            click.echo(
                f"as committed; --again {'computes' if claims else 'derives'} every row anew",
                err=True,
            )
        if wrong:
            sys.exit(1)


#: Rows of a ledger, and the differences from the committed ones as text.
_Rows = tuple[list[dict[str, Any]], list[str]]


def _chosen(only: tuple[str, ...], rows: Mapping[str, T], what: str) -> list[T]:
    """The rows that are asked for, in the order of the ledger; all if none is asked for.

    A row is asked for by its name, the beginning of its name, or its place in the print.
    """
    chosen = set() if only else set(rows)
    for name in only:
        found = (
            {name} & set(rows)
            or {row for row in rows if row.startswith(name)}
            or _standing_at(name, rows)
        )
        if not found:
            near = ", ".join(difflib.get_close_matches(name, rows, n=3, cutoff=0.3)) or "none"
            raise ParameterError(
                f"--row {name}: no row of {what} has this name, begins with it or stands there; "
                f"names like it: {near}"
            )
        chosen |= found
    return [row for name, row in rows.items() if name in chosen]


def _standing_at(typed: str, rows: Mapping[str, Any]) -> set[str]:
    """The rows at a place in the print, as ``9``, ``(9)``, ``eq9`` or ``Figure 7``; without those
    of the text about it, whose places are longer.
    """
    number = re.sub(r"^eq[a-z]*[\s.-]*|[()]", "", typed.lower())
    places = {
        name: str(row["where"] if isinstance(row, Mapping) else row.where or "").lower()
        for name, row in rows.items()
    }
    found = {
        name: where
        for name, where in places.items()
        if f"({number})" in where or (" " in typed and typed.lower() in where)
    }
    shortest = min(map(len, found.values()), default=0)
    return {name for name, where in found.items() if len(where) == shortest}


def _claims(only: tuple[str, ...], again: bool) -> _Rows:
    """The statements of the article's text, as committed or computed again."""
    from ..article import STATEMENTS, drifted, recorded, run

    statements = _chosen(only, {statement.id: statement for statement in STATEMENTS}, "the claims")
    if not again:
        return recorded(statements), []
    with show_progress("computing what the article states"):
        anew = run(statements)
    return anew, drifted(anew, recorded(statements))


def _equations(only: tuple[str, ...], again: bool) -> _Rows:
    """The printed equations of the article, as committed or derived again."""
    from ..article.ledger import printed

    before = {row["id"]: row for row in printed()["rows"]}
    rows = _chosen(only, before, "the equations (statements of the text: --claims)")
    if not again:
        return rows, []
    from ..derive.kang_nam import ledger as derivation

    with show_progress("deriving the equations of the article"):
        all_rows = derivation.run()
    chosen, now = {row["id"] for row in rows}, {row.id: row.recorded() for row in all_rows}
    wrong = [
        f"{row.id} ({row.where}): {row.note}"
        for row in derivation.failures(all_rows)
        if row.id in chosen
    ]
    changed = [
        id
        for id in sorted(before.keys() | now.keys())
        if before.get(id) != now.get(id) and (not only or id in chosen)
    ]
    wrong += [f"{id} is not as recorded in generated/ledger.json" for id in changed]
    return [row for id, row in now.items() if id in chosen], wrong


def _draft(source: Path, out: Path | None) -> None:
    """Write the draft of a file of statements, or print it."""
    from ..drafts import draft

    refuse([out])
    with show_progress("reading the source"):
        found = draft(source)
    if o.is_json():
        print_json(asdict(found))
    elif out is None:
        click.echo(found.text, nl=False)
    else:
        write({out: found.text})
    click.echo(
        f"{found.equations} displayed equations: {found.unread} unread, {found.judged} with a "
        "guess of what they are about",
        err=True,
    )


def _check_paper(
    paper: Path, model: str | None, only: tuple[str, ...], out: Path | None, row_limit: float
) -> None:
    """Print the verdicts on the statements of a file."""
    from ..paper_ledgers import fields
    from ..papers import check as check_statements

    with show_progress("deriving what the paper is held against"):
        found = check_statements(paper, model, trust=is_typed("trust"), row_limit=row_limit)
    rows = _chosen(only, {row.id: row for row in found.rows}, "the paper")
    if out is not None:
        files = {
            out / "LEDGER.md": found.to_markdown(),
            out / "LEDGER.tex": found.to_latex(),
            out / "ledger.html": found.to_html(),
        }
        write(files, made=True)
    if o.is_json():
        chosen = {row.id for row in rows}
        whole = found.as_dict()
        print_json({**whole, "rows": [row for row in whole["rows"] if row["id"] in chosen]})
    elif only:
        for row in rows:
            _print_in_full(row.id, row.status, fields(row))
    else:
        table = [(it.id, it.where or it.about, it.status, it.repaired or it.note) for it in rows]
        _print_rows("right", table)
        for convention in found.conventions:
            click.echo(visible(convention), err=True)
        if not found.model:
            click.echo(visible(found.held_against), err=True)
        click.echo(f"{len(rows)} statements: {found.summary()}; {found.judged}", err=True)
    wrong = {row.status for row in rows if not row.is_expected}
    if wrong:
        sys.exit(3 if wrong == {"unread"} else 1)


def _check_model(name: str, only: tuple[str, ...]) -> None:
    """Print which rows of the article hold for a model, fail, or have no meaning."""
    from ..derive import pages
    from ..derive.kang_nam import ledger

    model = load(name)
    with show_progress(f"deriving the equations of {model.name}"):
        all_rows = ledger.judge(pages.read(page_of(model, pages.SHIPPED), model.name))
    rows = _chosen(only, {row.id: row for row in all_rows}, "the equations")
    if o.is_json():
        print_json([asdict(row) for row in rows])
        return
    _print_rows("print less model", [(it.id, it.where, it.status, it.remark) for it in rows])
    hold, fail, none = map([row.status for row in rows].count, ledger.Transfer)
    click.echo(
        f"{model.name}: of {len(rows)} rows {hold} hold, {fail} fail, {none} have no meaning",
        err=True,
    )


def _print_rows(last: str, rows: Sequence[tuple[str, str, str, str]]) -> None:
    """Print rows with their status in colour; the last column is wrapped on a terminal."""
    colours = {
        **dict.fromkeys(("confirmed", "reproduced", "holds"), "green"),
        **dict.fromkeys(("failed", "not reproduced", "fails"), "red"),
        **dict.fromkeys(("approximation", "input not stated"), "cyan"),
        **dict.fromkeys(("misprint", "convention"), "yellow"),
        "corrected": "magenta",
    }
    table = [("row", "where", "status", last), *(tuple(map(visible, row)) for row in rows)]
    lines = aligned([row[:3] for row in table])
    begin = max(map(len, lines)) + 2
    for line, (*_, status, remark) in zip(lines, table, strict=True):
        colour, dim = colours.get(status), status in ("definition", "premise", "no meaning")
        bold = colour == "red" or not (colour or dim)
        styled = line.removesuffix(status) + click.style(
            status, fg=colour, bold=bold or None, dim=dim or None
        )
        click.echo(f"{styled}{' ' * (begin - len(line))}{wrapped(remark, begin)}".rstrip())


def _fields(row: Mapping[str, Any]) -> dict[str, str]:
    """The fields of a row of the article's equations, by their titles.

    A row without a derived form of its own is derived as printed.
    """
    whole = {"derived": row["printed"], **row} if row.get("derived_by") else row
    titles = {
        "where": "Where",
        "printed": "Printed",
        "derived": "Derived",
        "derivation": "As derived",
        "derived_by": "Derived by",
        "difference": "Printed less derived",
        "limit": "Limit",
        "cause": "Cause",
        "evidence": "Evidence",
        "consequence": "Consequence",
        "note": "Note",
    }
    return {title: str(whole[key]) for key, title in titles.items() if whole.get(key)}


def _print_in_full(row: str, status: str, said: Mapping[str, str]) -> None:
    """Print all fields of one row."""
    click.echo(visible(f"{row}: {status}"))
    for title, text in said.items():
        click.echo(wrapped(visible(f"  {title}: {text}"), 4))


def _print_table(rows: Sequence[Mapping[str, Any]]) -> None:
    """Print equations with a remark each, or statements of the text with their outcome."""
    remarks = ("outcome", "cause", "limit", "note")
    shown = [
        (
            row["id"],
            row["where"],
            row["status"],
            next((row[key] for key in remarks if row.get(key)), ""),
        )
        for row in rows
    ]
    _print_rows("remark", shown)
    for row in rows:
        if row.get("consequence"):
            right = f": right is {row['derived']}" if "derived" in row else ""
            click.echo(f"\n{wrapped(row['id'] + right)}\n  {wrapped(row['consequence'], 2)}")


def _words(allowed: Sequence[str], option: str) -> Callable[..., list[str]]:
    """A callback of click that splits an option into allowed words, at blanks or commas."""

    def known(_: click.Context, __: click.Parameter, given: str | tuple[str, ...]) -> list[str]:
        text = given if isinstance(given, str) else ",".join(given)
        found = dict.fromkeys(re.split(r"[\s,]+", text.strip(" ,")) if given else ())
        for name in found:
            one_of(option, name, allowed)
        return list(found)

    return known


@o.command()
@click.argument("names", nargs=-1, callback=_words(DRAWN, "NAMES"))
@o.folder("Folder to write to, made if missing.")
@click.option(
    "--format",
    "kinds",
    default="pdf",
    callback=_words(("pdf", "png", "svg"), "--format"),
    help="pdf, png, svg, or several with commas.",
)
@o.workers(-1)
@o.quiet
@o.force
def figures(
    names: list[str],
    out: Path,
    kinds: list[str],
    workers: int,
    quiet: bool,
) -> None:
    """Draw the article's Figures 3 to 14, and some that it lacks: all, or NAMES.

    Those are cusp-friction, false-double-root, rms-map and sensitivity. NAMES are separated by
    blanks or commas.

    Beside each figure go its caption (.txt) and the data of its panels (.csv). The same bytes every
    time.

    \b
    Examples:
      spragsym figures --out figures
      spragsym figures 4 12 --out figures --format pdf,png
      spragsym figures rms-map --out figures
    """
    import matplotlib

    matplotlib.use("Agg")  # files only; no display is needed
    from ..figures import FIGURES, write
    from ..motion.sweeps.workers import count, pool

    chosen = [FIGURES[name] for name in names or FIGURES]
    written = (
        [
            *(out / f"{draw.__name__}.{kind}" for kind in (*kinds, "txt")),
            *sorted(out.glob(f"{draw.__name__}_[a-z].csv")),
        ]
        for draw in chosen
    )
    refuse(itertools.chain(*written), made=True)
    size = count(workers)
    # One pool for all figures, since a process takes a second to start.
    with (
        nullcontext(1) if size == 1 else pool(size) as mapping,
        advance(not quiet, len(chosen), 0) as step,
    ):
        for draw in chosen:
            moving = {"workers": mapping} if "workers" in inspect.signature(draw).parameters else {}
            for path in write(draw(**moving), out, draw.__name__, kinds):
                click.echo(path)
            step()
