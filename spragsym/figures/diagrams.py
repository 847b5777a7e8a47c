"""A bifurcation diagram of any model: equilibria and cycles over one parameter, as AUTO and MatCont draw it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .labels import shown
from .oscillation import COLOURS, draw_cycles, draw_stretches
from .style import BLACK, DOUBLE, GREY, Sheet, Table, say, single

if TYPE_CHECKING:
    from ..orbits.diagram import Diagram, Label

#: Of labels; those that are not here are left to the table.
MARKERS = {"LP": "s", "H": "D", "LPC": "s", "PD": "o", "NS": "^", "BPC": "x", "HC": "*"}

#: Two labels of one kind nearer than this share of the frame are written once.
CLOSE = 0.04


def diagram_figure(found: Diagram) -> Sheet:
    """First coordinate over the parameter: equilibria black, lift-off grey; of cycles, in colours, the largest and the least."""
    figure, ax = single(DOUBLE, 3.6)
    (title, unit), (height, one) = (shown(found.model, name) for name in (found.vary, found.name))
    tables: dict[str, Table] = {}
    for i, rest in enumerate(found.equilibria):
        colour = BLACK if rest.mode == "contact" else GREY
        draw_stretches(ax, unit * rest.values, one * rest.states[:, 0], rest.stable, colour, 1.1)
        tables[f"equilibria_{i + 1}"] = {found.vary: rest.values, found.name: rest.states[:, 0], "stable": rest.stable}
    for i, branch in enumerate(found.cycles):
        colour = COLOURS[i % len(COLOURS)]
        draw_cycles(ax, branch, unit, one * branch.highest, lambda cycle: one * cycle.state[0], colour)
        draw_cycles(ax, branch, unit, one * branch.lowest, lambda cycle: one * (cycle.state[0] - 2 * cycle.amplitude), colour)
        tables[f"cycles_{i + 1}"] = {
            found.vary: branch.values, "period": branch.periods, "lowest": branch.lowest, "highest": branch.highest,
            "stable": branch.stable,
        }  # fmt: skip
    ax.set(xlim=(unit * found.to[0], unit * found.to[1]))
    ax.set(xlabel=title, ylabel=f"{height}: rest, cycles from least to largest")
    ax.margins(y=0.12)
    named: list[tuple[str, float, float]] = []
    low, high = ax.get_ylim()
    for label in found.labels:
        if label.label not in MARKERS:
            continue
        at = unit * label.value, one * label.height
        ax.plot(*at, MARKERS[label.label], color=BLACK, markersize=4, markerfacecolor="white", zorder=4)
        place = ((label.value - found.to[0]) / (found.to[1] - found.to[0]), (at[1] - low) / (high - low))
        if any(name == label.label and abs(place[0] - x) + abs(place[1] - y) < CLOSE for name, x, y in named):
            continue
        named.append((label.label, *place))
        ax.annotate(label.label, at, xytext=_aside(label, place), textcoords="offset points", fontsize=7)
    if not (found.equilibria or found.cycles):
        say(ax, "no equilibria and no cycles found here")
    tables["labels"] = {
        "label": np.array([label.label for label in found.labels]), found.vary: np.array([label.value for label in found.labels]),
        found.name: np.array([label.height for label in found.labels]),
    }  # fmt: skip
    return figure.describe(
        f"""Equilibria (black; grey without contact) and cycles (colours, least and largest {found.name}) over {found.vary}: full
        where stable, dashed where not. LP folds and H Hopf points of equilibria; of cycles LPC folds, PD period doublings, NS
        tori, BPC crossings, HC homoclinic ends. Cycles are those that were followed from Hopf points, starts and doublings: there
        may be others.""",
        **tables,
    )


def _aside(label: Label, place: tuple[float, float]) -> tuple[float, float]:
    """Where the text of a label stands, in points: inside of the frame."""
    if label.label == "H":
        return (-11.0, 5.0)
    return (-16.0 if place[0] > 0.93 else 4.0, -10.0 if place[1] > 0.93 or label.of == "equilibria" else 4.0)
