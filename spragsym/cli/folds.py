"""``spragsym folds``, ``path`` and ``critical``: where states meet, how one is followed, and when it jumps."""

from __future__ import annotations

import math
from typing import Any

import click

from ..errors import ParameterError
from ..parameters import RANGES
from .commands import command
from .data import data, length, varied, vary
from .options import DEGREES, Number, as_json, build, check_theta0, parameters, theta0_unless_varied
from .states import words_of
from .tables import print_json, print_path, print_table
from .with_model import ForModels, made_for, model_option


@command(cls=ForModels)
@theta0_unless_varied
@parameters
@vary
@data
@model_option
@as_json
def folds(theta0_deg: float | None, vary: str, json_output: bool, **values: float) -> None:
    """All folds along one parameter: which state ends there, when, and where it jumps to.

    \b
    Examples:
      spragsym folds --theta0 40
      spragsym folds --data brake.toml --vary k_x
      spragsym folds --model two_springs --theta0 40

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    from ..catastrophe import folds as solve

    check_theta0(theta0_deg, vary)
    name, unit, title = varied(vary)
    found = solve(build(theta0_deg, **values), name)
    size, end = length()
    rows: list[dict[str, Any]] = [
        {
            title: unit * float(getattr(found, name)[i]), "kind": str(found.kind[i]), "ends": str(found.ends[i]),
            "when": str(found.when[i]), "theta_deg": math.degrees(found.theta[i]), f"x{end}": size * float(found.x[i]),
            "theta_after_deg": math.degrees(found.theta_after[i]), f"x_after{end}": size * float(found.x_after[i]),
        }
        for i in range(found.theta.size)
    ]  # fmt: skip
    if json_output:
        print_json({"vary": vary, "folds": rows})
    elif rows:
        print_table("", tuple(rows[0]), [list(row.values()) for row in rows])
    else:
        click.echo(f"no folds as {vary} varies")


@command(cls=ForModels)
@theta0_unless_varied
@parameters
@vary
@click.option("--from", "low", type=Number(), default=0.0, show_default=True, help="First value; degrees for theta0.")
@click.option("--to", "high", type=Number(), default=1.0, show_default=True, help="Last value, larger or smaller.")
@click.option("--points", type=click.IntRange(2, 100_000), default=11, show_default=True, help="Values, the ends included.")
@data
@model_option
@as_json
def path(
    theta0_deg: float | None, vary: str, low: float, high: float, points: int, json_output: bool, **values: float
) -> None:  # fmt: skip
    """The state of small deformation, followed as one parameter moves: where it goes and where it jumps.

    \b
    Examples:
      spragsym path --theta0 40 --to 0.9
      spragsym path --data brake.toml --vary theta0 --from 10 --to 80

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    import numpy as np

    from ..catastrophe import quasi_static_path

    if low == high:
        raise ParameterError(f"--from {low:g} and --to are the same; give two values")
    check_theta0(theta0_deg, vary)
    name, unit, title = varied(vary)
    allowed = DEGREES if name == "theta0" else RANGES[name]
    for flag, given in (("--from", low), ("--to", high)):
        value = given if name == "theta0" else given / unit
        if not allowed.contains(value):
            own = "" if name == "theta0" or unit == 1 else f" is {name} = {value:g}, which"
            what = f"{title} = {given:g}{own}"
            raise ParameterError(f"{flag}: {what} is not in {allowed}{f'; {allowed.remedy}' if allowed.remedy else ''}")
    found = quasi_static_path(build(theta0_deg, **values), name, np.linspace(low, high, points) / unit)
    size, end = length()
    states = [
        {title: float(unit * value), **words, "theta_deg": math.degrees(theta), f"x{end}": float(size * x),
         f"y{end}": float(size * y)}
        for value, words, theta, x, y in zip(found.values, words_of(found), found.theta, found.x, found.y, strict=True)
    ]  # fmt: skip
    jumps = [
        {title: unit * jump.value, "theta_before_deg": math.degrees(jump.theta_before), f"x_before{end}": size * jump.x_before,
         "theta_after_deg": math.degrees(jump.theta_after), f"x_after{end}": size * jump.x_after}
        for jump in found.jumps
    ]  # fmt: skip
    print_path({"vary": vary}, states, jumps, json_output)


@command(cls=ForModels)
@theta0_unless_varied
@parameters
@vary
@data
@model_option
@as_json
def critical(theta0_deg: float | None, vary: str, json_output: bool, **values: float) -> None:
    """Where the state of small deformation jumps first as one parameter moves, and the frictions that decide whether it can.

    Friction and inclination rise from their lower end; the others move up and down from their value, at a friction at which
    nothing has jumped.

    \b
    Examples:
      spragsym critical --theta0 40
      spragsym critical --data brake.toml --vary theta0

    \b
    Exit codes: 0 done, 1 failed, 2 usage, 130 interrupted.
    """
    from ..catastrophe import critical_friction, cusp_friction, linear_critical_friction
    from ..design import jump_value

    check_theta0(theta0_deg, vary)
    name, unit, title = varied(vary)
    p = build(theta0_deg, **values)
    at_angle = math.nan if theta0_deg is None else float(jump_value(p))
    ways = ("up",) if name in ("mu0", "theta0") else ("up", "down")
    jumped = name not in ("mu0", "theta0") and at_angle <= float(p.mu0)
    found = {way: math.nan if jumped else unit * float(jump_value(p, name, direction=way)) for way in ways}
    lowest = critical_friction(p)
    place = {"theta0_lowest_deg": math.degrees(lowest.theta0), "kind_lowest": lowest.kind or None}
    solved = {
        "mu_jump": at_angle, "mu_lowest": lowest, "mu_cusp": cusp_friction(p), "mu_cr": linear_critical_friction(p),
    }  # fmt: skip
    frictions = {key: float(value) for key, value in solved.items()}
    if json_output:
        print_json({"vary": vary, "quantity": title, "jump": found, "jumped": jumped, **frictions, **place})
        return
    rows = [
        (f"{title} at the first jump, {way}", _or(value, "it has jumped already" if jumped else "never"))
        for way, value in found.items()
    ]
    meanings = {
        "mu_jump": "friction at which it jumps at this angle",
        "mu_lowest": "friction of the lowest fold: below it it jumps at no angle" + (
            f" (a {lowest.kind}, at {place['theta0_lowest_deg']:.6g} deg)" if lowest.kind else ""
        ),
        "mu_cusp": "friction of the lowest cusp", "mu_cr": "friction of the linear sprag model",
    }  # fmt: skip
    if theta0_deg is None:
        del meanings["mu_jump"]
    print_table("", ("", "value"), rows + [(text, _or(frictions[key], "none")) for key, text in meanings.items()])


def _or(value: float, word: str) -> float | str:
    return value if math.isfinite(value) else word


for _command in (folds, path, critical):
    made_for(_command, "model_paths", f"{_command.name}_of")
