"""``brake.toml``: the data of a brake with units and tolerances, read with an error for every mistake that says where it is."""

from __future__ import annotations

import os
import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..design.dependence import Correlation, dependence
from ..errors import ParameterError, SpragsymError
from ..files.text import text_of
from ..models.load import USUAL, shipped
from ..models.parameters import FINITE, Range
from ..names import hint
from . import brake_quantities
from .measured_tables import read_friction
from .measurements import FrictionFit, fit_friction
from .rises import Rise, rise_of
from .units import ENDS, EXAMPLES, WITHIN, Measured, read, remedy

#: Quantities that are not of the size that others of the same unit have.
_EXAMPLES: Mapping[str, str] = {"k_x": "9 N/mm", "k_y": "0 N/mm", "k_c": "1500 N/mm"}


@dataclass(frozen=True)
class BrakeFile:
    """What stands in a file: quantities, model, the fit of a measured friction law, what varies together, and what rises."""

    path: str
    model: str
    quantities: Mapping[str, Measured]
    fit: FrictionFit | None = None
    correlation: Correlation = field(default_factory=dict)
    rise: Rise | None = None
    state: Mapping[str, float] = field(default_factory=dict)  #: coordinates in SI near which the followed state begins


class _Lines:
    """The text of a file, to say on which line a key stands."""

    def __init__(self, path: str, text: str) -> None:
        self.path, self.lines = path, text.splitlines()

    def of(self, key: str) -> str:
        pattern = re.compile(rf"""\s*(?:brake\s*\.\s*)?["']?{re.escape(key)}["']?\s*=""")
        for number, line in enumerate(self.lines, 1):
            if pattern.match(line):
                return f"{self.path}, line {number}"
        return self.path

    def table(self, name: str) -> str:
        for number, line in enumerate(self.lines, 1):
            if re.match(rf"""\s*\[\s*["']?{re.escape(name)}["']?\s*\]""", line):
                return f"{self.path}, line {number}"
        return self.path


def read_brake(path: str | os.PathLike[str], trust: bool | str = False) -> BrakeFile:
    """The data of a brake.

    Parameters
    ----------
    path : path
        A TOML file with one table, ``[brake]``: for each quantity a text with number, unit and, if it has one, a tolerance; and
        ``correlation = [["k", "k_x", 0.9]]`` for quantities that vary together; and ``vary = "F_L"`` where not the friction but a
        quantity rises until the state jumps, with ``begin = "10 N"`` if not from its least value; and
        ``state = { phi = "-28 deg" }`` where another state than the reference state is followed.
    trust : bool or str
        Whether the code of a model's folder may run that the file names, or the one folder whose code may.

    Raises
    ------
    ParameterError
        For every mistake: it names the file, the line, the key, the value and what to write.
    """
    name = os.fspath(path)
    text = text_of(path, what="a file such as brake.toml", remedy=", or write +- for ±")
    lines = _Lines(name, text)
    table = _table(text, lines)
    model = _model(table, lines, trust)
    units = brake_quantities.quantity_units(model)
    measured, together, rising = table.pop("friction", None), table.pop("correlation", None), table.pop("vary", None)
    begin, chosen = table.pop("begin", None), table.pop("state", {})
    _check_names(table, units, model, lines)
    ranges = brake_quantities.ranges(model)
    found = {key: _quantity(key, table[key], units[key], ranges[key], lines) for key in units if key in table}
    fit = None
    if measured is not None:
        found, fit = _with_friction(measured, found, units, Path(path), lines)
    _check_complete(found, units, model, lines)
    rise = _rise(rising, begin, model, found, lines)
    return BrakeFile(name, model, found, fit, _correlation(together, found, fit, lines), rise, _state(chosen, model, lines))


