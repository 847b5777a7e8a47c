"""A measured friction curve: sliding speed and coefficient, read from a table of text."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from ..core.errors import ParameterError
from ..files.text import text_of
from ..models.parameters import FloatArray, Span
from ..models.quantities import factor

#: Names of the two columns, in small letters without hyphens; a name that is not here is that of
#: another column.
SPEED = frozenset(
    (
        "v",
        "v rel",
        "v s",
        "v slip",
        "vrel",
        "vel",
        "velocity",
        "speed",
        "sliding speed",
        "sliding velocity",
        "slip speed",
        "slip velocity",
        "relative speed",
        "relative velocity",
        "geschwindigkeit",
        "gleitgeschwindigkeit",
        "relativgeschwindigkeit",
        "vitesse",
        "vitesse de glissement",
        "velocidad",
    )
)
FRICTION = frozenset(
    (
        "mu",
        "mu k",
        "muk",
        "mue",
        "friction",
        "friction coefficient",
        "coefficient of friction",
        "friction coeff",
        "coefficient",
        "cof",
        "reibwert",
        "reibzahl",
        "reibungszahl",
        "reibungskoeffizient",
        "reibkoeffizient",
        "frottement",
        "coefficient de frottement",
    )
)
#: Name and unit: v [m/s], v (m/s), v in m/s, v / (m/s), v/m/s, v_m/s, and v, m/s.
_HEAD = re.compile(
    r"(?P<name>[^\[\](/]*?)\s*(?:\[(?P<a>[^\[\]]*)\]|/?\s*\((?P<b>.*)\)|\s+in\s+(?P<c>\S+)"
    r"|/\s*(?P<d>\S+)|[_\s,]\s*(?P<e>[cdkmµμ]?m/(?:s|min|h)))?"
)
#: What a head looks like.
EXAMPLE = "v [m/s],mu"


class _RefusedError(Exception):
    """Why a file can't be read with one character between columns, on which line, and how far that
    came.
    """


def read_friction(path: Path) -> tuple[FloatArray, FloatArray]:
    """Sliding speeds in m/s and friction coefficients.

    The first line that is no comment names the columns in any order, with units, as in
    ``v [mm/s];mu``; units may stand in a line of their own below the names. Columns stand between
    semicolons, tabs, commas, bars or blanks, with a decimal point or comma. A ParameterError is
    raised for a file that has no such head, may be read in two ways, or has a line that is no
    measurement.
    """
    # Bytes of a file, at most: an instrument writes more than a person does.
    most = 8 * 2**20
    text = text_of(path, most, "a text file with sliding speed and coefficient").splitlines()
    stripped = ((number, line.strip(" \r\n")) for number, line in enumerate(text, 1))
    lines = [
        (number, line)
        for number, line in stripped
        if line.strip() and not line.strip().startswith(("#", "%", "//"))
    ]
    # Lines of a file, at most.
    most_lines = 20_000
    if len(lines) > most_lines:
        raise ParameterError(
            f"{path} has {len(lines)} lines, and at most {most_lines} are read; give every tenth "
            "or so"
        )
    found, failures = set[tuple[Span, ...]](), list[_RefusedError]()
    said = re.fullmatch(r"sep=(.)", lines[0][1]) if lines else None  # as spreadsheets write it
    # Characters between columns; blanks last.
    for between in (said[1],) if said else (";", "\t", ",", "|", " "):
        try:
            found.add(tuple(_rows(lines[1:] if said else lines, between)))
        except _RefusedError as error:
            failures.append(error)
    if len(found) > 1:
        raise ParameterError(
            f"{path} may be read in two ways; put semicolons between the columns, and nowhere else"
        )
    if not found:
        reason, line, _ = max((one.args for one in failures), key=lambda one: one[2])
        raise ParameterError(f"{path}{f', line {line}' if line else ''}: {reason}")
    (rows,) = found
    speed, friction = np.abs([*zip(*rows, strict=True)] or [(), ()])
    if len(set(speed[speed > 0].tolist())) < 2:
        few = f"{path} has {len(rows)} measurements"
        raise ParameterError(
            f"{few}; at least two at different sliding speeds are needed to fit mu0 and d"
        )
    # A sliding speed in m/s that is smaller is none.
    slowest = 1e-15
    if not ((speed == 0) | ((speed > slowest) & (speed < 1 / slowest))).all():
        ends = f"{speed.min():g} to {speed.max():g} m/s"
        raise ParameterError(
            f"{path}: no sliding speeds are from {ends}; look at the unit in the head"
        )
    if not friction.any():
        raise ParameterError(
            f"{path}: all coefficients are 0; without friction there is nothing to fit, so "
            "give mu0 = 0 and d"
        )
    return speed, friction


def _rows(lines: Sequence[tuple[int, str]], between: str) -> Iterator[Span]:
    """Speed in m/s and coefficient of every line, if columns stand between these characters."""
    if not lines:
        raise _RefusedError(
            f"the file is empty; begin with a line of names and units such as {EXAMPLE}", 0, 0
        )
    cells, texts = [(number, _cells(line, between)) for number, line in lines], dict(lines)
    # Above the head may stand what a test rig says of itself.
    # The head of a table is looked for in so many lines.
    words = [{_word(name) for name in row} for _, row in cells[:100]]
    begin = next((at for at, row in enumerate(words) if row & SPEED and row & FRICTION), 0)
    (number, names), *data = cells[begin:]
    a_number = re.compile(r"[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?")
    if any(a_number.fullmatch(name) for name in names):
        said = "this is no head: it does not say which column is which, and in what unit"
        raise _RefusedError(f"{said}; put a line such as {EXAMPLE} above it", number, 3)
    units = [""] * len(names)
    if (
        data
        and len(data[0][1]) == len(names)
        and not any(a_number.match(cell) for cell in data[0][1] if cell not in ("1", ""))
    ):
        units, data = [cell.strip("[]()") for cell in data[0][1]], data[1:]
    speed = _column(names, units, SPEED, "m/s", number)
    friction = _column(names, units, FRICTION, "1", number)
    used = []
    for number, row in data:
        if len(row) < len(names) or any(row[len(names) :]):
            said = f"{texts[number]!r} has {len(row)} columns, and the head has {len(names)}"
            raise _RefusedError(
                f"{said}; give every column a name, and put semicolons between them", number, 3
            )
        used += [row[speed[0]], row[friction[0]]]
        for cell in used[-2:]:
            if not a_number.fullmatch(cell) or not math.isfinite(float(cell.replace(",", "."))):
                said = f"{texts[number]!r} is not a sliding speed and a coefficient"
                raise _RefusedError(f"{said}, such as 0.5;0.41 or 0,5;0,41", number, 4)
    marks = {mark for mark in ".," for cell in used if mark in cell}
    # A number whose mark may stand before thousands.
    thousands = re.compile(r"[+-]?[1-9]\d{0,2}[.,]\d{3}")
    if len(marks) > 1 or any(
        all(thousands.fullmatch(cell) for cell in used if mark in cell) for mark in marks
    ):
        said = (
            "points and commas may stand before decimals or thousands; write all numbers with a "
            "decimal point"
        )
        raise _RefusedError(f"{said}, such as 1500 and 1.50", data[0][0], 5)
    for number, row in data:
        at, value = (one[1] * float(row[one[0]].replace(",", ".")) for one in (speed, friction))
        if value < 0:
            raise _RefusedError(
                f"{texts[number]!r}: the coefficient {value:g} is negative; give its size",
                number,
                6,
            )
        # A coefficient that is larger is in percent, or none.
        if value > 2.0:
            cure = "write mu [%] in the head if it is in percent"
            raise _RefusedError(
                f"{texts[number]!r}: the coefficient {value:g} is more than any brake has; {cure}",
                number,
                6,
            )
        yield at, value


def _cells(line: str, between: str) -> list[str]:
    if between != " ":
        try:
            return [
                _number(cell.strip(" \t\"'"))
                for cell in next(csv.reader([line], delimiter=between, skipinitialspace=True))
            ]
        except csv.Error as error:
            raise _RefusedError(
                f"a line of {len(line)} characters is too long ({error}); write one a line", 0, 0
            ) from error
    # Blanks in a row are one: patterns go back over each of them.
    together = re.sub(r" in (\S+)", r"[\1]", re.sub(r" (?=[\[(])", "", " ".join(line.split())))
    return [_number(cell.strip("\"'")) for cell in together.split()]


def _word(name: str) -> str:
    """Name of a column: small letters, without its unit and without a symbol behind its name."""
    parts = _HEAD.fullmatch(" ".join(name.split()))
    word = re.sub(r"[\s_\-.]+", " ", parts["name"] if parts else name).strip().lower()
    word = re.sub("[\N{MICRO SIGN}\N{GREEK SMALL LETTER MU}]", "mu", word)
    first, _, last = word.rpartition(" ")
    return first if any({first, last} <= words for words in (SPEED, FRICTION)) else word


def _number(cell: str) -> str:
    """A cell; of a number with a minus of print, groups of thousands or Fortran's exponent, as
    Python writes it.
    """
    text = cell.replace("\N{MINUS SIGN}", "-")
    # A number with marks that stand before thousands only.
    grouped = re.compile(r"[+-]?\d{1,3}(?:['’\u202f\u00a0]\d{3})+(?:[.,]\d*)?")
    text = re.sub(r"['’\u202f\u00a0]", "", text) if grouped.fullmatch(text) else text
    return re.sub(r"^([+-]?[\d.,]+)[dD]([+-]?\d+)$", r"\1e\2", text)


def _column(
    names: Sequence[str], units: Sequence[str], words: frozenset[str], si: str, line: int
) -> tuple[int, float]:
    """Column that has one of these names, and the size of its unit in SI."""
    what, write = (
        ("the sliding speed", "v [m/s]")
        if si == "m/s"
        else ("the friction coefficient", "mu or mu [%]")
    )
    found = [i for i, name in enumerate(names) if _word(name) in words]
    if len(found) != 1:
        several = f"is named {len(found)} times" if found else "is not among the names"
        raise _RefusedError(f"{what} {several}; name one column {write}, as in {EXAMPLE}", line, 1)
    (i,), name, below = found, names[found[0]], units[found[0]]
    parts = _HEAD.fullmatch(" ".join(name.split()))
    given = parts[parts.lastindex or 0] if parts and parts.lastgroup != "name" else ""
    if given and below:
        raise _RefusedError(
            f"{name!r} has a unit, and the line below gives {below!r}; give one of them", line, 2
        )
    unit = (given or below).strip()
    if not unit and si == "m/s":
        raise _RefusedError(
            f"{name!r} has no unit; write it in brackets behind the name, as in v [m/s] or v "
            "[mm/s]",
            line,
            2,
        )
    try:
        return i, factor("" if si == "1" and unit in ("-", "–", "1") else unit, si)
    except ParameterError as error:
        raise _RefusedError(f"{name!r}: {error}; write {write}", line, 2) from error
