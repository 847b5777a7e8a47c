"""The article's Figures 4 to 6, 8 to 10 and 13: curves of equilibria over the inclination θ₀ or the
friction μ₀, and quasi-static paths along them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes

import spragsym as ss

from ..article.assumed import MU0_RANGE, Parameters
from ..models.parameters import FloatArray
from ..results import Path
from .curves import (
    LABELS,
    Branch,
    branches,
    draw_branches,
    draw_path,
    mark_folds,
    path_pieces,
    table_of,
)
from .style import (
    BASE_TEXT,
    BLACK,
    BLUE,
    DOUBLE,
    GREY,
    LETTERS,
    LINES_TEXT,
    PATHS_DEG,
    RANGE_TEXT,
    SINGLE,
    SKY,
    VERMILION,
    Sheet,
    Table,
    angle_axis,
    denser_at_ends,
    line_at,
    panels,
    remark,
    single,
    stacked,
    styled,
    symbol,
    write_along,
)


@styled
def figure_4() -> Sheet:
    """Equilibria in contact and in lift-off."""
    figure, axes = panels(2, 2, DOUBLE, 4.4)
    p = Parameters.article()
    contact, lifted = branches(p), branches(p, contact=False)
    for row, (curves, title) in enumerate(((contact, "contact"), (lifted, "lift-off"))):
        for ax, name, letter in zip(axes[row], "xy", ("ab", "cd")[row], strict=True):
            draw_panel(ax, p if curves is contact else None, curves, name)
            figure.tables[letter] = table_of(curves)
            remark(ax, title)
    for text, x, y in (("stable", 62, 1.2), ("divergent", 27, 0.88), ("stable", 6, 0.25)):
        write_along(axes[0, 0], text, x, y)
    write_along(axes[0, 0], "divergent", 158, -0.95, ha="right")
    write_along(axes[0, 0], "stable", 153, -1.65, ha="right")
    write_along(axes[0, 1], "stable", 90, -0.011)
    write_along(axes[0, 1], "divergent", 27, -0.055)
    write_along(axes[1, 0], "divergent", 98, 0.5)
    return figure.describe(
        f"""Figure 4. Equilibria over the inclination at μ₀ = 0.5, {BASE_TEXT}: in contact (a) x,
        (b) y, and in lift-off (c) x, (d) y. {LINES_TEXT} Displacements over L₀. {RANGE_TEXT}"""
    )


@styled
def figure_5() -> Sheet:
    """Equilibria of the linear and the nonlinear model, below and above the critical friction of
    the linear one.
    """
    figure, axes = panels(2, 2, DOUBLE, 4.4)
    for row, (mu0, range_of_y) in enumerate(((0.5, (-0.1, 0.01)), (0.7, (-0.23, 0.08)))):
        p = Parameters.article(mu0=mu0)
        curves, limits = branches(p), ((-2.2, 3.2), range_of_y)
        for ax, name, letter, ylim in zip(axes[row], "xy", ("ab", "cd")[row], limits, strict=True):
            figure.tables[letter] = table_of(curves)
            figure.tables[f"{letter}_linear"], _ = draw_linear(ax, p, name)
            draw_panel(ax, p, curves, name, ylim=ylim)
            remark(ax, rf"$\mu_0 = {mu0}$")
    for ax, angle in zip(axes[:, 0], (86, 92), strict=True):
        write_along(ax, "nonlinear", 30, 1.85)
        write_along(ax, "linear", angle, 2.3, color=BLUE)
    return figure.describe(
        f"""Figure 5. Equilibria in contact (black) and those of the linear sprag model, whose
        spring keeps its angle (blue), over the inclination: (a) x and (b) y at μ₀ = 0.5, (c) x and
        (d) y at μ₀ = 0.7; {BASE_TEXT}. Dotted lines are the poles of the linear model. {LINES_TEXT}
        Displacements over L₀; {RANGE_TEXT.lower()}"""
    )


def draw_linear(ax: Axes, p: Parameters, name: str) -> tuple[Table, FloatArray]:
    """Draw the curves of the linear model between its poles, and the poles; returns the curves as a
    table, and the poles in degrees.
    """
    poles = np.degrees(ss.kang_nam.linear_sprag(p.replace(theta0=1.0)).poles)
    poles = np.sort(poles[np.isfinite(poles)])
    # One column for each curve.
    angles = denser_at_ends([0.05, *poles], [*poles, 179.95], 2e-3, 400)
    model = ss.kang_nam.linear_sprag(p.replace(theta0=np.radians(angles)))
    ax.plot(angles, getattr(model, name), color=BLUE, linewidth=1.0)
    for pole in poles:
        line_at(ax, pole, BLUE, 0.6)
    return {
        "theta0_deg": angles.T.ravel(),
        "x_linear": model.x.T.ravel(),
        "y_linear": model.y.T.ravel(),
    }, poles


def draw_panel(
    ax: Axes,
    p: Parameters | None,
    curves: Iterable[Branch],
    name: str = "x",
    color: str = BLACK,
    **limits: Any,
) -> None:
    """Draw curves over the inclination, and the folds for ``p``, if given."""
    draw_branches(curves, name, ax=ax, color=color)
    if p is not None:
        mark_folds(ss.folds(p), name, ax=ax, color=color)
    angle_axis(ax, ylabel=LABELS[name], **limits)


#: Position of a label, and the point of the curve to which a thin line leads.
_Label: TypeAlias = tuple[tuple[float, float], tuple[float, float]]

_FAMILY_COLORS = (BLUE, VERMILION, BLACK)


@styled
def figure_8() -> Sheet:
    """Equilibrium curves for β = 0, 1 and 2."""
    labels = [((78, 1.5), (52, 1.16)), ((95, 1.0), (67, 0.61)), ((108, 0.55), (80, 0.195))]
    return _family(8, "beta", (0.0, 1.0, 2.0), labels)[0]


@styled
def figure_9() -> Sheet:
    """Equilibrium curves for α = 0.007, 0.07 and 0.7."""
    values = (0.007, 0.07, 0.7)
    labels = [((70, 1.4), (49, 1.22)), ((100, 0.7), (78, 0.06)), ((40, -0.27), (82, -0.01))]
    figure, ax = _family(9, "alpha", values, labels)
    low, high = np.degrees(
        ss.flutter_onsets(Parameters.article(alpha=values[-1]), damping=False).theta0
    ).tolist()
    _flutter(ax, low, high, -0.14, 8)
    inset = _magnified(ax, values)
    _flutter(inset, low, high, -0.002, 7)
    for value, position, color in zip(
        values, ((134, 0.055), (47, 0.06), (40, 0.012)), _FAMILY_COLORS, strict=True
    ):
        write_along(inset, rf"$\alpha = {value:g}$", *position, color=color, fontsize=7)
    figure.caption += (
        " The inset magnifies small deformation. At α = 0.7 the state flutters between the "
        f"onsets, {low:.1f}° and {high:.1f}°, "
        "which the brackets mark: at the scale of the outer axes the three curves coincide there."
    )
    return figure


@styled
def figure_10() -> Sheet:
    """Equilibrium curves for σ = 0.01, 0.1 and 1."""
    labels = [((110, 0.95), (100, 0.38)), ((33, 0.8), (47, 1.27)), ((70, 1.5), (52, 1.2))]
    figure, ax = _family(10, "sigma", (0.01, 0.1, 1.0), labels)
    write_along(ax, "flutter", 30, 1.95)
    write_along(ax, "flutter", 152, -0.2)
    return figure


def _family(
    number: int, name: str, values: tuple[float, ...], labels: Sequence[_Label]
) -> tuple[Sheet, Axes]:
    """Figure of equilibrium curves in contact for three values of a parameter, and its axes."""
    figure, ax = single(SINGLE, 2.9)
    tables = []
    for value, color, (position, target) in zip(values, _FAMILY_COLORS, labels, strict=True):
        p = Parameters.article(**{name: value})
        curves = branches(p)
        draw_panel(ax, p, curves, color=color, ylim=(-2.2, 2.4))
        _point_at(ax, rf"$\{name} = {value:g}$", target, position, color)
        tables.append({name: value, **table_of(curves)})
    fixed = f"μ₀ = 0.5, {BASE_TEXT}".split(", ")
    others = ", ".join(part for part in fixed if not part.startswith(LETTERS[name]))
    varied = f"{LETTERS[name]} = {', '.join(f'{value:g}' for value in values)}"
    sheet = figure.describe(
        f"""Figure {number}. Equilibria in contact over the inclination for {varied}; {others}.
        {LINES_TEXT} x over L₀. {RANGE_TEXT}""",
        a=stacked(tables),
    )
    return sheet, ax


def _point_at(
    ax: Axes,
    text: str,
    target: tuple[float, float],
    position: tuple[float, float],
    color: str = BLACK,
) -> None:
    """Write a label with a thin line to a point of a curve."""
    leader = {"arrowstyle": "-", "linewidth": 0.5, "color": color, "shrinkA": 1, "shrinkB": 2}
    ax.annotate(text, target, position, color=color, fontsize=8, va="center", arrowprops=leader)


def _magnified(ax: Axes, values: tuple[float, ...]) -> Axes:
    """Draw inset axes that magnify small deformation, where the curves of ``ax`` coincide."""
    inset = ax.inset_axes((0.2, 0.13, 0.5, 0.26))
    for value, color in zip(values, _FAMILY_COLORS, strict=True):
        draw_branches(
            branches(Parameters.article(alpha=value)), ax=inset, color=color, linewidth=1.0
        )
    angle_axis(inset, step=60, ylabel=LABELS["x"], ylim=(-0.02, 0.068), yticks=(0.0, 0.03, 0.06))
    inset.tick_params(labelsize=7)
    for axis in (inset.xaxis, inset.yaxis):
        axis.label.set_fontsize(7)
        axis.labelpad = 1.0
    return inset


def _flutter(ax: Axes, low: float, high: float, level: float, fontsize: int) -> None:
    """Draw a bracket "flutter" below a curve, between two values of θ₀ in degrees."""
    ax.annotate(
        "",
        (low, level),
        (high, level),
        arrowprops={
            "arrowstyle": "|-|, widthA=0.2, widthB=0.2",
            "linewidth": 0.7,
            "shrinkA": 0,
            "shrinkB": 0,
        },
    )
    ax.annotate(
        "flutter",
        ((low + high) / 2, level),
        (0, -3),
        textcoords="offset points",
        ha="center",
        va="top",
        fontsize=fontsize,
    )


@styled
def figure_6() -> Sheet:
    """Quasi-static paths of the nonlinear model as θ₀ rises and falls, and equilibria of the linear
    one.
    """
    figure, ((left, right),) = panels(1, 2, DOUBLE, 2.7)
    p = Parameters.article(mu0=0.7)
    curves = branches(p)
    values = np.radians(np.linspace(0.5, 179.5, 359))
    rising, falling = _both_ways(
        left, p, curves, values, [(0.55,), (0.35, 0.9)], [(40, 0.45), (58, 1.5)]
    )
    angle_axis(left, ylabel=LABELS["x"], ylim=(-2.1, 2.3))
    linear, (low, high) = draw_linear(right, p, "x")
    right.axvspan(low, high, color=SKY, alpha=0.25, linewidth=0)
    angle_axis(right, ylabel=LABELS["x"], ylim=(-6, 6))
    _point_at(right, "no steady sliding", ((low + high) / 2, 4.4), (102, 4.9))
    return figure.describe(
        f"""Figure 6. Trajectory of the equilibrium over the inclination at μ₀ = 0.7, {BASE_TEXT}.
        (a) Nonlinear model: from small deformation the state jumps where θ₀ rises through the
        fold, and from where that ends it returns without a jump. Thin line: rising, broad line:
        falling. (b) Linear model: between its poles, shaded, there is no steady sliding in
        contact. {LINES_TEXT} {RANGE_TEXT}""",
        a=table_of(curves),
        b=linear,
        a_rising=rising,
        a_falling=falling,
    )


@styled
def figure_13() -> Sheet:
    """The paths a–a′ and b–b′ over the friction: hysteresis, and a jump without return."""
    figure, (axes,) = panels(1, 2, DOUBLE, 2.7)
    places = [(0.3, 0.45), (0.3, 0.98)], [(0.3, 0.22), (0.2, 1.55)]
    values, heights = np.linspace(*MU0_RANGE, 401), {"a": 1.1, "b": 1.7}
    for ax, (letter, angle), at in zip(axes, PATHS_DEG.items(), places, strict=True):
        p = Parameters.article(theta0=np.radians(angle))
        curves = branches(p, "mu0", between={"mu0": MU0_RANGE})
        rising, falling = _both_ways(ax, p, curves, values, [(0.5,)] * 2, at)
        ax.set(xlabel=r"$\mu_0$", ylabel=LABELS["x"], xlim=(0, 1), ylim=(0, heights[letter]))
        remark(ax, rf"$\theta_0 = {angle:g}^\circ$")
        figure.tables |= {
            letter: table_of(curves),
            f"{letter}_rising": rising,
            f"{letter}_falling": falling,
        }
    return figure.describe(
        f"""Figure 13. Trajectories of the equilibrium as the friction rises and falls, (a) a–a′ at
        θ₀ = 60°: a jump either way, hysteresis; (b) b–b′ at θ₀ = 40°: one jump, and no return. Here
        {BASE_TEXT}. Thin line: rising, broad line: falling. {LINES_TEXT} {RANGE_TEXT}"""
    )


def _both_ways(
    ax: Axes,
    p: Parameters,
    curves: Sequence[Branch],
    values: FloatArray,
    arrows: Sequence[tuple[float, ...]],
    places: Sequence[tuple[float, float]],
) -> list[Table]:
    """Draw all equilibria, the path of the reference state as a parameter rises, and the path back
    from its end; returns tables of both paths.

    ``values`` are those of the parameter, ``arrows`` and ``places`` the arrow heads and labels of
    the two paths. The path back is broad and the other one thin, so that both are seen where they
    coincide.
    """
    vary = curves[0].vary
    draw_branches(curves, ax=ax, color=GREY, linewidth=0.8)
    rising = ss.quasi_static_path(p, vary, values)
    falling = ss.quasi_static_path(p.following(x=float(rising.x[-1])), vary, values[::-1])
    draw_path(falling, ax=ax, color=BLUE, arrows=arrows[1], linewidth=3.2, alpha=0.45, zorder=2.1)
    draw_path(rising, ax=ax, color=VERMILION, arrows=arrows[0])
    write_along(ax, f"${symbol(vary)}$ rising", *places[0], color=VERMILION)
    write_along(ax, f"${symbol(vary)}$ falling", *places[1], color=BLUE)
    mark_folds(ss.folds(p, vary), ax=ax, between={vary: (values[0], values[-1])})
    return [table_of_path(rising), table_of_path(falling)]


def table_of_path(path: Path) -> Table:
    """The pieces of a path between jumps as a table."""
    title = path.parameters.model.column(path.vary).heading
    return stacked([{title: value, "x": state} for value, state in path_pieces(path)], "piece")
