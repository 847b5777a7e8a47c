"""``spragsym equilibria``: a table of all equilibria of one point, or of many."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import click
import numpy as np

import spragsym as ss

from ..errors import ConvergenceError
from ..numerics.decimals import upward
from ..progress import show_progress
from .drawings import drawable, written
from .of_model import Case, method, of_model
from .options import Numbers, as_json
from .spans import Span, Typed, box, span, vary, within
from .states import boxes_of, rows_of, summed, unless_room
from .tables import print_json, print_table
from .targets import force, refuse

#: Points of a table.
MOST = 10_000


@of_model(kind=Numbers, statics=True)
@vary("What varies, with its ends: a parameter, or with --data a quantity of the file, as k_x=5:20 or mu0=0:1:11 for 11 values.")
@within
@method
@click.option(
    "--plot", type=click.Path(dir_okay=False, path_type=Path), metavar="FILE",
    help="Draw frequencies and growth rates in contact over what varies, with damping and without (pdf, png, svg).",
)  # fmt: skip
@force
@as_json
def equilibria(
    case: Case, vary: Typed | None, within: tuple[Typed, ...], plot: Path | None, force: bool, json_output: bool
) -> None:  # fmt: skip
    """All equilibria at one point, in contact and in lift-off, stable and unstable; or at many.

    Every parameter may be a number, numbers a,b,c, or start:stop:count; of several, all combinations.

    \b
    Examples:
      spragsym equilibria --theta0 49
      spragsym equilibria --theta0 30 --mu0 0.7 --json
      spragsym equilibria --theta0 49 --mu0 0:1:11
      spragsym equilibria --data brake.toml --vary k_x=5:20
      spragsym equilibria --model cubic_contact --theta0 49
      spragsym equilibria --model mode_coupling --vary mu0=0:1 --plot modes.pdf

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    titles = {name: case.units.parameter(name) for name in case.model.parameters}
    if vary is not None:
        along = span(case, vary, "", values=True)
        if along.ends is None:
            raise click.UsageError(f"--vary {vary.text}: from where to where? Give it as {vary.text}=FROM:TO")
        case.values[along.name], titles[along.name] = along.values, (along.title, along.unit)
    case.require()
    if plot is not None:
        _draw(case, None if vary is None else along, plot, force)
    many = [name for name, value in case.values.items() if not isinstance(value, float) and value.ndim]
    asked = box(case, within)
    size = math.prod(np.size(value) for value in case.values.values())
    if size > MOST:
        raise click.UsageError(f"{size} points are more than the {MOST} of a table; in Python ss.equilibria takes any number")
    with show_progress(f"searching for equilibria of {size} points" if many else "searching for equilibria"):
        points = list(_points(case.values))
        told = [{title: unit * point[name] for name, (title, unit) in titles.items()} for point in points]
        found = [{"parameters": at, **one} for at, one in zip(told, _all_states(case, points, asked), strict=True)]
    if json_output:
        print_json({"model": case.model.name, **({"points": found} if many else found[0])})
        return
    rows = [row for point in found for row in point["equilibria"]]
    columns = [name for name in (rows[0] if rows else ()) if "eigenvalues" not in name and name not in ("error", "marginal")]
    print_table("", (*(titles[name][0] for name in many), *columns, "error"), [
        (*(point["parameters"][titles[name][0]] for name in many),
         *(row[name] if not name.startswith("growth") else f"{row[name]:.1e}" for name in columns), upward(row["error"]))
        for point in found for row in point["equilibria"]
    ], optional=unless_room(columns))  # fmt: skip
    if not rows and all(point["complete"] for point in found):
        click.echo("none, proved")
    for state in case.model.regimes.values():
        unknown = [one for point in found for one in point["undecided"] if one["state"] == state]
        if boxes := [one for one in unknown if len(one) > len(("state", "reason"))]:
            click.echo(f"{state}: not complete, {summed(boxes)}")
        for reason in dict.fromkeys(one["reason"] for one in unknown if one not in boxes):
            click.echo(f"{state}, undecided: {reason}")
    for remark in dict.fromkeys(remark for point in found for remark in point["remarks"]):
        click.echo(remark)


def _draw(case: Case, along: Span | None, plot: Path, force: bool) -> None:
    """Eigenvalues over what varies, in the units of the answer."""
    drawable(plot)
    if along is None or along.ends is None or any(np.ndim(value) for name, value in case.values.items() if name != along.name):
        raise click.UsageError(
            "--plot shows eigenvalues over one parameter: give it as --vary NAME=FROM:TO, and numbers for others"
        )
    refuse([plot], force)
    from ..figures import eigenvalue_figure

    name, p, (low, high) = along.name, case.set(along.name, **{along.name: None}), sorted(along.ends)
    across, (_, per) = case.units.axis(name), case.units.rate("growth")
    words = (r"frequency Im $\lambda$", r"growth Re $\lambda$")
    axes = [(across, None if case.units.study is None else (f"{word} (1/s)", per)) for word in words]
    written(plot, f"drawing eigenvalues over {name}", lambda: eigenvalue_figure(p, name, low=low, high=high), axes)


def _points(values: dict[str, Any]) -> Iterator[dict[str, float]]:
    """All combinations, the first parameter slowest."""
    lists = [[value] if isinstance(value, float) else value.ravel().tolist() for value in values.values()]
    for combination in itertools.product(*lists):
        yield dict(zip(values, combination, strict=True))


def _all_states(case: Case, points: list[dict[str, float]], within: Any) -> list[dict[str, Any]]:
    """As :func:`_states` of each point: of all in one call, and of those that it does not answer whole in one each."""
    p = case.model.Parameters(**{name: np.array([point[name] for point in points]) for name in points[0]})
    more, several = case.searching({}, within), len(points) > 1  # of one alone an error is the answer
    every = [ss.equilibria(p, contact=contact, **more) for contact in case.model.regimes if several]
    found = []
    for at, point in enumerate(points):
        if several and all((eq.decided & eq.whole)[at] for eq in every):
            rows = [row for eq in every for row in rows_of(eq, case.units, (at,))]
            found.append({"equilibria": rows, "complete": True, "undecided": [], "remarks": []})
        else:
            found.append(_states(case, point, within))
    return found


def _states(case: Case, point: dict[str, float], within: Any) -> dict[str, Any]:
    """A row for each equilibrium of a point, whether these are all, and what is not known."""
    p, units = case.model.Parameters(**point), case.units
    more = case.searching({}, within)
    told: dict[str, Any] = {"equilibria": [], "complete": True, "undecided": [], "remarks": []}
    for contact, state in case.model.regimes.items():
        try:
            eq = ss.equilibria(p, contact=contact, **more)
        except ConvergenceError as reason:  # the other regime may be known
            told["undecided"].append({"state": state, "reason": str(reason)})
            told["complete"] = False
            continue
        told["equilibria"] += rows_of(eq, units)
        told["complete"] &= eq.complete
        for one in eq.undecided:
            boxes = boxes_of(case, [zip(one.low, one.high, strict=True)], case.model.coordinates, state=state)
            told["undecided"] += [{**box, "reason": one.reason} for box in boxes]
        told["remarks"] += [f"{state}: {text}" for text in units.said(eq.remarks)]
    return told