def _table(text: str, lines: _Lines) -> dict[str, Any]:
    try:
        content = tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # TOML that is none, and numbers that are too long
        raise ParameterError(_syntax(str(error), lines)) from error
    if "brake" not in content:
        other = next(iter(content), None)
        where = lines.path if other is None else lines.table(other) if isinstance(content[other], dict) else lines.of(other)
        what = f"the table [{other}] is" if isinstance(content.get(str(other)), dict) else f"the key {other!r} stands"
        remark = f"{lines.path} is empty: " if other is None else f"{where}: {what} there, but "
        raise ParameterError(f"{remark}[brake] is missing; begin with a line [brake]{hint(str(other), ['brake'])}")
    table = content["brake"]
    if not isinstance(table, dict):
        raise ParameterError(f"{lines.of('brake')}: brake = {table!r} is no table; begin with a line [brake]")
    for other in content:
        if other != "brake":
            where = lines.table(other) if isinstance(content[other], dict) else lines.of(other)
            raise ParameterError(f"{where}: {other!r} does not belong here; all keys go below [brake], and nothing else is read")
    return dict(table)


def _syntax(message: str, lines: _Lines) -> str:
    """What tomllib says, with the line before it and how a line is written."""
    found = re.search(r" \(at (?:line (\d+), column (\d+)|end of document)\)", message)
    number = int(found[1]) if found and found[1] else len(lines.lines)
    line = lines.lines[number - 1].strip() if 0 < number <= len(lines.lines) else ""
    said = message[: found.start()] if found else message
    key = line.partition("=")[0].strip()
    if "overwrite" in message:
        remedy = f"{key} is there twice; keep one of the two"
    else:
        example = example_of(key, brake_quantities.quantity_units(USUAL).get(key, "kg"))
        remedy = f'text stands in quotes, as in {key if key.isidentifier() else "m"} = "{example}"'
    return f"{lines.path}, line {number}: {line!r} is not TOML ({said[:1].lower()}{said[1:]}); {remedy}"


def example_of(key: str, unit: str) -> str:
    """How an engineer would write a quantity."""
    return _EXAMPLES.get(key) or EXAMPLES.get(unit, (f"1 {unit}",))[0]


def _model(table: dict[str, Any], lines: _Lines, trust: bool | str) -> str:
    name = table.pop("model", USUAL)
    if not isinstance(name, str):
        raise ParameterError(f'{lines.of("model")}: model = {name!r} is no name; write model = "kang_nam"')
    if name not in shipped() and trust is not True and trust != name and os.path.isdir(name[:4096].replace("\0", "")):
        where = lines.of("model")
        raise ParameterError(
            f"{where}: model = {name!r} is a folder, whose code runs; "
            f"if you trust it, give --trust or --model {name}, in Python trust=True"
        )
    try:
        brake_quantities.about(name)
    except SpragsymError as error:
        raise ParameterError(f"{lines.of('model')}: model = {error}") from error
    return name


def _check_names(table: Mapping[str, Any], units: Mapping[str, str], model: str, lines: _Lines) -> None:
    known = [*units, "friction", "correlation", "model", "vary", "begin", "state"]
    for key, value in table.items():
        if key not in known:
            remark = hint(key, known) or f"; the keys are {', '.join(known)}"
            raise ParameterError(f"{lines.of(key)}: {key} = {value!r} is not a quantity of the model {model}{remark}")


def _quantity(key: str, given: Any, unit: str, allowed: Range, lines: _Lines) -> Measured:
    where, example = lines.of(key), _EXAMPLES.get(key, "")
    if unit == "1" and isinstance(given, list) and len(given) == 2 and all(type(end) in (int, float) for end in given):
        given = f"[{given[0]!r}, {given[1]!r}]"
    text = given if isinstance(given, str) else repr(given)
    if isinstance(given, bool) or not isinstance(given, str | int | float):
        what = remedy(unit, allowed, example)
        raise ParameterError(f"{where}: {key} = {given!r} is neither text nor a number; write {what}")
    try:
        return read(text, unit, allowed, example)
    except ParameterError as error:
        raise ParameterError(f"{where}: {key} = {error}") from error


def _with_friction(
    given: Any, found: dict[str, Measured], units: Mapping[str, str], path: Path, lines: _Lines
) -> tuple[dict[str, Measured], FrictionFit]:
    """μ₀ and d from the measured file: normal, with their standard errors."""
    where = lines.of("friction")
    if not isinstance(given, str) or not given.strip():
        raise ParameterError(f'{where}: friction = {given!r} is no file name; write friction = "measured.csv"')
    if "mu0" not in units:
        raise ParameterError(
            f"{where}: friction = {given!r}, but this model has another friction law; give its quantities instead"
        )
    for key in ("mu0", "d"):
        if key in found:
            raise ParameterError(f"{where}: friction = {given!r}, but {key} is given too; leave out one of the two")
    try:
        fit = fit_friction(*read_friction(path.parent / given))
    except ParameterError as error:
        raise ParameterError(f"{where}: friction = {given!r}: {error}") from error
    return found | {"mu0": _fitted(fit.mu0, fit.mu0_error, ""), "d": _fitted(fit.d, fit.d_error, "s/m")}, fit


