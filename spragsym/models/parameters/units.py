"""Units of measure that have ranges: what depends on them, and what they may be."""

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

from ...errors import ParameterError, ParameterTypeError


@dataclass(frozen=True)
class Unit:
    """A unit of measure that has a range too: its ends over its base value, and the power of it in each parameter.

    A parameter is P u₁^e₁ u₂^e₂ …, where P is what it is at the base values.
    """

    low: float
    high: float
    powers: Mapping[str, float]


def checked_units(units: Mapping[str, Unit] | None, parameters: Collection[str], angles: Collection[str]) -> dict[str, Unit]:
    """Units by name, without powers that are 0, for a model with these parameters, of which some are angles; or an error."""
    if not isinstance(units or {}, Mapping):
        raise ParameterTypeError(f"units = {units!r:.60} is no mapping; give units by name")
    found = {}
    for name, unit in (units or {}).items():
        if not isinstance(unit, Unit):
            raise ParameterTypeError(f"units[{name!r}] = {unit!r:.60} is no Unit; make one with Unit(low, high, powers)")
        if name in parameters:
            raise ParameterError(f"units: {name!r} is a parameter of the model; give the unit another name")
        if not 0 < unit.low <= unit.high < math.inf:
            raise ParameterError(f"units[{name!r}]: from {unit.low} to {unit.high}; give two ends above 0, the smaller first")
        for of, power in unit.powers.items():
            if of not in parameters:
                raise ParameterError(
                    f"units[{name!r}]: {of!r} is not a parameter of the model; there are {', '.join(parameters)}"
                )
            if not math.isfinite(power) or (power and of in angles):
                raise ParameterError(
                    f"units[{name!r}]: {of} has the power {power} of it; give a finite one, and none for an angle"
                )
        found[name] = replace(unit, powers={of: power for of, power in unit.powers.items() if power})
    return found
