"""The reader of everything foreign: bytes, text, TOML and JSON, of bounded size, depth and digits,
of checked characters; and texts of the package's own files.
"""

from __future__ import annotations

import codecs
import json
import math
import os
import re
import select
import stat
import tomllib
from collections.abc import Callable, Mapping
from importlib import resources
from types import UnionType
from typing import Any, TypeAlias

from ..core.errors import MissingExtraError, ParameterError, ParameterTypeError
from ..core.shown import unprinted
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
        If there is no such file, it is a pipe into which nothing comes, or it holds more than
        ``largest`` bytes.
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
        with open(number, "rb") as file:
            about = os.fstat(number)
            if os.name == "posix" and not stat.S_ISREG(about.st_mode):
                largest = min(largest, 1 << 26)
                data = _piped(number, largest)
            else:
                data = file.read(largest + 1) if about.st_size <= largest else b""
    except ValueError as error:  # a NUL in a name
        raise ParameterError(
            f"{shown!r} can't be the name of a file: {error}; give {what}"
        ) from error
    except OSError as error:
        raise ParameterError(f"{shown} can't be read: {error.strerror}; give {what}") from error
    if max(len(data), about.st_size) > largest:
        raise ParameterError(f"{shown} has more than {largest} bytes; give {what}")
    return data


def _piped(number: int, largest: int) -> bytes:
    """What comes out of a pipe or a device, which do not block: one byte more than ``largest`` at
    most.

    Raises
    ------
    TimeoutError
        If nothing comes for ten seconds.
    """
    data = b""
    while len(data) <= largest:
        try:
            part = os.read(number, largest + 1 - len(data))
        except BlockingIOError:
            if not select.select([number], [], [], 10.0)[0]:
                raise TimeoutError(0, "nothing comes into this pipe") from None
            continue
        if not part:
            break
        data += part
    return data


def text_of(
    path: FilePath,
    largest: int = BY_HAND,
    what: str = "another file",
    remedy: str = "",
    may_hold: str | None = "\n\r\t",
) -> str:
    """The text of a file in UTF-8, with or without byte order mark, or in UTF-16 with one, as
    PowerShell writes it.

    ``may_hold`` are the characters it may hold that are not printed; None for all, in a text that
    is only shown through ``core.shown``. Errors are those of :func:`contents`, and a ParameterError
    for other bytes.
    """
    data = contents(path, largest, what)
    is_utf16 = data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    try:
        text = data.decode("utf-16" if is_utf16 else "utf-8-sig")
    except UnicodeDecodeError as error:
        raise ParameterError(
            f"{os.fspath(path)} is not text in UTF-8 (byte {error.start}); save it as UTF-8{remedy}"
        ) from error

    return text if may_hold is None else printed(path_text(path), text, allowed=may_hold)


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
        for one in unprinted({*held} - {*allowed}):
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


#: Levels of tables and lists in foreign data.
DEEPEST = 100
#: A type, or several; one for all parts of a list, or one for each; those of names in a table.
Shape: TypeAlias = "type | UnionType | list[Shape] | tuple[Shape, ...] | dict[str, Shape]"


def toml_of(text: str) -> dict[str, Any]:
    """The data of a text in TOML.

    Raises
    ------
    ValueError
        If it is none, or has deeper tables or longer numbers than data have.
    """
    part = (
        r"""(?:[\w-]+|"[^"\n]*"|'[^'\n]*')[ \t]*\.[ \t]*"""  # tomllib takes a key's length squared
    )
    if found := re.search(rf"(?<![\w-])(?:{part}){{{DEEPEST}}}", text):
        line = text[: found.start()].count("\n") + 1
        raise ValueError(f"a key has more than {DEEPEST} parts (at line {line}, column 1)")
    try:
        return _bounded(tomllib.loads(text, parse_float=_float))
    except RecursionError as error:
        raise ValueError(f"it has more than {DEEPEST} levels") from error


def json_of(text: str | bytes, made_of: Callable[[dict[str, Any]], object] | None = None) -> Any:
    """The data of a text in JSON, or what ``made_of`` makes of its tables; errors as of
    :func:`toml_of`.
    """
    try:
        return _bounded(json.loads(text, parse_float=_float, object_hook=made_of))
    except RecursionError as error:
        raise ValueError(f"it has more than {DEEPEST} levels") from error


def _float(text: str) -> float:
    """A number in double precision, which neither overflows nor vanishes."""
    value, mantissa = float(text), re.split("[eE]", text)[0]
    if math.isinf(value) * ("n" not in mantissa) or (value == 0 and re.search("[1-9]", mantissa)):
        raise ValueError(f"the number {text:.40} is beyond double precision")
    return value


def _bounded(data: T) -> T:
    """Return data if they have few levels."""
    level: list[object] = [data]
    for _ in range(DEEPEST):
        level = [
            part
            for held in level
            if isinstance(held, dict | list)
            for part in (held.values() if isinstance(held, dict) else held)
        ]
        if not level:
            return data
    raise ValueError(f"it has more than {DEEPEST} levels")


def has_shape(held: object, shape: Shape) -> bool:
    """Whether data have a structure; True and False are no numbers.

    >>> has_shape([1, ["a"]], (int, [str])), has_shape({"a": 1}, {"a": str})
    (True, False)
    """
    match shape:
        case dict():
            return isinstance(held, dict) and all(
                name in held and has_shape(held[name], part) for name, part in shape.items()
            )
        case list():
            return isinstance(held, list) and all(has_shape(part, shape[0]) for part in held)
        case tuple():
            return (
                isinstance(held, list)
                and len(held) == len(shape)
                and all(map(has_shape, held, shape))
            )
    return isinstance(held, shape) and (shape is bool or not isinstance(held, bool))


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
