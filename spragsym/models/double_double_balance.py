"""The balance of forces with double-double residuals, for equilibria near folds, of which float64 knows few digits.

Boxes and slopes stay floats. What limits interval Newton near a fold is the rounding in the forces at the middle of a box, which
is divided by a stiffness that is nearly singular: of these alone more digits are needed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..exact.double_double import DoubleDouble
from ..exact.interval_arrays import FloatArray, Intervals, stacked
from ..exact.wide_balls import XP, WideBalls, cosine_and_sine
from .balance import Balance


class WideBalance(Balance):
    """Forces at floats with some thirty digits, for points of parameters; over boxes of parameters as :class:`Balance`."""

    def prepared(self, bounds: Intervals) -> Intervals:
        """As for the balance, and behind it high parts, low parts and radii of the arguments of single points; NaN for others."""
        parts = []
        single = bounds.low == bounds.high
        for place, name in enumerate(self.parameters):
            value = np.where(single[place], bounds.low[place], np.nan)
            parts += list(cosine_and_sine(value)) if name in self.angles else []
            parts += [] if self.only_turns(name) else [WideBalls.exact(value)]
        columns = [part for ball in parts for part in (ball.middle.high, ball.middle.low, ball.radius)]
        return Intervals(np.concatenate([super().prepared(bounds).ends, Intervals.point(np.array(columns)).ends], axis=1))

    def at_points(self, middles: FloatArray, parameters: Intervals) -> Intervals:
        """Forces at floats; those of the balance where more digits are not known."""
        known = super().at_points(middles, parameters)
        values = self.wide_values(parameters)
        wide = stacked(
            [_as_intervals(row, middles.shape[1]) for row in self.wide_forces([WideBalls.exact(row) for row in middles], values)],
            middles.shape[1:],
        )
        better = wide.ends[0] + wide.ends[1] < known.ends[0] + known.ends[1]
        return Intervals(np.where(better, wide.ends, known.ends))

    def wide_values(self, parameters: Intervals) -> dict[str, WideBalls]:
        """Arguments of generated functions by name, from what :meth:`prepared` has made."""
        rows = parameters.ends[1, len(self.codes) :].reshape(len(self.codes), 3, -1)
        return {
            code: WideBalls(DoubleDouble(high, low), radius) for code, (high, low, radius) in zip(self.codes, rows, strict=True)
        }

    def wide_forces(self, q: Sequence[Any], values: dict[str, WideBalls]) -> Any:
        """Forces of balls, or of jets of balls."""
        return self.call("forces", q, self.plain_directions(q, values, XP), values, XP)


@dataclass(frozen=True)
class Clusters:
    """The system of :func:`spragsym.exact.many_reductions.reduced_roots`: a wide balance, and the parameters of each cluster."""

    balance: WideBalance
    parameters: Intervals

    def values(self, rows: NDArray[np.int64], unknowns: Sequence[Any]) -> Sequence[Any]:
        """Forces of balls, of intervals, or of jets of intervals."""
        out: Sequence[Any] = self._called("forces", rows, unknowns)
        return out

    def slopes(self, rows: NDArray[np.int64], unknowns: Sequence[Any]) -> Sequence[Sequence[Any]]:
        """Stiffness of balls or of intervals."""
        out: Sequence[Sequence[Any]] = self._called("forces_jacobian", rows, unknowns)
        return out

    def _called(self, name: str, rows: NDArray[np.int64], q: Sequence[Any]) -> Any:
        given = self.parameters[:, rows]
        if isinstance(q[0], WideBalls):
            values = self.balance.wide_values(given)
            return self.balance.call(name, q, self.balance.plain_directions(q, values, XP), values, XP)
        values = self.balance.arguments(given)
        return self.balance.call(name, q, self.balance.directions(q, values, rows.shape), values)


def _as_intervals(row: Any, count: int) -> Intervals:
    return row.intervals() if isinstance(row, WideBalls) else Intervals.point(np.full(count, float(row)))
