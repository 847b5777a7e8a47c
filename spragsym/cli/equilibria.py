"""``spragsym equilibria``: a table of all equilibria of one point."""

from __future__ import annotations

import math
from typing import Any

import click

from .options import as_json, build, parameters, theta0
from .tables import print_json, print_table
from .with_model import ForModels, made_for, model_option


@click.command(cls=ForModels)
@model_option
@theta0
@parameters
@as_json
def equilibria(theta0_deg: float, json_output: bool, **values: float) -> None:
    """All equilibria at one point, in contact and in lift-off, stable and unstable.

    \b
    Examples:
      spragsym equilibria --theta0 49
      spragsym equilibria --theta0 30 --mu0 0.7 --json
      spragsym equilibria --model cubic_contact --theta0 49

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    rows, reasons = _rows(theta0_deg, values)
    if json_output:
        print_json({"parameters": {"theta0_deg": theta0_deg, **values}, "equilibria": rows, "undecided": reasons})
        return
    print_table("", ("state", "stability", "theta_deg", "L", "x", "y", "error"), [
        (row["state"], row["stability"], *(row[name] for name in ("theta_deg", "L", "x", "y")), f"{row['error']:.1e}")
        for row in rows
    ])  # fmt: skip
    for state, reason in reasons.items():
        click.echo(f"{state}, undecided: {reason}")


def _rows(theta0_deg: float, values: dict[str, float]) -> tuple[list[dict[str, Any]], dict[str, str]]:
    """A row for each equilibrium; and, by state, why the equilibria in contact or in lift-off can't be told."""
    import numpy as np

    from ..errors import ConvergenceError
    from ..statics.solver import Stability
    from ..statics.solver import equilibria as solve

    p = build(theta0_deg, **values)
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
