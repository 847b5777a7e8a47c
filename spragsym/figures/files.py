"""A figure as files: the picture, its caption and the data of its panels; the same bytes every time."""

from __future__ import annotations

import csv
import io
import textwrap
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from ..files.storage import put
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
    files: dict[str, bytes | str] = {}
    with house_style():
        for kind in formats:
            files[f"{stem}.{kind}"] = picture(figure, kind)
    files[f"{stem}.txt"] = textwrap.fill(figure.caption, 100) + "\n"
    files |= {f"{stem}_{panel}.csv": _table(table) for panel, table in figure.tables.items()}
    for name, content in files.items():
        put(folder / name, content, made=True)
    return [folder / name for name in files]


def picture(figure: Any, kind: str) -> bytes:
    """A figure in a format."""
    stream = io.BytesIO()
    figure.savefig(stream, format=kind, metadata=FORMATS[kind])
    return stream.getvalue()


def _table(table: Table) -> str:
    """One line per row; numbers with the twelve digits that the library promises."""
    columns, text = [_as_text(np.asarray(values)) for values in table.values()], io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(table)
    writer.writerows(zip(*columns, strict=True))
    return text.getvalue()


def _as_text(values: Any) -> list[str]:
    return [f"{value:.12g}" if isinstance(value, float) else str(value) for value in values.tolist()]
