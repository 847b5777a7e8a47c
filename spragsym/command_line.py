"""Names of the options of commands, and those of the parameters of a model among them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

#: What commands call their own options, and the values of these.
OF_COMMANDS = frozenset(
    (
        "backend",
        "data",
        "diagram",
        "digits",
        "error",
        "estimate_error",
        "force",
        "help",
        "json",
        "json_output",
        "method",
        "model",
        "n",
        "near",
        "output",
        "plot",
        "points",
        "prove",
        "quiet",
        "rtol",
        "sound",
        "state",
        "store",
        "t_end",
        "transient",
        "trust",
        "undamped",
        "vary",
        "whole",
        "within",
        "workers",
    )
)


def options_of(about: Mapping[str, Any], name: str) -> tuple[str, ...]:
    """Options by which commands call a parameter: as for the article's model, unless another
    parameter has that name.
    """
    # Options whose names are not those of their parameters.
    options = {"V": ("--speed", "-V"), "d": ("--creep", "-d")}
    flags = options.get(name)
    if flags and flags[0][2:] not in {entry["name"] for entry in about["parameters"]}:
        return flags
    return (f"--{option_name(name)}",)


def option_name(name: str) -> str:
    """A parameter among the options of a command: with an underscore behind it where commands have
    an option of its name.
    """
    return f"{name}_" if name in OF_COMMANDS else name
