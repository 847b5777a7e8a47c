"""Corners between which all brakes within the tolerances lie, in the parameters of the model."""

import math
from typing import Any

from ..models.parameters.units import Unit
from .study import Study
from .units import Measured

#: Some roundings of half a unit each.
ROUNDED = 2.0**-48


def corners(study: Study) -> tuple[Any, Any, dict[str, Unit]]:
    """Two sets of parameters at the study's own units, rounded outward, and units of measure that have tolerances too."""
    kind, low, high = study.kind, dict[str, float](), dict[str, float]()
    of_units: dict[str, dict[str, float]] = {name: {} for name in kind.bases}
    for quantity, name in kind.parameters.items():
        if quantity not in study.quantities:
            continue
        powers, allowed = kind.powers(kind.units[quantity]), kind.model.Parameters.ranges[name]
        for base, power in powers.items():
            of_units[base] |= {name: -power} if power else {}
        off = ROUNDED if any(powers.values()) else 0.0
        ends = outward(study.quantities[quantity], study.scale(kind.units[quantity]), off)
        low[name], high[name] = max(ends[0], allowed.low), min(ends[1], allowed.high)
    units = {
        f"{base}/{base}_0": Unit(*outward(study.quantities[base], study.values[base], ROUNDED), of)
        for base, of in of_units.items() if of and study.quantities[base].varies
    }  # fmt: skip
    return study.placed(kind.model.Parameters(**low)), kind.model.Parameters(**high), units


def outward(one: Measured, scale: float, off: float) -> tuple[float, float]:
    """Ends over a scale, the lower one no higher and the upper one no lower than they are."""
    return one.low / scale * (1 - math.copysign(off, one.low)), one.high / scale * (1 + math.copysign(off, one.high))


def sides(study: Study) -> dict[str, tuple[str, float]]:
    """For each parameter and each unit the quantity that it is, and its unit in SI."""
    kind = study.kind
    return {f"{base}/{base}_0": (base, study.values[base]) for base in kind.bases} | {
        name: (quantity, study.scale(kind.units[quantity])) for quantity, name in kind.parameters.items()
    }
