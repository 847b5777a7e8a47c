"""Variation of a brake within its tolerances: quantities at shares of their distributions, corners
and samples of the tolerances, the certificate that nothing jumps, the probability of a jump.
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
    """Numbers of samples and boxes. The defaults are for states that are followed numerically.

    Attributes
    ----------
    samples : int
        Samples for a probability.
    boxes, points : int
        Boxes for a certificate, and samples among which a counterexample is searched for.
    boxes_of_change, points_of_change : int
        The same for a change.
    shares : int
        Samples for the probability of a jump after a change without a proof.
    many : int
        Samples among which a counterexample is searched for if a change has no proof.
    most : int
        Number of changes of single quantities that are examined, the smallest first.
    further : tuple of float
        A change without a proof is extended by these shares of the remaining range.
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
    """The numbers for a study."""
    # Closed forms, which have no upper limit of the search, take thousands of points per second.
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
    """Quantities that influence whether it jumps: those in the balance of forces, and those of the
    friction in use.
    """
    names = {*study.kind.balanced, *friction_depends_on(study)}
    return tuple(name for name in study.quantities if name in names)


def varied(study: Study) -> list[str]:
    """Quantities with a tolerance, of those that influence whether it jumps."""
    return [name for name in deciding(study) if study.quantities[name].varies]


def values_at(study: Study, shares: FloatArray) -> dict[str, FloatArray]:
    """All quantities in SI, (n,) each, at cumulative probabilities ``shares`` of the :func:`varied`
    ones, (n, varied); within their allowed ranges.
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
    """Shares of the brake as drawn, with the loading at its upper end, and of all corners of the
    tolerances that may occur; a loading that depends on no other quantity is at its upper end.
    """
    names, load = varied(study), study.loading.quantity
    together = study.together(names)
    found = together.corners()
    if load in together.titles:  # independent of other quantities
        found = found[found[:, names.index(load)] == 1.0]
    drawn = [
        1.0 if name == load else float(study.quantities[name].cdf(study.values[name]))
        for name in names
    ]
    return np.vstack([drawn, found])


def samples(study: Study, number: int) -> FloatArray:
    """Shares of ``number`` Sobol' points, with the correlations of the quantities."""
    from scipy.stats import qmc  # a slow import, which input errors do not need

    names = varied(study)
    if names:
        return study.together(names).shares(qmc.Sobol(len(names), rng=0).random(number))
    return np.zeros((1, 0))


def ending(
    study: Study, values: Mapping[str, Any], target: float | None = None, *, coarse: bool = False
) -> FloatArray:
    """1 for brakes, given by their quantities in SI, that jump at or below a target value of the
    loading, by default each brake's own; 0 for others, NaN where undecided.
    """
    return limit_point_passed(study.loaded(values, target), **study.along(values), coarse=coarse)


def box(study: Study) -> tuple[Any, Any, dict[str, Unit]]:
    """Lower and upper ends of a box of parameters that contains all brakes, with the μ₀ of the
    friction in use and the loading above its start; and units.
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
    """The state of all brakes, followed as the loading rises, in subdivisions of their box."""
    low, high, units = box(study)
    return Splitting(low, high, study.loading.name, study.start(), units)


def _all_works(study: Study) -> bool:
    """True if statics uses the parameters of the friction as they are, and not a part of μ₀."""
    return study.kind.law["at_rest"] != "full" or study.law == "friction_at_rest"


def certificate(study: Study, *, coarse: bool = False) -> Certificate:
    """Certificate that no brake within the tolerances jumps: proved, refuted by a counterexample in
    SI, or undecided. ``coarse`` uses fewer boxes and points.

    Of a normal distribution without limits the box contains three standard deviations on either
    side; nothing is proved beyond.

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
    # A part of the box in which all jump is no refutation: since the bounds of the friction may be
    # wide, it may contain no brake.
    if found.outcome == "proved":
        return found
    return replace(found, outcome="undecided", counterexample=None)


def counterexample(study: Study, number: int) -> Numbers | None:
    """A brake within the tolerances that jumps, in SI: a corner, or one of ``number`` samples; None
    if none jumps.
    """
    for shares in (corners(study), samples(study, number)):
        values = values_at(study, shares)
        found = np.flatnonzero(ending(study, values) == 1)
        if found.size:
            return {name: float(values[name][found[0]]) for name in deciding(study)}
    return None


def chance(study: Study, n: int) -> JumpProbability:
    """Probability of a jump from ``n`` samples, with the distributions and correlations of the
    file.
    """
    return estimated(
        study.values | {name: study.quantities[name].whole for name in varied(study)},
        lambda values: ending(study, values),
        Sampling(study.pairs(varied(study)), n, rng=0, replicates=8),
    )


def begins_alike(study: Study, after: Numbers) -> bool:
    """True if the state that is followed in a changed brake is the continuation of that of the
    brake as drawn, proved; False if it is another one, or this is not proved.
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
    """Proved bounds of the probability of a jump: the share of brakes that are proved to jump, and
    1 minus the share of those that are proved not to.

    The bounds are (0, 1) if quantities are correlated, if none or more than four vary, or if the
    friction in use is only a part of μ₀ and the loading is another parameter. The belt's speed and
    the steepness of the law enter by the smallest and largest part of μ₀ in use.
    """
    names = [name for name in varied(study) if name in study.kind.of_statics]
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
    # Number of parts into which the boxes are divided.
    parts = 200
    below, above = measured(whole, OpenShare(whole.free, laws, up_to), parts)
    ends = [study.quantities[name] for name in names]
    # Rounding of a probability, relative to the ratio of a value to the width of its distribution.
    rounding = 2.0**-50
    error = parts * rounding * max(abs(one.high) / (one.high - one.low) for one in ends)
    return max(0.0, below - error), min(1.0, above + error)


def _shares_that_work(study: Study) -> Span:
    """Bounds of the ratio of the friction in use to μ₀, over all tolerances but that of μ₀; above
    0.
    """
    if _all_works(study):
        return 1.0, 1.0
    least, most = friction_bounds(
        study.with_quantities(
            {**study.quantities, str(study.kind.friction): Measured(1.0, 1.0, 1.0, "")}
        )
    )
    smallest = 1e-300
    return max(smallest, least), max(smallest, most)


def sides(study: Study) -> dict[str, tuple[str, float]]:
    """For each parameter and each unit of the box the corresponding quantity, and the factor to
    SI.
    """
    kind = study.kind
    return {f"{base}/{base}_0": (base, study.values[base]) for base in kind.bases} | {
        name: (quantity, study.scale(kind.units[quantity]))
        for quantity, name in kind.parameters.items()
    }
