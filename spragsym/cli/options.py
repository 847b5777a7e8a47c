"""Options that commands share: one name and one meaning everywhere."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeVar

import click

from ..errors import ParameterError
from ..parameters import ARTICLE, Parameters

F = TypeVar("F", bound=Callable[..., Any])

_PARAMETER_HELP = {
    "mu0": "Friction coefficient.",
    "kappa": "Preload F_L / (k_c L_0).",
    "alpha": "Stiffness along the belt, k_x / k_c.",
    "sigma": "Stiffness of the inclined spring, k / k_c.",
    "beta": "Stiffness across the belt, k_y / k_c.",
}


def parameters(function: F) -> F:
    """``--mu0 --kappa --alpha --sigma --beta``, with the article's base values as defaults."""
    for name, text in reversed(_PARAMETER_HELP.items()):
        function = click.option(f"--{name}", type=float, default=ARTICLE[name], show_default=True, help=text)(function)
    return function


def theta0(function: F) -> F:
    """``--theta0`` in degrees."""
    text = "Inclination of the undeformed spring, degrees."
    return click.option("--theta0", "theta0_deg", type=float, required=True, help=text)(function)


def belt(function: F) -> F:
    """``-V --speed`` and ``-d --creep``: belt speed and steepness of the friction law, which the article does not state."""
    for flag, short, name, default, text in (
        ("--creep", "-d", "d", 10.0, "Steepness d of the friction law. Our assumption."),
        ("--speed", "-V", "V", 0.5, "Belt speed V. Our assumption."),
    ):
        function = click.option(flag, short, name, type=float, default=default, show_default=True, help=text)(function)
    return function


def as_json(function: F) -> F:
    """``--json``."""
    return click.option("--json", "json_output", is_flag=True, help="Print JSON instead of a table.")(function)


def build(theta0_deg: float | None, **values: float) -> Parameters:
    """Parameters from the options of a command."""
    if theta0_deg is not None and not 0 < theta0_deg < 180:
        raise ParameterError(
            f"--theta0 = {theta0_deg:g} is not in (0, 180) degrees; give the inclination of the undeformed spring"
        )
    return Parameters(theta0=None if theta0_deg is None else math.radians(theta0_deg), **values)
