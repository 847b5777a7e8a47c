"""The oscillation: equilibria and cycles over θ₀, and the events of cycles in the plane of θ₀ and μ₀."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from contextlib import suppress
from importlib import resources
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap, LogNorm
from matplotlib.patches import Patch

import spragsym as ss

from ..assumed import D, V
from ..errors import ConvergenceError, ParameterError
from ..models.parameters import FloatArray, Parameters
from ..numerics.interval_arrays import BoolArray
from ..orbits import Cycle, CycleBranch, FateMap, cycle, cycle_branch, cycle_events, fate_boundary
from ..orbits.fates import Kind
from .curves import branches, table_of
from .style import (
    BASE_TEXT,
    BLACK,
    BLUE,
    DOUBLE,
    GREEN,
    GREY,
    LINES,
    MODEL,
    ORANGE,
    PURPLE,
    SKY,
    VERMILION,
    Sheet,
    Table,
    angle_axis,
    label,
    line_at,
    panels,
    say,
    shown,
    single,
    stacked,
    styled,
    write_along,
)

if TYPE_CHECKING:
    from ..orbits.diagram import Diagram, Label

#: A state on the cycle of period 34 at 42 degrees.
ON_CYCLE = (2.538161566773, 3.361504868710, 0.0, 0.361278176249)

#: Of branches, in the order in which they were found; doubled ones have the colour of those that they come from.
COLOURS = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY)

#: Unstable cycles beyond this are left to the table.
HIGHEST = 2.15

#: A label stands this far above its curve.
LIFTED = 0.035

#: Doubled cycles are labelled if they are stable over more degrees than this.
WIDE = 10.0

#: Of events of cycles.
MARKERS = {"period_doubling": "o", "fold": "s", "torus": "^"}


def found_cycles() -> dict[str, Any]:
    """The branches that ``python -m validation.cycle_search`` found, with how they were looked for."""
    text = resources.files(__package__).joinpath("cycles.json").read_text(encoding="utf-8")
    found: dict[str, Any] = json.loads(text)
    for line in found["branches"]:
        line |= {name: np.array(line[name]) for name in ("theta0", "period", "rms", "stable")}
    return found


def _sliding() -> float:
    """μ(V) of the article's values."""
    return float(MODEL.friction(Parameters.article(V=V, d=D)))


