"""Reading of prints without a page: every name is known as it is spelled, and what has dots or is
differentiated by time moves.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from contextlib import suppress

from .latex import read_latex
from .tree import Equation, Unread, Vocabulary, nodes, read_sympy, symbols

_BY_TIME = re.compile(
    r"frac\s*\{\s*(?:\\mathrm\s*)?\{?d\}?\s*(?:\^\{?2\}?)?\s*"
    r"(?P<name>\\?[A-Za-z]+(?:_(?:\{\w+\}|\w))?)\s*(?:\(t\))?\s*\}"
    r"\s*\{\s*(?:\\mathrm\s*)?\{?d\}?\s*t"
)


def read_alone(
    text: str,
    moving: Iterable[str],
    renamed: Mapping[str, str] | None = None,
    *,
    is_latex: bool = True,
    dotted: set[str] | None = None,
) -> list[Equation]:
    """The equations in a print; names with dots that are not ``moving`` are added to ``dotted``.

    Raises
    ------
    Unread
        If a part can't be read or is ambiguous, with its offset.
    """
    coordinates = tuple(sorted(moving))
    if not is_latex:
        words = frozenset(re.findall(r"[^\W\d]\w*", text))
        return read_sympy(text, Vocabulary(words, coordinates, dict(renamed or {})))
    names = Vocabulary(
        frozenset(coordinates),
        coordinates,
        dict(renamed or {}),
        derivative=lambda of, by: f"diff({of}, {by})" if by else f"diff({of})",
        dotted=set() if dotted is None else dotted,
    )
    return read_latex(text, names)


def moving_names(texts: Iterable[str], renamed: Mapping[str, str] | None = None) -> frozenset[str]:
    """Names that have dots, two primes, or a derivative by time, in any of the prints."""
    found: set[str] = set()
    for text in texts:
        for it in _BY_TIME.finditer(text):
            with suppress(Unread):
                (equation,) = read_alone(it["name"], (), renamed)
                found |= symbols(equation.left) if equation.left.kind == "symbol" else set()
        with suppress(Unread, RecursionError):
            read_alone(text, found, renamed, dotted=found)
    return frozenset(found)


def derivatives_in(equation: Equation) -> frozenset[str]:
    """Names of the derivatives in an equation, as ``diff(L, vx)``."""
    sides = (*nodes(equation.left), *nodes(equation.right))
    return frozenset(it.value for it in sides if it.value.startswith("diff("))
