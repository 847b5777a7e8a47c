"""Any model from its page: the quantities that it takes, with units, and its dimensionless parameters from them."""

from __future__ import annotations

import inspect
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from ..models.load import load
from ..models.parameters import Range
from .units import dimension, registry


def about(name: str) -> Mapping[str, Any]:
    """``model.json`` of a model."""
    return load(name).about


def quantity_units(name: str) -> dict[str, str]:
    """The physical quantities of a model, each with its SI unit; those that are the units of the others first."""
    data = about(name)
    found = {entry["name"]: entry["unit"] for entry in data["units"]}
    return found | {entry["quantity"]: entry["quantity_unit"] for entry in data["parameters"]}


def scale_of(unit: str, bases: Mapping[str, tuple[float, str]]) -> float:
    """What one dimensionless unit of a quantity is in SI: the product of powers of the model's units that has its dimension.

    Notes
    -----
    Source: dimensional analysis; the model's page makes three quantities of independent dimensions 1.

    Examples
    --------
    >>> bases = {"m": (4.0, "kg"), "k_c": (100.0, "N/m"), "L_0": (0.5, "m")}
    >>> round(scale_of("N", bases), 12), round(scale_of("s", bases), 12)
    (50.0, 0.2)
    """
    powers = exponents(unit, {name: base for name, (_, base) in bases.items()})
    result = 1.0
    for name, (value, _) in bases.items():
        result = result * value ** powers[name] if powers[name] else result  # exactly 1 for an angle or a number
    return result


def exponents(unit: str, bases: Mapping[str, str]) -> dict[str, float]:
    """Powers of the model's units, each with its SI unit, whose product has the dimension of a unit."""
    return dict(zip(bases, _exponents(unit, tuple(bases.values())), strict=True))


@cache
def _exponents(unit: str, bases: tuple[str, ...]) -> tuple[float, ...]:
    axes = ("[mass]", "[length]", "[time]")

    def powers(text: str) -> list[float]:
        known = dict(dimension(registry().parse_units(text.replace("1", "dimensionless") if text == "1" else text)))
        return [float(known.get(axis, 0.0)) for axis in axes]

    matrix = np.array([powers(base) for base in bases]).T
    return tuple(round(float(power), 9) for power in np.linalg.solve(matrix, np.array(powers(unit))))


def bases(name: str, values: Mapping[str, Any]) -> dict[str, tuple[float, str]]:
    """The quantities in SI that are the units of the others, each with its SI unit."""
    return {entry["name"]: (values[entry["name"]], entry["unit"]) for entry in about(name)["units"]}


def dimensionless(name: str, values: Mapping[str, Any]) -> tuple[Any, dict[str, float]]:
    """The parameters of a model from its quantities in SI, and the scales of length, time and force; of many brakes arrays."""
    units = bases(name, values)
    scales = {"length": scale_of("m", units), "time": scale_of("s", units), "force": scale_of("N", units)}
    return load(name).Parameters(**groups(name, values)), scales


def groups(name: str, values: Mapping[str, Any]) -> dict[str, Any]:
    """The dimensionless parameters by name, from quantities in SI of any number type."""
    units, given = bases(name, values), {}
    for entry in about(name)["parameters"]:
        quantity, unit = entry["quantity"], entry["quantity_unit"]
        if quantity in values:
            given[entry["name"]] = values[quantity] / scale_of(unit, units)
    return given


def ranges(name: str, values: Mapping[str, Any] | None = None) -> dict[str, Range]:
    """Where quantities may lie in SI: units of measure are positive, others as their parameters, at units of these values.

    Without values, in those of the parameters, of which ends other than 0 are rare.
    """
    model = load(name)
    found = {entry["name"]: Range(0.0, open_low=True) for entry in model.about["units"]}
    units = None if values is None else bases(name, values)
    for entry in model.about["parameters"]:
        allowed, unit = model.Parameters.ranges[entry["name"]], entry["quantity_unit"]
        scale = 1.0 if units is None else scale_of(unit, units)
        found[entry["quantity"]] = replace(allowed, low=scale * allowed.low, high=scale * allowed.high)
    return found


@cache
def balanced(name: str) -> tuple[str, ...]:
    """Quantities on which the balance of forces depends besides its friction, in the order of the page."""
    model = load(name)
    taken = set(inspect.signature(model.algebra.forces).parameters)
    kinds = {entry["name"]: entry["unit"] for entry in model.about["units"]}
    found: set[str] = set()
    for entry in model.about["parameters"]:
        if taken & {entry["name"], *model.about["angles"].get(entry["name"], ())}:
            powers = exponents(entry["quantity_unit"], kinds)
            found |= {entry["quantity"], *(base for base, power in powers.items() if power)}
    return tuple(quantity for quantity in quantity_units(name) if quantity in found)


@cache
def of_statics(name: str) -> tuple[str, ...]:
    """The same, and those of the friction that works at rest: all on which the states of a model depend."""
    law = about(name)["friction"] or {"quantities": (), "at_rest": ""}
    friction = ("mu0",) if law["at_rest"] == "mu0" else law["quantities"]
    return tuple(quantity for quantity in quantity_units(name) if quantity in (*balanced(name), *friction))


@cache
def of_the_law(name: str) -> tuple[str, ...]:
    """Quantities that a brake may be given without: those of the friction law alone, without which friction is μ₀, at full slip.

    Of a law that is not proportional to mu0, or not mu0 at full slip, there are none.
    """
    law = about(name)["friction"]
    if not law or law["at_rest"] != "mu0":
        return ()
    return tuple(quantity for quantity in law["quantities"] if quantity not in (*balanced(name), "mu0"))


def share(model: Any, p: Any) -> Any:
    """The share of μ₀ at which friction works at the speed of the belt, by the model's own law; of the shape of ``p``."""
    full, works = (model.friction(p, law) for law in ("friction_at_rest", "friction_at_speed"))
    return np.where(full > 0, works / np.where(full > 0, full, 1.0), 1.0)[()]
