"""``spragsym cycles``: a cycle, or a branch of them over a parameter."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from ..errors import ParameterError
from ..parameters import ARTICLE
from .commands import command
from .data import PHYSICAL, data, in_units, varied
from .options import DEGREES, Number, as_json, belt, build, parameters, sentence
from .tables import print_json, print_table
from .targets import force, refuse
from .with_model import ForModels, made_for, model_option

if TYPE_CHECKING:
    from ..cycles import Cycle, CycleBranch
    from ..parameters import ParameterSet

F = TypeVar("F", bound=Callable[..., Any])

#: Parameters that can be varied.
VARIED = ("theta0", *ARTICLE, "V", "d")


def search(place: str, choices: Sequence[str]) -> Callable[[F], F]:
    """Where to begin, what varies, and what to do with it; ``place`` names a state's numbers."""
    options = (
        click.option("--near", metavar=place, help="A state near the cycle. Default: the motion from rest at x = y = 0."),
        click.option("--vary", type=click.Choice(choices), help="Follow the cycle as this varies."),
        click.option("--from", "low", type=Number(), help="Where the range begins, degrees for angles."),
        click.option("--to", "high", type=Number(), help="Where it ends."),
        click.option("--points", type=click.IntRange(1), default=200, show_default=True, help="Most points each way."),
        click.option(
            "--diagram", "whole", is_flag=True, help="Equilibria too, and cycles from Hopf points and doublings; with --vary."
        ),
        click.option("--prove", is_flag=True, help="Prove the cycle in ball arithmetic: a minute."),
        click.option(
            "--plot", type=click.Path(dir_okay=False, path_type=Path), metavar="FILE", help="Draw the branch (pdf, png, svg)."
        ),
    )

    def add(function: F) -> F:
        for option in reversed(options):
            function = option(function)
        return function

    return add


