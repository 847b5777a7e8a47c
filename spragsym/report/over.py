"""The verdict on a brake over one of its quantities, or two."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass

from ..core.errors import ParameterError, SpragsymError, hint
from ..core.progress import doing
from ..design.jumps import verb_of
from ..models.parameters import FloatArray
from ..statics.equilibria import equilibria
from .damping import modal_dampers
from .facts import percent_beyond, reach_of, speed_of_jump
from .states import current, states
from .study import Study

#: Outcome in words for each :attr:`Facts.reach`, with the forms of an
#: :class:`~spragsym.design.jumps.EndVerb` to be inserted.
OUTCOMES = {
    "jumped": "{0.has_done}",
    "within": "{0.does} within the tolerances",
    "faster": "{0.does} at higher speed",
    "beyond": "does not {0.do}",
    "never": "never {0.does}",
    "": "unsettled",
}


@dataclass(frozen=True)
class Verdicts:
    """The verdict at each point of a grid of quantities.

    Attributes
    ----------
    titles : tuple of str
        Titles of the columns, with units.
    rows : tuple of tuple
        For each point: the quantities, in the units of the file; the loading at the jump, NaN if
        there is none; the margin between its largest value and the jump in percent; the outcome in
        words; the stability of the current state.
    reason : str
        Reason for which the first unsettled point has no answer; empty if there is none.
    """

    titles: tuple[str, ...]
    rows: tuple[tuple[float | str, ...], ...]
    reason: str

    @property
    def onsets(self) -> tuple[str, ...]:
        """For a single quantity, the intervals between points of different stability."""
        if len(self.titles) != 5:
            return ()
        return tuple(
            f"{self.titles[0]} {one[0]:.6g} to {two[0]:.6g}: from {one[4]} to {two[4]}"
            for one, two in itertools.pairwise(self.rows)
            if one[4] and two[4] and one[4] != two[4]
        )

    @property
    def unsettled(self) -> str:
        """Number of points without an answer, with reason and remedy; empty if there are none."""
        count = sum(row[-2] == OUTCOMES[""] for row in self.rows)
        if count:
            return (
                f"{count} of {len(self.rows)} unsettled, the first because {self.reason}; write "
                "that value into the file and ask for its report, which says more, or take other "
                "ends"
            )
        return ""

    def csv(self) -> str:
        """The rows as CSV text, with a header; NaN is empty."""
        lines = [self.titles, *(map(_cell, row) for row in self.rows)]
        return "".join(f"{','.join(line)}\n" for line in lines)


def _cell(value: float | str) -> str:
    """A cell of a CSV file."""
    if isinstance(value, str):
        return value
    return repr(value) if math.isfinite(value) else ""


def verdicts_over(study: Study, over: Mapping[str, FloatArray]) -> Verdicts:
    """The verdict at each point of a grid, with values in the units of the file.

    Tolerances stay the same relative to the values, that of an inclination absolutely.

    Raises
    ------
    ParameterError
        For a name that is no quantity of the brake.
    """
    for name, values in over.items():
        if name not in study.quantities:
            quantities = [*study.quantities]
            remark = hint(name, quantities) or f"; choose of {', '.join(quantities)}"
            raise ParameterError(f"over: {name!r} is no quantity of the brake{remark}")
        for value in values.tolist():
            _in_si(study, name, value)  # raises for a value out of range, before any computation
    points = list(itertools.product(*(one.tolist() for one in over.values())))
    rows, reason = [], ""
    for number, point in enumerate(points, 1):
        with doing("{} of {} points", number, len(points)):
            verdict, why = _verdict_of(study, dict(zip(over, point, strict=True)))
        reason = reason or why
        rows.append((*point, *verdict))
    units = [_titled(name, study.quantities[name].unit) for name in over]
    load = study.loading
    unit = ""
    if load.name and not study.of_friction:
        unit = study.quantities[load.quantity].unit
    titles = (*units, _titled(f"jump {load.word}", unit), "margin [%]", "outcome", "state")
    return Verdicts(titles, tuple(rows), reason)


def _titled(name: str, unit: str) -> str:
    """Title of a column."""
    return f"{name} [{unit}]" if unit else name


def _verdict_of(study: Study, values: Mapping[str, float]) -> tuple[tuple[float | str, ...], str]:
    """Columns of the verdict at a point, and the reason if there is no answer."""
    try:
        at = brake_at(study, values)
        jump = at.displayed(at.jump())
        eq = equilibria(at.operating_point)
        found = states(at, eq, current(at, eq))
    except SpragsymError as error:
        return (math.nan, math.nan, OUTCOMES[""], ""), str(error).partition(";")[0]
    here = next((state.stability for state in found if state.current), "")
    shown = jump if at.of_friction else at.in_file(at.loading.quantity, jump)
    outcome = OUTCOMES[reach_of(at, jump, speed_of_jump(at, jump))].format(verb_of(at.ends.kind()))
    return (shown, percent_beyond(jump, at.in_use[2]), outcome, here), ""


def brake_at(study: Study, values: Mapping[str, float]) -> Study:
    """The brake with some quantities changed, in the units of the file. If it has a damping ratio,
    the dampers are computed anew, unless one of them is among the values.
    """
    new = study.changed({name: _in_si(study, name, value) for name, value in values.items()})
    dampers = study.kind.dampers
    if study.damping_ratio is not None and not set(dampers) & set(values):
        others = {name: one for name, one in new.quantities.items() if name not in dampers}
        found = modal_dampers(study.kind, others, study.damping_ratio)
        new = new.with_quantities({**new.quantities, **found})
    return new


def _in_si(study: Study, name: str, value: float) -> float:
    """A value, given in the unit of the file, in SI; raises if it is out of range."""
    si, allowed = value * study.unit_size(name), study.kind.ranges()[name]
    if not allowed.contains(si):
        raise ParameterError(f"over: {name} = {study.shown(name, si)} is not in {allowed}")
    return si
