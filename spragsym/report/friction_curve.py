"""Measured friction curves, sliding speed and friction coefficient, from text files."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ..core.errors import ParameterError
from ..files.text import text_of
from ..models.parameters import FloatArray
from ..models.quantities import factor

#: Names of the two columns by unit, in lower case and without hyphens. Other columns are ignored.
NAMES = {
    "m/s": (
        "v",
        "v rel",
        "v slip",
        "velocity",
        "speed",
        "sliding speed",
        "sliding velocity",
        "slip speed",
        "slip velocity",
        "relative speed",
        "relative velocity",
    ),
    "1": (
        "mu",
        "mu k",
        "friction",
        "friction coefficient",
        "coefficient of friction",
        "coefficient",
        "cof",
    ),
}
#: Example of a header.
EXAMPLE = "v [m/s],mu"


def read_friction(path: Path) -> tuple[FloatArray, FloatArray]:
    """Sliding speeds in m/s and friction coefficients.

    The header, which is the first line that is no comment, names the columns in any order, with
    units in brackets, as in ``v [mm/s];mu``. The separator is the first of semicolon, tab, bar,
    comma and blank that the header contains. Numbers have a decimal point or a decimal comma. A
    ParameterError is raised for a file without such a header, an ambiguous one, or one with a line
    that is no measurement.
    """
    # Maximum size of a file in bytes.
    most = 8 * 2**20
    text = text_of(path, most, "a text file with sliding speed and coefficient").splitlines()
    lines = [
        (number, line.strip(" "))
        for number, line in enumerate(text, 1)
        if line.strip() and not line.strip().startswith(("#", "%", "//"))
    ]
    most_lines = 20_000
    if len(lines) > most_lines:
        raise ParameterError(
            f"{path} has {len(lines)} lines, and at most {most_lines} are read; give every tenth "
            "or so"
        )
    if not lines:
        raise ParameterError(
            f"{path}: the file is empty; begin with a line of names and units such as {EXAMPLE}"
        )
    measured = _measurements(path, lines)
    speed, friction = np.abs(measured).reshape(-1, 2).T
    if len(set(speed[speed > 0].tolist())) < 2:
        raise ParameterError(
            f"{path} has {len(measured)} measurements; at least two at different sliding speeds "
            "are needed to fit mu0 and d"
        )
    # Smaller speeds in m/s, and larger ones than its inverse, are mistakes.
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


def _measurements(path: Path, lines: Sequence[tuple[int, str]]) -> list[tuple[float, float]]:
    """Speed in m/s and friction coefficient of each line."""
    (first, head), *data = lines
    between = separator(head, " ")
    if between == " ":
        head = re.sub(r"\s+(?=[\[(])", "", head)
    names = cells(head, between)
    a_number = re.compile(r"[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?")
    if any(map(a_number.fullmatch, names)):
        raise ParameterError(
            f"{path}, line {first}: this is no head: it does not say which column is which, and "
            f"in what unit; put a line such as {EXAMPLE} above it"
        )
    at = f"{path}, line {first}"
    speed, friction = _column(at, names, "m/s"), _column(at, names, "1")
    found, written = list[tuple[float, float]](), list[str]()
    for number, line in data:
        row = cells(line, between)
        at = f"{path}, line {number}: {line[:80]!r}"
        if len(row) < len(names) or any(row[len(names) :]):
            raise ParameterError(
                f"{at} has {len(row)} columns, and the head has {len(names)}; give every column a "
                "name, and put semicolons between them"
            )
        pair = [row[speed[0]], row[friction[0]]]
        numbers = [
            float(cell.replace(",", ".")) if a_number.fullmatch(cell) else math.nan for cell in pair
        ]
        if not np.isfinite(numbers).all():
            raise ParameterError(
                f"{at} is not a sliding speed and a coefficient, such as 0.5;0.41 or 0,5;0,41"
            )
        v, mu = numbers[0] * speed[1], numbers[1] * friction[1]
        if mu < 0:
            raise ParameterError(f"{at}: the coefficient {mu:g} is negative; give its size")
        # A larger coefficient is in percent, or a mistake.
        if mu > 2.0:
            raise ParameterError(
                f"{at}: the coefficient {mu:g} is more than any brake has; write mu [%] in the "
                "head if it is in percent"
            )
        found.append((v, mu))
        written += pair
    _check_marks(f"{path}, line {data[0][0]}" if data else "", written)
    return found


def _check_marks(at: str, written: Sequence[str]) -> None:
    """Raise if points or commas in the numbers may be thousands separators."""
    marks = {mark for mark in ".," for cell in written if mark in cell}
    thousands = re.compile(r"[+-]?[1-9]\d{0,2}[.,]\d{3}")
    if len(marks) > 1 or any(
        all(thousands.fullmatch(cell) for cell in written if mark in cell) for mark in marks
    ):
        raise ParameterError(
            f"{at}: points and commas may stand before decimals or thousands; write all numbers "
            "with a decimal point, such as 1500 and 1.50"
        )


def separator(head: str, usual: str) -> str:
    """What stands between cells: the first of semicolon, tab, bar and comma in the head."""
    return next((mark for mark in ";\t|," if mark in head), usual)


def cells(line: str, between: str) -> list[str]:
    """Cells of a line, without blanks and quotes."""
    try:
        row = next(csv.reader([line], delimiter=between, skipinitialspace=True))
    except csv.Error as error:
        raise ParameterError(
            f"a line of {len(line)} characters is too long ({error}); write one a line"
        ) from error
    return [cell.strip(" \t\"'").replace("\N{MINUS SIGN}", "-") for cell in row]


def _column(at: str, names: Sequence[str], si: str) -> tuple[int, float]:
    """Index of the column in a unit, and the factor from the unit in the head to it."""
    what, write = ("the friction coefficient", "mu or mu [%]")
    if si == "m/s":
        what, write = ("the sliding speed", "v [m/s]")
    parts = [re.fullmatch(r"([^\[(]*)(?:[\[(](.*)[\])])?", name) for name in names]
    units = {
        i: (part[2] or "").strip()
        for i, part in enumerate(parts)
        if part and _word(part[1]) in NAMES[si]
    }
    if len(units) != 1:
        several = f"is named {len(units)} times" if units else "is not among the names"
        raise ParameterError(f"{at}: {what} {several}; name one column {write}, as in {EXAMPLE}")
    ((i, unit),) = units.items()
    if not unit and si == "m/s":
        raise ParameterError(
            f"{at}: {names[i]!r} has no unit; write it in brackets behind the name, as in v [m/s] "
            "or v [mm/s]"
        )
    try:
        return i, factor("" if si == "1" and unit in ("-", "–", "1") else unit, si)
    except ParameterError as error:
        raise ParameterError(f"{at}: {names[i]!r}: {error}; write {write}") from error


def _word(name: str) -> str:
    """Name of a column in lower case, without hyphens and similar characters; "mu" for μ."""
    word = re.sub("[\N{MICRO SIGN}\N{GREEK SMALL LETTER MU}]", "mu", name)
    return re.sub(r"[\s_\-./]+", " ", word).strip().lower()
