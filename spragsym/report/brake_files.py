"""``brake.toml``: the data of a brake with units and tolerances, read with an error for every
mistake that says where it is.

So is the measured friction curve that it may name, to which μ₀ and d are fitted: what the head of
that file says of names, units and order is what is read, or it is refused.
"""

from __future__ import annotations

import csv
import json
import math
import os
import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..design.sampling import Correlation, dependence
from ..errors import ParameterError, SpragsymError, hint
from ..files.text import MEASURED, FilePath, shipped_text, text_of
from ..generated import laws
from ..models import Model
from ..models.load import USUAL, shipped
from ..models.parameters import FINITE, FloatArray, Range, Ranges, Span
from ..models.quantities import Quantities, factor, quantities
from ..results import Result
from .study import PLAIN_UNITS, Rise, Study, rise_of, spanned
from .units import ENDS, EXAMPLES, WITHIN, Measured, Numbers, read, remedy

#: Quantities that are not of the size that others of the same unit have.
_EXAMPLES: Mapping[str, str] = {"k_x": "9 N/mm", "k_y": "0 N/mm", "k_c": "1500 N/mm"}
#: Of a file to begin with: what one of a unit of measure is, by its unit in SI, and tolerances.
_SIZES = {"kg": 0.35, "N/m": 1.5e6, "m": 0.038, "N": 400.0, "N/m^(3/2)": 8e6}
_TOLERANCES = {"k": " +- 10 %", "k_t": " +- 10 %", "theta0": " +- 1 deg", "mu0": " +- 10 %"}
#: A speed in m/s that no belt of a brake has, as the unit of a model may be; then speeds are those
#: of the examples.
_FASTEST = 10.0
#: Keys of a file that are no quantities.
_KEYS = (
    "friction",
    "correlation",
    "model",
    "vary",
    "begin",
    "state",
    "may_change",
    "title",
    "date",
)


def read_brake(path: FilePath, trust: bool | str = False) -> Study:
    """The data of a brake from a TOML file with one table, ``[brake]``.

    For each quantity it has a text with number, unit and, if there is one, a tolerance;
    ``correlation = [["k", "k_x", 0.9]]`` for quantities that vary together; ``vary = "F_L"`` where
    not the friction but a quantity rises until the state jumps, with ``begin = "10 N"`` if not from
    its least value; and ``state = { phi = "-28 deg" }`` where another state than the reference
    state is followed; ``may_change = { k = "[100, 250] N/mm" }`` where a proposal may change these
    only, within these ends; ``title = "Front brake"`` and ``date = 2026-03-01`` for the head of the
    report. ``trust`` says whether the code of a model's folder may run that the file names, or the
    one folder whose code may. Every mistake is a ParameterError that names the file, the line, the
    key, the value and what to write.
    """
    return _Reader(
        os.fspath(path),
        text_of(path, what="a file such as brake.toml", remedy=", or write +- for ±"),
    ).read(trust)


def example_of(key: str, unit: str) -> str:
    """How an engineer would write a quantity."""
    return _EXAMPLES.get(key) or EXAMPLES.get(unit, (f"1 {unit}",))[0]


