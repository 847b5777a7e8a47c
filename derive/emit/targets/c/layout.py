"""The layout of C that clang-format gives with the project's settings: where long lines are broken,
and how comments are written.

Lines are broken only where clang-format breaks them: after an operator outside all brackets, or
after a comma in the outermost ones. Text in further brackets stays on one line, however long.
"""

import itertools
import re
import textwrap
import unicodedata
from collections.abc import Iterator

from ...definitions import WIDTH


def broken(line: str) -> str:
    """A statement, or the head of a function, on as many lines as it needs."""
    indent = line[: len(line) - len(line.lstrip())] + "    "
    lines = [""]
    for start, end in itertools.pairwise([0, *_places(line), len(line)]):
        part = line[start:end]
        if lines[-1] and len(lines[-1].rstrip()) + len(part.rstrip()) > WIDTH:
            lines.append(indent)
        lines[-1] += part
    return "\n".join(text.rstrip() for text in lines)


def definition(head: str, body: str) -> str:
    """A function, on one line if it is one statement that fits."""
    line = f"{head} {body.strip()} }}"
    return f"{line}\n" if body.count("\n") == 1 and len(line) <= WIDTH else f"{head}\n{body}}}\n"


def _places(line: str) -> list[int]:
    """Places at which a line may be broken."""
    depths = list(_depths(line))
    outside = "".join(
        character if depth == 0 else "_" for character, depth in zip(line, depths, strict=True)
    )
    first = max(outside.find(" = "), 0) + 1
    unbreakable = re.compile(r" (\?|[<>]=?|==|!=) ")
    # Operators, by how weakly they bind: a line is broken only after the weakest that it
    # has.
    for operator in (r"&|\|", r"\+|-", r"\*|/"):
        if places := [
            match.end()
            for match in re.finditer(rf" (?:{operator}) ", outside)
            if match.start() > first
        ]:
            return places
        if unbreakable.search(outside):
            return []
    return [match.end() for match in re.finditer(", ", line) if depths[match.start()] == 1]


def _depths(line: str) -> Iterator[int]:
    depth = 0
    for character in line:
        depth -= character in ")]}"
        yield depth
        depth += character in "([{"


def comment(text: str, indent: str = "") -> str:
    """A comment on lines of its own, paragraph by paragraph."""
    width = WIDTH - len(" */")
    paragraphs = [
        textwrap.fill(plain(paragraph), width - len(indent) - 3, subsequent_indent=f"{indent} * ")
        for paragraph in text.split("\n\n")
    ]
    return f"{indent}/* " + f"\n{indent} *\n{indent} * ".join(paragraphs) + " */\n"


def plain(text: str) -> str:
    """A text in ASCII, which every compiler reads."""
    # Signs as C sources have them, and what would end a comment or begin one; letters are
    # spelled by their names.
    spelled = {
        "n̄": "nbar",
        "√": "sqrt ",
        "≠": "!=",
        "≤": "<=",
        "≥": ">=",
        "−": "-",
        "′": "'",
        "″": "''",
        "ℓ": "l",
        "×": "*",
        "·": "*",
        "±": "+-",
        "``": "`",
        "–": "-",
        "—": "-",
        "∂": "d",
        "…": "...",
        "°": " degrees",
        "∞": "infinity",
        "\u0303": "~",
        "λ": "lambda",
        "Λ": "Lambda",
        "*/": "* /",
        "/*": "/ *",
        "??": "? ?",
    }
    for sign, words in spelled.items():
        text = text.replace(sign, words)
    superscripts = str.maketrans({power: f"^{number}" for number, power in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")})
    return "".join(map(_ascii, text.translate(superscripts)))


def _ascii(character: str) -> str:
    """The name of a Greek letter, another letter without its accent, or the character's name in
    Unicode, in brackets.
    """
    if character.isascii():
        return character
    name = unicodedata.name(character, f"U+{ord(character):04X}")
    if letter := re.match(r"GREEK (SMALL|CAPITAL) LETTER (\w+)", name):
        return letter[2].lower() if letter[1] == "SMALL" else letter[2].capitalize()
    if unicodedata.combining(character):
        return ""
    lettered = character.isalpha() or character.isdigit()
    without = (
        "".join(filter(str.isascii, unicodedata.normalize("NFKD", character))) if lettered else ""
    )
    return without or f"[{name.lower()}]"
