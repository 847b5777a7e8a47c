"""``spragsym cycles``: a cycle of the motion, and branches of cycles over a parameter."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import spragsym as ss

from ..errors import ParameterError
from ..progress import show_progress
from . import options as o
from .of_model import Case, of_model
from .output import drawn, print_rows, print_table

if TYPE_CHECKING:
    from ..models.parameters import ParameterSet
    from ..orbits import Cycle, CycleBranch


@of_model(spanned=0)
@click.option("--near", metavar="{state}", help="A state near the cycle, angles in degrees. Default: the motion from rest at 0.")
@o.vary("Follow the cycle as this varies, with a range as theta0=38:60; with --data a quantity of the file too.")
@click.option("--points", type=click.IntRange(1), default=200, help="Most points each way.")
@click.option("--diagram", "whole", is_flag=True, help="Equilibria too, and cycles from Hopf points and doublings; with --vary.")
@click.option("--prove", is_flag=True, help="Prove the cycle in ball arithmetic: a minute.")
@click.option("--digits", type=click.IntRange(1), help="Digits of that proof; more of them prove what repels strongly.")
@o.plot("the branch")
@o.force
@o.as_json
def cycles(
    case: Case, near: str | None, points: int, whole: bool, prove: bool, digits: int | None, plot: Path | None
) -> Any:  # fmt: skip
    """A cycle of the motion with its multipliers; with --vary, a branch of cycles with its bifurcations.

    The article states neither the belt speed V nor the steepness d of the friction law: the defaults are an
    assumption. A parameter that varies begins at the first end of its range, where it has no value of its own.

    \b
    Examples:
      spragsym cycles --theta0 42
      spragsym cycles --data brake.toml
      spragsym cycles --theta0 42 --vary theta0=38:60 --plot branch.pdf
      spragsym cycles --theta0 42 --near 2.54,3.36,0,0.36 --vary theta0=30:80 --diagram --plot all.pdf
      spragsym cycles --model stick_slip -V 0.2 --vary V=0.08:0.3
    """
    along = case.span if case.spans else None
    if plot is not None and along is None:
        raise ParameterError(f"--plot {plot}: it draws a branch, so it needs --vary")
    if along is not None:
        case.require_ends()
    if whole and (along is None or prove):
        raise click.UsageError("--diagram goes with --vary, and without --prove")
    if digits is not None and not prove:
        raise click.UsageError("--digits goes with --prove")
    start = None if near is None else _state(near, case)
    p = case.set(**({along.name: along.ends[0]} if along and along.ends and case.values[along.name] is None else {}))
    if whole:
        return _diagram(case, p, [] if start is None else [start], points, plot)
    with show_progress("looking for a cycle"):
        found = ss.cycle(p, start)
    summary: dict[str, Any] = case.row({
        "period": found.period, "stable": found.stable, "state": None, "multipliers": found.multipliers, "error": found.error,
        "residual": found.residual, "rms": found.rms, "mean": found.mean, "amplitude": found.amplitude, **found.forces,
        "crossings": len(found.events), "backend": found.backend,
    })  # fmt: skip
    # As --near takes it.
    summary["state"] = [value * one for value, one in zip(found.state.tolist(), _ones(case), strict=True)]
    if prove:
        with show_progress("proving it"):
            summary |= _proof(found, {} if digits is None else {"digits": digits})
    branch = {} if along is None else _branch(case, found, points, plot)

    def tables() -> None:
        print_table("", ("", ""), [(name, _shown(value)) for name, value in {"model": case.model.name, **summary}.items()])
        for key, title in (("branch", "Branch"), ("branch_events", "Events")):
            if along is not None:
                print_rows(title, branch[key])

    return {**summary, **branch}, tables


def _diagram(case: Case, p: ParameterSet, starts: list[Any], points: int, plot: Path | None) -> Any:
    """Equilibria and cycles over a parameter: the labelled points, and the figure."""
    from ..orbits.diagram import diagram

    along = case.span
    unit, title = along.unit, along.title
    with show_progress(f"equilibria and cycles along {along.name}"):
        found = diagram(p, along.name, along.between[along.name], starts=starts, points=points)
    if plot is not None:
        from ..figures import diagram_figure

        first = case.axis(found.name, after=": rest, cycles from least to largest")
        drawn(plot, "drawing the diagram", lambda: diagram_figure(found), [(case.axis(found.vary), first)])
    labels = [
        {"label": label.label, title: unit * label.value, found.name: label.height, "of": label.of, "branch": label.branch}
        for label in found.labels
    ]
    ends = [branch.mode for branch in found.equilibria]
    ends += ["; ".join(case.said(end.how for end in branch.of("end", "homoclinic"))) for branch in found.cycles]
    every: Mapping[str, Sequence[Any]] = {"equilibria": found.equilibria, "cycles": found.cycles}
    kinds = [(of, i, one) for of, those in every.items() for i, one in enumerate(those)]
    branches = [
        {"of": of, "branch": i, "points": len(one.values), "from": unit * one.values[0], "to": unit * one.values[-1],
         "stable": int(one.stable.sum()), "ends": end}
        for (of, i, one), end in zip(kinds, ends, strict=True)
    ]  # fmt: skip
    remarks = case.said(found.remarks)

    def tables() -> None:
        print_rows("Branches", branches)
        print_rows("Labels", labels)
        for remark in remarks:
            click.echo(remark)

    return {"labels": labels, "branches": branches, "remarks": remarks}, tables


def _proof(found: Cycle, asked: dict[str, int]) -> dict[str, Any]:
    from .. import precise

    proof = precise.prove_cycle(found, **asked)
    if not proof.proved:
        return {"proved": False, "reason": proof.reason}
    decimals = {f"{name}_proved": str(decimal) for name, decimal in proof.decimals().items()}
    return {"proved": True, **decimals, "stable_proved": proof.stable}


def _state(text: str, case: Case) -> list[float]:
    names = (*case.model.coordinates, *case.model.rates)
    try:
        numbers = [float(part) for part in text.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) != len(names):
        raise ParameterError(f"--near {text!r} is not {len(names)} numbers with commas, {', '.join(names)}")
    return [number / one for number, one in zip(numbers, _ones(case), strict=True)]


def _ones(case: Case) -> list[float]:
    """What one of each component of a state is where it is typed, and where it is printed to be typed again."""
    return [case.state(name) for name in (*case.model.coordinates, *case.model.rates)]


def _branch(case: Case, found: Cycle, points: int, plot: Path | None) -> dict[str, Any]:
    """The branch of a cycle within a range, which must hold the cycle itself, and what happens on it."""
    from ..orbits import cycle_branch

    along = case.span
    unit, (low, high), value = along.unit, along.between[along.name], found.parameters[along.name]
    if not low <= value <= high:
        raise ParameterError(
            f"--vary {along.title}: the range from {unit * low:.10g} to {unit * high:.10g} does not hold the cycle's own "
            f"{unit * value:.10g}; give one that does"
        )
    with show_progress(f"following cycles along {along.name}"):
        branch = cycle_branch(found, along.name, (low, high), points=points)
    if plot is not None:
        _draw(case, branch, plot)
    events = branch.events
    columns = {along.name: branch.values, "period": branch.periods, "rms": branch.rms, "stable": branch.stable}
    return {
        "branch": case.rows(columns),
        "branch_events": case.rows(
            {"kind": [event.kind for event in events], along.name: [event.value for event in events]},
            error=[unit * event.error for event in events], **case.row({"period": [event.cycle.period for event in events]}),
            how=case.said(event.how for event in events),
        ),
    }  # fmt: skip


def _draw(case: Case, branch: CycleBranch, path: Path) -> None:
    from ..figures import branch_figure

    along, period = case.axis(branch.vary), None if case.study is None else ("period (s)", case.time)
    axes = [(along, case.axis(case.model.coordinates[0], "RMS of ")), (along, period)]
    drawn(path, "drawing the branch", lambda: branch_figure(branch), axes)


def _shown(value: Any) -> Any:
    """Numbers to twelve digits; multipliers as a+bi."""
    if isinstance(value, float):
        return f"{value:.12g}"
    return "  ".join(_number(item) for item in value) if isinstance(value, list) else value


def _number(item: Any) -> str:
    real, imaginary = item if isinstance(item, list) else (item, 0.0)
    return f"{real:.10g}" + (f"{imaginary:+.10g}i" if imaginary else "")
