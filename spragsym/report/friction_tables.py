"""A measured friction curve from a text file, and μ₀ and d fitted to it.

What the head of the file says of names, units and order is what is read, or it is refused.
"""

import csv
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..errors import ParameterError
from ..files.text import MEASURED, text_of
from ..generated import laws
from ..models.parameters import FloatArray
from ..models.units import factor
from ..results.result import Result

#: Names of the two columns, in small letters without hyphens; a name that is not here is that of another column.
SPEED = frozenset(
    (
        "v", "v rel", "v s", "v slip", "vrel", "vel", "velocity", "speed", "sliding speed", "sliding velocity", "slip speed",
        "slip velocity", "relative speed", "relative velocity", "geschwindigkeit", "gleitgeschwindigkeit",
        "relativgeschwindigkeit", "vitesse", "vitesse de glissement", "velocidad",
    )
)  # fmt: skip
FRICTION = frozenset(
    (
        "mu", "mu k", "muk", "mue",
        "friction", "friction coefficient", "coefficient of friction", "friction coeff", "coefficient", "cof",
        "reibwert", "reibzahl", "reibungszahl", "reibungskoeffizient", "reibkoeffizient", "frottement",
        "coefficient de frottement",
    )
)  # fmt: skip
#: Characters between columns; blanks last.
_BETWEEN = (";", "\t", ",", "|", " ")
_COMMENT = ("#", "%", "//")
#: Name and unit: v [m/s], v (m/s), v in m/s, v / (m/s), v/m/s, v_m/s, and v, m/s.
_HEAD = re.compile(
    r"(?P<name>[^\[\](/]*?)\s*(?:\[(?P<a>[^\[\]]*)\]|/?\s*\((?P<b>.*)\)|\s+in\s+(?P<c>\S+)|/\s*(?P<d>\S+)"
    r"|[_\s,]\s*(?P<e>[cdkmµμ]?m/(?:s|min|h)))?"
)
_NUMBER = re.compile(r"[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?")
#: A number with marks that stand before thousands only.
_GROUPED = re.compile(r"[+-]?\d{1,3}(?:['’\u202f\u00a0]\d{3})+(?:[.,]\d*)?")
#: A number whose mark may stand before thousands.
_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2}[.,]\d{3}")
#: A coefficient that is larger is in percent, or none.
_LARGEST = 2.0
#: A sliding speed in m/s that is smaller is none.
_SLOWEST = 1e-15
#: Lines of a file, and those among which its head is.
_LINES, _ABOVE = 20_000, 100
#: What a head looks like.
EXAMPLE = "v [m/s],mu"


class _RefusedError(Exception):
    """Why a file can't be read with one character between columns, on which line, and how far that came."""


def read_friction(path: Path) -> tuple[FloatArray, FloatArray]:
    """Sliding speeds in m/s and friction coefficients.

    The first line that is no comment names the columns in any order, with units, as in ``v [mm/s];mu``; units may stand in a line
    of their own below the names. Columns stand between semicolons, tabs, commas, bars or blanks, with a decimal point or comma.
    A ParameterError is raised for a file that has no such head, may be read in two ways, or has a line that is no measurement.
    """
    text = text_of(path, MEASURED, "a text file with sliding speed and coefficient").splitlines()
    stripped = ((number, line.strip(" \r\n")) for number, line in enumerate(text, 1))
    lines = [(number, line) for number, line in stripped if line.strip() and not line.strip().startswith(_COMMENT)]
    if len(lines) > _LINES:
        raise ParameterError(f"{path} has {len(lines)} lines, and at most {_LINES} are read; give every tenth or so")
    found, failures = set[tuple[tuple[float, float], ...]](), list[_RefusedError]()
    said = re.fullmatch(r"sep=(.)", lines[0][1]) if lines else None  # as spreadsheets write it
    for between in (said[1],) if said else _BETWEEN:
        try:
            found.add(tuple(_rows(lines[1:] if said else lines, between)))
        except _RefusedError as error:
            failures.append(error)
    if len(found) > 1:
        raise ParameterError(f"{path} may be read in two ways; put semicolons between the columns, and nowhere else")
    if not found:
        reason, line, _ = max((one.args for one in failures), key=lambda one: one[2])
        raise ParameterError(f"{path}{f', line {line}' if line else ''}: {reason}")
    (rows,) = found
    speed, friction = np.abs([row[0] for row in rows]), np.array([row[1] for row in rows])
    if len(set(speed[speed > 0].tolist())) < 2:
        few = f"{path} has {len(rows)} measurements"
        raise ParameterError(f"{few}; at least two at different sliding speeds are needed to fit mu0 and d")
    if not ((speed == 0) | ((speed > _SLOWEST) & (speed < 1 / _SLOWEST))).all():
        ends = f"{speed.min():g} to {speed.max():g} m/s"
        raise ParameterError(f"{path}: no sliding speeds are from {ends}; look at the unit in the head")
    if not friction.any():
        raise ParameterError(f"{path}: all coefficients are 0; without friction there is nothing to fit, so give mu0 = 0 and d")
    return speed, friction


