"""``brake.toml``: the data of a brake with units and tolerances, read with an error for every mistake that says where it is."""

import json
import os
import re
import tomllib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from importlib import resources
from pathlib import Path
from typing import Any

from ..design.dependence import Correlation, dependence
from ..errors import ParameterError, SpragsymError
from ..files.text import text_of
from ..models import Model
from ..models.load import USUAL, shipped
from ..models.parameters import FINITE, Range
from ..models.quantities import Quantities, quantities
from ..models.units import factor
from ..names import hint
from .friction_tables import FrictionFit, fit_friction, read_friction
from .study import PLAIN_UNITS, Rise, Study, rise_of, spanned
from .units import ENDS, EXAMPLES, WITHIN, Measured, read, remedy

#: Quantities that are not of the size that others of the same unit have.
_EXAMPLES: Mapping[str, str] = {"k_x": "9 N/mm", "k_y": "0 N/mm", "k_c": "1500 N/mm"}
#: Of a file to begin with: what one of a unit of measure is, by its unit in SI, and tolerances.
_SIZES = {"kg": 0.35, "N/m": 1.5e6, "m": 0.038, "N": 400.0, "N/m^(3/2)": 8e6}
_TOLERANCES = {"k": " +- 10 %", "k_t": " +- 10 %", "theta0": " +- 1 deg", "mu0": " +- 10 %"}
#: A speed in m/s that no belt of a brake has, as the unit of a model may be; then speeds are those of the examples.
_FASTEST = 10.0
#: Keys of a file that are no quantities.
_KEYS = ("friction", "correlation", "model", "vary", "begin", "state", "may_change", "title", "date")


def read_brake(path: str | os.PathLike[str], trust: bool | str = False) -> Study:
    """The data of a brake from a TOML file with one table, ``[brake]``.

    For each quantity it has a text with number, unit and, if there is one, a tolerance; ``correlation = [["k", "k_x", 0.9]]`` for
    quantities that vary together; ``vary = "F_L"`` where not the friction but a quantity rises until the state jumps, with
    ``begin = "10 N"`` if not from its least value; and ``state = { phi = "-28 deg" }`` where another state than the reference
    state is followed; ``may_change = { k = "[100, 250] N/mm" }`` where a proposal may change these only, within these ends;
    ``title = "Front brake"`` and ``date = 2026-03-01`` for the head of the report.
    ``trust`` says whether the code of a model's folder may run that the file names, or the one folder whose code may. Every
    mistake is a ParameterError that names the file, the line, the key, the value and what to write.
    """
    return _Reader(os.fspath(path), text_of(path, what="a file such as brake.toml", remedy=", or write +- for ±")).read(trust)


def example_of(key: str, unit: str) -> str:
    """How an engineer would write a quantity."""
    return _EXAMPLES.get(key) or EXAMPLES.get(unit, (f"1 {unit}",))[0]


