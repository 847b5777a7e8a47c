"""The verdict on a brake over one of its quantities, or two."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from matplotlib.figure import Figure

from ..report.over import OUTCOMES, Verdicts

#: Of each outcome, from the worst on.
_COLOURS = dict(
    zip(
        OUTCOMES.values(),
        ("#D55E00", "#E69F00", "#CC79A7", "#0072B2", "#56B4E9", "#999999"),
        strict=True,
    )
)


def verdict_figure(found: Verdicts) -> Figure:
    """Jump and margin over one quantity; or the outcomes in the plane of two."""
    figure, columns = Figure(layout="constrained"), [*zip(*found.rows, strict=True)]
    several = len(found.titles) == 6
    outcome = np.array(columns[-2])
    panels = figure.subplots(1 if several else 2, sharex=True, squeeze=False)[:, 0]
    first = np.array(columns[0], dtype=float)
    for row, ax in enumerate(panels):
        values = np.array(columns[1 + row], dtype=float)
        for word in dict.fromkeys(outcome.tolist()):
            here = outcome == word
            ax.plot(first[here], values[here], "o", color=_COLOURS[word], label=word, markersize=4)
        if not several:
            ax.plot(first, values, color="#777777", linewidth=0.8, zorder=0)
        ax.set_ylabel(found.titles[1 + row])
    if not several:
        panels[1].axhline(0.0, color="#777777", linewidth=0.8)
        for (one, before), (two, after) in pairwise(zip(first, columns[-1], strict=True)):
            if before and after and before != after:
                panels[0].axvspan(one, two, color="#DDDDDD", label=f"{before} | {after}")
    panels[-1].set_xlabel(found.titles[0])
    panels[0].legend(fontsize="small")
    return figure
