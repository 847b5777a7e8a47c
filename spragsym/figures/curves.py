"""Curves of equilibria over a parameter, drawn by stability; quasi-static paths; eigenvalues over a
parameter.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.text import Annotation
from scipy.optimize import linear_sum_assignment

import spragsym as ss

from ..bifurcation.borders import reachable
from ..bifurcation.branches import linked, undecided_parts, undecided_points
from ..bifurcation.defining_systems import ranges
from ..core.errors import ConvergenceError, SpragsymError, one_of, require_kind
from ..core.questions import model_of
from ..models import Model
from ..models.forces import columns_of
from ..models.model import Touching
from ..models.parameters import FINITE, FloatArray, ParameterSet, Ranges, Span, varied_range
from ..numerics.columns import selected_rows
from ..numerics.interval_arrays import ComplexArray, IntArray, joined
from ..results import Equilibria, EquilibriumType, Named, Path, Points
from ..statics.search import balances_of
from ..statics.stability import NEUTRAL_GROWTH, REAL
from .style import (
    BLACK,
    GREY,
    LINES,
    SINGLE,
    VERMILION,
    Sheet,
    Table,
    denser_at_ends,
    in_letters,
    label,
    once,
    own_axes,
    own_unit,
    panels,
    places,
    runs,
    stacked,
    styled,
    window,
)

#: Names of axes in the article's figures.
LABELS = {"x": r"$x_{\mathrm{eq}}$", "y": r"$y_{\mathrm{eq}}$"}


#: Equilibria by their indices into the columns.
States: TypeAlias = tuple[IntArray, ...]


@dataclass(frozen=True, eq=False)
class Branch(Named):
    """A part of an equilibrium curve with states of one type; angles in radians.

    ``values`` are those of the parameter. ``states`` are the columns of
    :class:`spragsym.results.Equilibria` that describe the positions, by name; each is also an
    attribute.
    """

    schema = Path.schema
    _held = "states"

    model: Model
    vary: str
    values: FloatArray
    states: Mapping[str, FloatArray]
    kind: EquilibriumType

    def shown(self, name: str) -> FloatArray:
        """A column, or the parameter, in the unit of an axis: angles in degrees."""
        values = self.values if name == self.vary else self.states[name]
        return self.model.column(name).size * values


class Branches(list[Branch]):
    """List of curves of equilibria, with the ranges of the parameter in which some may be missing.

    Attributes
    ----------
    model : Model
    vary : str
        The parameter.
    undecided : ndarray
        Ranges (n, 2) in which a point or a fold is undecided.
    """

    def __init__(
        self, curves: Iterable[Branch], model: Model, vary: str, undecided: FloatArray
    ) -> None:
        super().__init__(curves)
        self.model, self.vary, self.undecided = model, vary, undecided


def name_axes(ax: Axes, model: Model, vary: str, quantity: str) -> None:
    """Label the axes, unless they have labels."""
    for axis, name in ((ax.xaxis, vary), (ax.yaxis, quantity)):
        if not axis.get_label_text():
            axis.set_label_text(label(model.column(name), own_unit(model, model.column(name))))


def branches(
    p: ParameterSet,
    vary: str | None = None,
    *,
    between: Ranges | None = None,
    contact: bool = True,
    damping: bool = False,
    n: int = 200,
) -> Branches:
    """All equilibrium curves of any model over one parameter, cut at folds and at changes of
    stability.

    Parameters
    ----------
    p : Parameters
        Scalars; the parameter that varies is not used.
    vary : str, optional
        Its name, by default theta0 if the model has it.
    between : mapping, optional
        Its range, by its name; by default its own, which if unbounded ends at 1, or at twice the
        base value if that is larger.
    contact : bool
        Steady sliding, with several contacts in every combination of touching ones; or lift-off.
    damping : bool
        Types of equilibria with dampers and the slope of the friction law; or without, by (27).
    n : int
        Number of points of each piece, denser at its ends.

    Notes
    -----
    Folds and onsets of flutter are computed first. Between these, equilibria are computed at each
    point, and connected by tubes, see :func:`spragsym.bifurcation.branches.linked`. A curve that
    leaves the contact ends at the last point in contact. Ranges in which a point is undecided, or a
    fold may be missing, are in ``undecided`` of the result.
    """
    return curves_between(p, *_range(p, vary, between, contact), damping, n)


def curves_between(
    p: ParameterSet, vary: str, ends: Span, turns: Points | None, damping: bool, n: int
) -> Branches:
    """The curves of :func:`branches` with known folds ``turns`` between the ends; None for
    lift-off.

    A curve between two cuts is split by stability, and extended to the exact point of a fold.
    """
    pieces, undecided = _pieces(p, vary, ends, turns, damping, n)
    curves = [curve for piece in pieces for curve in _by_stability(vary, piece, damping)]
    return Branches(curves, p.model, vary, undecided)


@dataclass(frozen=True, eq=False)
class _Chain:
    """A curve between two cuts.

    ``at`` are the indices of its states in the columns of ``eq``, and ``turns`` the folds and
    border points of states of the same combination of contacts; None for lift-off.
    """

    eq: Equilibria
    at: States
    cuts: Span
    turns: Points | None


def _pieces(
    p: ParameterSet, vary: str, ends: Span, turns: Points | None, damping: bool, n: int
) -> tuple[list[_Chain], FloatArray]:
    """All curves between cuts (folds, borders, onsets of flutter) for every combination of touching
    contacts, and the ranges in which something is undecided.
    """
    combinations: list[tuple[Touching, Points | None]] = [(False, None)]
    onsets = list[float]()
    if turns is not None:
        combinations = [
            (one.contact, turns.select(reachable(turns, one))) for one in balances_of(p.model)
        ]
        with suppress(SpragsymError):
            onsets = ss.flutter_onsets(p, vary, damping=damping)[vary].tolist()
    found, spans = list[_Chain](), [undecided_parts(turns, ends)]
    for contact, own in combinations:
        inner = {*onsets, *([] if own is None else own[vary].tolist())}
        stops = sorted(value for value in inner if ends[0] < value < ends[1])
        for cuts in itertools.pairwise([ends[0], *stops, ends[1]]):
            values = denser_at_ends(*cuts, 1e-4, n)
            eq = ss.equilibria(p.replace(**{vary: values}), contact=contact)
            spans.append(undecided_points(eq, vary, cuts))
            found += [_Chain(eq, at, cuts, own) for at in chains(p, vary, eq, own)]
    return found, joined(np.concatenate(spans))


def _by_stability(vary: str, piece: _Chain, damping: bool) -> Iterator[Branch]:
    """The parts of a curve with constant stability, extended to the exact folds."""
    eq, at, turns = piece.eq, piece.at, piece.turns
    columns = {
        vary: eq.parameters[vary][at[0]],
        **{name: eq[name][at] for name in eq.state_columns},
    }
    kinds = eq.undamped[at]
    if damping:  # by (27) if the sign of the growth is not proved
        sign, fastest = eq.growth_sign[at], eq.damped_eigenvalues[at][:, 0]
        grows = np.where(
            np.abs(fastest.imag) <= REAL * np.abs(fastest),
            EquilibriumType.DIVERGENT,
            EquilibriumType.FLUTTER,
        )
        kinds = np.select([sign < 0, sign > 0], [EquilibriumType.STABLE, grows], kinds)
    for side, cut in zip((0, -1), piece.cuts, strict=True):
        folds = [] if turns is None else np.flatnonzero(turns[vary] == cut).tolist()
        if turns is None or not folds or at[0][side] != range(eq.count.size)[side]:
            continue
        # At a fold two states meet; at a border one arrives.
        meeting = 1 if turns.kind[folds[0]] in ("passes", "border_fold") else 2
        fold, count = {name: turns[name][folds[0]] for name in columns}, eq.count[side]
        away = [values[side, :count] - fold[name] for name, values in eq.coordinates.items()]
        if count >= meeting and at[1][side] in np.argsort(np.hypot.reduce(away))[:meeting]:
            index = side % (kinds.size + 1)
            kinds = np.insert(kinds, index, kinds[side])
            columns = {
                name: np.insert(column, index, fold[name]) for name, column in columns.items()
            }
    for part in runs(kinds):
        states = selected_rows(columns, part)
        values = states.pop(vary)
        yield Branch(eq.parameters.model, vary, values, states, EquilibriumType(kinds[part][0]))


def chains(p: ParameterSet, vary: str, eq: Equilibria, turns: Points | None) -> list[States]:
    """The states of each curve, as indices into the columns of ``eq``."""
    found, ends = list[list[tuple[int, int]]](), dict[int, list[tuple[int, int]]]()
    # With few halvings some links are not proved; a curve is then drawn as two.
    options = ss.ContinuationOptions(halvings=3)
    for index, pairs in enumerate([{}, *linked(p, vary, eq, turns, options=options)]):
        before = {other: ends[one] for one, other in pairs.items()}
        ends = {slot: before.get(slot, []) for slot in range(eq.count[index])}
        for slot, chain in ends.items():
            if not chain:  # a curve begins here
                found.append(chain)
            chain.append((index, slot))
    return [(index, slot) for index, slot in map(np.transpose, found)]


def _range(
    p: ParameterSet, vary: str | None, between: Ranges | None, contact: bool
) -> tuple[str, Span, Points | None]:
    """The parameter that varies, its range as given or by default, and the folds in it; None for
    lift-off.
    """
    model = model_of(p)
    vary = model.one(vary)
    model.require_parameter(vary)
    if between:
        low, high = ranges(p, (vary,), between)[0].tolist()
    else:
        inset = 1e-4 if p.ranges[vary].open_low else 0.0
        low, high = window(p, (vary,), {})[vary]
        low, high = low + inset, high - inset
    return vary, (low, high), ss.folds(p, vary, between={vary: (low, high)}) if contact else None


@styled
def draw_branches(
    curves: Iterable[Branch],
    quantity: str = "x",
    *,
    ax: Axes | None = None,
    color: str = BLACK,
    **options: Any,
) -> list[Line2D]:
    """Draw branches: stable solid, divergent dashed, flutter dash-dotted; returns the lines.

    Undecided ranges of a result of :func:`branches` are hatched.
    """
    ax = own_axes(ax)
    lines = []
    if isinstance(curves, Branches):
        shade(ax, curves.model, curves.vary, curves.undecided)
    for curve in curves:
        named = {"label": once(ax, curve.kind.name.lower())}
        style = {"color": color, "linestyle": LINES[curve.kind], **named, **options}
        lines += ax.plot(curve.shown(curve.vary), curve.shown(quantity), **style)
    return lines


def shade(ax: Axes, model: Model, vary: str, spans: FloatArray) -> None:
    """Hatch undecided ranges of a parameter, including those of a single value."""
    for low, high in (model.column(vary).size * spans).tolist():
        ax.axvspan(
            low,
            high,
            facecolor="none",
            edgecolor=GREY,
            hatch="////",
            linewidth=0.8,
            zorder=0,
            label=once(ax, "undecided"),
        )


@styled
def mark_folds(
    turns: Points,
    quantity: str = "x",
    *,
    ax: Axes | None = None,
    between: Ranges | None = None,
    **options: Any,
) -> list[Line2D]:
    """Mark folds at their exact positions, if given only those in a range of the parameter."""
    require_kind("turns", turns, Points, "an answer of ss.folds(...)")
    vary = turns.vary[0]
    if between:
        turns = turns.between(np.array([varied_range(vary, between, FINITE)]))
    ax, kinds = own_axes(ax), dict.fromkeys(turns["kind"].tolist())
    style = {
        "linestyle": "none",
        "marker": "o",
        "markersize": 3.4,
        "color": BLACK,
        "zorder": 3,
        "label": once(ax, ", ".join(kinds) or "points"),
        **options,
    }
    return ax.plot(*places(turns.parameters.model, (vary, quantity), turns), **style)


def plot_equilibria(
    p: ParameterSet,
    vary: str | None = None,
    quantity: str | None = None,
    *,
    between: Ranges | None = None,
    contact: bool = True,
    damping: bool = False,
    ax: Axes | None = None,
    color: str = BLACK,
    n: int = 200,
    **options: Any,
) -> list[Line2D]:
    """Plot all equilibrium curves of any model over a parameter, with folds marked.

    Ranges in which a point is undecided, or a fold may be missing, are hatched.

    Parameters
    ----------
    p : Parameters
        Scalars; the parameter that varies is not used.
    vary : str, optional
        As for :func:`branches`: the parameter along the horizontal axis.
    quantity : str, optional
        Along the vertical axis: a column of :class:`spragsym.results.Equilibria` that describes
        positions, as x or theta; by default the first coordinate. Angles are in degrees.
    between, contact, damping, n
        As for :func:`branches`.
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default pyplot's current axes.
    color : str
        Colour of lines and folds.
    **options
        For :meth:`matplotlib.axes.Axes.plot`.

    Returns
    -------
    list of matplotlib.lines.Line2D
        One for each part with constant stability, and the folds.

    Examples
    --------
    >>> import spragsym as ss
    >>> from spragsym.figures import plot_equilibria
    >>> from matplotlib.figure import Figure
    >>> len(plot_equilibria(ss.Parameters.article(), ax=Figure().add_subplot()))
    8
    >>> p = ss.load("cubic_contact").Parameters()
    >>> len(plot_equilibria(p, quantity="theta", ax=Figure().add_subplot(), n=20))
    8
    """
    vary, ends, turns = _range(p, vary, between, contact)
    ax, model = own_axes(ax), p.model
    quantity = quantity or model.coordinates[0]
    one_of("quantity", quantity, columns_of(model))
    name_axes(ax, model, vary, quantity)
    lines = draw_branches(
        curves_between(p, vary, ends, turns, damping, n), quantity, ax=ax, color=color, **options
    )
    if turns is not None:
        lines += mark_folds(turns, quantity, ax=ax, color=color)
    return lines


def table_of(curves: Iterable[Branch]) -> Table:
    """Branches as a table, concatenated."""
    tables = list[Table]()
    for curve in curves:
        names = (curve.vary, *curve.states)
        columns = {curve.model.column(name).heading: curve.shown(name) for name in names}
        tables.append({"kind": curve.kind.name.lower(), **columns})
    return stacked(tables, "branch")


def first_fold(p: ParameterSet) -> float:
    """The smallest θ₀ of a fold, in degrees."""
    return float(np.degrees(ss.folds(p).theta0[0]))


# ------------------------------------------------------------------------------------------------
# paths


def path_pieces(path: Path, quantity: str = "x") -> list[tuple[FloatArray, FloatArray]]:
    """The pieces of a quasi-static path between jumps, each up to the exact fold: values of the
    parameter and of the quantity in the units of the axes.
    """
    values, model = path.values, path.parameters.model
    forward = -1.0 if values[0] > values[-1] else 1.0
    ends = [
        (jump.value, end[quantity])
        for jump in path.jumps
        if jump.after  # not at infinity
        for end in (jump.before, jump.after)
    ]
    jumps = np.array(ends).reshape(-1, 2)
    stops = np.searchsorted(forward * values, forward * jumps[:, 0], side="right")
    whole = np.insert(np.stack([values, path[quantity]], axis=1), stops, jumps, axis=0)
    sizes = [model.column(name).size for name in (path.vary, quantity)]
    pieces = np.split(whole * sizes, stops[::2] + np.arange(1, stops.size, 2))
    return [(piece[:, 0], piece[:, 1]) for piece in pieces]


@styled
def draw_path(
    path: Path,
    quantity: str | None = None,
    *,
    ax: Axes | None = None,
    color: str = BLACK,
    arrows: Sequence[float] = (0.5,),
    **options: Any,
) -> list[Any]:
    """Draw a quasi-static path, with jumps dotted; returns the artists.

    Jumps have arrow heads at their ends, pieces between jumps at ``arrows``, shares of their
    extent.
    """
    require_kind("path", path, Path, "one of ss.quasi_static_path(...)")
    ax, quantity = own_axes(ax), quantity or path.parameters.model.coordinates[0]
    name_axes(ax, path.parameters.model, path.vary, quantity)
    artists: list[Any] = []
    pieces = path_pieces(path, quantity)
    style = {"color": color, "linewidth": 1.1, "zorder": 2.2, **options}
    for value, state in pieces:
        artists += ax.plot(value, state, **{"label": once(ax, "state"), **style})
        artists += [_head(ax, value, state, share, color) for share in arrows]
    for (value, state), (_, landed) in itertools.pairwise(pieces):
        jump = value[[-1, -1]], np.array([state[-1], landed[0]])
        name = once(ax, "jump")
        artists += ax.plot(*jump, color=color, linewidth=1.1, linestyle=":", label=name)
        artists.append(_head(ax, *jump, 1.0, color))
    return artists


def _head(ax: Axes, x: FloatArray, y: FloatArray, share: float, color: str) -> Annotation:
    """Draw an arrow head on a curve, at a share of its extent along x."""
    distance = np.abs(x - x[0])
    i = np.clip(np.searchsorted(distance, share * distance[-1]), 1, x.size - 1)
    before, at = np.stack([x, y], axis=1)[i - 1 : i + 1]
    arrow = {
        "arrowstyle": "-|>",
        "color": color,
        "shrinkA": 0,
        "shrinkB": 0,
        "mutation_scale": 9,
        "linewidth": 0.8,
    }
    return ax.annotate("", at, at + 1e-3 * (before - at), arrowprops=arrow)


def plot_eigenvalues(
    p: ParameterSet,
    vary: str | None = None,
    *,
    between: Ranges | None = None,
    contact: bool = True,
    axes: tuple[Axes, Axes] | None = None,
    n: int = 200,
) -> list[Line2D]:
    """Plot imaginary and real parts of the eigenvalues λ of all equilibria of any model over a
    parameter.

    Black: the full linearization, det(λ² M + λ C + K) = 0; red if Re λ > 1e-4 |λ|. Grey: by (27),
    without dampers and the slope of the friction law.

    Parameters
    ----------
    p : Parameters
        Scalars; the parameter that varies is not used.
    vary, between, contact
        As for :func:`~spragsym.figures.branches`: the parameter along the horizontal axes.
    axes : tuple of two matplotlib.axes.Axes, optional
        Axes for frequencies and for growth rates; by default two panels of pyplot's current figure.
    n : int
        Number of points between two folds or onsets, denser near these.

    Returns
    -------
    list of matplotlib.lines.Line2D

    Raises
    ------
    ConvergenceError
        If no equilibrium is found.

    Examples
    --------
    >>> import spragsym as ss
    >>> from matplotlib.figure import Figure
    >>> from spragsym.figures import plot_eigenvalues
    >>> p = ss.load("mode_coupling").Parameters()
    >>> len(plot_eigenvalues(
    ...     p, "mu0", between={"mu0": (0.1, 0.9)}, axes=Figure().subplots(2, 1), n=20
    ... )) > 0
    True
    """
    if axes is None:
        from matplotlib import pyplot

        axes = tuple(pyplot.gcf().subplots(2, 1, sharex=True))
    return _drawn(axes, p, vary, between, contact, n)[0]


@styled
def eigenvalue_figure(
    p: ParameterSet,
    vary: str | None = None,
    *,
    between: Ranges | None = None,
    contact: bool = True,
    n: int = 200,
) -> Sheet:
    """:func:`plot_eigenvalues` as a figure, frequencies above growth rates; same arguments."""
    figure, axes = panels(2, 1, SINGLE, 4.2, sharex=True)
    vary = model_of(p).one(vary)
    _, frequencies, rates = _drawn([*axes[:, 0]], p, vary, between, contact, n)
    return figure.describe(
        f"""Eigenvalues λ of {p.model.name} at its equilibria over {vary}: (a) frequencies, (b)
        growth rates. Black with all damping, red where λ grows by more than 1e-4 of its size; grey
        by (27), without dampers and the slope of the friction law.""",
        a=frequencies,
        b=rates,
    )


def _followed(values: FloatArray, every: ComplexArray) -> ComplexArray:
    """Eigenvalues (values, n) with each row sorted so that columns are continuous.

    The order is the assignment that is closest to a linear extrapolation of the two rows before.
    """
    out = every.copy()
    for row in range(1, len(out)):
        predicted = out[row - 1]
        if row > 1:
            predicted = predicted + (predicted - out[row - 2]) * (values[row] - values[row - 1]) / (
                values[row - 1] - values[row - 2]
            )
        distances = np.abs(predicted[:, None] - every[row])
        if np.isfinite(distances).all():
            out[row] = every[row, linear_sum_assignment(distances)[1]]
    return out


def _drawn(
    axes: Sequence[Axes],
    p: ParameterSet,
    vary: str | None,
    between: Ranges | None,
    contact: bool,
    n: int,
) -> tuple[list[Line2D], Table, Table]:
    """Draw eigenvalues; returns the lines, and tables of frequencies and of growth rates, with
    damping and without.
    """
    vary, ends, turns = _range(p, vary, between, contact)
    model, lines, tables = p.model, list[Line2D](), list[Table]()
    hidden = complex(np.nan, np.nan)
    pieces, undecided = _pieces(p, vary, ends, turns, False, n)
    size = model.column(vary).size
    for piece in pieces:
        values = piece.eq.parameters[vary][piece.at[0]]
        damped = _followed(values, piece.eq.damped_eigenvalues[piece.at])
        undamped = _followed(values, piece.eq.eigenvalues[piece.at])
        growing = np.where(damped.real > NEUTRAL_GROWTH * np.abs(damped), damped, hidden)
        for roots, color, width in (
            (undamped, GREY, 0.7),
            (damped, BLACK, 1.1),
            (growing, VERMILION, 1.5),
        ):
            upper = np.where(roots.imag >= 0, roots, hidden)
            lines += axes[0].plot(size * values, upper.imag, color=color, linewidth=width)
            lines += axes[1].plot(size * values, upper.real, color=color, linewidth=width)
        tables.append(
            {vary: values}
            | {f"damped_{i}": column for i, column in enumerate(damped.T, 1)}
            | {f"undamped_{i}": column for i, column in enumerate(undamped.T, 1)}
        )
    if not lines:
        raise ConvergenceError(
            f"no equilibrium in {'contact' if contact else 'lift-off'} was found with {vary} from "
            f"{ends[0]:g} to {ends[1]:g}: nothing to draw"
        )
    rate = in_letters(model.about["scales"]["rate"])
    for ax, text in zip(axes, (r"frequency Im $\lambda$", r"growth Re $\lambda$"), strict=True):
        ax.set_ylabel(f"{text} (units of ${rate}$)")
        shade(ax, model, vary, undecided)
        ax.set_xlim(*size * np.array(ends))
    axes[0].set_ylim(bottom=max(0.0, axes[0].get_ylim()[0]))
    axes[1].axhline(0.0, color=BLACK, linewidth=0.4)
    axes[1].set_xlabel(label(model.column(vary)))
    columns = stacked(tables, "curve")
    frequencies, rates = (
        {
            name: getattr(column, part) if "damped_" in name else column
            for name, column in columns.items()
        }
        for part in ("imag", "real")
    )
    return lines, frequencies, rates
