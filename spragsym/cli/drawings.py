"""Figures that commands draw: written to a file, their axes in the units of the answer."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..errors import ParameterError
from ..files.writing import put
from ..progress import show_progress

if TYPE_CHECKING:
    from ..figures.labels import Shown
    from ..figures.style import Sheet


def drawable(path: Path) -> None:
    """Raise for a file of a kind that figures are not written in."""
    if path.suffix not in (".pdf", ".png", ".svg"):
        raise ParameterError(f"--plot {path}: the ending must be .pdf, .png or .svg")


def written(path: Path, part: str, make: Callable[[], Sheet], axes: Iterable[tuple[Shown | None, Shown | None]] = ()) -> None:
    """Draw a figure in its house's style, and write it; ``axes`` says of each panel what its two axes show, None as it is."""
    from ..figures.files import picture
    from ..figures.labels import in_units
    from ..figures.style import house_style

    with house_style(), show_progress(part):
        figure = make()
        for ax, (across, up) in zip(figure.axes, axes, strict=False):
            in_units(ax.xaxis, across)
            in_units(ax.yaxis, up)
        put(path, picture(figure, path.suffix[1:]))
    click.echo(f"drew {path}", err=True)
