"""The article's Figures 3 to 14, from its equations and its text; no picture of it was at hand.

Each function returns a :class:`~spragsym.figures.style.Sheet`, a matplotlib figure with its caption and the data
of its panels.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes

from ..catastrophe.bifurcation_sets import bifurcation_set
from ..catastrophe.flutter_points import FlutterBoundary, flutter_boundary, flutter_onsets
from ..catastrophe.fold_points import folds
from ..catastrophe.linear import linear_sprag
from ..catastrophe.paths import Path, quasi_static_path
from ..dynamics.trajectory import simulate
from ..generated import motion
from ..parameters import FloatArray, Parameters
from ..statics.solver import Stability, equilibria
from ..sweeps import Workers, rms_sweep
from . import surfaces
from .curves import LABELS, branches, draw_branches, draw_path, joined, mark_folds, passages, table_of
from .hidden import Cover, cover_of, parts
from .style import (  # fmt: skip
    BLACK,
    BLUE,
    DOUBLE,
    GREEN,
    GREY,
    LINES,
    SINGLE,
    SKY,
    VERMILION,
    Sheet,
    Table,
    angle_axis,
    panels,
    styled,
    write_along,
)

#: Belt speed and steepness of the friction law; the article states neither.
V, D = 0.5, 10.0
#: Frictions that the surfaces and bifurcation sets are shown for; the article's ranges are unknown.
MU0_RANGE = (0.0, 1.0)
#: θ₀ of the paths a–a′ and b–b′.
PATHS_DEG = {"a": 60.0, "b": 40.0}

#: Parameters that the captions repeat, in the article's letters.
_LETTERS = {"alpha": "α", "beta": "β", "kappa": "κ", "mu0": "μ₀", "sigma": "σ", "theta0": "θ₀"}
_BASE_TEXT = "κ = 0.007, α = 0.007, σ = 0.1, β = 0"
_LINES_TEXT = "Stable solid, divergent dashed, flutter dash-dotted; dots are folds."
_RANGE_TEXT = "The ranges of the axes are our choice."
_HIDDEN_TEXT = "Thin dashes lie behind a sheet."


@styled
def figure_3() -> Sheet:
    """Friction over the speed of the mass, and contact force over its displacement."""
    figure, ((left, right),) = panels(1, 2, DOUBLE, 2.3)
    speed = np.unique(np.concatenate([np.linspace(-0.5, 1.5, 401), V + np.linspace(-1e-9, 1e-9, 2)]))
    friction = motion.friction(speed, 1.0, V, D)
    left.axhline(0, color=GREY, linewidth=0.5)
    for part in (speed < V, speed > V):
        left.plot(speed[part], friction[part], color=BLACK)
    left.axvline(V, color=GREY, linewidth=0.7, linestyle=":")
    write_along(left, r"$x' = V$", V + 0.04, -0.12)
    left.set(xlabel=r"$x'$", ylabel=r"$\mu/\mu_0$", xlim=(-0.5, 1.5), ylim=(-1.15, 1.15))
    left.set_xticks(np.arange(-0.5, 1.6, 0.5))
    right.set_xticks(np.arange(-0.1, 0.11, 0.05))
    y = np.array([-0.1, 0.0, 0.1])
    right.plot(y, 0.5 * (np.abs(y) - y), color=BLACK)
    write_along(right, "contact", -0.048, 0.06, ha="left")
    write_along(right, "lift-off", 0.05, 0.009, ha="center")
    right.set(xlabel=r"$y$", ylabel=r"$n$", xlim=(-0.1, 0.1), ylim=(-0.008, 0.105))
    return figure.describe(
        f"""Figure 3. (a) Regularized friction coefficient (10) over the speed of the mass, for a belt speed
        V =         {V} and a steepness d = {D:g}, which are our assumption: the article states neither. (b) Contact
        force (11). All quantities are dimensionless.""",
        a={"vx": speed, "mu_over_mu0": friction}, b={"y": y, "n": 0.5 * (np.abs(y) - y)},
    )  # fmt: skip


@styled
def figure_4() -> Sheet:
    """Equilibria in contact and in lift-off."""
    figure, axes = panels(2, 2, DOUBLE, 4.4)
    p = Parameters.article()
    contact, lifted = branches(p), branches(p, contact=False)
    for ax, curves, name in zip(axes.flat, (contact, contact, lifted, lifted), "xyxy", strict=True):
        draw_branches(curves, name, ax=ax)
        angle_axis(ax)
        ax.set_ylabel(LABELS[name])
    for ax, name in zip(axes[0], "xy", strict=True):
        mark_folds(folds(p), name, ax=ax)
    for ax, name in zip(axes.flat, ("contact", "contact", "lift-off", "lift-off"), strict=True):
        ax.set_title(name, loc="right", color=GREY)
    for text, x, y in (("stable", 62, 1.2), ("divergent", 27, 0.88), ("stable", 6, 0.25)):
        write_along(axes[0, 0], text, x, y)
    for text, x, y in (("divergent", 158, -0.95), ("stable", 153, -1.65)):
        write_along(axes[0, 0], text, x, y, ha="right")
    for text, x, y in (("stable", 90, -0.011), ("divergent", 27, -0.055)):
        write_along(axes[0, 1], text, x, y)
    write_along(axes[1, 0], "divergent", 98, 0.5)
    return figure.describe(
        f"""Figure 4. Equilibria over the inclination at μ₀ = 0.5, {_BASE_TEXT}: in contact (a) x, (b) y, and
        in lift-off (c) x, (d) y. {_LINES_TEXT} Displacements over L₀. {_RANGE_TEXT}""",
        a=table_of(contact), b=table_of(contact), c=table_of(lifted), d=table_of(lifted),
    )  # fmt: skip


def _linear_curves(p: Parameters) -> tuple[list[FloatArray], FloatArray]:
    """θ₀ in degrees between the poles of the linear model, piece by piece, and the poles."""
    poles = np.degrees(linear_sprag(p.replace(theta0=1.0)).poles)
    poles = np.sort(poles[np.isfinite(poles)])
    ends = [0.05, *poles, 179.95]
    pieces = []
    for begin, end in itertools.pairwise(ends):
        pieces.append(begin + (end - begin) * (0.5 - 0.5 * np.cos(np.pi * np.linspace(2e-3, 1 - 2e-3, 400))))
    return pieces, poles


def _draw_linear(ax: Axes, p: Parameters, name: str, color: str = BLUE) -> Table:
    """Curves of the linear model, broken at its poles, which are marked."""
    pieces, poles = _linear_curves(p)
    for piece in pieces:
        ax.plot(
            piece,
            getattr(linear_sprag(p.replace(theta0=np.radians(piece))), name),
            color=color,
            linewidth=1.0,
        )
    for pole in poles:
        ax.axvline(pole, color=color, linewidth=0.6, linestyle=":")
    along = np.concatenate(pieces)
    model = linear_sprag(p.replace(theta0=np.radians(along)))
    return {"theta0_deg": along, "x_linear": model.x, "y_linear": model.y}


@styled
def figure_5() -> Sheet:
    """The linear model against the nonlinear one, below and above the linear model's critical friction."""
    figure, axes = panels(2, 2, DOUBLE, 4.4)
    limits = {
        ("x", 0.5): (-2.2, 3.2),
        ("y", 0.5): (-0.1, 0.01),
        ("x", 0.7): (-2.2, 3.2),
        ("y", 0.7): (-0.23, 0.08),
    }
    tables: dict[str, Table] = {}
    for row, mu0 in enumerate((0.5, 0.7)):
        p = Parameters.article(mu0=mu0)
        curves = branches(p)
        for ax, name, letter in zip(axes[row], "xy", "abcd"[2 * row : 2 * row + 2], strict=True):
            linear = _draw_linear(ax, p, name)
            draw_branches(curves, name, ax=ax)
            mark_folds(folds(p), name, ax=ax)
            angle_axis(ax)
            ax.set(ylabel=LABELS[name], ylim=limits[name, mu0])
            ax.set_title(rf"$\mu_0 = {mu0}$", loc="right", color=GREY)
            tables[letter] = table_of(curves)
            tables[f"{letter}_linear"] = linear
    for ax in axes[:, 0]:
        write_along(ax, "nonlinear", 30, 1.85)
    write_along(axes[0, 0], "linear", 86, 2.3, color=BLUE)
    write_along(axes[1, 0], "linear", 92, 2.3, color=BLUE)
    return figure.describe(
        f"""Figure 5. Equilibria in contact (black) and those of the linear sprag model, whose spring keeps
        its
        angle (blue), over the inclination: (a) x and (b) y at μ₀ = 0.5, (c) x and (d) y at μ₀ = 0.7;
        {_BASE_TEXT}. Dotted lines are the poles of the linear model. {_LINES_TEXT} Displacements over L₀;
        {_RANGE_TEXT.lower()}""",
        **tables,
    )