def _fitted(value: float, error: float, unit: str) -> Measured:
    """A normal distribution; cut off at three standard errors, and above 0, where it would reach 0 else."""
    if value > WITHIN * error:
        return Measured(value, value - ENDS * error, value + ENDS * error, unit, error, error == 0)
    return Measured(value, max(value - ENDS * error, value / 100), value + ENDS * error, unit, error, True)


def _correlation(given: Any, found: Mapping[str, Measured], fit: FrictionFit | None, lines: _Lines) -> Correlation:
    """Which quantities vary together: those of the file, and μ₀ and d of one fit."""
    fitted = {("mu0", "d"): fit.correlation} if fit is not None and fit.mu0_error and fit.d_error else {}
    if given is None:
        return fitted
    where, example = lines.of("correlation"), 'write correlation = [["k", "k_x", 0.9]]'
    rows = given if isinstance(given, list) else [given]
    for row in rows:
        if not (isinstance(row, list) and len(row) == 3 and all(isinstance(name, str) for name in row[:2])):
            raise ParameterError(f"{where}: correlation = {given!r} is no list of two names and a number each; {example}")
        for name in row[:2]:
            if name not in found or found[name].low == found[name].high:
                what = "has no tolerance" if name in found else "is not a quantity of this file"
                raise ParameterError(f"{where}: correlation: {name} {what}{hint(name, found)}; leave the pair out")
    pairs = [(row[0], row[1]) for row in rows]
    if len({frozenset(pair) for pair in (*pairs, *fitted)}) < len(pairs) + len(fitted):
        raise ParameterError(f"{where}: correlation = {given!r} has a pair twice, or that of the measured file; keep one of them")
    result = dict(zip(pairs, (row[2] for row in rows), strict=True)) | fitted
    try:
        dependence([name for name, one in found.items() if one.low < one.high], result)
    except ParameterError as error:
        raise ParameterError(f"{where}: {error}") from error
    return result


def _state(given: Any, model: str, lines: _Lines) -> dict[str, float]:
    """Coordinates in SI near which the followed state begins."""
    units = {entry["name"]: entry["unit"] for entry in brake_quantities.about(model)["coordinates"]}
    example = ", ".join(f'{name} = "{"30 deg" if unit == "rad" else "2 mm"}"' for name, unit in units.items())
    if not isinstance(given, dict) or not set(given) <= set(units):
        raise ParameterError(f"{lines.of('state')}: state = {given!r} does not name coordinates; write state = {{ {example} }}")
    return {name: _quantity(name, text, units[name], FINITE, lines).value for name, text in given.items()}


def _rise(vary: Any, begin: Any, model: str, found: Mapping[str, Measured], lines: _Lines) -> Rise | None:
    """What rises; an error names the line of what is wrong."""
    units, key = brake_quantities.quantity_units(model), "vary" if begin is None else "begin"
    if not isinstance(vary, str | None):
        raise ParameterError(f'{lines.of("vary")}: vary = {vary!r} is no name of a quantity; write vary = "F_L"')
    start = None if begin is None or vary not in units else _quantity("begin", begin, units[vary], FINITE, lines).value
    try:
        return rise_of(model, vary, begin if start is None else start, {name: one.value for name, one in found.items()})
    except ParameterError as error:
        raise ParameterError(f"{lines.of(key)}: {error}") from error


def _check_complete(found: Mapping[str, Measured], units: Mapping[str, str], model: str, lines: _Lines) -> None:
    missing = [key for key in units if key not in found and key not in brake_quantities.of_the_law(model)]
    if missing:
        wanted = ", ".join(f'{key} = "{example_of(key, units[key])}"' for key in missing)
        raise ParameterError(f"{lines.table('brake')}: [brake] is without {', '.join(missing)}; add lines such as {wanted}")
