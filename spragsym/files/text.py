"""Texts: of users' files, read on any system and up to a bound, and of templates that come with the
package.
"""

import codecs
import os
from importlib import resources
from typing import Any, TypeAlias

from ..errors import MissingExtraError, ParameterError

#: What says where a file is.
FilePath: TypeAlias = str | os.PathLike[str]
#: Bytes of a file that a user writes by hand, and of a table that an instrument writes.
BY_HAND, MEASURED = 1 << 20, 8 << 20


def contents(path: FilePath, largest: int = BY_HAND, what: str = "another file") -> bytes:
    """The bytes of a file, or of a pipe; a device without end, and a pipe that nobody writes to,
    end too.

    If there is no such file, or it holds more than ``largest`` bytes, that is a ParameterError.
    """
    name = os.fspath(path)
    shown = name if len(name) <= 200 else f"{name[:80]}…"
    if os.path.isdir(path):
        raise ParameterError(f"{shown} is a folder; give {what}")
    try:
        # A pipe that nobody writes to is at its end at once, if it is not waited for when it is
        # opened.
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
    """The text of a file in UTF-8, with a mark at its beginning or without, or in UTF-16 with one,
    as PowerShell writes it.

    Errors are those of :func:`contents`, and one for bytes that are no text.
    """
    data = contents(path, largest, what)
    try:
        return data.decode(
            "utf-16" if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)) else "utf-8-sig"
        )
    except UnicodeDecodeError as error:
        raise ParameterError(
            f"{os.fspath(path)} is not text in UTF-8 (byte {error.start}); save it as UTF-8{remedy}"
        ) from error


def shipped_text(package: str, name: str) -> str:
    """The text of a file that comes with a package."""
    return (resources.files(package) / name).read_text(encoding="utf-8")


def filled(package: str, name: str, what: str, **values: Any) -> str:
    """The template of this name with values in it, text escaped in HTML; ``what`` it is needs the
    extra ``plot``.
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
