"""The verdict on a brake over one of its quantities, or two."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from matplotlib.figure import Figure

from ..design.jumps import verb_of
from ..report.over import OUTCOMES, Verdicts


def verdict_figure(found: Verdicts) -> Figure:
    """Jump and margin over one quantity, or the outcomes in the plane of two; markers are hollow if
    sliding is unstable.
    """
    figure, columns = Figure(layout="constrained"), [*zip(*found.rows, strict=True)]
    several = len(found.titles) == 6
    verdicts = [*zip(*columns[-2:], strict=True)]
    first, jumps = (np.array(column, dtype=float) for column in columns[:2])
    never = np.isnan(jumps).all()  # without a jump only the state is shown
    panels = figure.subplots(1 if several or never else 2, sharex=True, squeeze=False)[:, 0]
    # A colour for each outcome, the worst first.
    scale = ("#D55E00", "#E69F00", "#CC79A7", "#0072B2", "#56B4E9", "#999999")
    colours = {
        outcome.format(verb_of(kind)): colour
        for outcome, colour in zip(OUTCOMES.values(), scale, strict=True)
        for kind in ("fold", "border", "infinity")
    }
    for row, ax in enumerate(panels):
        values, title = np.array(columns[1 + row], dtype=float), found.titles[1 + row]
        if never:
            ax.set_yticks([])
            title += ": none"
        for word, state in dict.fromkeys(verdicts):
            here = np.array([each == (word, state) for each in verdicts])
            style = {"color": colours[word], "markersize": 4, "label": f"{word}, {state}"}
            if state == "unstable":
                style["markerfacecolor"] = "white"
            ax.plot(first[here], values[here], "o", **style)
            missing = first[here & np.isnan(values)]  # without a jump: at the upper edge
            edge = style | {"label": "", "transform": ax.get_xaxis_transform()}
            ax.plot(missing, np.full_like(missing, 0.97), "o", **edge)
        if not several:
            ax.plot(first, values, color="#777777", linewidth=0.8, zorder=0)
        ax.set_ylabel(title)
    if len(panels) == 2:
        panels[1].axhline(0.0, color="#777777", linewidth=0.8)
    if not several:
        for (one, before), (two, after) in pairwise(zip(first, columns[-1], strict=True)):
            if before and after and before != after:
                panels[0].axvspan(one, two, color="#DDDDDD", label=f"{before} | {after}")
    panels[-1].set_xlabel(found.titles[0])
    handles, words = panels[0].get_legend_handles_labels()
    figure.legend(handles, words, loc="outside upper center", ncols=2, fontsize="small")
    return figure
