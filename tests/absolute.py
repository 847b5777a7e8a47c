"""Sentences of pages, public docstrings, commands and reports that speak of all states, folds, jumps or cycles, or of none."""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import spragsym as ss

ROOT = Path(__file__).resolve().parent.parent
#: Each such sentence with what stands behind it; ``python -m tests.absolute`` prints those that are not there.
READ = ROOT / "tests" / "absolute.txt"
#: What may stand behind one: a row of docs/statements.md; a computation that is shown; nothing, since it says what a name
#: means or speaks of something else; a claim of the article's; or it says that something is not known.
REASONS = ("proved", "computed", "means", "quoted", "open")
_ABSOLUTE = re.compile(
    r"\b(never|nothing|nowhere|none|no|always|every|all|whatever|guaranteed|proved|proves|proof|only|exact|exactly)\b",
    re.IGNORECASE,
)
_OF_RESULTS = re.compile(
    r"\b(jump\w*|folds?|cusps?|equilibri\w+|states?|flutter\w*|onsets?|oscillat\w+|cycles?)\b", re.IGNORECASE
)


def sentences() -> Iterator[tuple[str, str]]:
    """Page and sentence, of those in question. Pages that are generated from claims, each with its test, are left out."""
    for path in (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))):
        if path.name not in ("statements.md", "reproduction.md", "models.md"):
            yield from _absolute(
                path.name, re.sub(r"^(```|\$\$).*?^(```|\$\$)", "\n\n", path.read_text(encoding="utf-8"), flags=re.M | re.S)
            )
    for name in ("texts", "other_texts"):
        path = ROOT / "spragsym" / "studies" / f"{name}.py"
        if path.exists():
            yield from _absolute(path.name, "\n\n".join(_strings(ast.parse(path.read_text(encoding="utf-8")))))

    for name, text in _docstrings():
        yield from _absolute(name, text)


def _docstrings() -> Iterator[tuple[str, str]]:
    """Texts of everything public, with the methods of classes and the functions of modules, and of the commands."""
    for name in sorted(ss.__all__):
        thing = getattr(ss, name)
        yield name, _without_examples(thing)
        inner = vars(thing) if inspect.isclass(thing) else {key: getattr(thing, key) for key in getattr(thing, "__all__", ())}
        for key, part in inner.items():
            if not key.startswith("_") and (inspect.isroutine(part) or isinstance(part, property) or hasattr(part, "func")):
                yield f"{name}.{key}", _without_examples(part)
    from spragsym.cli import cli

    for name in cli.list_commands(None):  # type: ignore[arg-type]  # the list depends on no context
        yield f"spragsym {name}", (cli.get_command(None, name).help or "").split("Examples:")[0]  # type: ignore[arg-type,union-attr]


def _without_examples(thing: Any) -> str:
    return (inspect.getdoc(thing) or "").split("\nExamples\n--------")[0]


def _absolute(page: str, text: str) -> Iterator[tuple[str, str]]:
    for part in re.split(r"\n\s*\n|\n(?=#|- |\* |\d+\. |\|)", text):
        for sentence in re.split(r"(?<=[.!?])\s+(?=[A-Zµμ`*\[(\"])", " ".join(part.split())):
            if _ABSOLUTE.search(sentence) and _OF_RESULTS.search(sentence):
                yield page, sentence


def _strings(tree: ast.AST) -> Iterator[str]:
    """Texts that are said; what is filled in as {}."""
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            yield "".join(str(part.value) if isinstance(part, ast.Constant) else "{}" for part in node.values)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and " " in node.value:
            yield node.value


def read() -> dict[tuple[str, str], str]:
    """What stands behind each sentence that was read."""
    rows = [line.split("\t") for line in READ.read_text(encoding="utf-8").splitlines() if line]
    return {(page, sentence): reason for reason, page, sentence in rows}


if __name__ == "__main__":
    known = read() if READ.exists() else {}
    for page, sentence in dict.fromkeys(sentences()):
        if (page, sentence) not in known:
            print(f"?\t{page}\t{sentence}")
