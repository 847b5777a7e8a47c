"""``spragsym figures``: the article's figures as files."""

import inspect
import os
import re
from collections.abc import Mapping
from contextlib import nullcontext
from pathlib import Path
from typing import Any

import click

from ..errors import ParameterError, hint
from ..motion.sweeps.workers import pool
from ..progress import advance
from . import options as o
from .output import refuse


def _names(_: click.Context, option: click.Parameter, given: tuple[str, ...]) -> list[str]:
    """Names of figures; looked at before what is missing is an error."""
    if not given:
        return []
    from ..figures import FIGURES

    return _chosen([*given], FIGURES, option.opts[0] if option.opts[0].startswith("-") else "NAMES")


@o.command()
@click.option("--only", "first", multiple=True, callback=_names, metavar="NAME...", help="As NAMES.")
@click.argument("names", nargs=-1, callback=_names)
@o.folder("Folder to write to, made if missing.")
@click.option("--format", "kinds", default="pdf", help="pdf, png, svg, or several with commas.")
@o.workers(-1)
@o.quiet
@o.force
def figures(first: list[str], names: list[str], out: Path, kinds: str, workers: int, quiet: bool, force: bool) -> None:
    """Draw the article's Figures 3 to 14, and some that it lacks: all, or NAMES.

    Those are cusp-friction, false-double-root, rms-map and sensitivity. NAMES are separated by blanks or commas.

    Beside each figure go its caption (.txt) and the data of its panels (.csv). The same bytes every time.

    \b
    Examples:
      spragsym figures --out figures
      spragsym figures 4 12 --out figures --format pdf,png
      spragsym figures rms-map --out figures
    """
    import matplotlib

    matplotlib.use("Agg")  # files only; no display is needed
    from ..figures import FIGURES, FORMATS, write

    formats = _chosen([kinds], FORMATS, "--format")
    names = list(dict.fromkeys([*first, *names])) or list(FIGURES)
    refuse((path for name in names for path in _written_before(out, _stem(name), formats)), force, made=True)
    count = os.cpu_count() or 1 if workers == -1 else workers
    # One pool for all figures, since a process takes a second to start.
    with nullcontext(1) if count == 1 else pool(count) as mapping, advance(not quiet, len(names), 0) as step:
        for name in names:
            draw = FIGURES[name]
            moving = {"workers": mapping} if "workers" in inspect.signature(draw).parameters else {}
            for path in write(draw(**moving), out, _stem(name), formats):
                click.echo(path)
            step()


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
