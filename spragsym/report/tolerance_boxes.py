"""Corners between which all brakes within the tolerances lie, in the parameters of the model."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from ..design.certificates import Unit
from ..models.load import load
from . import brake_quantities

if TYPE_CHECKING:
    from .study import Study

#: Some roundings of half a unit each.
ROUNDED = 2.0**-48


def corners(study: Study) -> tuple[Any, Any, dict[str, Unit]]:
    """Two sets of parameters at the study's own units, rounded outward, and units of measure that have tolerances too."""
    model, bases = load(study.model), brake_quantities.bases(study.model, study.values)
    kinds = {name: unit for name, (_, unit) in bases.items()}
    powers: dict[str, dict[str, float]] = {name: {} for name in bases}
    low, high = {}, {}
    for entry in model.about["parameters"]:
        name, unit, allowed = entry["name"], entry["quantity_unit"], model.Parameters.ranges[entry["name"]]
        if entry["quantity"] not in study.quantities:
            continue
        given, of = study.quantities[entry["quantity"]], brake_quantities.exponents(unit, kinds)
        for base, power in of.items():
            powers[base] |= {name: -power} if power else {}
        ends = outward(given.low, given.high, brake_quantities.scale_of(unit, bases), ROUNDED if any(of.values()) else 0.0)
        low[name], high[name] = max(ends[0], allowed.low), min(ends[1], allowed.high)
    units = {}
    for base, of in powers.items():
        given = study.quantities[base]
        if of and given.low < given.high:
            units[f"{base}/{base}_0"] = Unit(*outward(given.low, given.high, study.values[base], ROUNDED), of)
    return study.placed(model.Parameters(**low)), model.Parameters(**high), units


def sides(study: Study) -> dict[str, tuple[str, float]]:
    """Of each parameter, and of each unit, the quantity that it is, and what one of it is in SI."""
    bases = brake_quantities.bases(study.model, study.values)
    found = {f"{base}/{base}_0": (base, study.values[base]) for base in bases}
    for entry in study.about["parameters"]:
        found[entry["name"]] = entry["quantity"], brake_quantities.scale_of(entry["quantity_unit"], bases)
    return found


def outward(low: float, high: float, scale: float, off: float) -> tuple[float, float]:
    """Ends over a scale, the lower one no higher and the upper one no lower than they are."""
    return low / scale * (1 - math.copysign(off, low)), high / scale * (1 + math.copysign(off, high))
