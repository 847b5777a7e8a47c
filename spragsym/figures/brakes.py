"""Pictures of one brake: where it stands in the bifurcation set, its path as friction rises, and which tolerance matters."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from ..door import only_for
from ..kang_nam.catastrophe import folds, quasi_static_path
from ..parameters import Parameters
from .bifurcation_sets import draw_bifurcation_set
from .curves import branches, draw_branches, draw_path, mark_folds
from .style import BLACK, BLUE, GREY, SKY, VERMILION, own_axes, write_along

#: Friction up to which pictures go, at least.
_TOP = 1.0


@only_for(Parameters, "draw_bifurcation_set_of(model, found) draws the set")
def draw_operating_point(
    p: Parameters, theta0: tuple[float, float], mu0: tuple[float, float], jump: float = float("nan"), ax: Axes | None = None
) -> Any:
    """The bifurcation set with the point where a brake works, the box of its tolerances, and the friction at which it jumps.

    Parameters
    ----------
    p : Parameters
        Scalars, with the friction that works.
    theta0, mu0 : (float, float)
        Ends of the tolerances, radians.
    jump : float
        Friction at which the state of small deformation jumps at θ₀, NaN if it never does.
    ax : Axes, optional

    Returns
    -------
    matplotlib line of the point
    """
    ax = own_axes(ax)
    top = max(_TOP, 1.15 * mu0[1], 1.15 * jump if jump < 3 else 0.0)
    draw_bifurcation_set(ax, p.replace(theta0=None, mu0=None), (0.0, top))
    angle, friction = float(np.degrees(p.theta0)), float(p.mu0)
    low, high = np.degrees(theta0)
    ax.add_patch(Rectangle((low, mu0[0]), high - low, mu0[1] - mu0[0], facecolor=SKY, edgecolor=BLUE, linewidth=0.8, alpha=0.6,
                           zorder=3))  # fmt: skip
    (point,) = ax.plot([angle], [friction], "o", color=BLUE, markersize=4.5, zorder=5)
    if np.isfinite(jump):
        ax.plot([angle], [jump], marker="x", color=BLACK, markersize=5, zorder=5)
        ax.annotate(f"jump at {jump:.3f}", (angle, jump), (6, -2), textcoords="offset points", fontsize=8, va="top")
    return point


@only_for(Parameters, "draw_equilibria_of(model, p, vary, ends) draws the states")
def draw_rising_friction(
    p: Parameters, mu0: tuple[float, float], ax: Axes | None = None, *, length: float = 1.0, label: str = r"$x$ / $L_0$"
) -> Any:
    """The states over the friction, the one followed as it rises from 0, and the range of the friction shaded."""
    ax = own_axes(ax)
    turns = folds(p, "mu0")
    top = max(_TOP, 1.15 * mu0[1], *(1.15 * value for value in turns.mu0.tolist() if value < 3))
    draw_branches(branches(p, "mu0", 0.0, top), ax=ax, color=GREY, linewidth=0.8)
    path = quasi_static_path(p, "mu0", np.linspace(0.0, top, 401))
    artists = draw_path(path, ax=ax, color=VERMILION)
    mark_folds(turns, ax=ax, high=top)
    ax.axvspan(*mu0, color=SKY, alpha=0.25, linewidth=0, zorder=0)
    if length != 1.0:
        ax.yaxis.set_major_formatter(lambda value, _: f"{value * length:g}")
        _round_ticks(ax, length)
    ax.set(xlabel=r"friction $\mu$", ylabel=label, xlim=(0, top))
    return artists


def _round_ticks(ax: Axes, length: float) -> None:
    """Ticks at round numbers of the unit that is shown."""
    from matplotlib.ticker import MaxNLocator

    low, high = ax.get_ylim()
    ticks = (np.asarray(MaxNLocator(6).tick_values(low * length, high * length)) / length).tolist()
    ax.set_yticks([tick for tick in ticks if low <= tick <= high])


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
    ax.set_yticks(places, [_SYMBOLS.get(name, name) for name in names])
    ax.set(xlabel="share of the variance of “it jumps”", xlim=(0, 1.05))
    if names:
        write_along(ax, "dark: alone; light: with others", 0.98, -0.1, ha="right", color=GREY)
    return bars


_SYMBOLS = {
    "k": "$k$", "k_x": "$k_x$", "k_y": "$k_y$", "k_c": "$k_c$", "F_L": "$F_L$", "L_0": "$L_0$", "theta0": r"$\theta_0$",
    "mu0": r"$\mu_0$",
}  # fmt: skip