@styled
def figure_cycles(*, to_deg: tuple[float, float] = (1.0, 179.0)) -> Sheet:
    """Root mean square of x over θ₀, of equilibria and of cycles: what Figure 7b samples by one motion."""
    figure, ax = single(DOUBLE, 4.2)
    tables: dict[str, Table] = {"a_equilibria": _draw_rest(ax, to_deg)}
    found = found_cycles()
    families = list(dict.fromkeys(line["name"].partition(",")[0] for line in found["branches"]))
    for line in found["branches"]:
        family, _, doubled = line["name"].partition(",")
        colour = COLOURS[families.index(family) % len(COLOURS)]
        angles = np.degrees(line["theta0"])
        stable = line["stable"] == 1
        draw_stretches(ax, angles, line["rms"], stable, colour, 0.9 if doubled else 1.4)
        value, period, *_ = line["at"]
        nearest = int(np.argmin(np.abs(line["theta0"] - value) + np.abs(line["period"] - period)))
        if to_deg[0] < np.degrees(value) < to_deg[1] and (not doubled or np.ptp(angles[stable]) > WIDE):
            write_along(
                ax,
                f"{period:.0f}",
                float(np.degrees(value)),
                line["rms"][nearest] + LIFTED,
                color=colour,
                ha="center",
                fontsize=7,
            )
        events = [event for event in line["events"] if event[0] in MARKERS]
        for kind, value, _, rms, _ in events:
            ax.plot(np.degrees(value), rms, MARKERS[kind], color=colour, markersize=3, markerfacecolor="white")
    tables["a_branches"] = stacked([
        {"branch": np.full(len(line["theta0"]), line["name"]), "theta0_deg": np.degrees(line["theta0"]),
         "period": line["period"], "rms_x": line["rms"], "stable": line["stable"]}
        for line in found["branches"]
    ])  # fmt: skip
    events = [(line["name"], *event) for line in found["branches"] for event in line["events"]]
    names = ("branch", "kind", "theta0_deg", "period", "rms_x", "how")
    tables["a_events"] = {
        name: np.degrees(column).tolist() if name == "theta0_deg" else list(column)
        for name, column in zip(names, zip(*events, strict=True), strict=True)
    }
    fold = float(np.degrees(ss.folds(Parameters.article()).theta0[0]))
    sliding = float(np.degrees(ss.folds(Parameters.article(mu0=_sliding())).theta0[0]))
    fate = fate_boundary(Parameters.article(), vary="theta0", bracket=(np.radians(41.0), np.radians(42.0)), V=V, d=D)
    rest = float(np.degrees(fate.value))
    for place, colour, style in ((rest, BLACK, "--"), (fold, GREY, ":"), (sliding, GREY, "-")):
        if to_deg[0] < place < to_deg[1]:
            line_at(ax, place, colour, 0.8, style=style, zorder=0.5)
    angle_axis(ax, *((0.0, 180.0, 30.0) if to_deg[1] - to_deg[0] > 120 else (*to_deg, 1.0)))
    ax.set(ylabel=r"RMS of $x$", ylim=(0, HIGHEST))
    tables["a_lines"] = {"what": ["fate of rest", "fold at mu0", "fold at mu(V)"], "theta0_deg": [rest, fold, sliding]}
    return figure.describe(
        f"""Dynamic bifurcation diagram that Figure 7b samples, μ₀ = 0.5, {BASE_TEXT}, belt speed V = {V}, steepness
        d = {D:g} (our assumption). Black: equilibria at the friction μ(V), |x|; colours: cycles, root mean square of x about
        zero over one period; full where stable, equilibria by (27), dashed where not; thin: cycles that period doublings
        begin. Circles: period doublings; squares: folds of cycles; triangles: tori. Dashed vertical line: where the motion from
        rest changes its fate, {rest:.4f}°; dotted: the fold of the statics at μ₀, {fold:.4f}°; full: at μ(V), {sliding:.4f}°.
        Cycles were looked for from {found["starts"]} starts at each of {len(found["inclinations_deg"])} inclinations, along
        their branches, and from stable doublings; they are not proved to be all, and branches that end in the open were not
        followed farther. Numbers: a period on the stable part. Some unstable cycles lie above the frame.""",
        **tables,
    )


def draw_stretches(
    ax: Axes, values: FloatArray, heights: FloatArray, stable: BoolArray, colour: str, width: float
) -> None:  # fmt: skip
    """A branch: full where stable, dashed where not, without a gap between."""
    for wanted, style in ((True, "-"), (False, (0, (3, 1.5)))):
        ends = stable == wanted
        shown = ends | np.append(False, ends[:-1] & ~ends[1:])
        ax.plot(np.where(shown, values, np.nan), np.where(shown, heights, np.nan), color=colour, linestyle=style, linewidth=width)


def draw_cycles(
    ax: Axes, branch: CycleBranch, unit: float, heights: FloatArray, height_of: Callable[[Cycle], float], colour: str
) -> None:
    """A branch of cycles by one of its columns, of which ``height_of`` is one cycle's: full as far as it is stable."""
    changes = list(branch.changes())
    at = np.repeat([place for place, _ in changes], 2).astype(int)
    values = np.insert(branch.values, at, np.repeat([event.value for _, event in changes], 2))
    curve = np.insert(heights, at, np.repeat([height_of(event.cycle) for _, event in changes], 2))
    stable = np.insert(branch.stable, at, [side for place, _ in changes for side in branch.stable[place - 1 : place + 1]])
    draw_stretches(ax, unit * values, curve, stable, colour, 1.3)


def _draw_rest(ax: Axes, to_deg: tuple[float, float]) -> Table:
    """Equilibria at μ(V): |x| is their root mean square."""
    curves = branches(Parameters.article(mu0=_sliding()), "theta0", *map(math.radians, to_deg))
    for curve in curves:
        ax.plot(curve.shown("theta0"), np.abs(curve.x), color=BLACK, linestyle=LINES[curve.stability], linewidth=1.0)
    return table_of(curves)


