"""Figures of cycles: branches of cycles beside equilibria, bifurcation diagrams, curves of
bifurcations of cycles, and maps of the fates of motions.
"""

from __future__ import annotations

import functools
import json
import math
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from operator import attrgetter
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.transforms import Affine2D

import spragsym as ss

from ..article.assumed import ON_CYCLE, D, Parameters, V
from ..core.errors import ConvergenceError, ParameterError, one_of, require_kind
from ..files.text import shipped_text
from ..models.parameters import FloatArray
from ..numerics.interval_arrays import BoolArray
from ..orbits import Cycle, CycleBranch, FateMap, cycle, cycle_branch, cycle_events, fate_boundary
from ..orbits.diagram import Diagram, Label
from ..orbits.events import SLIDING
from ..orbits.fates import FateKind
from .curves import branches, first_fold, shade, table_of
from .style import (
    BASE_TEXT,
    BLACK,
    BLUE,
    DOUBLE,
    GREY,
    LINES,
    PALETTE,
    SKY,
    VERMILION,
    Sheet,
    Table,
    angle_axis,
    cells,
    label,
    line_at,
    once,
    panels,
    runs,
    say,
    single,
    stacked,
    styled,
    write_along,
)

#: Markers of bifurcations of cycles.
MARKERS = {"period_doubling": "o", "fold": "s", "torus": "^", "branch_point": "D"}


def _sliding() -> Parameters:
    """The article's parameters with μ₀ replaced by the friction μ(V) at the speed of the belt."""
    p = Parameters.article()
    return p.replace(mu0=float(p.model.friction(p)))


@styled
def figure_cycles() -> Sheet:
    """Root mean square of x over θ₀ for equilibria and cycles: the bifurcation diagram behind
    Figure 7b.
    """
    figure, ax = single(DOUBLE, 4.2)
    rest = branches(_sliding(), "theta0", between={"theta0": (np.radians(1.0), np.radians(179.0))})
    for curve in rest:  # the root mean square is |x|
        ax.plot(
            curve.shown("theta0"),
            np.abs(curve.x),
            color=BLACK,
            linestyle=LINES[curve.kind],
            linewidth=1.0,
        )
    # Branches found by ``python -m validation.cycle_search``, with data of the search.
    found = json.loads(shipped_text("spragsym.figures", "cycles.json"))
    colours = dict[str, str]()
    columns, events = list[Table](), list[tuple[Any, ...]]()
    titles = ("branch", "kind", "theta0_deg", "period", "rms_x", "how")
    for line in found["branches"]:
        # Doubled cycles have the colour of the original ones.
        family, _, doubled = line["name"].partition(",")
        colour = colours.setdefault(family, PALETTE[len(colours) % len(PALETTE)])
        columns.append(_draw_found(ax, line, colour, bool(doubled)))
        for kind, at, length, rms, how in line["events"]:
            angle = np.degrees(at)
            events.append((line["name"], kind, angle, length, rms, how))
            if kind in MARKERS:
                _mark(ax, (angle, rms), MARKERS[kind], color=colour, markersize=3)
    p = Parameters.article()
    fate = fate_boundary(p, "theta0", between={"theta0": (np.radians(41.0), np.radians(42.0))})
    places = np.degrees(fate.value), first_fold(p), first_fold(_sliding())
    for place, colour, dashes in zip(places, (BLACK, GREY, GREY), ("--", ":", "-"), strict=True):
        line_at(ax, place, colour, 0.8, style=dashes, zorder=0.5)
    # Larger unstable cycles are in the table only.
    angle_axis(ax, ylabel=r"RMS of $x$", ylim=(0, 2.15))
    return figure.describe(
        f"""Dynamic bifurcation diagram that Figure 7b samples, μ₀ = 0.5, {BASE_TEXT}, belt speed V
        = {V}, steepness d = {D:g} (our assumption). Black: equilibria at the friction μ(V), |x|;
        colours: cycles, root mean square of x about zero over one period; full where stable,
        equilibria by (27), dashed where not; thin: cycles that period doublings begin. Circles:
        period doublings; squares: folds of cycles; triangles: tori. Dashed vertical line: where
        the motion from rest changes its fate, {places[0]:.4f}°; dotted: the fold of the statics at
        μ₀, {places[1]:.4f}°; full: at μ(V), {places[2]:.4f}°. Cycles were looked for from
        {found["starts"]} starts at each of {len(found["inclinations_deg"])} inclinations, along
        their branches, and from stable doublings; they are not proved to be all, and branches that
        end in the open were not followed farther. Numbers: a period on the stable part. Some
        unstable cycles lie above the frame.""",
        a_equilibria=table_of(rest),
        a_branches=stacked(columns),
        a_events=dict(zip(titles, zip(*events, strict=True), strict=True)),
        a_lines={"what": ["fate of rest", "fold at mu0", "fold at mu(V)"], "theta0_deg": places},
    )


