"""Files of statements (TOML): the equations that a paper prints, and the page they are about."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeAlias


Table: TypeAlias = Mapping[str, object]


class PaperError(ValueError):
    """A file of statements that can't be read: its line, its key, and the remedy."""


@dataclass(frozen=True)
class Statement:
    """One printed statement; the fields are the keys of the file (docs/statements.md)."""

    id: str
    about: str
    text: str
    is_latex: bool
    where: str = ""
    form: str = ""
    limit: str = ""
    expect: str = "confirmed"
    note: str = ""
    transcribed: str = ""  #: the print in SymPy's syntax, beside its LaTeX
    file: str = ""  #: where code stands, and which function of it
    function: str = ""

    @property
    def word(self) -> str:
        """The kind of object that it is about."""
        return re.split(r"[ ,]", self.about)[0]

    @property
    def judged(self) -> str:
        """The text that is read."""
        return self.transcribed or self.text


@dataclass(frozen=True)
class Paper:
    """A file of statements.

    ``renamed`` has the paper's own names with their meanings on the page, from [symbols];
    ``conventions`` how it counts coordinates, from [conventions].
    """

    title: str
    model: str
    renamed: Mapping[str, str]
    statements: tuple[Statement, ...]
    conventions: Mapping[str, str] = field(default_factory=dict)
    meanings: Mapping[str, str] = field(default_factory=dict)  #: what the text says of names
    units: Mapping[str, str] = field(default_factory=dict)  #: of names, as far as they are known
    data: Mapping[str, str] = field(default_factory=dict)  #: printed values of names


def read(path: Path) -> Paper:
    """The paper in a file of this project; those of others come through ``spragsym.papers``."""
    return paper_of(path.name, path.read_text(encoding="utf-8"), tomllib.loads)


def paper_of(name: str, text: str, data_of: Callable[[str], Table]) -> Paper:
    """The paper in the text of a file, whose data ``data_of`` reads.

    Raises
    ------
    PaperError
        If it is no TOML or a key is wrong, with line, key and remedy.
    """
    try:
        data = data_of(text)
    except ValueError as error:
        raise PaperError(f"{name} is no TOML: {error}; LaTeX stands in ''' '''") from error
    lines = text.split("\n")

    def refuse(key: str, message: str, after: int = 0) -> PaperError:
        begin = re.compile(rf"\s*[\[\"']*{re.escape(key)}\b")
        found = (n for n, line in enumerate(lines[after:], after + 1) if begin.match(line))
        line = next(found, after or 1)
        return PaperError(f"{name}, line {line}, key {key}: {message}")

    allowed = ("paper", "model", "symbols", "conventions", "meanings", "units", "data", "statement")
    for key in sorted(data.keys() - {*allowed}):
        raise refuse(key, f"is unknown; allowed are {', '.join(allowed)}")
    texts = {key: data.get(key, "") for key in ("paper", "model")}
    for key, value in texts.items():
        if not isinstance(value, str):
            raise refuse(key, f"{value!r} is no text; write it in quotation marks")
    entries, tables = data.get("statement", []), dict[str, dict[str, str]]()
    for key, said in (
        ("symbols", """write "print" = "page's name\""""),
        ("conventions", 'write x = "reversed" or theta = "theta - pi"'),
        ("meanings", 'write m = "mass of the cart"'),
        ("units", 'write m = "kg"'),
        ("data", 'write g = "9.81"'),
    ):
        table = data.get(key, {})
        if not isinstance(table, dict) or not all(isinstance(it, str) for it in table.values()):
            raise refuse(key, f"is no table of texts; {said}")
        tables[key] = table
    if (
        not isinstance(entries, list)
        or not entries
        or not all(isinstance(it, dict) for it in entries)
    ):
        raise refuse("statement", "there is none; begin each with [[statement]]")
    begins = [
        n for n, line in enumerate(lines) if line.replace(" ", "").startswith("[[statement]]")
    ]
    found: list[Statement] = []
    ids: set[str] = set()
    for number, entry in enumerate(entries):
        after = begins[number] if number < len(begins) else 0
        problem = _problem(entry, ids)
        if problem is not None:
            raise refuse(problem[0], problem[1], after)
        ids.add(entry["id"])
        rest = {key: entry[key] for key in entry.keys() - {"latex", "sympy"}}
        sympy = entry.get("sympy", "")
        if "file" in entry:
            found.append(Statement(text="", is_latex=False, **rest))
        elif "latex" in entry:
            found.append(Statement(text=entry["latex"], is_latex=True, transcribed=sympy, **rest))
        else:
            found.append(Statement(text=sympy, is_latex=False, **rest))
    head = str(texts["paper"]), str(texts["model"]), tables["symbols"]
    more = (tables[it] for it in ("conventions", "meanings", "units", "data"))
    return Paper(*head, tuple(found), *more)


def _problem(entry: Table, before: set[str]) -> tuple[str, str] | None:
    """The first wrong or missing key of a statement and what is wrong; None for a valid one."""
    keys = {"id", "where", "about", "latex", "sympy", "form", "limit", "expect", "note"}
    code = {"file", "function"}
    keys |= code
    for key, value in entry.items():
        if key not in keys:
            return key, f"is unknown; allowed are {', '.join(sorted(keys))}"
        if not isinstance(value, str):
            return key, f"{value!r} is no text; write it in quotation marks"
    for key in ("id", "about"):
        if not entry.get(key):
            return key, f'is missing in this statement; add {key} = "…"'
    if entry["id"] in before:
        return "id", f"{entry['id']} stands twice; give the second statement another id"
    if (entry["about"] == "code") is not (code <= entry.keys()) or len(code & entry.keys()) == 1:
        return "about", 'code has file = "…" and function = "…", and nothing else has'
    if not {"latex", "sympy", "file"} & entry.keys() and entry["about"] != "other":
        return "id", f"{entry['id']} has to have latex, or sympy, or both"
    verdicts = (
        "confirmed",
        "definition",
        "approximation",
        "misprint",
        "failed",
        "unread",
        "other",
    )
    for key, allowed in (("form", ("units", "scaled")), ("expect", verdicts)):
        if key in entry and entry[key] not in allowed:
            return key, f"{entry[key]!r} is none of {', '.join(allowed)}"
    return None
