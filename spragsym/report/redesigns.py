"""Redesigns that move the jump beyond a target: changes of single quantities, and the smallest
joint change, with certificates.

New values are rounded for the report, away from the old ones, and the rounded values are verified.
A change is discarded if a brake within its tolerances jumps; it is extended until a certificate is
found, or reported as undecided.
"""

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..core.errors import SpragsymError
from ..design.design_space import Design, EndOfState, space
from ..design.margins import jump_margin, redesign
from ..display import Column
from ..models.parameters import Range, Span
from ..numerics.interval_arrays import BoolArray
from ..results import Result
from .study import Study
from .tolerances import (
    begins_alike,
    certificate,
    corners,
    counterexample,
    ending,
    samples,
    sampling_budget,
    values_at,
    varied,
)
from .units import Numbers

#: Assumed tolerance of an inclination without one, radians.
_INCLINATION_TOLERANCE = math.radians(1.0)
#: Largest factor by which a quantity is increased or decreased, if the data have no may_change.
LARGEST_FACTOR = 3.0


@dataclass(frozen=True)
class Change(Result):
    """A new design.

    Attributes
    ----------
    before, after : dict
        Old and new values in SI of the quantities that change.
    jump_at : float
        Value of the loading at the jump, as reported.
    distance : float
        Size of the change, in tolerances.
    probability : float
        Probability of a jump within the tolerances: 0 if proved, else from samples; NaN if nothing
        has a tolerance.
    outcome : str
        Of the certificate that nothing jumps within the tolerances: ``"proved"``, or
        ``"undecided"`` if neither a proof nor a counterexample was found.
    """

    schema = (
        Column("{a}_before", "{a}", "{a} of the old design"),
        Column("{a}_after", "{a}", "{a} of the new design"),
    )

    before: Numbers
    after: Numbers
    jump_at: float
    distance: float
    probability: float
    outcome: str


def changes(study: Study, target: float) -> tuple[Change, ...]:
    """Changes with the jump at or beyond a target, and for all brakes within the tolerances beyond
    the largest value of the loading.

    First single quantities, the smallest change first, then the smallest joint change, unless only
    that has no proof. ``target`` is a friction, or another loading in SI.

    Source: :func:`spragsym.redesign`, and :func:`spragsym.certify` over the tolerances around the
    printed values. It is not proved that no smaller change exists. Tolerances stay the same
    relative to the values, that of an inclination absolutely.
    """
    search = _RedesignSearch(study, target)
    found = search.singles()
    together = search.joint()
    if (
        together is None
        or any(one.after.keys() == together.after.keys() for one in found)
        or (together.outcome != "proved" and any(one.outcome == "proved" for one in found))
    ):
        return tuple(found)
    return (*found, together)


def distance(study: Study) -> float:
    """Distance in tolerances to the nearest brake that jumps, see :func:`spragsym.jump_margin`; NaN
    without tolerances, or without a jump.
    """
    scale = {name: size for name, size in study.tolerances.items() if name in study.kind.of_statics}
    if scale and study.load:
        return float(jump_margin(design(study), scale, **study.along()).distance)
    return math.nan


def design(study: Study) -> Design:
    """The brake as drawn, with the friction in use, as a design of the model, in SI."""
    kind = study.kind
    name, own = kind.friction, kind.model.coefficient
    works = {} if name is None or own is None else {name: float(study.operating_point[own])}
    return Design(
        study.values | works,
        kind.ranges(study.values),
        kind.groups,
        dict,
        kind.model.Parameters,
        study.start,
        study.dimensionless.followed,
        {study.loading.name: study.loading.quantity},
    )


