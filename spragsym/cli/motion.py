"""``spragsym simulate``, ``sweep``, ``fates`` and ``cycles``: motions, over a grid too, their
fates, and periodic orbits.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

import spragsym as ss

from ..core.errors import ConvergenceError, ParameterError
from ..core.progress import show_progress
from ..display import own_name
from ..models.model import Touching, label_of
from ..models.parameters import FloatArray, ParameterSet
from ..numerics.interval_arrays import Int8Array
from . import options as o
from .case import Case, Row
from .output import drawn, is_typed, print_rows, refuse, resumed

if TYPE_CHECKING:
    from ..orbits import Cycle
    from ..orbits.branch import CycleBranch
    from ..orbits.diagram import EquilibriumBranch


@o.of_model(start=True)
@o.t_end
@o.transient
@o.rtol
@o.backend("heyoka", "compiled", "scipy")
@click.option(
    "--error",
    "estimate_error",
    is_flag=True,
    help="Estimate the error by a second run at a tighter tolerance.",
)
@o.file("--output", "-o", folder=True, help="Write the motion to FILE.nc or FILE.csv.")
@o.plot("the motion")
@o.force
@o.as_json
def simulate(
    case: Case,
    t_end: float,
    transient: float | None,
    output: Path | None,
    plot: Path | None,
    **settings: Any,
) -> object:
    """Integrate the motion from an initial state, by default from rest where all coordinates are 0.

    The article states neither the belt speed V nor the steepness d of the friction law: the
    defaults are an assumption. With --data, --t-end and --transient are in seconds, and the initial
    state in the file's units.

    \b
    Examples:
      spragsym simulate --theta0 49
      spragsym simulate --data brake.toml --t-end 0.5
      spragsym simulate --theta0 49 -V 0.2 --error -o run.nc
      spragsym simulate --model trolley --theta0 49
    """
    from ..files import storage

    p, (t_end, transient) = case.set(), _times(case, t_end, transient, "all of a motion is kept")
    refuse([output])
    if output is not None:
        storage.check_target(output, 10_000_000)
    with show_progress("following the motion"):
        tr: Any = ss.simulate(p, t_end=t_end, **case.start, **settings)
    late, first = tr.after(transient), tr.components[0]
    summary = case.row(
        {
            "rms": late.rms(0.0, of=first),
            "rms_about_mean": late.rms(0.0, of=first, about="mean"),
            "mean": late.mean(0.0, of=first),
            "largest": late.largest(0.0, of=first),
            "period": late.period(0.0),
            "converged": late.converged(0.0),
            **{kind.name.lower(): len(tr.events.of(kind)) for kind in ss.Event},
            "backend": tr.backend,
            **({} if tr.error is None else {"error": tr.error.max()}),
        },
        ss.results.Trajectory,
    )
    if output is not None:
        tr.save(output)

    units = None if case.study is None else case.study.scales
    drawn(plot, "drawing the motion", lambda: ss.figures.motion_figure(tr, transient, units))

    return summary, lambda: _print_summary(case, summary)


def _times(case: Case, t_end: float, transient: float | None, why: str) -> tuple[float, float]:
    """The end of a motion, and the time from which it is measured, in the model's unit of time.

    With a file they are typed in seconds. ``why`` says in an error why the motion can't be longer.
    """
    seconds_per_unit, of_file = case.time, case.study is not None
    t_end = t_end / seconds_per_unit if is_typed("t_end") else t_end
    transient = 0.75 * t_end if transient is None else transient / seconds_per_unit
    if transient >= t_end:
        begins, ends = (
            f"{value * seconds_per_unit:.9g}{' s' * of_file}" for value in (transient, t_end)
        )
        raise ParameterError(
            f"--transient = {begins} is not below --t-end = {ends}; nothing would be left to "
            "measure"
        )
    unit = case.model.about["scales"]["time"].replace("**", "^")
    longest = 2e6  # in the model's unit of time
    if t_end > longest:
        limit = f"{longest:g} {unit}" + (
            f", which is {longest * seconds_per_unit:.3g} s" if of_file else ""
        )
        raise ParameterError(f"--t-end is {t_end:g} {unit}, and {why}: give at most {limit}")
    return t_end, transient


@o.of_model(kind=o.NumberList, start=True)
@o.t_end
@o.transient
@o.rtol
@o.backend("heyoka", "compiled", "scipy")
@o.workers(1)
@o.quiet
@o.file("--output", "-o", "store", folder=True, required=True, help="FILE.nc or FILE.csv.")
@o.force
def sweep(
    case: Case, t_end: float, transient: float | None, quiet: bool, store: Path, **settings: Any
) -> None:
    """Simulate over a grid of parameters, to a file.

    Every option that takes numbers is an axis: a single number, a,b,c, or start:stop:count. The
    grid is all combinations. Killed or interrupted, the same command goes on where it stopped;
    finished, it reads the file. The file holds theta0 in radians, and in degrees as theta0_deg.
    With --data it holds columns in the units of that file, as rms_mm, and beside it stands what it
    is made from, in those of the model, as FILE.model.nc.

    \b
    Examples:
      spragsym sweep --theta0 30:60:61 -o rms.nc
      spragsym sweep --theta0 30:60:61 -V 0.2,0.5,1 -j 2 -o rms.csv
      spragsym sweep --data brake.toml --theta0 40:60:21 -o rms.nc
      spragsym sweep --model stribeck --theta0 30:60:61 -o rms.nc
    """
    from ..motion.sweeps import Regime

    case.require(case.values)
    t_end, transient = _times(
        case, t_end, transient, "each motion of a sweep is followed to its end"
    )
    p, start = _grid(case)
    own = _resumed_from(case, store)
    with resumed():
        options = {
            **start,
            **settings,
            "t_end": t_end,
            "transient": transient,
            "progress": not quiet,
            "store": own,
        }
        result = ss.rms_sweep(p, **options)
    if case.study is not None:
        result.to_units(case.study).save(store)
    counts = {regime.name.lower(): np.count_nonzero(result.regime == regime) for regime in Regime}
    click.echo(
        f"{store}: " + ", ".join(f"{count} {name}" for name, count in counts.items() if count)
    )


def _resumed_from(case: Case, store: Path) -> Path:
    """The file, in units of the model, from which the same command goes on: beside the one in units
    of the data, if there are such.
    """
    if case.study is None:
        return store
    own = store.with_suffix(f".model{store.suffix}")
    if not own.exists():
        refuse([store])
    return own


def _grid(case: Case) -> tuple[Any, dict[str, FloatArray]]:
    """The parameters and the initial state; every option with several numbers has an axis of its
    own, so that they broadcast to the grid.
    """
    axes = {**case.values, **case.start}
    long = [name for name, axis in axes.items() if np.size(axis) > 1]
    axes |= dict(zip(long, np.ix_(*(axes[name] for name in long)), strict=True))
    return case.model.Parameters(**{name: axes.pop(name) for name in case.values}), axes


@o.of_model(kind=o.NumberList, start=True)
@click.option(
    "--t-end",
    type=float,
    help="How long to follow it, with --data in seconds; 40,000 units of its time if left out. "
    "Exponents come after.",
)
@o.backend("heyoka", "scipy")
@o.workers(1)
@o.quiet
@o.file("--output", "-o", "store", folder=True, required=True, help="FILE.csv.")
@o.plot("the map")
@o.force
def fates(
    case: Case, t_end: float | None, quiet: bool, store: Path, plot: Path | None, **settings: Any
) -> None:
    """Fates of motions: rest, a cycle, chaos, lift-off, or undecided, and why.

    Every parameter is an axis: a single number, a,b,c, or start:stop:count; a picture is of two
    that vary. Killed or interrupted, the same command goes on where it stopped; finished, it reads
    the file. With --data it holds columns in the units of that file, and beside it stands what it
    is made from, in those of the model, as FILE.model.csv; what its column why says is in those of
    the model, too.

    \b
    Examples:
      spragsym fates --theta0 10:170:21 --mu0 0.1:1:10 -V 0.25 -o fates.csv --plot fates.pdf
    """
    from ..orbits import fate_map

    case.require(case.values)
    many = [name for name, values in case.values.items() if np.size(values) > 1]
    if plot is not None and len(many) != 2:
        raise ParameterError(
            f"--plot {plot}: it draws a map over two parameters that vary; give two of them "
            "several values"
        )
    p, start = _grid(case)
    begin = [float(value) for value in start.values()]
    own = _resumed_from(case, store)
    t_end = None if t_end is None else t_end / case.time
    with resumed():
        found = fate_map(p, t_end=t_end, start=begin, progress=not quiet, store=own, **settings)
    if case.study is not None:
        found.to_units(case.study).save(store)
    drawn(plot, "drawing the map", found.plot, lambda: [[*map(case.axis, many)]])
    click.echo(
        f"{store}: "
        + ", ".join(f"{count} {name}" for name, count in found.count().items() if count)
    )


@o.of_model(spanned=0)
@click.option(
    "--near",
    type=o.NumberList(),
    metavar="{state}",
    help="A state near the cycle, angles in degrees. Default: the motion from rest at 0.",
)
@o.vary(
    "Follow the cycle as this varies, with a range as theta0=38:60; with --data a quantity of "
    "the file too."
)
@click.option("--points", type=click.IntRange(1), default=200, help="Most points each way.")
@click.option(
    "--diagram",
    "diagram",
    is_flag=True,
    help="Equilibria too, and cycles from Hopf points and doublings; with --vary.",
)
@click.option("--prove", is_flag=True, help="Prove the cycle in ball arithmetic: a minute.")
@click.option(
    "--digits",
    type=click.IntRange(1),
    help="Digits of that proof; more of them prove what repels strongly.",
)
@click.option("--sound", is_flag=True, help="Levels of the surface's speed in dB too; with --data.")
@o.plot("the branch")
@o.force
@o.as_json
def cycles(
    case: Case,
    near: float | FloatArray | None,
    points: int,
    diagram: bool,
    prove: bool,
    digits: int | None,
    sound: bool,
    plot: Path | None,
) -> object:
    """A cycle of the motion with its multipliers; with --vary, a branch of cycles with its
    bifurcations.

    The article states neither the belt speed V nor the steepness d of the friction law: the
    defaults are an assumption. A parameter that varies begins at the first end of its range, where
    it has no value of its own.

    \b
    Examples:
      spragsym cycles --theta0 42
      spragsym cycles --data brake.toml --sound
      spragsym cycles --theta0 42 --vary theta0=38:60 --plot branch.pdf
      spragsym cycles --theta0 42 --vary theta0=30:80 --diagram --plot all.pdf
      spragsym cycles --model stick_slip -V 0.2 --vary V=0.08:0.3
    """
    along = case.span if case.spans else None
    if plot is not None and along is None:
        raise ParameterError(f"--plot {plot}: it draws a branch, so it needs --vary")
    if along is not None:
        case.require_ends()
    if diagram and (along is None or prove):
        raise click.UsageError("--diagram goes with --vary, and without --prove")
    if digits is not None and not prove:
        raise click.UsageError("--digits goes with --prove")
    if sound and case.study is None:
        raise click.UsageError("--sound needs metres and seconds: give --data FILE")
    names = case.model.components
    # A state is printed in the units in which it is typed.
    factors = np.array([case.of(name)[1] for name in names])
    if near is not None and np.size(near) != len(names):
        raise ParameterError(
            f"--near has {np.size(near)} numbers, and a state {len(names)}: {', '.join(names)}"
        )
    start = None if near is None else near / factors
    changes = {}
    if along and along.ends and case.values[along.name] is None:
        changes[along.name] = along.ends[0]
    p = case.set(**changes)
    if diagram:
        return _diagram(case, p, [] if start is None else [start], points, plot)
    try:
        with show_progress("looking for a cycle"):
            found = ss.cycle(p, start)
    except ConvergenceError as error:
        raise ConvergenceError(*case.said(error.args)) from error
    summary: Row = case.row(
        {
            **{each.name: each.value(found) for each in found.schema},
            "stable": found.stable,
            "state": found.state * factors,
            "multipliers": found.multipliers,
            **found.forces,
            "crossings": len(found.events),
            "backend": found.backend,
        },
        type(found),
    )
    modes = found.phases
    slips = {1: "belt ahead", -1: "mass ahead", 0: "sticks"}
    if not case.model.frictions:
        slips = {1: "none"}
    phases = case.rows(
        {"t": modes.t, "duration": modes.duration},
        type(modes),
        state=[_touching(case, held) for held in modes.contact.reshape(len(modes.t), -1)],
        slip=[
            ", ".join(slips[side] for side in sides)
            for sides in modes.side.reshape(len(modes.t), -1).tolist()
        ],
    )
    if prove:
        from .. import precise

        with show_progress("proving it"):
            proof = precise.prove_cycle(found, **({} if digits is None else {"digits": digits}))
        summary["proved"] = proof.proved
        if proof.proved:
            summary |= {
                f"{name}_proved": str(decimal) for name, decimal in proof.decimals().items()
            }
            summary["stable_proved"] = proof.stable
        else:
            summary["reason"] = proof.reason
    branch = {} if along is None else _branch(case, found, points, plot)
    levels: dict[str, Any] = {}
    if sound and case.study is not None:
        from ..report.sound import surface_levels

        levels["sound"] = surface_levels(case.study, found)

    def tables() -> None:
        _print_summary(case, summary)
        for title, rows in {"phases": phases, **levels, **branch}.items():
            print_rows(title.rpartition("_")[2].capitalize(), rows, formats=case.formats)

    return {**summary, "phases": phases, **levels, **branch}, tables


def _diagram(
    case: Case, p: ParameterSet, starts: list[Any], points: int, plot: Path | None
) -> object:
    """Equilibria and cycles over a parameter: branches, labelled points, and the figure."""
    from ..orbits.diagram import diagram

    along = case.span
    unit, title = along.unit, along.title
    with show_progress(f"equilibria and cycles along {along.name}"):
        found = diagram(
            p,
            along.name,
            between={along.name: case.between[along.name]},
            starts=starts,
            points=points,
        )
    up = ": rest, cycles from least to largest"
    drawn(
        plot,
        "drawing the diagram",
        found.plot,
        lambda: [(case.axis(found.vary), case.axis(found.name, after=up))],
    )
    labels = [
        {
            "label": label.label,
            title: unit * label.value,
            found.name: label.height,
            "of": label.of,
            "branch": label.branch,
        }
        for label in found.labels
    ]

    def row(of: str, number: int, branch: CycleBranch | EquilibriumBranch, ends: str) -> Row:
        return {
            "of": of,
            "branch": number,
            "points": len(branch.values),
            "from": unit * branch.values[0],
            "to": unit * branch.values[-1],
            "stable": int(branch.stable.sum()),
            "ends": ends,
        }

    branches = [
        row("equilibria", i, branch, branch.mode) for i, branch in enumerate(found.equilibria)
    ]
    for i, branch in enumerate(found.cycles):
        branches.append(
            row(
                "cycles",
                i,
                branch,
                "; ".join(
                    case.said(
                        end.how for end in branch.of("end", "homoclinic", "catastrophic-sliding")
                    )
                ),
            )
        )
    remarks = case.said(found.remarks)

    def tables() -> None:
        print_rows("Branches", branches)
        print_rows("Labels", labels)
        for remark in remarks:
            click.echo(remark)

    return {"labels": labels, "branches": branches, "remarks": remarks}, tables


def _branch(case: Case, found: Cycle, points: int, plot: Path | None) -> Row:
    """The branch of a cycle within a range, which must hold the cycle, and its events."""
    from ..orbits import cycle_branch

    along = case.span
    unit, (low, high), value = along.unit, case.between[along.name], found.parameters[along.name]
    if not low <= value <= high:
        raise ParameterError(
            f"--vary {along.title}: the range from {unit * low:.10g} to {unit * high:.10g} "
            "does not hold the cycle's own "
            f"{unit * value:.10g}; give one that does"
        )
    with show_progress(f"following cycles along {along.name}"):
        branch = cycle_branch(found, along.name, between={along.name: (low, high)}, points=points)
    period = None if case.study is None else ("period (s)", case.time)
    first = case.model.coordinates[0]
    drawn(
        plot,
        "drawing the branch",
        branch.plot,
        lambda: [(case.axis(along.name), up) for up in (case.axis(first, "RMS of "), period)],
    )
    events, own = branch.events, partial(own_name, case.model)
    return {
        "branch": case.rows(branch.data(), type(branch)),
        "branch_events": case.rows(
            {
                own("kind"): [event.kind for event in events],
                along.name: [event.value for event in events],
            },
            error=[unit * event.error for event in events],
            **case.row({own("period"): [event.cycle.period for event in events]}, type(found)),
            how=case.said(event.how for event in events),
        ),
    }


def _touching(case: Case, indicators: Int8Array) -> str:
    """The touching contacts in words; ``indicators`` has 1 for each contact that touches."""
    contacts = zip(case.model.contacts, indicators.tolist(), strict=True)
    opening = {label_of(entry): touches for entry, touches in contacts if entry["border"]}
    touching = tuple(name for name, touches in opening.items() if touches)
    regime: Touching = len(touching) == len(opening) or (touching or False)
    return "contact" if regime is True else case.model.regimes[regime]


def _print_summary(case: Case, summary: Row) -> None:
    rows = {"model": case.model.name, **summary}
    print_rows("", [{"": name, " ": _shown(value)} for name, value in rows.items()])


def _shown(value: object) -> object:
    """A cell of a table: numbers with twelve digits, lists with ten, complex numbers as a+bi."""
    if isinstance(value, float):
        return f"{value:.12g}"
    return "  ".join(_number(item) for item in value) if isinstance(value, list) else value


def _number(item: object) -> str:
    real, imaginary = item if isinstance(item, list) else (item, 0.0)
    return f"{real:.10g}" + (f"{imaginary:+.10g}i" if imaginary else "")
