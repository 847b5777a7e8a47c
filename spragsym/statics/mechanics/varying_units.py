"""The balance of forces where the units of measure have tolerances too: dimensional analysis, p = P u₁^e₁ u₂^e₂ ….

P is a parameter as the base values of the page's units make it dimensionless, and u is a unit's value over its base value. Many
parameters depend on one unit; the chain rule keeps that, where boxes of the parameters themselves would take each for its own.
"""

from collections.abc import Iterable, Mapping, Sequence
from functools import reduce
from operator import mul
from typing import Any

import numpy as np

from ...models.parameters.units import Unit
from ...numerics.interval_arrays import Intervals, stacked
from .balance import Balance
from .forces import Model, Values
from .laws import XP


class BalanceInUnits(Balance):
    """The balance with units among its parameters, after those of the model."""

    def __init__(self, model: Model, contact: bool, units: Mapping[str, Unit], law: str = "friction_at_rest") -> None:
        super().__init__(model, contact, law)
        self.units = units
        #: Parameters of the balance that depend on each unit; a unit on which none does matters to the motion alone.
        self.scaling = {unit: [name for name in self.balanced if name in one.powers] for unit, one in units.items()}
        self.matter = [unit for unit, names in self.scaling.items() if names]
        #: p/P as arguments of their own, by parameter.
        self.factors = {name: f"{name}/P" for name in self.parameters if any(name in unit.powers for unit in units.values())}
        self.parameters += units
        #: Those that are asked for: the law at rest depends on nothing of the motion.
        self.needed = [name for name in self.factors if law != "friction_at_rest" or name in self.balanced]
        self.codes += [*units, *(self.factors[name] for name in self.needed)]

    def scaled(self, values: Values, xp: Any = np, names: Iterable[str] | None = None) -> dict[str, Any]:
        """P and u by name, of any number type, with the page's parameters p in place of P, all or some, and beside them p/P."""
        found = dict(values)
        for name in self.factors if names is None else names:
            code = self.factors[name]
            powers = ((values[key], unit.powers[name]) for key, unit in self.units.items() if name in unit.powers)
            found[code] = reduce(mul, (_power(value, power, xp) for value, power in powers))
            found[name] = _times(values[name], found[code])
        return found

    def prepared(self, bounds: Intervals) -> Intervals:
        """Arguments of the generated functions, units and p/P."""
        found = self.scaled(dict(zip(self.parameters, bounds, strict=True)), XP, self.needed)
        shape = bounds.shape[1:]
        known = super().prepared(stacked([found[name] for name in self.parameters], shape))
        return Intervals(np.concatenate([known.ends, *(found[self.factors[name]].ends[:, None] for name in self.needed)], axis=1))

    def arguments_of(self, values: Values, xp: Any) -> dict[str, Any]:
        """Arguments by name, of any number type."""
        return super().arguments_of(self.scaled(values, xp, self.needed), xp)

    def by_parameters(
        self, names: Sequence[str], q: Sequence[Any], directions: Sequence[Any], values: Values, xp: Any = XP
    ) -> list[list[Any]]:
        """Derivatives by P, and by u: Σ e p/u ∂/∂p over the parameters that depend on it."""
        needed = sorted({part for name in names for part in self.scaling.get(name, [name])})
        rows = super().by_parameters(needed, q, directions, values, xp)
        return [[self._slope(name, dict(zip(needed, row, strict=True)), values) for name in names] for row in rows]

    def _slope(self, name: str, slopes: Mapping[str, Any], values: Values) -> Any:
        if name in self.units:
            powers = self.units[name].powers
            return sum(slopes[key] * values[key] * powers[key] for key in self.scaling[name]) / values[name]
        return slopes[name] * values[self.factors[name]] if name in self.factors else slopes[name]


def _power(value: Any, power: float, xp: Any) -> Any:
    whole = int(power)
    if whole == power:
        return value**whole if whole > 0 else 1 / value**-whole
    return xp.exp(power * xp.log(value))


def _times(value: Any, factor: Any) -> Any:
    """Their product; what is 0, and an end that is, stays so."""
    if isinstance(value, int) and not value:
        return value
    product = value * factor
    return Intervals(np.where(value.ends == 0, 0.0, product.ends)) if isinstance(value, Intervals) else product