def _both_ways(p: Parameters, vary: str, values: FloatArray) -> tuple[Path, Path]:
    """The state of small deformation followed up, and the state where it ends followed back."""
    up = quasi_static_path(p, vary, values)
    back = quasi_static_path(p, vary, values[::-1], start=_slot_of(p.replace(**{vary: values[-1]}), up.x[-1]))
    return up, back


def _draw_both_ways(ax: Axes, up: Path, back: Path, rising: tuple[float, ...], falling: tuple[float, ...]) -> None:
    """The way up as a thin line upon the broad one of the way back: both are seen where they share a curve."""
    draw_path(back, ax=ax, color=BLUE, arrows=falling, linewidth=3.2, alpha=0.45, zorder=2.1)
    draw_path(up, ax=ax, color=VERMILION, arrows=rising)


def _slot_of(p: Parameters, x: float) -> int:
    return int(np.nanargmin(np.abs(equilibria(p).x - x)))


def _table_of_path(path: Path, name: str) -> Table:
    pieces = passages(path)
    return {
        "piece": np.repeat(np.arange(len(pieces)), [value.size for value, _ in pieces]),
        name: np.concatenate([value for value, _ in pieces]),
        "x": np.concatenate([state for _, state in pieces]),
    }


@styled
def figure_6() -> Sheet:
    """The trajectory of equilibria as θ₀ rises and falls."""
    figure, ((left, right),) = panels(1, 2, DOUBLE, 2.7)
    p = Parameters.article(mu0=0.7)
    curves = branches(p)
    draw_branches(curves, ax=left, color=GREY, linewidth=0.8)
    up, back = _both_ways(p, "theta0", np.radians(np.linspace(0.5, 179.5, 359)))
    _draw_both_ways(left, up, back, rising=(0.55,), falling=(0.35, 0.9))
    mark_folds(folds(p), ax=left)
    write_along(left, r"$\theta_0$ rising", 40, 0.45, color=VERMILION)
    write_along(left, r"$\theta_0$ falling", 58, 1.5, color=BLUE)
    angle_axis(left)
    left.set(ylabel=LABELS["x"], ylim=(-2.1, 2.3))
    linear = _draw_linear(right, p, "x")
    low, high = _linear_curves(p)[1]
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
        f"""Figure 6. Trajectory of the equilibrium over the inclination at μ₀ = 0.7, {_BASE_TEXT}. (a)
        Nonlinear model: from small deformation the state jumps where θ₀ rises through the fold, and
        from where that ends it returns without a jump. Thin line: rising, broad line: falling. (b) Linear
        model: between its poles, shaded, there is no steady sliding in contact. {_LINES_TEXT}
        {_RANGE_TEXT}""",
        a=table_of(curves), b=linear,
        a_rising=_table_of_path(up, "theta0_deg"), a_falling=_table_of_path(back, "theta0_deg"),
    )  # fmt: skip


