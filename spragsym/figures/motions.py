"""Motions over time, in the phase plane, and their spectra; the article's Figures 3 and 7, and the
sensitivity of 7 to what the article does not state.
"""

from __future__ import annotations

import re
from string import ascii_lowercase
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray
from scipy import ndimage

import spragsym as ss

from ..article.assumed import MU0_RANGE, D, Parameters, V
from ..core.errors import ParameterError, require_kind
from ..generated import laws
from ..models import Model
from ..models.forces import contact_force
from ..models.parameters import FloatArray, ParameterSet
from ..models.quantities import Scales
from ..motion import Trajectory, simulate
from ..motion.simulation import row_of
from ..motion.sweeps import Basin, Sweep, Workers, rms_sweep, sensitivity
from ..numerics.interval_arrays import BoolArray
from ..statics.forces import belt_speeds
from .curves import first_fold
from .planes import draw_bifurcation_set
from .style import (
    BASE_TEXT,
    BLACK,
    BLUE,
    DOUBLE,
    GREY,
    PALETTE,
    SINGLE,
    VERMILION,
    Sheet,
    Shown,
    Table,
    angle_axis,
    cells,
    in_letters,
    label,
    line_at,
    own_axes,
    own_unit,
    panels,
    plain_ticks,
    remark,
    single,
    stacked,
    styled,
    write_along,
)

if TYPE_CHECKING:
    from matplotlib.lines import Line2D


@styled
def figure_3() -> Sheet:
    """Friction over the speed of the mass, and contact force over its displacement."""
    figure, ((left, right),) = panels(1, 2, DOUBLE, 2.3)
    beside_jump = V - 1e-9, V + 1e-9
    speed = np.unique([*np.linspace(-0.5, 1.5, 401), *beside_jump])
    friction = laws.friction(speed, 1.0, V, D)
    left.axhline(0, color=GREY, linewidth=0.5)
    for part in (speed < V, speed > V):
        left.plot(speed[part], friction[part], color=BLACK)
    line_at(left, V)
    write_along(left, r"$x' = V$", V + 0.04, -0.12)
    left.set(
        xlabel=r"$x'$",
        ylabel=r"$\mu/\mu_0$",
        xlim=(-0.5, 1.5),
        ylim=(-1.15, 1.15),
        xticks=np.arange(-0.5, 1.6, 0.5),
    )
    y, p = np.array([-0.1, 0.0, 0.1]), Parameters.article(theta0=1.0)
    # The contact force (11) depends on y only.
    contact = contact_force(p.model, (0.0, y), p.model.arguments(p, "motion"))
    right.plot(y, contact, color=BLACK)
    write_along(right, "contact", -0.048, 0.06)
    write_along(right, "lift-off", 0.05, 0.009, ha="center")
    right.set(
        xlabel=r"$y$",
        ylabel=r"$n$",
        xlim=(-0.1, 0.1),
        ylim=(-0.008, 0.105),
        xticks=np.arange(-0.1, 0.11, 0.05),
    )
    return figure.describe(
        f"""Figure 3. (a) Regularized friction coefficient (10) over the speed of the mass, for a
        belt speed V = {V} and a steepness d = {D:g}, which are our assumption: the article states
        neither. (b) Contact force (11). All quantities are dimensionless.""",
        a={"vx": speed, "mu_over_mu0": friction},
        b={"y": y, "n": contact},
    )


