"""The article's Figures 11, 12 and 14: equilibrium surface and bifurcation set; and two of our own:
the critical friction, and double roots of the quartic in L that are no folds.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgba_array
from numpy.typing import NDArray

import spragsym as ss

from ..article.assumed import MU0_RANGE, Parameters
from ..generated import equilibrium as _equilibrium
from ..models.parameters import FloatArray, Span
from ..numerics.interval_arrays import Int8Array
from ..numerics.polynomials import eigenvalues
from ..results import EquilibriumType
from .curves import LABELS, path_pieces
from .equilibrium_curves import table_of_path
from .planes import draw_plane
from .style import (
    BASE_TEXT,
    BLACK,
    BLUE,
    DOUBLE,
    GREEN,
    GREY,
    LINES,
    PATHS_DEG,
    RANGE_TEXT,
    SINGLE,
    VERMILION,
    Sheet,
    Table,
    angle_axis,
    line_at,
    panels,
    plain_ticks,
    remark,
    single,
    stacked,
    styled,
    write_along,
)

if TYPE_CHECKING:
    from mpl_toolkits.mplot3d import Axes3D


@styled
def figure_11(*, detail: float = 1.0) -> Sheet:
    """The equilibrium surface with its folds, its cusp and the paths a–a′ and b–b′."""
    figure = Sheet(figsize=(4.6, 3.5))
    ax = space_axes(figure, (0.0, 0.02, 0.97, 0.98), 1.02)
    p = Parameters.article()
    lines = []
    for (name, angle), color in zip(PATHS_DEG.items(), (BLACK, "#5b2a86"), strict=True):
        up = ss.quasi_static_path(
            p.replace(theta0=np.radians(angle)), "mu0", np.linspace(*MU0_RANGE, 201)
        )
        pieces = path_pieces(up)
        lines += [(on_surface(mu0, np.radians(angle), x), color) for mu0, x in pieces]
        for (mu0, x), (_, landed) in itertools.pairwise(pieces):
            ends = [angle, angle], [mu0[-1], mu0[-1]], [x[-1], landed[0]]
            ax.plot(*ends, color=color, linewidth=1.2, linestyle=":", zorder=4)
        for (mu0, x), mark, at in ((pieces[0], "", 0), (pieces[-1], "′", -1)):
            position = angle, mu0[at] + (-0.06 if at == 0 else 0.05), x[at] + 0.12
            ax.text(*position, f"$\\mathit{{{name}}}${mark}", color=color, zorder=6)
        figure.tables[f"a_path_{name}"] = table_of_path(up)
    return figure.describe(
        f"""Figure 11. Surface of equilibria in contact over inclination and friction, {BASE_TEXT}.
        Blue sheets are stable, orange ones divergent; orange lines are the folds, the dot is the
        cusp. Lines with a dotted jump are the paths a–a′ (θ₀ = 60°, black) and b–b′ (θ₀ = 40°,
        violet) with μ₀ rising. Thin dashes lie behind a sheet. x over L₀. {RANGE_TEXT}""",
        a=draw_surface(ax, p, lines, detail),
    )


@styled
def figure_12() -> Sheet:
    """The bifurcation set."""
    figure, ax = single(SINGLE, 2.7)
    for name, angle in PATHS_DEG.items():
        line_at(ax, angle, width=0.6)
        write_along(
            ax, f"$\\mathit{{{name}}}$–$\\mathit{{{name}}}$′", angle + 1.5, 0.93, color=GREY
        )
    return figure.describe(
        f"""Figure 12. Bifurcation set over inclination and friction, {BASE_TEXT}: three equilibria
        in contact in the shaded regions, one elsewhere; the dot is the cusp. Dotted: the paths of
        Figure 13. {RANGE_TEXT}""",
        a=_regions(ax, Parameters.article(), {(20, 0.3): "3", (155, 0.25): "3", (98, 0.6): "1"}),
    )


@styled
def figure_14(*, detail: float = 1.0) -> Sheet:
    """Surface and bifurcation set at σ = 1, with flutter."""
    figure = Sheet(figsize=(DOUBLE, 3.3))
    space = space_axes(figure, (0.02, 0.0, 0.56, 1.0), 0.95)
    plane = figure.add_axes((0.64, 0.16, 0.345, 0.74))
    p = Parameters.article(sigma=1.0)
    onsets = ss.kang_nam.flutter_boundary(p)
    flutter = [
        on_surface(
            *(column[onsets.curve == number] for column in (onsets.mu0, onsets.theta0, onsets.x))
        )
        for number in np.unique(onsets.curve)
    ]
    shown = table_of_lines(flutter)
    tables = {
        "a": draw_surface(space, p, [(line, GREEN) for line in flutter], detail),
        "b": _regions(plane, p, {(40, 0.13): "3", (150, 0.13): "3", (98, 0.75): "1"}),
        "a_flutter": shown,
        "b_flutter": shown,
    }
    for line in flutter:
        style = LINES[EquilibriumType.FLUTTER]
        plane.plot(*line.T[:2], color=GREEN, linewidth=1.2, linestyle=style, zorder=3)
    for x in (6, 157):
        write_along(plane, "flutter", x, 0.85, color=GREEN)
    figure.text(0.02, 0.95, "(a)", va="center")
    plane.set_title("(b)", loc="left")
    return figure.describe(
        f"""Figure 14. Equilibria in contact at σ = 1, κ = 0.007, α = 0.007, β = 0. (a) Surface
        over inclination and friction: blue sheets are stable, orange divergent, green flutter;
        orange lines are folds, green ones onsets of flutter, the dot is the cusp. Thin dashes
        lie behind a sheet. (b) Bifurcation set: three equilibria in the shaded regions, one
        elsewhere; dash-dotted, onsets of flutter on the sheet of largest θ. x over L₀.
        {RANGE_TEXT}""",
        **tables,
    )


def _regions(ax: Axes, p: Parameters, counts: Mapping[tuple[float, float], str]) -> Table:
    """Draw the bifurcation set with the coordinates of the cusp, and the texts of ``counts``, which
    are numbers of equilibria, at their positions; returns the curves as a table.
    """
    found, _ = draw_plane(ax, p, {"mu0": MU0_RANGE})
    for position, text in counts.items():
        write_along(ax, text, *position, ha="center", fontsize=10)
    theta0, mu0 = np.degrees(found.cusps.theta0[0]), found.cusps.mu0[0]
    write_along(ax, f"cusp\n{theta0:.2f}°\n{mu0:.4f}", theta0 + 3, mu0 + 0.09, linespacing=0.95)
    return stacked(
        [{"theta0_deg": np.degrees(curve.theta0), "mu0": curve.mu0} for curve in found.curves],
        "curve",
    )


#: Proportions of the sides of the axes in three dimensions.
_ASPECT = (1.25, 1.1, 0.9)


def sheets(p: Parameters, theta0_deg: FloatArray, n: int) -> tuple[FloatArray, Int8Array]:
    """Mesh of the shown part of the equilibrium surface: quadrilaterals (cells, 4, 3) of (θ₀ in
    degrees, μ₀, x), and their stability (cells,).

    For each θ₀ there are ``n`` directions θ, from one end of the arc in contact to the other. At
    both ends μ₀ is infinite, so that the mesh has no holes.
    """
    theta0 = np.radians(theta0_deg)
    found = ss.kang_nam.surface(p, _directions(p, theta0, n), theta0[:, None])
    friction, x, clipped = found.mu0, found.x, np.clip(found.mu0, *MU0_RANGE)
    inside = friction == clipped
    # A vertex outside the range is moved to its end, on the line to a neighbour inside.
    for side in (1, -1) * 4:
        next_friction, next_x = np.roll(friction, side, axis=1), np.roll(x, side, axis=1)
        moves = (friction != clipped) & (next_friction == np.clip(next_friction, *MU0_RANGE))
        share = (clipped - friction) / np.where(moves, next_friction - friction, np.inf)
        friction, x = np.where(moves, clipped, friction), x + share * (next_x - x)
    cells = _corners(on_surface(friction, theta0[:, None], x))
    shown = np.isfinite(cells).all(axis=(2, 3)) & _corners(inside).any(axis=2)
    return cells[shown], found.undamped[:-1, :-1][shown]


def _corners(values: NDArray[Any]) -> NDArray[Any]:
    """Values at the four corners of each cell of a mesh, (rows − 1, columns − 1, 4, …)."""
    return np.stack([values[:-1, :-1], values[1:, :-1], values[1:, 1:], values[:-1, 1:]], axis=2)


def _directions(p: Parameters, theta0: FloatArray, n: int) -> FloatArray:
    """For each θ₀, ``n`` directions θ in contact, evenly spaced along the shown part of the surface
    and sparser outside.
    """
    kappa, sigma = p.scalars("kappa", "sigma")
    # In contact sin θ > sin θ₀ − κ/σ.
    least = np.arcsin(np.clip(np.sin(theta0) - kappa / sigma, 0.0, 1.0))
    u = np.linspace(1e-3, 1 - 1e-3, 20 * n)
    share = u**3 * (10 - 15 * u + 6 * u * u)  # dense at the ends, where μ₀ is steep
    theta = least[:, None] + (np.pi - 2 * least[:, None]) * share
    found = ss.kang_nam.surface(p, theta, theta0[:, None])
    shown = np.clip(found.mu0, MU0_RANGE[0] - 0.1, MU0_RANGE[1] + 0.1)
    # Outside of the shown range, the weight decreases with the distance from it.
    weight = 0.25 / (1 + (found.mu0 - shown) ** 2)[:, 1:]
    steps = np.hypot(np.diff(shown, axis=1), weight * np.diff(found.x, axis=1))
    length = np.pad(np.cumsum(steps, axis=1), [(0, 0), (1, 0)])
    even = np.linspace(0.0, 1.0, n)
    return np.array(
        [np.interp(even * along[-1], along, row) for along, row in zip(length, theta, strict=True)]
    )


def space_axes(figure: Sheet, corners: tuple[float, float, float, float], zoom: float) -> Axes3D:
    """Axes in three dimensions for θ₀, μ₀ and x."""
    ax: Any = figure.add_axes(
        corners,
        projection="3d",
        computed_zorder=False,
        proj_type="ortho",
        elev=24.0,
        azim=-118.0,
    )
    ax.tick_params(pad=-2)
    ax.zaxis.set_rotate_label(False)
    ax.set_box_aspect(_ASPECT, zoom=zoom)
    angle_axis(
        ax, step=45, ylabel=r"$\mu_0$", ylim=MU0_RANGE, zlim=(-2, 2), zticks=np.arange(-2, 3, 1)
    )
    ax.set_zlabel(LABELS["x"], rotation=90)
    return ax


def draw_surface(
    ax: Axes3D, p: Parameters, lines: Iterable[tuple[FloatArray, str]], detail: float
) -> Table:
    """Draw the equilibrium surface by stability, with folds, cusps and other ``lines``, each of
    points (n, 3) and a colour; returns a table of the folds.

    Lines are ribbons a little in front of the surface, which hides them where a sheet is nearer to
    the viewer; the hidden parts are dashed.
    """
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    cells, kinds = sheets(p, np.linspace(0.5, 179.5, round(160 * detail)), round(160 * detail))
    # Ranges of θ₀ in degrees, μ₀ and x, relative to the sides of the axes.
    size = np.divide((180.0, 1.0, 4.0), _ASPECT)
    up, turn = np.radians((ax.elev, ax.azim))
    viewer = np.array([np.cos(up) * np.cos(turn), np.cos(up) * np.sin(turn), np.sin(up)])
    normal = np.cross((cells[:, 2] - cells[:, 0]) / size, (cells[:, 3] - cells[:, 1]) / size)
    upright = np.abs(normal[:, 2]) / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
    sheet_colors = {
        EquilibriumType.STABLE: "#b3d9f0",
        EquilibriumType.DIVERGENT: "#f7b78f",
        EquilibriumType.FLUTTER: "#96dcc0",
    }
    colors = to_rgba_array([sheet_colors[EquilibriumType(kind)] for kind in kinds])
    colors[:, :3] *= 0.72 + 0.28 * upright[:, None]  # steep cells are darker
    found = ss.bifurcation_set(p)
    folds = [on_surface(curve.mu0, curve.theta0, curve.x) for curve in found.curves]
    polygons, faces = [cells], [colors]
    for points, color in (*lines, *((fold, VERMILION) for fold in folds)):
        ax.plot(*points.T, color=color, linewidth=0.6, linestyle=(0, (3.0, 2.2)), zorder=2)
        across = np.cross(np.diff(points, axis=0) / size, viewer)
        # Half of the width, and the distance from the surface, in units of the sides.
        across *= size * 0.0036 / np.maximum(np.linalg.norm(across, axis=1), 1e-300)[:, None]
        raised = points + 0.08 * viewer * size
        begin, end = raised[:-1], raised[1:]
        ribbon = np.stack([begin - across, end - across, end + across, begin + across], axis=1)
        ribbon = ribbon[np.isfinite(ribbon).all(axis=(1, 2))]
        polygons.append(ribbon)
        faces.append(np.repeat(to_rgba_array(color), len(ribbon), axis=0))
    face_colors = np.concatenate(faces)
    ax.add_collection3d(
        Poly3DCollection(
            np.concatenate(polygons),
            facecolors=face_colors,
            edgecolors=face_colors,
            linewidths=0.3,
            rasterized=True,
            zorder=1,
        )
    )
    cusps = np.degrees(found.cusps.theta0), found.cusps.mu0, found.cusps.x
    ax.plot(*cusps, "o", markersize=4, color=BLACK, zorder=5)
    return table_of_lines(folds)


def table_of_lines(lines: Iterable[FloatArray]) -> Table:
    """The points of lines on the surface as a table, without those outside of the shown range."""
    names = ("theta0_deg", "mu0", "x")
    tables = [dict(zip(names, line[np.isfinite(line[:, 1])].T, strict=True)) for line in lines]
    return stacked(tables, "curve", names)


def on_surface(mu0: FloatArray, theta0: FloatArray | float, x: FloatArray) -> FloatArray:
    """Points (…, 3) on the surface as (θ₀ in degrees, μ₀, x), from θ₀ in radians.

    μ₀ outside of the shown range is NaN, so that lines are interrupted there.
    """
    inside = np.where(mu0 == np.clip(mu0, *MU0_RANGE), mu0, np.nan)
    return np.stack(np.broadcast_arrays(np.degrees(theta0), inside, x), axis=-1)


@styled
def figure_cusp_friction(*, n: int = 41) -> Sheet:
    """The least friction at which the reference state ends, over each parameter, which explains
    Figures 8 to 10.
    """
    figure, axes = panels(2, 2, DOUBLE, 4.6)
    shown = {
        "beta": ((0.0, 3.0), (0.0, 1.0, 2.0), (1.0, 2.0), ()),
        "alpha": ((1e-3, 1.0), (0.007, 0.07, 0.7), (0.007, 0.07), (0.1, 1.0, 10.0)),
        "sigma": ((3e-3, 3.0), (0.01, 0.1, 1.0), (0.01, 0.1), (0.1, 0.2, 0.5)),
        "kappa": ((1e-4, 1.0), (0.007,), (1e-4, 0.007), (0.01, 0.1, 0.5)),
    }
    for letter, ax, (name, samples) in zip("abcd", axes.flat, shown.items(), strict=True):
        figure.tables[letter] = _draw_cusp_friction(ax, name, samples, n)
    return figure.describe(
        f"""The least friction at which the reference state ends at some inclination, μ_lowest, over
        (a) β, (b) α, (c) σ, (d) κ, the other parameters at {BASE_TEXT}. From small deformation
        a curve at μ₀ = 0.5 (dotted) jumps where μ_lowest lies below it. Dots are the article's
        samples, of its Figures 8 to 10 in (a) to (c); filled: jumps, open: does not. The number
        is the critical value. Where the curve of (d) ends there is no fold beyond."""
    )


#: Range of a parameter, the article's samples, a bracket of the critical value, and ticks of the
#: friction if the axes are logarithmic.
_Samples = tuple[Span, tuple[float, ...], Span, tuple[float, ...]]


def _draw_cusp_friction(ax: Axes, name: str, shown: _Samples, n: int) -> Table:
    """Draw one panel of :func:`figure_cusp_friction`; returns its data."""
    (low, high), samples, bracket, ticks = shown
    values = np.geomspace(low, high, n) if ticks else np.linspace(low, high, n)
    p, mu0 = Parameters.article(), Parameters.mu0
    varied = p.replace(**{name: values})
    frictions = np.asarray(ss.critical_friction(varied))
    ax.plot(values, frictions, color=BLACK)
    ax.axhline(mu0, color=GREY, linewidth=0.7, linestyle=":")
    for value in samples:
        friction = float(ss.critical_friction(p.replace(**{name: value})))
        filled = BLUE if friction < mu0 else "white"
        ax.plot(
            value,
            friction,
            "o",
            markersize=4.5,
            color=BLUE,
            markerfacecolor=filled,
            zorder=3,
            clip_on=False,
        )
    critical = ss.critical_value(p, name, between={name: bracket})
    line_at(ax, critical, VERMILION)
    if ticks:
        ax.set(xscale="log", yscale="log")
        plain_ticks(ax.yaxis, ticks)
        text, position = f"{critical:.3g}", (critical * 1.12, 0.06)
    else:
        ax.set(ylim=(0, 0.9))
        text, position = f"{critical:.6f}", (critical + 0.05, 0.06 / 0.9)
    write_along(ax, text, *position, VERMILION, transform=ax.get_xaxis_transform())
    ax.set(xlabel=rf"$\{name}$", ylabel=r"$\mu_{\mathrm{lowest}}$", xlim=(low, high))
    return {name: values, "mu_lowest": frictions, "mu_cusp": np.asarray(ss.cusp_friction(varied))}


def _in_contact(p: Parameters, theta0: FloatArray) -> tuple[Any, ...]:
    """Arguments of the generated functions in contact."""
    return np.cos(theta0), np.sin(theta0), *p.scalars("mu0", "kappa", "alpha", "sigma", "beta"), 1


def _root_gap(coefficients: tuple[FloatArray, ...]) -> FloatArray:
    """Smallest relative distance of two roots of each polynomial, coefficients lowest power
    first.
    """
    roots = eigenvalues(np.stack(np.broadcast_arrays(*coefficients), axis=-1).astype(float))
    one, other = (roots[..., which] for which in np.triu_indices(roots.shape[-1], 1))
    return (np.abs(one - other) / np.maximum(np.abs(one), np.abs(other))).min(axis=-1)


def root_gaps(p: Parameters, theta0: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Smallest relative distance of two roots, of the quartic in L and of that in t = tan(θ/2)."""
    given = _in_contact(p, theta0)
    in_t = _equilibrium.t_quartic(*_equilibrium.f_coefficients(*given))
    return _root_gap(_equilibrium.contact_quartic(*given[:-1])), _root_gap(in_t)