@styled
def figure_7(*, step_deg: float = 0.5, workers: Workers = 1) -> Sheet:
    """The motion in time at 49°, and the root mean square of x over θ₀."""
    figure, ((left, right),) = panels(1, 2, DOUBLE, 2.5)
    p = Parameters.article()
    trajectory = simulate(p.replace(theta0=np.radians(49.0)), V=V, d=D)
    t = np.linspace(0.0, 2000.0, 8001)
    x = trajectory(t)[0]
    left.plot(t, x, color=BLACK, linewidth=0.6)
    left.set(xlabel=r"$\tau$", ylabel=r"$x$", xlim=(0, 2000))
    left.set_title(r"$\theta_0 = 49^\circ$", loc="right", color=GREY)
    angles = np.arange(step_deg, 180.0 - step_deg / 2, step_deg)
    sweep = rms_sweep(p.replace(theta0=np.radians(angles)), V, D, workers=workers)
    right.plot(angles, sweep.rms, color=BLACK, marker=".", markersize=2.2, linewidth=0.5)
    fold = float(np.degrees(folds(p).theta0[0]))
    right.axvline(fold, color=VERMILION, linewidth=0.8, linestyle=":")
    write_along(right, f"fold, {fold:.2f}°", fold + 3, 0.12, color=VERMILION)
    angle_axis(right)
    right.set(ylabel=r"RMS of $x$", ylim=(0, None))
    return figure.describe(
        f"""Figure 7. Motion from rest at x = y = 0, μ₀ = 0.5, {_BASE_TEXT}. (a) x over dimensionless time at
        θ₀ = 49°. (b) Root mean square of x, about zero, over 1500 < τ < 2000. Belt speed V = {V},
        steepness d = {D:g}, the rest at the start and the window in time are our assumption: the article
        states none of them. The dotted line is the fold. Beyond it a large and a small motion compete; near
        54° rounding decides which of them is reached.""",
        a={"tau": t, "x": x}, b={"theta0_deg": angles, "rms_x": sweep.rms, "regime": sweep.regime},
    )  # fmt: skip


