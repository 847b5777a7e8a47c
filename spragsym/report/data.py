"""``brake.toml``: the data of a brake with units and tolerances.

An error for every mistake names the file, the line, the key, the value and what to write.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Mapping, Set
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from ..core.errors import ModelError, ParameterError, SpragsymError, hint
from ..core.type_variables import T
from ..design.sampling import Correlation, dependence
from ..files.text import FilePath, brake_text, path_text, printed, toml_of
from ..models.load import USUAL, WITH_DAMPERS, require_trust, shipped
from ..models.parameters import FINITE, Range, Ranges
from ..models.quantities import Quantities, quantities
from .damping import RATIO, modal_dampers
from .example import OWN_EXAMPLES, example_of
from .friction_curve import read_friction
from .friction_fit import FrictionFit, fit_friction
from .study import LoadParameter, Study, check_load, load_parameter_of, spanned
from .units import (
    SIGMAS_AT_ENDS,
    SIGMAS_IN_ALL,
    Measured,
    Numbers,
    check_words,
    read,
    read_exact,
    remedy,
)


def read_brake(path: FilePath, trust: bool | str = False) -> Study:
    """Read the data of a brake from a TOML file with one table, ``[brake]``.

    Each quantity is a text with a number, a unit, and optionally a tolerance. Other keys:
    ``correlation = [["k", "k_x", 0.9]]`` for correlated quantities; ``vary = "F_L"`` if a quantity
    other than the friction rises until the state jumps, with ``begin = "10 N"`` unless it starts at
    its smallest value; ``state = { phi = "-28 deg" }`` if another state than the reference state is
    followed; ``may_change = { k = "[100, 250] N/mm" }`` for the only quantities that a redesign may
    change, with ranges; ``title = "Front brake"`` and ``date = 2026-03-01`` for the head of the
    report. ``trust`` is True if the code of a model folder that the file names may be run, or the
    name of the only folder for which it may. Mistakes raise a ParameterError with the file, the
    line, the key, the value, and what to write.
    """
    return FileReader(path_text(path), brake_text(path)).read(trust)


class DataFile:
    """The text of a file in TOML; errors bear the file and the line."""

    def __init__(self, path: str, text: str) -> None:
        self.path, self.text, self.lines = path, text, text.splitlines()

    def of(self, key: str, pattern: str = r"""\s*(?:brake\s*\.\s*)?["']?{}["']?\s*=""") -> str:
        """File and line of a key, for messages."""
        found = (
            number
            for number, line in enumerate(self.lines, 1)
            if re.match(pattern.format(re.escape(key)), line)
        )
        number = next(found, None)
        return f"{self.path}, line {number}" if number else self.path

    def beside(self, key: str = "") -> Path:
        """The folder in which files that a key names are looked for."""
        return Path(self.path).parent

    def table(self, name: str) -> str:
        """File and line of a table."""
        return self.of(name, r"""\s*\[\s*["']?{}["']?\s*\]""")

    @contextmanager
    def at(self, key: str, before: str = "") -> Iterator[None]:
        """Context that adds file and line of a key to errors."""
        try:
            yield
        except SpragsymError as error:
            raise ParameterError(f"{self.of(key)}: {before}{error}") from error

    def content(self) -> dict[str, Any]:
        """The data of the text."""
        try:
            return toml_of(self.text)
        except ValueError as error:
            raise ParameterError(self._syntax(str(error))) from error

    def _syntax(self, message: str) -> str:
        """Message for a syntax error, with the line and an example, from that of tomllib."""
        found = re.search(r" \(at line (\d+), column \d+\)", message)  # else at the end
        number = int(found[1]) if found else len(self.lines)
        line = self.lines[number - 1].strip() if 0 < number <= len(self.lines) else ""
        key = line.partition("=")[0].strip()
        example = example_of(key, quantities(USUAL).units.get(key, "kg"))
        cure = f'text stands in quotes, as in {key if key.isidentifier() else "m"} = "{example}"'
        if "overwrite" in message or "twice" in message:
            cure = f"{key} is there twice; keep one of the two"
        return f"{self.path}, line {number}: {line!r} is not TOML; {cure}"


class FileReader(DataFile):
    """Reader of a file with a table [brake]."""

    def read(self, trust: bool | str) -> Study:
        """The study that the file describes."""
        table = self._table()
        for key, value in table.items():
            printed(self.of(key), {key: value})
        # Keys other than quantities.
        keys = [
            "friction",
            "damping_ratio",
            "correlation",
            "model",
            "vary",
            "begin",
            "state",
            "may_change",
            "title",
            "date",
        ]
        own = {key: table.pop(key, None) for key in keys}
        with self.at("model", "model = "):
            kind = _trusted(USUAL if own["model"] is None else own["model"], trust)
        model = kind.model.where
        damped = quantities(WITH_DAMPERS.get(model, model))
        dampers = damped.units.keys() - kind.units.keys()
        if own["damping_ratio"] is not None or table.keys() & dampers:
            kind = damped
        # Checks without sizes of units come first, because these need the slow import of pint.
        ranges, found = kind.ranges(), dict[str, Measured]()
        for key, value in table.items():
            with self.at(key):
                if key not in kind.units:
                    allowed = [*kind.units, *keys]
                    remark = hint(key, allowed) or f"; the keys are {', '.join(allowed)}"
                    raise ParameterError(
                        f"{key} = {value!r} is not a quantity of the model {model}{remark}"
                    )
                unit = kind.units[key]
                looked_at(read if unit == "1" else check_words, key, value, unit, ranges[key])
        with self.at("damping_ratio"):
            ratio = own["damping_ratio"]
            if ratio is not None:
                ratio = looked_at(read_exact, "damping_ratio", ratio, "1", RATIO)
        with self.at("vary"):
            check_load(kind, own["vary"])
        self._check_missing(table.keys(), own, kind, dampers)
        for key, value in table.items():
            with self.at(key):
                found[key] = looked_at(read, key, value, kind.units[key], ranges[key])
        with self.at("friction", f"friction = {own['friction']!r}: "):
            fit = None if own["friction"] is None else self._friction(own["friction"], found, kind)
        data: dict[str, Any] = {"model": kind.model.where, "damping_ratio": ratio, "fit": fit}
        data |= {key: str(own[key] or "") for key in ("title", "date")}
        with self.at("correlation"):
            data["correlation"] = _correlation(own["correlation"], found, fit, kind.friction)
        with self.at("state"):
            data["state"] = _state(own["state"] or {}, kind)
        with self.at("may_change"):
            data["may_change"] = _may_change(own["may_change"] or {}, kind)
        with self.at("vary" if own["begin"] is None else "begin"):
            data["load"] = _rise(own["vary"], own["begin"], kind, found)
        with self.at("damping_ratio"):
            if ratio is not None:
                found |= modal_dampers(kind, found, ratio)
        measured = {key: found[key] for key in kind.units if key in found}
        return Study.of(**data, source=Path(self.path).name, quantities=measured)

    def _check_missing(
        self, given: Set[str], own: Mapping[str, Any], kind: Quantities, dampers: Set[str]
    ) -> None:
        """Raise if a quantity is missing; ``dampers`` are those that a damping ratio provides."""
        needed = (
            {*kind.of_the_law} if own["friction"] is None else {*kind.of_the_law, kind.friction}
        )
        missing = [key for key in kind.units if key not in given | needed]
        if missing and own["damping_ratio"] is not None:
            missing = [key for key in missing if key not in (dampers or kind.dampers)]
        if missing:
            wanted = ", ".join(f'{key} = "{example_of(key, kind.units[key])}"' for key in missing)
            raise ParameterError(
                f"{self.table('brake')}: [brake] is without {', '.join(missing)}; add lines "
                f"such as {wanted}"
            )

    def _table(self) -> dict[str, Any]:
        """The table [brake], the only one in the file."""
        content = self.content()
        if "matrices" in content:
            raise ModelError(
                f"{self.path} is a brake of matrices, which tell small vibrations about one state "
                f"of sliding: ask spragsym squeal {self.path}; equilibria, folds, cusps, jumps, "
                "motions, cycles, fates and basins are not asked of it, nor is it explored"
            )
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

    def _friction(self, given: object, found: dict[str, Measured], kind: Quantities) -> FrictionFit:
        """Fit of the measured friction in a file; adds μ₀ and d with their standard errors, as
        normal distributions, to the quantities.
        """
        if not isinstance(given, str) or not given.strip():
            raise ParameterError('it is no file name; write friction = "measured.csv"')
        if not kind.has_friction or kind.friction is None:
            raise ParameterError("this model has another friction law; give its quantities instead")
        for key in (kind.friction, "d"):
            if key in found:
                raise ParameterError(f"{key} is given too; leave out one of the two")
        fit = fit_friction(*read_friction(self.beside("friction") / given))
        found |= {
            kind.friction: _fitted(fit.mu0, fit.mu0_error, ""),
            "d": _fitted(fit.d, fit.d_error, "s/m"),
        }
        return fit


def _trusted(name: object, trust: bool | str) -> Quantities:
    """The quantities of a model; raises for a folder whose code is not trusted."""
    if not isinstance(name, str):
        raise ParameterError(f'{name!r} is no name; write model = "kang_nam"')
    code = name[:4096].replace("\0", "")
    if name not in shipped() and os.path.isdir(code):
        require_trust(name, code, trust)
    return quantities(name)


def looked_at(how: Callable[..., T], key: str, given: object, unit: str, allowed: Range) -> T:
    """Result of ``how``, a function to read or check a text, for the value of a key."""
    example = OWN_EXAMPLES.get(key, "")
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
            f"{remedy(unit, allowed, example, exact=how is read_exact)}"
        )
    try:
        return how(given if isinstance(given, str) else repr(given), unit, allowed, example)
    except ParameterError as error:
        raise ParameterError(f"{key} = {error}") from error


