"""Reports on many brakes: a table with a row a brake, and what the reports say, by risk."""

from __future__ import annotations

import csv
import hashlib
import io
import json
import math
import re
from collections import Counter
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

from ..core.errors import ParameterError, SpragsymError
from ..core.shown import json_text, without_nan
from ..files.cache import digest_of_folder
from ..files.storage import provenance, put
from ..files.text import FilePath, brake_text, json_of, path_text, text_of
from ..motion.sweeps.workers import Workers, results
from .data import FileReader
from .facts import REACHED
from .friction_curve import cells, separator

#: Column of the table with the names of brakes.
NAME = "name"

#: Options of a report, by name.
Options: TypeAlias = Mapping[str, Any]


@dataclass(frozen=True)
class BatchBrake:
    """A row of a table."""

    table: str  #: path of the table
    number: int  #: line in it
    name: str
    stem: str  #: name of its files, without ending
    row: dict[str, str]  #: texts by key, as in brake.toml


class _RowReader(FileReader):
    """Reader of one row, over the keys of a file like brake.toml; errors name the column."""

    def __init__(self, brake: BatchBrake, path: str, text: str) -> None:
        super().__init__(path, text)
        self.brake = brake

    def of(self, key: str, *pattern: str) -> str:
        if key in self.brake.row:
            return f"{self.brake.table}, line {self.brake.number}, column {key}"
        return super().of(key, *pattern)

    def beside(self, key: str = "") -> Path:
        return Path(self.brake.table).parent if key in self.brake.row else super().beside(key)

    def _table(self) -> dict[str, Any]:
        return {**super()._table(), **self.brake.row}

    def made_of(self) -> list[str]:
        """All that the study is made of: its keys, a measured friction, a model's own folder."""
        table = self._table()
        found = [json.dumps(table, default=str)]
        if isinstance(measured := table.get("friction"), str):
            with suppress(OSError, SpragsymError):
                found.append(text_of(self.beside("friction") / measured, 8 * 2**20))
        model = Path(str(table.get("model", "")))
        return found + ([digest_of_folder(model)] if model.is_dir() and model.name else [])


@dataclass(frozen=True)
class BatchReport:
    """What is known of a brake: its report as data, or why there is none."""

    brake: BatchBrake
    told: dict[str, Any] | None
    trouble: str = ""

    @property
    def verdict(self) -> str:
        """The verdict, or why there is none."""
        return self.told["verdict"] if self.told else self.trouble

    @property
    def at_risk(self) -> bool:
        """Whether it jumps, as :attr:`~spragsym.report.facts.Facts.at_risk` says."""
        return self.told is not None and self.told["reach"] in REACHED

    @property
    def risk(self) -> tuple[bool, bool, float, float]:
        """Key by which brakes at risk come first, and those without a report last."""
        row = self.columns()
        odds, margin = row["probability"], row["margin_percent"]
        return (
            not self.told,
            not self.at_risk,
            -(odds or 0.0),
            math.inf if margin is None else margin,
        )

    def columns(self) -> dict[str, Any]:
        """The row of the summary; None for what is not known."""
        told = self.told or {}
        odds, motion = told.get("probability") or {}, told.get("oscillation") or {}
        return {
            "name": self.brake.name,
            "jump_at": (told.get("jump_at") or {}).get("value"),
            "unit": (told.get("jump_at") or {}).get("unit"),
            "margin_percent": told.get("margin_percent"),
            "probability": odds.get("value"),
            "low": odds.get("low"),
            "high": odds.get("high"),
            "motion": motion.get("kind"),
            "frequency_hz": motion.get("frequency_hz"),
            "verdict": self.verdict,
        }


