"""Pictures of one brake: where it stands in the bifurcation set, its path as friction rises, and which tolerance matters."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

import spragsym as ss

from ..bifurcation.defining_systems import ranges
from ..errors import ConvergenceError
from ..models.parameters import ParameterSet
from .bifurcation_sets import draw_plane
from .curves import curves_between, draw_branches, draw_path, folds_between, mark_folds
from .labels import as_drawn, in_units, symbol, with_unit
from .style import BLACK, BLUE, GREY, SKY, VERMILION, own_axes, write_along

#: Friction up to which pictures go, at least, and up to which folds are looked for; of another quantity times its value.
_TOP, _FAR = 1.0, 3.0
#: By how much they go beyond what they show.
_MORE = 0.15


def draw_operating_point(
    p: ParameterSet, theta0: tuple[float, float], mu0: tuple[float, float], jump: float = float("nan"), ax: Axes | None = None, *,
    n: int = 60,
) -> Any:  # fmt: skip
    """The bifurcation set of any model over inclination and friction, the point where a brake works, its tolerances and its jump.

    Parameters
    ----------
    p : Parameters
        Scalars, with the friction that works.
    theta0, mu0 : (float, float)
        Ends of the tolerances, radians.
    jump : float
        Friction at which the followed state jumps at θ₀, NaN if it never does, or is not to be shown.
    ax : Axes, optional
    n : int
        Lines of either parameter on which a search looks for folds.

    Returns
    -------
    matplotlib line of the point
    """
    ax = own_axes(ax)
    top = max(_TOP, 1.15 * mu0[1], 1.15 * jump if jump < _FAR else 0.0)
    draw_plane(ax, p, (0.0, top), n)
    return mark_brake(ax, p, theta0, mu0, jump)


def mark_brake(
    ax: Axes, p: ParameterSet, theta0: tuple[float, float], mu0: tuple[float, float], jump: float = float("nan")
) -> Any:  # fmt: skip
    """A brake in the plane of θ₀ in degrees and μ₀: its point, the box of its tolerances, and where it jumps, if it does."""
    radians, friction = p.scalars("theta0", "mu0")
    angle = float(np.degrees(radians))
    low, high = np.degrees(theta0)
    ax.add_patch(Rectangle((low, mu0[0]), high - low, mu0[1] - mu0[0], facecolor=SKY, edgecolor=BLUE, linewidth=0.8, alpha=0.6,
                           zorder=3))  # fmt: skip
    (point,) = ax.plot([angle], [friction], "o", color=BLUE, markersize=4.5, zorder=5)
    if np.isfinite(jump):
        ax.plot([angle], [jump], marker="x", color=BLACK, markersize=5, zorder=5)
        ax.annotate(f"jump at {jump:.3f}", (angle, jump), (6, -2), textcoords="offset points", va="top")
    return point


def draw_rising(
    p: ParameterSet, ends: tuple[float, float], ax: Axes | None = None, *, vary: str = "mu0", begin: float = 0.0,
    length: float = 1.0, label: str | None = None, size: float = 1.0, across: str = r"friction $\mu$", n: int = 200,
) -> Any:  # fmt: skip
    """The states of any model over the loading parameter, the one followed as it does, and the range of its tolerance shaded.

    Parameters
    ----------
    p : Parameters
        Scalars, of which the one that rises is not used.
    ends : (float, float)
        Of the tolerance of the loading parameter.
    ax : Axes, optional
    vary : str
        The loading parameter.
    begin : float
        From where.
    length, size : float
        What one of the first coordinate, and of the loading parameter, is in the unit that the axis shows; of an angle, what a
        degree is.
    label, across : str, optional
        Of these axes.
    n : int
        Points of each piece.

    Returns
    -------
    list of artists
        Of the path.
    """
    ax, first = own_axes(ax), p.model.coordinates[0]
    allowed, end = p.model.Parameters.ranges[vary], float(ranges(p.model, (vary,), {})[0, 1])
    high, further = allowed.reached(allowed.high), ends[1] + _MORE * abs(ends[1])
    least, far = (_TOP, _FAR) if vary == "mu0" else (further, _FAR * ends[1] if ends[1] > max(begin, 0.0) else end)
    turns = folds_between(p, vary, begin, min(max(far, further), high))
    known = [value + _MORE * abs(value) for value in getattr(turns, vary).tolist() if begin < value < far]
    top = min(max(least, further, *known), high)
    top = top if top > begin else end  # nothing is applied yet, and nothing ends
    draw_branches(curves_between(p, vary, (begin, top), turns, True, n), first, ax=ax, color=GREY, linewidth=0.8)
    artists: list[Any] = []
    with suppress(ConvergenceError):  # where branches can't be told apart there are the states alone
        path = ss.quasi_static_path(p, vary, np.linspace(begin, top, 2 * n + 1))
        artists += draw_path(path, first, ax=ax, color=VERMILION)
    mark_folds(turns, first, ax=ax, low=begin, high=top)
    ax.axvspan(*as_drawn(p.model, vary, ends), color=SKY, alpha=0.25, linewidth=0, zorder=0)
    ax.set_xlim(as_drawn(p.model, vary, (begin, top)))
    in_units(ax.xaxis, (across, size))
    in_units(ax.yaxis, (label or with_unit(p.model, first), length))
    return artists


def draw_shares(indices: Mapping[str, tuple[float, float, float]], ax: Axes | None = None) -> Any:
    """Sobol' indices as bars: the total effect of every quantity, its own share within, and the interval of the total.

    Parameters
    ----------
    indices : mapping of str to (float, float, float)
        First order, total, and half-width of the total's interval.
    ax : Axes, optional
    """
    ax = own_axes(ax)
    names = list(indices)[::-1]
    first, total, error = (np.nan_to_num([indices[name][k] for name in names]) for k in range(3))
    places = np.arange(len(names))
    ax.barh(places, total, xerr=error, color=SKY, height=0.62, error_kw={"elinewidth": 0.8, "ecolor": GREY})
    bars = ax.barh(places, np.maximum(first, 0.0), color=BLUE, height=0.3)
    ax.set_yticks(places, [f"${symbol(name)}$" if name.isidentifier() else name for name in names])
    ax.set(xlabel="share of the variance of “it jumps”", xlim=(0, 1.05))
    if names:
        write_along(ax, "dark: alone; light: with others", 0.98, -0.1, ha="right", color=GREY)
    return bars
