"""The figures by name, and every kind of result drawn."""

from __future__ import annotations

from collections.abc import Callable
from functools import singledispatch
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes

import spragsym as ss

from ..article.drawn import DRAWN
from ..bifurcation.hopf_curves import OnsetCurves
from ..core.errors import ParameterError, require_kind
from ..orbits import CycleBranch, FateMap
from ..orbits.diagram import Diagram
from ..results import BifurcationSet, Equilibria, Path, Points, Result, Trajectory
from .curves import draw_path, mark_folds, name_axes, shade
from .cycles import (
    branch_figure,
    diagram_figure,
    draw_branch,
    draw_diagram,
    draw_fate_map,
    fate_map_figure,
)
from .motions import draw_motion
from .planes import draw_bifurcation_set, draw_onset_curves
from .style import BLACK, Sheet, own_axes, places, styled

if TYPE_CHECKING:
    from matplotlib.lines import Line2D

#: Name → the function that draws it, which is called after it: the article's numbers first.
FIGURES: dict[str, Callable[..., Sheet]] = {
    name: getattr(ss.figures, f"figure_{name.replace('-', '_')}") for name in DRAWN
}


@styled
def plot(result: Result, ax: Axes | None = None, **options: Any) -> Any:
    """Draw a result as its kind is drawn elsewhere; of others the first column over the first that
    varies.

    Parameters
    ----------
    result : a result of this package
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default pyplot's current axes. Diagrams, branches of cycles and maps of
        fates are figures of their own without it; of a branch the root mean square is drawn on it.
    **options
        For the drawing function.

    Raises
    ------
    ParameterTypeError
        For what is no result.
    ParameterError
        For a result without columns: there is nothing to draw.

    Examples
    --------
    >>> import spragsym as ss
    >>> from matplotlib.figure import Figure
    >>> path = ss.quasi_static_path(ss.Parameters.article(theta0=1.0), "mu0", [0.0, 0.1, 0.2])
    >>> ax = Figure().add_subplot()
    >>> _ = path.plot(ax)
    >>> len(ax.lines)
    1
    """
    require_kind("result", result, Result, "what a question gives, as ss.folds(p)")
    whole: dict[type, Callable[..., Sheet]] = {
        Diagram: diagram_figure,
        CycleBranch: branch_figure,
        FateMap: fate_map_figure,
    }
    if ax is None and type(result) in whole:
        return whole[type(result)](result, **options)
    return _drawn(result, ax=ax, **options)


@singledispatch
def _drawn(result: Result, ax: Axes | None, **options: Any) -> object:
    """A result on axes; of one that no function is registered for, the first column of numbers over
    another that varies, or over the row.
    """
    columns = [
        (name, np.ravel(column))
        for name, column in result.data().items()
        if column.dtype.kind in "fiu"
    ]
    if not columns:
        raise ParameterError(
            f"{type(result).__name__} has no columns of numbers, so that there is nothing to "
            "draw; print it"
        )
    if len(columns) == 1:
        columns.insert(0, ("row", np.arange(columns[0][1].size)))
    (across, x), (up, y), *_ = columns
    ax = own_axes(ax)
    ax.set(xlabel=across, ylabel=up)
    return ax.plot(x, y, ".", **options)


@_drawn.register(Points)
def _points(
    points: Points, ax: Axes | None, quantity: str | None = None, **options: Any
) -> list[Line2D]:
    ax, model = own_axes(ax), points.parameters.model
    across, up = (
        points.vary if len(points.vary) == 2 else (points.vary[0], quantity or model.coordinates[0])
    )
    name_axes(ax, model, across, up)
    return mark_folds(points, up, ax=ax, **options)


@_drawn.register(Equilibria)
def _equilibria(
    eq: Equilibria, ax: Axes | None, quantity: str | None = None, **options: Any
) -> list[Line2D]:
    """States over the first parameter that varies, or by their number, marked by stability.

    Where a point is undecided there is a hatched line."""
    ax, model, rows = own_axes(ax), eq.parameters.model, eq.data()
    up = quantity or model.coordinates[0]
    across = next((name for name in rows if name in model.parameters), None)
    (height,), along = places(model, (up,), rows), np.arange(eq.count.sum())
    if across is None:
        ax.set_xlabel("state")
    else:
        (along,) = places(model, (across,), rows)
        given = np.broadcast_to(eq.parameters[across], eq.count.shape)[~eq.decided]
        shade(ax, model, across, np.stack([given, given], axis=1))
    name_axes(ax, model, across or up, up)
    lines = []
    # Marks of equilibria by their stability.
    marks = {"stable": "o", "neutral": "d", "unstable": "x"}
    for kind, mark in marks.items():
        here = rows["stability"] == kind
        if here.any():
            style = {
                "linestyle": "none",
                "marker": mark,
                "color": BLACK,
                "markersize": 3,
                "label": kind,
                **options,
            }
            lines += ax.plot(along[here], height[here], **style)
    return lines


@_drawn.register(Trajectory)
def _motion(
    motion: Trajectory, ax: Axes | None, *, transient: float = 0.0, **options: Any
) -> Line2D:
    return draw_motion(motion.after(transient), ax=ax, **options)


for _kind, _on_axes in (
    (Path, draw_path),
    (BifurcationSet, draw_bifurcation_set),
    (OnsetCurves, draw_onset_curves),
    (Diagram, draw_diagram),
    (CycleBranch, draw_branch),
    (FateMap, draw_fate_map),
):
    _drawn.register(_kind, _on_axes)
