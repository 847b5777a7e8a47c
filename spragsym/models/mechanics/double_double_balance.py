"""The balance of forces with double-double residuals, for equilibria near folds, of which float64 knows few digits.

Boxes and slopes stay floats. What limits interval Newton near a fold is the rounding in the forces at the middle of a box, which
is divided by a stiffness that is nearly singular: of these alone more digits are needed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...exact.interval_arrays import FloatArray, Intervals
from ...exact.wide_balls import XP, WideBalls, cosine_and_sine
from .balance import Balance


@dataclass(frozen=True)
class Clusters:
    """The system of :func:`spragsym.exact.many_reductions.reduced_roots`: a balance, and the arguments of each cluster."""

    balance: Balance
    parameters: Intervals
    wide: Mapping[str, WideBalls]

    @classmethod
    def at(cls, balance: Balance, given: FloatArray) -> Clusters:
        """Of points of parameters, shape (parameters, clusters)."""
        wide = {}
        for name, value in zip(balance.parameters, given, strict=True):
            wide[name] = WideBalls.exact(value)
            if name in balance.angles:
                wide |= zip(balance.angles[name], cosine_and_sine(value), strict=True)
        return cls(balance, balance.prepared(Intervals.point(given)), wide)

    def values(self, rows: NDArray[np.int64], unknowns: Sequence[Any]) -> Sequence[Any]:
        """Forces of balls, of intervals, or of jets of intervals."""
        out: Sequence[Any] = self._called("forces", rows, unknowns)
        return out

    def slopes(self, rows: NDArray[np.int64], unknowns: Sequence[Any]) -> Sequence[Sequence[Any]]:
        """Stiffness of balls or of intervals."""
        out: Sequence[Sequence[Any]] = self._called("forces_jacobian", rows, unknowns)
        return out

    def _called(self, name: str, rows: NDArray[np.int64], q: Sequence[Any]) -> Any:
        if isinstance(q[0], WideBalls):
            wide = {name: value.taken(rows) for name, value in self.wide.items()}
            return self.balance.call(name, q, self.balance.plain_directions(q, wide, XP), wide, XP)
        values = self.balance.arguments(self.parameters[:, rows])
        return self.balance.call(name, q, self.balance.directions(q, values, rows.shape), values)