#: Where a direct label stands, and the point of the curve that a thin line leads to.
_Label: TypeAlias = tuple[tuple[float, float], tuple[float, float]]


def _family(number: int, name: str, values: tuple[float, ...], labels: Sequence[_Label]) -> tuple[Sheet, Axes]:
    """Equilibrium curves in contact for three values of a parameter, labelled at the given places."""
    figure, ((ax,),) = panels(1, 1, SINGLE, 2.9)
    tables = []
    for value, color, (place, target) in zip(values, _FAMILY_COLORS, labels, strict=True):
        p = Parameters.article(**{name: value})
        curves = branches(p)
        draw_branches(curves, ax=ax, color=color)
        mark_folds(folds(p), ax=ax, color=color)
        _point_at(ax, rf"$\{name} = {value:g}$", target, place, color)
        tables.append(table_of(curves, **{name: value}))
    angle_axis(ax)
    ax.set(ylabel=LABELS["x"], ylim=(-2.2, 2.4))
    others = ", ".join(part for part in f"μ₀ = 0.5, {_BASE_TEXT}".split(", ") if not part.startswith(_LETTERS[name]))
    sheet = figure.describe(
        f"""Figure {number}. Equilibria in contact over the inclination for {_LETTERS[name]} = {
            ", ".join(f"{value:g}" for value in values)
        }; {others}. {_LINES_TEXT} x over L₀. {_RANGE_TEXT}""",
        a=joined(tables),
    )
    return sheet, ax


_FAMILY_COLORS = (BLUE, VERMILION, BLACK)


def _point_at(ax: Axes, text: str, target: tuple[float, float], place: tuple[float, float], color: str = BLACK) -> None:
    """A label with a thin line from it to a point of a curve; the line starts beside the text or above it."""
    leader = {"arrowstyle": "-", "linewidth": 0.5, "color": color, "shrinkA": 1, "shrinkB": 2}
    ax.annotate(text, target, place, color=color, fontsize=8, va="center", arrowprops=leader)


