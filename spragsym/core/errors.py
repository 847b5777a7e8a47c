"""Errors: each says which argument, its value, what is allowed, and what to do."""

from __future__ import annotations

import difflib
import re
import unicodedata
from collections.abc import Iterable

from .shown import visible


class SpragsymError(Exception):
    """Base of every error that this package raises on purpose.

    Its text shows names and texts of files without characters that are not printed.
    """

    def __str__(self) -> str:
        return visible(super().__str__())


class ParameterError(SpragsymError, ValueError):
    """An argument has a value that is not allowed."""


class ParameterTypeError(SpragsymError, TypeError):
    """An argument is not a number, or not numbers of the kind that is needed."""


class ModelError(ParameterTypeError):
    """A question that can't be answered for a model; the text says what can be asked instead."""


class NotDimensionlessError(ParameterTypeError, AttributeError):
    """Parameters in newtons and metres stand where dimensionless ones are needed.

    Also an AttributeError, so that ``hasattr`` answers: what is missing is what dimensionless
    parameters have.
    """


class TargetError(ParameterError, FileExistsError):
    """A file exists at the target and is not to be replaced."""


class ConvergenceError(SpragsymError, RuntimeError):
    """A computation did not converge, or its result could not be certified."""


class MissingExtraError(SpragsymError, ImportError):
    """A feature needs a package that is not installed."""

    def __init__(self, feature: str, module: str, extra: str) -> None:
        super().__init__(
            f"{feature} needs {module}, which is not installed; in the source folder: pip "
            f"install '.[{extra}]'"
        )


class BackendError(SpragsymError, ImportError):
    """A backend that this installation does not have."""


class SweepError(SpragsymError, RuntimeError):
    """A sweep had to stop: the machine failed, or whatever else is no property of a motion."""


class StoreError(SpragsymError, OSError):
    """A file is damaged, in use, or cannot be written."""


class DamagedError(StoreError, TargetError):
    """The file is not a result of this library: it is damaged, or something else wrote it."""


class DamageWarning(UserWarning):
    """Part of a file is damaged and left out; the rest is good and used."""


class UndecidedWarning(UserWarning):
    """Some of many points have no answer; the others do."""


def closest(given: object, allowed: Iterable[str]) -> str | None:
    """The allowed name that was most likely meant, or None.

    Case, separators, Greek letters, subscripts and a trailing ``deg`` or ``rad`` make no
    difference; after that the spelling decides.

    Examples
    --------
    >>> closest("μ_0", ["theta0", "mu0", "kappa"]), closest("kapa", ["theta0", "mu0", "kappa"])
    ('mu0', 'kappa')
    """
    plain = {_plain(name): name for name in allowed}
    word = _plain(str(given))
    # Words for the article's parameters.
    words = {
        "theta": "theta0",
        "mu": "mu0",
        "inclination": "theta0",
        "friction": "mu0",
        "preload": "kappa",
    }
    for candidate in (word, word.removesuffix("deg"), word.removesuffix("rad")):
        if (match := words.get(candidate, candidate)) in plain:
            return plain[match]
    if len(word) < 2:  # one letter resembles every short name
        return None
    found = difflib.get_close_matches(word, [name for name in plain if len(name) > 1], n=1)
    return plain[found[0]] if found else None


def hint(given: object, allowed: Iterable[str]) -> str:
    """The end of a message, ``"; did you mean kappa?"``; empty if no name is similar."""
    meant = closest(given, allowed)
    return f"; did you mean {meant}?" if meant else ""


def one_of(name: str, given: object, allowed: Iterable[str]) -> str:
    """Return a word if it is allowed; else raise a ParameterError that lists those that are."""
    words = [*allowed]
    if given not in words:
        raise ParameterError(
            f"{name} = {given!r} is not one of {', '.join(words)}{hint(given, words)}"
        )
    return str(given)


def require_kind(name: str, value: object, kind: type | tuple[type, ...], remedy: str) -> None:
    """Raise a ParameterTypeError unless an argument is of a class, as the result of a question."""
    if not isinstance(value, kind):
        kinds = " or ".join(it.__name__ for it in (kind if isinstance(kind, tuple) else (kind,)))
        raise ParameterTypeError(f"{name} = {value!r:.60} is no {kinds}; give {remedy}")


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
