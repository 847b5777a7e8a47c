"""Figures that the article lacks: why its 8 to 10 come out as they do, and what its 4 and 7 rest on."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray

import spragsym as ss

from ..assumed import MU0_RANGE, D, V
from ..generated import equilibrium as _equilibrium
from ..models.parameters import ARTICLE, FloatArray, Parameters
from ..motion.sweeps import Workers, rms_sweep, sensitivity
from ..numerics.interval_arrays import BoolArray
from ..numerics.polynomials import eigenvalues
from .captions import BASE_TEXT
from .planes import draw_bifurcation_set
from .style import (
    BLACK,
    BLUE,
    DOUBLE,
    GREY,
    SINGLE,
    VERMILION,
    Sheet,
    Table,
    angle_axis,
    line_at,
    panels,
    plain_ticks,
    remark,
    single,
    stacked,
    styled,
    write_along,
)

#: Parameter → (range shown, the article's samples, an interval that holds the critical value).
_SAMPLES: dict[str, tuple[tuple[float, float], tuple[float, ...], tuple[float, float]]] = {
    "beta": ((0.0, 3.0), (0.0, 1.0, 2.0), (1.0, 2.0)),
    "alpha": ((1e-3, 1.0), (0.007, 0.07, 0.7), (0.007, 0.07)),
    "sigma": ((3e-3, 3.0), (0.01, 0.1, 1.0), (0.01, 0.1)),
    "kappa": ((1e-4, 1.0), (0.007,), (1e-4, 0.007)),
}
_TICKS = {"alpha": (0.1, 1.0, 10.0), "sigma": (0.1, 0.2, 0.5), "kappa": (0.01, 0.1, 0.5)}


@styled
def figure_cusp_friction(*, n: int = 41) -> Sheet:
    """The lowest fold over each parameter: why Figures 8 to 10 come out as they do."""
    figure, axes = panels(2, 2, DOUBLE, 4.6)
    tables: dict[str, Table] = {}
    for letter, ax, name in zip("abcd", axes.flat, _SAMPLES, strict=True):
        tables[letter] = _draw_cusp_friction(ax, name, n)
    return figure.describe(
        f"""Friction of the lowest fold over all inclinations, μ_lowest, over (a) β, (b) α, (c) σ, (d) κ, the other
        parameters
        at {BASE_TEXT}. From small deformation a curve at μ₀ = 0.5 (dotted) jumps where μ_lowest lies below
        it. Dots are the article's samples, of its Figures 8 to 10 in (a) to (c); filled: jumps, open: does
        not. The number is the critical value. Where the curve of (d) ends there is no fold beyond.""",
        **tables,
    )


def _draw_cusp_friction(ax: Axes, name: str, n: int) -> Table:
    (low, high), samples, bracket = _SAMPLES[name]
    values = np.linspace(low, high, n) if name == "beta" else np.geomspace(low, high, n)
    p, mu0 = Parameters.article(), ARTICLE["mu0"]
    along = p.replace(**{name: values})
    frictions, cusps = np.asarray(ss.critical_friction(along)), np.asarray(ss.cusp_friction(along))
    ax.plot(values, frictions, color=BLACK)
    ax.axhline(mu0, color=GREY, linewidth=0.7, linestyle=":")
    for value in samples:
        friction = float(ss.critical_friction(p.replace(**{name: value})))
        filled = BLUE if friction < mu0 else "white"
        ax.plot(value, friction, "o", markersize=4.5, color=BLUE, markerfacecolor=filled, zorder=3, clip_on=False)
    critical = ss.critical_value(p, name, bracket)
    line_at(ax, critical, VERMILION)
    if name == "beta":
        ax.set(ylim=(0, 0.9))
        write_along(ax, f"{critical:.6f}", critical + 0.05, 0.06, color=VERMILION)
    else:
        ax.set(xscale="log", yscale="log")
        plain_ticks(ax.yaxis, _TICKS[name])
        write_along(ax, f"{critical:.3g}", critical * 1.12, 0.06, color=VERMILION, transform=ax.get_xaxis_transform())
    ax.set(xlabel=rf"$\{name}$", ylabel=r"$\mu_{\mathrm{lowest}}$", xlim=(low, high))
    return {name: values, "mu_lowest": frictions, "mu_cusp": cusps}


# ---------------------------------------------------------------------------- the false double root in L


def _given(p: Parameters, theta0: FloatArray) -> tuple[Any, ...]:
    """What generated functions take, in contact."""
    return np.cos(theta0), np.sin(theta0), *p.scalars("mu0", "kappa", "alpha", "sigma", "beta"), 1


def _gap(coefficients: tuple[FloatArray, ...]) -> FloatArray:
    """Smallest distance of two roots, relative to their size, of each polynomial, lowest power first."""
    table = np.stack(np.broadcast_arrays(*coefficients), axis=-1).astype(float)
    roots = eigenvalues(table)
    one, other = (roots[..., which] for which in np.triu_indices(roots.shape[-1], 1))
    return (np.abs(one - other) / np.maximum(np.abs(one), np.abs(other))).min(axis=-1)


def root_gaps(p: Parameters, theta0: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Smallest relative distance of two roots of the quartic in L and of that in t = tan(θ/2)."""
    given = _given(p, theta0)
    return _gap(_equilibrium.contact_quartic(*given[:-1])), _gap(_equilibrium.t_quartic(*_equilibrium.f_coefficients(*given)))