def _magnified(ax: Axes, name: str, values: tuple[float, ...]) -> Axes:
    """Axes within others that show small deformation only, where the curves of the outer ones lie upon each other."""
    inset = ax.inset_axes((0.2, 0.13, 0.5, 0.26))
    for value, color in zip(values, _FAMILY_COLORS, strict=True):
        draw_branches(branches(Parameters.article(**{name: value})), ax=inset, color=color, linewidth=1.0)
    angle_axis(inset, step=60)
    inset.set(ylabel=LABELS["x"], ylim=(-0.02, 0.068))
    inset.set_yticks((0.0, 0.03, 0.06))
    inset.tick_params(labelsize=7)
    for label in (inset.xaxis.label, inset.yaxis.label):
        label.set_fontsize(7)
    inset.xaxis.labelpad = inset.yaxis.labelpad = 1.0
    return inset


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
    onsets = np.degrees(flutter_onsets(Parameters.article(alpha=values[-1])).theta0)
    low, high = float(onsets.min()), float(onsets.max())
    _bracket(ax, "flutter", low, high, -0.14)
    inset = _magnified(ax, "alpha", values)
    _bracket(inset, "flutter", low, high, -0.002, fontsize=7)
    for text, place, color in zip(("0.007", "0.07", "0.7"), ((134, 0.055), (47, 0.06), (40, 0.012)), _FAMILY_COLORS, strict=True):
        write_along(inset, rf"$\alpha = {text}$", *place, color=color, fontsize=7)
    figure.caption += (
        f" The inset magnifies small deformation. At α = 0.7 the state flutters between the onsets, {low:.1f}° and {high:.1f}°, "
        "which the brackets mark: at the scale of the outer axes the three curves lie upon each other there."
    )
    return figure


def _bracket(ax: Axes, text: str, low: float, high: float, level: float, **options: Any) -> None:
    """A bracket below a curve from one θ₀ in degrees to another, with a word beneath."""
    ax.annotate("", (low, level), (high, level), arrowprops={"arrowstyle": "|-|, widthA=0.2, widthB=0.2", "linewidth": 0.7,
                                                             "shrinkA": 0, "shrinkB": 0})  # fmt: skip
    ax.annotate(text, ((low + high) / 2, level), (0, -3), textcoords="offset points", ha="center", va="top",
                **({"fontsize": 8} | options))  # fmt: skip


@styled
def figure_10() -> Sheet:
    """Equilibrium curves for σ = 0.01, 0.1 and 1."""
    labels = [((110, 0.95), (100, 0.38)), ((33, 0.8), (47, 1.27)), ((70, 1.5), (52, 1.2))]
    figure, ax = _family(10, "sigma", (0.01, 0.1, 1.0), labels)
    for place in ((30, 1.95), (152, -0.2)):
        write_along(ax, "flutter", *place)
    return figure


# ------------------------------------------------------------------------------ surfaces and their shadow

_VIOLET = "#5b2a86"
_SHEET_COLORS = {Stability.STABLE: "#b3d9f0", Stability.DIVERGENT: "#f7b78f", Stability.FLUTTER: "#96dcc0"}


