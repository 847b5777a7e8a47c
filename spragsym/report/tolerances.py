"""Variation within the tolerances of a brake: brakes at shares of it, corners, proofs and probabilities."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.stats import qmc

from ..design.jump_probability import measured
from ..design.jumps import have_jumped
from ..design.probability import JumpProbability, estimated
from ..design.tube_certificates import Splitting, certify
from ..errors import ConvergenceError
from ..models.parameters import FloatArray
from ..models.parameters.units import Unit
from ..results.result import Result
from . import friction, tolerance_boxes
from .study import Study
from .units import Measured

#: Quantities with tolerances up to which their probability is bracketed by proof, and parts of them.
_MOST_SIDES, _PARTS = 4, 200
#: What a share of a distribution is rounded by, where values go over its width.
_ROUNDING = 2.0**-50
#: A share of the friction that is none.
_NOTHING = 1e-300


@dataclass(frozen=True)
class Effort:
    """How much is looked at where states are followed: ``samples`` of a probability, ``boxes`` of a proof and the ``points`` at
    which it is refuted; of a change, ``shares`` that are sampled where it is not proved, and ``many`` where not even a sample
    jumps; the ``most`` single quantities that are the nearest are proved, each ``further`` by these shares of what is left.
    """

    samples: int = 2048
    boxes: int = 4000
    points: int = 512
    boxes_of_change: int = 3000
    points_of_change: int = 64
    shares: int = 1 << 8
    many: int = 1 << 11
    most: int = 4
    further: tuple[float, ...] = (0.0, 0.03, 0.3)


#: By closed forms, in thousands of a second, more.
_CLOSED = Effort(
    samples=4096, boxes=20_000, points=1024, boxes_of_change=1000, points_of_change=1024, shares=1 << 10, many=1 << 17,
    most=16, further=(0.0, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0),
)  # fmt: skip


def effort(study: Study) -> Effort:
    """Effort for the study's model, whose closed forms are of rising friction."""
    return _CLOSED if study.closed else Effort()


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


def deciding(study: Study) -> tuple[str, ...]:
    """The quantities that decide whether it jumps: those of the balance of forces, and of the friction that works."""
    names = {*study.kind.balanced, *friction.depends_on(study)}
    return tuple(name for name in study.quantities if name in names)


def varied(study: Study) -> list[str]:
    """Quantities that have a tolerance."""
    return [name for name in deciding(study) if study.quantities[name].varies]


def values_at(study: Study, shares: FloatArray) -> dict[str, FloatArray]:
    """All quantities in SI, within their ranges, at shares of what is :func:`varied`, of shape (n, varied)."""
    values = {name: np.full(len(shares), value) for name, value in study.values.items()}
    allowed = study.kind.ranges(study.values)
    for j, name in enumerate(varied(study)):
        least, most = (allowed[name].reached(end) for end in (allowed[name].low, allowed[name].high))
        values[name] = np.clip(study.quantities[name].ppf(shares[:, j]), least, most)
    return values


def corners(study: Study) -> FloatArray:
    """Shares of the brake as drawn with most friction, and of all corners of the tolerances that may occur, at upper ends only of
    what rises, or of quantities with which the friction does."""
    names = varied(study)
    rising = friction.rising(study) if study.rise is None or study.of_friction else {study.rise.quantity}
    together = study.together(names)
    found = together.corners()
    for group in together.groups:
        if len(group) == 1 and names[group[0]] in rising:
            found = found[found[:, group[0]] == 1.0]
    drawn = [1.0 if name in rising else float(study.quantities[name].cdf(study.values[name])) for name in names]
    return np.concatenate([np.array(drawn).reshape(1, -1), found])


def samples(study: Study, number: int) -> FloatArray:
    """Shares of Sobol' points, correlated as the quantities are."""
    names = varied(study)
    return study.together(names).shares(qmc.Sobol(len(names), rng=0).random(number)) if names else np.zeros((1, 0))


def jumping(study: Study, shares: FloatArray) -> FloatArray:
    """1 for the brakes that jump, 0 for those that don't, and NaN where that is not known."""
    return ending(study, values_at(study, shares))


def ending(study: Study, values: Mapping[str, Any], target: float | None = None, *, hasty: bool = False) -> FloatArray:
    """Whether brakes, by their quantities in SI, jump: up to a target, or up to the own value of each that works."""
    return have_jumped(study.risen(values, target), **study.along(values), hasty=hasty)


def box(study: Study) -> tuple[Any, Any, dict[str, Unit]]:
    """Corners between which all brakes lie, with the μ₀ of the friction that works; what rises has begun to."""
    low, high, units = tolerance_boxes.corners(study)
    if not study.of_friction:
        name = study.rises.name
        low = low.replace(**{name: max(study.begins(), float(getattr(low, name)))})
    if not _all_works(study):
        ends = zip((low, high), friction.bounds(study), strict=True)
        low, high = (p.replace(mu0=max(0.0, value)) for p, value in ends)
    return low, high, units