class _Reader:
    """The text of a file; mistakes in it are told with the line on which their key stands."""

    def __init__(self, path: str, text: str) -> None:
        self.path, self.text, self.lines = path, text, text.splitlines()

    def of(self, key: str, pattern: str = r"""\s*(?:brake\s*\.\s*)?["']?{}["']?\s*=""") -> str:
        """The line of a key."""
        found = (
            number
            for number, line in enumerate(self.lines, 1)
            if re.match(pattern.format(re.escape(key)), line)
        )
        number = next(found, None)
        return f"{self.path}, line {number}" if number else self.path

    def table(self, name: str) -> str:
        """The line of a table."""
        return self.of(name, r"""\s*\[\s*["']?{}["']?\s*\]""")

    @contextmanager
    def at(self, key: str, before: str = "") -> Iterator[None]:
        """A mistake in the value of a key is told with its line."""
        try:
            yield
        except SpragsymError as error:
            raise ParameterError(f"{self.of(key)}: {before}{error}") from error

    def read(self, trust: bool | str) -> Study:
        table = self._table()
        with self.at("model", "model = "):
            model = _model(table.pop("model", USUAL), trust)
        kind = quantities(model)
        own = {key: table.pop(key, None) for key in _KEYS}
        ranges, found = kind.ranges(), dict[str, Measured]()
        for key, value in table.items():
            with self.at(key):
                if key not in kind.units:
                    known = [*kind.units, *_KEYS]
                    remark = hint(key, known) or f"; the keys are {', '.join(known)}"
                    raise ParameterError(
                        f"{key} = {value!r} is not a quantity of the model {model}{remark}"
                    )
                found[key] = _quantity(key, value, kind.units[key], ranges[key])
        with self.at("friction", f"friction = {own['friction']!r}: "):
            fit = None if own["friction"] is None else self._friction(own["friction"], found, kind)
        missing = [key for key in kind.units if key not in found and key not in kind.of_the_law]
        if missing:
            wanted = ", ".join(f'{key} = "{example_of(key, kind.units[key])}"' for key in missing)
            raise ParameterError(
                f"{self.table('brake')}: [brake] is without {', '.join(missing)}; add lines "
                f"such as {wanted}"
            )
        study = Study.of(
            quantities={key: found[key] for key in kind.units if key in found},
            model=model,
            source=Path(self.path).name,
            fit=fit,
            title=str(own["title"] or ""),
            date=str(own["date"] or ""),
        )
        with self.at("correlation"):
            study.correlation = _correlation(own["correlation"], study)
        with self.at("state"):
            study.state = _state(own["state"] or {}, kind)
        with self.at("may_change"):
            study.may_change = _may_change(own["may_change"] or {}, kind)
        with self.at("vary" if own["begin"] is None else "begin"):
            study.rise = _rise(own["vary"], own["begin"], study)
        return study

    def _table(self) -> dict[str, Any]:
        try:
            content = tomllib.loads(self.text)
        except (
            ValueError,
            RecursionError,
        ) as error:  # TOML that is none, and numbers that are too long
            raise ParameterError(self._syntax(str(error))) from error
        if not content:
            raise ParameterError(
                f"{self.path} is empty: [brake] is missing; begin with a line [brake]"
            )
        other = next((name for name in content if name != "brake"), "brake")
        table, held = content.get("brake"), content[other]
        if isinstance(table, dict) and other == "brake":
            return table
        where = self.table(other) if isinstance(held, dict) else self.of(other)
        missing = (
            "" if isinstance(table, dict) else f", and [brake] is missing{hint(other, ['brake'])}"
        )
        raise ParameterError(
            f"{where}: {other!r} does not belong here{missing}; all keys go below one line [brake]"
        )

    def _syntax(self, message: str) -> str:
        """What tomllib says, with the line before it and how a line is written."""
        found = re.search(r" \(at line (\d+), column \d+\)", message)  # else at the end
        number = int(found[1]) if found else len(self.lines)
        line = self.lines[number - 1].strip() if 0 < number <= len(self.lines) else ""
        key = line.partition("=")[0].strip()
        example = example_of(key, quantities(USUAL).units.get(key, "kg"))
        cure = f'text stands in quotes, as in {key if key.isidentifier() else "m"} = "{example}"'
        cure = f"{key} is there twice; keep one of the two" if "overwrite" in message else cure
        return f"{self.path}, line {number}: {line!r} is not TOML; {cure}"

    def _friction(self, given: Any, found: dict[str, Measured], kind: Quantities) -> FrictionFit:
        """The fit of the measured file; its μ₀ and d go among the quantities, normal, with their
        standard errors.
        """
        if not isinstance(given, str) or not given.strip():
            raise ParameterError('it is no file name; write friction = "measured.csv"')
        if not kind.of_mu0:
            raise ParameterError("this model has another friction law; give its quantities instead")
        for key in ("mu0", "d"):
            if key in found:
                raise ParameterError(f"{key} is given too; leave out one of the two")
        fit = fit_friction(*read_friction(Path(self.path).parent / given))
        found |= {
            "mu0": _fitted(fit.mu0, fit.mu0_error, ""),
            "d": _fitted(fit.d, fit.d_error, "s/m"),
        }
        return fit


