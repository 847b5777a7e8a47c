"""``spragsym path``: a state followed as one parameter moves."""

from __future__ import annotations

from typing import Any

import click

import spragsym as ss

from ..progress import show_progress
from .of_model import Case, followed, following, method, of_model
from .options import as_json
from .spans import Typed, span, vary
from .states import placed
from .tables import print_json, print_table


@of_model(statics=True)
@vary("What moves, and from where to where, as mu0=0:0.9, or mu0=0.9:0:19 for 19 values; with --data a quantity of the file too.")
@followed
@method
@as_json
def path(case: Case, vary: Typed | None, near: tuple[str, ...], json_output: bool) -> None:
    """The state of small deformation, followed as one parameter moves: where it goes and where it jumps.

    \b
    Examples:
      spragsym path --theta0 40 --vary mu0=0:0.9
      spragsym path --data brake.toml --vary theta0=10:80
      spragsym path --model two_springs --vary theta0=10:80:8
      spragsym path --model sprag_rod --theta0 30 --vary mu0=0:0.7 --state phi=-28

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    if vary is None or vary.low is None:
        asked = case.model.axes[-1] if vary is None else vary.name
        raise click.UsageError(f"--vary: from where to where? Give it as {asked}=FROM:TO")
    along = span(case, vary, "", values=True)
    with show_progress(f"following a state along {along.name}"):
        found = ss.quasi_static_path(following(case, case.set(along.name), near), along.name, along.values, **case.ask)
    growth, per = case.units.rate("growth")
    states = [
        {
            along.title: along.unit * float(found.values[row]), "stability": str(found.kind[row]),
            "undamped": _undamped(found.stability[row]), growth: per * float(found.growth[row]),
            **placed(case.units, found.columns, lambda name, row=row: found.places[name][row]),
        }
        for row in range(found.values.size)
    ]  # fmt: skip
    jumps = [
        {
            along.title: along.unit * jump.value, "kind": jump.kind,
            **placed(case.units, found.columns, jump.before.__getitem__, "_before"),
            **placed(case.units, found.columns, jump.after.__getitem__, "_after"), "error": jump.error,
        }
        for jump in found.jumps
    ]  # fmt: skip
    if json_output:
        print_json({"model": case.model.name, "vary": along.title, "states": states, "jumps": jumps})
        return
    _print("States", states, growth)
    if jumps:
        _print("Jumps", jumps, growth)
    else:
        click.echo("No jumps")


def _undamped(code: Any) -> str:
    from ..results.equilibria import Stability

    return Stability(int(code)).name.lower()


def _print(title: str, rows: list[dict[str, Any]], growth: str) -> None:
    header = list(rows[0])
    lengths = [name for name in header if name == "L" or name.startswith("L_")]
    room = [
        *lengths,
        "error",
        *(name for name in header if name.startswith("theta") and name.endswith(("_before_deg", "_after_deg"))),
    ]
    body = [[f"{value:.1e}" if name == growth else value for name, value in row.items()] for row in rows]
    print_table(title, header, body, optional=[name for name in room if name in header[1:]])
