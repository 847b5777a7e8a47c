"""What the tolerances leave possible: a certificate for all of them, and the probability of a jump."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..design.certificates import Unit
from ..design.jump_probability import measured
from ..design.jumps import have_jumped
from ..design.probability import estimated, probability_table, variable
from ..design.tube_certificates import Splitting, certify
from ..display import Result, Table
from ..errors import ConvergenceError
from ..models.parameters import FloatArray, Range
from . import brake_quantities, rises, tolerance_boxes
from .effort import effort
from .friction import bounds, law_of
from .study import Study
from .tolerances import corners, correlated, deciding, distribution, quantile, samples, values_at, varied
from .units import Measured

#: Quantities with tolerances up to which their probability is bracketed by proof, and parts of them.
_MOST_SIDES, _PARTS = 4, 200
#: What a share of a distribution is rounded by, where values go over its width.
_ROUNDING = 2.0**-50
#: A share of the friction that is none.
_NOTHING = 1e-300


@dataclass(frozen=True)
class BoxCertificate(Result):
    """What is known of "nothing jumps" for every brake within the tolerances.

    ``outcome`` is ``"proved"``, ``"refuted"`` or ``"undecided"``; ``counterexample`` is a brake within the tolerances that jumps,
    in SI; ``undecided`` is the share of the box that is not proved. Of a normal distribution that is not cut off the box holds
    three standard deviations on either side, and nothing is said of what lies beyond.
    """

    claim: str
    outcome: str
    counterexample: Mapping[str, float] | None
    undecided: float
    boxes: int


@dataclass(frozen=True)
class Chance(Result):
    """The probability of a jump with its interval; Sobol' indices: first order, total, and the total's half-width.

    ``proved`` are bounds of the probability by proof, not by samples; (0, 1) where nothing was asked to be proved.
    """

    probability: float
    low: float
    high: float
    confidence: float
    n: int
    sobol: Mapping[str, tuple[float, float, float]]
    proved: tuple[float, float] = (0.0, 1.0)

    def as_table(self) -> Table:
        """The probability on the line above, and the indices."""
        rows = tuple((f"of {name}", *(f"{value:.4f}" for value in indices)) for name, indices in self.sobol.items())
        return probability_table("Chance", self, ("", "first order", "total", "±"), rows)


def certificate(study: Study, *, hasty: bool = False) -> BoxCertificate:
    """Whether any brake within the tolerances jumps: proved, refuted by one that does, or undecided; ``hasty`` ends earlier.

    Notes
    -----
    Source: :func:`spragsym.certify` over a box of the model's parameters and of the quantities that are their units, rounded
    outward. Of the friction that works the proof takes bounds, and a counterexample its own.
    """
    boxes, points = (amount[hasty] for amount in (effort(study).boxes, effort(study).points))
    point = counterexample(study, points)
    if point is not None:
        return BoxCertificate("no jump", "refuted", point, 0.0, 0)
    low, high, units = box(study)
    found = certify(low, high, "no jump", max_boxes=boxes, refute=False, units=units, **rises.along(study))
    # A part of the box where all jump need not hold a brake: the bounds of its friction may be loose.
    outcome = found.outcome if found.outcome == "proved" else "undecided"
    return BoxCertificate("no jump", outcome, None, found.undecided, found.boxes)


def counterexample(study: Study, number: int) -> dict[str, float] | None:
    """A brake within the tolerances that jumps, in SI: a corner if there is one, or one of some points."""
    for shares in (corners(study), samples(study, number)):
        found = np.flatnonzero(jumping(study, shares) == 1)
        if found.size:
            share = shares[found[0]]
            own = {name: float(quantile(study.quantities[name], share[j])) for j, name in enumerate(varied(study))}
            return {name: own.get(name, study.values[name]) for name in deciding(study)}
    return None


def chance(study: Study, n: int) -> Chance | None:
    """How probable a jump is with the distributions of the file, what varies together included; None where nothing varies."""
    if not varied(study):
        return None
    moving = {name: variable(name, distribution(study.quantities[name]), Range(-np.inf)) for name in varied(study)}
    variables = {**study.values, **moving}
    found = estimated(
        variables, lambda values: ending(study, values), correlation=correlated(study), n=n, rng=0, confidence=0.95, sobol=True,
        replicates=8, workers=1, progress=False,
    )  # fmt: skip
    indices = {
        name: (found.first[name], found.total[name], found.total_error[name])
        for name in sorted(found.total, key=lambda name: -np.nan_to_num(found.total[name]))
    }
    return Chance(found.probability, found.low, found.high, found.confidence, found.n, indices)


def jumping(study: Study, shares: FloatArray) -> FloatArray:
    """1 for the brakes that jump, 0 for those that don't, and NaN where that is not known."""
    return ending(study, values_at(study, shares))