def _rows(lines: Sequence[tuple[int, str]], between: str) -> Iterator[tuple[float, float]]:
    """Speed in m/s and coefficient of every line, if columns stand between these characters."""
    if not lines:
        raise _RefusedError(f"the file is empty; begin with a line of names and units such as {EXAMPLE}", 0, 0)
    cells, texts = [(number, _cells(line, between)) for number, line in lines], dict(lines)
    # Above the head may stand what a test rig says of itself.
    words = [{_word(name) for name in row} for _, row in cells[:_ABOVE]]
    begin = next((at for at, row in enumerate(words) if row & SPEED and row & FRICTION), 0)
    (number, names), *data = cells[begin:]
    if any(_NUMBER.fullmatch(name) for name in names):
        said = "this is no head: it does not say which column is which, and in what unit"
        raise _RefusedError(f"{said}; put a line such as {EXAMPLE} above it", number, 3)
    units = [""] * len(names)
    if data and len(data[0][1]) == len(names) and not any(_NUMBER.match(cell) for cell in data[0][1] if cell not in ("1", "")):
        units, data = [cell.strip("[]()") for cell in data[0][1]], data[1:]
    speed, friction = _column(names, units, SPEED, "m/s", number), _column(names, units, FRICTION, "1", number)
    used = []
    for number, row in data:
        if len(row) < len(names) or any(row[len(names) :]):
            said = f"{texts[number]!r} has {len(row)} columns, and the head has {len(names)}"
            raise _RefusedError(f"{said}; give every column a name, and put semicolons between them", number, 3)
        used += [row[speed[0]], row[friction[0]]]
        for cell in used[-2:]:
            if not _NUMBER.fullmatch(cell) or not math.isfinite(float(cell.replace(",", "."))):
                said = f"{texts[number]!r} is not a sliding speed and a coefficient"
                raise _RefusedError(f"{said}, such as 0.5;0.41 or 0,5;0,41", number, 4)
    marks = {mark for mark in ".," for cell in used if mark in cell}
    if len(marks) > 1 or any(all(_THOUSANDS.fullmatch(cell) for cell in used if mark in cell) for mark in marks):
        said = "points and commas may stand before decimals or thousands; write all numbers with a decimal point"
        raise _RefusedError(f"{said}, such as 1500 and 1.50", data[0][0], 5)
    for number, row in data:
        at, value = (one[1] * float(row[one[0]].replace(",", ".")) for one in (speed, friction))
        if value < 0:
            raise _RefusedError(f"{texts[number]!r}: the coefficient {value:g} is negative; give its size", number, 6)
        if value > _LARGEST:
            cure = "write mu [%] in the head if it is in percent"
            raise _RefusedError(f"{texts[number]!r}: the coefficient {value:g} is more than any brake has; {cure}", number, 6)
        yield at, value


def _cells(line: str, between: str) -> list[str]:
    if between != " ":
        try:
            return [_number(cell.strip(" \t\"'")) for cell in next(csv.reader([line], delimiter=between, skipinitialspace=True))]
        except csv.Error as error:
            raise _RefusedError(f"a line of {len(line)} characters is too long ({error}); write one a line", 0, 0) from error
    # Blanks in a row are one: patterns go back over each of them.
    together = re.sub(r" in (\S+)", r"[\1]", re.sub(r" (?=[\[(])", "", " ".join(line.split())))
    return [_number(cell.strip("\"'")) for cell in together.split()]


def _word(name: str) -> str:
    """What a column is called: small letters, without its unit and without a symbol behind its name."""
    parts = _HEAD.fullmatch(" ".join(name.split()))
    word = re.sub(r"[\s_\-.]+", " ", parts["name"] if parts else name).strip().lower()
    word = re.sub("[\N{MICRO SIGN}\N{GREEK SMALL LETTER MU}]", "mu", word)
    first, _, last = word.rpartition(" ")
    return first if any({first, last} <= known for known in (SPEED, FRICTION)) else word


