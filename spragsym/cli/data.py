"""``--data FILE``: the parameters of a command from the data of a brake, and its answers in the units of that file."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

import click

from ..errors import ParameterError
from ..parameters import NAMES, degrees

if TYPE_CHECKING:
    from ..studies import Study

F = TypeVar("F", bound=Callable[..., Any])

#: Physical quantity → the dimensionless parameter that is proportional to it.
PHYSICAL = {"k": "sigma", "k_x": "alpha", "k_y": "beta", "F_L": "kappa"}


def data(function: F) -> F:
    """``--data``: what the file says are the defaults of the other options."""
    text = "Take the parameters from the data of a brake, and answer in the units of that file."
    return click.option("--data", metavar="FILE", is_eager=True, expose_value=False, callback=_load, help=text)(function)


def _load(ctx: click.Context, _: click.Parameter, value: str | None) -> None:
    if value is None:
        return
    from ..studies import Study

    study = Study.from_file(value)
    if study.model != "kang_nam":
        raise ParameterError(f"--data {value}: model = {study.model!r}, and this command is for kang_nam; leave the model out")
    p = study.dimensionless
    if not any(option.name == "V" for option in ctx.command.params):  # statics: the friction that works at the belt's speed
        p = p.replace(mu0=study.friction[1])
    defaults: dict[str, Any] = dict(zip(NAMES, p.scalars(*NAMES), strict=True))
    defaults["theta0_deg"] = degrees(defaults["theta0"])
    if study.moves:
        defaults |= study.parameters.belt()
    ctx.default_map = {name: str(value) for name, value in defaults.items()}
    ctx.meta["spragsym.study"] = study


def current() -> Study | None:
    """The study of this command, if it was given one."""
    found: Study | None = click.get_current_context().meta.get("spragsym.study")
    return found


def length() -> tuple[float, str]:
    """What one L_0 is in the unit of the answer, and that unit as the end of a name."""
    study = current()
    if study is None:
        return 1.0, ""
    return study.in_file("L_0", study.values["L_0"]), f"_{study.quantities['L_0'].unit}"


def vary(function: F) -> F:
    """``--vary``: a parameter, or with ``--data`` a physical quantity."""
    choices = click.Choice([*NAMES, *PHYSICAL])
    text = "What varies: a parameter; with --data, a quantity of the file too."
    return click.option("--vary", type=choices, default="mu0", show_default=True, help=text)(function)


def varied(name: str) -> tuple[str, float, str]:
    """The dimensionless parameter that varies, what one of it is in the unit of the answer, and the name of that."""
    if name == "theta0":
        return name, math.degrees(1.0), "theta0_deg"
    if name not in PHYSICAL:
        return name, 1.0, name
    study = current()
    if study is None:
        raise ParameterError(f"--vary {name}: without --data the parameters have no units; give --vary {PHYSICAL[name]}")
    stiffness = study.values["k_c"]
    unit = stiffness * study.values["L_0"] if name == "F_L" else stiffness
    return PHYSICAL[name], study.in_file(name, unit), f"{name}_{study.quantities[name].unit}"


def in_units(summary: dict[str, Any]) -> dict[str, Any]:
    """What is measured of a motion in the units of the file: lengths, and the period in seconds."""
    study = current()
    if study is None:
        return summary
    size, end = length()
    lengths = {"rms", "rms_about_mean", "mean", "amplitude", "error"}
    found = {name + end * (name in lengths): value * size if name in lengths else value for name, value in summary.items()}
    return {("period_s" if name == "period" else name): value * study.scales.time if name == "period" else value
            for name, value in found.items()}  # fmt: skip
