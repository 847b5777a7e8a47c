"""``brake.toml``: the data of a brake with units and tolerances, read with an error for every mistake that says where it is."""

from __future__ import annotations

import os
import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from ..errors import ParameterError, SpragsymError
from ..files.text import decoded
from ..generated.quantities import QUANTITIES
from ..names import hint
from ..parameters import RANGES, PhysicalParameters, degrees, physical_ranges, shown
from . import other_models
from .measurements import FrictionFit, fit_friction, read_friction
from .units import EXAMPLES, Measured, factor, read

#: Quantities of the article's model in the order of the file, each with its SI unit.
QUANTITY_UNITS: Mapping[str, str] = {
    field.name: QUANTITIES[f"{field.name}_dim" if field.name in ("V", "d") else field.name].unit
    for field in fields(PhysicalParameters)
}
#: Quantities that are not of the size that others of the same unit have.
_EXAMPLES: Mapping[str, str] = {"k_x": "9 N/mm", "k_y": "0 N/mm", "k_c": "1500 N/mm"}
#: Bytes; a larger file is no file of this kind.
_LARGEST = 1 << 20


@dataclass(frozen=True)
class BrakeFile:
    """What stands in a file: quantities by name, the model, and the fit of the friction law if it was measured."""

    path: str
    model: str
    quantities: Mapping[str, Measured]
    fit: FrictionFit | None = None


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


def read_brake(path: str | os.PathLike[str]) -> BrakeFile:
    """The data of a brake.

    Parameters
    ----------
    path : path
        A TOML file with one table, ``[brake]``: for each quantity a text with number, unit and, if it has one, a tolerance.

    Raises
    ------
    ParameterError
        For every mistake: it names the file, the line, the key, the value and what to write.
    """
    name = os.fspath(path)
    text = _text(Path(path), name)
    lines = _Lines(name, text)
    table = _table(text, lines)
    model = _model(table, lines)
    units = QUANTITY_UNITS if model == "kang_nam" else other_models.quantity_units(model)
    measured = table.pop("friction", None)
    _check_names(table, units, lines)
    found = {key: _quantity(key, table[key], units[key], lines) for key in units if key in table}
    fit = None
    if measured is not None:
        found, fit = _with_friction(measured, found, units, Path(path), lines)
    _check_complete(found, units, model, lines)
    return BrakeFile(name, model, found, fit)


def _text(path: Path, name: str) -> str:
    if path.is_dir():
        raise ParameterError(f"{name} is a folder; give a file such as brake.toml")
    try:
        if path.stat().st_size > _LARGEST:
            raise ParameterError(f"{name} has more than {_LARGEST} bytes; give a file with the table [brake] and nothing else")
        return decoded(path.read_bytes())
    except UnicodeDecodeError as error:
        raise ParameterError(f"{name} is not text in UTF-8 (byte {error.start}); save it as UTF-8, or write +- for ±") from error
    except OSError as error:
        raise ParameterError(f"{name} can't be read: {error.strerror}; give a file such as brake.toml") from error


def _table(text: str, lines: _Lines) -> dict[str, Any]:
    try:
        content = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
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
        example = _example(key, QUANTITY_UNITS.get(key, "kg"))
        remedy = f'text stands in quotes, as in {key if key.isidentifier() else "m"} = "{example}"'
    return f"{lines.path}, line {number}: {line!r} is not TOML ({said[:1].lower()}{said[1:]}); {remedy}"


def _example(key: str, unit: str) -> str:
    """How an engineer would write a quantity."""
    return _EXAMPLES.get(key) or EXAMPLES.get(unit, f"1 {unit}")


def _model(table: dict[str, Any], lines: _Lines) -> str:
    name = table.pop("model", "kang_nam")
    if not isinstance(name, str):
        raise ParameterError(f'{lines.of("model")}: model = {name!r} is no name; write model = "kang_nam"')
    try:
        other_models.about(name)
    except SpragsymError as error:
        raise ParameterError(f"{lines.of('model')}: model = {error}") from error
    return name


def _check_names(table: Mapping[str, Any], units: Mapping[str, str], lines: _Lines) -> None:
    known = [*units, "friction", "model"]
    for key, value in table.items():
        if key not in known:
            remark = hint(key, known) or f"; the keys are {', '.join(known)}"
            raise ParameterError(f"{lines.of(key)}: {key} = {value!r} is not a quantity of this model{remark}")


