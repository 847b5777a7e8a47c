"""The article's Figures 6 and 13: which equilibrium a slow change of a parameter leads through."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

import spragsym as ss

from ..assumed import MU0_RANGE
from ..models.parameters import FloatArray, Parameters
from ..results import Path
from .captions import BASE_TEXT, LINES_TEXT, PATHS_DEG, RANGE_TEXT
from .curves import LABELS, branches, draw_branches, draw_path, mark_folds, passages, table_of
from .equilibrium_curves import draw_linear, linear_curves
from .style import BLUE, DOUBLE, GREY, SKY, VERMILION, Sheet, Table, angle_axis, panels, remark, stacked, styled, write_along


@styled
def figure_6() -> Sheet:
    """The trajectory of equilibria as θ₀ rises and falls."""
    figure, ((left, right),) = panels(1, 2, DOUBLE, 2.7)
    p = Parameters.article(mu0=0.7)
    curves = branches(p)
    draw_branches(curves, ax=left, color=GREY, linewidth=0.8)
    up, back = both_ways(p, "theta0", np.radians(np.linspace(0.5, 179.5, 359)))
    _draw_both_ways(left, up, back, rising=(0.55,), falling=(0.35, 0.9))
    mark_folds(ss.folds(p), ax=left)
    write_along(left, r"$\theta_0$ rising", 40, 0.45, color=VERMILION)
    write_along(left, r"$\theta_0$ falling", 58, 1.5, color=BLUE)
    angle_axis(left)
    left.set(ylabel=LABELS["x"], ylim=(-2.1, 2.3))
    linear = draw_linear(right, p, "x")
    low, high = linear_curves(p)[1]
    right.axvspan(low, high, color=SKY, alpha=0.25, linewidth=0)
    angle_axis(right)
    right.set(ylabel=LABELS["x"], ylim=(-6, 6))
    right.annotate(
        "no steady sliding",
        ((low + high) / 2, 4.4),
        (102, 4.9),
        fontsize=8,
        va="center",
        arrowprops={"arrowstyle": "-", "linewidth": 0.5},
    )
    return figure.describe(
        f"""Figure 6. Trajectory of the equilibrium over the inclination at μ₀ = 0.7, {BASE_TEXT}. (a)
        Nonlinear model: from small deformation the state jumps where θ₀ rises through the fold, and
        from where that ends it returns without a jump. Thin line: rising, broad line: falling. (b) Linear
        model: between its poles, shaded, there is no steady sliding in contact. {LINES_TEXT}
        {RANGE_TEXT}""",
        a=table_of(curves), b=linear,
        a_rising=table_of_path(up, "theta0_deg"), a_falling=table_of_path(back, "theta0_deg"),
    )  # fmt: skip


@styled
def figure_13() -> Sheet:
    """The paths a–a′ and b–b′: hysteresis, and a jump without return."""
    figure, (axes,) = panels(1, 2, DOUBLE, 2.7)
    tables: dict[str, Table] = {}
    for ax, (letter, angle) in zip(axes, PATHS_DEG.items(), strict=True):
        p = Parameters.article(theta0=np.radians(angle))
        curves = branches(p, "mu0", *MU0_RANGE)
        draw_branches(curves, ax=ax, color=GREY, linewidth=0.8)
        up, back = both_ways(p, "mu0", np.linspace(*MU0_RANGE, 401))
        _draw_both_ways(ax, up, back, rising=(0.5,), falling=(0.5,))
        mark_folds(ss.folds(p, "mu0"), ax=ax, high=MU0_RANGE[1])
        ax.set(xlabel=r"$\mu_0$", ylabel=LABELS["x"], xlim=(0, 1), ylim=(0, 1.7 if angle < 50 else 1.1))
        remark(ax, rf"$\theta_0 = {angle:g}^\circ$")
        tables |= {
            letter: table_of(curves),
            f"{letter}_rising": table_of_path(up, "mu0"),
            f"{letter}_falling": table_of_path(back, "mu0"),
        }
    for ax, rising, falling in zip(axes, ((0.3, 0.45), (0.3, 0.22)), ((0.3, 0.98), (0.2, 1.55)), strict=True):
        write_along(ax, r"$\mu_0$ rising", *rising, color=VERMILION)
        write_along(ax, r"$\mu_0$ falling", *falling, color=BLUE)
    return figure.describe(
        f"""Figure 13. Trajectories of the equilibrium as the friction rises and falls, (a) a–a′ at θ₀ = 60°: a
        jump either way, hysteresis; (b) b–b′ at θ₀ = 40°: one jump, and no return. Here {BASE_TEXT}.
        Thin line: rising, broad line: falling. {LINES_TEXT} {RANGE_TEXT}""",
        **tables,
    )


def both_ways(p: Parameters, vary: str, values: FloatArray) -> tuple[Path, Path]:
    """The reference state followed up, and the state where it ends followed back."""
    up = ss.quasi_static_path(p, vary, values)
    slot = int(np.nanargmin(np.abs(ss.equilibria(p.replace(**{vary: values[-1]})).x - up.x[-1])))
    back = ss.quasi_static_path(p, vary, values[::-1], start=slot)
    return up, back


def _draw_both_ways(ax: Axes, up: Path, back: Path, rising: tuple[float, ...], falling: tuple[float, ...]) -> None:
    """Draw the way back as a broad line and the way up as a thin one on it: both are seen where they coincide."""
    draw_path(back, ax=ax, color=BLUE, arrows=falling, linewidth=3.2, alpha=0.45, zorder=2.1)
    draw_path(up, ax=ax, color=VERMILION, arrows=rising)


def table_of_path(path: Path, name: str) -> Table:
    return stacked([{name: value, "x": state} for value, state in passages(path)], "piece")
