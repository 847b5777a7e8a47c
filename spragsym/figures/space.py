"""Drawing in three dimensions: the surface of equilibria, its folds and cusps, and lines that it hides in part."""

from __future__ import annotations

from typing import Any

import numpy as np

import spragsym as ss

from ..assumed import MU0_RANGE
from ..models.parameters import FloatArray, Parameters
from ..results.equilibria import Stability
from . import surfaces
from .curves import LABELS
from .hidden import Cover, cover_of, parts
from .style import BLACK, VERMILION, Sheet, Table, stacked

_SHEET_COLORS = {Stability.STABLE: "#b3d9f0", Stability.DIVERGENT: "#f7b78f", Stability.FLUTTER: "#96dcc0"}

#: How the parts of a line look that a sheet hides.
BEHIND: dict[str, Any] = {"linewidth": 0.6, "linestyle": (0, (3.0, 2.2))}


def space_axes(figure: Sheet, place: Any, zoom: float) -> Any:
    """Axes in three dimensions, for print."""
    ax: Any = figure.add_axes(place, projection="3d", computed_zorder=False)
    for axis in (ax.xaxis, ax.yaxis, ax.zaxis):
        axis.set_pane_color((1.0, 1.0, 1.0, 0.0))
        axis._axinfo["grid"].update(linewidth=0.3, color="#cccccc")  # there is no public way to thin the grid
    ax.tick_params(pad=-2)
    ax.zaxis.set_rotate_label(False)
    ax.set_box_aspect((1.25, 1.1, 0.9), zoom=zoom)
    ax.view_init(elev=24, azim=-118)
    return ax


def draw_surface(ax: Any, p: Parameters, detail: float = 1.0) -> tuple[Cover, Table]:
    """Sheets by stability, fold curves and cusps on them; what the sheets hide is drawn thin."""
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    low, high = MU0_RANGE
    angles = np.linspace(0.5, 179.5, round(120 * detail))
    polygons, colors = [], []
    for stability, sheet in surfaces.sheets(p, MU0_RANGE, angles, round(120 * detail)).items():
        polygons += sheet
        colors += [surfaces.shaded(_SHEET_COLORS[stability], polygon) for polygon in sheet]
    # One collection, so that polygons of all sheets are sorted by depth together; edges close the seams.
    filled = surfaces.of_equal_length(polygons)
    ax.add_collection3d(Poly3DCollection(filled, facecolors=colors, edgecolors=colors, linewidths=0.3, rasterized=True, zorder=1))
    ax.set(xlabel=r"$\theta_0$ (deg)", ylabel=r"$\mu_0$", xlim=(0, 180), ylim=MU0_RANGE, zlim=(-2, 2))
    ax.set_zlabel(LABELS["x"], rotation=90)
    ax.set_xticks(np.arange(0, 181, 45))
    ax.set_zticks(np.arange(-2, 3, 1))
    cover = cover_of(ax, polygons)
    found = ss.bifurcation_set(p)
    tables = []
    for curve in found.curves:
        mu0, theta0, x = surfaces.inside(curve.mu0, low, high, np.degrees(curve.theta0), curve.x)
        draw_line(ax, cover, theta0, mu0, x, color=VERMILION, linewidth=1.2, zorder=3)
        shown = np.isfinite(mu0)
        tables.append({"theta0_deg": theta0[shown], "mu0": mu0[shown], "x": x[shown]})
    cusps = np.stack([np.degrees(found.cusps.theta0), found.cusps.mu0, found.cusps.x], axis=-1)
    for place, behind in zip(cusps, cover.hides(cusps), strict=True):
        face = "none" if behind else BLACK
        ax.plot(*place[:, None], linestyle="none", marker="o", markersize=4, color=BLACK, markerfacecolor=face, zorder=5)
    return cover, stacked(tables, "curve", ("theta0_deg", "mu0", "x"))


def draw_line(ax: Any, cover: Cover, theta0: FloatArray, mu0: FloatArray, x: FloatArray, **options: Any) -> None:
    """A line in space, thin and dashed where the sheets hide it."""
    for piece, behind in parts(np.stack([theta0, mu0, x], axis=-1), cover):
        ax.plot(*piece.T, **(options | BEHIND if behind else options))