def _model(name: Any, trust: bool | str) -> str:
    if not isinstance(name, str):
        raise ParameterError(f'{name!r} is no name; write model = "kang_nam"')
    if (
        name not in shipped()
        and trust is not True
        and trust != name
        and os.path.isdir(name[:4096].replace("\0", ""))
    ):
        cure = f"if you trust it, give --trust or --model {name}, in Python trust=True"
        raise ParameterError(f"{name!r} is a folder, whose code runs; {cure}")
    quantities(name)
    return name


def _quantity(key: str, given: Any, unit: str, allowed: Range) -> Measured:
    example = _EXAMPLES.get(key, "")
    if (
        unit == "1"
        and isinstance(given, list)
        and len(given) == 2
        and all(type(end) in (int, float) for end in given)
    ):
        given = f"[{given[0]!r}, {given[1]!r}]"
    if isinstance(given, bool) or not isinstance(given, str | int | float):
        raise ParameterError(
            f"{key} = {given!r} is neither text nor a number; write "
            f"{remedy(unit, allowed, example)}"
        )
    try:
        return read(given if isinstance(given, str) else repr(given), unit, allowed, example)
    except ParameterError as error:
        raise ParameterError(f"{key} = {error}") from error


def _correlation(given: Any, study: Study) -> Correlation:
    """Which quantities vary together: those of the file, and μ₀ and d of one fit."""
    fit, rows = study.fit, given if isinstance(given, list) else [] if given is None else [given]
    rows = (
        [*rows, ["mu0", "d", fit.correlation]]
        if fit is not None and {"mu0", "d"} <= set(study.tolerances)
        else rows
    )
    for row in rows:
        if not (
            isinstance(row, list)
            and len(row) == 3
            and all(isinstance(name, str) for name in row[:2])
        ):
            cure = 'write correlation = [["k", "k_x", 0.9]]'
            raise ParameterError(
                f"correlation = {given!r} is no list of two names and a number each; {cure}"
            )
    found = {(one, other): value for one, other, value in rows}
    if len(set(map(frozenset, found))) < len(rows):
        raise ParameterError(
            f"correlation = {given!r} has a pair twice, or that of the measured file; keep "
            "one of them"
        )
    dependence(list(study.tolerances), found)
    return found


def _state(given: Any, kind: Quantities) -> Numbers:
    units = kind.coordinates
    if not isinstance(given, dict) or not set(given) <= set(units):
        example = ", ".join(
            f'{name} = "{"30 deg" if unit == "rad" else "2 mm"}"' for name, unit in units.items()
        )
        raise ParameterError(
            f"state = {given!r} does not name coordinates; write state = {{ {example} }}"
        )
    return {name: _quantity(name, text, units[name], FINITE).value for name, text in given.items()}


def _may_change(given: Any, kind: Quantities) -> Ranges:
    if not isinstance(given, dict) or not set(given) <= set(kind.units):
        cure = (
            f'write may_change = {{ {next(iter(kind.units))} = "[100, 250] N/mm" }}, in the '
            "quantity's own unit"
        )
        raise ParameterError(f"may_change = {given!r} does not name quantities; {cure}")
    ends = {
        name: _quantity(name, text, kind.units[name], kind.ranges()[name])
        for name, text in given.items()
    }
    return {name: spanned(kind, name, (one.low, one.high)) for name, one in ends.items()}


def _rise(vary: Any, begin: Any, study: Study) -> Rise | None:
    units = study.kind.units
    if not isinstance(vary, str | None):
        raise ParameterError(f'vary = {vary!r} is no name of a quantity; write vary = "F_L"')
    if begin is not None and vary in units:
        begin = _quantity("begin", begin, units[vary], FINITE).value
    return rise_of(study.kind, vary, begin, study.values)


def _fitted(value: float, error: float, unit: str) -> Measured:
    """A normal distribution; cut off at three standard errors, and above 0, where it would reach 0
    else.
    """
    cut = error == 0 or value <= WITHIN * error
    return Measured(
        value, max(value - ENDS * error, value / 100), value + ENDS * error, unit, error, cut
    )


