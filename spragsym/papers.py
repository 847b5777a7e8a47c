"""Printed equations of a paper, held against its model: verdicts, as a table, a ledger, a page of
HTML.
"""

from __future__ import annotations

import importlib.util
import os
import sys
import tempfile
from collections import Counter
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .core.errors import MissingExtraError, ParameterError, SweepError, require_kind
from .core.limits import limit_memory, limit_time
from .core.shown import markdown_code, markdown_text
from .display import Table, as_html
from .files.storage import resolved
from .files.text import text_of, toml_of
from .models.load import load, page_of, require_trust, shipped
from .models.parameters import POSITIVE, as_number
from .motion.sweeps.workers import pool
from .paper_ledgers import as_latex, as_page, fields

if TYPE_CHECKING:
    from .derive.pages import PageModel as Page
    from .derive.statements.papers import Paper
    from .derive.statements.verdicts import Checked, Row


@dataclass(frozen=True)
class PaperCheck:
    """Verdicts on the printed equations of a paper.

    Attributes
    ----------
    paper, model : str
        The paper's title, and the name of the page.
    conventions : tuple of str
        How coordinates of the print differ from those of the page.
    rows : tuple
        One for each statement, with the fields ``id``, ``about``, ``status`` and more.
    coordinates : tuple of str
        The page's coordinates, whose rates are shown with dots.
    """

    paper: str
    model: str
    conventions: tuple[str, ...]
    rows: tuple[Row, ...]
    coordinates: tuple[str, ...] = ()

    @property
    def status(self) -> tuple[str, ...]:
        """Verdicts on the statements."""
        return tuple(row.status for row in self.rows)

    @property
    def is_expected(self) -> bool:
        """True where every verdict is the expected one."""
        return all(row.is_expected for row in self.rows)

    def as_dict(self) -> dict[str, Any]:
        """Verdicts for JSON: of each row all fields, which are empty where they do not apply.

        Returns
        -------
        dict
            ``paper``, ``model``, ``conventions`` and ``rows``.

        Examples
        --------
        >>> PaperCheck("A paper", "kang_nam", (), ()).as_dict()
        {'paper': 'A paper', 'model': 'kang_nam', 'conventions': [], 'rows': []}
        """
        rows = [asdict(row) for row in self.rows]
        head = {"paper": self.paper, "model": self.model, "conventions": list(self.conventions)}
        return {**head, "rows": rows}

    def summary(self) -> str:
        """Number of statements with each verdict.

        Returns
        -------
        str

        Examples
        --------
        >>> from types import SimpleNamespace
        >>> rows = [SimpleNamespace(status=word) for word in ("confirmed", "misprint", "confirmed")]
        >>> PaperCheck("A paper", "kang_nam", (), tuple(rows)).summary()
        '2 confirmed, 1 misprint'
        """
        counts = Counter(self.status)
        return ", ".join(f"{counts[status]} {status}" for status in sorted(counts))

    def to_markdown(self) -> str:
        """A ledger that a referee can attach.

        Returns
        -------
        str

        Examples
        --------
        >>> PaperCheck("A paper", "kang_nam", (), ()).to_markdown().splitlines()[0]
        '# A paper'
        """
        lines = [f"# {markdown_text(self.paper or 'Printed equations')}", ""]
        lines += [markdown_text(self.held_against), "", markdown_text(self.judged), ""]
        lines += [f"- {markdown_text(convention)}" for convention in self.conventions]
        lines += ["", "| row | where | about | verdict |", "|---|---|---|---|"]
        cells = ((row.id, row.where, row.about, row.status) for row in self.rows)
        lines += [f"| {' | '.join(map(markdown_text, row))} |" for row in cells]
        for row in self.rows:
            lines += ["", f"## {markdown_text(row.id)}", ""]
            lines += [f"{markdown_text(row.about)}: **{row.status}**", ""]
            lines += [f"- {title}: {markdown_code(text)}" for title, text in fields(row).items()]
        return "\n".join(lines) + "\n"

    @property
    def held_against(self) -> str:
        """What the statements are held against, and how many have each verdict."""
        if self.model:
            return f"Held against the page {self.model}: {self.summary()}."
        first = [row.where or row.id for row in self.rows if row.status == "premise"]
        return (
            f"Without a page. Premises, taken as printed and not confirmed: {', '.join(first)}. "
            f"All else is held against what follows from these: {self.summary()}."
        )

    @property
    def judged(self) -> str:
        """How many statements were judged, and why the others were not."""
        apart = {
            "premise": "premises",
            "definition": "new names or ways of writing",
            "unread": "not read",
            "other": "not about the page",
        }
        counts = Counter(self.status)
        left = [f"{counts[it]} {said}" for it, said in apart.items() if counts[it]]
        total = len(self.rows)
        judged = total - sum(counts[it] for it in apart)
        return f"{judged} of {total} judged" + (f"; {', '.join(left)}." if left else ".")

    def to_html(self) -> str:
        """The same as one page of HTML, which loads nothing.

        Returns
        -------
        str

        Examples
        --------
        >>> "<h1>A paper</h1>" in PaperCheck("A paper", "kang_nam", (), ()).to_html()
        True
        """
        return as_page(self)

    def to_latex(self) -> str:
        r"""What is wrong, for a referee's letter in LaTeX: each equation as printed, and as it is
        right.

        Returns
        -------
        str

        Examples
        --------
        >>> print(PaperCheck("A paper", "kang_nam", (), ()).to_latex().splitlines()[0])
        \section*{A paper}
        """
        return as_latex(self)

    def _table(self, right: Callable[[Row], str]) -> str:
        """A row for each statement, with what is right in place of it."""
        rows = tuple((row.id, row.about, row.status, right(row)) for row in self.rows)
        return as_html(Table(self.summary(), ("id", "about", "status", "right"), rows))

    def _repr_html_(self) -> str:
        return self._table(lambda row: row.repaired_latex and rf"\({row.repaired_latex}\)")