def false_double_roots(p: Parameters) -> FloatArray:
    """θ₀ at which the quartic in L has a double root that is no fold: f(θ) = f(π − θ) = 0."""
    # There a sin θ + b = 0 and d sin θ = m sin² θ: a d + m b = 0, with cos θ₀ and sin θ₀ of the first degree.
    a, b, d, m = _equilibrium.f_coefficients(*_given(p, np.array([0, np.pi / 2, np.pi])))
    right, up, left = a * d + m * b
    along, level = (right - left) / 2, (right + left) / 2
    with np.errstate(invalid="ignore"):  # where there is none
        middle, half = np.arctan2(up - level, along), np.arccos(-level / np.hypot(along, up - level))
    angles = np.sort(np.mod([middle - half, middle + half], 2 * np.pi))
    return angles[(0 < angles) & (angles < np.pi)]


@styled
def figure_false_double_root() -> Sheet:
    """The quartic in L has a double root that is no fold; the quartic in t has none."""
    figure, (axes,) = panels(1, 2, DOUBLE, 2.6, sharey=True)
    p = Parameters.article()
    true, false = np.degrees(ss.folds(p).theta0), np.degrees(false_double_roots(p))
    near = [centre + side * np.geomspace(1e-8, 10, 150) for centre in (*true, *false) for side in (-1, 1)]
    angles = np.unique(np.concatenate([np.linspace(0.5, 179.5, 400), *near]))
    angles = angles[(angles > 0.1) & (angles < 179.9)]
    gaps = root_gaps(p, np.radians(angles))
    for ax, gap, name in zip(axes, gaps, "Lt", strict=True):
        ax.semilogy(angles, gap, color=BLACK, linewidth=0.9)
        angle_axis(ax)
        remark(ax, f"quartic in ${name}$")
        for angle in true:
            line_at(ax, angle, VERMILION, zorder=0)
            write_along(ax, f"fold\n{angle:.2f}°", angle + 2, 2e-5, color=VERMILION)
    for angle in false:
        line_at(axes[0], angle, BLUE, zorder=0)
        write_along(axes[0], f"no fold\n{angle:.2f}°", angle - 2, 2e-5, color=BLUE, ha="right")
    axes[0].set(ylabel="smallest relative\ndistance of two roots", ylim=(1e-6, 3))
    return figure.describe(
        f"""Smallest distance of two roots, relative to their size, at μ₀ = 0.5, {BASE_TEXT}, of (a) the
        quartic in L, the article's Equation (21), (b) the quartic in t = tan(θ/2). Both have a double
        root at the two folds; that in L has another where two different equilibria share the length
        σ/(σ + α), and where x and y can't be recovered from it.""",
        a={"theta0_deg": angles, "gap_L": gaps[0]}, b={"theta0_deg": angles, "gap_t": gaps[1]},
    )  # fmt: skip