def false_double_roots(p: Parameters) -> FloatArray:
    """θ₀ at which the quartic in L has a double root that is no fold: f(θ) = f(π − θ) = 0.

    Then a sin θ + b = 0 and d sin θ = m sin² θ, so that a d + m b = 0. This is linear in cos θ₀ and
    sin θ₀, and quadratic in t = tan(θ₀/2).
    """
    # The values at θ₀ = 0, π/2 and π give the coefficients.
    a, b, d, m = _equilibrium.f_coefficients(*_in_contact(p, np.array([0, np.pi / 2, np.pi])))
    at_0, at_right_angle, at_pi = a * d + m * b
    t = np.roots([at_pi, 2 * at_right_angle - at_pi - at_0, at_0])
    return np.sort(2 * np.arctan(t.real[np.isreal(t) & (t.real > 0)]))


@styled
def figure_false_double_root() -> Sheet:
    """The quartic in L has a double root that is no fold; the quartic in t has none."""
    figure, (axes,) = panels(1, 2, DOUBLE, 2.6, sharey=True)
    p = Parameters.article()
    folds, false = np.degrees(ss.folds(p).theta0), np.degrees(false_double_roots(p))
    distances = np.geomspace(1e-8, 10, 150)
    near = [centre + side * distances for centre in (*folds, *false) for side in (-1, 1)]
    angles = np.unique(np.concatenate([np.linspace(0.5, 179.5, 400), *near]))
    angles = angles[(angles > 0.1) & (angles < 179.9)]
    gaps = root_gaps(p, np.radians(angles))
    for ax, gap, name in zip(axes, gaps, "Lt", strict=True):
        ax.semilogy(angles, gap, color=BLACK, linewidth=0.9)
        angle_axis(ax)
        remark(ax, f"quartic in ${name}$")
        for angle in folds:
            line_at(ax, angle, VERMILION, zorder=0)
            write_along(ax, f"fold\n{angle:.2f}°", angle + 2, 2e-5, color=VERMILION)
    for angle in false:
        line_at(axes[0], angle, BLUE, zorder=0)
        write_along(axes[0], f"no fold\n{angle:.2f}°", angle - 2, 2e-5, color=BLUE, ha="right")
    axes[0].set(ylabel="smallest relative\ndistance of two roots", ylim=(1e-6, 3))
    return figure.describe(
        f"""Smallest distance of two roots, relative to their size, at μ₀ = 0.5, {BASE_TEXT}, of
        (a) the quartic in L, the article's Equation (21), (b) the quartic in t = tan(θ/2). Both
        have a double root at the two folds; that in L has another where two different equilibria
        share the length σ/(σ + α), and where x and y can't be recovered from it.""",
        a={"theta0_deg": angles, "gap_L": gaps[0]},
        b={"theta0_deg": angles, "gap_t": gaps[1]},
    )
