"""Texts of users' files, of bounded size and checked characters, and of the package's templates."""

from __future__ import annotations

import codecs
import os
import unicodedata
from collections.abc import Mapping
from importlib import resources
from typing import Any, TypeAlias

from ..core.errors import MissingExtraError, ParameterError, ParameterTypeError
from ..core.type_variables import T

#: The path of a file.
FilePath: TypeAlias = str | os.PathLike[str]
#: Largest size in bytes of a file that is written by hand.
BY_HAND = 1 << 20


def path_text(path: FilePath) -> str:
    """A path as text.

    Raises
    ------
    ParameterTypeError
        For anything else.
    """
    if not isinstance(path, str | os.PathLike):
        raise ParameterTypeError(f"path = {path!r:.60} is no path; give text, or a pathlib.Path")
    return os.fsdecode(os.fspath(path))


def contents(path: FilePath, largest: int = BY_HAND, what: str = "another file") -> bytes:
    """The bytes of a file or a pipe; ``what`` says in errors what to give.

    It returns for an endless device and for a pipe without a writer too.

    Raises
    ------
    ParameterError
        If there is no such file, or it holds more than ``largest`` bytes.
    """
    name = path_text(path)
    shown = name if len(name) <= 200 else f"{name[:80]}…"
    if os.path.isdir(path):
        raise ParameterError(f"{shown} is a folder; give {what}")
    try:
        # O_NONBLOCK: a pipe without a writer is then at its end, instead of blocking.
        number = os.open(
            path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
        )
        if hasattr(os, "set_blocking"):
            os.set_blocking(number, True)
        with open(number, "rb") as file:
            data = file.read(largest + 1)
    except ValueError as error:  # a NUL in a name
        raise ParameterError(
            f"{shown!r} can't be the name of a file: {error}; give {what}"
        ) from error
    except OSError as error:
        raise ParameterError(f"{shown} can't be read: {error.strerror}; give {what}") from error
    if len(data) > largest:
        raise ParameterError(f"{shown} has more than {largest} bytes; give {what}")
    return data


def text_of(
    path: FilePath, largest: int = BY_HAND, what: str = "another file", remedy: str = ""
) -> str:
    """The text of a file in UTF-8, with or without byte order mark, or in UTF-16 with one, as
    PowerShell writes it.

    Errors are those of :func:`contents`, and a ParameterError for other bytes.
    """
    data = contents(path, largest, what)
    is_utf16 = data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    try:
        text = data.decode("utf-16" if is_utf16 else "utf-8-sig")
    except UnicodeDecodeError as error:
        raise ParameterError(
            f"{os.fspath(path)} is not text in UTF-8 (byte {error.start}); save it as UTF-8{remedy}"
        ) from error

    return printed(os.fspath(path), text, allowed="\n\r\t")


def brake_text(path: FilePath) -> str:
    """The text of a file of data, by :func:`text_of`."""
    return text_of(path, what="a file such as brake.toml", remedy=", or write +- for ±")


def printed(where: str, held: T, allowed: str = "") -> T:
    """Return text, or data with texts in it, if it has printable characters only.

    Control characters are commands to a terminal, and marks of the writing direction disguise a
    text. Pages have the same rule, ``check_characters`` of ``derive.model``.

    Raises
    ------
    ParameterError
        For other characters, unless they are ``allowed``.

    >>> printed("brake.toml", {"title": "Front brake"})
    {'title': 'Front brake'}
    """
    if isinstance(held, str):
        for one in sorted(set(held) - {*allowed}):
            # Unicode's controls, formats, surrogates, line and paragraph separators.
            if unicodedata.category(one) in ("Cc", "Cf", "Cs", "Zl", "Zp"):
                line = held[: held.index(one)].count("\n") + 1
                at = f", line {line}" if line > 1 else ""
                raise ParameterError(
                    f"{where}{at}: the text {held[:60]!a} holds the character U+{ord(one):04X}, "
                    "which is not printed; take it out"
                )
    elif isinstance(held, Mapping):
        for key, value in held.items():
            printed(where, key, allowed)
            printed(where, value, allowed)
    elif isinstance(held, list | tuple):
        for value in held:
            printed(where, value, allowed)
    return held


def shipped_text(package: str, name: str) -> str:
    """The text of a file in a package."""
    return (resources.files(package) / name).read_text(encoding="utf-8")


def filled(package: str, name: str, what: str, **values: Any) -> str:
    """A template filled with values; text is escaped in HTML.

    Raises
    ------
    MissingExtraError
        Without jinja2; ``what`` says for what it is needed.
    """
    try:
        from jinja2 import Environment, StrictUndefined
    except ModuleNotFoundError as error:
        raise MissingExtraError(what, "jinja2", "plot") from error
    made = Environment(
        autoescape=name.endswith(".html"),
        undefined=StrictUndefined,
        trim_blocks=True,
        keep_trailing_newline=True,
    )
    return made.from_string(shipped_text(package, name)).render(values)