def _draw_found(ax: Axes, line: Mapping[str, Any], colour: str, doubled: bool) -> Table:
    """Draw a branch of ``cycles.json`` and label it by a period; returns its table."""
    theta0, periods, heights, is_stable = (
        np.array(line[name]) for name in ("theta0", "period", "rms", "stable")
    )
    angles, stable = np.degrees(theta0), is_stable == 1
    draw_stretches(ax, angles, heights, stable, colour, 0.9 if doubled else 1.4)
    # Doubled cycles are labelled if they are stable over more than 10 degrees.
    if not doubled or np.ptp(angles[stable]) > 10.0:
        value, period, *_ = line["at"]
        nearest = np.argmin(np.abs(theta0 - value) + np.abs(periods - period))
        position = np.degrees(value), heights[nearest] + 0.035
        write_along(ax, f"{period:.0f}", *position, color=colour, ha="center", fontsize=7)
    course = {"theta0_deg": angles, "period": periods, "rms_x": heights, "stable": is_stable}
    return {"branch": line["name"], **course}


def _mark(ax: Axes, place: tuple[float, float], marker: str, **style: Any) -> None:
    """Draw a hollow marker, by default black."""
    ax.plot(*place, marker, **{"color": BLACK, "markersize": 4, **style}, markerfacecolor="white")


def draw_stretches(
    ax: Axes, values: FloatArray, heights: FloatArray, stable: BoolArray, colour: str, width: float
) -> None:
    """Draw a branch, solid where stable and dashed where not, without gaps between the parts."""
    for part in runs(stable):
        style = "-" if stable[part][0] else (0, (3, 1.5))
        name = once(ax, "stable" if stable[part][0] else "unstable")
        (line,) = ax.plot(values[part], heights[part], color=colour, linestyle=style, label=name)
        line.set_linewidth(width)


def draw_cycles(
    ax: Axes,
    branch: CycleBranch,
    units: tuple[float, float],
    heights: FloatArray,
    height_of: Callable[[Cycle], float],
    colour: str,
) -> None:
    """Draw ``heights`` of a branch of cycles over the parameter, solid where stable.

    ``height_of`` gives the height of a cycle; it is asked for those at changes of stability, which
    are inserted. ``units`` are factors from the parameter and the heights to the units of the axes.
    """
    changes = dict(branch.changes())
    at = [*changes]
    values = np.insert(branch.values, at, [event.value for event in changes.values()])
    curve = np.insert(heights, at, [height_of(event.cycle) for event in changes.values()])
    stable = np.insert(branch.stable, at, branch.stable[at])
    draw_stretches(ax, units[0] * values, units[1] * curve, stable, colour, 1.3)


@styled
def branch_figure(branch: CycleBranch) -> Sheet:
    """Root mean square of the first coordinate and period along a branch of cycles, as a figure."""
    figure, ((left, right),) = panels(1, 2, DOUBLE, 2.6)
    draw_branch(branch, left)
    draw_branch(branch, right, "period")
    field = branch.cycles[0].field
    return figure.describe(
        "A branch of cycles: full where stable, dashed where not; circles are period "
        "doublings, squares folds, bars grazings.",
        a={
            branch.vary: branch.values,
            f"rms_{field.coordinates[0]}": branch.rms,
            "stable": branch.stable,
        },
        b={branch.vary: branch.values, "period": branch.periods},
    )


