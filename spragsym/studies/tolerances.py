"""What the tolerances leave possible: a certificate for the whole box, the probability of a jump, and which quantity matters."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from scipy.special import ndtr, ndtri
from scipy.stats import qmc

from ..design import JumpProbability
from ..design.design_space import PHYSICAL, dimensionless
from ..design.probability import probability_table
from ..display import Result, Table
from ..kang_nam.catastrophe.sliding import sliding_friction
from ..kang_nam.design import certify, jump_probability
from ..kang_nam.design.events import have_jumped
from ..kang_nam.design.probability import BELT
from ..parameters import NAMES, FloatArray, Parameters
from .study import Study
from .units import WITHIN, Measured

#: Slices of the contact's stiffness, on which all groups depend: more of them until the claim is decided.
_SLICES = (1, 4, 16, 48)
#: The step between slices that are looked at first.
_SPREAD = 8
#: Boxes for one slice, and points at which counterexamples are looked for.
_BOXES, _POINTS = 400, 1024


@dataclass(frozen=True)
class BoxCertificate(Result):
    """What is known of "nothing jumps" for every brake within the tolerances.

    ``outcome`` is ``"proved"``, ``"refuted"`` or ``"undecided"``; ``counterexample`` is a brake within the tolerances that jumps,
    in SI; ``undecided`` is the share of the slices of the box that is not proved. Of a normal distribution that is not cut off
    the box holds three standard deviations on either side, and nothing is said of what lies beyond.
    """

    claim: str
    outcome: str
    counterexample: Mapping[str, float] | None
    undecided: float
    boxes: int


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


def names_of(study: Study) -> tuple[str, ...]:
    """The quantities that decide whether it jumps."""
    return PHYSICAL + (BELT if study.moves else ()) if study.model == "kang_nam" else tuple(study.quantities)


def varied(study: Study) -> list[str]:
    """Those of them that have a tolerance."""
    return [name for name in names_of(study) if name in study.tolerances]


def quantile(one: Measured, share: Any) -> FloatArray:
    """The value of a quantity below which a share of its distribution within its ends lies."""
    if one.sd:
        return Normal(one.value, one.sd, one.low, one.high).ppf(share)
    return np.asarray(np.clip(one.low + np.asarray(share) * (one.high - one.low), one.low, one.high))


def values_at(study: Study, shares: FloatArray) -> dict[str, FloatArray]:
    """Quantities in SI at shares of what is :func:`varied`, of shape (n, varied)."""
    values = {name: np.full(len(shares), study.values[name]) for name in names_of(study)}
    for j, name in enumerate(varied(study)):
        values[name] = quantile(study.quantities[name], shares[:, j])
    return values


def brakes(study: Study, shares: FloatArray) -> dict[str, FloatArray]:
    """Brakes at shares of what is :func:`varied`, of shape (n, varied), in SI; the friction is the one that works."""
    values = values_at(study, shares)
    if study.moves:
        values["mu0"] = sliding_friction(*(values[name] for name in ("mu0", *BELT)))
    return {name: values[name] for name in PHYSICAL}


def jumping(study: Study, shares: FloatArray) -> FloatArray:
    """1 for the brakes that jump, 0 for those that don't, and NaN where that is not known."""
    found = have_jumped(Parameters(**dimensionless(brakes(study, shares))))
    result = np.where(found.jumped, 1.0, 0.0)
    result[list(found.reasons)] = np.nan
    return result


#: 1 for the brakes of a study at some shares that jump, 0 for those that don't, NaN where that is not known.
Jumping: TypeAlias = Callable[[Study, FloatArray], FloatArray]


def corners(study: Study) -> FloatArray:
    """Shares of the brake as drawn with most friction, and of all corners of the tolerances that may occur.

    Of friction and, with the article's law, of the belt the ends with most of it are enough, if independent.
    """
    names, rising = varied(study), ("mu0", *BELT) if study.model == "kang_nam" else ("mu0",)
    together = study.together(names)
    found = together.corners()
    for group in together.groups:
        if len(group) == 1 and names[group[0]] in rising:
            found = found[found[:, group[0]] == 1.0]
    quantities = [study.quantities[name] for name in names]
    drawn = [[1.0 if name in rising else share_of(one) for name, one in zip(names, quantities, strict=True)]]
    return np.concatenate([np.array(drawn).reshape(1, -1), found])


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


def ends(study: Study) -> dict[str, tuple[float, float]]:
    """Both ends of every quantity that the statics depend on; of the friction, the one that works."""
    found = {name: (study.quantities[name].low, study.quantities[name].high) for name in PHYSICAL}
    return found | {"mu0": (study.friction[0], study.friction[2])}