# ------------------------------------------------------------------------------------ motions in numbers


#: Neighbouring cells whose RMS differ by more than this are divided.
_STEP_OF_RMS = 0.3


@styled
def figure_rms_map(*, step_deg: float = 2.0, step_mu0: float = 0.04, levels: int = 2, workers: Workers = 1) -> Sheet:
    """Root mean square of x over (θ₀, μ₀), as in Figure 7b, upon the bifurcation set.

    Cells are divided into four ``levels`` times, each time where the RMS steps from a cell to its neighbour.
    """
    figure, ax = single(SINGLE * 1.3, 3.2)
    p = Parameters.article()
    angles, frictions, rms, table = _divided(p, step_deg, step_mu0, levels, workers)
    image = ax.pcolormesh(angles, frictions, rms, cmap="cividis", vmin=0.0, rasterized=True)
    for line in draw_bifurcation_set(ss.bifurcation_set(p), ax, color=VERMILION):
        line.set_path_effects([withStroke(linewidth=2.4, foreground="white")])
    for text, place in (("I", (50, 0.75)), ("II", (117, 0.93))):
        write_along(ax, text, *place, ha="center", color=BLACK if text == "I" else "white")
    angle_axis(ax)
    ax.set(ylabel=r"$\mu_0$", ylim=MU0_RANGE)
    figure.colorbar(image, ax=ax, label=r"RMS of $x$", pad=0.02)
    share = 2**levels
    return figure.describe(
        f"""Root mean square of x, about zero, over 1500 < τ < 2000, of the motion from rest at x = y = 0, over
        inclination and friction; orange: the bifurcation set, the dot is the cusp. Here {BASE_TEXT}; V = {V} and d =
        {D:g} are our assumption. One motion for each cell, at its centre: cells of {step_deg:g}° by {step_mu0:g}, divided
        down to {step_deg / share:g}° by {step_mu0 / share:g} where the RMS steps. In both bright regions the motion ends in a
        large cycle, in which it is above the belt most of the time. Region I begins before the fold: the motion overshoots the
        divergent state. Region II has nothing to do with folds: the only equilibrium there is stable, a large cycle lives
        beside it, at θ₀ = 132° from μ₀ = 0.3 upwards at least, and the motion from rest, which bounces on the belt, grows into
        that cycle where friction is above about 0.83. Its ragged edge depends on the start, and on rounding.""",
        a=table,
    )


def _divided(
    p: Parameters, step_deg: float, step_mu0: float, levels: int, workers: Workers
) -> tuple[FloatArray, FloatArray, FloatArray, Table]:  # fmt: skip
    """A map over cells of unequal size: angles, frictions and RMS on the finest grid, and a table of what was computed."""
    tables: list[Table] = []
    for level in range(levels + 1):
        angles = _centres(180.0, step_deg / 2**level)
        frictions = _centres(MU0_RANGE[1], step_mu0 / 2**level)
        shape = frictions.size, angles.size
        if level == 0:
            rms, asked = np.zeros(shape), np.ones(shape, dtype=bool)
        else:
            rms, asked = _in_four(rms), _in_four(_beside_a_step(rms))
        row, column = np.nonzero(asked)
        where = p.replace(theta0=np.radians(angles[column]), mu0=frictions[row])
        sweep = rms_sweep(where, V, D, rtol=1e-8, workers=workers)
        rms[row, column] = sweep.rms
        tables.append({
            "theta0_deg": angles[column], "mu0": frictions[row], "rms_x": sweep.rms, "regime": sweep.regime,
            "level": np.full(row.size, level),
        })  # fmt: skip
    return angles, frictions, rms, stacked(tables)


def _centres(top: float, step: float) -> FloatArray:
    """Middles of equal cells from 0 on; the last cell may reach beyond ``top``."""
    return step * np.arange(0.5, round(top / step), dtype=np.float64)


def _in_four(cells: NDArray[Any]) -> NDArray[Any]:
    return np.kron(cells, np.ones((2, 2), dtype=cells.dtype))