@styled
def branch_figure(branch: CycleBranch) -> Sheet:
    """Root mean square of the first coordinate and period along one branch."""
    figure, ((left, right),) = panels(1, 2, DOUBLE, 2.6)
    field = branch.cycles[0].field
    (along, unit), (first, one) = (shown(field, name) for name in (branch.vary, field.coordinates[0]))
    draw_cycles(left, branch, unit, one * branch.rms, lambda cycle: one * cycle.rms, BLUE)
    draw_cycles(right, branch, unit, branch.periods, lambda cycle: cycle.period, BLUE)
    left.set(xlabel=along, ylabel=f"RMS of {first}")
    right.set(xlabel=along, ylabel="period")
    for kind, marker in {**MARKERS, "grazing": "|"}.items():
        for event in branch.of(kind):
            for ax, value in ((left, one * event.cycle.rms), (right, event.cycle.period)):
                ax.plot(unit * event.value, value, marker, color=BLACK, markersize=4, markerfacecolor="white")
    return figure.describe(
        "A branch of cycles: full where stable, dashed where not; circles are period doublings, squares folds, bars grazings.",
        a={branch.vary: branch.values, f"rms_{field.coordinates[0]}": branch.rms, "stable": branch.stable},
        b={branch.vary: branch.values, "period": branch.periods},
    )


class _Curve(NamedTuple):
    """Where on a branch the event is from which a curve is followed, how far, and where its label stands."""

    vary: str
    kind: str
    nearest: float
    points: int
    label: str
    place: tuple[float, float]


#: Events of the cycle of period 34, from its branches at 42 degrees over the friction and at friction 0.5 over the angle.
CURVES = {
    "doubling": _Curve("mu0", "period_doubling", 0.49, 22, "period doubling", (5.0, 0.455)),
    "lower_doubling": _Curve("mu0", "period_doubling", 0.32, 25, "period doubling", (96.0, 0.43)),
    "fold": _Curve("theta0", "fold", np.radians(69.8), 20, "fold of cycles", (78.0, 0.515)),
    "lower_fold": _Curve("mu0", "fold", 0.096, 36, "fold of cycles", (20.0, 0.04)),
}


#: At which the fate of rest is looked for.
FRICTIONS = (0.3, 0.4, 0.5, 0.6, 0.7, 0.8)


def _along(vary: str) -> CycleBranch:
    """The branch of the cycle of period 34 from 42 degrees and friction 0.5."""
    first = cycle(Parameters.article(theta0=np.radians(42.0)), V=V, d=D, near=ON_CYCLE, patient=False)
    if vary == "theta0":
        return cycle_branch(first, vary, (np.radians(41.0), np.radians(72.0)))
    return cycle_branch(first, vary, (0.05, 0.5), points=90)


@styled
def figure_cycles_plane(
    *, frictions: tuple[float, ...] = FRICTIONS, curves: tuple[str, ...] = tuple(CURVES)
) -> Sheet:  # fmt: skip
    """Events of the cycle of period 34, folds of the statics and fates of rest in the plane of θ₀ and μ₀."""
    figure, ax = single(DOUBLE, 3.6)
    tables: dict[str, Table] = {}
    branches = {vary: _along(vary) for vary in dict.fromkeys(CURVES[name].vary for name in curves)}
    for name in curves:
        curve = CURVES[name]
        events = branches[curve.vary].of(curve.kind)
        event = events[int(np.argmin([abs(each.value - curve.nearest) for each in events]))]
        limits = {"theta0": (0.02, 3.12), "mu0": (0.01, 1.0)}
        found = cycle_events(event, ("theta0", "mu0"), to=limits, points=curve.points)
        angles, friction = np.degrees(found.values[:, 0]), found.values[:, 1]
        colour = BLUE if curve.kind == "period_doubling" else VERMILION
        ax.plot(angles, friction, color=colour)
        write_along(ax, curve.label, *curve.place, color=colour)
        tables[f"a_{name}"] = {"theta0_deg": angles, "mu0": friction, "period": found.periods}
    still = [{"theta0_deg": np.degrees(one.theta0), "mu0": one.mu0} for one in ss.bifurcation_set(Parameters.article()).curves]
    for folds in still:
        ax.plot(*folds.values(), color=GREY, linewidth=0.9)
    tables["a_statics"] = stacked(still)
    decided, fates = [], []
    for mu0 in frictions:
        fold = float(ss.folds(Parameters.article(mu0=mu0)).theta0[0])
        low = fold - np.radians(9.0)
        with suppress(ConvergenceError):  # where the motion is undecided by then, there is no dot
            fates.append(fate_boundary(Parameters.article(mu0=mu0), vary="theta0", bracket=(low, fold - 0.003), V=V, d=D).value)
            decided.append(mu0)
    ax.plot(np.degrees(fates), decided, "o", color=BLACK, markersize=3)
    tables["a_fates"] = {"theta0_deg": np.degrees(fates), "mu0": np.array(decided)}
    angle_axis(ax)
    ax.set(ylabel=r"$\mu_0$", ylim=(0, 1))
    return figure.describe(
        f"""Events in the plane of inclination and friction, {BASE_TEXT}, V = {V}, d = {D:g} (our assumption). Grey: folds of the
        equilibria, at μ₀. Blue: period doublings of the cycle of period 34; orange: its folds; each as far as it was followed.
        At 42° this cycle is stable for 0.096 < μ₀ < 0.320 and above 0.491. Dots: where the motion from rest at x = y = 0
        changes its fate, about 3° before the fold of the equilibria at every friction. Other cycles have curves of their own.""",
        **tables,
    )


