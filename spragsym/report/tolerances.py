"""What varies within the tolerances of a brake: which quantities, how, together with which, and brakes at shares of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.special import ndtr, ndtri
from scipy.stats import qmc

from ..models.parameters import FloatArray
from . import brake_quantities, friction
from .study import Study
from .units import WITHIN, Measured


@dataclass(frozen=True)
class Normal:
    """A normal distribution between two ends, by its quantiles."""

    mean: float
    sd: float
    low: float
    high: float

    def cdf(self, value: Any) -> FloatArray:
        """The share of it up to a value."""
        least, most, here = (ndtr((end - self.mean) / self.sd) for end in (self.low, self.high, np.asarray(value)))
        return np.asarray(np.clip((here - least) / (most - least), 0.0, 1.0))

    def ppf(self, share: Any) -> FloatArray:
        """The value below which a share of it lies."""
        least, most = (ndtr((end - self.mean) / self.sd) for end in (self.low, self.high))
        value = self.mean + self.sd * ndtri(least + np.asarray(share) * (most - least))
        return np.asarray(np.clip(value, self.low, self.high))


def deciding(study: Study) -> tuple[str, ...]:
    """The quantities that decide whether it jumps: those of the balance of forces, and of the friction that works."""
    names = {*brake_quantities.balanced(study.model), *friction.depends_on(study)}
    return tuple(name for name in study.quantities if name in names)


def varied(study: Study) -> list[str]:
    """Those of them that have a tolerance."""
    return [name for name in deciding(study) if name in study.tolerances]


def quantile(one: Measured, share: Any) -> FloatArray:
    """The value of a quantity below which a share of its distribution within its ends lies."""
    if one.sd:
        return Normal(one.value, one.sd, one.low, one.high).ppf(share)
    return np.asarray(np.clip(one.low + np.asarray(share) * (one.high - one.low), one.low, one.high))


def values_at(study: Study, shares: FloatArray) -> dict[str, FloatArray]:
    """All quantities in SI, within their ranges, at shares of what is :func:`varied`, of shape (n, varied)."""
    values = {name: np.full(len(shares), value) for name, value in study.values.items()}
    allowed = brake_quantities.ranges(study.model, study.values)
    for j, name in enumerate(varied(study)):
        least, most = (allowed[name].reached(end) for end in (allowed[name].low, allowed[name].high))
        values[name] = np.clip(quantile(study.quantities[name], shares[:, j]), least, most)
    return values


def corners(study: Study) -> FloatArray:
    """Shares of the brake as drawn with most friction, and of all corners of the tolerances that may occur.

    Of what rises, or of quantities with which the friction does if it is that, the upper ends are enough, if independent.
    """
    names, rising = varied(study), _rising(study)
    together = study.together(names)
    found = together.corners()
    for group in together.groups:
        if len(group) == 1 and names[group[0]] in rising:
            found = found[found[:, group[0]] == 1.0]
    quantities = [study.quantities[name] for name in names]
    drawn = [[1.0 if name in rising else share_of(one) for name, one in zip(names, quantities, strict=True)]]
    return np.concatenate([np.array(drawn).reshape(1, -1), found])


def _rising(study: Study) -> set[str]:
    """Quantities of which a larger value has ended wherever a smaller one has."""
    rise = study.rise
    return friction.rising(study) if rise is None or rise.is_friction else {rise.quantity}


def share_of(one: Measured) -> float:
    """The share of a distribution within its ends that lies below its value."""
    if one.sd:
        least, middle, most = (float(ndtr((end - one.value) / one.sd)) for end in (one.low, one.value, one.high))
        return (middle - least) / (most - least)
    return (one.value - one.low) / (one.high - one.low)


def samples(study: Study, number: int) -> FloatArray:
    """Shares of Sobol' points, correlated as the quantities are."""
    names = varied(study)
    if not names:
        return np.zeros((1, 0))
    return study.together(names).shares(qmc.Sobol(len(names), rng=0).random(number))


def correlated(study: Study) -> dict[tuple[str, str], float]:
    """Pairs that vary together, of those that decide whether it jumps."""
    return {pair: value for pair, value in study.correlation.items() if set(pair) <= set(varied(study))}


def distribution(one: Measured) -> Any:
    """A quantity as a number, a range or a distribution.

    A normal distribution that is not cut off is taken to six standard deviations, beyond which lie 2e-9 of it.
    """
    if one.low == one.high:
        return one.value
    if not one.sd:
        return one.low, one.high
    if one.cut:
        return Normal(one.value, one.sd, one.low, one.high)
    return Normal(one.value, one.sd, one.value - WITHIN * one.sd, one.value + WITHIN * one.sd)
