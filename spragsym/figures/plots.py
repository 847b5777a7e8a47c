"""The picture of a result: which drawing function shows it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from ..errors import ParameterError
from ..results import Stability
from .curves import draw_path, mark_folds, name_axes
from .diagrams import diagram_figure
from .labels import as_drawn
from .motion_pictures import draw_motion
from .oscillation import branch_figure, fate_map_figure
from .planes import draw_bifurcation_set, draw_onset_curves
from .style import BLACK, own_axes, styled

#: Marks of equilibria by their stability.
_MARKS = {Stability.STABLE: ("o", "stable"), Stability.DIVERGENT: ("x", "divergent"), Stability.FLUTTER: ("^", "flutter")}


@styled
def plot(result: Any, ax: Axes | None = None, **options: Any) -> Any:
    """Draw a result as its kind is drawn elsewhere; of others the first column over the first that varies.

    Parameters
    ----------
    result : a result of this package
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default pyplot's current axes. Diagrams, branches and maps are figures of their own and take none.
    **options
        For the drawing function.

    Raises
    ------
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
    name = type(result).__name__
    if name in _FIGURES:
        return _FIGURES[name](result, **options)
    draw: Callable[..., Any] = _DRAWN.get(name, _columns)
    return draw(result, ax, **options)


def _path(path: Any, ax: Axes | None, quantity: str | None = None, **options: Any) -> Any:
    return draw_path(path, quantity or path.parameters.model.coordinates[0], ax=ax, **options)


def _points(points: Any, ax: Axes | None, quantity: str | None = None, **options: Any) -> Any:
    ax, model = own_axes(ax), points.parameters.model
    across, up = points.vary if len(points.vary) == 2 else (points.vary[0], quantity or model.coordinates[0])
    name_axes(ax, model, across, up)
    return mark_folds(points, up, ax=ax, **options)


def _equilibria(eq: Any, ax: Axes | None, quantity: str | None = None, **options: Any) -> Any:
    """States over the first parameter that varies, or by their number, marked by their stability."""
    ax, model, rows = own_axes(ax), eq.parameters.model, eq.data()
    up = quantity or model.coordinates[0]
    across = next((name for name in rows if name in model.parameters), None)
    along = np.arange(len(rows[up])) if across is None else as_drawn(model, across, rows[across])
    name_axes(ax, model, across or up, up)
    if across is None:
        ax.set_xlabel("state")
    lines = []
    for kind, (mark, word) in _MARKS.items():
        here = rows["stability"] == kind
        if here.any():
            style: dict[str, Any] = {"linestyle": "none", "marker": mark, "color": BLACK, "markersize": 3, "label": word}
            lines += ax.plot(along[here], as_drawn(model, up, rows[up][here]), **(style | options))
    return lines


def _motion(motion: Any, ax: Axes | None, *, transient: float = 0.0, of: str | None = None, **options: Any) -> Any:
    return draw_motion(motion.after(transient), of, ax, **options)


def _columns(result: Any, ax: Axes | None, **options: Any) -> Any:
    """The first column of numbers over another that varies, or over the row."""
    columns = {name: np.ravel(column) for name, column in result.data().items() if column.dtype.kind in "fiu"}
    if not columns:
        raise ParameterError(f"{type(result).__name__} has no columns of numbers, so that there is nothing to draw; print it")
    ax = own_axes(ax)
    names = [*columns][:2]
    across = columns[names[0]] if len(names) == 2 else np.arange(columns[names[0]].size)
    ax.set(xlabel=names[0] if len(names) == 2 else "row", ylabel=names[-1])
    return ax.plot(across, columns[names[-1]], ".", **options)


_FIGURES: Mapping[str, Callable[..., Any]] = {
    "Diagram": diagram_figure, "CycleBranch": branch_figure, "FateMap": fate_map_figure,
}  # fmt: skip
_DRAWN: Mapping[str, Callable[..., Any]] = {
    "Path": _path, "Points": _points, "Onsets": _points, "Equilibria": _equilibria,
    "BifurcationSet": draw_bifurcation_set, "OnsetCurves": draw_onset_curves, "Trajectory": _motion,
}  # fmt: skip
