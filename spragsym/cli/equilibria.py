"""``spragsym equilibria``: a table of all equilibria of one point."""

from __future__ import annotations

import math
from typing import Any

import click

from .options import as_json, build, parameters, theta0
from .tables import print_json, print_table


@click.command()
@theta0
@parameters
@as_json
def equilibria(theta0_deg: float, json_output: bool, **values: float) -> None:
    """All equilibria at one point, in contact and in lift-off, stable and unstable.

    \b
    Examples:
      spragsym equilibria --theta0 49
      spragsym equilibria --theta0 30 --mu0 0.7 --json

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    rows = _rows(theta0_deg, values)
    if json_output:
        print_json({"parameters": {"theta0_deg": theta0_deg, **values}, "equilibria": rows})
        return
    print_table("", ("state", "stability", "theta_deg", "L", "x", "y", "error"), [
        (row["state"], row["stability"], *(row[name] for name in ("theta_deg", "L", "x", "y")), f"{row['error']:.1e}")
        for row in rows
    ])  # fmt: skip


def _rows(theta0_deg: float, values: dict[str, float]) -> list[dict[str, Any]]:
    import numpy as np

    from ..solver import Stability
    from ..solver import equilibria as solve

    p = build(theta0_deg, **values)
    rows = []
    for contact in (True, False):
        eq = solve(p, contact=contact)
        with np.errstate(all="ignore"):  # of numbers near the largest that there are
            eigenvalues = eq.eigenvalues
        for slot in range(int(eq.count)):
            rows.append({
                "state": "contact" if contact else "lift-off",
                "stability": Stability(int(eq.stability[slot])).name.lower(),
                "theta_deg": math.degrees(eq.theta[slot]),
                **{name: float(getattr(eq, name)[slot]) for name in ("L", "x", "y")},
                "eigenvalues": [[float(np.real(value)), float(np.imag(value))] for value in eigenvalues[slot]],
                "error": float(eq.error[slot]),
                "fold": bool(eq.fold),
            })  # fmt: skip
    return rows