def _draw_surface(ax: Any, p: Parameters, detail: float = 1.0) -> tuple[Cover, Table]:
    """Sheets by stability, fold curves and cusps on them; what the sheets hide is drawn thin."""
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    low, high = MU0_RANGE
    angles = np.linspace(0.5, 179.5, round(120 * detail))
    polygons, colors = [], []
    for sheet in surfaces.sheets(p, MU0_RANGE, angles, round(120 * detail)):
        polygons += sheet.polygons
        colors += [surfaces.shaded(_SHEET_COLORS[sheet.stability], polygon) for polygon in sheet.polygons]
    # One collection, so that polygons of all sheets are sorted by depth together; edges close the seams.
    filled = surfaces.of_equal_length(polygons)
    ax.add_collection3d(
        Poly3DCollection(filled, facecolors=colors, edgecolors=colors, linewidths=0.3, rasterized=True, zorder=1)
    )
    ax.set(xlabel=r"$\theta_0$ (deg)", ylabel=r"$\mu_0$", xlim=(0, 180), ylim=MU0_RANGE, zlim=(-2, 2))
    ax.set_zlabel(LABELS["x"], rotation=90)
    ax.set_xticks(np.arange(0, 181, 45))
    ax.set_zticks(np.arange(-2, 3, 1))
    cover = cover_of(ax, polygons)
    found = bifurcation_set(p)
    columns: dict[str, list[FloatArray]] = {"curve": [], "theta0_deg": [], "mu0": [], "x": []}
    for number, curve in enumerate(found.curves):
        mu0, theta0, x = surfaces.inside(curve.mu0, low, high, np.degrees(curve.theta0), curve.x)
        _draw_line(ax, cover, theta0, mu0, x, color=VERMILION, linewidth=1.2, zorder=3)
        shown = np.isfinite(mu0)
        for name, values in zip(columns, (np.full(mu0.size, number), theta0, mu0, x), strict=True):
            columns[name].append(values[shown])
    cusps = np.stack([np.degrees(found.cusps.theta0), found.cusps.mu0, found.cusps.x], axis=-1)
    for place, behind in zip(cusps, cover.hides(cusps), strict=True):
        face = "none" if behind else BLACK
        ax.plot(*place[:, None], linestyle="none", marker="o", markersize=4, color=BLACK, markerfacecolor=face, zorder=5)
    return cover, {name: np.concatenate([[], *values]) for name, values in columns.items()}


#: How a line looks where a sheet stands before it, whatever its own pattern is.
_BEHIND: dict[str, Any] = {"linewidth": 0.6, "linestyle": (0, (3.0, 2.2))}


def _draw_line(ax: Any, cover: Cover, theta0: FloatArray, mu0: FloatArray, x: FloatArray, **options: Any) -> None:
    """A line in space, thin and dashed where the sheets hide it."""
    for piece, behind in parts(np.stack([theta0, mu0, x], axis=-1), cover):
        ax.plot(*piece.T, **(options | _BEHIND if behind else options))


def _space(figure: Sheet, place: Any, zoom: float) -> Any:
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


@styled
def figure_11(*, detail: float = 1.0) -> Sheet:
    """The equilibrium surface with its folds, its cusp and the paths a–a′ and b–b′."""
    figure = Sheet(figsize=(4.6, 3.5))
    ax = _space(figure, (0.0, 0.02, 0.97, 0.98), 1.02)
    p = Parameters.article()
    cover, folded = _draw_surface(ax, p, detail)
    tables = {"a": folded}
    for (name, angle), color in zip(PATHS_DEG.items(), (BLACK, _VIOLET), strict=True):
        up, _ = _both_ways(p.replace(theta0=np.radians(angle)), "mu0", np.linspace(*MU0_RANGE, 201))
        pieces = passages(up)
        for mu0, x in pieces:
            _draw_line(ax, cover, np.full(mu0.size, angle), mu0, x, color=color, linewidth=1.5, zorder=4)
        for (mu0, x), (_, landed) in itertools.pairwise(pieces):
            ends = np.array([angle, angle]), np.array([mu0[-1], mu0[-1]]), np.array([x[-1], landed[0]])
            _draw_line(ax, cover, *ends, color=color, linewidth=1.2, linestyle=":", zorder=4)
        for (mu0, x), mark, at in ((pieces[0], "", 0), (pieces[-1], "′", -1)):
            ax.text(
                angle,
                mu0[at] + (-0.06 if at == 0 else 0.05),
                x[at] + 0.12,
                f"$\\mathit{{{name}}}${mark}",
                color=color,
                zorder=6,
            )
        tables[f"a_path_{name}"] = _table_of_path(up, "mu0")
    return figure.describe(
        f"""Figure 11. Surface of equilibria in contact over inclination and friction, {_BASE_TEXT}. Blue
        sheets are stable, orange ones divergent; orange lines are the folds, the dot is the cusp. Lines with a
        dotted jump are the paths a–a′ (θ₀ = 60°, black) and b–b′ (θ₀ = 40°, violet) with μ₀ rising.
        {_HIDDEN_TEXT} x over L₀. {_RANGE_TEXT}""",
        **tables,
    )


