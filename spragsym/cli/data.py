"""``--data FILE``: the parameters of a command from the data of a brake, and its answers in the units of that file."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

import click

from ..errors import ParameterError
from ..names import hint
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
    elif not study.moves:
        raise ParameterError(
            f'--data {value}: there is no motion without belt speed and creep; add V = "1.2 m/s" and d = "10 s/m"'
        )
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


def growth_rate() -> tuple[float, str]:
    """What one growth rate is in the unit of the answer, and that unit as the end of a name."""
    study = current()
    return (1.0, "") if study is None else (1.0 / study.scales.time, "_per_s")


class _OneOf(click.Choice[str]):
    """One of some names; a name that is nearly one of them is told which."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        if value not in self.choices:
            names = ", ".join(self.choices)
            self.fail(f"{value!r} is not one of {names}{hint(str(value), self.choices)}", param, ctx)
        return str(value)


def vary(function: F) -> F:
    """``--vary``: a parameter, or with ``--data`` a physical quantity."""
    choices = _OneOf([*NAMES, *PHYSICAL])
    text = "What varies: a parameter; with --data, a quantity of the file too."
    return click.option("--vary", type=choices, default="mu0", show_default=True, help=text)(function)


def varied(name: str) -> tuple[str, float, str]:
    """The dimensionless parameter that varies, what one of it is in the unit of the answer, and the name of that."""
    if name == "theta0":
        return name, math.degrees(1.0), "theta0_deg"
    study = current()
    if name in ("V", "d") and study is not None:
        speed = study.scales.length / study.scales.time
        return name, study.in_file(name, speed if name == "V" else 1 / speed), f"{name}_{study.quantities[name].unit}"
    if name not in PHYSICAL:
        return name, 1.0, name
    if study is None:
        raise ParameterError(f"--vary {name}: without --data the parameters have no units; give --vary {PHYSICAL[name]}")
    stiffness = study.values["k_c"]
    unit = stiffness * study.values["L_0"] if name == "F_L" else stiffness
    return PHYSICAL[name], study.in_file(name, unit), f"{name}_{study.quantities[name].unit}"


def own_units(times: dict[str, Any], start: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Times and an initial state as the command takes them: seconds and the file's units with ``--data``, if they were typed."""
    study, context = current(), click.get_current_context()
    if study is None:
        return times, start

    def typed(name: str) -> bool:
        return context.get_parameter_source(name) == click.core.ParameterSource.COMMANDLINE

    scales = study.scales
    speed = study.in_file("V", scales.length / scales.time)
    units = dict.fromkeys(times, scales.time) | {"x0": length()[0], "y0": length()[0], "vx0": speed, "vy0": speed}
    found = {name: value / units[name] if typed(name) else value for name, value in {**times, **start}.items()}
    if not typed("transient"):
        found["transient"] = 0.75 * found["t_end"]
    if found["transient"] >= found["t_end"]:
        raise ParameterError(
            f"--transient = {found['transient'] * scales.time:.6g} s is not below --t-end = "
            f"{found['t_end'] * scales.time:.6g} s; nothing would be left to measure"
        )
    return {name: found[name] for name in times}, {name: found[name] for name in start}


def in_units(summary: dict[str, Any]) -> dict[str, Any]:
    """What is measured of a motion in the units of the file: lengths, forces, and the period in seconds."""
    study = current()
    if study is None:
        return summary
    size, end = length()
    forces = study.in_file("F_L", study.scales.force), f"_{study.quantities['F_L'].unit}"
    units = dict.fromkeys(("rms", "rms_about_mean", "mean", "amplitude", "error"), (size, end))
    units |= dict.fromkeys(("spring_force", "contact_force"), forces) | {"period": (study.scales.time, "_s")}
    found = {}
    for name, value in summary.items():
        unit, ending = units.get(name, (1.0, ""))
        scaled = [unit * one for one in value] if isinstance(value, list) and ending else value * unit if ending else value
        found[name + ending] = scaled
    return found