#: Kinds of a map that have one colour, and its name.
PLAIN = {Kind.REST: ("#d9d9d9", "rest"), Kind.CHAOTIC: (VERMILION, "chaotic"), Kind.LIFT_OFF: (SKY, "lift-off"),
         Kind.UNDECIDED: ("white", "undecided")}  # fmt: skip


@styled
def fate_map_figure(found: FateMap) -> Sheet:
    """What motions come to over two parameters: rest, cycles coloured by their period, chaos, undecided ones with a cross."""
    shape, model = found.kind.shape, found.model
    varied = [name for name, values in found.inputs.items() if values.size > 1]
    if len(varied) != 2 or found.kind.size != math.prod(found.inputs[name].size for name in varied):
        raise ParameterError(f"a map over {', '.join(varied) or 'nothing'}, of the shape {shape}, is not one over two parameters")
    given = {name: np.degrees(found.inputs[name]) if name in model.about["angles"] else found.inputs[name] for name in varied}
    across, up = (np.unique(values) for values in given.values())
    order = np.lexsort([np.broadcast_to(values, shape).ravel() for values in given.values()])  # row by row
    kind, period, positive = (
        values.ravel()[order].reshape(up.size, across.size)
        for values in (found.kind, found.period, found.exponent > found.exponent_error)
    )
    figure, ax = single(DOUBLE, 3.2)
    for code, (colour, _) in PLAIN.items():
        ax.pcolormesh(across, up, np.where(kind == code, 1.0, np.nan), cmap=ListedColormap([colour]))
    image = ax.pcolormesh(across, up, np.where(kind == Kind.CYCLE, period, np.nan), cmap="viridis", norm=LogNorm())
    for marker, colour, irregular in (("x", GREY, False), ("+", VERMILION, True)):
        rows, columns = np.nonzero((kind == Kind.UNDECIDED) & (positive == irregular))
        ax.plot(across[columns], up[rows], marker, color=colour, markersize=3 + 2 * irregular, linestyle="none")
    if (kind == Kind.CYCLE).any():
        figure.colorbar(image, ax=ax, label="period of the cycle", pad=0.02)
    shown = [code for code in PLAIN if (kind == code).any()]
    patches = [Patch(facecolor=PLAIN[code][0], edgecolor=GREY, label=PLAIN[code][1]) for code in shown]
    ax.legend(handles=patches, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=len(patches), frameon=False)
    ax.set(xlabel=label(model, varied[0]), ylabel=label(model, varied[1]))
    counts = ", ".join(f"{count} {name}" for name, count in found.count().items() if count)
    return figure.describe(
        f"""What the motion comes to by τ = {found.t_end:g}, over {' and '.join(varied)}: {counts}. Cycles, by their colour the
        period, and rest are found by Newton's method and attract by their multipliers or eigenvalues; chaos is proved by Lyapunov
        exponents, as far as the motion was followed; crosses are undecided, upright
        ones in colour with an exponent above its 95 % interval: irregular so far.""",
        a={**{f"{name}_deg" if name in model.about["angles"] else name: column for name, column in
              zip(varied, (np.tile(across, up.size), np.repeat(up, across.size)), strict=True)},
           "kind": kind.ravel(), "period": period.ravel()},
    )  # fmt: skip


