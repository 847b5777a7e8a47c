"""Frequencies and damping ratios of a brake of matrices over a parameter, and its page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ..files.text import filled
from ..matrices.answers import MatrixOnsets
from ..models.parameters import FloatArray, Span
from ..report.squeal import SquealReport, SquealStudy
from .curves import shade
from .report_pages import picture
from .style import BLUE, SKY, VERMILION, Sheet, own_axes, panels, symbol


def squeal_figure(found: MatrixOnsets, band: Span | None = None) -> Sheet:
    """Frequency and damping ratio of the modes over the parameter; ``band`` are frequencies in Hz
    of those that are shown.
    """
    figure, ((top,), (low,)) = panels(2, 1, 5.0, 5.6, sharex=True)
    draw_squeal(found, top, band=band)
    draw_squeal(found, low, band=band, damping=True)
    top.set_xlabel("")
    return figure.describe(_caption(found))


def _caption(found: MatrixOnsets) -> str:
    name = found.vary
    text = (
        f"Modes over {name}, by floats; orange: they grow faster than {found.threshold:.3g} 1/s. "
    )
    text += f"Lines: the onsets. Shaded: some mode grows so, proved for each {name} in it."
    return text + " Hatched: undecided." * bool(len(found.undecided))


def draw_squeal(
    found: MatrixOnsets,
    ax: Axes | None = None,
    *,
    band: Span | None = None,
    damping: bool = False,
    **options: Any,
) -> list[object]:
    """Draw frequencies of the modes over the parameter, or their damping ratios if ``damping``;
    shaded where one grows faster than the threshold.
    """
    ax, (low, high) = own_axes(ax), found.between
    values, each = found.eigenvalues
    hertz = each.imag / (2.0 * np.pi)
    shown = np.ones(len(each), dtype=bool)
    if band is not None:
        shown = (hertz >= band[0]) & (hertz <= band[1])
    heights = -each.real / np.maximum(np.abs(each), 1e-300) if damping else hertz
    drawn: list[object] = []
    for growing, colour, word in ((False, BLUE, "decays"), (True, VERMILION, "grows")):
        here = shown & ((each.real > found.threshold) == growing)
        style = {"color": colour, "markersize": 1.6, "label": word, **options}
        drawn += ax.plot(values[here], heights[here], ".", **style)
    for start, end, count in found.growing:
        if count:
            ax.axvspan(start, end, facecolor=SKY, alpha=0.3, linewidth=0.0, zorder=0)
    for number, row in enumerate(found):
        word = "_an onset" if number else "an onset"
        style = {"color": VERMILION, "linewidth": 0.7, "linestyle": ":", "label": word}
        ax.axvline(row[found.vary], **style)
    shade(ax, found.parameters.model, found.vary, found.undecided)
    if damping:
        ax.axhline(0.0, color="#777777", linewidth=0.8, label="no damping")
        ax.set_ylabel("damping ratio")
    else:
        ax.set_ylabel("frequency in Hz")
        ax.set_ylim(*(band or (0.0, None)))
    ax.set_xlim(low, high)
    ax.set_xlabel(f"${symbol(found.vary)}$")
    return drawn


def map_figure(
    study: SquealStudy, name: str, rows: Sequence[Mapping[str, Any]], values: FloatArray
) -> Sheet:
    """Onsets along one parameter at values of another, shaped by the direction they set in."""
    figure, ((ax,),) = panels(1, 1, 5.0, 4.0)
    for direction, marker, word in (("up", "^", "grows above"), ("down", "v", "grows below")):
        here = [row for row in rows if row["direction"] == direction]
        where = [row[name] for row in here], [row[study.vary] for row in here]
        ax.plot(*where, marker, color=VERMILION, markersize=4.0, label=word)
    for value in values:
        ax.axvline(float(value), color="#777777", linewidth=0.4, zorder=0)
    ax.set_ylim(*study.between)
    ax.set_xlabel(f"${symbol(name)}$")
    ax.set_ylabel(f"${symbol(study.vary)}$")
    ax.legend()
    return figure.describe(f"Onsets of squeal: {study.vary} at values of {name}, the grey lines.")


def squeal_page(report: SquealReport) -> str:
    """Text of a self-contained HTML page with a report on squeal (extra ``plot``)."""
    study, found = report.study, report.onsets
    draw = partial(draw_squeal, found, band=study.band)
    captions = (
        _caption(found),
        f"Damping ratios of the same modes over {study.vary}; below 0 they grow.",
    )
    return filled(
        "spragsym.figures",
        "report.html",
        "the page of a report",
        title=study.title or "Squeal report",
        about=f"{study.source}, {study.parameters.model.about['summary']}",
        verdict=report.verdict(),
        at_risk=report.squeals,
        steps=[],
        warnings=report.remarks(),
        drawn=[
            (picture(partial(draw, damping=damping)), caption)
            for damping, caption in zip((False, True), captions, strict=True)
        ],
        headed=report.sections().items(),
        mechanism="",
        drawing="",
    )
