"""Closest match for a mistyped name."""

from __future__ import annotations

import difflib
import re
import unicodedata
from collections.abc import Iterable

#: Other ways to write the symbols of the model.
_WORDS = {"theta": "theta0", "mu": "mu0", "inclination": "theta0", "friction": "mu0", "preload": "kappa"}


def closest(given: str, allowed: Iterable[str]) -> str | None:
    """The allowed name that was most likely meant, or None.

    Case, separators, Greek letters, subscripts and a trailing ``deg`` or ``rad`` make no difference; after that
    the spelling decides.

    Examples
    --------
    >>> closest("μ_0", ["theta0", "mu0", "kappa"]), closest("kapa", ["theta0", "mu0", "kappa"])
    ('mu0', 'kappa')
    """
    plain = {_plain(name): name for name in allowed}
    word = _plain(given)
    for candidate in (word, word.removesuffix("deg"), word.removesuffix("rad")):
        if (known := _WORDS.get(candidate, candidate)) in plain:
            return plain[known]
    # A one-letter name resembles every short name, so only its exact spelling counts.
    found = difflib.get_close_matches(word, [name for name in plain if len(name) > 1], n=1) if len(word) > 1 else []
    return plain[found[0]] if found else None


def hint(given: str, allowed: Iterable[str]) -> str:
    """``"; did you mean kappa?"``, or nothing."""
    meant = closest(given, allowed)
    return f"; did you mean {meant}?" if meant else ""


def latin(text: str) -> str:
    """Greek letters by their names, and subscripts as digits."""
    return "".join(_letter(character) for character in unicodedata.normalize("NFKC", text))


def _letter(character: str) -> str:
    name = unicodedata.name(character, "")
    found = re.fullmatch(r"GREEK (SMALL|CAPITAL) LETTER (\w+)", name)
    if not found:
        return character
    return found[2].lower() if found[1] == "SMALL" else found[2].capitalize()


def _plain(name: str) -> str:
    return re.sub(r"[\s_\-]", "", latin(name)).casefold()