@styled
def figure_7(*, step_deg: float = 0.5, workers: Workers = 1) -> Sheet:
    """The motion over time at 49°, and the root mean square of x over θ₀."""
    figure, ((left, right),) = panels(1, 2, DOUBLE, 2.5)
    p = Parameters.article()
    trajectory = simulate(p.replace(theta0=np.radians(49.0)))
    t = np.linspace(0.0, 2000.0, 8001)
    x = trajectory(t)[0]
    left.plot(t, x, color=BLACK, linewidth=0.6)
    left.set(xlabel=r"$\tau$", ylabel=r"$x$", xlim=(0, 2000))
    remark(left, r"$\theta_0 = 49^\circ$")
    angles = np.arange(step_deg, 180.0 - step_deg / 2, step_deg)
    sweep = rms_sweep(p.replace(theta0=np.radians(angles)), workers=workers)
    right.plot(angles, sweep.rms, color=BLACK, marker=".", markersize=2.2, linewidth=0.5)
    fold = first_fold(p)
    line_at(right, fold, VERMILION, 0.8)
    write_along(right, f"fold, {fold:.2f}°", fold + 3, 0.12, color=VERMILION)
    angle_axis(right, ylabel=r"RMS of $x$", ylim=(0, None))
    return figure.describe(
        f"""Figure 7. Motion from rest at x = y = 0, μ₀ = 0.5, {BASE_TEXT}. (a) x over
        dimensionless time at θ₀ = 49°. (b) Root mean square of x, about zero, over 1500 < τ <
        2000. Belt speed V = {V}, steepness d = {D:g}, the rest at the start and the window in time
        are our assumption: the article states none of them. The dotted line is the fold. Beyond it
        a large and a small motion compete; near 54° rounding decides which of them is reached.""",
        a={"tau": t, "x": x},
        b={"theta0_deg": angles, "rms_x": sweep.rms, "regime": sweep.regime},
    )


#: Title and factor of each of two axes.
_Pair: TypeAlias = tuple[Shown, Shown]


def _own(motion: Trajectory, name: str) -> Shown:
    """Title of an axis for a column in radians or the model's unit, and the factor 1."""
    column = motion.columns[name]
    return label(column, "rad" if column.is_angle else own_unit(motion.model, column)), 1.0


def _frequency(model: Model) -> Shown:
    """Title of an axis for frequencies in the model's unit, and the factor 1."""
    return rf"frequency $\times\ {in_letters(model.unit('s'))}$", 1.0


def _line(ax: Axes, x: FloatArray, y: FloatArray, shown: _Pair, width: float = 0.8) -> Line2D:
    """Draw a line in the units of the axes, and name these."""
    (x_title, x_unit), (y_title, y_unit) = shown
    (line,) = ax.plot(x_unit * x, y_unit * y, color=BLUE, linewidth=width, label=y_title)
    ax.set(xlabel=x_title, ylabel=y_title)
    return line


def draw_motion(
    motion: Trajectory,
    of: str | None = None,
    ax: Axes | None = None,
    *,
    shown: _Pair | None = None,
) -> Line2D:
    """Draw a component of a motion over time; returns the line.

    Parameters
    ----------
    motion : Trajectory
    of : str, optional
        A coordinate of the model or its rate, as ``"x"``, ``"y"``, ``"vx"``, ``"vy"``; by default
        the first coordinate.
    ax : Axes, optional
    shown : pair of (str, float), optional
        Title of each axis, and the factor from the model's unit to that of the axis.
    """
    require_kind("motion", motion, Trajectory, "one of ss.simulate(...)")
    names = motion.components
    row, t = row_of(of, names), np.linspace(motion.t[0], motion.t[-1], 4000)
    shown = shown or (_own(motion, motion._own("t")), _own(motion, names[row]))
    return _line(own_axes(ax), t, motion(t)[row], shown)


def draw_phase(
    motion: Trajectory,
    ax: Axes | None = None,
    *,
    of: str | None = None,
    shown: _Pair | None = None,
) -> Line2D:
    """Draw the phase plane of a coordinate, by default the first, with a line at the speed of the
    belt; returns the curve. ``shown`` as for :func:`draw_motion`.
    """
    require_kind("motion", motion, Trajectory, "one of ss.simulate(...)")
    ax, model, names = own_axes(ax), motion.model, motion.model.coordinates
    row, states = row_of(of, names), motion(np.linspace(motion.t[0], motion.t[-1], 6000))
    shown = shown or (_own(motion, names[row]), _own(motion, model.rates[row]))
    line = _line(ax, states[row], states[len(names) + row], shown)
    for speed in steady_belts(motion.p, names[row]):
        ax.axhline(
            shown[1][1] * speed,
            color=GREY,
            linewidth=0.6,
            linestyle=":",
            label="speed of the belt",
        )
    return line