@styled
def draw_branch(branch: CycleBranch, ax: Axes, quantity: str = "rms") -> None:
    """Draw the root mean square of the first coordinate (``"rms"``), or the ``"period"``, along a
    branch of cycles.
    """
    require_kind("branch", branch, CycleBranch, "one of ss.cycle_branch(...)")
    one_of("quantity", quantity, ("rms", "period"))
    field, height_of = branch.cycles[0].field, attrgetter(quantity)
    varied, height = (field.column(name) for name in (branch.vary, field.coordinates[0]))
    unit = varied.size
    if quantity == "period":
        heights, size, title = branch.periods, 1.0, "period"
    else:
        heights, size, title = branch.rms, height.size, f"RMS of {label(height)}"
    draw_cycles(ax, branch, (unit, size), heights, height_of, BLUE)
    ax.set(xlabel=label(varied), ylabel=title)
    for kind, marker in {**MARKERS, **dict.fromkeys(("grazing", *SLIDING), "|")}.items():
        for event in branch.of(kind):
            place = unit * event.value, size * height_of(event.cycle)
            _mark(ax, place, marker, label=once(ax, kind.replace("_", " ")))


#: Bifurcations of the cycle of period 34, on its branches over the friction at 42 degrees and over
#: the angle at friction 0.5: parameter of the branch, kind, approximate value, number of points of
#: its curve in the plane, label and position of the label.
CURVES: dict[str, tuple[str, str, float, int, str, tuple[float, float]]] = {
    "doubling": ("mu0", "period_doubling", 0.49, 22, "period doubling", (5.0, 0.455)),
    "lower_doubling": ("mu0", "period_doubling", 0.32, 25, "period doubling", (96.0, 0.43)),
    "fold": ("theta0", "fold", np.radians(69.8), 20, "fold of cycles", (78.0, 0.515)),
    "lower_fold": ("mu0", "fold", 0.096, 36, "fold of cycles", (20.0, 0.04)),
}


def _along(vary: str) -> CycleBranch:
    """The branch over a parameter of the cycle of period 34, from 42° and friction 0.5 on."""
    first = cycle(Parameters.article(theta0=np.radians(42.0)), near=ON_CYCLE, patient=False)
    if vary == "theta0":
        return cycle_branch(first, vary, between={vary: (np.radians(41.0), np.radians(72.0))})
    return cycle_branch(first, vary, between={vary: (0.05, 0.5)}, points=90)


@styled
def figure_cycles_plane(
    *,
    frictions: tuple[float, ...] = (0.3, 0.4, 0.5, 0.6, 0.7, 0.8),
    curves: tuple[str, ...] = tuple(CURVES),
) -> Sheet:
    """Curves in the plane of θ₀ and μ₀: bifurcations of the cycle of period 34, folds of
    equilibria, and changes of the fate of the motion from rest.
    """
    figure, ax = single(DOUBLE, 3.6)
    followed = functools.cache(_along)
    for name in curves:
        vary, kind, nearest, points, text, position = CURVES[name]
        event = min(followed(vary).of(kind), key=lambda event: abs(event.value - nearest))
        found = cycle_events(
            event,
            ("theta0", "mu0"),
            between={"theta0": (0.02, 3.12), "mu0": (0.01, 1.0)},
            points=points,
        )
        angles, friction = np.degrees(found.values[:, 0]), found.values[:, 1]
        colour = BLUE if kind == "period_doubling" else VERMILION
        ax.plot(angles, friction, color=colour)
        write_along(ax, text, *position, color=colour)
        figure.tables[f"a_{name}"] = {
            "theta0_deg": angles,
            "mu0": friction,
            "period": found.periods,
        }
    folds = [
        {"theta0_deg": np.degrees(curve.theta0), "mu0": curve.mu0}
        for curve in ss.bifurcation_set(Parameters.article()).curves
    ]
    for table in folds:
        ax.plot(*table.values(), color=GREY, linewidth=0.9)
    fates = {"theta0_deg": list[float](), "mu0": list[float]()}
    for mu0 in frictions:
        p = Parameters.article(mu0=mu0)
        fold = np.radians(first_fold(p))
        with suppress(ConvergenceError):  # no dot if the fate is undecided
            fate = fate_boundary(
                p, "theta0", between={"theta0": (fold - np.radians(9.0), fold - 0.003)}
            )
            fates["theta0_deg"].append(np.degrees(fate.value))
            fates["mu0"].append(mu0)
    ax.plot(*fates.values(), "o", color=BLACK, markersize=3)
    angle_axis(ax, ylabel=r"$\mu_0$", ylim=(0, 1))
    return figure.describe(
        f"""Events in the plane of inclination and friction, {BASE_TEXT}, V = {V}, d = {D:g} (our
        assumption). Grey: folds of the equilibria, at μ₀. Blue: period doublings of the cycle of
        period 34; orange: its folds; each as far as it was followed. At 42° this cycle is stable
        for 0.096 < μ₀ < 0.320 and above 0.491. Dots: where the motion from rest at x = y = 0
        changes its fate, about 3° before the fold of the equilibria at every friction. Other
        cycles have curves of their own.""",
        a_statics=stacked(folds),
        a_fates=fates,
    )


