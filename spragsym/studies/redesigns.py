"""What to change, so that the jump lies beyond a target: single quantities, and the least joint change; each solved again.

A value is rounded to what stands in the report, away from the old one, and verified as it stands there.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

from ..design import redesign
from ..design.events import have_jumped
from ..design.jump_values import first_jumps
from ..design.spaces import PHYSICAL, dimensionless
from ..display import Result
from ..errors import SpragsymError
from ..parameters import FloatArray, Parameters, PhysicalParameters
from .study import Study
from .tolerances import friction_at
from .units import factor

#: What may be changed, one at a time.
SINGLE = ("theta0", "k", "k_x", "k_y", "k_c", "F_L", "L_0")
#: Tolerance of a quantity that has none, as a share of its value; of the inclination in radians.
_SHARE, _ANGLE = 0.1, math.radians(1.0)
#: A single quantity is changed by up to this factor either way, at this many values, then between the two that decide.
_FACTOR, _VALUES, _BETWEEN, _ROUNDS = 20.0, 160, 32, 2
#: Up to this many quantities all corners of the tolerances are looked at; of more, a sample of as many corners.
_CORNERS = 5
#: How much further than the least joint change it may go.
_STRETCHES = (1.0, 1.1, 1.25, 1.5, 2.0, 3.0)
#: Digits of a new value.
_DIGITS = 3


@dataclass(frozen=True)
class Change(Result):
    """A new design: the quantities that change, in SI, before and after; where it jumps; and how far it is, in tolerances.

    ``probability`` is the share of brakes within the tolerances about the new design that jump; NaN where nothing has one.
    """

    before: Mapping[str, float]
    after: Mapping[str, float]
    mu_jump: float
    distance: float
    probability: float


def changes(study: Study, target: float) -> tuple[Change, ...]:
    """Changes that keep the jump at or beyond a friction, and at every corner of the tolerances beyond the largest one given.

    Single quantities, nearest first, and last the least joint change.

    Parameters
    ----------
    study : Study
    target : float
        The friction below which nothing may jump.

    Notes
    -----
    Source: :func:`spragsym.jump_value` over values of one quantity, and :func:`spragsym.redesign` for several. That a change
    keeps the target is verified at the value as it is printed, at the corners of the tolerances about it and at Sobol' points
    within them; that there is none nearer is not proved. A changed quantity keeps its tolerance as a share of its value, an
    inclination as it is.
    """
    scale = {name: _scale(study, name) for name in SINGLE}
    single = [_single(study, name, target, scale) for name in SINGLE]
    found = sorted((one for one in single if one is not None), key=lambda one: one.distance)
    together = _joint(study, target, scale)
    return tuple(found if together is None else [*found, together])


def _scale(study: Study, name: str) -> float:
    if name in study.tolerances:
        return study.tolerances[name]
    if name == "theta0":
        return _ANGLE
    return _SHARE * (study.values[name] or study.values["k_x"] or 0.01 * study.values["k_c"])


def _designs(study: Study, changed: Mapping[str, Any]) -> Parameters:
    shape = np.shape(next(iter(changed.values())))
    values = {name: np.broadcast_to(changed.get(name, study.values[name]), shape) for name in PHYSICAL}
    return Parameters(**{name: np.broadcast_to(value, shape) for name, value in dimensionless(values).items()})


def _free(study: Study, changed: Mapping[str, Any], friction: FloatArray | float) -> NDArray[np.bool_]:
    """Which designs are known not to jump at a friction or below it."""
    designs = _designs(study, changed)
    found = have_jumped(designs.replace(mu0=np.broadcast_to(friction, designs.shape)))
    free = ~found.jumped
    free.flat[list(found.reasons)] = False
    return free


def _kept(study: Study, changed: Mapping[str, Any], target: float) -> NDArray[np.bool_]:
    """Which designs jump at the target at the earliest, and at the corners of their tolerances beyond the largest friction."""
    kept = _free(study, changed, target)
    left = np.flatnonzero(kept)
    corners = _shares(study, corners=True)
    if left.size and len(corners):
        some = {name: np.asarray(value)[left] for name, value in changed.items()}
        kept[left] = _free(study, _about(study, some, corners), study.friction[2]).all(axis=0)
    return kept


def _wide(study: Study) -> list[str]:
    return [name for name in SINGLE if name in study.tolerances]


def _shares(study: Study, corners: bool) -> FloatArray:
    """Corners of the unit cube of all tolerances but the friction's, a sample where they are many; or points of that and of the
    tolerances of mu0, V and d.
    """
    wide = _wide(study)
    if not wide:
        return np.empty((0, 0))
    if corners and len(wide) <= _CORNERS:
        return np.array(list(product((0.0, 1.0), repeat=len(wide))))
    points = qmc.Sobol(len(wide) + (0 if corners else 3), rng=1).random(1 << (_CORNERS if corners else 10))
    return np.round(points) if corners else np.asarray(points)


def _about(study: Study, changed: Mapping[str, Any], shares: FloatArray) -> dict[str, FloatArray]:
    """Designs at shares of the tolerances about others, of shape (shares, designs)."""
    found: dict[str, FloatArray] = {}
    for name in _wide(study):
        one, size = study.quantities[name], np.shape(next(iter(changed.values())))
        centre = np.broadcast_to(changed.get(name, one.value), size)
        scale = centre / one.value if name != "theta0" and one.value else np.ones(size)
        off = one.low - one.value + shares[:, _wide(study).index(name), None] * (one.high - one.low)
        found[name] = centre + off * scale
    others = {name: np.broadcast_to(value, (len(shares), *np.shape(value))) for name, value in changed.items()}
    low, high = math.radians(1e-6), math.pi - math.radians(1e-6)
    return others | {name: np.clip(value, low, high) if name == "theta0" else value for name, value in found.items()}


def _probability(study: Study, changed: Mapping[str, float]) -> float:
    """The share of Sobol' points within the tolerances about a design that jump at their friction."""
    shares = _shares(study, corners=False)
    if not len(shares):
        return math.nan
    about = _about(study, {name: np.array([value]) for name, value in changed.items()}, shares)
    friction = friction_at(study, dict(zip(("mu0", "V", "d"), shares[:, -3:].T, strict=True)))
    return float(1 - _free(study, about, friction[:, None]).mean())


