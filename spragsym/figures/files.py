"""A figure as files: the picture, its caption and the data of its panels; the same bytes every time."""

from __future__ import annotations

import csv
import textwrap
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from .style import Sheet, Table, house_style

#: Format → metadata that leaves out the date and the version of what drew it.
FORMATS: dict[str, dict[str, Any]] = {
    "pdf": {"CreationDate": None, "Producer": None, "Creator": None},
    "png": {"Software": None},
    "svg": {"Date": None, "Creator": None},
}


def write(figure: Sheet, folder: Path, stem: str, formats: Iterable[str] = ("pdf",)) -> list[Path]:
    """Write ``stem.pdf`` and the like, its caption to ``stem.txt``, its data to ``stem_a.csv`` …; returns the paths.

    Parts that are not drawn as lines have 300 dots per inch.
    """
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    with house_style():
        for kind in formats:
            paths.append(folder / f"{stem}.{kind}")
            figure.savefig(paths[-1], format=kind, metadata=FORMATS[kind])
    paths.append(folder / f"{stem}.txt")
    paths[-1].write_text(textwrap.fill(figure.caption, 100) + "\n", encoding="utf-8", newline="\n")
    for panel, table in figure.tables.items():
        paths.append(folder / f"{stem}_{panel}.csv")
        _write_table(paths[-1], table)
    return paths


def _write_table(path: Path, table: Table) -> None:
    """One line per row; numbers with the twelve digits that the library promises."""
    columns = [_as_text(np.asarray(values)) for values in table.values()]
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(table)
        writer.writerows(zip(*columns, strict=True))


def _as_text(values: Any) -> list[str]:
    return [f"{value:.12g}" if isinstance(value, float) else str(value) for value in values.tolist()]
