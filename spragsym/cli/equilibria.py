"""``spragsym equilibria``: a table of all equilibria of one point."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from typing import Any

import click

from .data import data, length
from .options import as_json, build, ranges
from .tables import print_json, print_table
from .with_model import ForModels, made_for, model_option


@click.command(cls=ForModels)
@model_option
@ranges
@data
@as_json
def equilibria(json_output: bool, **values: Any) -> None:
    """All equilibria at one point, in contact and in lift-off, stable and unstable; or at many.

    Every parameter may be a number, numbers a,b,c, or start:stop:count; of several, all combinations.

    \b
    Examples:
      spragsym equilibria --theta0 49
      spragsym equilibria --theta0 30 --mu0 0.7 --json
      spragsym equilibria --theta0 49 --mu0 0:1:11
      spragsym equilibria --data brake.toml
      spragsym equilibria --model cubic_contact --theta0 49

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    size, end = length()
    names = [name for name, value in values.items() if not isinstance(value, float)]
    points: list[dict[str, Any]] = []
    for point in _points(values):
        rows, reasons = _rows(point)
        lengths = {"L", "x", "y"}
        scaled = [{name + end * (name in lengths): value * size if name in lengths else value for name, value in row.items()}
                  for row in rows]  # fmt: skip
        points.append({"parameters": point, "equilibria": scaled, "undecided": reasons})
    if json_output:
        print_json({"points": points} if names else points[0])
        return
    columns = ("theta_deg", *(name + end for name in ("L", "x", "y")))
    print_table("", (*names, "state", "stability", *columns, "error"), [
        (*(point["parameters"][name] for name in names), row["state"], row["stability"], *(row[name] for name in columns),
         f"{row['error']:.1e}")
        for point in points for row in point["equilibria"]
    ])  # fmt: skip
    for one in points:
        for state, reason in one["undecided"].items():
            click.echo(f"{state}, undecided: {reason}")


def _points(values: dict[str, Any]) -> Iterator[dict[str, float]]:
    """All combinations, the first parameter slowest."""
    lists = [[value] if isinstance(value, float) else value.tolist() for value in values.values()]
    for combination in itertools.product(*lists):
        yield dict(zip(values, combination, strict=True))


def _rows(values: dict[str, float]) -> tuple[list[dict[str, Any]], dict[str, str]]:
    """A row for each equilibrium; and, by state, why the equilibria in contact or in lift-off can't be told."""
    import numpy as np

    from ..errors import ConvergenceError
    from ..statics.solver import Stability
    from ..statics.solver import equilibria as solve

    p = build(**values)
    rows, reasons = [], {}
    for contact, state in ((True, "contact"), (False, "lift-off")):
        try:
            eq = solve(p, contact=contact)
        except ConvergenceError as reason:
            reasons[state] = str(reason)
            continue
        with np.errstate(all="ignore"):  # parameters near the largest floats overflow
            eigenvalues = eq.eigenvalues
        for slot in range(int(eq.count)):
            rows.append({
                "state": state,
                "stability": Stability(int(eq.stability[slot])).name.lower(),
                "theta_deg": math.degrees(eq.theta[slot]),
                **{name: float(getattr(eq, name)[slot]) for name in ("L", "x", "y")},
                "eigenvalues": [[float(np.real(value)), float(np.imag(value))] for value in eigenvalues[slot]],
                "error": float(eq.error[slot]),
                "fold": bool(eq.fold),
            })  # fmt: skip
    return rows, reasons


made_for(equilibria, "model_statics", "equilibria_of")
