"""Text that is shown, by one function for each format: terminal and messages, Markdown, HTML, JSON.

What a file holds is data: in no format it commands a terminal, disguises a text, begins a line or a
cell, or is markup.
"""

from __future__ import annotations

import html
import json
import math
import re
import unicodedata
from collections.abc import Iterable, Mapping
from typing import Any


def unprinted(text: Iterable[str]) -> list[str]:
    """Characters that are not printed, in order: controls, formats such as marks of direction,
    surrogates, and separators of lines and paragraphs.
    """
    return sorted(
        one for one in {*text} if unicodedata.category(one) in ("Cc", "Cf", "Cs", "Zl", "Zp")
    )


def visible(text: str) -> str:
    r"""Text on one line of a terminal or a message: blanks for ends of lines and tabs, escapes for
    what else is not printed.

    >>> print(visible("confirmed\n\x1b[31m7"))
    confirmed \x1b[31m7
    """
    return text.translate(
        {
            ord(one): " " if one.isspace() else one.encode("unicode_escape").decode("ascii")
            for one in unprinted(text)
        }
    )


def markdown_text(text: str) -> str:
    r"""Text in a line or a cell of Markdown that is no markup.

    >>> print(markdown_text("a|*b*<script>"))
    a\|\*b\*< script>
    """
    marked = r"[\\`*\[\]|]|(?<!\w)_|_(?!\w)"
    return re.sub(marked, r"\\\g<0>", _without_tags(text))


def markdown_code(text: str) -> str:
    """A formula in a line of Markdown, between as many backticks as it needs.

    >>> markdown_code("k*x")
    '`k*x`'
    """
    inside = _without_tags(text)
    longest = max(map(len, re.findall("`+", inside)), default=0)
    fence, blank = "`" * (longest + 1), " " * (longest > 0)
    return f"{fence}{blank}{inside}{blank}{fence}"


def _without_tags(text: str) -> str:
    """Visible text in which no < begins a tag: a blank behind it, which formulas do not mind."""
    return re.sub(r"<(?=[A-Za-z/!?])", "< ", visible(text))


def html_text(text: str) -> str:
    """Text in an element or an attribute of HTML.

    >>> html_text("<b>")
    '&lt;b&gt;'
    """
    return html.escape(visible(text))


def without_nan(thing: object) -> Any:
    """Data for JSON: None in place of NaN and infinities."""
    if isinstance(thing, Mapping):
        return {name: without_nan(value) for name, value in thing.items()}
    if isinstance(thing, list | tuple):
        return [without_nan(value) for value in thing]
    return None if isinstance(thing, float) and not math.isfinite(thing) else thing


def json_text(thing: object, *, indent: int | None = None, ascii_only: bool = False) -> str:
    r"""Data as JSON, in which what is not printed is escaped; read back it is the same.

    >>> print(json_text("\u202e7"))
    "\u202e7"
    """
    text = json.dumps(thing, indent=indent, ensure_ascii=ascii_only, allow_nan=False)
    return text.translate(
        {ord(one): json.dumps(one)[1:-1] for one in unprinted(text) if one != "\n"}
    )