def _correlation(
    given: object, found: dict[str, Measured], fit: FrictionFit | None, friction: str | None
) -> Correlation:
    """Correlations of quantities: those in the file, and that of μ₀ and d of a fit."""
    rows: list[Any] = given if isinstance(given, list) else [] if given is None else [given]
    varying = [name for name, one in found.items() if one.varies]
    if fit is not None and {friction, "d"} <= set(varying):
        rows = [*rows, [friction, "d", fit.correlation]]
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
    pairs = {(one, other): value for one, other, value in rows}
    if len(set(map(frozenset, pairs))) < len(rows):
        raise ParameterError(
            f"correlation = {given!r} has a pair twice, or that of the measured file; keep "
            "one of them"
        )
    dependence(varying, pairs)
    return pairs


def _state(given: object, kind: Quantities) -> Numbers:
    """Coordinates of the state to follow, in SI."""
    units = kind.coordinates
    if not isinstance(given, dict) or not set(given) <= set(units):
        example = ", ".join(
            f'{name} = "{"30 deg" if unit == "rad" else "2 mm"}"' for name, unit in units.items()
        )
        raise ParameterError(
            f"state = {given!r} does not name coordinates; write state = {{ {example} }}"
        )
    return {
        name: looked_at(read_exact, name, text, units[name], FINITE) for name, text in given.items()
    }


