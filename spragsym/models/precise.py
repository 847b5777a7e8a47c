"""The balance of forces with many digits at floats: what a search near a fold lacks.

Boxes stay boxes of float64, and slopes over them stay as they are: two roots that are 10⁻⁸ apart are well apart as floats. What
float64 does not tell is on which side of zero the forces are between them, where they are 10⁻¹⁶ and less.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np

from ..exact.ball_functions import XP, as_ends
from ..exact.interval_arrays import FloatArray, Intervals
from ..exact.intervals import Ball, Balls
from ..exact.polynomials import Undecided
from .balance import Balance, undecorated

#: Bits of the forces at floats.
BITS = 192


class PreciseBalance(Balance):
    """A :class:`Balance` of points, parameters without width, that knows many digits of the forces at floats."""

    def prepared(self, bounds: Intervals) -> Intervals:
        """The arguments, and the parameters themselves behind them."""
        arguments = super().prepared(bounds)
        return Intervals(np.concatenate([arguments.ends, bounds.ends], axis=1))

    def at_points(self, middles: FloatArray, parameters: Intervals) -> Intervals:
        """Forces at floats, shape (n, N)."""
        given = parameters.ends[1, len(self.codes) :]
        out = np.empty((2, *middles.shape))
        for column in range(middles.shape[1]):
            out[:, :, column] = self._at_point(tuple(middles[:, column]), tuple(given[:, column]))
        return Intervals(out)

    def _at_point(self, state: tuple[float, ...], given: tuple[float, ...]) -> FloatArray:
        if not np.isfinite(state).all():
            return np.full((2, self.n), np.nan)
        values = self._balls(given)
        q = [ball(value) for value in state]
        try:
            rows = undecorated(self.model.statics.geometry)(*q, *self._listed(values, "statics"), xp=XP)
            directions: list[Any] = []
            for dx, dy, _ in rows:
                length = XP.sqrt(dx * dx + dy * dy)
                directions += [dx / length, dy / length, length]
            return np.array([as_ends(force) for force in self.call("forces", q, directions, values, XP)]).T
        except Undecided:
            return np.full((2, self.n), np.nan)

    def _balls(self, given: tuple[float, ...]) -> dict[str, Any]:
        """The arguments by name, of parameters that are floats."""
        return _arguments(tuple(self.parameters), tuple((name, *pair) for name, pair in sorted(self.angles.items())), given)


@lru_cache(maxsize=256)
def _arguments(names: tuple[str, ...], angles: tuple[tuple[str, ...], ...], given: tuple[float, ...]) -> dict[str, Any]:
    pairs = {name: (cosine, sine) for name, cosine, sine in angles}
    values: dict[str, Any] = {}
    for name, number in zip(names, given, strict=True):
        value = ball(number)
        if name in pairs:
            values |= zip(pairs[name], Balls().cos_sin(value), strict=True)
        else:
            values[name] = value
    return values


def ball(value: float) -> Ball:
    """A float, exactly."""
    numerator, denominator = float(value).as_integer_ratio()
    return Ball(numerator, 0, 1 - denominator.bit_length(), BITS)
