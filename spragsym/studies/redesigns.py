"""What to change, so that the jump lies beyond a target: single quantities, and the least joint change, with certificates.

A value is rounded to what stands in the report, away from the old one, and verified as it stands there. A change that a brake
within its tolerances refutes is not given: it goes on until the proof is found, or is said to be missing.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..design import redesign
from ..design.design_space import PHYSICAL, dimensionless
from ..design.events import have_jumped
from ..design.jump_values import first_jumps
from ..display import Result
from ..errors import SpragsymError
from ..parameters import FloatArray, Parameters, PhysicalParameters
from .study import Study
from .tolerances import brakes, certificate, corners, counterexample, jumping, samples, varied
from .units import factor

#: What may be changed, one at a time.
SINGLE = ("theta0", "k", "k_x", "k_y", "k_c", "F_L", "L_0")
#: Tolerance of a quantity that has none, as a share of its value; of the inclination in radians.
_SHARE, _ANGLE = 0.1, math.radians(1.0)
#: A single quantity is changed by up to this factor either way, at this many values, then between the two that decide.
_FACTOR, _VALUES, _BETWEEN, _ROUNDS = 20.0, 160, 32, 2
#: By how much of what is left it goes further, and by how much of the least joint change, until it is proved.
_FURTHER = (0.0, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0)
_STRETCHES = (1.0, 1.02, 1.05, 1.1, 1.2, 1.5, 2.0, 3.0)
#: Digits of a new value.
_DIGITS = 3
#: Slices of a certificate, and boxes of each: where few do not decide, a design a little further off is proved sooner.
_SLICES, _BOXES = (1, 4, 16), 120
#: Points about a design, for the share that jumps, and where there is no proof.
_POINTS, _MANY = 1 << 10, 1 << 17


@dataclass(frozen=True)
class Change(Result):
    """A new design: the quantities that change, in SI, before and after; where it jumps; and how far it is, in tolerances.

    ``outcome`` is that of the certificate that nothing jumps within the tolerances about it: ``"proved"``, or ``"undecided"`` if
    no proof was found, and neither was a brake that jumps. ``probability`` is the share of brakes within them that jump: 0 if
    that is proved, else what a sample gives; NaN where nothing has a tolerance.
    """

    before: Mapping[str, float]
    after: Mapping[str, float]
    mu_jump: float
    distance: float
    probability: float
    outcome: str


def changes(study: Study, target: float) -> tuple[Change, ...]:
    """Changes that keep the jump at or beyond a friction, and beyond the largest one given for all brakes within the tolerances.

    Single quantities, nearest first, and last the least joint change.

    Parameters
    ----------
    study : Study
    target : float
        The friction below which nothing may jump.

    Notes
    -----
    Source: :func:`spragsym.jump_value` over values of one quantity, :func:`spragsym.redesign` for several, and
    :func:`spragsym.certify` over the tolerances about the values as they are printed; that there is none nearer is not proved. A
    changed quantity keeps its tolerance as a share of its value, an inclination as it is.
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


def _reaches(study: Study, changed: Mapping[str, Any], target: float) -> NDArray[np.bool_]:
    """Which designs are known not to jump at a friction or below it."""
    designs = _designs(study, changed)
    found = have_jumped(designs.replace(mu0=np.broadcast_to(target, designs.shape)))
    free = ~found.jumped
    free.flat[list(found.reasons)] = False
    return free


def _kept(study: Study, changed: Mapping[str, Any], target: float) -> NDArray[np.bool_]:
    """Which designs jump at the target at the earliest, and at no corner of their tolerances."""
    kept = _reaches(study, changed, target)
    left = np.flatnonzero(kept)
    shares = corners(study)
    about = [brakes(study.changed({name: float(values[i]) for name, values in changed.items()}), shares) for i in left]
    if about:
        low, high = math.radians(1e-6), math.pi - math.radians(1e-6)
        rows = {name: np.concatenate([one[name] for one in about]) for name in PHYSICAL}
        rows["theta0"] = np.clip(rows["theta0"], low, high)
        found = have_jumped(Parameters(**dimensionless(rows)))
        free = ~found.jumped
        free[list(found.reasons)] = False
        kept[left] = free.reshape(len(left), -1).all(axis=1)
    return kept