def certificate(study: Study, slices: tuple[int, ...] = _SLICES, boxes: int = _BOXES, hasty: bool = False) -> BoxCertificate:
    """Prove that nothing jumps within the tolerances, or find a brake within them that does; ``hasty`` ends where one is open.

    Notes
    -----
    Source: :func:`spragsym.certify` over boxes of the dimensionless groups that enclose the tolerances, rounded outward. All
    groups have the stiffness of the contact in common, so it is cut into slices until the boxes are narrow enough.
    Counterexamples are looked for among the corners and Sobol' points of the tolerances themselves.
    """
    box = ends(study)
    point = counterexample(study)
    if point is not None:
        return BoxCertificate("no jump", "refuted", point, 0.0, 0)
    seen, left = 0, 1.0
    for number in slices:
        cuts = np.linspace(*box["k_c"], number + 1)
        low_k, high_k = cuts[:-1], cuts[1:]
        open_ones = 0
        # From all parts of the range first: where each of these is open, so are the others, or nearly.
        order = sorted(range(number), key=lambda i: i % _SPREAD)
        for done, i in enumerate(order, 1):
            slice_of = _corners(box | {"k_c": (float(low_k[i]), float(high_k[i]))})
            found = certify(*slice_of, "no jump", max_boxes=boxes, refute=False)
            seen += found.boxes
            open_ones += found.outcome != "proved"
            if open_ones and (hasty or number != slices[-1] or open_ones == done == number // _SPREAD):
                open_ones += number - done
                break
        left = open_ones / number
        if not open_ones:
            return BoxCertificate("no jump", "proved", None, 0.0, seen)
        if box["k_c"][0] == box["k_c"][1]:
            break
    return BoxCertificate("no jump", "undecided", None, left, seen)


def counterexample(study: Study, number: int = _POINTS, jumping: Jumping = jumping) -> dict[str, float] | None:
    """A brake within the tolerances that jumps, in SI: a corner if there is one, or one of some points."""
    for shares in (corners(study), samples(study, number)):
        found = np.flatnonzero(jumping(study, shares) == 1)
        if found.size:
            share = shares[found[0]]
            own = {name: float(quantile(study.quantities[name], share[j])) for j, name in enumerate(varied(study))}
            return {name: own.get(name, study.values[name]) for name in names_of(study)}
    return None


def _corners(box: Mapping[str, tuple[float, float]]) -> tuple[Parameters, Parameters]:
    """Dimensionless parameters between which all of the box lies, rounded outward."""
    low, high = ({name: end[side] for name, end in box.items()} for side in (0, 1))
    # Every group is one quantity over k_c, and κ over L_0 as well.
    least = dimensionless(low | {"k_c": high["k_c"], "L_0": high["L_0"]})
    most = dimensionless(high | {"k_c": low["k_c"], "L_0": low["L_0"]})
    for name in NAMES:
        if name in ("theta0", "mu0"):
            continue
        for _ in range(4):  # three operations at most, each rounded by half a unit
            least[name] = max(np.nextafter(least[name], -np.inf), 0.0) if least[name] else least[name]
            most[name] = np.nextafter(most[name], np.inf) if most[name] else most[name]
    return Parameters(**least), Parameters(**most)


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


def chance(study: Study, n: int) -> Chance | None:
    """How probable a jump is with the distributions of the file, what varies together included; None where nothing varies.

    Notes
    -----
    A normal distribution that is not cut off is sampled to six standard deviations, beyond which lie 2e-9 of it.
    """
    if not varied(study):
        return None
    return told(jump_probability(distributions(study), correlation=correlated(study), n=n, rng=0))


def correlated(study: Study) -> dict[tuple[str, str], float]:
    """Pairs that vary together, of those that decide whether it jumps."""
    return {pair: value for pair, value in study.correlation.items() if set(pair) <= set(varied(study))}


def distributions(study: Study) -> dict[str, Any]:
    """Each quantity as a number, a range or a distribution, see :func:`distribution`."""
    return {name: distribution(study.quantities[name]) for name in names_of(study)}


def told(found: JumpProbability) -> Chance:
    """The probability, and the indices with the largest first."""
    indices = {
        name: (found.first[name], found.total[name], found.total_error[name])
        for name in sorted(found.total, key=lambda name: -np.nan_to_num(found.total[name]))
    }
    return Chance(found.probability, found.low, found.high, found.confidence, found.n, indices)


def distribution(one: Measured) -> Any:
    """A quantity as a number, a range or a distribution."""
    if one.low == one.high:
        return one.value
    if not one.sd:
        return one.low, one.high
    if one.cut:
        return Normal(one.value, one.sd, one.low, one.high)
    return Normal(one.value, one.sd, one.value - WITHIN * one.sd, one.value + WITHIN * one.sd)
