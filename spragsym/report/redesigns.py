"""What to change, so that the jump lies beyond a target: single quantities, and the least joint change, with certificates.

A value is rounded to what stands in the report, away from the old one, and verified as it stands there. A change that a brake
within its tolerances refutes is not given: it goes on until the proof is found, or is said to be missing.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

import spragsym as ss

from ..design.design_space import Design, space
from ..display import Result
from ..errors import SpragsymError
from ..models.load import load
from ..models.parameters import FloatArray
from . import brake_quantities, rises
from .effort import effort
from .jump_verdicts import begins_alike, certificate, counterexample, ending, jumping
from .study import Study
from .tolerances import corners, samples, values_at, varied
from .units import factor

#: Tolerance of a quantity that has none, as a share of its value; of the inclination in radians.
_SHARE, _ANGLE = 0.1, math.radians(1.0)
#: A single quantity is changed by up to this factor either way.
_FACTOR = 20.0
#: Designs whose tolerances are looked at in one go.
_AT_ONCE = 8
#: By how much of the least joint change it goes further until it is proved.
_STRETCHES = (1.0, 1.02, 1.05, 1.1, 1.2, 1.5, 2.0, 3.0)
#: Digits of a new value.
_DIGITS = 3


@dataclass(frozen=True)
class Change(Result):
    """A new design: what changes, in SI, before and after; where it jumps, as the report tells it; how far it is, in tolerances.

    ``outcome`` is that of the certificate that nothing jumps within the tolerances about it: ``"proved"``, or ``"undecided"`` if
    no proof was found, and neither was a brake that jumps. ``probability`` is the share of brakes within them that jump: 0 if
    that is proved, else what a sample gives; NaN where nothing has a tolerance.
    """

    before: Mapping[str, float]
    after: Mapping[str, float]
    jump_at: float
    distance: float
    probability: float
    outcome: str


def changes(study: Study, target: float) -> tuple[Change, ...]:
    """Changes that keep the jump at or beyond a target, and beyond the largest value given for all brakes within the tolerances.

    Single quantities, nearest first, and last the least joint change.

    Parameters
    ----------
    study : Study
    target : float
        The friction, or value of what rises in SI, below which nothing may jump.

    Notes
    -----
    Source: :func:`spragsym.jump_value` over values of one quantity, :func:`spragsym.redesign` for several, and
    :func:`spragsym.certify` over the tolerances about the values as they are printed; that there is none nearer is not proved. A
    changed quantity keeps its tolerance as a share of its value, an inclination as it is.
    """
    search = _Search(study, target)
    found = sorted(search.singles(), key=lambda one: one.distance)
    together = search.joint()
    if together is None or any(one.after.keys() == together.after.keys() for one in found):
        return tuple(found)
    return (*found, together)


def distance(study: Study) -> float:
    """The nearest jump in tolerances at what works, see :func:`spragsym.jump_margin`; NaN without tolerances."""
    names = brake_quantities.of_statics(study.model)
    scale = {name: size for name, size in study.tolerances.items() if name in names}
    if not scale:
        return math.nan
    return float(ss.jump_margin(design(study), scale, **rises.along(study)).distance)


def design(study: Study) -> Design:
    """The brake as drawn, with the friction that works, as a design of the model: quantities in SI."""
    model = load(study.model)
    works = {"mu0": float(study.at_work.mu0)} if "mu0" in model.parameters else {}
    return Design(
        {**study.values, **works},
        brake_quantities.ranges(study.model, study.values),
        partial(brake_quantities.groups, study.model),
        dict,
        model.Parameters,
        None if rises.of(study).is_friction else lambda values: rises.along(study, values)["begin"],
        study.dimensionless.followed,
    )


class _Search:
    """The changes of one brake."""

    def __init__(self, study: Study, target: float) -> None:
        self.study, self.target, self.effort = study, target, effort(study)
        self.names = tuple(name for name in brake_quantities.balanced(study.model) if name != rises.of(study).quantity)
        self.scale = {name: self._scale(name) for name in self.names}
        self.allowed = brake_quantities.ranges(study.model, study.values)
        self.corners = corners(study)

    def _scale(self, name: str) -> float:
        study = self.study
        if name in study.tolerances:
            return study.tolerances[name]
        if study.si(name) == "rad":
            return _ANGLE
        alike = [value for other, value in study.values.items() if value > 0 and study.si(other) == study.si(name)]
        return _SHARE * (study.values[name] or min(alike, default=0.01 * self._unit(name)))

    def _unit(self, name: str) -> float:
        """What one of the model's units is in SI."""
        return brake_quantities.scale_of(self.study.si(name), brake_quantities.bases(self.study.model, self.study.values))

    # ------------------------------------------------------------------------------------------------- which are kept

    def _reaches(self, changed: Mapping[str, FloatArray]) -> NDArray[np.bool_]:
        """Which designs are known not to jump at the target or below it."""
        shape = np.shape(next(iter(changed.values())))
        rows = {name: np.broadcast_to(changed.get(name, value), shape) for name, value in self.study.values.items()}
        return np.asarray(ending(self.study, rows, self.target, hasty=True) == 0)

    def _kept(self, changed: Mapping[str, FloatArray]) -> int | None:
        """The first design that jumps at the target at the earliest, and at no corner of its tolerances."""
        shares, left = self.corners, np.flatnonzero(self._reaches(changed))
        for begin in range(0, left.size, _AT_ONCE):
            some = left[begin : begin + _AT_ONCE]
            designs = [self.study.changed({name: float(values[i]) for name, values in changed.items()}) for i in some]
            about = [values_at(design, shares) for design in designs]
            rows = {name: np.concatenate([one[name] for one in about]) for name in about[0]}
            free = (ending(self.study, rows, hasty=True) == 0).reshape(len(some), -1).all(axis=1)
            if free.any():
                return int(some[np.flatnonzero(free)[0]])
        return None

    # ------------------------------------------------------------------------------------------------- one quantity

    def singles(self) -> list[Change]:
        """Of single quantities the nearest values that keep the target, of as many as are asked for."""
        starts = {name: self._starts(name) for name in self.names}
        before, found = self.study.values, list[Change]()
        nearest = {name: abs(ends[0][0] - before[name]) / self.scale[name] for name, ends in starts.items() if ends}
        for name in sorted(nearest, key=nearest.__getitem__):
            change = self._nearest(name, starts[name]) if len(found) < self.effort.most else None
            found += [change] if change is not None else []
        return found

    def _starts(self, name: str) -> list[tuple[float, float]]:
        """Values of one quantity that keep the target, one on either side at most, the nearer first; and how far each may go."""
        starts = []
        for side in (-1, 1):
            values = ladder = self._ladder(name, side)
            for _ in range(self.effort.rounds):
                k = self._kept({name: values})
                if k is None:
                    break
                values = np.linspace(values[max(k - 1, 0)], values[k], self.effort.between)
            else:
                k = self._kept({name: values})
                if k is not None:
                    starts.append((float(values[k]), float(ladder[-1])))
        return sorted(starts, key=lambda one: abs(one[0] - self.study.values[name]))

    def _nearest(self, name: str, starts: list[tuple[float, float]]) -> Change | None:
        """The first of these with a proof, as it is printed."""
        best: Change | None = None
        for start, end in starts:
            change = self._first_proved({name: start + share * (end - start)} for share in self.effort.further)
            if change is not None and (best is None or _order(change) < _order(best)):
                best = change
            if best is not None and best.outcome == "proved":
                break
        return best

    def _ladder(self, name: str, side: int) -> FloatArray:
        """Values from the present one away, to where a redesign would be another brake."""
        start, share = self.study.values[name], np.linspace(0.0, 1.0, self.effort.values)
        if self.study.si(name) == "rad":
            end = math.radians(1.0) if side < 0 else math.radians(179.0)
            values = start + share * (end - start)
        elif start == 0:
            values = share**2 * (self._unit(name) if side > 0 else 0.0)
        else:
            values = start * _FACTOR ** (side * share)
        inside = [self._inside(name, value, value) for value in values.tolist()]
        return np.asarray(values[: inside.index(False)] if False in inside else values)

    # ------------------------------------------------------------------------------------------------- several at once

    def joint(self) -> Change | None:
        """The least change of all that has a tolerance; where that is one alone, of the three that move the jump most."""
        study, rise = self.study, rises.of(self.study)
        # Where a unit of what rises changes, the target is another one of its parameter.
        free = [name for name in self.names if name not in rises.units(study)]
        names = tuple(name for name in free if name in study.tolerances)
        try:
            names = names if len(names) > 1 else tuple(name for name in self._movers() if name in free)[:3]
            scale = {name: self.scale[name] for name in names}
            target = {rise.name: self.target / rises.scale(study)}
            start = None if rise.is_friction else rises.begin(study)
            after = ss.redesign(design(study), names, target, scale, begin=start).parameters
        except SpragsymError:
            return None
        if not isinstance(after, dict):
            return None
        # The least change has its jump on the target: as much further as its own tolerances ask for.
        before = self.study.values
        longer = (
            {name: before[name] + stretch * (value - before[name]) for name, value in after.items()} for stretch in _STRETCHES
        )
        allowed = (one for one in longer if all(self._inside(name, value, value) for name, value in one.items()))
        return self._first_proved(allowed)

    def _movers(self) -> tuple[str, ...]:
        """Quantities by how far one tolerance of each moves the jump."""
        designs = space(design(self.study), self.scale, None)
        z = np.zeros(len(designs.names))
        found = ss.jump_gradient(designs.sets(z), **rises.along(self.study)).slopes
        slopes = designs.slopes(z)
        moved = np.abs(sum(float(found[name]) * slopes[name] for name in found if name in slopes))
        return tuple(designs.names[j] for j in np.argsort(-moved, kind="stable"))

    # ------------------------------------------------------------------------------------------------- as it is printed

    def _first_proved(self, designs: Iterator[dict[str, float]]) -> Change | None:
        """The first of some designs with a proof; else the first without a brake that jumps among many samples."""
        open_one: Change | None = None
        tried: list[Mapping[str, float]] = []
        for after in designs:
            printed = self._printed(after)
            if printed is None or printed in tried:
                continue
            tried.append(printed)
            change = self._verified(printed, open_one is not None)
            if change is not None and change.outcome == "proved":
                return change
            open_one = open_one or change
        return open_one

    def _printed(self, after: Mapping[str, float]) -> dict[str, float] | None:
        """What changes, as it is printed, if it keeps the target; a value that does not change in print is left as it was."""
        study = self.study
        before = {name: study.values[name] for name in after}
        for further in range(4):
            rounded = {name: _rounded(study, name, before[name], value, further) for name, value in after.items()}
            if self._in_range(rounded) and self._kept({name: np.array([value]) for name, value in rounded.items()}) is not None:
                return {name: value for name, value in rounded.items() if value != before[name]}
        return None

    def _in_range(self, after: Mapping[str, float]) -> bool:
        """Whether all brakes within the tolerances about a design are brakes."""
        new = self.study.changed(after).quantities
        return all(self._inside(name, new[name].low, new[name].high) for name in after)

    def _inside(self, name: str, low: float, high: float) -> bool:
        """Whether all between two ends are values of a quantity."""
        allowed = self.allowed[name]
        return allowed.contains(low) and allowed.contains(high)

    def _verified(self, after: Mapping[str, float], proof_only: bool) -> Change | None:
        """A change with its certificate; None if a brake within the tolerances about it jumps, or only a proof will do."""
        study = self.study
        new, before = study.changed(after), {name: study.values[name] for name in after}
        try:
            jump = rises.told(new, rises.jump(new))
        except SpragsymError:
            return None
        if not begins_alike(study, after):
            return None
        outcome, (few, many) = certificate(new, hasty=True).outcome, self.effort.shares
        if outcome == "refuted" or (outcome == "undecided" and (proof_only or counterexample(new, many) is not None)):
            return None
        size = math.hypot(*((value - before[name]) / self.scale[name] for name, value in after.items()))
        share = 0.0 if outcome == "proved" else float(np.nanmean(jumping(new, samples(new, few))))
        return Change(before, after, jump, size, share if varied(study) else math.nan, outcome)


def _order(change: Change) -> tuple[bool, float]:
    """What is proved before what is not, then by distance."""
    return change.outcome != "proved", change.distance


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
    return math.radians(shown) if unit == math.pi / 180 else shown * unit
