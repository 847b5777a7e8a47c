"""The oscillation: equilibria and cycles over θ₀, and the events of cycles in the plane of θ₀ and μ₀."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from ..assumed import D, V
from ..catastrophe import BifurcationSet, bifurcation_set, folds, sliding_friction
from ..cycles import CycleBranch, cycle, cycle_branch, cycle_events, fate_boundary
from ..parameters import FloatArray, Parameters
from ..statics.solver import Stability, equilibria
from .captions import BASE_TEXT
from .style import (
    BLACK,
    BLUE,
    DOUBLE,
    GREEN,
    GREY,
    ORANGE,
    PURPLE,
    VERMILION,
    Sheet,
    Table,
    angle_axis,
    panels,
    styled,
    write_along,
)

#: States near a cycle of each branch that 16 random starts at each of 22 inclinations came to: degrees, then x, y, x', y'.
SEEDS: dict[str, tuple[float, tuple[float, float, float, float]]] = {
    "34": (42.0, (2.538161566773, 3.361504868710, 0.0, 0.361278176249)),
    "165": (49.0, (3.178893595172, 2.120311377456, 0.0, 0.035253616447)),
    "130": (54.0, (3.09475195, 1.43390171, 0.0, 0.11289679)),
    "75": (80.0, (3.002656, 0.40497029, 0.0, 0.13983899)),
    "26": (90.0, (2.32939917, 1.34003954, 0.0, 0.25152749)),
}

#: |x| of one equilibrium changes by less than this from one inclination to the next.
LEAP = 0.1

#: Those whose doubled cycles are followed as well.
DOUBLED = ("34",)

_COLOURS = {"34": BLUE, "165": VERMILION, "130": GREEN, "75": PURPLE, "26": ORANGE}


def branches_of(seeds: tuple[str, ...], to_deg: tuple[float, float], points: int) -> dict[str, list[CycleBranch]]:
    """The branches through the seeds, each with those of the doubled cycles that begin on it."""
    found: dict[str, list[CycleBranch]] = {}
    low, high = np.radians(to_deg)
    for name in seeds:
        angle, state = SEEDS[name]
        first = cycle(Parameters.article(theta0=np.radians(angle)), V=V, d=D, near=state, patient=False)
        branch = cycle_branch(first, "theta0", (low, high), points=points)
        found[name] = [branch]
        for event in branch.of("period_doubling") if name in DOUBLED else ():
            found[name].append(cycle_branch(branch.switch(event), "theta0", (low, high), points=points))
    return found


@styled
def figure_cycles(
    *, seeds: tuple[str, ...] = tuple(SEEDS), to_deg: tuple[float, float] = (1.0, 179.0), points: int = 100
) -> Sheet:  # fmt: skip
    """Root mean square of x over θ₀, of equilibria and of cycles: what Figure 7b samples by one motion."""
    figure, ((ax,),) = panels(1, 1, DOUBLE, 3.2)
    tables: dict[str, Table] = {"a_equilibria": _draw_rest(ax, to_deg)}
    for name, family in branches_of(seeds, to_deg, points).items():
        for i, branch in enumerate(family):
            _draw_branch(ax, branch, _COLOURS[name], thin=i > 0)
            key = f"a_{name}" + (f"_doubled_{i}" if i else "")
            tables[key] = {
                "theta0_deg": np.degrees(branch.values), "period": branch.periods, "rms_x": branch.rms, "stable": branch.stable,
            }  # fmt: skip
            tables[key + "_events"] = {
                "kind": [event.kind for event in branch.events],
                "theta0_deg": [np.degrees(event.value) for event in branch.events],
                "how": [event.how for event in branch.events],
            }
    fold = float(np.degrees(folds(Parameters.article()).theta0[0]))
    sliding = float(np.degrees(folds(Parameters.article(mu0=sliding_friction(0.5, V, D))).theta0[0]))
    fate = fate_boundary(Parameters.article(), vary="theta0", bracket=(np.radians(41.0), np.radians(42.0)), V=V, d=D)
    rest = float(np.degrees(fate.value))
    for place, colour, style in ((rest, BLACK, "--"), (fold, GREY, ":"), (sliding, GREY, "-")):
        if to_deg[0] < place < to_deg[1]:
            ax.axvline(place, color=colour, linewidth=0.8, linestyle=style, zorder=0.5)
    if to_deg[1] - to_deg[0] > 120:
        angle_axis(ax)
    else:
        angle_axis(ax, *to_deg, step=1.0)
    ax.set(ylabel=r"RMS of $x$", ylim=(0, None))
    tables["a_lines"] = {"what": ["fate of rest", "fold at mu0", "fold at mu(V)"], "theta0_deg": [rest, fold, sliding]}
    return figure.describe(
        f"""Dynamic bifurcation diagram that Figure 7b samples, μ₀ = 0.5, {BASE_TEXT}, belt speed V = {V}, steepness
        d = {D:g} (our assumption). Black: equilibria at the friction μ(V), |x|; colours: cycles, root mean square of x about
        zero over one period; full where stable, equilibria by (27), dashed where not; thin: cycles that period doublings
        begin. Circles: period doublings; squares: folds of cycles; triangles: tori. Dashed vertical line: where the motion from
        rest changes its fate, {rest:.4f}°; dotted: the fold of the statics at μ₀, {fold:.4f}°; full: at μ(V), {sliding:.4f}°.
        Cycles were looked for from 16 random starts at each of 22 inclinations, and from doublings; they are not proved to be
        all.""",
        **tables,
    )


def _draw_rest(ax: Axes, to_deg: tuple[float, float]) -> Table:
    """Equilibria at μ(V): |x| is their root mean square."""
    angles = np.linspace(*to_deg, 1201)
    friction = sliding_friction(0.5, V, D)
    found = equilibria(Parameters.article(theta0=np.radians(angles), mu0=friction))
    size = np.abs(found.x)
    for kind, style in ((Stability.STABLE, "-"), (Stability.DIVERGENT, (0, (3.5, 1.6)))):
        for slot in range(size.shape[-1]):
            shown = np.where(found.stability[:, slot] == kind, size[:, slot], np.nan)
            # Beyond a fold the slots are others' states: no line from one to the next.
            shown[1:][np.abs(np.diff(size[:, slot])) > LEAP] = np.nan
            ax.plot(angles, shown, color=BLACK, linestyle=style, linewidth=1.0)
    return {"theta0_deg": np.repeat(angles, size.shape[-1]), "abs_x": size.ravel(), "stability": found.stability.ravel()}


def _draw_branch(ax: Axes, branch: CycleBranch, colour: str, *, thin: bool) -> None:
    angles, width = np.degrees(branch.values), 0.8 if thin else 1.4
    for wanted, style in ((True, "-"), (False, (0, (3, 1.5)))):
        ends = branch.stable == wanted
        shown = ends | np.append(False, ends[:-1] & ~ends[1:])
        ax.plot(np.where(shown, angles, np.nan), np.where(shown, branch.rms, np.nan), color=colour, linestyle=style,
                linewidth=width)  # fmt: skip
    for kind, marker in (("period_doubling", "o"), ("fold", "s"), ("torus", "^")):
        events = branch.of(kind)
        ax.plot([np.degrees(e.value) for e in events], [e.cycle.rms for e in events], marker, color=colour, markersize=3,
                markerfacecolor="white", linestyle="none")  # fmt: skip


@styled
def branch_figure(branch: CycleBranch) -> Sheet:
    """Root mean square of x and period along one branch."""
    figure, ((left, right),) = panels(1, 2, DOUBLE, 2.6)
    unit = np.degrees(1.0) if branch.vary == "theta0" else 1.0
    for ax, values, label in ((left, branch.rms, r"RMS of $x$"), (right, branch.periods, "period")):
        for wanted, style in ((True, "-"), (False, (0, (3, 1.5)))):
            ends = branch.stable == wanted
            shown = ends | np.append(False, ends[:-1] & ~ends[1:])
            ax.plot(np.where(shown, unit * branch.values, np.nan), np.where(shown, values, np.nan), color=BLUE, linestyle=style)
        ax.set(xlabel=r"$\theta_0$ (deg)" if branch.vary == "theta0" else branch.vary, ylabel=label)
    for kind, marker in (("period_doubling", "o"), ("fold", "s"), ("torus", "^"), ("grazing", "|")):
        for event in branch.of(kind):
            for ax, value in ((left, event.cycle.rms), (right, event.cycle.period)):
                ax.plot(unit * event.value, value, marker, color=BLACK, markersize=4, markerfacecolor="white")
    return figure.describe(
        "A branch of cycles: full where stable, dashed where not; circles are period doublings, squares folds, bars grazings.",
        a={branch.vary: branch.values, "rms_x": branch.rms, "stable": branch.stable},
        b={branch.vary: branch.values, "period": branch.periods},
    )


@styled
def figure_cycles_plane(
    *, points: int = 20, frictions: tuple[float, ...] = (0.45, 0.5, 0.55, 0.6),
    curves: tuple[str, ...] = ("fold", "period_doubling"),
) -> Sheet:  # fmt: skip
    """Events of the cycle of period 34, folds of the statics and fates of rest in the plane of θ₀ and μ₀."""
    figure, ((ax,),) = panels(1, 1, DOUBLE, 3.2)
    first = cycle(Parameters.article(theta0=np.radians(42.0)), V=V, d=D, near=SEEDS["34"][1], patient=False)
    branch = cycle_branch(first, "theta0", (np.radians(38.0), np.radians(72.0)))
    tables: dict[str, Table] = {}
    for kind, colour, label in (("period_doubling", BLUE, "period doubling"), ("fold", VERMILION, "fold of cycles")):
        if kind in curves:
            found = cycle_events(branch.of(kind)[0], ("theta0", "mu0"), to={"theta0": (0.05, 3.09), "mu0": (0.01, 1.0)},
                                 points=points)  # fmt: skip
            angles, friction = np.degrees(found.values[:, 0]), found.values[:, 1]
            ax.plot(angles, friction, color=colour)
            middle = len(angles) // 2
            write_along(ax, label, float(angles[middle]) + 4, float(friction[middle]) - 0.03, color=colour)
            tables[f"a_{kind}"] = {"theta0_deg": angles, "mu0": friction, "period": found.periods}
    still = bifurcation_set(Parameters.article())
    tables["a_statics"] = _draw_statics(ax, still)
    fates = []
    for mu0 in frictions:
        fold = float(folds(Parameters.article(mu0=mu0)).theta0[0])
        low = fold - np.radians(9.0)
        fates.append(fate_boundary(Parameters.article(mu0=mu0), vary="theta0", bracket=(low, fold - 0.003), V=V, d=D).value)
    ax.plot(np.degrees(fates), frictions, "o", color=BLACK, markersize=3)
    tables["a_fates"] = {"theta0_deg": np.degrees(fates), "mu0": np.array(frictions)}
    angle_axis(ax)
    ax.set(ylabel=r"$\mu_0$", ylim=(0, 1))
    words = {
        "period_doubling": "Blue: the period doubling of the cycle of period 34.",
        "fold": "Orange: its fold, where it ends.",
    }
    return figure.describe(
        f"""Events in the plane of inclination and friction, {BASE_TEXT}, V = {V}, d = {D:g} (our assumption). Grey: folds of the
        equilibria, at μ₀. {" ".join(words[kind] for kind in curves)} Dots: where the motion from rest at x = y = 0 changes its
        fate. Other cycles have curves of their own.""",
        **tables,
    )


def _draw_statics(ax: Axes, still: BifurcationSet) -> Table:
    columns: list[tuple[FloatArray, FloatArray]] = []
    for curve in still.curves:
        columns.append((np.degrees(curve.theta0), curve.mu0))
        ax.plot(*columns[-1], color=GREY, linewidth=0.9)
    return {"theta0_deg": np.concatenate([a for a, _ in columns]), "mu0": np.concatenate([b for _, b in columns])}


__all__ = ["branch_figure", "figure_cycles", "figure_cycles_plane"]
