"""Figures: the article's 3 to 14, some that it lacks, and the functions that draw them (extra ``plot``).

Drawing functions take ``ax=None``, draw, and return the artists; figure functions return a
:class:`~spragsym.figures.style.Sheet`, a matplotlib figure that carries its caption and the data of its panels.
Nothing here shows a window or changes matplotlib's settings.

Examples
--------
>>> import spragsym.figures
>>> figure = spragsym.figures.figure_12()
>>> figure.caption[:26], sorted(figure.tables)
('Figure 12. Bifurcation set', ['a'])
"""

from collections.abc import Callable

from .bifurcation_sets import figure_11, figure_12, figure_14
from .brakes import draw_operating_point, draw_rising, draw_shares
from .curves import Branch, branches, draw_branches, draw_path, mark_folds, plot_equilibria
from .diagrams import diagram_figure
from .eigenvalues import eigenvalue_figure, plot_eigenvalues
from .equilibrium_curves import figure_4, figure_5, figure_8, figure_9, figure_10
from .extras import figure_cusp_friction, figure_false_double_root, figure_rms_map, figure_sensitivity
from .files import FORMATS, write
from .motion_pictures import draw_motion, draw_phase, draw_spectrum, motion_figure
from .motions import figure_3, figure_7
from .oscillation import branch_figure, fate_map_figure, figure_cycles, figure_cycles_plane
from .planes import bifurcation_figure, draw_bifurcation_set, draw_onset_curves, stability_figure
from .plots import plot
from .report_pages import report_page
from .style import Sheet
from .trajectories import figure_6, figure_13

#: Name → the function that draws it: the article's numbers first.
FIGURES: dict[str, Callable[..., Sheet]] = {
    drawn.__name__.removeprefix("figure_").replace("_", "-"): drawn
    for drawn in (
        figure_3, figure_4, figure_5, figure_6, figure_7, figure_8, figure_9, figure_10, figure_11, figure_12, figure_13,
        figure_14,
        figure_cusp_friction, figure_cycles, figure_cycles_plane, figure_false_double_root, figure_rms_map, figure_sensitivity,
    )
}  # fmt: skip

__all__ = [
    "FIGURES",
    "FORMATS",
    "Branch",
    "Sheet",
    "bifurcation_figure",
    "branch_figure",
    "fate_map_figure",
    "branches",
    "diagram_figure",
    "draw_bifurcation_set",
    "draw_branches",
    "draw_motion",
    "draw_onset_curves",
    "draw_operating_point",
    "draw_path",
    "draw_phase",
    "draw_rising",
    "draw_shares",
    "draw_spectrum",
    "eigenvalue_figure",
    "mark_folds",
    "stability_figure",
    "motion_figure",
    "plot",
    "plot_eigenvalues",
    "plot_equilibria",
    "report_page",
    "write",
    *(function.__name__ for function in FIGURES.values()),
]
