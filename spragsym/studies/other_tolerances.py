"""What the tolerances leave possible with any model: a certificate for all of them, and the probability of a jump."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from ..design.probability import estimated, variable
from ..exact.interval_arrays import Intervals, stacked
from ..models.balance import Balance
from ..models.certificates import certify
from ..models.jumps import Followed
from ..models.load import load
from ..parameters import FloatArray, Range
from . import other_models
from .study import Study
from .tolerances import Chance, correlated, counterexample, distributions, told, values_at, varied

#: Slices of each unit that has a tolerance, on which several parameters depend: more of them until the claim is decided.
_SLICES = (1, 4)
#: Parts of one slice, and points at which counterexamples are looked for.
_BOXES, _POINTS = 2000, 512


def tolerated(study: Study, n: int) -> tuple[dict[str, Any], Chance | None]:
    """The certificate, and the probability: 0 with confidence 1 where no brake jumps, by proof, and none is left out of that."""
    reached = certificate_of(study)
    if reached["outcome"] == "proved" and not study.unbounded and varied(study):
        return reached, Chance(0.0, 0.0, 0.0, 1.0, 0, {})
    return reached, chance(study, n)


def certificate_of(study: Study, slices: tuple[int, ...] = _SLICES, boxes: int = _BOXES, points: int = _POINTS) -> dict[str, Any]:
    """Whether any brake within the tolerances jumps: proved, refuted by a brake in the file's units, or undecided.

    Notes
    -----
    Source: :func:`spragsym.models.certificates.certify` over boxes of the model's parameters that enclose the tolerances, rounded
    outward. Quantities that are the units of others, on which many parameters depend, are cut into slices until the boxes are
    narrow enough. The friction of the proof is μ₀ itself, or the one that works at the belt's speed where a law may say more
    there; that of a counterexample is the one that works.
    """
    point = counterexample(study, points, jumping)
    if point is not None:
        shown = {
            name: {"value": study.in_file(name, value), "unit": study.quantities[name].unit}
            for name, value in point.items() if name in study.tolerances
        }  # fmt: skip
        return _told("refuted", 0.0, 0, shown)
    seen = 0
    for number in slices:
        parts, left = list(_slices(study, number)), 0
        for done, part in enumerate(parts, 1):
            low, high = _corners(study, part)
            found = certify(low, high, "no jump", vary="mu0", begin=0.0, max_boxes=boxes, refute=False)
            seen += found.boxes
            if found.outcome != "proved":
                left = len(parts) - done + 1
                break
        if not left:
            return _told("proved", 0.0, seen, None)
        if len(parts) == 1 and number > 1:
            break
    return _told("undecided", left / len(parts), seen, None)


def _told(outcome: str, undecided: float, boxes: int, example: Any) -> dict[str, Any]:
    return {"claim": "no jump", "outcome": outcome, "undecided": undecided, "boxes": boxes, "counterexample": example}


def chance(study: Study, n: int) -> Chance | None:
    """How probable a jump is with the distributions of the file; None where nothing varies."""
    if not varied(study):
        return None
    everything = Range(-np.inf)
    variables = {name: variable(name, given, everything) for name, given in distributions(study).items()}
    found = estimated(
        variables, lambda values: ending(study, values), correlation=correlated(study), n=n, rng=0, confidence=0.95, sobol=True,
        replicates=8, workers=1, progress=False, store=None,
    )  # fmt: skip
    return told(found)


def jumping(study: Study, shares: FloatArray) -> FloatArray:
    """1 for the brakes that jump, 0 for those that don't, and NaN where that is not known."""
    return ending(study, values_at(study, shares))


def ending(study: Study, values: Mapping[str, Any], friction: float | None = None) -> FloatArray:
    """The same of brakes by their quantities in SI: up to a friction, or up to the own one of each that works."""
    model = load(study.model)
    p, _ = other_models.dimensionless(study.model, values)
    works = p.mu0 * (other_models.share(model, p) if "V" in study.quantities else 1.0) if friction is None else friction
    found = Followed(model, p, "mu0", "up", 0.0, np.broadcast_to(works, p.shape)).ends(patient=False)
    out = np.where(np.isnan(found.value), 0.0, 1.0)
    out[list(found.reasons)] = np.nan
    return out


def _slices(study: Study, number: int) -> Iterator[dict[str, tuple[float, float]]]:
    """Ends of all quantities, those that are units of others cut into parts."""
    ends = {name: (one.low, one.high) for name, one in study.quantities.items()}
    units = [name for name in other_models.bases(study.model, study.values) if ends[name][0] < ends[name][1]]
    cuts = ([*itertools.pairwise(np.linspace(*ends[name], number + 1).tolist())] for name in units)
    for chosen in itertools.product(*cuts):
        yield ends | dict(zip(units, chosen, strict=True))


def _corners(study: Study, ends: Mapping[str, tuple[float, float]]) -> tuple[Any, Any]:
    """The model's parameters between which all brakes between some ends lie, rounded outward."""
    model = load(study.model)
    units = {entry["name"]: entry["unit"] for entry in model.about["units"]}
    low, high = {}, {}
    for entry in model.about["parameters"]:
        name, unit, allowed = entry["name"], entry["quantity_unit"], model.Parameters.ranges[entry["name"]]
        if entry["quantity"] not in ends:
            continue
        least, most = ends[entry["quantity"]]
        scales = [1.0, 1.0]
        for base, power in other_models.exponents(unit, units).items() if unit not in ("1", "rad") else ():
            powers = sorted(end**power for end in ends[base])
            scales = [scales[0] * powers[0], scales[1] * powers[1]]
        found = [end / scale for end in (least, most) for scale in scales]
        off = 0.0 if unit in ("1", "rad") else 2.0**-48  # some roundings of half a unit each
        low[name] = max(min(found) - off * abs(min(found)), allowed.low)
        high[name] = min(max(found) + off * abs(max(found)), allowed.high)
    corners = model.Parameters(**low), model.Parameters(**high)
    if "V" not in study.quantities:
        return corners
    law = Balance(model, True, "friction_at_speed")
    columns = (np.array([[value] for value in corner.scalars(*law.parameters)]) for corner in corners)
    works = law.friction(law.arguments(law.prepared(Intervals.between(*columns))))
    return corners[0], corners[1].replace(mu0=max(high["mu0"], float(stacked([works], (1,)).high[0, 0])))
