"""``spragsym figures``: the article's figures as files."""

from __future__ import annotations

import inspect
import os
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from ..errors import ParameterError
from ..motion.sweeps.workers import Map, pool
from ..names import hint
from .commands import command
from .options import workers
from .targets import force, refuse


@command()
@click.option(
    "--only",
    "first",
    multiple=True,
    metavar="NAME...",
    help="Only these: numbers of the article's figures, or names, with blanks or commas.",
)
@click.argument("more", nargs=-1, metavar="")
@click.option(
    "--out",
    "-o",
    type=click.Path(file_okay=False, path_type=Path),
    required=True,
    help="Folder to write to, made if missing.",
)
@click.option("--format", "kinds", default="pdf", show_default=True, help="pdf, png, svg, or several with commas.")
@workers(-1)
@click.option("--quiet", "-q", is_flag=True, help="No progress bar.")
@force
def figures(first: tuple[str, ...], more: tuple[str, ...], out: Path, kinds: str, workers: int, quiet: bool, force: bool) -> None:
    """Draw the article's Figures 3 to 14, and some that it lacks.

    Those are cusp-friction, false-double-root, rms-map and sensitivity.

    Beside each figure go its caption (.txt) and the data of its panels (.csv). The same bytes every time.

    \b
    Examples:
      spragsym figures --out figures
      spragsym figures --only 4 12 --out figures --format pdf,png
      spragsym figures --only rms-map --out figures

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    if more and not first:
        raise ParameterError(f"{' '.join(more)}: names of figures go after --only")
    import matplotlib

    matplotlib.use("Agg")  # files only; no display is needed
    from ..figures import FIGURES, FORMATS, write

    formats = _chosen([kinds], FORMATS, "--format")
    names = _chosen([*first, *more], FIGURES, "--only") if first else list(FIGURES)
    refuse((path for name in names for path in _written_before(out, _stem(name), formats)), force, made=True)
    with _processes(workers) as mapping, _bar(len(names), quiet) as advance:
        for name in names:
            advance(name)
            draw = FIGURES[name]
            moving = {"workers": mapping} if "workers" in _options(draw) else {}
            for path in write(draw(**moving), out, _stem(name), formats):
                click.echo(path)


def _chosen(given: list[str], allowed: Mapping[str, Any], option: str) -> list[str]:
    """Names, separated by blanks or commas."""
    names = [name for text in given for name in re.split(r"[\s,]+", text.strip(" ,"))]
    for name in names:
        if name not in allowed:
            raise ParameterError(f"{option}: {name!r} is not one of {', '.join(allowed)}{hint(name, allowed)}")
    return list(dict.fromkeys(names))


def _stem(name: str) -> str:
    return f"figure_{name.replace('-', '_')}"


def _written_before(out: Path, stem: str, formats: list[str]) -> list[Path]:
    """Files of a figure that would be overwritten."""
    return [*(out / f"{stem}.{kind}" for kind in (*formats, "txt")), *sorted(out.glob(f"{stem}_[a-z].csv"))]


def _options(function: Callable[..., Any]) -> set[str]:
    return set(inspect.signature(function).parameters)


@contextmanager
def _processes(workers: int) -> Iterator[int | Map]:
    """1, or the map of a pool that all figures share, since a process takes a second to start."""
    count = os.cpu_count() or 1 if workers == -1 else workers
    if count == 1:
        yield 1
        return
    with pool(count) as processes:
        yield processes


@contextmanager
def _bar(total: int, quiet: bool) -> Iterator[Callable[[str], None]]:
    """A progress bar on stderr; it yields a function to be called with each figure's name before that is drawn."""
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), disable=quiet) as progress:
        task = progress.add_task("figures", total=total)
        begun = 0

        def advance(name: str) -> None:
            nonlocal begun
            progress.update(task, description=f"figure {name}", completed=begun)
            begun += 1

        yield advance
        progress.update(task, description="figures", completed=total)
