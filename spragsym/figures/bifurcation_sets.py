"""The article's Figures 11, 12 and 14: the surface of equilibria, and its shadow, the bifurcation set."""

from __future__ import annotations

import itertools

import numpy as np
from matplotlib.axes import Axes

import spragsym as ss

from ..assumed import MU0_RANGE
from ..models.parameters import Parameters, ParameterSet
from ..questions import has_closed_form
from ..results import Stability
from .captions import BASE_TEXT, HIDDEN_TEXT, PATHS_DEG, RANGE_TEXT
from .curves import passages
from .planes import draw_bifurcation_set, draw_regions
from .style import (
    BLACK,
    DOUBLE,
    GREEN,
    GREY,
    LINES,
    SINGLE,
    VERMILION,
    Sheet,
    Table,
    angle_axis,
    line_at,
    single,
    stacked,
    styled,
    write_along,
)
from .surfaces import POINT, draw_surface, on_surface, space_axes, table_of_points
from .trajectories import both_ways, table_of_path

_VIOLET = "#5b2a86"


@styled
def figure_11(*, detail: float = 1.0) -> Sheet:
    """The equilibrium surface with its folds, its cusp and the paths a–a′ and b–b′."""
    figure = Sheet(figsize=(4.6, 3.5))
    ax = space_axes(figure, (0.0, 0.02, 0.97, 0.98), 1.02)
    p = Parameters.article()
    tables: dict[str, Table] = {}
    lines = []
    for (name, angle), color in zip(PATHS_DEG.items(), (BLACK, _VIOLET), strict=True):
        up, _ = both_ways(p.replace(theta0=np.radians(angle)), "mu0", np.linspace(*MU0_RANGE, 201))
        pieces = passages(up)
        lines += [(on_surface(mu0, np.full(mu0.size, np.radians(angle)), x), color) for mu0, x in pieces]
        for (mu0, x), (_, landed) in itertools.pairwise(pieces):
            ends = [angle, angle], [mu0[-1], mu0[-1]], [x[-1], landed[0]]
            ax.plot(*ends, color=color, linewidth=1.2, linestyle=":", zorder=4)
        for (mu0, x), mark, at in ((pieces[0], "", 0), (pieces[-1], "′", -1)):
            place = angle, mu0[at] + (-0.06 if at == 0 else 0.05), x[at] + 0.12
            ax.text(*place, f"$\\mathit{{{name}}}${mark}", color=color, zorder=6)
        tables[f"a_path_{name}"] = table_of_path(up, "mu0")
    tables["a"] = draw_surface(ax, p, lines, detail)
    return figure.describe(
        f"""Figure 11. Surface of equilibria in contact over inclination and friction, {BASE_TEXT}. Blue
        sheets are stable, orange ones divergent; orange lines are the folds, the dot is the cusp. Lines with a
        dotted jump are the paths a–a′ (θ₀ = 60°, black) and b–b′ (θ₀ = 40°, violet) with μ₀ rising.
        {HIDDEN_TEXT} x over L₀. {RANGE_TEXT}""",
        **tables,
    )


@styled
def figure_12() -> Sheet:
    """The bifurcation set."""
    figure, ax = single(SINGLE, 2.7)
    p = Parameters.article()
    table = draw_plane(ax, p)
    label_regions(ax, p, [(20, 0.3), (155, 0.25)], (98, 0.6))
    for name, angle in PATHS_DEG.items():
        line_at(ax, angle, width=0.6)
        write_along(ax, f"$\\mathit{{{name}}}$–$\\mathit{{{name}}}$′", angle + 1.5, 0.93, color=GREY)
    return figure.describe(
        f"""Figure 12. Bifurcation set over inclination and friction, {BASE_TEXT}: three equilibria in
        contact
        in the shaded regions, one elsewhere; the dot is the cusp. Dotted: the paths of Figure 13.
        {RANGE_TEXT}""",
        a=table,
    )


@styled
def figure_14(*, detail: float = 1.0) -> Sheet:
    """Surface and bifurcation set at σ = 1, with flutter."""
    figure = Sheet(figsize=(DOUBLE, 3.3))
    space, plane = space_axes(figure, (0.02, 0.0, 0.56, 1.0), 0.95), figure.add_axes((0.64, 0.16, 0.345, 0.74))
    p = Parameters.article(sigma=1.0)
    onsets = ss.flutter_boundary(p)
    flutter = [
        on_surface(*(column[onsets.curve == number] for column in (onsets.mu0, onsets.theta0, onsets.x)))
        for number in np.unique(onsets.curve)
    ]
    shown = stacked(list(map(table_of_points, flutter)), "curve", POINT)
    tables = {"a": draw_surface(space, p, [(line, GREEN) for line in flutter], detail), "b": draw_plane(plane, p)}
    tables |= {"a_flutter": shown, "b_flutter": shown}
    for line in flutter:
        plane.plot(line[:, 0], line[:, 1], color=GREEN, linewidth=1.2, linestyle=LINES[Stability.FLUTTER], zorder=3)
    label_regions(plane, p, [(40, 0.13), (150, 0.13)], (98, 0.75))
    for x in (6, 157):
        write_along(plane, "flutter", x, 0.85, color=GREEN)
    figure.text(0.02, 0.95, "(a)", va="center")
    plane.set_title("(b)", loc="left")
    return figure.describe(
        f"""Figure 14. Equilibria in contact at σ = 1, κ = 0.007, α = 0.007, β = 0. (a) Surface over
        inclination and friction: blue sheets are stable, orange divergent, green flutter; orange lines are folds,
        green ones onsets of flutter, the dot is the cusp. {HIDDEN_TEXT} (b) Bifurcation set: three equilibria in the
        shaded regions, one elsewhere; dash-dotted, onsets of flutter on the sheet of largest θ. x over
        L₀. {RANGE_TEXT}""",
        **tables,
    )


def draw_plane(ax: Axes, p: ParameterSet, mu0: tuple[float, float] = MU0_RANGE, n: int = 60) -> Table:
    """Fold curves of any model over (θ₀, μ₀), on ``n`` lines if by search; by closed forms the regions between them shaded."""
    model = p.model
    closed = has_closed_form(ss.bifurcation_set, p)
    found = ss.bifurcation_set(p, model.two(None), None if closed else n, between=None if closed else {"mu0": mu0})
    if closed:
        draw_regions(ax, p, mu0)
    draw_bifurcation_set(found, ax, color=VERMILION)
    angle_axis(ax)
    ax.set(ylabel=r"$\mu_0$", ylim=mu0)
    tables = [{"theta0_deg": np.degrees(curve.theta0), "mu0": curve.mu0} for curve in found.curves]
    return stacked(tables, "curve", ("theta0_deg", "mu0"))


def label_regions(ax: Axes, p: Parameters, three: list[tuple[float, float]], one: tuple[float, float]) -> None:
    """The number of equilibria in each region, and the cusp's coordinates beside it."""
    for place in three:
        write_along(ax, "3", *place, ha="center", fontsize=10)
    write_along(ax, "1", *one, ha="center", fontsize=10)
    cusp = ss.bifurcation_set(p).cusps
    theta0, mu0 = float(np.degrees(cusp.theta0[0])), float(cusp.mu0[0])
    write_along(ax, f"cusp\n{theta0:.2f}°\n{mu0:.4f}", theta0 + 3, mu0 + 0.09, linespacing=0.95)