def _draw_bifurcation_set(ax: Axes, p: Parameters, mu0: tuple[float, float] = MU0_RANGE) -> Table:
    """Fold curves over (θ₀, μ₀), what lies between them shaded, cusps marked."""
    found = bifurcation_set(p)
    columns: dict[str, list[FloatArray]] = {"curve": [], "theta0_deg": [], "mu0": []}
    angles, frictions = np.radians(np.linspace(0.1, 179.9, 400)), np.linspace(*mu0, 240)
    count = equilibria(p.replace(theta0=angles, mu0=frictions[:, None])).count
    if (count == 3).any():
        ax.contourf(np.degrees(angles), frictions, count, levels=[2, 4], colors=["#f7dfd0"], zorder=0)
    for number, curve in enumerate(found.curves):
        ax.plot(np.degrees(curve.theta0), curve.mu0, color=VERMILION)
        for name, values in zip(columns, (np.full(curve.mu0.size, number), np.degrees(curve.theta0), curve.mu0), strict=True):
            columns[name].append(values)
    ax.plot(
        np.degrees(found.cusps.theta0),
        found.cusps.mu0,
        linestyle="none",
        marker="o",
        markersize=3.6,
        color=BLACK,
        zorder=4,
    )
    angle_axis(ax)
    ax.set(ylabel=r"$\mu_0$", ylim=mu0)
    return {name: np.concatenate([[], *values]) for name, values in columns.items()}


@styled
def figure_12() -> Sheet:
    """The bifurcation set."""
    figure, ((ax,),) = panels(1, 1, SINGLE, 2.7)
    p = Parameters.article()
    table = _draw_bifurcation_set(ax, p)
    _label_regions(ax, p, [(20, 0.3), (155, 0.25)], (98, 0.6))
    for name, angle in PATHS_DEG.items():
        ax.axvline(angle, color=GREY, linewidth=0.6, linestyle=":")
        write_along(ax, f"$\\mathit{{{name}}}$–$\\mathit{{{name}}}$′", angle + 1.5, 0.93, color=GREY)
    return figure.describe(
        f"""Figure 12. Bifurcation set over inclination and friction, {_BASE_TEXT}: three equilibria in
        contact
        in the shaded regions, one elsewhere; the dot is the cusp. Dotted: the paths of Figure 13.
        {_RANGE_TEXT}""",
        a=table,
    )


def _label_regions(ax: Axes, p: Parameters, three: list[tuple[float, float]], one: tuple[float, float]) -> None:
    for place in three:
        write_along(ax, "3", *place, ha="center", fontsize=10)
    write_along(ax, "1", *one, ha="center", fontsize=10)
    cusp = bifurcation_set(p).cusps
    theta0, mu0 = float(np.degrees(cusp.theta0[0])), float(cusp.mu0[0])
    write_along(ax, f"cusp\n{theta0:.2f}°\n{mu0:.4f}", theta0 + 3, mu0 + 0.09, linespacing=0.95)


