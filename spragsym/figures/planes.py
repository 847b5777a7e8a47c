"""Planes of two parameters of any model: where the number of equilibria changes, and where
oscillation begins.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MultipleLocator
from numpy.lib.stride_tricks import sliding_window_view
from scipy.ndimage import binary_dilation, distance_transform_edt, zoom

import spragsym as ss

from ..bifurcation.flutter import ON_UNSTABLE
from ..bifurcation.hopf_curves import OnsetCurves
from ..core.errors import ModelError, require_kind
from ..core.questions import model_of
from ..display import own_name
from ..models import Model
from ..models.parameters import ParameterSet, Ranges, Span
from ..numerics.interval_arrays import FloatArray
from ..results import BifurcationSet, Equilibria, EquilibriumType
from ..statics.stability import NEUTRAL_GROWTH
from .style import (
    BLACK,
    GREY,
    LETTERS,
    SINGLE,
    VERMILION,
    Sheet,
    Table,
    label,
    once,
    own_axes,
    places,
    runs,
    say,
    single,
    stacked,
    styled,
    window,
    write_along,
)


def _table(found: BifurcationSet | OnsetCurves, *names: str) -> Table:
    """Table of the curves: index of the curve, the two parameters, and the named columns."""
    names = (*found.vary, *names)
    tables = [{name: curve[name] for name in names} for curve in found.curves]
    return stacked(tables, "curve", names)


def draw_bifurcation_set(
    found: BifurcationSet, ax: Axes | None = None, *, color: str = BLACK
) -> list[Any]:
    """Draw curves of folds and cusps in the plane of two parameters, with undecided parts of the
    searched lines as thick lines; returns the artists.

    Parameters
    ----------
    found : BifurcationSet
        Of :func:`spragsym.bifurcation_set`.
    ax : Axes, optional
    color : str
        Of the curves.
    """
    require_kind("found", found, BifurcationSet, "one of ss.bifurcation_set(...)")
    ax, model = own_axes(ax), found.cusps.parameters.model
    artists = [
        line
        for curve in found.curves
        for line in ax.plot(*places(model, found.vary, curve), color=color, label=once(ax, "folds"))
    ]
    x, y = places(model, found.vary, found.cusps)
    artists += ax.plot(x, y, "o", color=BLACK, markersize=3.5, label=once(ax, "cusps"))
    return [*artists, *_plane(ax, model, found)]


def draw_shown_set(
    found: BifurcationSet, ax: Axes | None = None, *, color: str = BLACK
) -> list[Any]:
    """Draw :func:`draw_bifurcation_set` on axes that end where those of other figures of the model
    do; curves may run on to values that no machine has.
    """
    ax = own_axes(ax)
    artists = draw_bifurcation_set(found, ax, color=color)
    p = found.cusps.parameters
    for (name, (low, high)), direction in zip(
        window(p, found.vary, {}, lambda: found.cusps).items(), "xy", strict=True
    ):
        size, (least, most) = p.model.column(name).size, getattr(ax, f"get_{direction}lim")()
        ax.set(**{f"{direction}lim": (max(least, size * low), min(most, size * high))})
    return artists


def draw_onset_curves(
    found: OnsetCurves, ax: Axes | None = None, *, shown: Ranges | None = None
) -> list[Any]:
    """Draw curves of Hopf points in the plane of two parameters (map of stability); returns the
    artists.

    Lines are full where the onset is supercritical, dashed where it is subcritical, and dotted
    where that is undecided; grey where the state is unstable on both sides. Dots: l₁ changes its
    sign (generalized Hopf, GH). Squares: points of codimension two (Bogdanov–Takens, BT; zero–Hopf,
    ZH; double Hopf, HH). With damping, the region in which oscillations grow is shaded and labelled
    "unstable". Without damping, two modes meet on the lines, which are grey. Undecided parts of the
    searched lines are thick.

    Parameters
    ----------
    found : OnsetCurves
        Of :func:`spragsym.onset_curves`.
    ax : Axes, optional
    shown : mapping, optional
        Ranges that the axes span, in place of those that were searched.
    """
    require_kind("found", found, OnsetCurves, "those of ss.onset_curves(...)")
    ax, model = own_axes(ax), found.points.parameters.model
    artists: list[Any] = []
    color = BLACK if found.damping else GREY
    styles = {"supercritical": "-", "subcritical": "--", "undecided": ":" if found.damping else "-"}
    for curve in found.curves:
        x, y = places(model, found.vary, curve)
        own = own_name(model, "onset")
        beside = curve[own] == ON_UNSTABLE
        for part in runs(np.char.add(curve.criticality, np.where(beside, own, ""))):
            kind, other = str(curve.criticality[part][0]), beside[part][0]
            label = f"{kind} onsets {ON_UNSTABLE}" if other else f"{kind} onsets"
            drawn = GREY if other else color
            artists += ax.plot(x[part], y[part], styles[kind], color=drawn, label=once(ax, label))
    for labels, points, marker, offset, name in (
        (itertools.repeat("GH"), found.changes, "o", (3, 3), "generalized Hopf points"),
        (found.points.kind, found.points, "s", (3, -9), "points of codimension two"),
    ):
        positions = places(model, found.vary, points)
        if not positions[0].size:
            continue
        artists += ax.plot(*positions, marker, color=BLACK, markersize=3.5, label=once(ax, name))
        artists += [
            ax.annotate(text, (x, y), offset, textcoords="offset points", fontsize="x-small")
            for x, y, text in zip(*positions, labels, strict=False)
        ]
    shown = shown or found.between
    if found.damping and found.curves:
        shade_oscillating(ax, found.points.parameters, found.vary, shown)
    _span(ax, model, found.vary, shown)
    return [*artists, *_plane(ax, model, found)]


def shade_oscillating(ax: Axes, p: ParameterSet, vary: Sequence[str], shown: Ranges) -> None:
    """Shade the region in which a state in contact has growing oscillations, by its eigenvalues
    with all damping; lighter for very slow growth. The region is labelled "unstable".

    Parameters
    ----------
    ax : Axes
    p : Parameters
        Scalars; those that vary are not used.
    vary : pair of str
        Two parameters: across and up.
    shown : mapping
        Their ranges; growth rates are interpolated between values within.
    """

    def growth_at(across: FloatArray, up: FloatArray) -> FloatArray:
        values = dict(zip(vary, (across, up), strict=True))
        return growth_of_oscillations(ss.equilibria(p.replace(**values)))

    *grid, growth = sampled_by_sign(growth_at, *_reached(p, vary, shown))
    if not (growth > 0).any():
        return
    grid = places(p.model, vary, dict(zip(vary, grid, strict=True)))
    # The first colour is for very slow growth.
    ax.contourf(
        *grid,
        growth,
        levels=[0.0, NEUTRAL_GROWTH, np.inf],
        colors=["#fcf1ea", "#f7dfd0"],
        zorder=0,
    )
    # The label is at the point farthest from the border of the region.
    depth = distance_transform_edt(np.pad(growth > 0, 1))[1:-1, 1:-1]
    row, column = np.unravel_index(np.argmax(depth), depth.shape)
    write_along(ax, "unstable", grid[0][column], grid[1][row], color=VERMILION, ha="center")


def _reached(p: ParameterSet, vary: Sequence[str], shown: Ranges) -> list[Span]:
    """The ranges of two parameters, restricted to the values that the page allows."""
    ends = (map(p.ranges[name].reached, shown[name]) for name in vary)
    return [(low, high) for low, high in ends]


def sampled_by_sign(
    function: Callable[[FloatArray, FloatArray], FloatArray], across: Span, up: Span
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Values of a function on a grid over a rectangle, to draw the contour where it is 0.

    Near changes of sign the function is evaluated on the fine grid. Elsewhere values are
    interpolated linearly from a coarse grid.

    Parameters
    ----------
    function : callable
        Of arrays that broadcast: values across, and up.
    across, up : pair of float
        Ends of the rectangle.

    Returns
    -------
    tuple of array
        Values across, values up, and the function, (up, across).
    """
    # Values of each parameter in the coarse grid, and parts into which the fine one divides a cell.
    count, parts = 48, 6
    fine_index = np.arange((count - 1) * parts + 1)
    x, y = (np.linspace(*ends, fine_index.size) for ends in (across, up))
    values = function(np.linspace(*across, count), np.linspace(*up, count)[:, None])
    corners = sliding_window_view(values > 0, (2, 2))
    mixed = corners.any(axis=(2, 3)) & ~corners.all(axis=(2, 3))
    near = binary_dilation(mixed, np.ones((3, 3)))  # the contour may end in a cell beside these
    cell = np.minimum(fine_index // parts, count - 2)
    rows, columns = np.nonzero(near[np.ix_(cell, cell)])
    result = zoom(values, fine_index.size / count, order=1)
    result[rows, columns] = function(x[columns], y[rows])
    return x, y, result


def growth_of_oscillations(eq: Equilibria) -> FloatArray:
    """Largest ratio Re λ / |λ|, a negative damping ratio, over the eigenvalues of all states in
    contact that do not diverge without damping; −1 if there is no such state.
    """
    roots = np.nan_to_num(eq.damped_eigenvalues)
    size = np.abs(roots)
    oscillates = np.isin(eq.undamped, (EquilibriumType.STABLE, EquilibriumType.FLUTTER))
    rates = np.where(size > 0, roots.real / np.where(size > 0, size, 1.0), 0.0)
    return np.where(oscillates, rates.max(axis=-1), -1.0).max(axis=-1, initial=-1.0)


def _plane(ax: Axes, model: Model, found: BifurcationSet | OnsetCurves) -> list[Any]:
    """Name the axes, and draw the undecided parts of the lines that were searched."""
    x_column, y_column = map(model.column, found.vary)
    ax.set(xlabel=label(x_column), ylabel=label(y_column))
    # Closed forms search no lines.
    ends = zip((x_column, y_column), found.undecided.swapaxes(0, 1)[-2:], strict=False)
    places = (column.size * spans.T for column, spans in ends)
    lines = ax.plot(*places, color=VERMILION, linewidth=3, alpha=0.4, solid_capstyle="round")
    for line in lines:
        line.set_label(once(ax, "undecided"))
    return lines


def _span(ax: Axes, model: Model, vary: Sequence[str], between: Ranges) -> None:
    """Set the limits of the axes to the given ranges; ticks every 30 degrees for wide angles."""
    for direction, name in zip("xy", vary, strict=True):
        low, high = model.column(name).size * np.array(between[name])
        ax.set(**{f"{direction}lim": (low, high)})
        if model.is_angle(name) and high - low > 120:
            getattr(ax, f"{direction}axis").set_major_locator(MultipleLocator(30))


@styled
def stability_figure(found: OnsetCurves) -> Sheet:
    """Map of stability in the plane of two parameters: curves of supercritical and subcritical
    onsets, as a figure.

    Parameters
    ----------
    found : OnsetCurves
        Of :func:`spragsym.onset_curves`.
    """
    figure, ax = single(SINGLE, 2.7)
    draw_onset_curves(found, ax)
    model = found.points.parameters.model
    if not found.curves and not len(found.points):
        _say_none(ax, "onsets", found.complete)
    lines = " without damping: two modes meet."
    if found.damping:
        lines = """, supercritical on full lines, subcritical on dashed,
        undecided on dotted ones. Dots: GH; squares: curves end on folds (BT, ZH) or cross (HH)."""
    return figure.describe(
        f"Onsets of oscillation of {model.name}{lines}{on_undecided(found)}",
        a=_table(found, *model.coordinates, "omega", "lyapunov", "lyapunov_error"),
    )


def on_undecided(found: BifurcationSet | OnsetCurves) -> str:
    """A sentence on undecided boxes, if there are any."""
    count = len(found.undecided)
    return f" {count} boxes on its lines are undecided." if count else ""


def _say_none(ax: Axes, what: str, complete: bool) -> None:
    """Write that a figure is empty, and whether the search was complete."""
    say(ax, f"no {what} here" if complete else f"no {what} found here; not complete")


def draw_plane(
    ax: Axes,
    p: ParameterSet,
    between: Ranges,
    vary: Sequence[str] | None = None,
    n: int | None = None,
) -> tuple[BifurcationSet, bool]:
    """Draw the bifurcation set; returns it, and whether regions with three equilibria are shaded.

    They are if the model counts equilibria in closed form. A search looks at ``n`` lines.
    """
    model = model_of(p)
    vary = tuple(model.two(vary))
    between = window(p, vary, between, lambda: ss.cusps(p, vary))
    found = ss.bifurcation_set(p, vary, n, between=between)
    draw_bifurcation_set(found, ax, color=VERMILION)
    _span(ax, model, vary, between)
    across, up = _reached(p, vary, between)
    grid = np.linspace(*across, 400), np.linspace(*up, 240)
    try:
        inside = p.replace(**dict(zip(vary, np.meshgrid(*grid, sparse=True), strict=True)))
        count = ss.count(inside, method="closed")
    except ModelError:
        return found, False
    if (count == 3).any():
        shown = places(model, vary, dict(zip(vary, grid, strict=True)))
        ax.contourf(*shown, count, levels=[2, 4], colors=["#f7dfd0"], zorder=0)
    return found, True


@styled
def bifurcation_figure(
    p: ParameterSet,
    vary: Sequence[str] | None = None,
    *,
    between: Ranges | None = None,
    n: int = 60,
    onsets: OnsetCurves | None = None,
) -> Sheet:
    """The bifurcation set of any model in the plane of two parameters, as a figure.

    Parameters
    ----------
    p : Parameters
        Scalars; those that vary are not used.
    vary : (str, str), optional
        Two parameters: across and up; theta0 and mu0 unless told otherwise.
    between : mapping, optional
        Their ranges, as for :func:`spragsym.folds`.
    n : int
        Lines of either parameter on which a search looks for folds: a closed curve between two of
        them is not seen.
    onsets : OnsetCurves, optional
        Of :func:`spragsym.onset_curves` in this plane, drawn as well.
    """
    figure, ax = single(SINGLE, 2.7)
    found, shaded = draw_plane(ax, p, between or (onsets.between if onsets else {}), vary, n)
    model = p.model
    if onsets is not None:
        draw_onset_curves(onsets, ax)
    if not (found.curves or len(found.cusps) or onsets):
        what = "folds and cusps" if onsets is None else "folds, cusps and onsets"
        _say_none(ax, what, found.complete)
    fixed = [name for name in model.balanced if name not in found.vary]
    values = ", ".join(
        f"{LETTERS.get(name, name)} = {value:g}"
        for name, value in zip(fixed, p.scalars(*fixed), strict=True)
    )
    at = f" at {values}" if values else ""
    three = ", three in contact in the shaded regions and one elsewhere" if shaded else ""
    lines = (
        "black lines, and on grey ones in a state that is unstable already"
        if onsets and onsets.damping
        else "grey lines"
    )
    sets_in = f" Oscillation sets in on the {lines}." if onsets else ""
    return figure.describe(
        f"""Bifurcation set of {model.name}{at}: two equilibria in contact meet on the lines{three};
        dots are cusps.{on_undecided(found)}{sets_in}""",
        a=_table(found, *model.coordinates),
        **({"onsets": _table(onsets, "omega")} if onsets else {}),
    )