class _RedesignSearch:
    """Search for changes of a brake: ``span`` are ranges, and ``scale`` tolerances, of the
    quantities that may change.
    """

    def __init__(self, study: Study, target: float) -> None:
        self.study, self.target, self.budget = study, target, sampling_budget(study)
        self.span = {
            name: self._span(name) for name in study.kind.balanced if name != study.loading.quantity
        }
        self.scale = {
            name: self._scale(name) for name, (low, high) in self.span.items() if low < high
        }
        self.allowed, self.corners = study.kind.ranges(study.values), corners(study)
        within = {name: Range(*ends, closed_high=True) for name, ends in self.span.items()}
        self.within = replace(design(study), ranges=self.allowed | within)

    def _span(self, name: str) -> Span:
        """Range of values of a quantity: from the data, else up to :data:`LARGEST_FACTOR`, for an
        inclination within 1° to 179°.
        """
        start = self.study.values[name]
        if self.study.may_change:
            return self.study.may_change.get(name, (start, start))
        low, high = sorted((start / LARGEST_FACTOR, start * LARGEST_FACTOR))
        if self.study.kind.units[name] == "rad":
            return (max(low, _INCLINATION_TOLERANCE), min(high, math.pi - _INCLINATION_TOLERANCE))
        return (low, high)

    def _scale(self, name: str) -> float:
        """Tolerance of a quantity; if it has none, 1° for an inclination, else a tenth of the value
        (of the smallest in the same unit, if the value is 0).
        """
        study, si = self.study, self.study.kind.units
        if name in study.tolerances:
            return study.tolerances[name]
        if si[name] == "rad":
            return _INCLINATION_TOLERANCE
        alike = [
            value for other, value in study.values.items() if value > 0 and si[other] == si[name]
        ]
        return 0.1 * (study.values[name] or min(alike, default=0.01 * study.scale(si[name])))

    def _keep(self, designs: Sequence[Numbers]) -> BoolArray:
        """Mask of designs that are allowed, do not jump below the target, and do not jump at any
        corner of their tolerances.
        """
        new = {
            i: self.study.changed(one)
            for i, one in enumerate(designs)
            if all(self._may_be(*item) for item in one.items())
        }
        for shares, target in (None, self.target), (self.corners, None):
            if new:
                neighbours = [
                    one.values if shares is None else values_at(one, shares) for one in new.values()
                ]
                values = {
                    name: np.concatenate([np.atleast_1d(one[name]) for one in neighbours])
                    for name in self.study.values
                }
                remains = ending(self.study, values, target, coarse=True) == 0
                none_jumps = remains.reshape(len(new), -1).all(axis=1)
                new = dict(itertools.compress(new.items(), none_jumps))
        return np.isin(np.arange(len(designs)), [*new])

    def singles(self) -> list[Change]:
        """Smallest changes of single quantities that reach the target, in increasing order, at most
        as many as the budget says.
        """
        least = filter(None, (self._least((name,)) for name in self.scale))
        found = [
            self._first_proved(one) for one in sorted(least, key=self._distance)[: self.budget.most]
        ]
        return sorted((one for one in found if one is not None), key=lambda one: one.distance)

    def _distance(self, after: Numbers) -> float:
        """Size of a change, in tolerances."""
        return math.hypot(
            *((value - self.study.values[name]) / self.scale[name] for name, value in after.items())
        )

    def joint(self) -> Change | None:
        """The smallest joint change of all quantities with a tolerance; if there are less than two,
        of the three quantities that move the jump most.
        """
        names = tuple(name for name in self.scale if name in self.study.tolerances)
        try:
            if len(names) < 2:
                designs = space(design(self.study), self.scale, "scale")
                start = EndOfState(designs, self.study.loading.name, self.study.start())
                _, moved = start.ahead(np.zeros(len(designs.names)))
                names = tuple(
                    designs.names[j] for j in np.argsort(-np.abs(moved), kind="stable")[:3]
                )
        except SpragsymError:
            return None
        return self._first_proved(self._least(names))

    def _least(self, names: tuple[str, ...]) -> Numbers | None:
        """The smallest change of some quantities with the jump at the target, restricted to their
        ranges; None if none is found.
        """
        study = self.study
        try:
            target = {study.loading.name: self.target}
            change = {name: self.scale[name] for name in names}
            after: Any = redesign(self.within, change, target, begin=study.start()).parameters
        except SpragsymError:
            return None
        if after:
            return {name: float(np.clip(value, *self.span[name])) for name, value in after.items()}
        return None

    def _further(self, after: Numbers) -> Iterator[Numbers]:
        """A change for which no corner of the tolerances jumps, and larger ones, up to the end of
        the range of a quantity.
        """
        before = self.study.values
        way = {name: value - before[name] for name, value in after.items()}
        left = min(
            [
                (self.span[name][step > 0] - after[name]) / step
                for name, step in way.items()
                if step
            ],
            default=0.0,
        )
        # Joint changes are extended by twice the smallest one at most.
        if len(way) > 1:
            left = min(left, 2.0)

        def at(share: float) -> Numbers:
            return {name: before[name] + (1 + share * left) * step for name, step in way.items()}

        # Shares of the remaining range at which corners of the tolerances are examined.
        tried, high = np.array((0.0, 0.01, 0.03, 0.1, 0.2, 0.4, 0.7, 1.0)), 0.0
        for _ in range(3):
            kept = self._keep([at(share) for share in tried.tolist()])
            if not kept.any():
                return
            first = int(np.argmax(kept))
            high = float(tried[first])
            if not high:
                break
            # Refine between the last design that jumps and the first that does not.
            tried = np.linspace(tried[first - 1], high, 9)
        yield from (at(high + share * (1 - high)) for share in self.budget.further)

    def _first_proved(self, least: Numbers | None) -> Change | None:
        """The first change with a proof, of the smallest one and larger ones; else the first for
        which no brake among many samples jumps.
        """
        open_one = None
        tried: list[Numbers] = []
        for after in self._further(least) if least else ():
            printed = self._printed(after)
            if printed is None or printed in tried:
                continue
            tried.append(printed)
            change = self._verified(printed, open_one is not None)
            if change is not None and change.outcome == "proved":
                return change
            open_one = open_one or change
        return open_one

    def _printed(self, after: Numbers) -> Numbers | None:
        """A change rounded as it is printed, if it still reaches the target; None otherwise. Values
        that do not change in print are left out.
        """
        for further in range(4):
            rounded = {
                name: _rounded(self.study, name, value, further) for name, value in after.items()
            }
            new = self.study.changed(rounded).quantities
            inside = all(
                self.allowed[name].contains(end)
                for name in rounded
                for end in (new[name].low, new[name].high)
            )
            if inside and self._keep([rounded]).all():
                return {
                    name: value
                    for name, value in rounded.items()
                    if value != self.study.values[name]
                }
        return None

    def _may_be(self, name: str, value: float) -> bool:
        """True if a quantity may have a value, up to rounding."""
        (low, high), rounding = self.span[name], 1e-12 * abs(value)
        return self.allowed[name].contains(value) and low - rounding <= value <= high + rounding

    def _verified(self, after: Numbers, proof_only: bool) -> Change | None:
        """A change with its certificate; None if a brake within the tolerances jumps, or if there
        is no proof and ``proof_only``.
        """
        study, new = self.study, self.study.changed(after)
        try:
            jump = new.displayed(new.jump())
        except SpragsymError:
            return None
        if not begins_alike(study, after):
            return None
        outcome = certificate(new, coarse=True).outcome
        undecided = outcome == "undecided"
        if outcome == "refuted" or (
            undecided and (proof_only or counterexample(new, self.budget.many) is not None)
        ):
            return None
        share = (
            float(np.nanmean(ending(new, values_at(new, samples(new, self.budget.shares)))))
            if undecided
            else 0.0
        )
        before = {name: study.values[name] for name in after}
        return Change(
            before,
            after,
            jump,
            self._distance(after),
            share if varied(study) else math.nan,
            outcome,
        )


def _rounded(study: Study, name: str, after: float, further: int) -> float:
    """A new value rounded to a few digits in its unit, away from the old one, and moved away by
    ``further`` units of the last digit.
    """
    before, unit = study.values[name], study.unit_size(name)
    old, new = before / unit, after / unit
    digits = 3
    step = 10.0 ** (math.floor(math.log10(abs(new))) - digits + 1) if new else 1.0
    if abs(new - old) < 0.5 * step:
        return before
    away = math.copysign(1.0, new - old)
    steps = (math.ceil if away > 0 else math.floor)(new / step) + away * further
    shown = float(f"{steps * step:.{digits + 2}g}")
    return math.radians(shown) if unit == math.pi / 180 else shown * unit
