"""Changes that move the jump beyond a target: single quantities, and the least joint change, with certificates.

A value is rounded to what stands in the report, away from the old one, and verified as it stands there. A change that a brake
within its tolerances refutes is not given: it goes on until the proof is found, or is said to be missing.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import spragsym as ss

from ..design.design_space import Design, space
from ..errors import SpragsymError
from ..models.parameters import FloatArray
from ..models.units import factor
from ..results.result import Result
from .study import Study
from .tolerances import begins_alike, certificate, corners, counterexample, effort, ending, jumping, samples, values_at, varied

#: Tolerance of a quantity that has none, as a share of its value; of the inclination in radians.
_SHARE, _ANGLE = 0.1, math.radians(1.0)
#: A quantity is changed by up to this factor either way, where the data do not say how far it may change.
FACTOR = 3.0
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

    Single quantities, nearest first, and last the least joint change; ``target`` is a friction, or what rises in SI.

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
    scale = {name: size for name, size in study.tolerances.items() if name in study.kind.of_statics}
    return float(ss.jump_margin(design(study), scale, **study.along()).distance) if scale else math.nan


def design(study: Study) -> Design:
    """The brake as drawn, with the friction that works, as a design of the model: quantities in SI."""
    kind = study.kind
    works = {"mu0": float(study.at_work.mu0)} if "mu0" in kind.model.parameters else {}
    begin = None if study.of_friction else study.begins
    return Design(
        {**study.values, **works}, kind.ranges(study.values), kind.groups, dict, kind.model.Parameters, begin,
        study.dimensionless.followed,
    )  # fmt: skip


class _Search:
    """The changes of one brake."""

    def __init__(self, study: Study, target: float) -> None:
        self.study, self.target, self.effort = study, target, effort(study)
        self.span = {name: self._span(name) for name in study.kind.balanced if name != study.rises.quantity}
        self.names = tuple(name for name, (low, high) in self.span.items() if low < high)
        self.scale = {name: self._scale(name) for name in self.names}
        self.allowed, self.corners = study.kind.ranges(study.values), corners(study)

    def _span(self, name: str) -> tuple[float, float]:
        """Between which values it may change: as the data say, else by :data:`FACTOR`, an inclination from 1° to 179°."""
        start = self.study.values[name]
        if self.study.may_change:
            return self.study.may_change.get(name, (start, start))
        low, high = min(start / FACTOR, start * FACTOR), max(start / FACTOR, start * FACTOR)
        return (max(low, _ANGLE), min(high, math.pi - _ANGLE)) if self.study.kind.units[name] == "rad" else (low, high)

    def _scale(self, name: str) -> float:
        study, si = self.study, self.study.kind.units
        if name in study.tolerances:
            return study.tolerances[name]
        if si[name] == "rad":
            return _ANGLE
        alike = [value for other, value in study.values.items() if value > 0 and si[other] == si[name]]
        return _SHARE * (study.values[name] or min(alike, default=0.01 * study.scale(si[name])))

    def _reaches(self, changed: Mapping[str, FloatArray]) -> NDArray[np.bool_]:
        """Which designs are known not to jump at the target or below it."""
        shape = np.shape(next(iter(changed.values())))
        rows = {name: np.broadcast_to(changed.get(name, value), shape) for name, value in self.study.values.items()}
        return np.asarray(ending(self.study, rows, self.target, hasty=True) == 0)

    def _kept(self, changed: Mapping[str, FloatArray]) -> int | None:
        """The first design that jumps at the target at the earliest, and at no corner of its tolerances."""
        left = np.flatnonzero(self._reaches(changed))
        for begin in range(0, left.size, _AT_ONCE):
            some = left[begin : begin + _AT_ONCE]
            designs = [self.study.changed({name: float(values[i]) for name, values in changed.items()}) for i in some]
            about = [values_at(design, self.corners) for design in designs]
            rows = {name: np.concatenate([one[name] for one in about]) for name in about[0]}
            free = (ending(self.study, rows, hasty=True) == 0).reshape(len(some), -1).all(axis=1)
            if free.any():
                return int(some[np.flatnonzero(free)[0]])
        return None

    def singles(self) -> list[Change]:
        """Nearest values of single quantities that keep the target, of as many as are asked for."""
        starts, found = {name: self._starts(name) for name in self.names}, list[Change]()
        for name in sorted((name for name in self.names if starts[name]), key=lambda name: self._off(name, starts[name][0][0])):
            change = self._nearest(name, starts[name]) if len(found) < self.effort.most else None
            found += [] if change is None else [change]
        return found

    def _off(self, name: str, value: float) -> float:
        return abs(value - self.study.values[name]) / self.scale[name]

    def _starts(self, name: str) -> list[tuple[float, float]]:
        """Values of one quantity that keep the target, one on either side at most, the nearer first; and how far each may go."""
        starts = []
        for side in (-1, 1):
            values = ladder = self._ladder(name, side)
            k = self._kept({name: values})
            for _ in range(self.effort.rounds):
                if k is not None:
                    values = np.linspace(values[max(k - 1, 0)], values[k], self.effort.between)
                    k = self._kept({name: values})
            if k is not None:
                starts.append((float(values[k]), float(ladder[-1])))
        return sorted(starts, key=lambda one: self._off(name, one[0]))

    def _nearest(self, name: str, starts: list[tuple[float, float]]) -> Change | None:
        """The first of these with a proof, as it is printed."""
        best: Change | None = None
        for start, end in starts:
            change = self._first_proved({name: start + share * (end - start)} for share in self.effort.further)
            best = min((one for one in (best, change) if one is not None), key=_order, default=None)
            if best is not None and best.outcome == "proved":
                break
        return best

    def _ladder(self, name: str, side: int) -> FloatArray:
        start, end, share = self.study.values[name], self.span[name][side > 0], np.linspace(0.0, 1.0, self.effort.values)
        if (end - start) * side <= 0:
            return np.empty(0)
        geometric = start * end > 0 and self.study.kind.units[name] != "rad"
        values = start * (end / start) ** share if geometric else start + share**2 * (end - start)
        values = np.clip(values, *self.span[name])  # the last by rounding, the first where the present value lies outside
        inside = [self._inside(name, value, value) for value in values.tolist()]
        return np.asarray(values[: inside.index(False)] if False in inside else values)

    def joint(self) -> Change | None:
        """The least change of all that has a tolerance; where that is one alone, of the three that move the jump most."""
        study, rise = self.study, self.study.rises
        # Where a unit of the loading parameter changes, the target is another one of its parameter.
        free = [name for name in self.names if not study.kind.powers(study.kind.units[rise.quantity]).get(name)]
        names = tuple(name for name in free if name in study.tolerances)
        try:
            names = names if len(names) > 1 else tuple(name for name in self._movers() if name in free)[:3]
            target, start = {rise.name: self.target / study.rise_scale}, None if study.of_friction else study.begins()
            after = ss.redesign(design(study), names, target, {name: self.scale[name] for name in names}, begin=start).parameters
        except SpragsymError:
            return None
        if not isinstance(after, dict):
            return None
        # The least change has its jump on the target: as much further as its own tolerances ask for.
        before = study.values
        longer = (
            {name: before[name] + stretch * (value - before[name]) for name, value in after.items()} for stretch in _STRETCHES
        )
        return self._first_proved(one for one in longer if all(self._may_be(name, at) for name, at in one.items()))

    def _movers(self) -> tuple[str, ...]:
        designs = space(design(self.study), self.scale, None)
        z = np.zeros(len(designs.names))
        found, slopes = ss.jump_gradient(designs.sets(z), **self.study.along()).slopes, designs.slopes(z)
        moved = np.abs(sum(float(found[name]) * slopes[name] for name in found if name in slopes))
        return tuple(designs.names[j] for j in np.argsort(-moved, kind="stable"))

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
        for further in range(4):
            rounded = {name: _rounded(self.study, name, value, further) for name, value in after.items()}
            new = self.study.changed(rounded).quantities
            kept = all(
                self._inside(name, new[name].low, new[name].high) and self._may_be(name, value) for name, value in rounded.items()
            )
            if kept and self._kept({name: np.array([value]) for name, value in rounded.items()}) is not None:
                return {name: value for name, value in rounded.items() if value != self.study.values[name]}
        return None

    def _inside(self, name: str, low: float, high: float) -> bool:
        return self.allowed[name].contains(low) and self.allowed[name].contains(high)

    def _may_be(self, name: str, value: float) -> bool:
        """Whether a quantity may change to a value, but for the rounding of that."""
        (low, high), rounding = self.span[name], 1e-12 * abs(value)
        return self.allowed[name].contains(value) and low - rounding <= value <= high + rounding

    def _verified(self, after: Mapping[str, float], proof_only: bool) -> Change | None:
        """A change with its certificate; None if a brake within the tolerances about it jumps, or only a proof will do."""
        study, new = self.study, self.study.changed(after)
        try:
            jump = new.told(new.jump())
        except SpragsymError:
            return None
        if not begins_alike(study, after):
            return None
        outcome = certificate(new, hasty=True).outcome
        undecided = outcome == "undecided"
        if outcome == "refuted" or (undecided and (proof_only or counterexample(new, self.effort.many) is not None)):
            return None
        share = float(np.nanmean(jumping(new, samples(new, self.effort.shares)))) if undecided else 0.0
        size = math.hypot(*(self._off(name, value) for name, value in after.items()))
        before = {name: study.values[name] for name in after}
        return Change(before, after, jump, size, share if varied(study) else math.nan, outcome)


def _order(change: Change) -> tuple[bool, float]:
    return change.outcome != "proved", change.distance


def _rounded(study: Study, name: str, after: float, further: int) -> float:
    """A value rounded away from the old one to few digits in its unit, and then by single units of the last digit farther."""
    before, unit = study.values[name], factor(study.quantities[name].unit, study.kind.units[name])
    old, new = before / unit, after / unit
    step = 10.0 ** (math.floor(math.log10(abs(new))) - _DIGITS + 1) if new else 1.0
    if abs(new - old) < 0.5 * step:
        return before
    away = math.copysign(1.0, new - old)
    steps = (math.ceil if away > 0 else math.floor)(new / step) + away * further
    shown = float(f"{steps * step:.{_DIGITS + 2}g}")
    return math.radians(shown) if unit == math.pi / 180 else shown * unit