@styled
def fate_map_figure(found: FateMap) -> Sheet:
    """Map of the fates of motions over two parameters: rest, cycles coloured by their period,
    chaos, lift-off; undecided ones are marked by crosses.
    """
    figure, ax = single(DOUBLE, 3.2)
    axes = draw_fate_map(found, ax)
    counts = ", ".join(f"{count} {name}" for name, count in found.count().items() if count)
    return figure.describe(
        f"""What the motion comes to by τ = {found.t_end:g}, over {" and ".join(axes)}: {counts}.
        Cycles, by their colour the period, and rest are found by Newton's method and attract by
        their multipliers or eigenvalues; chaos is told by the 95 % intervals of Lyapunov
        exponents, as far as the motion was followed; crosses are undecided, upright ones in colour
        with an exponent above its 95 % interval: irregular so far.""",
        a={found.model.column(name).heading: values for name, values in axes.items()}
        | {"kind": found.kind.ravel(), "period": found.period.ravel()},
    )


@styled
def draw_fate_map(found: FateMap, ax: Axes) -> dict[str, FloatArray]:
    """Draw :func:`fate_map_figure` on given axes; returns the values of both parameters in the
    units of the axes.
    """
    require_kind("found", found, FateMap, "one of ss.fate_map(...)")
    shape, model = found.kind.shape, found.model
    varied = [name for name, values in found.inputs.items() if values.size > 1]
    if len(varied) != 2 or found.kind.size != math.prod(found.inputs[name].size for name in varied):
        raise ParameterError(
            f"a map over {', '.join(varied) or 'nothing'}, of the shape {shape}, is not one "
            "over two parameters"
        )
    x, y = (
        model.column(name).size * np.broadcast_to(found.inputs[name], shape).ravel()
        for name in varied
    )
    kind = found.kind.ravel()
    # Colour and name of each fate except cycles.
    plain = {
        FateKind.REST: ("#d9d9d9", "rest"),
        FateKind.CHAOTIC: (VERMILION, "chaotic"),
        FateKind.LIFT_OFF: (SKY, "lift-off"),
        FateKind.UNDECIDED: ("white", "undecided"),
    }
    for code, (colour, name) in plain.items():
        cells(ax, (x, y), kind == code, colour, name)
    (image,) = cells(ax, (x, y), np.where(kind == FateKind.CYCLE, found.period.ravel(), np.nan))
    image.set_norm(LogNorm())
    undecided = kind == FateKind.UNDECIDED
    irregular = (found.exponent > found.exponent_error).ravel()
    for marker, colour, size, mask, name in (
        ("x", GREY, 3, undecided & ~irregular, "undecided so far"),
        ("+", VERMILION, 5, undecided & irregular, "irregular so far"),
    ):
        if mask.any():
            ax.plot(x[mask], y[mask], marker, color=colour, markersize=size, label=name)
    if (kind == FateKind.CYCLE).any():
        ax.figure.colorbar(image, ax=ax, label="period of the cycle", pad=0.02)
    if ax.get_legend_handles_labels()[1]:
        ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=4)
    ax.set(xlabel=label(model.column(varied[0])), ylabel=label(model.column(varied[1])))
    return dict(zip(varied, (x, y), strict=True))


