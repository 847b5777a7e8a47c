"""The friction that works at the speed of the belt, by the model's law, within the tolerances; and the speed for a friction."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING

import numpy as np

from ..models.load import load
from ..models.parameters import FloatArray
from ..numerics.interval_arrays import Intervals, stacked
from ..numerics.jets import gradient, variables
from ..statics.mechanics.balance import NOTHING, Balance
from ..statics.mechanics.varying_units import BalanceInUnits
from . import brake_quantities
from .tolerance_boxes import corners

if TYPE_CHECKING:
    from .study import Study

#: How closely the ends of the friction are enclosed, relative; in how many halvings, and in how many boxes at once, or few.
CLOSE, HALVINGS, MOST, FEW = 1e-9, 60, 1 << 12, 1 << 6
#: Times the belt's own speed up to which a speed is looked for, as a power of two; how closely; and parts that are looked at.
OCTAVES, SHARP, PARTS = 30, 2.0**-44, 1 << 12


def law_of(study: Study) -> str:
    """Which friction works: that at the belt's speed where it is known and statics can take it, else what statics takes.

    Statics takes μ₀, to which the law is proportional, or the law at the belt's speed itself; of other laws no value of μ₀ stands
    for the friction at a speed.
    """
    said = study.about["friction"]
    if not said:
        return "friction_at_rest"
    known = said["belt"] != "0" and set(said["quantities"]) <= set(study.quantities)
    return "friction_at_speed" if known and said["at_rest"] != "other" else "friction_at_rest"


def drawn(study: Study) -> float:
    """The friction that works as drawn; 0 for a model without friction."""
    p = study.dimensionless
    return float(p.model.friction(p, law_of(study))) if p.model.about["friction"] else 0.0


def share(study: Study) -> float:
    """The share of the friction of statics that works at the speed of the belt; 1 where that is not known."""
    p = study.dimensionless
    if not p.model.about["friction"] or law_of(study) == "friction_at_rest":
        return 1.0
    return float(brake_quantities.share(p.model, p))


def of_statics(study: Study, mu0: float) -> float:
    """The friction that statics takes with a value of μ₀."""
    p = study.dimensionless
    return float(p.model.friction(p.replace(mu0=mu0), "friction_at_rest")) if mu0 < math.inf else mu0


def working(study: Study) -> tuple[float, float, float]:
    """The friction that works: least, as drawn, and largest within the tolerances.

    Notes
    -----
    The ends are those of the law at the corners of the tolerances; where it says less or more between them, they are bounds.
    """
    here = drawn(study)
    if not study.dimensionless.model.about["friction"]:
        return here, here, here
    at_corners = _at_corners(study)
    least, most = min(here, *at_corners), max(here, *at_corners)
    below, above = bounds(study)
    return (
        least if below >= least - CLOSE * abs(least) - NOTHING else below, here,
        most if above <= most + CLOSE * abs(most) + NOTHING else above,
    )  # fmt: skip


def _at_corners(study: Study) -> list[float]:
    model = load(study.model)
    names = _deciding(study)
    ends = [(study.quantities[name].low, study.quantities[name].high) for name in names]
    rows = np.array(list(itertools.product(*ends)))
    p, _ = brake_quantities.dimensionless(study.model, {**study.values, **dict(zip(names, rows.T, strict=True))})
    found: list[float] = np.atleast_1d(model.friction(p, law_of(study))).tolist()
    return found


def _deciding(study: Study) -> list[str]:
    """Quantities with tolerances on which the friction depends."""
    return [name for name in depends_on(study) if name in study.tolerances]


def depends_on(study: Study) -> tuple[str, ...]:
    """Quantities on which the friction that works depends."""
    said = study.about["friction"]
    if said and said["at_rest"] == "mu0" and law_of(study) == "friction_at_rest":
        return ("mu0",)
    return tuple(said["quantities"]) if said else ()


def rising(study: Study) -> set[str]:
    """Those of them along which it is proved not to fall, over all tolerances."""
    if not study.about["friction"]:
        return set()
    law, low, high = _law_and_box(study)
    prepared = law.prepared(Intervals.between(low, high))
    of = {entry["quantity"]: entry["name"] for entry in study.about["parameters"] if entry["quantity"] in depends_on(study)}
    jets = variables([prepared[law.codes.index(name)] for name in of.values()], 1)
    slopes = gradient(law.friction(law.arguments(prepared, dict(zip(of.values(), jets, strict=True)))), len(of))
    return {name for name, slope in zip(of, slopes, strict=True) if (stacked([slope], low.shape[1:]).low >= 0).all()}


def bounds(study: Study) -> tuple[float, float]:
    """Bounds of the friction that works for everything within the tolerances, by intervals."""
    law, low, high = _law_and_box(study)
    least = -_largest(law, low, high, -1.0)
    # A law that is proportional to μ₀ does not drive.
    return max(0.0, least) if study.about["friction"]["at_rest"] == "mu0" else least, _largest(law, low, high, 1.0)


def _law_and_box(study: Study) -> tuple[BalanceInUnits, FloatArray, FloatArray]:
    """The law that works, and corners of all on which it depends, within the tolerances.

    Of what the law does not depend on it does not matter which value is taken: units of measure cancel in it.
    """
    names = study.about["friction"]["quantities"]
    taken = {name: one if name in names else one.alone for name, one in study.quantities.items()}
    low, high, units = corners(study.with_quantities(taken))
    one, other = (
        np.array([[value] for value in (*corner.scalars(*corner.ranges), *(getattr(unit, side) for unit in units.values()))])
        for corner, side in ((low, "low"), (high, "high"))
    )
    return BalanceInUnits(low.model, True, units, law_of(study)), one, other


def _largest(law: BalanceInUnits, low: FloatArray, high: FloatArray, sign: float, most: int = MOST) -> float:
    """A bound of ± the law over a box: parts are halved along the side over which it moves most, until it is close."""
    above, done = np.full(1, np.inf), -np.inf
    for _ in range(HALVINGS):
        above = sign * _law(law, low, high)[1 if sign > 0 else 0]
        best = float((sign * _law(law, low, low)[0 if sign > 0 else 1]).max())
        best = max(best, float((sign * _law(law, high, high)[0 if sign > 0 else 1]).max()))
        open_ = np.flatnonzero(above > best + CLOSE * abs(best))
        if not open_.size or 2 * open_.size > most:
            break
        done = max(done, float(np.delete(above, open_).max(initial=-np.inf)))
        low, high = low[:, open_], high[:, open_]
        middle = 0.5 * (low + high)
        moves = [_moves(law, low, high, middle, side) for side in range(len(low))]
        side, rows = np.argmax(moves, axis=0), np.arange(open_.size)
        first, second = high.copy(), low.copy()
        first[side, rows] = second[side, rows] = middle[side, rows]
        low, high = np.concatenate([low, second], axis=1), np.concatenate([first, high], axis=1)
    return max(done, float(above.max()))


def _moves(law: BalanceInUnits, low: FloatArray, high: FloatArray, middle: FloatArray, side: int) -> FloatArray:
    """By how much the law moves over one side, all others in their middles."""
    one, other = middle.copy(), middle.copy()
    one[side], other[side] = low[side], high[side]
    ends = _law(law, one, other)
    moves: FloatArray = np.where(low[side] < high[side], ends[1] - ends[0], -1.0)
    return moves


def _law(law: Balance, low: FloatArray, high: FloatArray) -> tuple[FloatArray, FloatArray]:
    found = stacked([law.friction(law.arguments(law.prepared(Intervals.between(low, high))))], low.shape[1:])
    return found.low[0], found.high[0]


def speed_for(study: Study, friction: float) -> float:
    """The least speed of the belt in m/s at which the largest friction within the tolerances is this one; NaN where none is.

    Notes
    -----
    Source: bounds of the model's law over intervals of the speed, from 0 up to 2³⁰ times the belt's own, and over all other
    tolerances. Where the law neither rises nor falls in these, its bounds are loose, and it is a little less than that.
    """
    if not study.moves or law_of(study) != "friction_at_speed" or study.belt is None or not study.values[study.belt]:
        return math.nan
    law, low, high = _law_and_box(study)
    name = study.about["friction"]["belt"]
    place, speed = law.parameters.index(name), abs(float(getattr(study.dimensionless, name)))

    def reaches(slow: float, fast: float) -> bool:
        low[place], high[place] = slow, fast
        return _largest(law, low, high, 1.0, FEW) >= friction

    parts = [(speed * 2.0**octave, speed * 2.0 ** (octave + 1)) for octave in reversed(range(OCTAVES))] + [(0.0, speed)]
    for _ in range(PARTS):
        if not parts:
            return math.nan
        slow, fast = parts.pop()
        if not reaches(slow, fast):
            continue
        middle = 0.5 * (slow + fast)
        if fast - slow <= SHARP * fast:
            return float(middle * study.scales.length / study.scales.time)
        parts += [(middle, fast), (slow, middle)]
    return math.nan