def _may_change(given: object, kind: Quantities) -> Ranges:
    """Ranges of the quantities that a redesign may change, in SI."""
    if not isinstance(given, dict) or not set(given) <= set(kind.units):
        name = next(iter(kind.may_rise), next(iter(kind.units)))
        cure = f'write may_change = {{ {name} = "{example_of(name, kind.units[name])}" }}'
        raise ParameterError(f"may_change = {given!r} does not name quantities; {cure}")
    ends = {
        name: looked_at(read, name, text, kind.units[name], kind.ranges()[name])
        for name, text in given.items()
    }
    return {name: spanned(kind, name, (one.low, one.high)) for name, one in ends.items()}


def _rise(
    vary: Any, begin: Any, kind: Quantities, found: dict[str, Measured]
) -> LoadParameter | None:
    units = kind.units
    if begin is not None and vary in units:
        begin = looked_at(read_exact, "begin", begin, units[vary], FINITE)
    return load_parameter_of(kind, vary, begin, {name: one.value for name, one in found.items()})


def _fitted(value: float, error: float, unit: str) -> Measured:
    """A fitted value with a normal distribution; if this would include 0, it is cut off at three
    standard errors and above 0.
    """
    cut = error == 0 or value <= SIGMAS_IN_ALL * error
    return Measured(
        value,
        max(value - SIGMAS_AT_ENDS * error, value / 100),
        value + SIGMAS_AT_ENDS * error,
        unit,
        error,
        cut,
    )
