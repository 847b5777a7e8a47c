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

#: What is said of a point by where its state ends, see :attr:`Facts.reach`, in the words of an
#: :class:`~spragsym.design.jumps.EndVerb`.
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
        Each quantity with its unit, then what is told of each point.
    rows : tuple of tuple
        One for each point: quantities in the units of the file; the loading parameter at the jump
        in its own, NaN where there is none; the margin to its largest value in percent; the
        outcome in words; and whether small disturbances die out.
    reason : str
        Why the first unsettled point is that; empty where there is none.
    """

    titles: tuple[str, ...]
    rows: tuple[tuple[float | str, ...], ...]
    reason: str

    @property
    def onsets(self) -> tuple[str, ...]:
        """Between which neighbours of a single quantity what is said of the state changes."""
        if len(self.titles) != 5:
            return ()
        return tuple(
            f"{self.titles[0]} {one[0]:.6g} to {two[0]:.6g}: from {one[4]} to {two[4]}"
            for one, two in itertools.pairwise(self.rows)
            if one[4] and two[4] and one[4] != two[4]
        )

    @property
    def unsettled(self) -> str:
        """Number of points without an answer, the reason, and the remedy; empty if there is
        none.
        """
        count = sum(row[-2] == OUTCOMES[""] for row in self.rows)
        if count:
            return (
                f"{count} of {len(self.rows)} unsettled, the first because {self.reason}; write "
                "that value into the file and ask for its report, which says more, or take other "
                "ends"
            )
        return ""

    def csv(self) -> str:
        """Lines with commas under one line of titles; what has no number is empty."""
        lines = [self.titles, *(map(_cell, row) for row in self.rows)]
        return "".join(f"{','.join(line)}\n" for line in lines)


def _cell(value: float | str) -> str:
    return value if isinstance(value, str) else repr(value) if math.isfinite(value) else ""


def verdicts_over(study: Study, over: Mapping[str, FloatArray]) -> Verdicts:
    """The verdict at each point of a grid; values are in the units of the file.

    A quantity that has a tolerance keeps it as a share of its value, an inclination as it is.

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
            _in_si(study, name, value)  # an error for one out of range, before anything is asked
    points = list(itertools.product(*(one.tolist() for one in over.values())))
    rows, reason = [], ""
    for number, point in enumerate(points, 1):
        with doing("{} of {} points", number, len(points)):
            verdict, why = _verdict_of(study, dict(zip(over, point, strict=True)))
        reason = reason or why
        rows.append((*point, *verdict))
    units = [_titled(name, study.quantities[name].unit) for name in over]
    load = study.loading
    unit = "" if study.of_friction else study.quantities[load.quantity].unit if load.name else ""
    titles = (*units, _titled(f"jump {load.word}", unit), "margin [%]", "outcome", "state")
    return Verdicts(titles, tuple(rows), reason)


def _titled(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit else name


def _verdict_of(study: Study, values: Mapping[str, float]) -> tuple[tuple[float | str, ...], str]:
    """Verdict of one point, and the reason where there is none."""
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
    """The brake with quantities at values in the units of the file; a damping ratio holds for every
    mode there, too, unless one of its dampers is among them.
    """
    new = study.changed({name: _in_si(study, name, value) for name, value in values.items()})
    dampers = study.kind.dampers
    if study.damping_ratio is not None and not set(dampers) & set(values):
        others = {name: one for name, one in new.quantities.items() if name not in dampers}
        found = modal_dampers(study.kind, others, study.damping_ratio)
        new = new.with_quantities({**new.quantities, **found})
    return new


def _in_si(study: Study, name: str, value: float) -> float:
    """A value in the unit of the file; an error for one out of range."""
    si, allowed = value * study.unit_size(name), study.kind.ranges()[name]
    if not allowed.contains(si):
        raise ParameterError(f"over: {name} = {study.shown(name, si)} is not in {allowed}")
    return si