@styled
def draw_sweep(sweep: Sweep, ax: Axes | None = None, *, of: str = "rms") -> list[Any]:
    """Draw a quantity of a sweep: dots over the input that varies, or cells in the plane of the two
    that do; returns the artists.

    Parameters
    ----------
    sweep : Sweep
        Over one input or two.
    ax : Axes, optional
    of : str
        A column of numbers, by default the root mean square of the first coordinate.

    Raises
    ------
    ParameterError
        If none or more than two inputs vary.
    """
    require_kind("sweep", sweep, Sweep, "one of ss.rms_sweep(...)")
    ax, schema, height = own_axes(ax), sweep._schema, sweep[of]
    varied = [name for name, values in sweep.inputs.items() if values.size > 1]
    if not 0 < len(varied) <= 2:
        raise ParameterError(
            f"{', '.join(varied) or 'no input'} varied in this sweep; one or two can be drawn: "
            "draw columns of to_dataframe() otherwise"
        )
    columns = [schema.column(name) for name in varied]
    places = [
        column.size * np.broadcast_to(sweep.inputs[name], height.shape).ravel()
        for column, name in zip(columns, varied, strict=True)
    ]
    size, title = schema.column(of).size, schema.heading(of)
    if len(varied) == 1:
        ax.set(xlabel=label(columns[0]), ylabel=title)
        return ax.plot(places[0], size * height.ravel(), ".", color=BLUE, label=title)
    ax.set(xlabel=label(columns[0]), ylabel=label(columns[1]))
    (image,) = artists = cells(ax, places, size * height.ravel())
    ax.figure.colorbar(image, ax=ax, label=title, pad=0.02)
    return artists


@styled
def draw_basin(found: Basin, ax: Axes | None = None) -> list[Any]:
    """Draw basins of attraction as cells, each sampled at its middle, with one colour an attractor;
    returns the artists, which a legend names.
    """
    require_kind("found", found, Basin, "one of ss.basin(...)")
    ax, model = own_axes(ax), found.sweep.model
    x_column, y_column = map(model.column, found.plane)
    x, y = (
        column.size * values.ravel()
        for column, values in zip(
            (x_column, y_column), np.meshgrid(*found.starts, indexing="ij"), strict=True
        )
    )
    named = [
        f"{regime.name.lower().replace('_', ' ')}{f' {number}' if number >= 0 else ''}"
        for regime, number, *_ in found.attractors
    ]
    artists: list[Any] = []
    for code, name in enumerate(named):
        mask = found.attractor.ravel() == code
        artists += cells(ax, (x, y), mask, PALETTE[code % len(PALETTE)], name)
    artists += cells(ax, (x, y), found.attractor.ravel() < 0, "white", "failed")
    ax.set(xlabel=label(x_column), ylabel=label(y_column))
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)
    return artists


def steady_belts(p: ParameterSet, along: str | None = None) -> list[float]:
    """Speeds of belts that do not vary in time, each once; with ``along`` of those along a
    coordinate.
    """
    frictions, parameters = p.model.frictions, set(p.model.parameters)
    speeds = belt_speeds(p) if frictions else ()
    found = (
        float(speed)
        for speed, friction in zip(speeds, frictions, strict=False)
        if along in (None, friction["along"])
        and set(re.findall(r"[^\W\d]\w*", friction["belt"])) <= parameters
    )
    return list(dict.fromkeys(found))


