"""A report with any model as one page of HTML that needs no other file, with its pictures."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from matplotlib.axes import Axes

from ..errors import SpragsymError
from ..figures import models as drawings
from ..figures.style import BLUE, SKY
from ..models.load import load
from . import other_models
from .other_reports import ModelReport
from .pages import document, picture, stability_map, with_brake
from .study import Study

#: Lines of a bifurcation set, and values along the friction.
_LINES, _VALUES = 40, 240


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

    if "theta0" in model.parameters:
        with suppress(SpragsymError):
            folds = model.bifurcation_set(here, ("theta0", "mu0"), _LINES, between={"mu0": (0.0, top)})
            yield (
                with_brake(study, here, friction, lambda ax: drawings.draw_bifurcation_set_of(model, folds, ax)),
                "Where the brake works (dot) and its tolerances (box). On the lines two states of sliding meet.",
            )
        yield from stability_map(study, here, friction, top)
    yield (
        picture(states),
        f"All states of sliding over the friction, {model.coordinates[0]} without units (one is "
        f"{1e3 * study.scales.length:.4g} mm if it is a length); shaded: the friction within its tolerances, the line: the "
        "one that works.",
    )