def _single(study: Study, name: str, target: float, scale: Mapping[str, float]) -> Change | None:
    """The nearest value of one quantity, on either side, that keeps the target."""
    starts = []
    for side in (-1, 1):
        values = ladder = _ladder(study, name, side)
        for _ in range(_ROUNDS):
            kept = np.flatnonzero(_kept(study, {name: values}, target))
            if not kept.size:
                break
            k = int(kept[0])
            values = np.linspace(values[max(k - 1, 0)], values[k], _BETWEEN)
        else:
            kept = np.flatnonzero(_kept(study, {name: values}, target))
            if kept.size:
                starts.append((float(values[kept[0]]), float(ladder[-1])))
    best: Change | None = None
    for start, end in sorted(starts, key=lambda one: abs(one[0] - study.values[name])):
        designs = ({name: start + share * (end - start)} for share in _FURTHER)
        change = _first_proved(study, designs, target, scale)
        if change is not None and (best is None or _order(change) < _order(best)):
            best = change
        if best is not None and best.outcome == "proved":
            break
    return best


def _order(change: Change) -> tuple[bool, float]:
    """What is proved before what is not, then by distance."""
    return change.outcome != "proved", change.distance


def _first_proved(study: Study, designs: Iterator[dict[str, float]], target: float, scale: Mapping[str, float]) -> Change | None:
    """The first of some designs with a proof; else the first without a brake that jumps among many samples."""
    open_one: Change | None = None
    tried: list[Mapping[str, float]] = []
    for after in designs:
        printed = _printed(study, after, target)
        if printed is None or printed in tried:
            continue
        tried.append(printed)
        change = _verified(study, printed, scale, open_one is not None)
        if change is not None and change.outcome == "proved":
            return change
        open_one = open_one or change
    return open_one


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
    longer = ({name: study.values[name] + stretch * (value - study.values[name]) for name, value in after.items()}
              for stretch in _STRETCHES)  # fmt: skip
    return _first_proved(study, (one for one in longer if _allowed(one)), target, scale)


def _allowed(values: Mapping[str, float]) -> bool:
    allowed = all(value > 0 or (name in ("k_x", "k_y") and value == 0) for name, value in values.items())
    return allowed and values.get("theta0", 1.0) < math.pi


def _printed(study: Study, after: Mapping[str, float], target: float) -> dict[str, float] | None:
    """What changes, as it is printed, if it keeps the target; a value that does not change in print is left as it was."""
    before = {name: study.values[name] for name in after}
    for further in range(4):
        rounded = {name: _rounded(study, name, before[name], value, further) for name, value in after.items()}
        one = {name: np.array([value]) for name, value in rounded.items()}
        if _in_range(study, rounded) and _kept(study, one, target)[0]:
            return {name: value for name, value in rounded.items() if value != before[name]}
    return None


def _verified(study: Study, after: Mapping[str, float], scale: Mapping[str, float], proof_only: bool) -> Change | None:
    """A change with its certificate; None if a brake within the tolerances about it jumps, or only a proof will do."""
    new, before = study.changed(after), {name: study.values[name] for name in after}
    reached = certificate(new, _SLICES, _BOXES, hasty=True)
    if reached.outcome == "refuted" or (reached.outcome == "undecided" and (proof_only or counterexample(new, _MANY))):
        return None
    jump = float(first_jumps(_designs(study, {name: np.array(value) for name, value in after.items()}), "mu0").value)
    size = math.hypot(*((value - before[name]) / scale[name] for name, value in after.items()))
    share = 0.0 if reached.outcome == "proved" else float(np.nanmean(jumping(new, samples(new, _POINTS))))
    return Change(before, after, jump, size, share if varied(study) else math.nan, reached.outcome)


def _in_range(study: Study, after: Mapping[str, float]) -> bool:
    """Whether all brakes within the tolerances about a design are brakes."""
    new = study.changed(after)
    ends = {name: (new.quantities[name].low, new.quantities[name].high) for name in after}
    low, high = ends.get("theta0", (1.0, 1.0))
    return low > 0 and high < math.pi and all(end[0] > 0 or name in ("k_x", "k_y", "theta0") for name, end in ends.items())


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