def draw_spectrum(
    motion: Trajectory,
    of: str = "x",
    ax: Axes | None = None,
    *,
    shown: _Pair | None = None,
) -> Line2D:
    """Draw the spectrum of a motion, through a Hann window, up to the highest frequency with more
    than 1 % of the largest amplitude; of whole periods of a cycle its harmonics, as stems. Returns
    the line. ``shown`` as for :func:`draw_motion`.
    """
    require_kind("motion", motion, Trajectory, "one of ss.simulate(...)")
    ax, found = own_axes(ax), motion.spectrum(0.0, of=of)
    shown = shown or (
        _frequency(motion.model),
        (f"amplitude of {_own(motion, of)[0]}", 1.0),
    )
    # At rest all amplitudes are 0, and there is no last one.
    last = np.flatnonzero(found.amplitude > 0.01 * found.amplitude.max()).max(initial=0)
    end = 2 * last + 8
    if found.window == "Hann":
        line = _line(ax, found.frequency, found.amplitude, shown, 0.9)
    else:
        end = last + 1
        line = _line(ax, found.frequency[:end], found.amplitude[:end], shown)
        line.set(linestyle="", marker="o", markersize=3)
        ax.vlines(line.get_xdata(), 0.0, line.get_ydata(), color=BLUE, linewidth=1.4)
    end = shown[0][1] * found.frequency[min(end, found.frequency.size - 1)]
    ax.set(xlim=(0, end), ylim=(0, None))
    return line


@styled
def motion_figure(motion: Trajectory, transient: float = 0.0, units: Scales | None = None) -> Sheet:
    """For each coordinate but the phase of a clock the motion over time, and without the transient
    its phase plane and its spectrum, as a figure.

    Parameters
    ----------
    motion : Trajectory
        Of any model.
    transient : float
        Time that is left out in phase planes and spectra.
    units : Scales, optional
        Units of the model in metres and seconds, as of :class:`spragsym.PhysicalParameters`. Axes
        are then in mm, degrees and s; by default they are dimensionless.
    """
    require_kind("motion", motion, Trajectory, "one of ss.simulate(...)")
    model, late = motion.model, motion.after(transient)
    moving = [
        pair for pair in zip(model.coordinates, model.rates, strict=True) if pair[0] != model.clock
    ]
    figure, axes = panels(len(moving), 3, DOUBLE, 0.3 + 2.1 * len(moving))
    columns = list[Table]()
    for (left, middle, right), (name, rate) in zip(axes, moving, strict=True):
        if units is None:
            time, frequency = _own(motion, motion._own("t")), _frequency(model)
            place, speed = _own(motion, name), _own(motion, rate)
        else:
            size, unit = 1e3 * units.length, "mm"
            if model.is_angle(name):
                size, unit = 180 / np.pi, "deg"
            time, frequency = ("$t$ (s)", units.time), ("frequency (Hz)", 1 / units.time)
            place = label(model.column(name), unit), size
            speed = label(model.column(rate), f"{unit}/s"), size / units.time
        amplitude = f"amplitude of {place[0]}", place[1]
        draw_motion(motion, name, left, shown=(time, place))
        draw_phase(late, middle, of=name, shown=(place, speed))
        draw_spectrum(late, name, right, shown=(frequency, amplitude))
        found = late.spectrum(0.0, of=name)
        columns += (
            {"t": time[1] * motion.t, name: place[1] * motion[name]},
            {name: place[1] * late[name], rate: speed[1] * late[rate]},
            {"frequency": frequency[1] * found.frequency, "amplitude": place[1] * found.amplitude},
        )
    figure.tables |= dict(zip(ascii_lowercase, columns, strict=False))
    belts = steady_belts(motion.p)
    after = f"{transient:g}" if units is None else f"{transient * units.time:.4g} s"
    if units is not None and len(belts) == 1:
        moved = f"belt speed {1e3 * belts[0] * units.length / units.time:.4g} mm/s"
    else:
        moved = ", ".join(
            f"{each['meaning']} {each['name']} = {float(motion.p[each['name']]):g}"
            for each in model.about["parameters"]
            if each["role"] == "motion"
        )
    window = "" if late.periods else ", through a Hann window"
    return figure.describe(
        f"""A motion of {model.name}, {moved}. Left: each coordinate over time; middle and right,
        after the time {after}: its rate over it, with the speed of the belt dotted, and its
        spectrum{window}."""
    )


