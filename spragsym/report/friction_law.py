"""Bounds, by intervals, of the friction in use within the tolerances, and the belt speed at which
friction reaches a value.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..bifurcation.tubes import halves
from ..design.certificates import corner_values
from ..models.parameters import FloatArray, Span
from ..models.quantities import Unit
from ..numerics.interval_arrays import Intervals
from ..statics.balance import BalanceInUnits
from ..statics.forces import as_intervals
from .units import Measured

if TYPE_CHECKING:
    from .study import Study


def friction_depends_on(study: Study) -> tuple[str, ...]:
    """Quantities on which the friction in use depends."""
    law, own = study.kind.law, study.kind.friction
    full = law["at_rest"] == "full" and study.law == "friction_at_rest"
    return (own,) if full and own is not None else tuple(law["quantities"])


def friction_bounds(study: Study) -> Span:
    """Bounds of the friction in use within the tolerances, by intervals."""
    law = _Law(study)
    least, most = -law.largest(-1), law.largest()
    # A friction that is proportional to μ₀ is not negative.
    return max(0.0, least) if study.kind.law["at_rest"] == "full" else least, most


def speed_for(study: Study, friction: float) -> float:
    """The smallest belt speed in m/s at which the largest friction within the tolerances reaches a
    value; NaN if none does.

    The speed is a little too small if the law is not monotonic over the tolerances, because the
    bounds by intervals are not sharp then.
    """
    if (
        not study.moves
        or study.law != "friction_at_speed"
        or study.belt is None
        or not study.values[study.belt]
    ):
        return math.nan
    law, name = _Law(study), study.kind.law["belt"]
    index = law.balance.parameters.index(name)
    speed = abs(float(study.dimensionless[name]))
    # Intervals of the speed up to 2³⁰ times the belt's own; the slowest is last, and taken first.
    parts = [
        (speed * 2.0**octave, speed * 2.0 ** (octave + 1)) for octave in reversed(range(30))
    ] + [(0.0, speed)]
    # Maximum number of intervals, boxes for a rough bound, relative width of the enclosure.
    most, boxes, narrow = 512, 64, 2.0**-44
    for _ in range(most):
        if not parts:
            return math.nan
        slow, fast = parts.pop()
        law.low[index], law.high[index] = slow, fast
        if law.largest(1, boxes) < friction:
            continue
        middle = 0.5 * (slow + fast)
        if fast - slow <= narrow * fast:
            return float(middle * study.scales.length / study.scales.time)
        parts += [(middle, fast), (slow, middle)]
    return math.nan


class _Law:
    """The friction law in use, over the box of the tolerances of the quantities on which it
    depends. Units of measure cancel.
    """

    def __init__(self, study: Study) -> None:
        names = study.kind.law["quantities"]
        exact = {
            name: replace(one, low=one.value, high=one.value)
            for name, one in study.quantities.items()
            if name not in names
        }
        low, high, units = parameter_ends(study.with_quantities({**study.quantities, **exact}))
        self.low, self.high = corner_values(low.model.parameters, low, high, units)
        self.balance = BalanceInUnits(low.model, units, study.law)
        self.place = low.model.rubbing.index(study.kind.law["name"])

    def over(self, low: FloatArray, high: FloatArray, sign: int = 1) -> Intervals:
        """Bounds of ``sign`` times the friction over boxes."""
        arguments = self.balance.over(Intervals.between(low, high))
        found = as_intervals(self.balance.at((), arguments).frictions[self.place], low.shape[1:])
        return found if sign > 0 else -found

    def largest(self, sign: int = 1, most: int = 1 << 12) -> float:
        """Upper bound of ``sign`` times the friction over the whole box, by branch and bound with
        at most ``most`` boxes: a box is bisected along the side over which the friction changes
        most.
        """
        low, high, above, done = self.low, self.high, np.full(1, np.inf), -np.inf
        for _ in range(60):
            above = self.over(low, high, sign).high
            best = max(float(self.over(end, end, sign).low.max()) for end in (low, high))
            # Boxes that may contain a larger value than the best one known.
            open_ = np.flatnonzero(above > best + 1e-9 * abs(best))
            if not open_.size or 2 * open_.size > most:
                break
            done = max(done, float(np.delete(above, open_).max(initial=-np.inf)))
            low, high = low[:, open_], high[:, open_]
            _, first, second = halves(
                low, high, np.array([self._moves(low, high, side) for side in range(len(low))])
            )
            low, high = np.concatenate([low, second], axis=1), np.concatenate([first, high], axis=1)
        return max(done, float(above.max()))

    def _moves(self, low: FloatArray, high: FloatArray, side: int) -> FloatArray:
        """Change of the friction over one side, at the midpoints of the others; −1 for a side
        without extent.
        """
        one, other = 0.5 * (low + high), 0.5 * (low + high)
        one[side], other[side] = low[side], high[side]
        found = self.over(one, other)
        return np.where(low[side] < high[side], found.high - found.low, -1.0)


def parameter_ends(study: Study) -> tuple[Any, Any, dict[str, Unit]]:
    """Parameters at the lower and at the upper ends of the tolerances in the study's units, rounded
    outward, and the units of measure that have tolerances themselves.
    """
    kind, low, high = study.kind, dict[str, float](), dict[str, float]()
    of_units: dict[str, dict[str, float]] = {name: {} for name in kind.bases}
    # Bound of a few rounding errors.
    rounded = 2.0**-48
    for quantity, name in kind.parameters.items():
        if quantity not in study.quantities:
            continue
        powers, allowed = kind.powers(kind.units[quantity]), kind.model.Parameters.ranges[name]
        for base, power in powers.items():
            if power:
                of_units[base][name] = -power
        off = rounded if any(powers.values()) else 0.0
        ends = outward(study.quantities[quantity], study.scale(kind.units[quantity]), off)
        low[name], high[name] = max(ends[0], allowed.low), min(ends[1], allowed.high)
    units = {
        f"{base}/{base}_0": Unit(*outward(study.quantities[base], study.values[base], rounded), of)
        for base, of in of_units.items()
        if of and study.quantities[base].varies
    }
    return study.placed(kind.model.Parameters(**low)), kind.model.Parameters(**high), units


def outward(one: Measured, scale: float, off: float) -> Span:
    """Ends divided by a scale, moved outward by a relative error ``off``."""
    return one.low / scale * (1 - math.copysign(off, one.low)), one.high / scale * (
        1 + math.copysign(off, one.high)
    )
