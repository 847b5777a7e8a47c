"""The class of a model's parameters, made from its ``model.json``."""

import math
from collections.abc import Mapping
from dataclasses import field, make_dataclass
from typing import Any

from .parameters import ParameterSet, Range, named

#: Remedy for friction or a belt of the other sign.
MIRRORED = "a belt that runs the other way is the mirror image of the mechanism"
#: Options whose names are not those of their parameters.
_OPTIONS = {"V": ("--speed", "-V"), "d": ("--creep", "-d")}


#: What an angle without a base value is, as in the article's cases.
_INCLINATION = math.radians(30.0)


def ranges(about: Mapping[str, Any]) -> dict[str, Range]:
    """Allowed values of every parameter, in order."""
    return {entry["name"]: _range(entry) for entry in about["parameters"]}


def base(about: Mapping[str, Any]) -> dict[str, float]:
    """The base value of every parameter that has one."""
    return {entry["name"]: entry["base"] for entry in about["parameters"] if entry["base"] is not None}


def options_of(about: Mapping[str, Any], name: str) -> tuple[str, ...]:
    """What commands call a parameter: as for the article's model, unless another parameter has that name."""
    known = _OPTIONS.get(name)
    return known if known and known[0][2:] not in ranges(about) else (f"--{name}",)


def parameter_class(about: Mapping[str, Any], where: str) -> type[ParameterSet]:
    """A class whose fields are the model's parameters with their base values.

    ``where`` is what :func:`spragsym.load` takes for the model, by which a set finds its class again in another process.
    """
    values = base(about)
    names = [entry["name"] for entry in about["parameters"]]

    made = make_dataclass(
        "Parameters",
        [(name, Any, field(default=values.get(name))) for name in names],
        bases=(ParameterSet,),
        frozen=True,
        eq=False,
        repr=False,
        namespace={
            "__doc__": _documentation(about),
            "ranges": ranges(about),
            "spanned": frozenset(names),
            "origin": "model.Parameters(...)",
            "where": where,
        },
    )
    return named(made)


def base_case(about: Mapping[str, Any], made: type[ParameterSet]) -> tuple[tuple[str, ParameterSet], ...]:
    """One point of all parameters to begin at: base values, or an inclination, or the middle of a range."""
    values = {}
    for entry in about["parameters"]:
        low, high = entry["low"], entry["high"]
        angle = entry["name"] in about["angles"]
        middle = _INCLINATION if angle else 0.5 * (low + high) if low is not None and high is not None else 1.0
        values[entry["name"]] = middle if entry["base"] is None else entry["base"]
    return (("Base values", made(**values)),)


def _range(entry: Mapping[str, Any]) -> Range:
    low, high = (default if entry[end] is None else entry[end] for end, default in (("low", -math.inf), ("high", math.inf)))
    # Of the article's remedies only what is true of any page: which mirror image a belt has is not.
    remedy = MIRRORED if entry["name"] in ("mu0", "V") else f"it is the {entry['meaning']}"
    remedy = "angles are radians; use numpy.radians for degrees" if entry["unit"] == "rad" else remedy
    return Range(low, high, entry["low_open"] and not math.isinf(low), remedy, not entry["high_open"])


def _documentation(about: Mapping[str, Any]) -> str:
    lines = [
        f"Parameters of the model {about['name']}, scalars or arrays that broadcast together.",
        "",
        "Parameters",
        "----------",
    ]
    for entry in about["parameters"]:
        default = "" if entry["base"] is None else f", default {entry['base']:g}"
        unit = ", radians" if entry["unit"] == "rad" else ""
        lines += [f"{entry['name']} : array_like{default}", f"    {entry['meaning']}{unit}; allowed: {entry['domain']}"]
    return "\n".join(lines)
