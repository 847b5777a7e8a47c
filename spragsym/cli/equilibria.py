"""``spragsym equilibria``: a table of all equilibria of one point, or of many."""

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
from ..results.equilibria import Stability
from . import options as o
from .of_model import Case, of_model
from .output import drawn, print_rows
from .points import lengths, summed

#: Points of a table.
MOST = 10_000


@of_model(kind=o.Numbers, statics=True, values=True)
@o.vary(
    "What varies, with its ends: a parameter, or with --data a quantity of the file, as k_x=5:20 or mu0=0:1:11 for 11 values."
)
@o.within
@o.method
@o.plot("frequencies and growth rates in contact over what varies, with damping and without")
@o.force
@o.as_json
def equilibria(case: Case, plot: Path | None) -> Any:
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
    """
    titles, values = {name: case.parameter(name) for name in case.model.parameters}, dict(case.values)
    if case.spans:
        case.require_ends()
        values[case.span.name], titles[case.span.name] = case.span.values, (case.span.title, case.span.unit)
    case.require([name for name, value in values.items() if value is None])
    many = [name for name, value in values.items() if np.ndim(value)]
    if plot is not None:
        _draw(case, plot, many)
    lists = [np.ravel(value).tolist() for value in values.values()]
    size = math.prod(map(len, lists))
    if size > MOST:
        raise click.UsageError(f"{size} points are more than the {MOST} of a table; in Python ss.equilibria takes any number")
    with show_progress(f"searching for equilibria of {size} points" if many else "searching for equilibria"):
        every = [dict(zip(values, combination, strict=True)) for combination in itertools.product(*lists)]  # the first slowest
        told = [{title: unit * at[name] for name, (title, unit) in titles.items()} for at in every]
        points = [{"parameters": at, **one} for at, one in zip(told, _all_states(case, every), strict=True)]
    return {"points": points} if many else points[0], lambda: _print(case, points, [titles[name][0] for name in many])


def _print(case: Case, points: list[dict[str, Any]], many: list[str]) -> None:
    rows = [
        {title: point["parameters"][title] for title in many}
        | {
            name: f"{value:.1e}" if name.startswith("growth") else upward(value) if name == "error" else value
            for name, value in row.items() if "eigenvalues" not in name and name != "marginal"
        }
        for point in points for row in point["equilibria"]
    ]  # fmt: skip
    if rows:
        print_rows("", rows, [*lengths(rows[0]), "error"])
    elif all(point["complete"] for point in points):
        click.echo("none, proved")
    for state in case.model.regimes.values():
        unknown = [one for point in points for one in point["undecided"] if one["state"] == state]
        if boxes := [one for one in unknown if len(one) > len(("state", "reason"))]:
            click.echo(f"{state}: not complete, {summed(boxes)}")
        for reason in dict.fromkeys(one["reason"] for one in unknown if one not in boxes):
            click.echo(f"{state}, undecided: {reason}")
    for remark in dict.fromkeys(remark for point in points for remark in point["remarks"]):
        click.echo(remark)


def _draw(case: Case, plot: Path, many: list[str]) -> None:
    """Eigenvalues over what varies, in the units of the answer."""
    if not case.spans or many != [case.span.name]:
        raise click.UsageError(
            "--plot shows eigenvalues over one parameter: give it as --vary NAME=FROM:TO, and numbers for others"
        )
    from ..figures import eigenvalue_figure

    name, (low, high) = case.span.name, case.span.between[case.span.name]
    p, across, (_, per) = case.set(name, **{name: None}), case.axis(name), case.of("growth")
    words = (r"frequency Im $\lambda$", r"growth Re $\lambda$")
    axes = [(across, None if case.study is None else (f"{word} (1/s)", per)) for word in words]
    drawn(plot, f"drawing eigenvalues over {name}", lambda: eigenvalue_figure(p, name, low=low, high=high), axes)


def _all_states(case: Case, points: list[dict[str, float]]) -> Iterator[dict[str, Any]]:
    """States of all points in one call; points that it does not answer completely are asked one by one."""
    p = case.model.Parameters(**{name: np.array([point[name] for point in points]) for name in points[0]})
    several = len(points) > 1  # of one alone an error is the answer
    every = [ss.equilibria(p, contact=contact, **case.ask) for contact in case.model.regimes if several]
    for at, point in enumerate(points):
        if several and all((eq.decided & eq.whole)[at] for eq in every):
            rows = [row for eq in every for row in _rows(case, eq, (at,))]
            yield {"equilibria": rows, "complete": True, "undecided": [], "remarks": []}
        else:
            yield _states(case, point)


def _states(case: Case, point: dict[str, float]) -> dict[str, Any]:
    """A row for each equilibrium of a point, whether these are all, and what is not known."""
    p, names = case.model.Parameters(**point), case.model.coordinates
    told: dict[str, Any] = {"equilibria": [], "complete": True, "undecided": [], "remarks": []}
    for contact, state in case.model.regimes.items():
        try:
            eq = ss.equilibria(p, contact=contact, **case.ask)
        except ConvergenceError as reason:  # the other regime may be known
            told["undecided"].append({"state": state, "reason": str(reason)})
            told["complete"] = False
            continue
        told["equilibria"] += _rows(case, eq)
        told["complete"] &= eq.complete
        for one in eq.undecided:
            told["undecided"] += case.boxes([zip(one.low, one.high, strict=True)], names, state=state, reason=one.reason)
        told["remarks"] += [f"{state}: {text}" for text in case.said(eq.remarks)]
    return told


def _rows(case: Case, eq: Any, point: tuple[int, ...] = ()) -> list[dict[str, Any]]:
    """Rows of a point: words, directions and lengths of springs, coordinates, and the quality of each state.

    ``stability`` and ``eigenvalues`` are those of (27); ``damped`` is with dampers and the slope of the friction law.
    """
    count = int(eq.count[point])
    names = ("damped", *eq.columns, "eigenvalues", "damped_eigenvalues", "growth", "error", "marginal")
    columns = {name: getattr(eq, name)[point][:count] for name in names}
    words = {"state": [eq.regime] * count, "stability": [Stability(code).name.lower() for code in eq.stability[point][:count]]}
    error, marginal = (columns.pop(name).tolist() for name in ("error", "marginal"))
    return case.rows(words | columns, error=error, marginal=marginal)
