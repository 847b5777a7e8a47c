"""The folds of a report in the units of the file: where a state ends, and where it goes."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from . import rises
from .states import place_in_units

if TYPE_CHECKING:
    from .reports import Report
    from .study import Study


@dataclass(frozen=True)
class FoldRow:
    """One fold, or another point at which states meet.

    ``friction``, ``inclination_deg`` or ``value``, of what rises in SI, is where, the others None; ``ends`` and ``when`` are as
    of :class:`~spragsym.Points`.
    ``before`` and ``after`` are the coordinates in the units of the file, of which those after are NaN where nothing is left.
    """

    kind: str
    friction: float | None
    inclination_deg: float | None
    value: float | None
    ends: str
    when: str
    before: Mapping[str, float]
    after: Mapping[str, float]


def fold_rows(report: Report) -> Iterator[FoldRow]:
    """All that the report found."""
    study = report.study
    for vary, found in report.folds.items():
        for i, value in enumerate(getattr(found, vary).tolist()):
            before, after = (
                place_in_units(study, {key: float(columns[key][i]) for key in study.coordinates})
                for columns in ({key: getattr(found, key) for key in study.coordinates}, found.after)
            )
            yield FoldRow(str(found.kind[i]), *_where(study, vary, value), str(found.ends[i]), str(found.when[i]), before, after)


def _where(study: Study, vary: str, value: float) -> tuple[float | None, float | None, float | None]:
    """A value as friction, as inclination in degrees, or as what rises."""
    if vary == "mu0":
        return rises.told(study, value), None, None
    if vary == "theta0":
        return None, math.degrees(value), None
    return None, None, rises.told(study, value)
