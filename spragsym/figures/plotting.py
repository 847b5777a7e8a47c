"""Figures by name, and :func:`plot`, which draws any result by its type."""

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
from ..design.probability import JumpProbability
from ..matrices.answers import MatrixOnsets
from ..motion.sweeps import Basin, Sweep
from ..orbits import Cycle, CycleBranch, CycleEvent, Fate, FateMap, Lyapunov
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
from .motions import draw_basin, draw_motion, draw_phase, draw_sweep
from .planes import draw_onset_curves, draw_shown_set
from .report_pages import draw_shares
from .squeal import draw_squeal, squeal_figure
from .style import BLACK, Sheet, own_axes, places, styled

if TYPE_CHECKING:
    from matplotlib.lines import Line2D

#: Functions that draw the figures, by the name of the figure; the article's figures come first.
FIGURES: dict[str, Callable[..., Sheet]] = {
    name: getattr(ss.figures, f"figure_{name.replace('-', '_')}") for name in DRAWN
}


@styled
def plot(result: Result, ax: Axes | None = None, **options: Any) -> Any:
    """Draw a result in the way that fits its type.

    A result of a type that is not drawn elsewhere is drawn as points: its second column of numbers
    over the first, or its only one over the row.

    Parameters
    ----------
    result : a result of this package
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default pyplot's current axes. Without it, diagrams, branches of cycles
        and maps of fates become figures of their own. On given axes, the root mean square of a
        branch is drawn.
    **options
        For the drawing function.

    Raises
    ------
    ParameterTypeError
        If ``result`` is no result.
    ParameterError
        If the result has no columns of numbers.

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
    figures: dict[type, Callable[..., Sheet]] = {
        Diagram: diagram_figure,
        CycleBranch: branch_figure,
        FateMap: fate_map_figure,
        MatrixOnsets: squeal_figure,
    }
    if ax is None and type(result) in figures:
        return figures[type(result)](result, **options)
    return _drawn(result, ax=ax, **options)


@singledispatch
def _drawn(result: Result, ax: Axes | None, **options: Any) -> object:
    """Draw a result on axes. This is the fallback for types without a function of their own: the
    second column of numbers over the first, or the only one over the row.
    """
    kind, schema = type(result).__name__, result._schema
    columns = [
        (name, np.ravel(column))
        for name, column in result.data().items()
        if column.dtype.kind in "fiu" and column.ndim
    ]
    if not columns:
        raise ParameterError(
            f"{kind} is one row of numbers and words, which no picture shows; print it"
        )
    if len(columns) == 1:
        columns.insert(0, ("row", np.arange(columns[0][1].size)))
    (x_name, x), (y_name, y), *_ = columns
    ax, (x_column, y_column) = own_axes(ax), map(schema.column, (x_name, y_name))
    ax.set(xlabel=schema.heading(x_name), ylabel=schema.heading(y_name))
    style = {"label": schema.heading(y_name), **options}
    return ax.plot(x_column.size * x, y_column.size * y, ".", **style)


@_drawn.register(Points)
def _points(
    points: Points, ax: Axes | None, quantity: str | None = None, **options: Any
) -> list[Line2D]:
    """Draw points over the first parameter that varies: the second one, or a coordinate."""
    ax, model = own_axes(ax), points.parameters.model
    y_name = points.vary[1] if len(points.vary) == 2 else quantity or model.coordinates[0]
    name_axes(ax, model, points.vary[0], y_name)
    return mark_folds(points, y_name, ax=ax, **options)


@_drawn.register(Equilibria)
def _equilibria(
    eq: Equilibria, ax: Axes | None, quantity: str | None = None, **options: Any
) -> list[Line2D]:
    """Draw states over the first parameter that varies, or over their number, with markers by
    stability.

    Undecided points are hatched.
    """
    ax, model, rows = own_axes(ax), eq.parameters.model, eq.data()
    y_name = quantity or model.coordinates[0]
    (y,) = places(model, (y_name,), rows)
    x_name = next((name for name in rows if name in model.parameters), None)
    if x_name is None:
        x = np.arange(eq.count.sum())
        ax.set_xlabel("state")
    else:
        (x,) = places(model, (x_name,), rows)
        undecided = np.broadcast_to(eq.parameters[x_name], eq.count.shape)[~eq.decided]
        shade(ax, model, x_name, np.stack([undecided, undecided], axis=1))
    name_axes(ax, model, x_name or y_name, y_name)
    lines, style = [], {"linestyle": "none", "color": BLACK, "markersize": 3}
    for kind, marker in {"stable": "o", "neutral": "d", "unstable": "x"}.items():
        mask = rows["stability"] == kind
        if mask.any():
            lines += ax.plot(
                x[mask], y[mask], **{**style, "marker": marker, "label": kind, **options}
            )
    return lines


@_drawn.register(Trajectory)
def _motion(
    motion: Trajectory, ax: Axes | None, *, transient: float = 0.0, **options: Any
) -> Line2D:
    """Draw a motion after its transient."""
    return draw_motion(motion.after(transient), ax=ax, **options)


@_drawn.register(Cycle)
def _cycle(cycle: Cycle, ax: Axes | None, **options: Any) -> Line2D:
    """Draw a cycle in the phase plane of its first coordinate."""
    return draw_phase(cycle.trajectory(), ax=ax, **options)


@_drawn.register(CycleEvent)
def _event(event: CycleEvent, ax: Axes | None, **options: Any) -> Line2D:
    """Draw the cycle of an event."""
    return draw_phase(event.cycle.trajectory(), ax=ax, **options)


@_drawn.register(Lyapunov)
def _exponents(found: Lyapunov, ax: Axes | None, **options: Any) -> list[Line2D]:
    """Draw the convergence of the exponents over time."""
    ax = own_axes(ax)
    ax.set(xlabel="t", ylabel="mean since the middle of the motion")
    names = [f"exponent {number}" for number in range(1, found.running.shape[1] + 1)]
    return ax.plot(found.t, found.running, label=names, **options)


@_drawn.register(Fate)
def _fate(fate: Fate, ax: Axes | None, **options: Any) -> object:
    """Refuse: a fate is one row, beside the exponents that decide it."""
    raise ParameterError(
        "a fate is a verdict; draw the motion, ss.simulate(p).plot(), the cycle that it comes to, "
        "ss.cycle(p).plot(), or fates over parameters, ss.fate_map(p).plot()"
    )


@_drawn.register(JumpProbability)
def _shares(found: JumpProbability, ax: Axes | None, **options: Any) -> object:
    """Draw the shares of the quantities in the variance."""
    if not found.sobol:
        raise ParameterError(
            "this probability has no Sobol' indices, whose bars would be drawn; ask for them with "
            "sobol=True"
        )
    ax = own_axes(ax)
    draw_shares(found.sobol, ax, **options)
    return ax


for _type, _draw in (
    (Sweep, draw_sweep),
    (Basin, draw_basin),
    (Path, draw_path),
    (BifurcationSet, draw_shown_set),
    (OnsetCurves, draw_onset_curves),
    (Diagram, draw_diagram),
    (CycleBranch, draw_branch),
    (FateMap, draw_fate_map),
    (MatrixOnsets, draw_squeal),
):
    _drawn.register(_type, _draw)
