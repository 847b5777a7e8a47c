"""A report with any model as one page of HTML that needs no other file, with its pictures."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from ..errors import SpragsymError
from ..figures import models as drawings
from ..figures.style import BLUE, SKY
from ..models.load import load
from . import other_models
from .other_reports import ModelReport
from .pages import document, picture
from .study import Study

#: Lines of a bifurcation set, and values along the friction.
_LINES, _VALUES = 40, 240
#: Lines on which onsets of oscillation are looked for.
_ONSETS = 12


def write_other_page(study: Study, report: ModelReport, path: Path) -> None:
    """Write the page."""
    path.write_text(document(study, report, pictures(study, report), report.sections()), encoding="utf-8", newline="\n")


def pictures(study: Study, report: ModelReport) -> Iterator[tuple[str, str]]:
    """Each picture as SVG, with its caption; none of a plane that the model does not have."""
    model = load(study.model)
    if "mu0" not in model.parameters:
        return
    p, _ = other_models.dimensionless(study.model, study.values)
    share = report.mu_effective / float(p.mu0) if float(p.mu0) else 1.0
    ends = {name: (one.low, one.high) for name, one in study.quantities.items()}
    friction = (share * ends["mu0"][0], share * ends["mu0"][1])
    top = max(1.0, 1.15 * friction[1], *(1.15 * value for value in report.folds if value < 3))
    here = p.replace(mu0=report.mu_effective)

    def states(ax: Axes) -> None:
        drawings.draw_equilibria_of(model, here, "mu0", ax=ax, between={"mu0": (0.0, top)}, n=_VALUES)
        ax.axvspan(*friction, color=SKY, alpha=0.25, linewidth=0, zorder=0)
        ax.plot([report.mu_effective] * 2, ax.get_ylim(), color=BLUE, linewidth=0.8)

    def with_brake(draw: Callable[[Axes], Any]) -> str:
        def both(ax: Axes) -> None:
            draw(ax)
            low, high = np.degrees(ends["theta0"])
            size = high - low, friction[1] - friction[0]
            ax.add_patch(Rectangle((low, friction[0]), *size, facecolor=SKY, edgecolor=BLUE, alpha=0.6))
            ax.plot([float(np.degrees(p.theta0))], [report.mu_effective], "o", color=BLUE, markersize=4.5, zorder=5)

        return picture(both)

    if "theta0" in model.parameters:
        plane, between = ("theta0", "mu0"), {"mu0": (0.0, top)}
        with suppress(SpragsymError):
            folds = model.bifurcation_set(here, plane, _LINES, between=between)
            yield (
                with_brake(lambda ax: drawings.draw_bifurcation_set_of(model, folds, ax)),
                "Where the brake works (dot) and its tolerances (box). On the lines two states of sliding meet.",
            )
        with suppress(SpragsymError):
            onsets = model.onset_curves(here, plane, _ONSETS, between=between)
            yield (
                with_brake(lambda ax: drawings.draw_onset_curves_of(model, onsets, ax)),
                "The map of stability. On the lines oscillation sets in: gently where they are full, with a knock where they are "
                "dashed; where they are dotted it is not known which.",
            )
    yield (
        picture(states),
        f"All states of sliding over the friction, {model.coordinates[0]} without units (one is "
        f"{1e3 * study.scales.length:.4g} mm if it is a length); shaded: the friction within its tolerances, the line: the "
        "one that works.",
    )
