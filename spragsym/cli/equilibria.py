"""``spragsym equilibria``: a table of all equilibria of one point."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

import click

from ..errors import ParameterError
from ..exact.decimals import upward
from ..parameters import NAMES, RANGES, FloatArray
from .commands import command
from .data import PHYSICAL, data, growth_rate, length, varied
from .options import DEGREES, Number, as_json, build, ranges
from .states import WORDS, rows_of, unless_room
from .tables import print_json, print_table
from .with_model import ForModels, made_for, model_option


@command(cls=ForModels)
@model_option
@ranges
@click.option("--vary", type=click.Choice([*NAMES, *PHYSICAL]), help="What varies; with --data, a quantity of the file too.")
@click.option("--from", "low", type=Number(), help="First value, degrees for theta0.")
@click.option("--to", "high", type=Number(), help="Last value.")
@click.option("--points", type=click.IntRange(2, 100_000), default=11, show_default=True, help="Values, the ends included.")
@data
@as_json
def equilibria(
    json_output: bool, vary: str | None, low: float | None, high: float | None, points: int, **values: Any
) -> None:  # fmt: skip
    """All equilibria at one point, in contact and in lift-off, stable and unstable; or at many.

    Every parameter may be a number, numbers a,b,c, or start:stop:count; of several, all combinations.

    \b
    Examples:
      spragsym equilibria --theta0 49
      spragsym equilibria --theta0 30 --mu0 0.7 --json
      spragsym equilibria --theta0 49 --mu0 0:1:11
      spragsym equilibria --data brake.toml --vary k_x --from 5 --to 20
      spragsym equilibria --model cubic_contact --theta0 49

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    (size, end), (rate, per) = length(), growth_rate()
    named: dict[str, tuple[str, float]] = {}
    if (vary is None) != (low is None) or (low is None) != (high is None):
        raise click.UsageError("--vary, --from and --to belong together")
    if vary is not None and low is not None and high is not None:
        option, title, unit = _axis(vary)
        values[option], named[option] = _between(option, low / unit, high / unit, points), (title, unit)
    names = [named.get(name, (name, 1.0))[0] for name, value in values.items() if not isinstance(value, float)]
    found: list[dict[str, Any]] = []
    for point in _points(values):
        rows, reasons = _rows(point)
        units = {"L": (size, end), "x": (size, end), "y": (size, end), "growth": (rate, per)}
        scaled = [
            {name + units[name][1] if name in units else name: value * units[name][0] if name in units else value
             for name, value in row.items()}
            for row in rows
        ]  # fmt: skip
        told = {named[name][0] if name in named else name: value * named.get(name, ("", 1.0))[1] for name, value in point.items()}
        found.append({"parameters": told, "equilibria": scaled, "undecided": reasons})
    if json_output:
        print_json({"points": found} if names else found[0])
        return
    columns = (*WORDS, "theta_deg", *(name + end for name in ("L", "x", "y")), f"growth{per}")
    print_table("", (*names, *columns, "error"), [
        (*(point["parameters"][name] for name in names),
         *(row[name] if not name.startswith("growth") else f"{row[name]:.1e}" for name in columns), upward(row["error"]))
        for point in found for row in point["equilibria"]
    ], optional=unless_room(columns))  # fmt: skip
    for one in found:
        for state, reason in one["undecided"].items():
            click.echo(f"{state}, undecided: {reason}")


def _axis(vary: str) -> tuple[str, str, float]:
    """The option that varies, its name in the answer, and what one of it is there."""
    name, unit, title = varied(vary)
    return ("theta0_deg", title, 1.0) if name == "theta0" else (name, title, unit)


def _between(option: str, low: float, high: float, points: int) -> FloatArray:
    """Values from one end to the other, both of which are in range."""
    import numpy as np

    allowed = DEGREES if option == "theta0_deg" else RANGES[option]
    for flag, end in (("--from", low), ("--to", high)):
        if not allowed.contains(end):
            raise ParameterError(
                f"{flag}: {option} = {end:g} is not in {allowed}{'; ' + allowed.remedy if allowed.remedy else ''}"
            )
    return np.linspace(low, high, points)


def _points(values: dict[str, Any]) -> Iterator[dict[str, float]]:
    """All combinations, the first parameter slowest."""
    lists = [[value] if isinstance(value, float) else value.tolist() for value in values.values()]
    for combination in itertools.product(*lists):
        yield dict(zip(values, combination, strict=True))


def _rows(values: dict[str, Any]) -> tuple[list[dict[str, Any]], dict[str, str]]:
    """A row for each equilibrium; and, by state, why the equilibria in contact or in lift-off can't be told."""
    from ..errors import ConvergenceError
    from ..statics.solver import equilibria as solve

    p = build(**values)
    rows, reasons = [], {}
    for contact, state in ((True, "contact"), (False, "lift-off")):
        try:
            rows += rows_of(solve(p, contact=contact))
        except ConvergenceError as reason:
            reasons[state] = str(reason)
    return rows, reasons


made_for(equilibria, "model_statics", "equilibria_of")
