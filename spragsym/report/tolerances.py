"""Variation within the tolerances of a brake: the friction that works, brakes at shares, corners,
proofs, probabilities.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..core.errors import ConvergenceError
from ..design.certificates import Certificate
from ..design.jumps import limit_point_passed
from ..design.probability import JumpProbability, OpenShare, Sampling, estimated, measured
from ..design.tube_certificates import Splitting, claims
from ..models.parameters import FloatArray, Span
from ..models.quantities import Unit
from .friction_law import friction_bounds, friction_depends_on, parameter_ends
from .study import Study
from .units import Measured, Numbers


@dataclass(frozen=True)
class SamplingBudget:
    """Numbers of samples where states are followed: ``samples`` of a probability, ``boxes`` of a
    proof and the ``points`` at which it is refuted; of a change, ``shares`` that are sampled where
    it is not proved, and ``many`` where not even a sample jumps; the ``most`` single quantities
    that are the nearest are proved, each ``further`` by these shares of what is left.
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


def sampling_budget(study: Study) -> SamplingBudget:
    """SamplingBudget for the study's model."""
    # Where a jump is looked for without end, and so by closed forms, thousands of points in
    # a second: more.
    endless = SamplingBudget(
        samples=4096,
        boxes=20_000,
        points=1024,
        boxes_of_change=1000,
        points_of_change=1024,
        shares=1 << 10,
        many=1 << 17,
        most=16,
        further=(0.0, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0),
    )
    return endless if math.isinf(study.upper_limit) else SamplingBudget()


def deciding(study: Study) -> tuple[str, ...]:
    """The quantities that decide whether it jumps: those of the balance of forces, and of the
    friction that works.
    """
    names = {*study.kind.balanced, *friction_depends_on(study)}
    return tuple(name for name in study.quantities if name in names)


def varied(study: Study) -> list[str]:
    """Quantities that have a tolerance."""
    return [name for name in deciding(study) if study.quantities[name].varies]


def values_at(study: Study, shares: FloatArray) -> dict[str, FloatArray]:
    """All quantities in SI, within their ranges, at shares of what is :func:`varied`, of shape (n,
    varied).
    """
    values = {name: np.full(len(shares), value) for name, value in study.values.items()}
    allowed = study.kind.ranges(study.values)
    for j, name in enumerate(varied(study)):
        one = allowed[name]
        values[name] = np.clip(
            study.quantities[name].ppf(shares[:, j]), one.reached(one.low), one.reached(one.high)
        )
    return values


def corners(study: Study) -> FloatArray:
    """Shares of the brake as drawn with most of what rises, and of all corners of the tolerances
    that may occur, at its upper end only.
    """
    names, load = varied(study), study.loading.quantity
    together = study.together(names)
    found = together.corners()
    if load in together.titles:  # it depends on no other quantity
        found = found[found[:, names.index(load)] == 1.0]
    drawn = [
        1.0 if name == load else float(study.quantities[name].cdf(study.values[name]))
        for name in names
    ]
    return np.vstack([drawn, found])


def samples(study: Study, number: int) -> FloatArray:
    """Shares of Sobol' points, correlated as the quantities are."""
    from scipy.stats import qmc  # heavy, and a refusal does not need it

    names = varied(study)
    if names:
        return study.together(names).shares(qmc.Sobol(len(names), rng=0).random(number))
    return np.zeros((1, 0))


def ending(
    study: Study, values: Mapping[str, Any], target: float | None = None, *, coarse: bool = False
) -> FloatArray:
    """1 for brakes, by their quantities in SI, that jump up to a target, or to the own value of
    each; 0 or NaN for others.
    """
    return limit_point_passed(study.loaded(values, target), **study.along(values), coarse=coarse)


def box(study: Study) -> tuple[Any, Any, dict[str, Unit]]:
    """Corners between which all brakes lie, with the μ₀ of the friction that works; what rises has
    begun to.
    """
    low, high, units = parameter_ends(study)
    name = study.loading.name
    low = low.replace(**{name: max(study.start(), float(low[name]))})
    if not _all_works(study):
        ends = zip((low, high), friction_bounds(study), strict=True)
        own = str(study.kind.model.coefficient)
        low, high = (p.replace(**{own: max(0.0, value)}) for p, value in ends)
    return low, high, units


def splitting(study: Study) -> Splitting:
    """The state of all brakes, followed as what rises does, in parts of their box."""
    low, high, units = box(study)
    return Splitting(low, high, study.loading.name, study.start(), units)


def _all_works(study: Study) -> bool:
    """Whether statics takes the friction as the parameters have it, and not a share of μ₀."""
    return study.kind.law["at_rest"] != "full" or study.law == "friction_at_rest"