class _Reader:
    """The text of a file; mistakes in it are told with the line on which their key stands."""

    def __init__(self, path: str, text: str) -> None:
        self.path, self.text, self.lines = path, text, text.splitlines()

    def of(self, key: str, pattern: str = r"""\s*(?:brake\s*\.\s*)?["']?{}["']?\s*=""") -> str:
        """The line of a key."""
        found = (number for number, line in enumerate(self.lines, 1) if re.match(pattern.format(re.escape(key)), line))
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
                    raise ParameterError(f"{key} = {value!r} is not a quantity of the model {model}{remark}")
                found[key] = _quantity(key, value, kind.units[key], ranges[key])
        with self.at("friction", f"friction = {own['friction']!r}: "):
            fit = None if own["friction"] is None else self._friction(own["friction"], found, kind)
        missing = [key for key in kind.units if key not in found and key not in kind.of_the_law]
        if missing:
            wanted = ", ".join(f'{key} = "{example_of(key, kind.units[key])}"' for key in missing)
            raise ParameterError(f"{self.table('brake')}: [brake] is without {', '.join(missing)}; add lines such as {wanted}")
        found = {key: found[key] for key in kind.units if key in found}
        with self.at("correlation"):
            correlation = _correlation(own["correlation"], found, fit)
        with self.at("state"):
            state = _state(own["state"] or {}, kind)
        with self.at("may_change"):
            may_change = _may_change(own["may_change"] or {}, kind)
        with self.at("vary" if own["begin"] is None else "begin"):
            rise = _rise(own["vary"], own["begin"], kind, {name: one.value for name, one in found.items()})
        return Study.of(
            quantities=found, model=model, source=Path(self.path).name, fit=fit, rise=rise, correlation=correlation, state=state,
            may_change=may_change, title=str(own["title"] or ""), date=str(own["date"] or ""),
        )  # fmt: skip

    def _table(self) -> dict[str, Any]:
        try:
            content = tomllib.loads(self.text)
        except (ValueError, RecursionError) as error:  # TOML that is none, and numbers that are too long
            raise ParameterError(self._syntax(str(error))) from error
        if not content:
            raise ParameterError(f"{self.path} is empty: [brake] is missing; begin with a line [brake]")
        other = next((name for name in content if name != "brake"), "brake")
        table, held = content.get("brake"), content[other]
        if isinstance(table, dict) and other == "brake":
            return table
        where = self.table(other) if isinstance(held, dict) else self.of(other)
        missing = "" if isinstance(table, dict) else f", and [brake] is missing{hint(other, ['brake'])}"
        raise ParameterError(f"{where}: {other!r} does not belong here{missing}; all keys go below one line [brake]")

    def _syntax(self, message: str) -> str:
        """What tomllib says, with the line before it and how a line is written."""
        found = re.search(r" \(at (?:line (\d+), column (\d+)|end of document)\)", message)
        number = int(found[1]) if found and found[1] else len(self.lines)
        line = self.lines[number - 1].strip() if 0 < number <= len(self.lines) else ""
        key = line.partition("=")[0].strip()
        example = example_of(key, quantities(USUAL).units.get(key, "kg"))
        cure = f'text stands in quotes, as in {key if key.isidentifier() else "m"} = "{example}"'
        cure = f"{key} is there twice; keep one of the two" if "overwrite" in message else cure
        return f"{self.path}, line {number}: {line!r} is not TOML; {cure}"

    def _friction(self, given: Any, found: dict[str, Measured], kind: Quantities) -> FrictionFit:
        """The fit of the measured file; its μ₀ and d go among the quantities, normal, with their standard errors."""
        if not isinstance(given, str) or not given.strip():
            raise ParameterError('it is no file name; write friction = "measured.csv"')
        if not kind.of_mu0:
            raise ParameterError("this model has another friction law; give its quantities instead")
        for key in ("mu0", "d"):
            if key in found:
                raise ParameterError(f"{key} is given too; leave out one of the two")
        fit = fit_friction(*read_friction(Path(self.path).parent / given))
        found |= {"mu0": _fitted(fit.mu0, fit.mu0_error, ""), "d": _fitted(fit.d, fit.d_error, "s/m")}
        return fit


def _model(name: Any, trust: bool | str) -> str:
    if not isinstance(name, str):
        raise ParameterError(f'{name!r} is no name; write model = "kang_nam"')
    if name not in shipped() and trust is not True and trust != name and os.path.isdir(name[:4096].replace("\0", "")):
        cure = f"if you trust it, give --trust or --model {name}, in Python trust=True"
        raise ParameterError(f"{name!r} is a folder, whose code runs; {cure}")
    quantities(name)
    return name


def _quantity(key: str, given: Any, unit: str, allowed: Range) -> Measured:
    example = _EXAMPLES.get(key, "")
    if unit == "1" and isinstance(given, list) and len(given) == 2 and all(type(end) in (int, float) for end in given):
        given = f"[{given[0]!r}, {given[1]!r}]"
    if isinstance(given, bool) or not isinstance(given, str | int | float):
        raise ParameterError(f"{key} = {given!r} is neither text nor a number; write {remedy(unit, allowed, example)}")
    try:
        return read(given if isinstance(given, str) else repr(given), unit, allowed, example)
    except ParameterError as error:
        raise ParameterError(f"{key} = {error}") from error


