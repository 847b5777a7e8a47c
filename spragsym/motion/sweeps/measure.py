"""Measures of one motion of a sweep, or the reason why there are none."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from ...files.journal import Record
from ...models.model_field import field_of
from ...models.parameters import FloatArray
from .. import integrators
from ..classify import classified
from ..measures import Course
from ..problem import MAX_STEPS, Motions, out_of_range, without_direction
from ..regimes import Regime


def reported(coordinates: Sequence[str], rates: Sequence[str]) -> tuple[str, ...]:
    """Numbers that a file and a result hold, by names of the model; a record holds these, then the code of the regime.

    Of the first coordinate after the transient, and means of the others; then about the limit, from ``period`` on: an equilibrium
    by its place, a cycle by one state.
    """
    return (
        "rms", "spread", "largest", "mean", *(f"mean_{name}" for name in coordinates[1:]), "contact_lost", "slip_reversed",
        "period", "rate", "distance", "cycle_mean", "cycle_rms", *(f"rest_{name}" for name in coordinates),
        *(f"cycle_{name}" for name in (*coordinates, *rates)),
    )  # fmt: skip


@dataclass(frozen=True)
class Settings:
    """What all motions of a sweep share."""

    t_end: float
    transient: float
    rtol: float
    backend: str
    max_steps: int = MAX_STEPS


def measured(model: Any, settings: Settings, points: Sequence[tuple[float, ...]]) -> list[Record]:
    """A record each. What a motion itself makes impossible is its reason; whatever else goes wrong is raised."""
    count = len(model.parameters)
    constants = np.array([model.field.constants(point[:count]) for point in points], dtype=np.float64)
    starts = np.array([point[count:] for point in points], dtype=np.float64)
    records = {i: _no_result(error) for i, error in without_direction(model, constants.T, starts.T).items()}
    if kept := [i for i in range(len(points)) if i not in records]:
        given = settings.t_end, settings.transient, settings.rtol, settings.max_steps
        with np.errstate(all="ignore"):  # numbers out of range show in the result
            table, errors = _values(Motions(constants[kept], starts[kept], *given, partial(field_of, model)), settings.backend)
        for row, (i, values) in enumerate(zip(kept, table.tolist(), strict=True)):
            records[i] = _no_result(errors[row]) if row in errors else (values, "")
    return [records[i] for i in range(len(points))]


def _no_result(error: Exception) -> Record:
    error = out_of_range() if isinstance(error, ArithmeticError) else error
    return [], f"{type(error).__name__}: {' '.join(str(error).split())}"


def _values(motions: Motions, backend: str) -> tuple[FloatArray, dict[int, Exception]]:
    """What records of motions hold, a row each, and why there is none."""
    found, names, n = integrators.measure(motions, backend), motions.field.components, len(motions.field.coordinates)
    told = reported(names[:n], names[n:])
    table, errors = np.full((len(motions), len(told) + 1), np.nan), dict[int, Exception]()
    table[:, -1] = Regime.UNSETTLED
    for row, course in enumerate(found):
        if isinstance(course, Exception):
            errors[row] = course
            continue
        first = _averages(course)
        table[row, : len(first)] = first
        if not np.isfinite(first).all():
            errors[row] = out_of_range()
    after = 5 + n
    for row, outcome in classified(found, motions, backend):
        if isinstance(outcome, Exception):
            errors.setdefault(row, outcome)
        else:
            table[row, after:] = [getattr(outcome, name) for name in (*told[after:], "regime")]
    return table, errors


def _averages(course: Course) -> list[float]:
    """The measured values after the transient, in the order of :func:`reported`."""
    mean, spread = course.moments()
    lost, _, *reversals = course.events
    return [math.hypot(mean, spread), spread, max(map(abs, course.reach)), *course.means, lost, sum(reversals)]