@command(cls=ForModels)
@model_option
@click.option("--theta0", "theta0_deg", type=Number(DEGREES), help=f"{sentence('theta0')[:-1]}, degrees. Default: --from.")
@parameters
@belt
@search("X,Y,VX,VY", (*VARIED, *PHYSICAL))
@force
@data
@as_json
def cycles(
    theta0_deg: float | None, V: float, d: float, mu0: float, kappa: float, alpha: float, sigma: float, beta: float, **rest: Any
) -> None:
    """A cycle of the motion with its multipliers; with --vary, a branch of cycles with the events on it.

    The article states neither the belt speed V nor the steepness d of the friction law: the defaults are an
    assumption.

    \b
    Examples:
      spragsym cycles --theta0 42
      spragsym cycles --data brake.toml
      spragsym cycles --theta0 42 --vary theta0 --from 38 --to 60 --plot branch.pdf
      spragsym cycles --theta0 42 --near 2.54,3.36,0,0.36 --vary theta0 --from 30 --to 80 --diagram --plot all.pdf
      spragsym cycles --model stick_slip -V 0.2 --vary V --from 0.08 --to 0.3

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    if theta0_deg is None:
        if rest["vary"] != "theta0" or rest["low"] is None:
            raise click.UsageError("--theta0 is missing")
        theta0_deg = rest["low"]
    from ..cycles import cycle

    p = build(theta0_deg, mu0=mu0, kappa=kappa, alpha=alpha, sigma=sigma, beta=beta)
    p = p.replace(V=V, d=d)
    tell(p, lambda near: cycle(p, near=near), 4, varied, **rest)


def tell(
    p: ParameterSet, find: Callable[[Any], Cycle], size: int, unit_of: Callable[[str], tuple[str, float, str]], *,
    near: str | None, vary: str | None, low: float | None, high: float | None, points: int, whole: bool, prove: bool,
    plot: Path | None, force: bool, json_output: bool,
) -> None:  # fmt: skip
    """Find a cycle near a state of ``size`` numbers, prove it, follow it and draw the branch, as asked for; print all that."""
    if (vary is None) != (low is None) or (low is None) != (high is None):
        raise click.UsageError("--vary, --from and --to belong together")
    if plot is not None and (vary is None or plot.suffix not in (".pdf", ".png", ".svg")):
        raise ParameterError(f"--plot {plot}: it draws a branch, so it needs --vary, and the ending .pdf, .png or .svg")
    refuse([] if plot is None else [plot], force)
    if whole:
        if vary is None or low is None or high is None or prove:
            raise click.UsageError("--diagram goes with --vary, --from and --to, and without --prove")
        name, unit, title = unit_of(vary)
        starts = [] if near is None else [_state(near, size)]
        _tell_diagram(p, name, (low / unit, high / unit), unit, title, starts, points, plot, json_output)
        return
    found = find(_state(near, size))
    summary, title = in_units(_summary(found)), ""
    if prove:
        summary |= _proof(found)
    if vary is not None and low is not None and high is not None:
        from ..cycles import cycle_branch

        name, unit, title = unit_of(vary)
        branch = cycle_branch(found, name, (low / unit, high / unit), points=points)
        summary |= _branch(branch, unit, title)
        if plot is not None:
            _draw(branch, plot)
    if json_output:
        print_json(summary)
        return
    rows, events = summary.pop("branch", None), summary.pop("branch_events", [])
    print_table("", ("", ""), [(name, _shown(value)) for name, value in summary.items()])
    if rows is not None:
        print_table("Branch", tuple(rows[0]), [list(row.values()) for row in rows])
        print_table("Events", ("kind", title, "error", *in_units({"period": 0.0}), "how"), [list(row.values()) for row in events])


def _tell_diagram(
    p: ParameterSet, name: str, to: tuple[float, float], unit: float, title: str, starts: list[Any], points: int,
    plot: Path | None, json_output: bool,
) -> None:  # fmt: skip
    """Equilibria and cycles over a parameter: the labelled points, and the figure."""
    from ..models.diagram import diagram

    found = diagram(p, name, to, starts=starts, points=points)
    if plot is not None:
        from ..figures import diagram_figure

        _drawn(lambda: diagram_figure(found), plot)
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
         "ends": "; ".join(end.how for end in branch.of("end", "homoclinic"))}
        for i, branch in enumerate(found.cycles)
    ]  # fmt: skip
    if json_output:
        print_json({"labels": labels, "branches": branches, "remarks": list(found.remarks)})
        return
    print_table("Branches", tuple(branches[0]) if branches else (), [list(row.values()) for row in branches])
    print_table("Labels", tuple(labels[0]) if labels else (), [list(row.values()) for row in labels])
    for remark in found.remarks:
        click.echo(remark)


def _proof(found: Cycle) -> dict[str, Any]:
    from .. import precise

    proof = precise.prove_cycle(found)
    if not proof.proved:
        return {"proved": False, "reason": proof.reason}
    decimals = {f"{name}_proved": str(decimal) for name, decimal in proof.decimals().items()}
    return {"proved": True, **decimals, "stable_proved": proof.stable}


def _state(text: str | None, size: int) -> list[float] | None:
    if text is None:
        return None
    try:
        numbers = [float(part) for part in text.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) != size:
        raise ParameterError(f"--near {text!r} is not {size} numbers with commas, coordinates, then speeds")
    return numbers


def _summary(found: Cycle) -> dict[str, Any]:
    return {
        "period": found.period, "stable": found.stable, "state": found.state.tolist(),
        "multipliers": [[float(value.real), float(value.imag)] for value in found.multipliers], "error": found.error,
        "residual": found.residual, "rms": found.rms, "mean": found.mean, "amplitude": found.amplitude,
        **{name: list(ends) for name, ends in found.forces.items()}, "crossings": len(found.events),
        "backend": found.backend,
    }  # fmt: skip


def _branch(branch: CycleBranch, unit: float, name: str) -> dict[str, Any]:
    columns = zip(branch.values.tolist(), branch.periods.tolist(), branch.rms.tolist(), branch.stable.tolist(), strict=True)
    return {
        "branch": [
            {name: unit * v, **in_units({"period": period, "rms": rms, "stable": stable})} for v, period, rms, stable in columns
        ],
        "branch_events": [
            {"kind": event.kind, name: unit * event.value, "error": unit * event.error,
             **in_units({"period": event.cycle.period}), "how": event.how}
            for event in branch.events
        ],
    }  # fmt: skip


def _draw(branch: CycleBranch, path: Path) -> None:
    from ..figures import branch_figure

    _drawn(lambda: branch_figure(branch), path)


def _drawn(figure: Callable[[], Any], path: Path) -> None:
    """A figure written to a file."""
    from ..figures import FORMATS
    from ..figures.style import house_style

    kind = path.suffix[1:]
    with house_style():
        figure().savefig(path, format=kind, metadata=FORMATS[kind])
    click.echo(f"drew {path}", err=True)


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


made_for(cycles, "model_motion", "cycles_of")