def _quantity(key: str, given: Any, unit: str, lines: _Lines) -> Measured:
    where = lines.of(key)
    if unit == "1" and isinstance(given, list) and len(given) == 2 and all(type(end) in (int, float) for end in given):
        given = f"[{given[0]!r}, {given[1]!r}]"
    if isinstance(given, bool) or not isinstance(given, str | int | float):
        raise ParameterError(f'{where}: {key} = {given!r} is neither text nor a number; write {key} = "{_example(key, unit)}"')
    if not isinstance(given, str) and unit != "1":
        example = _example(key, unit).split(" ", 1)[1]
        raise ParameterError(f'{where}: {key} = {given!r} has no unit; write for instance {key} = "{given} {example}"')
    try:
        found = read(given if isinstance(given, str) else repr(given), unit)
    except ParameterError as error:
        raise ParameterError(f"{where}: {key} = {error}") from error
    _check_range(key, found, given, where, unit)
    return found


def _check_range(key: str, found: Measured, given: Any, where: str, unit: str) -> None:
    """Both ends of the tolerance lie where the model allows it."""
    allowed = physical_ranges().get(key)
    if allowed is None:
        return
    for end in (found.value, found.low, found.high):
        if not allowed.contains(end):
            what = "" if end == found.value else f" reaches {_in_words(end, found.unit, unit)}, which"
            low = "above" if allowed.open_low else "at least"
            limits = f"{low} 0" if unit != "rad" else "between 0 deg and 180 deg, without these two"
            word = "is not" if what else "must be"
            text = f"{key} = {given!r}{what} {word} {limits}"
            remedy = "" if unit == "rad" else allowed.remedy or _remedy(key)
            if key == "V":
                remedy = "a belt that runs the other way is the mirror image: give the supplement of theta0"
            if what and allowed.contains(found.value) and (end < 0 or not remedy):
                remedy = f'give the two ends, as in {key} = "{_ends(found, unit, allowed.open_low)}"'
            raise ParameterError(f"{where}: {text}; " + (remedy or f'write for instance {key} = "{_example(key, unit)}"'))


def _ends(found: Measured, si: str, open_low: bool) -> str:
    """A range that a quantity may have, about the one that was given."""
    low, high = (shown(round(end / factor(found.unit, si), 12)) for end in (found.value / 2 if open_low else 0.0, found.high))
    return f"[{low}, {high}] {found.unit}".strip()


def _remedy(key: str) -> str:
    """Why the quantity can't be 0, in the words of the dimensionless parameter that it makes."""
    return RANGES[{"k": "sigma", "F_L": "kappa"}[key]].remedy if key in ("k", "F_L") else ""


def _in_words(value: float, unit: str, si: str) -> str:
    return f"{degrees(value):.6g} deg" if unit == "deg" else f"{shown(round(value / factor(unit, si), 12))} {unit}".strip()


def _with_friction(
    given: Any, found: dict[str, Measured], units: Mapping[str, str], path: Path, lines: _Lines
) -> tuple[dict[str, Measured], FrictionFit]:
    """μ₀ and d from the measured file, with twice their standard errors as tolerances."""
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
    off = 2 * fit.mu0_error, 2 * fit.d_error
    friction = Measured(fit.mu0, max(fit.mu0 - off[0], 0.0), fit.mu0 + off[0], "")
    steepness = Measured(fit.d, max(fit.d - off[1], fit.d / 100), fit.d + off[1], "s/m")
    return found | {"mu0": friction, "d": steepness}, fit


def _check_complete(found: Mapping[str, Measured], units: Mapping[str, str], model: str, lines: _Lines) -> None:
    optional = {"V", "d"}
    missing = [key for key in units if key not in found and key not in optional]
    if missing:
        wanted = ", ".join(f'{key} = "{_example(key, units[key])}"' for key in missing)
        raise ParameterError(f"{lines.table('brake')}: [brake] is without {', '.join(missing)}; add lines such as {wanted}")


def physical(quantities: Mapping[str, Measured]) -> PhysicalParameters:
    """The values, without their tolerances."""
    return PhysicalParameters(**{name: one.value for name, one in quantities.items()})