@styled
def figure_13() -> Sheet:
    """The paths a–a′ and b–b′: hysteresis, and a jump without return."""
    figure, (axes,) = panels(1, 2, DOUBLE, 2.7)
    tables: dict[str, Table] = {}
    for ax, (letter, angle) in zip(axes, PATHS_DEG.items(), strict=True):
        p = Parameters.article(theta0=np.radians(angle))
        curves = branches(p, "mu0", *MU0_RANGE)
        draw_branches(curves, ax=ax, color=GREY, linewidth=0.8)
        up, back = _both_ways(p, "mu0", np.linspace(*MU0_RANGE, 401))
        _draw_both_ways(ax, up, back, rising=(0.5,), falling=(0.5,))
        mark_folds(folds(p, "mu0"), ax=ax, high=MU0_RANGE[1])
        ax.set(xlabel=r"$\mu_0$", ylabel=LABELS["x"], xlim=(0, 1), ylim=(0, 1.7 if angle < 50 else 1.1))
        ax.set_title(rf"$\theta_0 = {angle:g}^\circ$", loc="right", color=GREY)
        tables |= {
            letter: table_of(curves),
            f"{letter}_rising": _table_of_path(up, "mu0"),
            f"{letter}_falling": _table_of_path(back, "mu0"),
        }
    for ax, rising, falling in zip(axes, ((0.3, 0.45), (0.3, 0.22)), ((0.3, 0.98), (0.2, 1.55)), strict=True):
        write_along(ax, r"$\mu_0$ rising", *rising, color=VERMILION)
        write_along(ax, r"$\mu_0$ falling", *falling, color=BLUE)
    return figure.describe(
        f"""Figure 13. Trajectories of the equilibrium as the friction rises and falls, (a) a–a′ at θ₀ = 60°: a
        jump either way, hysteresis; (b) b–b′ at θ₀ = 40°: one jump, and no return. Here {_BASE_TEXT}.
        Thin line: rising, broad line: falling. {_LINES_TEXT} {_RANGE_TEXT}""",
        **tables,
    )


def _draw_flutter(ax: Any, found: FlutterBoundary, mu0: tuple[float, float], cover: Cover | None = None) -> Table:
    """Onsets of flutter over (θ₀, μ₀), or with a cover on the surface."""
    style: dict[str, Any] = {"color": GREEN, "linewidth": 1.2, "linestyle": LINES[Stability.FLUTTER], "zorder": 3}
    for number in np.unique(found.curve):
        part = found.curve == number
        friction, angle, x = surfaces.inside(found.mu0[part], *mu0, np.degrees(found.theta0[part]), found.x[part])
        if cover is None:
            ax.plot(angle, friction, **style)
        else:
            _draw_line(ax, cover, angle, friction, x, **style)
    shown = (found.mu0 >= mu0[0]) & (found.mu0 <= mu0[1])
    return {
        "curve": found.curve[shown], "theta0_deg": np.degrees(found.theta0[shown]), "mu0": found.mu0[shown],
        "x": found.x[shown],
    }  # fmt: skip


@styled
def figure_14(*, detail: float = 1.0) -> Sheet:
    """Surface and bifurcation set at σ = 1, with flutter."""
    figure = Sheet(figsize=(DOUBLE, 3.3))
    space, plane = _space(figure, (0.02, 0.0, 0.56, 1.0), 0.95), figure.add_axes((0.64, 0.16, 0.345, 0.74))
    p = Parameters.article(sigma=1.0)
    onsets = flutter_boundary(p)
    cover, folded = _draw_surface(space, p, detail)
    tables = {"a": folded, "a_flutter": _draw_flutter(space, onsets, MU0_RANGE, cover)}
    tables["b"] = _draw_bifurcation_set(plane, p)
    tables["b_flutter"] = _draw_flutter(plane, onsets, MU0_RANGE)
    _label_regions(plane, p, [(40, 0.13), (150, 0.13)], (98, 0.75))
    for x in (6, 157):
        write_along(plane, "flutter", x, 0.85, color=GREEN)
    figure.text(0.02, 0.95, "(a)", va="center")
    plane.set_title("(b)", loc="left")
    return figure.describe(
        f"""Figure 14. Equilibria in contact at σ = 1, κ = 0.007, α = 0.007, β = 0. (a) Surface over
        inclination and friction: blue sheets are stable, orange divergent, green flutter; orange lines are folds,
        green ones onsets of flutter, the dot is the cusp. {_HIDDEN_TEXT} (b) Bifurcation set: three equilibria in the
        shaded regions, one elsewhere; dash-dotted, onsets of flutter on the sheet of largest θ. x over
        L₀. {_RANGE_TEXT}""",
        **tables,
    )
