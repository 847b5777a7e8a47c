"""Output of commands: tables, styled on a terminal and plain in a pipe; JSON; and files, which are
overwritten with --force only.
"""

from __future__ import annotations

import shutil
import sys
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import click
from click.core import ParameterSource

from ..core.errors import TargetError
from ..core.progress import show_progress
from ..core.shown import json_text, without_nan
from ..display import aligned
from ..files.storage import OVERWRITING, probe, put

if TYPE_CHECKING:
    from ..figures.style import Shown

#: How the floats of a column are written, by its title.
Formats: TypeAlias = Mapping[str, Callable[[float], str]]


def line_width() -> int:
    """Width of the terminal; 0 in a pipe, where lines are not wrapped."""
    if sys.stdout is None or not sys.stdout.isatty():
        return 0
    return shutil.get_terminal_size().columns


def wrapped(text: str, indent: int = 0) -> str:
    """A text wrapped to the terminal, of which the first ``indent`` columns are in use."""
    if not line_width():
        return text
    width = max(line_width() - indent, 20)
    return f"\n{' ' * indent}".join(textwrap.wrap(text, width))


def print_rows(
    title: str,
    rows: Sequence[Mapping[str, Any]],
    optional: Sequence[str] = (),
    formats: Formats | None = None,
) -> None:
    """Print rows with the same columns as a table under a title; without rows, "title: none".

    Floats have as many digits as fit into the line, up to twelve, unless ``formats`` says how
    those of a column are written. If five digits do not fit, ``optional`` columns are left out,
    in their order.
    """
    if title:
        click.echo(click.style(title, bold=True) if rows else f"{title}: none")
    if rows:
        columns = _fitted(
            [(name, [row[name] for row in rows]) for name in rows[0]], optional, formats or {}
        )
        head, *lines = aligned(list(zip(*columns, strict=True)))
        if head.strip():
            click.secho(head, bold=True)
        click.echo("\n".join(lines))


def _fitted(
    columns: Sequence[tuple[str, Sequence[object]]], optional: Sequence[str], formats: Formats
) -> list[list[str]]:
    """Each column as its name and its cells as text, if possible within the line (at least 80)."""
    most_digits, least_digits = 12, 5
    written: list[list[str]] = []
    for left_out in range(len(optional) + 1):
        used = [(name, cells) for name, cells in columns if name not in optional[:left_out]]
        for digits in range(most_digits, least_digits - 1, -1):
            written = [
                [
                    name,
                    *(
                        _written(cell, formats.get(name, f"{{:.{digits}g}}".format))
                        for cell in cells
                    ),
                ]
                for name, cells in used
            ]
            width = sum(max(map(len, column)) + 2 for column in written) - 2
            if width <= max(80, line_width()):
                return written
    return written


def _written(cell: object, of_float: Callable[[float], str]) -> str:
    """A cell as text."""
    return of_float(cell) if isinstance(cell, float) else str(cell)


def print_json(thing: object) -> None:
    """Print JSON; NaN and infinities, which JSON does not have, become null."""
    # Greek letters are escaped if the stream can't write them.
    escaped = not (getattr(sys.stdout, "encoding", None) or "utf").lower().startswith("utf")
    click.echo(json_text(without_nan(thing), indent=1, ascii_only=escaped))


def is_typed(option: str) -> bool:
    """Whether an option is given on the command line."""
    return click.get_current_context().get_parameter_source(option) == ParameterSource.COMMANDLINE


def refuse(paths: Iterable[Path | None], *, made: bool = False, size: int = 0) -> None:
    """Raise, before any work, if a file exists without --force, or can't be written; ``size`` is
    that of all files in bytes, as far as it is known.
    """
    targets = [path for path in paths if path is not None]
    found = [str(path) for path in targets if path.exists()]
    if found and not is_typed("force"):
        exist = "exists" if len(found) == 1 else "exist"
        raise TargetError(
            f"{', '.join(found)} {exist}; nothing was written; use --force to overwrite, or "
            "give another path"
        )
    for path in targets:
        probe(path, size, made=made)


def write(files: Mapping[Path, Any], *, made: bool = False) -> bool:
    """Write texts or bytes to files that differ from them; return whether any did.

    Raises
    ------
    TargetError
        If a file exists with another content, without --force.
    """
    data = {path: held.encode() if isinstance(held, str) else held for path, held in files.items()}
    changed = {
        path: held
        for path, held in data.items()
        if not (path.is_file() and path.read_bytes() == held)
    }
    refuse(changed, made=made, size=sum(map(len, changed.values())))
    for path, content in changed.items():
        put(path, content, made=made)
    return bool(changed)


@contextmanager
def resumed() -> Iterator[None]:
    """Run work that resumes from its file; with ``--force`` it starts anew, and the former file
    stays until the new one is complete.
    """
    token = OVERWRITING.set(is_typed("force"))
    try:
        yield
    except TargetError as error:
        raise TargetError(f"{error}, or use --force to overwrite") from error
    finally:
        OVERWRITING.reset(token)


def drawn(
    path: Path | None,
    part: str,
    make: Callable[[], Any],
    axes: Callable[[], Iterable[Sequence[Shown | None]]] = tuple,
) -> None:
    """Draw a figure to a file, if one is asked for.

    ``axes`` gives for each panel the units of its two axes, None to leave an axis as it is.
    """
    if path is None:
        return
    from ..figures.style import house_style, in_units, picture

    with house_style(), show_progress(part):
        figure = make()
        for ax, shown in zip(figure.axes, axes(), strict=False):
            for axis, one in zip((ax.xaxis, ax.yaxis), shown, strict=True):
                in_units(axis, one)
        put(path, picture(figure, path.suffix[1:]))
    click.echo(f"drew {path}", err=True)