def _single(study: Study, name: str, target: float, scale: Mapping[str, float]) -> Change | None:
    """The nearest value of one quantity, on either side, that keeps the target."""
    best: Change | None = None
    for side in (-1, 1):
        values = _ladder(study, name, side)
        for _ in range(_ROUNDS):
            kept = np.flatnonzero(_kept(study, {name: values}, target))
            if not kept.size:
                break
            k = int(kept[0])
            values = np.linspace(values[max(k - 1, 0)], values[k], _BETWEEN)
        else:
            kept = np.flatnonzero(_kept(study, {name: values}, target))
            change = _verified(study, {name: float(values[kept[0]])}, target, scale) if kept.size else None
            if change is not None and (best is None or change.distance < best.distance):
                best = change
    return best


def _ladder(study: Study, name: str, side: int) -> FloatArray:
    """Values from the present one away, to where a redesign would be another brake."""
    start, share = study.values[name], np.linspace(0.0, 1.0, _VALUES)
    if name == "theta0":
        end = math.radians(1.0) if side < 0 else math.radians(179.0)
        return np.asarray(start + share * (end - start))
    if start == 0:
        return np.asarray(share**2 * (study.values["k_c"] if side > 0 else 0.0))
    return np.asarray(start * _FACTOR ** (side * share))


def _joint(study: Study, target: float, scale: Mapping[str, float]) -> Change | None:
    """The least change of all that has a tolerance, or of the inclination and both springs."""
    names = tuple(name for name in SINGLE if name in study.tolerances)
    names = names if len(names) > 1 else ("theta0", "k", "k_x")
    brake = PhysicalParameters(**{**study.values, "mu0": study.friction[1]})
    try:
        found = redesign(brake, names, {"mu0": target}, {name: scale[name] for name in names})
    except SpragsymError:
        return None
    if not np.isfinite(found.distance) or not isinstance(found.parameters, PhysicalParameters):
        return None
    after = {name: float(getattr(found.parameters, name)) for name in names}
    # The least change has its jump on the target: as much further as its own tolerances ask for.
    for stretch in _STRETCHES:
        longer = {name: study.values[name] + stretch * (value - study.values[name]) for name, value in after.items()}
        allowed = all(value > 0 or (name in ("k_x", "k_y") and value == 0) for name, value in longer.items())
        change = _verified(study, longer, target, scale) if allowed and longer.get("theta0", 1.0) < math.pi else None
        if change is not None:
            return change
    return None


def _verified(study: Study, after: Mapping[str, float], target: float, scale: Mapping[str, float]) -> Change | None:
    """The change as it is printed, if it keeps the target; a value that does not change in print is left as it was."""
    before = {name: study.values[name] for name in after}
    for further in range(4):
        rounded = {name: _rounded(study, name, before[name], value, further) for name, value in after.items()}
        if _kept(study, {name: np.array([value]) for name, value in rounded.items()}, target)[0]:
            jump = float(first_jumps(_designs(study, {name: np.array(value) for name, value in rounded.items()}), "mu0").value)
            moved = {name: value for name, value in rounded.items() if value != before[name]}
            size = math.hypot(*((value - before[name]) / scale[name] for name, value in moved.items()))
            return Change({name: before[name] for name in moved}, moved, jump, size, _probability(study, moved))
    return None


def _rounded(study: Study, name: str, before: float, after: float, further: int) -> float:
    """A value rounded away from the old one to few digits in its unit, and then by single units of the last digit farther."""
    unit = factor(study.quantities[name].unit, study.si(name))
    old, new = before / unit, after / unit
    step = 10.0 ** (math.floor(math.log10(abs(new))) - _DIGITS + 1) if new else 1.0
    if abs(new - old) < 0.5 * step:
        return before
    away = math.copysign(1.0, new - old)
    steps = (math.ceil if away > 0 else math.floor)(new / step) + away * further
    shown = float(f"{steps * step:.{_DIGITS + 2}g}")
    return math.radians(shown) if name == "theta0" and unit == math.pi / 180 else shown * unit
