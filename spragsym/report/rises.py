"""What rises until the state jumps: the friction, of which the belt's speed decides how much works, or a quantity of the file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

import spragsym as ss

from ..bifurcation.points import ranges
from ..errors import ParameterError
from ..models.load import load
from ..models.parameters import as_number
from ..names import hint
from . import brake_quantities, friction

if TYPE_CHECKING:
    from .study import Study


@dataclass(frozen=True)
class Rise:
    """What rises: its quantity in the file, the parameter that it is in the model, and from where it rises, in SI.

    Friction is told as the friction of the law, of which :mod:`~spragsym.report.friction` says how much works; of any other
    quantity values are told as they are, in SI, and the friction stays.
    """

    quantity: str
    name: str
    begin: float

    @property
    def is_friction(self) -> bool:
        """Whether it is the friction at full slip."""
        return self.name == "mu0"

    @property
    def word(self) -> str:
        """What it is called in a sentence."""
        return "friction" if self.is_friction else self.quantity


def rise_of(model: str, vary: str | None, begin: float | None, values: Mapping[str, float]) -> Rise | None:
    """What rises in a study: the quantity that is named, else the friction at full slip; None for a model without it.

    ``begin`` and the quantities are in SI; without it the quantity rises from its least value.

    Raises
    ------
    ParameterError
        For what is no quantity, or one on which no state depends; for one that has no least value, without ``begin``; and for a
        ``begin`` that is not allowed, or above the value.
    """
    made = load(model)
    names = {entry["quantity"]: entry["name"] for entry in made.about["parameters"]}
    if vary is None:
        if begin is not None:
            raise ParameterError(f"begin = {begin!r} says from where a quantity rises; give vary, its name, too")
        return Rise("mu0", "mu0", 0.0) if "mu0" in names else None
    may = may_rise(model)
    if vary not in may:
        remark = hint(vary, may) or f"; what may rise is {', '.join(may)}"
        raise ParameterError(f"vary = {vary!r} is no quantity of {model} on which its states depend, or a unit{remark}")
    allowed = brake_quantities.ranges(model, values)[vary]
    if begin is None and not allowed.contains(allowed.low):
        raise ParameterError(f"vary = {vary!r} has no least value in {allowed}; give begin, from where it rises")
    start = allowed.low if begin is None else as_number("begin", begin, allowed)
    if names[vary] == "mu0" and start != allowed.low:
        raise ParameterError(f"begin = {start:g}: friction rises from {allowed.low:g}; leave begin out")
    rise = Rise(vary, names[vary], start)
    check(rise, values)
    return rise


def check(rise: Rise, values: Mapping[str, float]) -> None:
    """An error for a brake in which what rises is below where it begins."""
    if rise.begin > values[rise.quantity]:
        above = f"begin = {rise.begin:g} is above {rise.quantity} = {values[rise.quantity]:g}"
        raise ParameterError(f"{above}; begin where it is lower")


def may_rise(model: str) -> tuple[str, ...]:
    """Quantities on which the states of a model depend, without those that are the units of the others."""
    depends = brake_quantities.of_statics(model)
    return tuple(entry["quantity"] for entry in brake_quantities.about(model)["parameters"] if entry["quantity"] in depends)


def for_example(model: str) -> str:
    """One of them: an angle, a load or a stiffness before what the friction law takes, which may fall as the belt is faster."""
    law = brake_quantities.about(model)["friction"] or {"quantities": ()}
    return min(may_rise(model), key=lambda name: name in law["quantities"], default="F")


def _scale(model: str, quantity: str, values: Mapping[str, float]) -> float:
    return brake_quantities.scale_of(brake_quantities.quantity_units(model)[quantity], brake_quantities.bases(model, values))


def working(study: Study) -> tuple[float, float, float]:
    """What rises, where the brake works: least, as drawn, and largest within the tolerances; 0 where nothing is known to rise."""
    rise = study.rise
    if rise is None or rise.is_friction:
        return study.friction
    one = study.quantities[rise.quantity]
    return one.low, one.value, one.high


def full(study: Study) -> tuple[float, float, float]:
    """The same of the friction at full slip."""
    if study.rise is None or not study.rise.is_friction:
        return working(study)
    one = study.quantities["mu0"]
    return friction.of_statics(study, one.low), friction.of_statics(study, one.value), friction.of_statics(study, one.high)


def scale(study: Study) -> float:
    """What one of the parameter that rises is as it is told: in SI, in the units of the brake as drawn."""
    return _scale(study.model, of(study).quantity, study.values)


def units(study: Study) -> tuple[str, ...]:
    """The quantities that are units of what rises: with them its parameter changes."""
    kinds = {entry["name"]: entry["unit"] for entry in study.about["units"]}
    return tuple(name for name, power in brake_quantities.exponents(study.si(of(study).quantity), kinds).items() if power)


def told(study: Study, value: float) -> float:
    """A value of the parameter that rises as it is told: the friction of the law, or in SI."""
    return friction.of_statics(study, value) if of(study).is_friction else value * scale(study)


def begin(study: Study) -> float:
    """From where it rises, as its parameter in the units of the brake as drawn."""
    return float(_begin(study, study.values))


def _begin(study: Study, values: Mapping[str, Any]) -> Any:
    """The same in the units of other brakes, of which each begins at the same value in SI."""
    rise = of(study)
    allowed = load(study.model).Parameters.ranges[rise.name]
    return np.maximum(rise.begin / _scale(study.model, rise.quantity, values), allowed.reached(allowed.low))


def along(study: Study, values: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """What rises as arguments of the model's questions, which take friction at full slip unless told otherwise.

    Of the brake as drawn, or of brakes by their quantities in SI.
    """
    rise = of(study)
    return {} if rise.is_friction else {"vary": rise.name, "begin": _begin(study, values or study.values)}


def jump(study: Study) -> float:
    """Where the state jumps, as the parameter that rises; NaN where it does not."""
    rise = of(study)
    p = study.dimensionless if rise.is_friction else study.at_work
    return float(ss.jump_value(p, **along(study)))


def of(study: Study) -> Rise:
    """What rises, of a study of which something does."""
    assert study.rise is not None
    return study.rise


def amount(study: Study, value: float, digits: int = 4) -> str:
    """A value of what rises: a friction as a number, a quantity with its unit."""
    rise = study.rise
    return f"{value:.{digits}g}" if rise is None or rise.is_friction else study.shown(rise.quantity, value, digits)


def named(study: Study, value: float, digits: int = 4) -> str:
    """The same in a sentence: ``a friction of 0.4`` or ``P = 20 N``."""
    rise = of(study)
    return f"{'a friction of' if rise.is_friction else f'{rise.quantity} ='} {amount(study, value, digits)}"


def top(study: Study) -> float:
    """Up to which value a jump is looked for, as it is told: all, or the end of a search; NaN where nothing rises."""
    rise = study.rise
    if rise is None:
        return np.nan
    model = load(study.model)
    if rise.is_friction and "first_ends" in model.closed:
        return np.inf
    return told(study, float(ranges(model, (rise.name,), {})[0, 1]))


def looked(study: Study) -> str:
    """Where a jump is looked for, in a sentence: ``friction`` at all, or ``P up to 20 N``."""
    end = top(study)
    return of(study).word if np.isinf(end) else f"{of(study).word} up to {amount(study, end)}"


def risen(study: Study, values: Mapping[str, Any], target: float | None) -> Any:
    """Parameters of brakes, by their quantities in SI, where what rises is at a target, or at the own value that works."""
    rise, model = of(study), load(study.model)
    if target is not None and not rise.is_friction:
        values = {**values, rise.quantity: target}
    p = study.placed(brake_quantities.dimensionless(study.model, values)[0])
    if "mu0" in model.parameters:
        at_speed = friction.law_of(study) == "friction_at_speed"
        works = p.mu0 * (brake_quantities.share(model, p) if at_speed else 1.0)
        p = p.replace(mu0=np.broadcast_to(target if rise.is_friction and target is not None else works, p.shape))
    return p