def certificate(study: Study, *, coarse: bool = False) -> Certificate:
    """Whether no brake within the tolerances jumps: proved, refuted by one in SI, or undecided;
    ``coarse`` ends earlier.

    Of a normal distribution that is not cut off the box holds three standard deviations on either
    side, and nothing is said of what lies beyond.

    Source: :func:`spragsym.certify` over a box of the model's parameters and of the quantities that
    are their units.
    """
    budget = sampling_budget(study)
    point = counterexample(study, budget.points_of_change if coarse else budget.points)
    if point is not None:
        return Certificate("no jump", "refuted", point, 0.0, 0)
    low, high, units = box(study)
    most = budget.boxes_of_change if coarse else budget.boxes
    found = claims((low, high), "no jump", units=units, **study.along()).certificate(
        "no jump", most, refute=False
    )
    # A part of the box where all jump need not hold a brake: the bounds of its friction may be
    # loose.
    if found.outcome == "proved":
        return found
    return replace(found, outcome="undecided", counterexample=None)


def counterexample(study: Study, number: int) -> Numbers | None:
    """A brake within the tolerances that jumps, in SI: a corner if there is one, or one of some
    points.
    """
    for shares in (corners(study), samples(study, number)):
        values = values_at(study, shares)
        found = np.flatnonzero(ending(study, values) == 1)
        if found.size:
            return {name: float(values[name][found[0]]) for name in deciding(study)}
    return None


def chance(study: Study, n: int) -> JumpProbability:
    """Probability of a jump with the distributions of the file, what varies together included."""
    return estimated(
        study.values | {name: study.quantities[name].whole for name in varied(study)},
        lambda values: ending(study, values),
        Sampling(study.pairs(varied(study)), n, rng=0, replicates=8),
    )


def begins_alike(study: Study, after: Numbers) -> bool:
    """Whether the state that is followed in a changed brake is the one of the brake as drawn, not
    one behind its end.
    """
    if study.of_friction:
        return True
    moved = {}
    for name, one in study.quantities.items():
        low, high = sorted((one.value, after.get(name, one.value)))
        moved[name] = Measured(one.value, low, high, one.unit)
    of = sides(study)
    try:
        way = splitting(study.with_quantities(moved))
        least, most = way.whole.low[:-1, 0], way.whole.high[:-1, 0]
        upward = [
            after.get(name, 0.0) > study.values[name] for name, _ in (of[side] for side in way.free)
        ]
        return way.begins_alike(np.where(upward, least, most), np.where(upward, most, least))
    except ConvergenceError:
        return False


def bracket(study: Study) -> Span:
    """Bounds of the probability of a jump, by proof: what is proved to jump, and one minus what is
    proved not to.

    (0, 1) where quantities vary together, or too many vary, and where friction that works less than
    fully is not what rises. Of the belt's speed and the law's steepness only how much of μ₀ works
    is taken, from least to most.
    """
    names = [name for name in varied(study) if name in study.kind.of_statics]
    # Quantities with tolerances up to which their probability is bracketed by proof.
    if (
        not names
        or len(names) > 4
        or study.pairs(varied(study))
        or not (study.of_friction or _all_works(study))
    ):
        return 0.0, 1.0

    def law(name: str, scale: float) -> Callable[[FloatArray], FloatArray]:
        return lambda value: study.quantities[name].whole.cdf(np.asarray(value) * scale)

    whole, of = splitting(study), sides(study)
    laws = {side: law(*of[side]) for side in whole.free}
    (quantity, size), (least, most) = of[study.loading.name], _shares_that_work(study)
    up_to = law(quantity, size / most), law(quantity, size / least)
    # Parts of them.
    parts = 200
    below, above = measured(whole, OpenShare(whole.free, laws, up_to), parts)
    ends = [study.quantities[name] for name in names]
    # Of a share of a distribution, where values go over its width.
    rounding = 2.0**-50
    off = parts * rounding * max(abs(one.high) / (one.high - one.low) for one in ends)
    return max(0.0, below - off), min(1.0, above + off)


def _shares_that_work(study: Study) -> Span:
    """Bounds of the share of μ₀ that works, over all tolerances but that of μ₀."""
    if _all_works(study):
        return 1.0, 1.0
    least, most = friction_bounds(
        study.with_quantities(
            {**study.quantities, str(study.kind.friction): Measured(1.0, 1.0, 1.0, "")}
        )
    )
    # A share of the friction that is none.
    nothing = 1e-300
    return max(nothing, least), max(nothing, most)


def sides(study: Study) -> dict[str, tuple[str, float]]:
    """For each parameter and each unit the quantity that it is, and its unit in SI."""
    kind = study.kind
    return {f"{base}/{base}_0": (base, study.values[base]) for base in kind.bases} | {
        name: (quantity, study.scale(kind.units[quantity]))
        for quantity, name in kind.parameters.items()
    }
