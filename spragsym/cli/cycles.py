"""``spragsym cycles``: a cycle, or a branch of them over a parameter."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import spragsym as ss

from ..errors import ParameterError
from ..progress import show_progress
from .drawings import written
from .of_model import Case, of_model
from .options import as_json
from .spans import Span, Typed, span, vary
from .tables import print_json, print_table
from .targets import force, refuse

if TYPE_CHECKING:
    from ..models.parameters import ParameterSet
    from ..orbits import Cycle, CycleBranch


@of_model()
@click.option("--near", metavar="{state}", help="A state near the cycle, angles in degrees. Default: the motion from rest at 0.")
@vary("Follow the cycle as this varies, with a range as theta0=38:60; with --data a quantity of the file too.")
@click.option("--points", type=click.IntRange(1), default=200, show_default=True, help="Most points each way.")
@click.option("--diagram", "whole", is_flag=True, help="Equilibria too, and cycles from Hopf points and doublings; with --vary.")
@click.option("--prove", is_flag=True, help="Prove the cycle in ball arithmetic: a minute.")
@click.option("--digits", type=click.IntRange(1), help="Digits of that proof; more of them prove what repels strongly.")
@click.option("--plot", type=click.Path(dir_okay=False, path_type=Path), metavar="FILE", help="Draw the branch (pdf, png, svg).")
@force
@as_json
def cycles(
    case: Case, near: str | None, vary: Typed | None, points: int, whole: bool, prove: bool, digits: int | None,
    plot: Path | None, force: bool, json_output: bool,
) -> None:  # fmt: skip
    """A cycle of the motion with its multipliers; with --vary, a branch of cycles with the events on it.

    The article states neither the belt speed V nor the steepness d of the friction law: the defaults are an
    assumption. A parameter that varies begins at the first end of its range, where it has no value of its own.

    \b
    Examples:
      spragsym cycles --theta0 42
      spragsym cycles --data brake.toml
      spragsym cycles --theta0 42 --vary theta0=38:60 --plot branch.pdf
      spragsym cycles --theta0 42 --near 2.54,3.36,0,0.36 --vary theta0=30:80 --diagram --plot all.pdf
      spragsym cycles --model stick_slip -V 0.2 --vary V=0.08:0.3

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    along = None if vary is None else span(case, vary, "", begins=True)
    if plot is not None and (along is None or plot.suffix not in (".pdf", ".png", ".svg")):
        raise ParameterError(f"--plot {plot}: it draws a branch, so it needs --vary, and the ending .pdf, .png or .svg")
    if along is not None and along.ends is None:
        raise click.UsageError(f"--vary {along.name}: from where to where? Give it as {along.name}=FROM:TO")
    if whole and (along is None or prove):
        raise click.UsageError("--diagram goes with --vary, and without --prove")
    if digits is not None and not prove:
        raise click.UsageError("--digits goes with --prove")
    refuse([] if plot is None else [plot], force)
    p = case.set(**({along.name: along.ends[0]} if along and along.ends and case.values[along.name] is None else {}))
    start = _state(near, case)
    if whole and along is not None:
        _tell_diagram(case, p, along, [] if start is None else [start], points, plot, json_output)
        return
    with show_progress("looking for a cycle"):
        found = ss.cycle(p, start)
    summary, title = case.units.measured({"model": case.model.name, **_summary(found)}), ""
    # As --near takes it.
    summary["state"] = [value * one for value, one in zip(summary["state"], _ones(case), strict=True)]
    if prove:
        with show_progress("proving it"):
            summary |= _proof(found, {} if digits is None else {"digits": digits})
    if along is not None:
        from ..orbits import cycle_branch

        title = along.title
        with show_progress(f"following cycles along {along.name}"):
            branch = cycle_branch(found, along.name, _held(along, found), points=points)
        summary |= _branch(case, branch, along)
        if plot is not None:
            _draw(case, branch, plot)
    if json_output:
        print_json(summary)
        return
    rows, events = summary.pop("branch", None), summary.pop("branch_events", [])
    print_table("", ("", ""), [(name, _shown(value)) for name, value in summary.items()])
    if rows is not None:
        print_table("Branch", tuple(rows[0]), [list(row.values()) for row in rows])
        period = case.units.measured({"period": 0.0})
        print_table("Events", ("kind", title, "error", *period, "how"), [list(row.values()) for row in events])


