"""Figures of any model: where the number of its equilibria changes, and where oscillation begins."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ..dynamics import Trajectory
from ..models import Model
from ..models.describe import units_of
from ..models.hopf_curves import OnsetCurves
from ..results.bifurcation_sets import BifurcationSet
from .labels import Between, is_angle, label, window
from .motion_pictures import draw_motion
from .style import BLACK, DOUBLE, GREEN, SINGLE, Sheet, own_axes, panels, styled


@styled
def model_motion_figure(motion: Trajectory) -> Sheet:
    """Each coordinate of a motion of a model over time, as a figure.

    Parameters
    ----------
    motion : Trajectory
        Of ``model.simulate``.
    """
    model = motion.model
    figure, axes = panels(len(model.coordinates), 1, DOUBLE, 1.8 * len(model.coordinates), sharex=True)
    for name, ax in zip(model.coordinates, axes[:, 0], strict=True):
        draw_motion(motion, name, ax, labels=("", label(model, name)))
    axes[-1, 0].set(xlabel="$t$")
    return figure.describe(
        f"""A motion of {model.name}, in its units: {units_of(model.about)}.""",
        **{letter: {"t": motion.t, name: getattr(motion, name)} for letter, name in zip("abcd", model.coordinates, strict=False)},
    )


def _shown(model: Model, name: str, values: Any) -> Any:
    return np.degrees(values) if is_angle(model, name) else values


def draw_bifurcation_set_of(model: Model, found: BifurcationSet, ax: Axes | None = None) -> list[Any]:
    """Curves of folds and cusps in the plane of two parameters; returns the artists.

    Parameters
    ----------
    model : Model
    found : BifurcationSet
        Of ``model.bifurcation_set``.
    ax : Axes, optional
    """
    ax = own_axes(ax)
    one, two = found.vary
    artists: list[Any] = []
    for curve in found.curves:
        artists += ax.plot(_shown(model, one, getattr(curve, one)), _shown(model, two, getattr(curve, two)), color=BLACK)
    cusps = [_shown(model, name, getattr(found.cusps, name)) for name in found.vary]
    artists += ax.plot(*cusps, "o", color=BLACK, markersize=3.5)
    ax.set(xlabel=label(model, one), ylabel=label(model, two))
    return artists


def draw_onset_curves_of(model: Model, found: OnsetCurves, ax: Axes | None = None) -> list[Any]:
    """Curves of Hopf points in the plane of two parameters, as maps of stability are printed; returns the artists.

    Full where the onset is gentle, dashed where it is dangerous, dotted where that is undecided; dots where that changes (GH),
    squares for points of two conditions (Bogdanov–Takens, BT; zero–Hopf, ZH; double Hopf, HH).

    Parameters
    ----------
    model : Model
    found : OnsetCurves
        Of ``model.onset_curves``.
    ax : Axes, optional
    """
    ax = own_axes(ax)
    one, two = found.vary
    artists: list[Any] = []
    styles = {"gentle": "-", "dangerous": "--", "undecided": ":"}
    for curve in found.curves:
        across, up = _shown(model, one, getattr(curve, one)), _shown(model, two, getattr(curve, two))
        kinds = curve.criticality
        begins = np.flatnonzero(np.concatenate([[True], kinds[1:] != kinds[:-1]]))
        for begin, end in zip(begins, [*begins[1:], len(kinds) - 1], strict=True):
            part = slice(begin, end + 1)
            artists += ax.plot(across[part], up[part], styles[str(kinds[begin])], color=BLACK)
    changes = (["GH"] * len(found.changes["error"]), found.changes, "o")
    points = (found.points.kind.tolist(), {name: getattr(found.points, name) for name in found.vary}, "s")
    for labels, rows, marker in (changes, points):
        places = [_shown(model, name, rows[name]) for name in found.vary]
        artists += ax.plot(*places, marker, color=BLACK, markersize=3.5)
        for text, place in zip(labels, zip(*places, strict=True), strict=True):
            artists.append(ax.annotate(text, place, (3, 3), textcoords="offset points", fontsize="x-small"))
    ax.set(xlabel=label(model, one), ylabel=label(model, two))
    return artists


def draw_onsets_of(
    model: Model, p: Any, vary: Sequence[str], ax: Axes | None = None, *, damping: bool | None = None,
    between: Between | None = None, n: int = 60,
) -> list[Any]:  # fmt: skip
    """Onsets of flutter along the second parameter, on n lines of the first; returns the artists.

    Parameters
    ----------
    model : Model
    p : Parameters
        Of the model, scalars; those that vary are not used.
    vary : (str, str)
        Two parameters: across and up.
    ax : Axes, optional
    damping, between
        As for ``model.flutter_onsets``.
    n : int
        Lines.
    """
    from ..models.points import ranges

    ax = own_axes(ax)
    one, two = vary
    given = between or {}
    low, high = ranges(model, (one,), {one: given[one]} if one in given else {})[0]
    spans = {two: given[two]} if two in given else None
    points: list[list[float]] = [[], []]
    for value in low + (high - low) * (np.arange(n) + 0.5) / n:
        found = model.search.flutter_onsets(p.replace(**{one: float(value)}), two, damping=damping, between=spans)
        points[0] += [float(value)] * len(found)
        points[1] += getattr(found, two).tolist()
    artists: list[Any] = ax.plot(*(_shown(model, name, np.array(column)) for name, column in zip(vary, points, strict=True)), ".",
                                 color=GREEN, markersize=3)  # fmt: skip
    ax.set(xlabel=label(model, one), ylabel=label(model, two))
    return artists


@styled
def stability_figure(model: Model, found: OnsetCurves) -> Sheet:
    """The map of stability in the plane of two parameters: where oscillation sets in, gently or dangerously, as a figure.

    Parameters
    ----------
    model : Model
    found : OnsetCurves
        Of ``model.onset_curves``.
    """
    figure, ((ax,),) = panels(1, 1, SINGLE, 2.7)
    draw_onset_curves_of(model, found, ax)
    names = (*found.vary, *model.coordinates, "omega", "lyapunov", "lyapunov_error")
    columns = {name: np.concatenate([getattr(curve, name) for curve in found.curves] or [np.empty(0)]) for name in names}
    number = np.concatenate([np.full(curve.omega.size, k) for k, curve in enumerate(found.curves)] or [np.empty(0)])
    open_boxes = "" if not len(found.undecided) else f" {len(found.undecided)} boxes on its lines are undecided."
    return figure.describe(
        f"""Onsets of oscillation of {model.name}, gentle on full lines and dangerous on dashed ones, undecided on dotted ones.
        Dots: the kind changes (GH); squares: curves end on folds (BT, ZH) or cross (HH).{open_boxes}""",
        a={"curve": number, **columns},
    )


@styled
def model_figure(model: Model, p: Any, vary: Sequence[str], *, between: Between | None = None, n: int = 60) -> Sheet:
    """The bifurcation set of a model in the plane of two parameters, as a figure.

    Parameters
    ----------
    model : Model
    p : Parameters
        Of the model, scalars; those that vary are not used.
    vary : (str, str)
        Two parameters: across and up.
    between : mapping, optional
        Their ranges, as for ``model.folds``.
    n : int
        Lines of either parameter on which folds are looked for: a closed curve between two of them is not seen.
    """
    figure, ((ax,),) = panels(1, 1, SINGLE, 2.7)
    found = model.search.bifurcation_set(p, vary, n, between=window(model, vary, between or {}))
    draw_bifurcation_set_of(model, found, ax)
    names = (*found.vary, *model.coordinates)
    columns = {name: np.concatenate([getattr(curve, name) for curve in found.curves] or [np.empty(0)]) for name in names}
    number = np.concatenate([np.full(getattr(curve, vary[0]).size, k) for k, curve in enumerate(found.curves)] or [np.empty(0)])
    open_boxes = "" if not len(found.undecided) else f" {len(found.undecided)} boxes on its lines are undecided."
    return figure.describe(
        f"""Bifurcation set of {model.name}: two equilibria in contact meet on the lines; dots are cusps.{open_boxes}""",
        a={"curve": number, **columns},
    )