def ending(study: Study, values: Mapping[str, Any], target: float | None = None, *, hasty: bool = False) -> FloatArray:
    """The same of brakes by their quantities in SI: up to a target, or up to the own value of each that works."""
    brakes = rises.risen(study, values, target)
    found: FloatArray = have_jumped(brakes, **rises.along(study, values), hasty=hasty)
    return found


def box(study: Study) -> tuple[Any, Any, dict[str, Unit]]:
    """Corners between which all brakes lie, as of :func:`tolerance_boxes.corners`, with the μ₀ of the friction that works.

    Of what rises from ``begin`` no less than that: a brake in which it is less has come to no end.
    """
    low, high, units = tolerance_boxes.corners(study)
    rise = rises.of(study)
    if not rise.is_friction:
        low = low.replace(**{rise.name: max(rises.begin(study), float(getattr(low, rise.name)))})
    if not _all_works(study):
        low, high = (p.replace(mu0=max(0.0, value)) for p, value in zip((low, high), bounds(study), strict=True))
    return low, high, units


def begins_alike(study: Study, after: Mapping[str, float]) -> bool:
    """Whether the state that is followed in a changed brake is the one that is followed in the brake as drawn.

    Where what rises begins behind its end in the changed brake, a state is taken up there that may end nowhere.
    """
    if rises.of(study).is_friction:
        return True
    ends = {name: sorted((study.values[name], value)) for name, value in after.items()}
    moved = {name: replace(study.quantities[name].alone, low=low, high=high) for name, (low, high) in ends.items()}
    alone = {name: one.alone for name, one in study.quantities.items()}
    low, high, units = box(study.with_quantities({**alone, **moved}))
    of = tolerance_boxes.sides(study)
    try:
        way = Splitting(low, high, rises.of(study).name, rises.begin(study), units)
        least, most = way.whole.low[:-1, 0], way.whole.high[:-1, 0]
        upward = np.array([after.get(name, 0.0) > study.values[name] for name in (of[side][0] for side in way.free)], dtype=bool)
        return way.begins_alike(np.where(upward, least, most), np.where(upward, most, least))
    except ConvergenceError:
        return False


def bracket(study: Study, parts: int = _PARTS) -> tuple[float, float]:
    """Bounds of the probability of a jump, by proof: what is proved to jump, and one minus what is proved not to.

    (0, 1) where quantities vary together, or more of them vary than parts can be made of, and where friction that works less than
    fully is not what rises.

    Notes
    -----
    Source: :func:`spragsym.design.jump_probability.measured` over the box of :func:`certificate`. Of the belt's speed and the
    law's steepness only how much of μ₀ works is taken, from least to most.
    """
    rise = rises.of(study)
    names = [name for name in varied(study) if name in brake_quantities.of_statics(study.model)]
    if not names or len(names) > _MOST_SIDES or correlated(study) or not (rise.is_friction or _all_works(study)):
        return 0.0, 1.0
    low, high, units = box(study)
    splitting, sides = Splitting(low, high, rise.name, rises.begin(study), units), tolerance_boxes.sides(study)
    laws = {side: _shares(study, *sides[side]) for side in splitting.free}
    up_to = (_shares(study, *sides[rise.name]),) * 2
    if rise.is_friction:
        least, most = _shares_that_work(study)
        up_to = _shares(study, "mu0", 1 / most), _shares(study, "mu0", 1 / least)
    below, above = measured(splitting, laws, up_to, parts)
    widths = [(one.high, one.high - one.low) for one in (study.quantities[name] for name in names)]
    off = parts * _ROUNDING * max(abs(end) / width for end, width in widths)
    return max(0.0, below - off), min(1.0, above + off)


def _all_works(study: Study) -> bool:
    """Whether statics takes the friction as the parameters have it, and not a share of μ₀."""
    said = study.about["friction"]
    return not said or said["at_rest"] != "mu0" or law_of(study) == "friction_at_rest"


def _shares_that_work(study: Study) -> tuple[float, float]:
    """Bounds of the share of μ₀ that works, over all tolerances but that of μ₀."""
    if _all_works(study):
        return 1.0, 1.0
    least, most = bounds(study.with_quantities({**study.quantities, "mu0": Measured(1.0, 1.0, 1.0, "")}))
    return max(_NOTHING, least), max(_NOTHING, most)


def _shares(study: Study, name: str, scale: float) -> Callable[[Any], Any]:
    """The share of a quantity up to some multiples of a scale."""
    law = variable(name, distribution(study.quantities[name]), Range(-np.inf))
    if isinstance(law, float):
        return lambda value: 1.0 * (np.asarray(value) * scale >= law)
    return lambda value: law.cdf(np.asarray(value) * scale)