def _correlation(given: Any, found: Mapping[str, Measured], fit: FrictionFit | None) -> Correlation:
    """Which quantities vary together: those of the file, and μ₀ and d of one fit."""
    rows = given if isinstance(given, list) else [] if given is None else [given]
    rows = [*rows, ["mu0", "d", fit.correlation]] if fit is not None and fit.mu0_error and fit.d_error else rows
    for row in rows:
        if not (isinstance(row, list) and len(row) == 3 and all(isinstance(name, str) for name in row[:2])):
            cure = 'write correlation = [["k", "k_x", 0.9]]'
            raise ParameterError(f"correlation = {given!r} is no list of two names and a number each; {cure}")
    pairs = [(row[0], row[1]) for row in rows]
    if len({frozenset(pair) for pair in pairs}) < len(pairs):
        raise ParameterError(f"correlation = {given!r} has a pair twice, or that of the measured file; keep one of them")
    result = dict(zip(pairs, (row[2] for row in rows), strict=True))
    dependence([name for name, one in found.items() if one.varies], result)
    return result


def _state(given: Any, kind: Quantities) -> dict[str, float]:
    units = kind.coordinates
    if not isinstance(given, dict) or not set(given) <= set(units):
        example = ", ".join(f'{name} = "{"30 deg" if unit == "rad" else "2 mm"}"' for name, unit in units.items())
        raise ParameterError(f"state = {given!r} does not name coordinates; write state = {{ {example} }}")
    return {name: _quantity(name, text, units[name], FINITE).value for name, text in given.items()}


def _may_change(given: Any, kind: Quantities) -> dict[str, tuple[float, float]]:
    if not isinstance(given, dict) or not set(given) <= set(kind.units):
        cure = f'write may_change = {{ {next(iter(kind.units))} = "[100, 250] N/mm" }}, in the quantity\'s own unit'
        raise ParameterError(f"may_change = {given!r} does not name quantities; {cure}")
    ends = {name: _quantity(name, text, kind.units[name], kind.ranges()[name]) for name, text in given.items()}
    return {name: spanned(kind, name, (one.low, one.high)) for name, one in ends.items()}


def _rise(vary: Any, begin: Any, kind: Quantities, values: Mapping[str, float]) -> Rise | None:
    if not isinstance(vary, str | None):
        raise ParameterError(f'vary = {vary!r} is no name of a quantity; write vary = "F_L"')
    if begin is not None and vary in kind.units:
        begin = _quantity("begin", begin, kind.units[vary], FINITE).value
    return rise_of(kind, vary, begin, values)


def _fitted(value: float, error: float, unit: str) -> Measured:
    """A normal distribution; cut off at three standard errors, and above 0, where it would reach 0 else."""
    if value > WITHIN * error:
        return Measured(value, value - ENDS * error, value + ENDS * error, unit, error, error == 0)
    return Measured(value, max(value - ENDS * error, value / 100), value + ENDS * error, unit, error, True)


def example(model: Model) -> str:
    """The text of ``brake.toml``: the article's example, or the base values of a model in the sizes of a brake.

    >>> import spragsym as ss
    >>> example(ss.load("stick_slip")).splitlines()[1:3]
    ['[brake]', 'model = "stick_slip"']
    """
    if model.where == USUAL:
        return (resources.files("spragsym.report") / "brake.toml").read_text(encoding="utf-8")
    kind, (_, p) = quantities(model.where), model.cases()[0]
    sizes = {name: _SIZES.get(unit, 1.0) for name, unit in kind.bases.items()}
    values = sizes | {
        quantity: float(getattr(p, name)) * kind.scale(kind.units[quantity], sizes) for quantity, name in kind.parameters.items()
    }
    given = ("m/s^2", "m/s", "s/m") if kind.scale("m/s", sizes) > _FASTEST else ("m/s^2",)

    def written(name: str, value: float) -> str:
        si = kind.units[name]
        unit = PLAIN_UNITS.get(si, si)
        return example_of(name, si) if si in given else f"{float(f'{value / factor(unit, si):.3g}'):g} {unit}".strip()

    rises, lines = kind.rises, []
    for name in kind.units:
        off = "" if name == rises else _TOLERANCES.get(name, "")
        key = name if name.isascii() else json.dumps(name, ensure_ascii=False)
        entry = f'{key} = "{written(name, values[name])}{off}"'
        lines.append(f"{entry:<32}# {kind.meanings[name]}")
    if rises is not None:
        least = kind.ranges()[rises]
        lines.append(f'vary = "{rises}"')
        lines += [] if least.contains(least.low) else [f'begin = "{written(rises, 0.5 * values[rises])}"']
    where = model.where if model.where == model.name else Path(model.where).as_posix()
    return "\n".join([f"# {kind.about['summary']}", "[brake]", f"model = {json.dumps(where, ensure_ascii=False)}", *lines]) + "\n"