def _number(cell: str) -> str:
    """A cell; of a number with a minus of print, groups of thousands or Fortran's exponent, as Python writes it."""
    text = cell.replace("\N{MINUS SIGN}", "-")
    text = re.sub(r"['’\u202f\u00a0]", "", text) if _GROUPED.fullmatch(text) else text
    return re.sub(r"^([+-]?[\d.,]+)[dD]([+-]?\d+)$", r"\1e\2", text)


def _column(names: Sequence[str], units: Sequence[str], known: frozenset[str], si: str, line: int) -> tuple[int, float]:
    """Which column has one of these names, and what its unit is in SI."""
    what, write = ("the sliding speed", "v [m/s]") if si == "m/s" else ("the friction coefficient", "mu")
    found = [i for i, name in enumerate(names) if _word(name) in known]
    if len(found) != 1:
        several = f"is named {len(found)} times" if found else "is not among the names"
        raise _RefusedError(f"{what} {several}; name one column {write}, as in {EXAMPLE}", line, 1)
    (i,), name, below = found, names[found[0]], units[found[0]]
    parts = _HEAD.fullmatch(" ".join(name.split()))
    given = next((part for part in parts.group("a", "b", "c", "d", "e") if part is not None), "") if parts else ""
    if given and below:
        raise _RefusedError(f"{name!r} has a unit, and the line below gives {below!r}; give one of them", line, 2)
    unit = (given or below).strip()
    if not unit and si == "m/s":
        raise _RefusedError(f"{name!r} has no unit; write it in brackets behind the name, as in v [m/s] or v [mm/s]", line, 2)
    try:
        return i, factor("" if si == "1" and unit in ("-", "–", "1") else unit, si)
    except ParameterError as error:
        raise _RefusedError(f"{name!r}: {error}; write {'v [m/s]' if si == 'm/s' else 'mu or mu [%]'}", line, 2) from error


@dataclass(frozen=True)
class FrictionFit(Result):
    """μ₀ and d of the law μ₀ (1 − exp(−d \\|v\\|)) by least squares, with their standard errors and the rms of what is left.

    ``correlation`` is that of the two errors: a larger μ₀ with a smaller d may fit as well.

    ``slowest`` and ``fastest`` are the smallest and the largest sliding speed that was measured, in m/s.
    """

    mu0: float
    d: float
    mu0_error: float
    d_error: float
    correlation: float
    rms: float
    points: int
    slowest: float
    fastest: float


def fit_friction(speed: FloatArray, friction: FloatArray) -> FrictionFit:
    """μ₀ and d by least squares; for each d the best μ₀ is linear, so that one search over d finds the best of all.

    Source: the regularized law (10) at steady sliding.

    >>> speed = np.array([0.05, 0.1, 0.3, 1.0])
    >>> found = fit_friction(speed, 0.4 * (1 - np.exp(-10 * speed)))
    >>> round(found.mu0, 9), round(found.d, 7)
    (0.4, 10.0)
    """
    from scipy.optimize import minimize_scalar

    moving = speed[speed > 0]

    def shape(d: float) -> FloatArray:
        return np.asarray(laws.friction(0.0, 1.0, speed, d))

    def best(log_d: float) -> tuple[float, float]:
        """μ₀, and the sum of squares that it leaves."""
        rise = shape(math.exp(log_d))
        mu0 = float(rise @ friction / (rise @ rise))
        return mu0, float(((friction - mu0 * rise) ** 2).sum())

    # Beyond these the law is a straight line in v, or a constant, at every speed that was measured.
    grid = np.linspace(math.log(1e-4 / moving.max()), math.log(40.0 / moving.min()), 400)
    k = int(np.argmin([best(value)[1] for value in grid]))
    ends = grid[max(k - 1, 0)], grid[min(k + 1, grid.size - 1)]
    found = minimize_scalar(lambda log_d: best(log_d)[1], bounds=ends, method="bounded", options={"xatol": 1e-12})
    d, (mu0, left) = math.exp(float(found.x)), best(float(found.x))
    spread = math.sqrt(left / max(speed.size - 2, 1))
    slopes = np.stack([shape(d), mu0 * speed * np.exp(-d * speed)], axis=1)
    covariance = np.linalg.pinv(slopes.T @ slopes)
    sizes = np.sqrt(np.abs(np.diag(covariance)))
    return FrictionFit(
        mu0=mu0, d=d, mu0_error=float(spread * sizes[0]), d_error=float(spread * sizes[1]),
        correlation=float(np.clip(covariance[0, 1] / max(sizes.prod(), 1e-300), -1.0, 1.0)), rms=spread, points=speed.size,
        slowest=float(moving.min()), fastest=float(speed.max()),
    )  # fmt: skip