@styled
def figure_rms_map(
    *, step_deg: float = 2.0, step_mu0: float = 0.04, levels: int = 2, workers: Workers = 1
) -> Sheet:
    """Root mean square of x over (θ₀, μ₀), as in Figure 7b, with the bifurcation set.

    Cells in which the RMS differs much from that of a neighbour are divided into four, ``levels``
    times.
    """
    figure, ax = single(SINGLE * 1.3, 3.2)
    p = Parameters.article()
    angles, frictions, rms, table = _adaptive_rms(p, step_deg, step_mu0, levels, workers)
    image = ax.pcolormesh(angles, frictions, rms, cmap="cividis", vmin=0.0, rasterized=True)
    for line in draw_bifurcation_set(ss.bifurcation_set(p), ax, color=VERMILION):
        line.set_path_effects([withStroke(linewidth=2.4, foreground="white")])
    write_along(ax, "I", 50, 0.75, ha="center")
    write_along(ax, "II", 117, 0.93, "white", ha="center")
    angle_axis(ax, ylabel=r"$\mu_0$", ylim=MU0_RANGE)
    figure.colorbar(image, ax=ax, label=r"RMS of $x$", pad=0.02)
    share = 2**levels
    return figure.describe(
        f"""Root mean square of x, about zero, over 1500 < τ < 2000, of the motion from rest at x =
        y = 0, over inclination and friction; orange: the bifurcation set, the dot is the cusp.
        Here {BASE_TEXT}; V = {V} and d = {D:g} are our assumption. One motion for each cell, at
        its centre: cells of {step_deg:g}° by {step_mu0:g}, divided down to {step_deg / share:g}°
        by {step_mu0 / share:g} where the RMS steps. In both bright regions the motion ends in a
        large cycle, in which it is above the belt most of the time. Region I begins before the
        fold: the motion overshoots the divergent state. Region II has nothing to do with folds:
        the only equilibrium there is stable, a large cycle lives beside it, at θ₀ = 132° from μ₀ =
        0.3 upwards at least, and the motion from rest, which bounces on the belt, grows into that
        cycle where friction is above about 0.83. Its ragged edge depends on the start, and on
        rounding.""",
        a=table,
    )


def _adaptive_rms(
    p: Parameters, step_deg: float, step_mu0: float, levels: int, workers: Workers
) -> tuple[FloatArray, FloatArray, FloatArray, Table]:
    """RMS on a grid that is refined where it steps: angles, frictions and RMS of the finest cells,
    and a table of the cells that were computed.
    """
    tables: list[Table] = []
    for level in range(levels + 1):
        ends = (180.0, step_deg / 2**level), (MU0_RANGE[1], step_mu0 / 2**level)
        # Centres of equal cells from 0; the last cell may extend beyond the end.
        angles, frictions = (
            step * np.arange(0.5, round(top / step), dtype=float) for top, step in ends
        )
        if level == 0:
            rms = np.zeros((frictions.size, angles.size))
            computed = rms == 0.0
        else:
            computed = _halves(_beside_a_step(rms))
            rms = _halves(rms)
        row, column = np.nonzero(computed)
        where = p.replace(theta0=np.radians(angles[column]), mu0=frictions[row])
        sweep = rms_sweep(where, rtol=1e-8, workers=workers)
        rms[row, column] = sweep.rms
        tables.append(
            {
                "theta0_deg": angles[column],
                "mu0": frictions[row],
                "rms_x": sweep.rms,
                "regime": sweep.regime,
                "level": level,
            }
        )
    return angles, frictions, rms, stacked(tables)


