"""``spragsym explore``: the explorer as one page, opened in the browser."""

from __future__ import annotations

import os
import sys
import webbrowser
from pathlib import Path

import click

from .. import assumed
from ..errors import ParameterError
from ..explorer import Preset, explorer_page
from .targets import force, holds, refuse

#: The model that the exported JavaScript solves.
ARTICLE_MODEL = "kang_nam"


@click.command()
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    default=Path("explorer.html"),
    show_default=True,
    help="File to write.",
)
@click.option(
    "--data",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Begin at your own data, a file like brake.toml.",
)
@click.option("--model", default=ARTICLE_MODEL, show_default=True, metavar="NAME", help="Model to explore.")
@click.option(
    "--no-open", "unopened", is_flag=True, help="Only write it; otherwise the browser opens it, where there is a display."
)
@force
def explore(out: Path, data: Path | None, model: str, unopened: bool, force: bool) -> None:
    """Write the explorer, one page that computes in the browser and needs no network, and open it.

    It shows the mechanism, the plane of inclination and friction, the surface of all equilibria, every state at a point,
    and the motion in time. A state carried along a path follows its sheet of the surface, and jumps at a fold.

    \b
    Examples:
      spragsym explore
      spragsym explore --data brake.toml
      spragsym explore --out web/explorer.html --no-open

    \b
    Exit codes: 0 written; 1 the file can't be written; 2 usage, or a file that differs is in the way.
    """
    _check_model(model)
    presets, V, d = ((), assumed.V, assumed.D) if data is None else _study(data)
    text = explorer_page(presets, V=V, d=d)
    if not holds(out, text):
        refuse([out], force)
        out.parent.mkdir(parents=True, exist_ok=True)
        out.write_text(text, encoding="utf-8", newline="\n")
    click.echo(out)
    if unopened:
        return
    if _has_display():
        webbrowser.open(out.resolve().as_uri())
    else:
        click.echo("there is no display; open the file in a browser", err=True)


def _check_model(name: str) -> None:
    """Raise for every model whose equilibria the exported JavaScript does not have."""
    from ..models.load import shipped

    if name not in shipped():
        raise ParameterError(f"--model {name} is no model; the models are {', '.join(shipped())}")
    if name != ARTICLE_MODEL:
        raise ParameterError(
            f"--model {name}: this model is not exported to JavaScript, so the page can't compute it; "
            f"use {ARTICLE_MODEL}, the article's, or spragsym.load({name!r}) in Python"
        )


def _study(path: Path) -> tuple[tuple[Preset, ...], float, float]:
    """The user's point, and belt speed and steepness of the friction law if the file has them."""
    from ..studies import Study

    study = Study.from_file(path)
    _check_model(study.model)
    drive = {"V": assumed.V, "d": assumed.D} | (study.parameters.belt() if study.moves else {})
    return (Preset.of(f"Your data: {path.name}", study.dimensionless),), float(drive["V"]), float(drive["d"])


def _has_display() -> bool:
    return sys.platform in ("win32", "darwin") or any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY"))
