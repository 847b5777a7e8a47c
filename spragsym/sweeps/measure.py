"""What is measured of one motion of a sweep, or why there is nothing to measure."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from ..dynamics import integrators
from ..dynamics.classify import classified
from ..dynamics.motions import Measured, Motions
from ..dynamics.problem import MAX_STEPS, out_of_range
from ..dynamics.regimes import Regime
from ..files.journal import Record
from ..parameters import FloatArray

#: What is measured of every motion after its transient.
AVERAGES = ("rms", "spread", "largest", "mean", "mean_y", "contact_lost", "slip_reversed")

#: What a record says, after those, about the limit of the motion.
LIMITS = ("period", "rate", "distance", "cycle_mean", "cycle_rms", "cycle_x", "cycle_y", "cycle_vy")

#: Numbers that a file and a result hold.
REPORTED = (*AVERAGES, *LIMITS)

#: A record holds these numbers, then the code of the regime and the place of the equilibrium.
MEASURED = (*REPORTED, "regime", "rest_x", "rest_y")


@dataclass(frozen=True)
class Settings:
    """What all motions of a sweep share."""

    t_end: float
    transient: float
    rtol: float
    backend: str
    max_steps: int = MAX_STEPS


#: Motions of points whose values were validated with the whole sweep's, and why points have none, by their numbers; the
#: motions are those of the other points, in order. To be sent to other processes.
MotionsOf: TypeAlias = Callable[[Settings, Sequence[tuple[float, ...]]], tuple[Motions | None, dict[int, Exception]]]


def measured(motions_of: MotionsOf, settings: Settings, points: Sequence[tuple[float, ...]]) -> list[Record]:
    """A record each. What a motion itself makes impossible is its reason; whatever else goes wrong is raised."""
    found, reasons = motions_of(settings, points)
    records: list[Record] = [_no_result(reasons[i]) if i in reasons else ([], "") for i in range(len(points))]
    if found is not None:
        with np.errstate(all="ignore"):  # numbers out of range show in the result
            table, errors = _values(found, settings.backend)
        places = (i for i in range(len(points)) if i not in reasons)
        for row, (i, values) in enumerate(zip(places, table.tolist(), strict=True)):
            records[i] = _no_result(errors[row]) if row in errors else (values, "")
    return records


def _no_result(error: Exception) -> Record:
    error = out_of_range() if isinstance(error, ArithmeticError) else error
    return [], f"{type(error).__name__}: {' '.join(str(error).split())}"


def _values(motions: Motions, backend: str) -> tuple[FloatArray, dict[int, Exception]]:
    """The measured values of motions, in the order of MEASURED, and why there are none."""
    found = integrators.measure(motions, backend)
    table, errors = np.full((len(motions), len(MEASURED)), np.nan), found.errors.copy()
    table[:, : len(AVERAGES)] = _averages(found).T
    table[:, MEASURED.index("regime")] = Regime.UNSETTLED
    needed = [i for i, name in enumerate(AVERAGES) if name != "mean_y" or motions.starts.shape[1] > 2]
    for row in np.flatnonzero(~np.isfinite(table[:, needed]).all(axis=1)).tolist():
        errors.setdefault(row, out_of_range())
    for row, outcome in classified(found, motions, backend):
        if isinstance(outcome, Exception):
            errors.setdefault(row, outcome)
        else:
            table[row, len(AVERAGES) :] = [getattr(outcome, name) for name in MEASURED[len(AVERAGES) :]]
    return table, errors


def _averages(found: Measured) -> FloatArray:
    """The measured values after the transient, in the order of AVERAGES."""
    mean, spread, *others = found.averages
    mean_y = others[0] if others else np.full(len(mean), np.nan)
    lost, _, *reversals = found.events.T
    largest = np.maximum(np.abs(found.low), np.abs(found.high))
    return np.array([np.hypot(mean, spread), spread, largest, mean, mean_y, lost, sum(reversals)])
