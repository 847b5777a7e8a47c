"""Equilibrium curves: computed branch by branch, cut where a branch ends, drawn by stability."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from ..door import only_for
from ..kang_nam.catastrophe.flutter_points import flutter_onsets
from ..kang_nam.catastrophe.fold_points import folds
from ..kang_nam.statics.solver import equilibria
from ..parameters import RANGES, FloatArray, Parameters
from ..results.equilibria import Equilibria, Stability
from ..results.paths import Path
from ..results.points import Points
from .style import BLACK, LINES, Table, own_axes, styled

#: Names of axes.
LABELS = {"x": r"$x_{\mathrm{eq}}$", "y": r"$y_{\mathrm{eq}}$", "theta": r"$\theta$ (deg)", "L": r"$L$"}
#: Labels of axes in drawings without a caption: with the unit.
_WITH_UNITS = {
    "theta0": r"$\theta_0$ (deg)",
    "mu0": r"$\mu_0$ (dimensionless)",
    "kappa": r"$\kappa$ (dimensionless)",
    "alpha": r"$\alpha$ (dimensionless)",
    "sigma": r"$\sigma$ (dimensionless)",
    "beta": r"$\beta$ (dimensionless)",
    "x": r"$x_{\mathrm{eq}}$ (units of $L_0$)",
    "y": r"$y_{\mathrm{eq}}$ (units of $L_0$)",
    "theta": r"$\theta$ (deg)",
    "L": r"$L$ (units of $L_0$)",
}
_ANGLES = ("theta0", "theta")
_STATE = ("theta", "L", "x", "y")


@dataclass(frozen=True)
class Branch:
    """A piece of an equilibrium curve of one stability, from end to end; angles in radians."""

    vary: str
    values: FloatArray
    theta: FloatArray
    L: FloatArray
    x: FloatArray
    y: FloatArray
    stability: Stability

    def shown(self, name: str) -> FloatArray:
        """A coordinate or the parameter as an axis shows it: angles in degrees."""
        value: FloatArray = self.values if name == self.vary else getattr(self, name)
        return np.degrees(value) if name in _ANGLES else value


def name_axes(ax: Axes, vary: str, quantity: str) -> None:
    """Label axes that have no label yet."""
    if not ax.get_xlabel():
        ax.set_xlabel(_WITH_UNITS[vary])
    if not ax.get_ylabel():
        ax.set_ylabel(_WITH_UNITS[quantity])


@only_for(Parameters, "model.equilibria(p) along an axis has the states")
def branches(
    p: Parameters, vary: str = "theta0", low: float | None = None, high: float | None = None, *,
    contact: bool = True, n: int = 200,
) -> list[Branch]:  # fmt: skip
    """All equilibrium curves as one parameter varies, complete: cut at every fold and flutter onset.

    Parameters
    ----------
    p : Parameters
        Scalars; the parameter that varies is not used.
    vary : str
        Its name.
    low, high : float, optional
        Its range; by default 0 < θ₀ < π, and 0 to 1 for another.
    contact : bool
        Steady sliding, or lift-off.
    n : int
        Points of each piece, denser towards its ends.
    """
    allowed = RANGES[vary]
    top = allowed.high if np.isfinite(allowed.high) else 1.0
    inset = 1e-4 if allowed.open_low else 0.0
    low = allowed.low + inset if low is None else low
    high = top - inset if high is None else high
    turns = folds(p, vary) if contact else None
    found = []
    for begin, end in itertools.pairwise(_cuts(p, vary, low, high, turns)):
        # 1 - cos gathers points where a curve turns back like a square root.
        share = 0.5 - 0.5 * np.cos(np.pi * np.linspace(1e-4, 1 - 1e-4, n))
        values = begin + (end - begin) * share
        eq = equilibria(p.replace(**{vary: values}), contact=contact)
        for rank in range(int(eq.count.max())):
            found += _pieces(vary, values, eq, rank, turns, (begin, end))
    return found


def _cuts(p: Parameters, vary: str, low: float, high: float, turns: Points | None) -> list[float]:
    """The ends of the range, and between them the folds and the flutter onsets."""
    inner: list[float] = [] if turns is None else getattr(turns, vary).tolist()
    if turns is not None and vary == "theta0":
        inner += flutter_onsets(p).theta0.tolist()
    return [low, *sorted(value for value in inner if low < value < high), high]


def _pieces(
    vary: str, values: FloatArray, eq: Equilibria, rank: int, turns: Points | None, ends: tuple[float, float]
) -> list[Branch]:
    """Equilibria of one rank between two cuts, split by stability; at a fold the piece is extended to the exact point."""
    there = np.flatnonzero(eq.count > rank)
    states = {name: getattr(eq, name)[there, rank] for name in _STATE}
    codes, along = eq.stability[there, rank], values[there]
    starts = np.flatnonzero(np.diff(codes, prepend=-1))
    pieces = []
    for start, stop in itertools.pairwise([*starts, codes.size]):
        # Where the stability changes within a branch, both pieces share a point, so that no gap shows.
        reach = slice(start, min(stop + 1, codes.size))
        shown = {name: state[reach] for name, state in states.items()}
        pieces.append(Branch(vary, along[reach], **shown, stability=Stability(int(codes[start]))))
    if turns is not None and pieces:
        pieces[0] = _to_fold(pieces[0], eq, 0, rank, turns, ends[0])
        pieces[-1] = _to_fold(pieces[-1], eq, -1, rank, turns, ends[1])
    return pieces


def _to_fold(piece: Branch, eq: Equilibria, at: int, rank: int, turns: Points, end: float) -> Branch:
    """The piece, extended to the fold at its first or last point if its equilibrium is one of the two that meet there."""
    (here,) = np.nonzero(getattr(turns, turns.vary[0]) == end)
    if not here.size or eq.count[at] < 2:
        return piece
    fold = int(here[0])
    pair = np.argsort(np.abs(eq.theta[at, : int(eq.count[at])] - turns.theta[fold]))[:2]
    if rank not in pair:
        return piece
    place = 0 if at == 0 else piece.values.size
    added = {name: np.insert(getattr(piece, name), place, getattr(turns, name)[fold]) for name in _STATE}
    return Branch(piece.vary, np.insert(piece.values, place, end), **added, stability=piece.stability)


@styled
def draw_branches(
    curves: Iterable[Branch],
    quantity: str = "x",
    *,
    ax: Axes | None = None,
    color: str = BLACK,
    **options: Any,
) -> list[Line2D]:
    """Draw branches: stable solid, divergent dashed, flutter dash-dotted; returns the lines."""
    ax = own_axes(ax)
    lines = []
    for curve in curves:
        style: dict[str, Any] = {"color": color, "linestyle": LINES[curve.stability]}
        lines += ax.plot(curve.shown(curve.vary), curve.shown(quantity), **(style | options))
    return lines


@styled
def mark_folds(
    turns: Points,
    quantity: str = "x",
    *,
    ax: Axes | None = None,
    low: float = -np.inf,
    high: float = np.inf,
    **options: Any,
) -> list[Line2D]:
    """Mark folds at their exact positions between ``low`` and ``high`` of the parameter that varies."""
    along = getattr(turns, turns.vary[0])
    inside = (low <= along) & (along <= high)
    x, y = along[inside], getattr(turns, quantity)[inside]
    x = np.degrees(x) if turns.vary[0] in _ANGLES else x
    y = np.degrees(y) if quantity in _ANGLES else y
    style: dict[str, Any] = {
        "linestyle": "none",
        "marker": "o",
        "markersize": 3.4,
        "color": BLACK,
        "zorder": 3,
    }
    return own_axes(ax).plot(x, y, **(style | options))


@only_for(Parameters, "draw_equilibria_of(model, p, vary, ends) draws the states")
def plot_equilibria(
    p: Parameters, quantity: str = "x", vary: str = "theta0", *,
    low: float | None = None, high: float | None = None,
    contact: bool = True, ax: Axes | None = None, color: str = BLACK, **options: Any,
) -> list[Line2D]:  # fmt: skip
    """All equilibrium curves as a parameter varies, folds marked.

    Parameters
    ----------
    p : Parameters
        Scalars; the parameter that varies is not used.
    quantity : {"x", "y", "theta", "L"}
        What to show; angles in degrees.
    vary : str
        The parameter along the horizontal axis.
    low, high : float, optional
        Its range.
    contact : bool
        Steady sliding, or lift-off.
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default pyplot's current axes.
    color : str
        Of lines and folds.
    **options
        For :meth:`matplotlib.axes.Axes.plot`.

    Returns
    -------
    list of matplotlib.lines.Line2D
        One for each piece of one stability, and the folds.

    Examples
    --------
    >>> import spragsym as ss
    >>> from spragsym.figures import plot_equilibria
    >>> from matplotlib.figure import Figure
    >>> len(plot_equilibria(ss.Parameters.article(), ax=Figure().add_subplot()))
    8
    """
    ax = own_axes(ax)
    name_axes(ax, vary, quantity)
    lines = draw_branches(branches(p, vary, low, high, contact=contact), quantity, ax=ax, color=color, **options)
    if contact:
        ends = [line.get_xdata() for line in lines]
        scale = np.radians if vary in _ANGLES else np.asarray
        reach = (
            float(scale(np.min([np.min(x) for x in ends]))),
            float(scale(np.max([np.max(x) for x in ends]))),
        )
        lines += mark_folds(folds(p, vary), quantity, ax=ax, low=reach[0], high=reach[1], color=color)
    return lines


def table_of(curves: Sequence[Branch], **same: float) -> Table:
    """Branches as columns, one after the other; ``same`` are columns of one value."""
    first = curves[0]
    columns: dict[str, Any] = {name: np.full(sum(c.values.size for c in curves), value) for name, value in same.items()}
    columns["branch"] = np.repeat(np.arange(len(curves)), [curve.values.size for curve in curves])
    columns["stability"] = np.repeat([c.stability.name.lower() for c in curves], [c.values.size for c in curves])
    for name in (first.vary, *_STATE):
        key = f"{name}_deg" if name in _ANGLES else name
        columns[key] = np.concatenate([curve.shown(name) for curve in curves])
    return columns


def joined(tables: Iterable[Table]) -> Table:
    """Tables of equal columns, one below the other."""
    tables = list(tables)
    return {name: np.concatenate([np.asarray(table[name]) for table in tables]) for name in tables[0]}


# ------------------------------------------------------------------------------------------------- paths


def passages(path: Path, quantity: str = "x") -> list[tuple[FloatArray, FloatArray]]:
    """The pieces of a quasi-static path between its jumps, from where it landed to the exact fold."""
    values, states = path.values, getattr(path, quantity)
    forward = -1.0 if values[0] > values[-1] else 1.0
    pieces, begin = [], 0
    head: tuple[list[float], list[float]] = ([], [])
    for jump in path.jumps:
        stop = int(np.searchsorted(forward * values, forward * jump.value, side="right"))
        before, after = jump.before[quantity], jump.after[quantity]
        pieces.append((
            np.concatenate([head[0], values[begin:stop], [jump.value]]),
            np.concatenate([head[1], states[begin:stop], [before]]),
        ))  # fmt: skip
        head, begin = ([jump.value], [after]), stop
    pieces.append((np.concatenate([head[0], values[begin:]]), np.concatenate([head[1], states[begin:]])))
    if path.vary in _ANGLES:
        pieces = [(np.degrees(value), state) for value, state in pieces]
    return pieces


@styled
def draw_path(
    path: Path,
    quantity: str = "x",
    *,
    ax: Axes | None = None,
    color: str = BLACK,
    arrows: Sequence[float] = (0.5,),
    **options: Any,
) -> list[Any]:
    """Draw a quasi-static path, its jumps dotted; arrow heads at some shares of every piece, and on jumps."""
    ax = own_axes(ax)
    name_axes(ax, path.vary, quantity)
    artists: list[Any] = []
    pieces = passages(path, quantity)
    style: dict[str, Any] = {"color": color, "linewidth": 1.1, "zorder": 2.2}
    for value, state in pieces:
        artists += ax.plot(value, state, **(style | options))
        artists += [_head(ax, *_around(value, state, share), color) for share in arrows]
    for (value, state), (_, landed) in itertools.pairwise(pieces):
        begin, end = (value[-1], state[-1]), (value[-1], landed[0])
        artists += ax.plot(*zip(begin, end, strict=True), color=color, linewidth=1.1, linestyle=":")
        artists.append(_head(ax, begin, end, color))
    return artists


def _around(x: FloatArray, y: FloatArray, share: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Two neighbouring points of a curve, at a share of its way along x."""
    sign = 1.0 if x[-1] > x[0] else -1.0
    i = int(np.clip(np.searchsorted(sign * x, sign * (x[0] + share * (x[-1] - x[0]))), 1, x.size - 1))
    return (x[i - 1], y[i - 1]), (x[i], y[i])


def _head(ax: Axes, begin: tuple[float, float], end: tuple[float, float], color: str) -> Any:
    """An arrow head at ``end``, pointing away from ``begin``."""
    near = (end[0] + 1e-3 * (begin[0] - end[0]), end[1] + 1e-3 * (begin[1] - end[1]))
    props = {
        "arrowstyle": "-|>",
        "color": color,
        "shrinkA": 0,
        "shrinkB": 0,
        "mutation_scale": 9,
        "linewidth": 0.8,
    }
    return ax.annotate("", end, near, arrowprops=props)
