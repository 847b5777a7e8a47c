"""The effective friction at the speed of the belt, by the model's law, within the tolerances; and the speed for a friction."""

import itertools
import math

import numpy as np

from ..models.parameters import FloatArray
from ..numerics.interval_arrays import Intervals, stacked
from ..numerics.jets import gradient, variables
from ..statics.mechanics.balance import NOTHING
from ..statics.mechanics.varying_units import BalanceInUnits
from .study import Study
from .tolerance_boxes import corners

#: How closely the ends of the friction are enclosed, relative; in how many halvings, and in how many boxes at once, or few.
CLOSE, HALVINGS, MOST, FEW = 1e-9, 60, 1 << 12, 1 << 6
#: Times the belt's own speed up to which a speed is looked for, as a power of two; how closely; and parts that are looked at.
OCTAVES, SHARP, PARTS = 30, 2.0**-44, 1 << 12


def working(study: Study) -> tuple[float, float, float]:
    """The friction that works: least, as drawn, and largest within the tolerances; 0 for a model without friction.

    The ends are those of the law at the corners of the tolerances; where it says less or more between them, they are bounds.
    """
    p = study.dimensionless
    if not study.kind.about["friction"]:
        return 0.0, 0.0, 0.0
    here = float(p.model.friction(p, study.law))
    names = [name for name in depends_on(study) if name in study.tolerances]
    ends = itertools.product(*((study.quantities[name].low, study.quantities[name].high) for name in names))
    at = study.kind.parameter_set({**study.values, **dict(zip(names, np.array(list(ends)).T, strict=True))})
    at_corners = np.atleast_1d(p.model.friction(at, study.law)).tolist()
    least, most = min(here, *at_corners), max(here, *at_corners)
    below, above = bounds(study)
    return (
        least if below >= least - CLOSE * abs(least) - NOTHING else below, here,
        most if above <= most + CLOSE * abs(most) + NOTHING else above,
    )  # fmt: skip


def depends_on(study: Study) -> tuple[str, ...]:
    """Quantities on which the friction that works depends."""
    law = study.kind.law
    return ("mu0",) if law["at_rest"] == "mu0" and study.law == "friction_at_rest" else tuple(law["quantities"])


def rising(study: Study) -> set[str]:
    """Quantities along which friction is proved not to fall, over all tolerances."""
    if not study.kind.about["friction"]:
        return set()
    law = _Law(study)
    prepared, shape = law.balance.prepared(Intervals.between(law.low, law.high)), law.low.shape[1:]
    of = {quantity: name for quantity, name in study.kind.parameters.items() if quantity in depends_on(study)}
    jets = variables([prepared[law.balance.codes.index(name)] for name in of.values()], 1)
    arguments = law.balance.arguments(prepared, dict(zip(of.values(), jets, strict=True)))
    slopes = gradient(law.balance.friction(arguments), len(of))
    return {name for name, slope in zip(of, slopes, strict=True) if (stacked([slope], shape).low >= 0).all()}


def bounds(study: Study) -> tuple[float, float]:
    """Bounds of the friction that works for everything within the tolerances, by intervals."""
    law = _Law(study)
    least, most = -law.largest(-1.0), law.largest(1.0)
    # A law that is proportional to μ₀ does not drive.
    return max(0.0, least) if study.kind.law["at_rest"] == "mu0" else least, most


def speed_for(study: Study, friction: float) -> float:
    """The least speed of the belt in m/s at which the largest friction within the tolerances is this one; NaN where none is.

    It is a little less where the law neither rises nor falls over the tolerances, where bounds over intervals are loose.
    """
    if not study.moves or study.law != "friction_at_speed" or study.belt is None or not study.values[study.belt]:
        return math.nan
    law, name = _Law(study), study.kind.law["belt"]
    place, speed = law.balance.parameters.index(name), abs(float(getattr(study.dimensionless, name)))
    parts = [(speed * 2.0**octave, speed * 2.0 ** (octave + 1)) for octave in reversed(range(OCTAVES))] + [(0.0, speed)]
    for _ in range(PARTS):
        if not parts:
            return math.nan
        slow, fast = parts.pop()
        law.low[place], law.high[place] = slow, fast
        if law.largest(1.0, FEW) < friction:
            continue
        middle = 0.5 * (slow + fast)
        if fast - slow <= SHARP * fast:
            return float(middle * study.scales.length / study.scales.time)
        parts += [(middle, fast), (slow, middle)]
    return math.nan


class _Law:
    """The law that works, and corners within the tolerances of all on which it depends; units of measure cancel in it."""

    def __init__(self, study: Study) -> None:
        names = study.kind.law["quantities"]
        taken = {name: one if name in names else one.alone for name, one in study.quantities.items()}
        low, high, units = corners(study.with_quantities(taken))
        self.low, self.high = (
            np.array([[value] for value in (*corner.scalars(*corner.ranges), *(getattr(unit, side) for unit in units.values()))])
            for corner, side in ((low, "low"), (high, "high"))
        )
        self.balance = BalanceInUnits(low.model, True, units, study.law)

    def between(self, low: FloatArray, high: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Bounds of the law over boxes."""
        arguments = self.balance.over(Intervals.between(low, high))
        found = stacked([self.balance.friction(arguments)], low.shape[1:])
        return found.low[0], found.high[0]

    def largest(self, sign: float, most: int = MOST) -> float:
        """A bound of ± the law over the box: parts are halved along the side over which it moves most, until it is close."""
        low, high = self.low, self.high
        above, done, near, far = np.full(1, np.inf), -np.inf, *((0, 1) if sign > 0 else (1, 0))
        for _ in range(HALVINGS):
            above = sign * self.between(low, high)[far]
            best = max(float((sign * self.between(end, end)[near]).max()) for end in (low, high))
            open_ = np.flatnonzero(above > best + CLOSE * abs(best))
            if not open_.size or 2 * open_.size > most:
                break
            done = max(done, float(np.delete(above, open_).max(initial=-np.inf)))
            low, high = low[:, open_], high[:, open_]
            middle = 0.5 * (low + high)
            side, rows = np.argmax([self._moves(low, high, side) for side in range(len(low))], axis=0), np.arange(open_.size)
            first, second = high.copy(), low.copy()
            first[side, rows] = second[side, rows] = middle[side, rows]
            low, high = np.concatenate([low, second], axis=1), np.concatenate([first, high], axis=1)
        return max(done, float(above.max()))

    def _moves(self, low: FloatArray, high: FloatArray, side: int) -> FloatArray:
        """By how much the law moves over one side, all others in their middles."""
        one, other = 0.5 * (low + high), 0.5 * (low + high)
        one[side], other[side] = low[side], high[side]
        least, most = self.between(one, other)
        return np.where(low[side] < high[side], most - least, -1.0)
