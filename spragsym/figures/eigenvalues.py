"""Frequencies and growth rates of small deviations from equilibria over a parameter: how modes couple, and where one grows."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from scipy.optimize import linear_sum_assignment

from ..errors import ConvergenceError
from ..models import Model
from ..models.parameters import FloatArray, ParameterSet
from ..numerics.interval_arrays import ComplexArray
from ..statics.stability import NEUTRAL
from .curves import along, chains_between, folds_between
from .labels import as_drawn, in_letters, label
from .style import BLACK, GREY, SINGLE, VERMILION, Sheet, Table, panels, stacked, styled


def plot_eigenvalues(
    p: ParameterSet, vary: str | None = None, *, low: float | None = None, high: float | None = None, contact: bool = True,
    axes: tuple[Axes, Axes] | None = None, n: int = 200,
) -> list[Line2D]:  # fmt: skip
    """Imaginary and real parts of the eigenvalues λ of all equilibria of any model as a parameter varies.

    Black by the full linearization, det(λ² M + λ C + K) = 0, and red where that λ grows by more than 1e-4 of its size; grey by
    (27), without dampers and the slope of the friction law.

    Parameters
    ----------
    p : Parameters
        Scalars; the parameter that varies is not used.
    vary, low, high, contact
        As for :func:`~spragsym.figures.branches`: the parameter along the horizontal axes.
    axes : tuple of two matplotlib.axes.Axes, optional
        For frequencies and for growth rates; by default two panels of pyplot's current figure.
    n : int
        Points between two folds or onsets, denser towards these.

    Returns
    -------
    list of matplotlib.lines.Line2D

    Raises
    ------
    ConvergenceError
        Where no equilibrium is found.

    Examples
    --------
    >>> import spragsym as ss
    >>> from matplotlib.figure import Figure
    >>> from spragsym.figures import plot_eigenvalues
    >>> p = ss.load("mode_coupling").Parameters()
    >>> len(plot_eigenvalues(p, "mu0", low=0.1, high=0.9, axes=Figure().subplots(2, 1), n=20)) > 0
    True
    """
    if axes is None:
        from matplotlib import pyplot

        axes = tuple(pyplot.gcf().subplots(2, 1, sharex=True))
    vary, ends = along(p.model, vary, low, high)
    return _drawn(axes, p.model, vary, ends, _courses(p, vary, ends, contact, n))


@styled
def eigenvalue_figure(
    p: ParameterSet, vary: str | None = None, *, low: float | None = None, high: float | None = None, contact: bool = True,
    n: int = 200,
) -> Sheet:  # fmt: skip
    """Frequencies above growth rates, as a figure; arguments as :func:`plot_eigenvalues`."""
    figure, axes = panels(2, 1, SINGLE, 4.2, sharex=True)
    vary, ends = along(p.model, vary, low, high)
    courses = _courses(p, vary, ends, contact, n)
    _drawn((axes[0, 0], axes[1, 0]), p.model, vary, ends, courses)
    tables = [_table(vary, courses, part) for part in ("imag", "real")]
    return figure.describe(
        f"""Eigenvalues λ of {p.model.name} at its equilibria over {vary}: (a) frequencies, (b) growth rates. Black with all
        damping, red where λ grows by more than 1e-4 of its size; grey by (27), without dampers and the slope of the friction
        law.""",
        a=tables[0], b=tables[1],
    )  # fmt: skip


#: Of each curve the values of the parameter, and at each all λ with damping and without, each of them in one column.
_Courses = list[tuple[FloatArray, ComplexArray, ComplexArray]]


def _courses(p: ParameterSet, vary: str, ends: tuple[float, float], contact: bool, n: int) -> _Courses:
    turns, found = folds_between(p, vary, *ends) if contact else None, list[Any]()
    for eq, at, _ in chains_between(p, vary, ends, turns, False, n):
        values = np.asarray(getattr(eq.parameters, vary))[at[0]]
        found.append((values, *(_followed(values, every[at]) for every in (eq.damped_eigenvalues, eq.eigenvalues))))
    if not found:
        where = "in contact" if contact else "in lift-off"
        raise ConvergenceError(f"no equilibrium {where} was found with {vary} from {ends[0]:g} to {ends[1]:g}: nothing to draw")
    return found


def _followed(values: FloatArray, every: ComplexArray) -> ComplexArray:
    """Rows of λ in such an order that each column goes on straight from the two rows before."""
    out = every.copy()
    for row in range(1, len(out)):
        ahead = out[row - 1]
        if row > 1:
            ahead = ahead + (ahead - out[row - 2]) * (values[row] - values[row - 1]) / (values[row - 1] - values[row - 2])
        off = np.abs(ahead[:, None] - every[row])
        if np.isfinite(off).all():
            out[row] = every[row, linear_sum_assignment(off)[1]]
    return out


def _drawn(
    axes: tuple[Axes, Axes], model: Model, vary: str, ends: tuple[float, float], courses: _Courses
) -> list[Line2D]:  # fmt: skip
    lines: list[Line2D] = []
    for values, damped, undamped in courses:
        across = as_drawn(model, vary, values)
        grows = damped.real > NEUTRAL * np.abs(damped)
        below, above = (np.where(undamped.imag >= 0, part, np.nan) for part in (undamped.imag, undamped.real))
        for ax, plain, part in zip(axes, (below, above), (damped.imag, damped.real), strict=True):
            lines += ax.plot(across, plain, color=GREY, linewidth=0.7)
            part = np.where(damped.imag >= 0, part, np.nan)
            lines += ax.plot(across, part, color=BLACK, linewidth=1.1)
            lines += ax.plot(across, np.where(grows, part, np.nan), color=VERMILION, linewidth=1.5)
    rate = in_letters(model.about["scales"]["rate"])
    for ax, text in zip(axes, (r"frequency Im $\lambda$", r"growth Re $\lambda$"), strict=True):
        ax.set_ylabel(f"{text} (units of ${rate}$)")
        ax.set_xlim(*as_drawn(model, vary, np.array(ends)))
    axes[0].set_ylim(bottom=max(0.0, axes[0].get_ylim()[0]))
    axes[1].axhline(0.0, color=BLACK, linewidth=0.4)
    axes[1].set_xlabel(label(model, vary))
    return lines


def _table(vary: str, courses: _Courses, part: str) -> Table:
    """Columns of all curves, one after the other: of each λ with damping, then of each without."""
    return stacked([
        {vary: values} | {
            f"{name}_{i + 1}": column
            for name, every in (("damped", damped), ("undamped", undamped)) for i, column in enumerate(getattr(every, part).T)
        }
        for values, damped, undamped in courses
    ], "curve")  # fmt: skip
