"""Equilibrium curves: computed branch by branch, cut where a branch ends, drawn by stability."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

import spragsym as ss

from ..bifurcation.branches import linked
from ..errors import ParameterError, SpragsymError
from ..models import Model
from ..models.forces import columns_of
from ..models.parameters import FloatArray, ParameterSet
from ..results.equilibria import Equilibria, Stability
from ..results.named_columns import Columns
from ..results.paths import Path
from ..results.points import Points
from ..statics.stability import REAL
from .labels import as_drawn, window, with_unit
from .style import BLACK, LINES, Table, own_axes, stacked, styled

#: Names of axes in the article's figures.
LABELS = {"x": r"$x_{\mathrm{eq}}$", "y": r"$y_{\mathrm{eq}}$", "theta": r"$\theta$ (deg)", "L": r"$L$"}


@dataclass(frozen=True)
class Branch(Columns, held_in="states"):
    """A piece of an equilibrium curve of one stability, from end to end; angles in radians.

    ``states`` are the columns of :class:`spragsym.Equilibria` that say where a state is, by name, each an attribute too.
    """

    model: Model
    vary: str
    values: FloatArray
    states: Mapping[str, FloatArray]
    stability: Stability

    def shown(self, name: str) -> FloatArray:
        """A column or the parameter as an axis shows it: angles in degrees."""
        value: FloatArray = as_drawn(self.model, name, self.values if name == self.vary else self.states[name])
        return value


def name_axes(ax: Axes, model: Model, vary: str, quantity: str) -> None:
    """Label axes that have no label yet."""
    if not ax.get_xlabel():
        ax.set_xlabel(with_unit(model, vary))
    if not ax.get_ylabel():
        ax.set_ylabel(with_unit(model, quantity))


def branches(
    p: ParameterSet, vary: str | None = None, low: float | None = None, high: float | None = None, *,
    contact: bool = True, damping: bool = False, n: int = 200,
) -> list[Branch]:  # fmt: skip
    """All equilibrium curves of any model as one parameter varies, cut at folds, and where their stability changes.

    Parameters
    ----------
    p : Parameters
        Scalars; the parameter that varies is not used.
    vary : str, optional
        Its name; theta0 where there is one.
    low, high : float, optional
        Its range; by default its own, and for one without an end up to 1, or twice the base value if that is more.
    contact : bool
        Steady sliding, or lift-off.
    damping : bool
        Stability with dampers and the slope of the friction law, or by (27), without them.
    n : int
        Points of each piece, denser towards its ends.

    Notes
    -----
    Folds and onsets are solved for; between them equilibria are solved for at each point, and belong together where a tube joins
    them, see :func:`spragsym.bifurcation.branches.linked`. Where a curve leaves the contact it ends at the last of these
    points.
    """
    model = p.model
    vary = model.axes[0] if vary is None else vary
    low, high = range_of(model, vary, low, high)
    return curves_between(p, vary, (low, high), folds_between(p, vary, low, high) if contact else None, damping, n)


def curves_between(
    p: ParameterSet, vary: str, ends: tuple[float, float], turns: Points | None, damping: bool, n: int
) -> list[Branch]:  # fmt: skip
    """The curves of :func:`branches` where the folds, at least those between the ends, are known; in lift-off without folds."""
    found: list[Branch] = []
    for eq, chain, between in chains_between(p, vary, ends, turns, damping, n):
        found += _pieces(p.model, vary, eq, chain, turns, between, damping)
    return found


def chains_between(
    p: ParameterSet, vary: str, ends: tuple[float, float], turns: Points | None, damping: bool, n: int
) -> Iterator[tuple[Equilibria, tuple[int, list[int]], tuple[float, float]]]:  # fmt: skip
    """Equilibria between two cuts, where one curve begins among them and its slots from there on, and the two cuts."""
    for begin, end in itertools.pairwise(_cuts(p, vary, *ends, turns, damping)):
        # 1 - cos gathers points where a curve turns back like a square root.
        share = 0.5 - 0.5 * np.cos(np.pi * np.linspace(1e-4, 1 - 1e-4, n))
        eq = ss.equilibria(p.replace(**{vary: begin + (end - begin) * share}), contact=turns is not None)
        for chain in _chains(eq, linked(p, vary, eq, turns)):
            yield eq, chain, (begin, end)


def range_of(model: Model, vary: str, low: float | None, high: float | None) -> tuple[float, float]:
    """Ends that are given, or those that are shown."""
    model.require_parameter(vary)
    allowed = model.Parameters.ranges[vary]
    ends = window(model, (vary,), {})[vary]
    inset = 1e-4 if allowed.open_low else 0.0
    low, high = ends[0] + inset if low is None else low, ends[1] - inset if high is None else high
    if not allowed.low <= low < high <= allowed.high:
        raise ParameterError(f"low = {low:g}, high = {high:g}: {vary} is in {allowed}; give a range in it, the smaller end first")
    return low, high


def folds_between(p: ParameterSet, vary: str, low: float, high: float) -> Points:
    """Folds along a parameter in a range."""
    return ss.folds(p, vary, between={vary: (low, high)})


def _cuts(p: ParameterSet, vary: str, low: float, high: float, turns: Points | None, damping: bool) -> list[float]:
    """The ends of the range, and between them the folds and the onsets of flutter, as far as these are known."""
    inner: list[float] = []
    if turns is not None:
        inner += getattr(turns, vary).tolist()
        with suppress(SpragsymError):
            inner += getattr(ss.flutter_onsets(p, vary, damping=damping), vary).tolist()
    return [low, *sorted({value for value in inner if low < value < high}), high]


def _chains(eq: Equilibria, pairs: Sequence[Mapping[int, int]]) -> list[tuple[int, list[int]]]:
    """Curves as the place at which each begins, and its slots from there on."""
    done: list[tuple[int, list[int]]] = []
    open_: dict[int, tuple[int, list[int]]] = {}
    for place, count in enumerate(eq.count.tolist()):
        ahead = {} if place == 0 else {pairs[place - 1][slot]: chain for slot, chain in open_.items() if slot in pairs[place - 1]}
        for slot in range(count):
            ahead.setdefault(slot, (place, []))[1].append(slot)
            done += [ahead[slot]] if len(ahead[slot][1]) == 1 else []
        open_ = ahead
    return done


def _pieces(
    model: Model, vary: str, eq: Equilibria, chain: tuple[int, list[int]], turns: Points | None, ends: tuple[float, float],
    damping: bool,
) -> list[Branch]:  # fmt: skip
    """A curve between two cuts, split by stability; at a fold it is extended to the exact point."""
    first, slots = chain
    at = np.arange(first, first + len(slots)), np.array(slots)
    states = {name: getattr(eq, name)[at] for name in eq.columns}
    values = np.asarray(getattr(eq.parameters, vary))[at[0]]
    kinds = list(map(Stability, eq.stability[at]))
    if damping:  # where the sign of the growth is not proved, the type by (27) stays
        sign, fastest = eq.growth_sign[at], eq.damped_eigenvalues[at][:, 0]
        grows = np.where(np.abs(fastest.imag) <= REAL * np.abs(fastest), Stability.DIVERGENT, Stability.FLUTTER)
        kinds = [Stability(code) for code in np.select([sign < 0, sign > 0], [Stability.STABLE, grows], eq.stability[at])]
    starts = [place for place, kind in enumerate(kinds) if place == 0 or kind != kinds[place - 1]]
    pieces = []
    for start, stop in itertools.pairwise([*starts, len(kinds)]):
        # Where the stability changes within a branch, both pieces share a point, so that no gap shows.
        reach = slice(start, min(stop + 1, len(kinds)))
        pieces.append(Branch(model, vary, values[reach], {name: state[reach] for name, state in states.items()}, kinds[start]))
    if turns is not None and first == 0:
        pieces[0] = _to_fold(pieces[0], eq, 0, slots[0], turns, ends[0])
    if turns is not None and first + len(slots) == eq.count.size:
        pieces[-1] = _to_fold(pieces[-1], eq, -1, slots[-1], turns, ends[1])
    return pieces


def _to_fold(piece: Branch, eq: Equilibria, at: int, slot: int, turns: Points, end: float) -> Branch:
    """The piece, extended to the fold at its first or last point if its equilibrium is one of the two that meet there."""
    (here,) = np.nonzero(getattr(turns, turns.vary[0]) == end)
    if not here.size or eq.count[at] < 2:
        return piece
    fold = int(here[0])
    away = [values[at, : int(eq.count[at])] - turns.coordinates[name][fold] for name, values in eq.coordinates.items()]
    if slot not in np.argsort(np.hypot.reduce(away))[:2]:
        return piece
    place = 0 if at == 0 else piece.values.size
    states = {name: np.insert(state, place, getattr(turns, name)[fold]) for name, state in piece.states.items()}
    return replace(piece, values=np.insert(piece.values, place, end), states=states)


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
    model = turns.parameters.model
    x, y = as_drawn(model, turns.vary[0], along[inside]), as_drawn(model, quantity, getattr(turns, quantity)[inside])
    style: dict[str, Any] = {
        "linestyle": "none",
        "marker": "o",
        "markersize": 3.4,
        "color": BLACK,
        "zorder": 3,
    }
    return own_axes(ax).plot(x, y, **(style | options))


def plot_equilibria(
    p: ParameterSet, quantity: str | None = None, vary: str | None = None, *,
    low: float | None = None, high: float | None = None, contact: bool = True, damping: bool = False,
    ax: Axes | None = None, color: str = BLACK, n: int = 200, **options: Any,
) -> list[Line2D]:  # fmt: skip
    """All equilibrium curves of any model as a parameter varies, folds marked.

    Parameters
    ----------
    p : Parameters
        Scalars; the parameter that varies is not used.
    quantity : str, optional
        What to show, a column of :class:`spragsym.Equilibria` that says where a state is, as x or theta; angles in degrees. By
        default the first coordinate.
    vary, low, high, contact, damping, n
        As for :func:`branches`: the parameter along the horizontal axis.
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
    >>> len(plot_equilibria(ss.load("cubic_contact").Parameters(), "theta", ax=Figure().add_subplot(), n=20))
    8
    """
    ax = own_axes(ax)
    vary, quantity = vary or p.model.axes[0], quantity or p.model.coordinates[0]
    low, high = range_of(p.model, vary, low, high)
    if quantity not in columns_of(p.model):
        raise ParameterError(f"quantity = {quantity!r} is not one of {', '.join(columns_of(p.model))}")
    name_axes(ax, p.model, vary, quantity)
    turns = folds_between(p, vary, low, high) if contact else None
    lines = draw_branches(curves_between(p, vary, (low, high), turns, damping, n), quantity, ax=ax, color=color, **options)
    if turns is not None:
        lines += mark_folds(turns, quantity, ax=ax, low=low, high=high, color=color)
    return lines


def table_of(curves: Iterable[Branch], **same: float) -> Table:
    """Branches as columns, one after the other; ``same`` are columns of one value."""
    tables = []
    for curve in curves:
        titles = {name: f"{name}_deg" if curve.model.is_angle(name) else name for name in (curve.vary, *curve.states)}
        kind = np.full(curve.values.size, curve.stability.name.lower())
        tables.append({"stability": kind, **{title: curve.shown(name) for name, title in titles.items()}})
    columns = stacked(tables, "branch")
    return {**{name: np.full(np.size(columns["branch"]), value) for name, value in same.items()}, **columns}


# ------------------------------------------------------------------------------------------------- paths


def passages(path: Path, quantity: str = "x") -> list[tuple[FloatArray, FloatArray]]:
    """The pieces of a quasi-static path between its jumps, from where it landed to the exact fold, as axes show them."""
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
    model = path.parameters.model
    return [(as_drawn(model, path.vary, value), as_drawn(model, quantity, state)) for value, state in pieces]


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
    name_axes(ax, path.parameters.model, path.vary, quantity)
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