def _halves(cells: NDArray[Any]) -> NDArray[Any]:
    """Values of a grid with each cell divided into four."""
    return cells.repeat(2, axis=0).repeat(2, axis=1)


def _beside_a_step(rms: FloatArray) -> BoolArray:
    """Mask of cells whose RMS differs from that of a neighbour by more than 0.3."""
    cross = ndimage.generate_binary_structure(2, 1)
    above = ndimage.maximum_filter(rms, footprint=cross) - rms
    below = rms - ndimage.minimum_filter(rms, footprint=cross)
    return np.maximum(above, below) > 0.3


@styled
def figure_sensitivity(*, step_deg: float = 1.0, workers: Workers = 1) -> Sheet:
    """Sensitivity of the article's Figure 7b to V and d, which it does not state, over a decade."""
    figure, (axes,) = panels(1, 3, DOUBLE, 2.5)
    p = Parameters.article()
    angles = np.arange(20.0, 70.0 + step_deg / 2, step_deg)
    fine = p.replace(theta0=np.radians(angles))
    speeds, steepnesses = (value * np.sqrt(10.0) ** np.array([-1, 0, 1]) for value in (V, D))
    # Colours of the smaller, the assumed and the larger value.
    shades = (BLUE, BLACK, VERMILION)
    for letter, ax, name, values in zip("ab", axes[:2], "Vd", (speeds, steepnesses), strict=True):
        sweep = rms_sweep(fine.replace(**{name: values[:, None]}), workers=workers)
        figure.tables[letter] = columns = {"theta0_deg": angles}
        for rms, value, color in zip(sweep.rms, values, shades, strict=True):
            ax.plot(angles, rms, color=color, linewidth=0.9, label=f"${name} = {value:.3g}$")
            columns[f"rms_x_{name}_{value:.4g}"] = rms
        angle_axis(ax, 20, 70, 10, ylabel=r"RMS of $x$", ylim=(0, None))
        ax.legend(loc="upper left", handlelength=1.2, borderaxespad=0.1)
    ax = axes[2]
    coarse = p.replace(theta0=np.radians(np.arange(26.0, 60.0, 2.0 * step_deg)))
    jumps = sensitivity(
        coarse, V * 10.0 ** np.linspace(-0.5, 0.5, 5), steepnesses, refine=4, workers=workers
    )
    places = np.degrees(jumps.theta0)
    for position, d, color in zip(places.T, steepnesses, shades, strict=True):
        name = f"$d = {d:.3g}$"
        ax.semilogx(jumps.V, position, "o-", color=color, markersize=3, linewidth=0.9, label=name)
    ax.set(xlabel=r"$V$", ylabel=r"$\theta_0$ of the jump (deg)")
    plain_ticks(ax.xaxis, (0.2, 0.5, 1.0))
    ax.legend(handlelength=1.2)
    ax.axhline(first_fold(p), color=GREY, linewidth=0.7, linestyle=":")
    figure.tables["c"] = {
        "V": np.repeat(jumps.V, jumps.d.size),
        "d": np.tile(jumps.d, jumps.V.size),
        "theta0_deg": places.ravel(),
    }
    return figure.describe(
        f"""Sensitivity of Figure 7b to belt speed and steepness, μ₀ = 0.5, {BASE_TEXT}. Root mean
        square of x over 1500 < τ < 2000 from rest at x = y = 0, (a) for three V at d = {D:g}, (b)
        for three d at V = {V}; (c) the θ₀ at which it steps most, to
        {np.degrees(jumps.width):.2g}°, over V for three d. Dotted: the fold, which does not depend
        on them. V = {V} and d = {D:g} are our assumption of what the article does not state."""
    )
