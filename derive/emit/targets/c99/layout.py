"""Layout of C as clang-format has it with the project's settings: where a long line is broken, and how comments are spelled.

Lines are broken only where clang-format leaves a break: after an operator outside of all brackets, or after a comma of the outermost
ones. Text inside further brackets stays on one line, however long.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator

WIDTH = 124
_INDENT = "    "
#: Operators, by how weakly they bind: a line is broken only after the weakest that it has.
_OPERATORS = (r"&|\|", r"\+|-", r"\*|/")
_UNBREAKABLE = re.compile(r" (\?|[<>]=?|==|!=) ")
#: Greek letters and signs as C sources have them.
_SPELLED = {
    "θ₀": "theta0", "θ": "theta", "μ₀": "mu0", "μ": "mu", "κ": "kappa", "α": "alpha", "σ": "sigma", "β": "beta", "n̄": "nbar",
    "π": "pi", "λ": "lambda", "τ": "tau", "√": "sqrt ", "²": "^2", "³": "^3", "⁴": "^4", "≤": "<=", "≥": ">=", "−": "-", "′": "'",
    "″": "''", "ℓ": "l", "φ": "phi", "P̃": "P~", "Q̃": "Q~", "×": "*", "ω": "omega", "``": "`", "–": "-", "δ": "delta", "∂": "d",
    "…": "...",
}  # fmt: skip


def broken(line: str) -> str:
    """A statement, or the head of a function, on as many lines as it needs."""
    indent = line[: len(line) - len(line.lstrip())] + _INDENT
    lines = [""]
    for part in _parts(line):
        if lines[-1] and len(lines[-1].rstrip()) + len(part.rstrip()) > WIDTH:
            lines.append(indent)
        lines[-1] += part
    return "\n".join(text.rstrip() for text in lines)


def _parts(line: str) -> Iterator[str]:
    """The line, cut where it may be broken."""
    start = 0
    for place in _places(line):
        yield line[start:place]
        start = place
    yield line[start:]


def _places(line: str) -> list[int]:
    depths = list(_depths(line))
    outside = "".join(character if depth == 0 else "_" for character, depth in zip(line, depths, strict=True))
    first = max(outside.find(" = "), 0) + 1
    for operator in _OPERATORS:
        if places := [match.end() for match in re.finditer(rf" (?:{operator}) ", outside) if match.start() > first]:
            return places
        if _UNBREAKABLE.search(outside):
            return []
    return [match.end() for match in re.finditer(", ", line) if depths[match.start()] == 1]


def _depths(line: str) -> Iterator[int]:
    depth = 0
    for character in line:
        depth -= character in ")]}"
        yield depth
        depth += character in "([{"


def comment(text: str, indent: str = "") -> str:
    """A comment of its own, paragraph by paragraph."""
    width = WIDTH - len(" */")
    paragraphs = [
        textwrap.fill(plain(paragraph), width - len(indent) - 3, subsequent_indent=f"{indent} * ")
        for paragraph in text.split("\n\n")
    ]
    return f"{indent}/* " + f"\n{indent} *\n{indent} * ".join(paragraphs) + " */\n"


def plain(text: str) -> str:
    """The words with letters and signs that every compiler reads."""
    for sign, words in _SPELLED.items():
        text = text.replace(sign, words)
    if not text.isascii():
        strange = "".join(sorted({letter for letter in text if not letter.isascii()}))
        raise ArithmeticError(f"C comments are ASCII, and {strange!r} has no spelling yet; add one in {__name__}: {text!r}")
    return text
