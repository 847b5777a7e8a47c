"""The register of absolute sentences: ``python docs/statements.py`` writes docs/statements.md from
docs/statements.toml, and prints how many there are and how many a row covers.
"""

from __future__ import annotations

import inspect
import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

import jinja2

import spragsym as ss

HERE = Path(__file__).parent
ROOT = HERE.parent
REGISTER = tomllib.loads((HERE / "statements.toml").read_text(encoding="utf-8"))
#: "None" is Python's, but for "None of".
WORD = re.compile(rf"\b(?:{'|'.join(REGISTER['words'])})\b", re.IGNORECASE)
PYTHONS = re.compile(r"\bNone\b(?! of\b)")


@dataclass(frozen=True)
class Absolute:
    """An absolute word of a text: where it stands, the paragraph, and its place in that."""

    where: str
    text: str
    begin: int
    end: int


def paragraphs(text: str) -> Iterator[str]:
    """Of a page or a docstring, on one line each, without blocks of code."""
    text = re.sub(r"\A---\n.*?^---\n", "", text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"^(```|~~~).*?^\1", "\n", text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"^ *>>> .*?(?=^\s*$|\Z)", "", text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"^[\w*, ]+ : .*", "", text, flags=re.MULTILINE)  # names and types of parameters
    for part in re.split(r"\n\s*\n|\n(?=\||[-*] |\d+\. |#)", text):
        yield " ".join(part.split())


def public() -> Iterator[tuple[str, str]]:
    """Docstrings of the public names, of their methods and properties."""
    rooms: list[ModuleType] = [ss, ss.kang_nam, ss.results, ss.errors, ss.figures, ss.precise]
    for room in rooms:
        yield room.__name__, inspect.getdoc(room) or ""
        for name in getattr(room, "__all__", dir(room)):
            thing = getattr(room, name)
            members = vars(thing).items() if inspect.isclass(thing) else ()
            for said in (thing, *(part for key, part in members if not key.startswith("_"))):
                if is_ours(said):
                    yield f"{room.__name__}.{name}", inspect.getdoc(said) or ""


def is_ours(said: object) -> bool:
    """Whether a docstring is one of a function, class or property of the package."""
    if isinstance(said, property | classmethod | staticmethod):
        said = getattr(said, "fget", None) or getattr(said, "__func__", None)
    return callable(said) and getattr(said, "__module__", "").startswith("spragsym.")


def texts() -> Iterator[tuple[str, str]]:
    """Each page that is not generated from guarded data, and each public docstring once."""
    for page in (ROOT / "README.md", ROOT / "paper.md", *sorted(HERE.glob("*.md"))):
        if page.name not in REGISTER["pages"]:
            yield page.relative_to(ROOT).as_posix(), page.read_text(encoding="utf-8")
    yield from {text: (where, text) for where, text in public()}.values()


def absolutes() -> list[Absolute]:
    """Every absolute word of the texts, outside of code and of questions."""
    return [
        Absolute(where, part, found.start(), found.end())
        for where, text in texts()
        for part in paragraphs(text)
        for found in WORD.finditer(re.sub(r"``?[^`]*``?", lambda code: "`" * len(code[0]), part))
        if not PYTHONS.match(part, found.start())
        and not re.match(r"[^.:;?|]*\?", part[found.end() :])
    ]


def covered(word: Absolute, phrases: list[str]) -> str | None:
    """The phrase of the list, in small letters, in which a word lies."""
    text = word.text.lower()
    for phrase in phrases:
        begin = text.find(phrase, max(0, word.end - len(phrase)))
        if 0 <= begin <= word.begin and word.end <= begin + len(phrase):
            return phrase
    return None


def phrases() -> list[str]:
    """Those of all rows, and the harmless ones."""
    kinds = [row.get("text", []) for row in REGISTER["rows"].values()]
    return [phrase.lower() for kind in (*kinds, *REGISTER["harmless"].values()) for phrase in kind]


def page() -> str:
    """docs/statements.md."""
    made = jinja2.Environment(
        undefined=jinja2.StrictUndefined, trim_blocks=True, keep_trailing_newline=True
    )
    text = (HERE / "statements.jinja").read_text(encoding="utf-8")
    return made.from_string(text).render(REGISTER)


if __name__ == "__main__":
    (HERE / "statements.md").write_text(page(), encoding="utf-8")
    words, known = absolutes(), phrases()
    rows = [phrase.lower() for row in REGISTER["rows"].values() for phrase in row.get("text", [])]
    print(
        f"{len(REGISTER['rows'])} rows; {len(words)} absolute words, "
        f"{sum(covered(word, known) is not None for word in words)} covered, "
        f"{sum(covered(word, rows) is not None for word in words)} of them by rows"
    )