def check(
    paper: str | os.PathLike[str],
    model: str | os.PathLike[str] | None = None,
    *,
    trust: bool = False,
    row_limit: float = 10.0,
) -> PaperCheck:
    """Verdicts on the printed equations of a paper, held against a page.

    Parameters
    ----------
    paper : str or path
        A file of statements, in TOML.
    model : str or path, optional
        A page, the folder of a model or a shipped model's name; left out, the file names it.
    trust : bool
        True if the code of a page or a folder that the file names may run; that of ``model`` may.
    row_limit : float
        Seconds of processor time that a row may take; one that takes more, or 1 GB, is unread.

    Returns
    -------
    PaperCheck
        One row for each statement.

    Raises
    ------
    ParameterError
        If the file of statements can't be read: its line, its key, and the remedy; or if it names
        code without ``trust``.
    MissingExtraError
        If SymPy is not installed.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import spragsym as ss
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder) / "paper.toml"
    ...     _ = file.write_text('''
    ... [[statement]]
    ... id = "9"
    ... about = "motion y"
    ... form = "scaled"
    ... sympy = "ay + sigma/L*(1 - L)*(sin(theta0) - y) + beta*y - N"
    ... ''')
    ...     (row,) = ss.check(file, "kang_nam").rows
    >>> print(row.status, row.repaired)
    misprint ay + sigma/L*(1 - L)*(sin(theta0) - y) + beta*y - N + kappa = 0

    """
    for name, given in (("paper", paper), ("model", model)):
        if given is not None or name == "paper":
            require_kind(name, given, (str, os.PathLike), "the path of a file")
    path = Path(paper)
    row_limit = as_number("row_limit", row_limit, POSITIVE)
    if importlib.util.find_spec("sympy") is None:
        raise MissingExtraError("a check of printed equations", "SymPy", "derive")
    from .derive.statements import papers

    text = text_of(path, what="the file of a paper", may_hold=None)
    try:
        read = papers.paper_of(path.name, text, toml_of)
    except papers.PaperError as error:
        raise ParameterError(str(error)) from error
    statements = tuple(
        replace(it, text=_code(path, it.file)) if it.file else it for it in read.statements
    )
    read = replace(read, statements=statements)
    chosen = Path(model) if model is not None else None
    if chosen is None and read.model:
        chosen = _named(path, read.model, trust)
    return _within_limits(read, chosen, row_limit)