def read_batch(path: FilePath) -> list[BatchBrake]:
    """The rows of a table of brakes: a head with keys of brake.toml, a row a brake.

    The separator is the first of semicolon, tab, bar and comma in the head. A column ``name``
    names brakes, else they are called by their line. An empty cell is no key.

    Raises
    ------
    ParameterError
        For a file that is no such table, or names that stand twice.
    """
    largest = 8 * 2**20
    name, text = path_text(path), text_of(path, largest, "a table such as brakes.csv")
    lines = [
        (number, line)
        for number, line in enumerate(text.splitlines(), 1)
        if line.strip() and not line.lstrip().startswith("#")
    ]
    if len(lines) < 2:
        raise ParameterError(
            f"{name} has no row; give a head with keys of brake.toml, as name,mu0,V, and a row a "
            "brake"
        )
    (first, head), *rows = lines
    between = separator(head, ",")
    keys = cells(head, between)
    twice = [key for key, count in Counter(keys).items() if count > 1]
    if twice or "" in keys:
        raise ParameterError(
            f"{name}, line {first}: the head has {twice[0] if twice else 'an empty cell'!r}"
            f"{' twice' if twice else ''}; give each column a key of its own"
        )
    found = []
    for number, line in rows:
        row = cells(line, between)
        if len(row) != len(keys):
            raise ParameterError(
                f"{name}, line {number} has {len(row)} cells, and the head has {len(keys)}; give "
                'as many, with texts that hold the separator in quotes, as "[0.3, 0.5]"'
            )
        given = {key: cell for key, cell in zip(keys, row, strict=True) if cell}
        called = given.pop(NAME, f"line {number}")
        stem = re.sub(r"[^\w.-]+", "_", called).strip("._") or f"line_{number}"
        found.append(BatchBrake(name, number, called, stem, given))
    same = [
        one for one, count in Counter(one.stem.casefold() for one in found).items() if count > 1
    ]
    if same:
        raise ParameterError(
            f"{name}: two brakes would be written to {same[0]}.json; give each a name of its own"
        )
    return found


def report_batch(
    brakes: Sequence[BatchBrake],
    folder: Path,
    base: FilePath | None = None,
    *,
    page: Callable[[Any], str] | None = None,
    trust: bool | str = False,
    workers: Workers = 1,
    options: Options | None = None,
    force: bool = False,
) -> Generator[BatchReport]:
    """Reports on brakes of :func:`read_batch`, each written to ``folder`` as soon as it is known.

    Those that an earlier call wrote, of the same data by the same version, are read. ``base`` is a
    file like brake.toml with what all brakes share; ``page`` draws the page of a report.

    Raises
    ------
    ParameterError
        If a file in the folder is of other data, without ``force``.
    """
    shared, tasks = dict(options or {}), dict[int, Any]()
    text = "[brake]" if base is None else brake_text(base)
    for index, brake in enumerate(brakes):
        target = folder / f"{brake.stem}.json"
        reader = _RowReader(brake, brake.table if base is None else path_text(base), text)
        made_of = _digest(reader.made_of(), shared)
        known = _known(target, made_of)
        if known is not None and (page is None or target.with_suffix(".html").is_file()):
            yield BatchReport(brake, known)
            continue
        if target.exists() and known is None and not force:
            raise ParameterError(
                f"{target} is of other data, or of another version; give --force, or another folder"
            )
        tasks[index] = reader, target, made_of, trust, shared, page
    for index, (told, trouble) in results(workers, _reported, tasks, lambda one: one[0].brake.name):
        yield BatchReport(brakes[index], told, trouble)


def _digest(made_of: list[str], options: Options) -> str:
    parts = [made_of, {**options}, provenance()]
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()


def _known(target: Path, made_of: str) -> dict[str, Any] | None:
    """The report in a file, if it is one of the same data."""
    with suppress(OSError, SpragsymError, ValueError):
        largest = 2**26
        told = json_of(text_of(target, largest, "a report"))
        if isinstance(told, dict) and told.get("made_of") == made_of and "verdict" in told:
            return told
    return None


def _reported(task: tuple[Any, ...]) -> tuple[dict[str, Any] | None, str]:
    """The report on a brake as data, written to its files; or None and what is wrong with it."""
    reader, target, made_of, trust, options, page = task
    try:
        found = reader.read(trust).report(**options)
    except SpragsymError as error:
        return None, " ".join(str(error).split())
    told = without_nan({"made_of": made_of} | found.to_dict())
    if page is not None:
        put(target.with_suffix(".html"), page(found), made=True)
    put(target, json_text(told, indent=1, ascii_only=False) + "\n", made=True)
    return told, ""


def by_risk(found: Sequence[BatchReport]) -> list[BatchReport]:
    """Brakes at risk first, by probability of a jump and margin; those without a report last."""
    return sorted(found, key=lambda one: (*one.risk, one.brake.number))


def summary_csv(found: Sequence[BatchReport]) -> str:
    """The summary as text with commas."""
    stream = io.StringIO(newline="")
    rows = [one.columns() for one in found]
    writer = csv.DictWriter(stream, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return stream.getvalue()