def diagram_figure(found: Diagram) -> Sheet:
    """Bifurcation diagram, first coordinate over the parameter: equilibria in black, without
    contact in grey; maximum and minimum of cycles in colours.
    """
    figure, ax = single(DOUBLE, 3.6)
    figure.tables |= draw_diagram(found, ax)
    columns = {"label": "label", found.vary: "value", found.name: "height"}
    return figure.describe(
        f"""Equilibria (black; grey without contact) and cycles (colours, least and largest
        {found.name}) over {found.vary}: full where stable, dashed where not. LP folds and H Hopf
        points of equilibria; of cycles LPC folds, PD period doublings, NS tori, BPC crossings, HC
        homoclinic ends. Hatched: equilibria or Hopf points may be missing. Cycles are those that
        were followed from Hopf points, starts and doublings: there may be others.""",
        labels={
            title: np.array([getattr(one, name) for one in found.labels])
            for title, name in columns.items()
        },
    )


@styled
def draw_diagram(found: Diagram, ax: Axes) -> dict[str, Table]:
    """Draw :func:`diagram_figure` on given axes; returns tables of the drawn data."""
    require_kind("found", found, Diagram, "one of ss.diagram(...)")
    tables = dict[str, Table]()
    varied, height = map(found.model.column, (found.vary, found.name))
    for i, rest in enumerate(found.equilibria, 1):
        colour, states = BLACK if rest.mode == "contact" else GREY, rest.states[:, 0]
        x, y = varied.size * rest.values, height.size * states
        draw_stretches(ax, x, y, rest.stable, colour, 1.1)
        tables[f"equilibria_{i}"] = {
            found.vary: rest.values,
            found.name: states,
            "stable": rest.stable,
        }
    units = varied.size, height.size
    for i, branch in enumerate(found.cycles):
        colour = PALETTE[i % len(PALETTE)]
        for heights, height_of in (  # the state of a cycle is at its maximum
            (branch.highest, lambda cycle: cycle.state[0]),
            (branch.lowest, lambda cycle: cycle.state[0] - 2 * cycle.amplitude),
        ):
            draw_cycles(ax, branch, units, heights, height_of, colour)
        tables[f"cycles_{i + 1}"] = {
            found.vary: branch.values,
            "period": branch.periods,
            "lowest": branch.lowest,
            "highest": branch.highest,
            "stable": branch.stable,
        }
    shade(ax, found.model, found.vary, np.array(found.undecided).reshape(-1, 2))
    ax.set(
        xlim=[varied.size * end for end in found.to],
        xlabel=label(varied),
        ylabel=f"{label(height)}: rest, cycles from least to largest",
    )
    ax.margins(y=0.12)
    ax.autoscale_view()
    _draw_labels(ax, found.labels, units)
    if not (found.equilibria or found.cycles):
        say(ax, "no equilibria and no cycles found here")
    return tables


def _draw_labels(ax: Axes, labels: Iterable[Label], units: tuple[float, float]) -> None:
    """Mark the labels of a diagram, and write each unless one of the same kind is near."""
    to_axes = Affine2D(ax.transLimits.get_matrix())
    written = dict[str, list[tuple[float, float]]]()
    # Other labels are in the table only.
    markers = {"LP": "s", "H": "D", "LPC": "s", "PD": "o", "NS": "^", "BPC": "x", "HC": "*"}
    for one in labels:
        name, at = one.label, (units[0] * one.value, units[1] * one.height)
        if name not in markers:
            continue
        _mark(ax, at, markers[name], zorder=4, label=once(ax, name))
        x, y = to_axes.transform(at)
        same_kind = written.setdefault(name, [])
        # Distance as a share of the axes.
        if any(abs(x - left) + abs(y - low) < 0.04 for left, low in same_kind):
            continue
        same_kind.append((x, y))
        ax.annotate(name, at, _offset(one, (x, y)), textcoords="offset points", fontsize=7)


def _offset(label: Label, position: tuple[float, float]) -> tuple[float, float]:
    """Offset of the text of a label in points, so that it stays inside the axes."""
    if label.label == "H":
        return (-11.0, 5.0)
    x = -16.0 if position[0] > 0.93 else 4.0
    y = -10.0 if position[1] > 0.93 or label.of == "equilibria" else 4.0
    return x, y