def example(model: Model) -> str:
    """The text of ``brake.toml``: the article's example, or the base values of a model in the sizes
    of a brake.

    >>> import spragsym as ss
    >>> example(ss.load("stick_slip")).splitlines()[1:3]
    ['[brake]', 'model = "stick_slip"']
    """
    if model.where == USUAL:
        return shipped_text("spragsym.report", "brake.toml")
    kind, (_, p) = quantities(model.where), model.cases()[0]
    sizes = {name: _SIZES.get(unit, 1.0) for name, unit in kind.bases.items()}
    values = sizes | {
        quantity: float(getattr(p, name)) * kind.scale(kind.units[quantity], sizes)
        for quantity, name in kind.parameters.items()
    }
    given = ("m/s^2", "m/s", "s/m") if kind.scale("m/s", sizes) > _FASTEST else ("m/s^2",)

    def written(name: str, value: float) -> str:
        si = kind.units[name]
        unit = PLAIN_UNITS.get(si, si)
        return (
            example_of(name, si)
            if si in given
            else f"{float(f'{value / factor(unit, si):.3g}'):g} {unit}".strip()
        )

    rises, lines = kind.rises, []
    for name in kind.units:
        off = "" if name == rises else _TOLERANCES.get(name, "")
        key = name if name.isascii() else json.dumps(name, ensure_ascii=False)
        entry = f'{key} = "{written(name, values[name])}{off}"'
        lines.append(f"{entry:<32}# {kind.meanings[name]}")
    if rises is not None:
        least = kind.ranges()[rises]
        lines.append(f'vary = "{rises}"')
        lines += (
            []
            if least.contains(least.low)
            else [f'begin = "{written(rises, 0.5 * values[rises])}"']
        )
    where = Path(model.where).as_posix()
    return (
        "\n".join(
            [
                f"# {kind.about['summary']}",
                "[brake]",
                f"model = {json.dumps(where, ensure_ascii=False)}",
                *lines,
            ]
        )
        + "\n"
    )


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
    text = text_of(path, MEASURED, "a text file with sliding speed and coefficient").splitlines()
    stripped = ((number, line.strip(" \r\n")) for number, line in enumerate(text, 1))
    lines = [
        (number, line)
        for number, line in stripped
        if line.strip() and not line.strip().startswith(_COMMENT)
    ]
    if len(lines) > _LINES:
        raise ParameterError(
            f"{path} has {len(lines)} lines, and at most {_LINES} are read; give every tenth or so"
        )
    found, failures = set[tuple[Span, ...]](), list[_RefusedError]()
    said = re.fullmatch(r"sep=(.)", lines[0][1]) if lines else None  # as spreadsheets write it
    for between in (said[1],) if said else _BETWEEN:
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
    if not ((speed == 0) | ((speed > _SLOWEST) & (speed < 1 / _SLOWEST))).all():
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
    words = [{_word(name) for name in row} for _, row in cells[:_ABOVE]]
    begin = next((at for at, row in enumerate(words) if row & SPEED and row & FRICTION), 0)
    (number, names), *data = cells[begin:]
    if any(_NUMBER.fullmatch(name) for name in names):
        said = "this is no head: it does not say which column is which, and in what unit"
        raise _RefusedError(f"{said}; put a line such as {EXAMPLE} above it", number, 3)
    units = [""] * len(names)
    if (
        data
        and len(data[0][1]) == len(names)
        and not any(_NUMBER.match(cell) for cell in data[0][1] if cell not in ("1", ""))
    ):
        units, data = [cell.strip("[]()") for cell in data[0][1]], data[1:]
    speed, friction = (
        _column(names, units, SPEED, "m/s", number),
        _column(names, units, FRICTION, "1", number),
    )
    used = []
    for number, row in data:
        if len(row) < len(names) or any(row[len(names) :]):
            said = f"{texts[number]!r} has {len(row)} columns, and the head has {len(names)}"
            raise _RefusedError(
                f"{said}; give every column a name, and put semicolons between them", number, 3
            )
        used += [row[speed[0]], row[friction[0]]]
        for cell in used[-2:]:
            if not _NUMBER.fullmatch(cell) or not math.isfinite(float(cell.replace(",", "."))):
                said = f"{texts[number]!r} is not a sliding speed and a coefficient"
                raise _RefusedError(f"{said}, such as 0.5;0.41 or 0,5;0,41", number, 4)
    marks = {mark for mark in ".," for cell in used if mark in cell}
    if len(marks) > 1 or any(
        all(_THOUSANDS.fullmatch(cell) for cell in used if mark in cell) for mark in marks
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
        if value > _LARGEST:
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
    """What a column is called: small letters, without its unit and without a symbol behind its
    name.
    """
    parts = _HEAD.fullmatch(" ".join(name.split()))
    word = re.sub(r"[\s_\-.]+", " ", parts["name"] if parts else name).strip().lower()
    word = re.sub("[\N{MICRO SIGN}\N{GREEK SMALL LETTER MU}]", "mu", word)
    first, _, last = word.rpartition(" ")
    return first if any({first, last} <= known for known in (SPEED, FRICTION)) else word


def _number(cell: str) -> str:
    """A cell; of a number with a minus of print, groups of thousands or Fortran's exponent, as
    Python writes it.
    """
    text = cell.replace("\N{MINUS SIGN}", "-")
    text = re.sub(r"['’\u202f\u00a0]", "", text) if _GROUPED.fullmatch(text) else text
    return re.sub(r"^([+-]?[\d.,]+)[dD]([+-]?\d+)$", r"\1e\2", text)


def _column(
    names: Sequence[str], units: Sequence[str], known: frozenset[str], si: str, line: int
) -> tuple[int, float]:
    """Which column has one of these names, and what its unit is in SI."""
    what, write = (
        ("the sliding speed", "v [m/s]")
        if si == "m/s"
        else ("the friction coefficient", "mu or mu [%]")
    )
    found = [i for i, name in enumerate(names) if _word(name) in known]
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


@dataclass(frozen=True)
class FrictionFit(Result):
    """μ₀ and d of the law μ₀ (1 − exp(−d \\|v\\|)) by least squares, with their standard errors and
    the rms of what is left.

    ``correlation`` is that of the two errors: a larger μ₀ with a smaller d may fit as well.

    ``slowest`` and ``fastest`` are the smallest and the largest sliding speed that was measured, in
    m/s.
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
    """μ₀ and d by least squares; for each d the best μ₀ is linear, so that one search over d finds
    the best of all.

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

    def best(log_d: float) -> Span:
        """μ₀, and the sum of squares that it leaves."""
        rise = shape(math.exp(log_d))
        mu0 = float(rise @ friction / (rise @ rise))
        return mu0, float(((friction - mu0 * rise) ** 2).sum())

    # Beyond these the law is a straight line in v, or a constant, at every speed that was measured.
    grid = np.linspace(math.log(1e-4 / moving.max()), math.log(40.0 / moving.min()), 400)
    k = int(np.argmin([best(value)[1] for value in grid]))
    ends = grid[np.clip([k - 1, k + 1], 0, grid.size - 1)]
    found = minimize_scalar(
        lambda log_d: best(log_d)[1], bounds=ends, method="bounded", options={"xatol": 1e-12}
    )
    d, (mu0, left) = math.exp(float(found.x)), best(float(found.x))
    spread = math.sqrt(left / max(speed.size - 2, 1))
    slopes = np.stack([shape(d), mu0 * speed * np.exp(-d * speed)], axis=1)
    covariance = np.linalg.pinv(slopes.T @ slopes)
    sizes = np.sqrt(np.abs(np.diag(covariance)))
    mu0_error, d_error = (spread * sizes).tolist()
    return FrictionFit(
        mu0,
        d,
        mu0_error,
        d_error,
        correlation=float(np.clip(covariance[0, 1] / max(sizes.prod(), 1e-300), -1.0, 1.0)),
        rms=spread,
        points=speed.size,
        slowest=float(moving.min()),
        fastest=float(speed.max()),
    )