def _beside_a_step(rms: FloatArray) -> BoolArray:
    """Cells that differ from a neighbour, beside or above, by a step."""
    found = np.zeros(rms.shape, dtype=bool)
    for axis in (0, 1):
        steps = np.abs(np.diff(rms, axis=axis)) > _STEP_OF_RMS
        for side in (0, 1):
            found |= np.insert(steps, 0 if side else steps.shape[axis], False, axis=axis)
    return found


@styled
def figure_sensitivity(*, step_deg: float = 1.0, workers: Workers = 1) -> Sheet:
    """What V and d, which the article does not state, do to its Figure 7b: a decade of each."""
    figure, (axes,) = panels(1, 3, DOUBLE, 2.5)
    p = Parameters.article()
    angles = np.arange(20.0, 70.0 + step_deg / 2, step_deg)
    tables: dict[str, Table] = {}
    along = p.replace(theta0=np.radians(angles))
    speeds, creeps = (value * np.sqrt(10.0) ** np.array([-1, 0, 1]) for value in (V, D))
    for letter, ax, symbol, sweep, values in (
        ("a", axes[0], "V", rms_sweep(along, speeds[:, None], D, workers=workers), speeds),
        ("b", axes[1], "d", rms_sweep(along, V, creeps[:, None], workers=workers), creeps),
    ):
        tables[letter] = _draw_rms(ax, angles, sweep.rms, values, symbol)
    coarse = p.replace(theta0=np.radians(np.arange(26.0, 60.0, 2.0 * step_deg)))
    speeds = V * 10.0 ** np.linspace(-0.5, 0.5, 5)
    jumps = sensitivity(coarse, speeds, creeps, refine=4, workers=workers)
    tables["c"] = _draw_jumps(axes[2], jumps.V, jumps.d, np.degrees(jumps.theta0))
    axes[2].axhline(float(np.degrees(ss.folds(p).theta0[0])), color=GREY, linewidth=0.7, linestyle=":")
    return figure.describe(
        f"""Sensitivity of Figure 7b to belt speed and steepness, μ₀ = 0.5, {BASE_TEXT}. Root mean square of x
        over 1500 < τ < 2000 from rest at x = y = 0, (a) for three V at d = {D:g}, (b) for three d at V =
        {V}; (c) the θ₀ at which it steps most, to {np.degrees(jumps.width):.2g}°, over V for three
        d. Dotted: the fold, which does not depend on them. V = {V} and d = {D:g} are our assumption of what
        the article does not state.""",
        **tables,
    )


_SHADES = (BLUE, BLACK, VERMILION)


def _draw_rms(ax: Axes, angles: FloatArray, rms: FloatArray, values: FloatArray, symbol: str) -> Table:
    for row, value, color in zip(rms, values, _SHADES, strict=True):
        ax.plot(angles, row, color=color, linewidth=0.9, label=f"${symbol} = {value:.3g}$")
    angle_axis(ax, 20, 70, 10)
    ax.set(ylabel=r"RMS of $x$", ylim=(0, None))
    ax.legend(loc="upper left", handlelength=1.2, borderaxespad=0.1)
    columns = {f"rms_x_{symbol}_{value:.4g}": row for row, value in zip(rms, values, strict=True)}
    return {"theta0_deg": angles, **columns}


def _draw_jumps(ax: Axes, speeds: FloatArray, creeps: FloatArray, jump_deg: FloatArray) -> Table:
    for column, creep, color in zip(jump_deg.T, creeps, _SHADES, strict=True):
        ax.semilogx(speeds, column, color=color, marker="o", markersize=3, linewidth=0.9, label=f"$d = {creep:.3g}$")
    ax.set(xlabel=r"$V$", ylabel=r"$\theta_0$ of the jump (deg)")
    plain_ticks(ax.xaxis, (0.2, 0.5, 1.0))
    ax.legend(handlelength=1.2)
    return {"V": np.repeat(speeds, creeps.size), "d": np.tile(creeps, speeds.size), "theta0_deg": jump_deg.ravel()}
