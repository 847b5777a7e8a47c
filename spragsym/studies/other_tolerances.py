"""What the tolerances leave possible with any model: a certificate for all of them, and the probability of a jump."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..design.probability import estimated, variable
from ..exact.interval_arrays import Intervals, stacked
from ..models.certificates import certify
from ..models.jumps import Followed
from ..models.load import load
from ..models.varying_units import BalanceInUnits, Unit
from ..parameters import FloatArray, Range
from . import other_models
from .study import Study
from .tolerances import Chance, correlated, counterexample, distributions, told, values_at, varied

#: Parts of the tolerances, and points at which counterexamples are looked for.
_BOXES, _POINTS = 4000, 512
#: Some roundings of half a unit each.
ROUNDED = 2.0**-48


def tolerated(study: Study, n: int) -> tuple[dict[str, Any], Chance | None]:
    """The certificate, and the probability: 0 with confidence 1 where no brake jumps, by proof, and none is left out of that."""
    reached = certificate_of(study)
    if reached["outcome"] == "proved" and not study.unbounded and varied(study):
        return reached, Chance(0.0, 0.0, 0.0, 1.0, 0, {})
    return reached, chance(study, n)


def certificate_of(study: Study, boxes: int = _BOXES, points: int = _POINTS) -> dict[str, Any]:
    """Whether any brake within the tolerances jumps: proved, refuted by a brake in the file's units, or undecided.

    Notes
    -----
    Source: :func:`spragsym.models.certificates.certify` over a box of the model's parameters and of the quantities that are their
    units, rounded outward. The friction of the proof is μ₀ itself, or the one that works at the belt's speed where a law may say
    more there; that of a counterexample is the one that works.
    """
    point = counterexample(study, points, jumping)
    if point is not None:
        shown = {
            name: {"value": study.in_file(name, value), "unit": study.quantities[name].unit}
            for name, value in point.items() if name in study.tolerances
        }  # fmt: skip
        return _told("refuted", 0.0, 0, shown)
    low, high, units = box(study)
    found = certify(low, high, "no jump", vary="mu0", begin=0.0, max_boxes=boxes, refute=False, units=units)
    return _told(found.outcome, found.undecided, found.boxes, None)


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


def box(study: Study) -> tuple[Any, Any, dict[str, Unit]]:
    """Corners between which all brakes within the tolerances lie, rounded outward, and units of measure that have tolerances too.

    The corners are those of the parameters at the study's own units; the upper friction is no less than what works anywhere.
    """
    model, bases = load(study.model), other_models.bases(study.model, study.values)
    kinds = {name: unit for name, (_, unit) in bases.items()}
    powers: dict[str, dict[str, float]] = {name: {} for name in bases}
    low, high = {}, {}
    for entry in model.about["parameters"]:
        name, unit, allowed = entry["name"], entry["quantity_unit"], model.Parameters.ranges[entry["name"]]
        if entry["quantity"] not in study.quantities:
            continue
        given, pure = study.quantities[entry["quantity"]], unit in ("1", "rad")
        for base, power in ({} if pure else other_models.exponents(unit, kinds)).items():
            powers[base] |= {name: -power} if power else {}
        ends = _outward(given.low, given.high, 1.0 if pure else other_models.scale_of(unit, bases), 0.0 if pure else ROUNDED)
        low[name], high[name] = max(ends[0], allowed.low), min(ends[1], allowed.high)
    units = {}
    for base, of in powers.items():
        given = study.quantities[base]
        if of and given.low < given.high:
            units[f"{base}/{base}_0"] = Unit(*_outward(given.low, given.high, study.values[base], ROUNDED), of)
    corners = model.Parameters(**low), model.Parameters(**high)
    if "V" not in study.quantities:
        return *corners, units
    law = BalanceInUnits(model, True, units, "friction_at_speed")
    columns = (
        np.array([[value] for value in (*corner.scalars(*model.parameters), *(getattr(unit, side) for unit in units.values()))])
        for corner, side in zip(corners, ("low", "high"), strict=True)
    )
    works = law.friction(law.arguments(law.prepared(Intervals.between(*columns))))
    return corners[0], corners[1].replace(mu0=max(high["mu0"], float(stacked([works], (1,)).high[0, 0]))), units


def _outward(low: float, high: float, scale: float, off: float) -> tuple[float, float]:
    return low / scale * (1 - math.copysign(off, low)), high / scale * (1 + math.copysign(off, high))