def _tell_diagram(
    case: Case, p: ParameterSet, along: Span, starts: list[Any], points: int, plot: Path | None, json_output: bool
) -> None:
    """Equilibria and cycles over a parameter: the labelled points, and the figure."""
    from ..orbits.diagram import diagram

    unit, title = along.unit, along.title
    with show_progress(f"equilibria and cycles along {along.name}"):
        found = diagram(p, along.name, along.between[along.name], starts=starts, points=points)
    if plot is not None:
        from ..figures import diagram_figure

        first = case.units.axis(found.name, after=": rest, cycles from least to largest")
        written(plot, "drawing the diagram", lambda: diagram_figure(found), [(case.units.axis(found.vary), first)])
    labels = [
        {"label": label.label, title: unit * label.value, found.name: label.height, "of": label.of, "branch": label.branch}
        for label in found.labels
    ]
    branches = [
        {"of": "equilibria", "branch": i, "points": len(rest.values), "from": unit * rest.values[0], "to": unit * rest.values[-1],
         "stable": int(rest.stable.sum()), "ends": rest.mode}
        for i, rest in enumerate(found.equilibria)
    ] + [
        {"of": "cycles", "branch": i, "points": len(branch.values), "from": unit * branch.values[0],
         "to": unit * branch.values[-1], "stable": int(branch.stable.sum()),
         "ends": "; ".join(case.units.said(end.how for end in branch.of("end", "homoclinic")))}
        for i, branch in enumerate(found.cycles)
    ]  # fmt: skip
    remarks = case.units.said(found.remarks)
    if json_output:
        print_json({"model": case.model.name, "labels": labels, "branches": branches, "remarks": remarks})
        return
    print_table("Branches", tuple(branches[0]) if branches else (), [list(row.values()) for row in branches])
    print_table("Labels", tuple(labels[0]) if labels else (), [list(row.values()) for row in labels])
    for remark in remarks:
        click.echo(remark)


def _held(along: Span, found: Cycle) -> tuple[float, float]:
    """The range of a branch, which must hold the cycle that it begins with; in the units that were typed if it does not."""
    low, high = along.between[along.name]
    if not low <= (value := found.parameters[along.name]) <= high:
        low, high, value = (along.unit * number for number in (low, high, value))
        raise ParameterError(
            f"--vary {along.title}: the range from {low:.10g} to {high:.10g} does not hold the cycle's own {value:.10g}; give "
            "one that does"
        )
    return low, high


def _proof(found: Cycle, asked: dict[str, int]) -> dict[str, Any]:
    from .. import precise

    proof = precise.prove_cycle(found, **asked)
    if not proof.proved:
        return {"proved": False, "reason": proof.reason}
    decimals = {f"{name}_proved": str(decimal) for name, decimal in proof.decimals().items()}
    return {"proved": True, **decimals, "stable_proved": proof.stable}


def _state(text: str | None, case: Case) -> list[float] | None:
    if text is None:
        return None
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
    return [case.units.state(name) for name in (*case.model.coordinates, *case.model.rates)]


def _summary(found: Cycle) -> dict[str, Any]:
    return {
        "period": found.period, "stable": found.stable, "state": found.state.tolist(),
        "multipliers": [[float(value.real), float(value.imag)] for value in found.multipliers], "error": found.error,
        "residual": found.residual, "rms": found.rms, "mean": found.mean, "amplitude": found.amplitude,
        **{name: list(ends) for name, ends in found.forces.items()}, "crossings": len(found.events),
        "backend": found.backend,
    }  # fmt: skip


def _branch(case: Case, branch: CycleBranch, along: Span) -> dict[str, Any]:
    unit, name, in_units = along.unit, along.title, case.units.measured
    columns = zip(branch.values.tolist(), branch.periods.tolist(), branch.rms.tolist(), branch.stable.tolist(), strict=True)
    return {
        "branch": [
            {name: unit * v, **in_units({"period": period, "rms": rms, "stable": stable})} for v, period, rms, stable in columns
        ],
        "branch_events": [
            {"kind": event.kind, name: unit * event.value, "error": unit * event.error,
             **in_units({"period": event.cycle.period}), "how": how}
            for event, how in zip(branch.events, case.units.said(event.how for event in branch.events), strict=True)
        ],
    }  # fmt: skip


def _draw(case: Case, branch: CycleBranch, path: Path) -> None:
    from ..figures import branch_figure

    units, along = case.units, case.units.axis(branch.vary)
    axes = [(along, units.axis(case.model.coordinates[0], "RMS of ")), (along, units.of_time("period"))]
    written(path, "drawing the branch", lambda: branch_figure(branch), axes)


def _shown(value: Any) -> Any:
    """Numbers to twelve digits; multipliers as a+bi."""
    if isinstance(value, float):
        return f"{value:.12g}"
    if isinstance(value, list):
        return "  ".join(_number(item) for item in value)
    return value


def _number(item: Any) -> str:
    real, imaginary = item if isinstance(item, list) else (item, 0.0)
    return f"{real:.10g}" + (f"{imaginary:+.10g}i" if imaginary else "")