def _all_works(study: Study) -> bool:
    """Whether statics takes the friction as the parameters have it, and not a share of μ₀."""
    return study.kind.law["at_rest"] != "mu0" or study.law == "friction_at_rest"


def certificate(study: Study, *, hasty: bool = False) -> BoxCertificate:
    """Whether any brake within the tolerances jumps: proved, refuted by one that does, or undecided; ``hasty`` ends earlier.

    Source: :func:`spragsym.certify` over a box of the model's parameters and of the quantities that are their units.
    """
    amount = effort(study)
    point = counterexample(study, amount.points_of_change if hasty else amount.points)
    if point is not None:
        return BoxCertificate("no jump", "refuted", point, 0.0, 0)
    low, high, units = box(study)
    most = amount.boxes_of_change if hasty else amount.boxes
    found = certify(low, high, "no jump", max_boxes=most, refute=False, units=units, **study.along())
    # A part of the box where all jump need not hold a brake: the bounds of its friction may be loose.
    outcome = found.outcome if found.outcome == "proved" else "undecided"
    return BoxCertificate("no jump", outcome, None, found.undecided, found.boxes)


def counterexample(study: Study, number: int) -> dict[str, float] | None:
    """A brake within the tolerances that jumps, in SI: a corner if there is one, or one of some points."""
    for shares in (corners(study), samples(study, number)):
        found = np.flatnonzero(jumping(study, shares) == 1)
        if found.size:
            share = dict(zip(varied(study), shares[found[0]], strict=True))
            own = {name: float(study.quantities[name].ppf(at)) for name, at in share.items()}
            return {name: own.get(name, study.values[name]) for name in deciding(study)}
    return None


def chance(study: Study, n: int) -> JumpProbability:
    """How probable a jump is with the distributions of the file, what varies together included."""
    return estimated(
        {**study.values, **{name: study.quantities[name].whole for name in varied(study)}}, lambda values: ending(study, values),
        correlation=study.pairs(varied(study)), n=n, rng=0, confidence=0.95, sobol=True, replicates=8, workers=1, progress=False,
    )  # fmt: skip


def begins_alike(study: Study, after: Mapping[str, float]) -> bool:
    """Whether the state that is followed in a changed brake is the one of the brake as drawn, not one behind its end."""
    if study.of_friction:
        return True
    ends = {name: sorted((study.values[name], value)) for name, value in after.items()}
    moved = {name: replace(study.quantities[name].alone, low=low, high=high) for name, (low, high) in ends.items()}
    low, high, units = box(study.with_quantities({name: one.alone for name, one in study.quantities.items()} | moved))
    of = tolerance_boxes.sides(study)
    try:
        way = Splitting(low, high, study.rises.name, study.begins(), units)
        least, most = way.whole.low[:-1, 0], way.whole.high[:-1, 0]
        upward = np.array([after.get(of[side][0], 0.0) > study.values[of[side][0]] for side in way.free], dtype=bool)
        return way.begins_alike(np.where(upward, least, most), np.where(upward, most, least))
    except ConvergenceError:
        return False


def bracket(study: Study, parts: int = _PARTS) -> tuple[float, float]:
    """Bounds of the probability of a jump, by proof: what is proved to jump, and one minus what is proved not to.

    (0, 1) where quantities vary together, or too many vary, and where friction that works less than fully is not what rises.
    Of the belt's speed and the law's steepness only how much of μ₀ works is taken, from least to most.
    """
    names = [name for name in varied(study) if name in study.kind.of_statics]
    if not names or len(names) > _MOST_SIDES or study.pairs(varied(study)) or not (study.of_friction or _all_works(study)):
        return 0.0, 1.0

    def law(name: str, scale: float) -> Any:
        return lambda value: study.quantities[name].whole.cdf(np.asarray(value) * scale)

    low, high, units = box(study)
    splitting, of = Splitting(low, high, study.rises.name, study.begins(), units), tolerance_boxes.sides(study)
    laws = {side: law(*of[side]) for side in splitting.free}
    up_to = (law(*of[study.rises.name]),) * 2
    if study.of_friction:
        least, most = _shares_that_work(study)
        up_to = law("mu0", 1 / most), law("mu0", 1 / least)
    below, above = measured(splitting, laws, up_to, parts)
    widths = [(one.high, one.high - one.low) for one in (study.quantities[name] for name in names)]
    off = parts * _ROUNDING * max(abs(end) / width for end, width in widths)
    return max(0.0, below - off), min(1.0, above + off)


def _shares_that_work(study: Study) -> tuple[float, float]:
    """Bounds of the share of μ₀ that works, over all tolerances but that of μ₀."""
    if _all_works(study):
        return 1.0, 1.0
    least, most = friction.bounds(study.with_quantities({**study.quantities, "mu0": Measured(1.0, 1.0, 1.0, "")}))
    return max(_NOTHING, least), max(_NOTHING, most)