#: Of labels; those that are not here are left to the table.
LABEL_MARKERS = {"LP": "s", "H": "D", "LPC": "s", "PD": "o", "NS": "^", "BPC": "x", "HC": "*"}

#: Two labels of one kind nearer than this share of the frame are written once.
CLOSE = 0.04


def diagram_figure(found: Diagram) -> Sheet:
    """First coordinate over the parameter: equilibria black, lift-off grey; of cycles, in colours, the largest and the least."""
    figure, ax = single(DOUBLE, 3.6)
    (title, unit), (height, one) = (shown(found.model, name) for name in (found.vary, found.name))
    tables: dict[str, Table] = {}
    for i, rest in enumerate(found.equilibria):
        colour = BLACK if rest.mode == "contact" else GREY
        draw_stretches(ax, unit * rest.values, one * rest.states[:, 0], rest.stable, colour, 1.1)
        tables[f"equilibria_{i + 1}"] = {found.vary: rest.values, found.name: rest.states[:, 0], "stable": rest.stable}
    for i, branch in enumerate(found.cycles):
        colour = COLOURS[i % len(COLOURS)]
        draw_cycles(ax, branch, unit, one * branch.highest, lambda cycle: one * cycle.state[0], colour)
        draw_cycles(ax, branch, unit, one * branch.lowest, lambda cycle: one * (cycle.state[0] - 2 * cycle.amplitude), colour)
        tables[f"cycles_{i + 1}"] = {
            found.vary: branch.values, "period": branch.periods, "lowest": branch.lowest, "highest": branch.highest,
            "stable": branch.stable,
        }  # fmt: skip
    ax.set(xlim=(unit * found.to[0], unit * found.to[1]))
    ax.set(xlabel=title, ylabel=f"{height}: rest, cycles from least to largest")
    ax.margins(y=0.12)
    named: list[tuple[str, float, float]] = []
    low, high = ax.get_ylim()
    for one_label in found.labels:
        if one_label.label not in LABEL_MARKERS:
            continue
        at = unit * one_label.value, one * one_label.height
        ax.plot(*at, LABEL_MARKERS[one_label.label], color=BLACK, markersize=4, markerfacecolor="white", zorder=4)
        place = ((one_label.value - found.to[0]) / (found.to[1] - found.to[0]), (at[1] - low) / (high - low))
        if any(name == one_label.label and abs(place[0] - x) + abs(place[1] - y) < CLOSE for name, x, y in named):
            continue
        named.append((one_label.label, *place))
        ax.annotate(one_label.label, at, xytext=_aside(one_label, place), textcoords="offset points", fontsize=7)
    if not (found.equilibria or found.cycles):
        say(ax, "no equilibria and no cycles found here")
    tables["labels"] = {
        "label": np.array([label.label for label in found.labels]), found.vary: np.array([label.value for label in found.labels]),
        found.name: np.array([label.height for label in found.labels]),
    }  # fmt: skip
    return figure.describe(
        f"""Equilibria (black; grey without contact) and cycles (colours, least and largest {found.name}) over {found.vary}: full
        where stable, dashed where not. LP folds and H Hopf points of equilibria; of cycles LPC folds, PD period doublings, NS
        tori, BPC crossings, HC homoclinic ends. Cycles are those that were followed from Hopf points, starts and doublings: there
        may be others.""",
        **tables,
    )


def _aside(label: Label, place: tuple[float, float]) -> tuple[float, float]:
    """Where the text of a label stands, in points: inside of the frame."""
    if label.label == "H":
        return (-11.0, 5.0)
    return (-16.0 if place[0] > 0.93 else 4.0, -10.0 if place[1] > 0.93 or label.of == "equilibria" else 4.0)