def _code(paper: Path, name: str) -> str:
    """The text of a file of code beside a paper; it is read, and not run."""
    place = paper.parent / name
    if not place.is_file():
        raise ParameterError(f"{paper.name}: file = {name!r}: there is no such file")
    return text_of(place, what="a file of code", may_hold=None)


def _within_limits(paper: Paper, chosen: Path | None, seconds: float) -> PaperCheck:
    """Verdicts from a process of their own, which ends where a row takes too long or too much
    memory; it is begun again without that row.
    """
    excluded: dict[str, str] = {}
    texts = {ascii(it.id): it for it in paper.statements}
    with tempfile.TemporaryDirectory() as folder:
        begun = Path(folder) / "begun"
        while True:
            begun.write_text("", encoding="utf-8")
            task = _PaperTask(paper, chosen, seconds, str(begun), tuple(excluded))
            try:
                with pool(1) as own:
                    (found,) = own(_judged, [task])
                break
            except SweepError as error:
                *_, last = ["", *begun.read_text(encoding="utf-8").splitlines()]
                if (row := texts.get(last)) is None or row.id in excluded:
                    raise
                is_late = "SIGPROF" in str(error) or sys.platform == "win32"
                size = f"{seconds:g} s of processor time for {len(row.judged)} characters"
                excluded[row.id] = f"too large: {size if is_late else error}"
    if isinstance(found, Exception):
        raise found
    rows = [
        replace(row, about=it.about, status="unread", evidence=excluded[it.id])
        if it.id in excluded
        else row
        for row, it in zip(found.rows, paper.statements, strict=True)
    ]
    return PaperCheck(**{**vars(found), "rows": tuple(rows)})


@dataclass(frozen=True)
class _PaperTask:
    """A paper to judge, without the rows that were too large."""

    paper: Paper
    chosen: Path | None  #: None if what the paper prints first is the page
    seconds: float
    begun: str  #: a file that is told of each row
    excluded: tuple[str, ...]


def _judged(task: _PaperTask) -> Checked | Exception:
    """Verdicts on a paper, or the error; this process is ended by the row that takes too long."""
    from .derive.statements import dimensions, papers, premises, reading, verdicts

    rows = task.paper.statements
    kept = [replace(it, about="other") if it.id in task.excluded else it for it in rows]
    limit_memory()
    with open(task.begun, "a", encoding="utf-8") as told:

        def begin(row: str) -> None:
            told.write(f"{row!a}\n")
            told.flush()
            limit_time(task.seconds)

        try:
            page = None if task.chosen is None else _page(task.chosen)
            token = reading.BEGUN.set(begin)
            paper = replace(task.paper, statements=tuple(kept))
            found = premises.check_premises(paper) if page is None else verdicts.check(paper, page)
            wrong = dimensions.problems(task.paper)
            beside = tuple(replace(row, units=wrong.get(row.id, "")) for row in found.rows)
            found = replace(found, rows=beside)
            reading.BEGUN.reset(token)
        except papers.PaperError as error:
            return ParameterError(str(error))
        except Exception as error:
            return error
        finally:
            limit_time(0.0)
    return found


def _named(paper: Path, name: str, trust: bool) -> Path:
    """The page, folder or shipped model that a paper names, if its code may run.

    That of pages in the source of this package may: they are part of it.
    """
    from .derive.pages import OWN

    if name in shipped():
        return Path(name)
    page = paper.parent / name
    if not any(resolved(page).is_relative_to(folder.resolve()) for folder in OWN):
        try:
            require_trust(name, page, trust)
        except ParameterError as error:
            raise ParameterError(f"{paper.name}: model = {error}") from error
    return page


def _page(chosen: Path) -> Page:
    from .derive import pages
    from .derive.model import PageError

    if chosen.suffix == ".py":
        try:
            return pages.read(chosen, only_equations=True)
        except PageError as error:
            raise ParameterError(str(error)) from error
    loaded = load(chosen)
    return pages.read(page_of(loaded, pages.SHIPPED), loaded.name)
