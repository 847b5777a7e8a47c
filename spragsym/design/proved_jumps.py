"""Points of a box of parameters at which the followed state has ended, told by parts of the box of
which that is proved: thousands of points at once.

Tubes hold the state that is taken up in the middle of the box, and what it becomes over the box. In
a room about it there is no other, so that the reference state of a point, which is looked for at
each, is that state if it lies there. Where nothing but the loading varies one jump value tells all.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..models.parameters import ParameterSet
from ..numerics.interval_arrays import FloatArray, scale_of
from ..statics.equilibria import equilibria
from ..statics.reference_state import reference_state
from .jumps import first_ends
from .tube_certificates import Pieces, Splitting


@dataclass(frozen=True)
class ProvedJumps:
    """Parts of a box, and the parameters that vary in it beside the loading ``vary``, which rises
    from ``begin``: up to ``safe`` the state of each part goes on, and above ``top`` it has ended.
    """

    vary: str
    begin: float
    free: tuple[str, ...]
    pieces: Pieces

    def ended(self, p: ParameterSet) -> FloatArray:
        """1 where the state of a point has ended, 0 where it has not, NaN where no part tells it;
        parameters of shape (M,).
        """
        pieces, (count,) = self.pieces, p.shape
        loading, *free = (np.broadcast_to(p[name], count) for name in (self.vary, *self.free))
        states, error = self._reference_states(p) if free else (np.zeros((0, count)),) * 2
        found = np.full(count, np.nan)
        for k in range(len(pieces)):
            rows = np.arange(count)
            for one, low, high in zip(free, pieces.low[:, k], pieces.high[:, k], strict=False):
                rows = rows[(low <= one[rows]) & (one[rows] <= high)]
            if free:
                base, middle = pieces.base[[k]], 0.5 * pieces.of.sum(axis=0)[:, [k]]
                off = np.stack([one[rows] for one in free]) - middle
                there = base.z[:-1] + np.einsum("ik,kM->iM", base.by_p[:-1, :, 0], off)
                away = np.abs(states[:, rows] - there) + error[:, rows]
                rows = rows[base.sure & (away <= base.room[:-1]).all(axis=0)]
            found[rows[loading[rows] <= pieces.safe[k]]] = 0.0
            found[rows[loading[rows] > pieces.top[k]]] = 1.0
        return found

    def _reference_states(self, p: ParameterSet) -> tuple[FloatArray, FloatArray]:
        """Coordinates of the states that are followed, where the loading begins, with bounds on
        their errors, infinite where they are not known; shape (n, M).
        """
        eq = equilibria(p.replace(**{self.vary: self.begin}))
        rows, slot = np.arange(p.shape[0]), reference_state(eq, p.followed)
        states = np.array([column[rows, slot] for column in eq.coordinates.values()])
        known = eq.decided & np.isfinite(states).all(axis=0)
        error = np.where(known, eq.error[rows, slot] * scale_of(states).max(axis=0), np.inf)
        return np.where(known, states, 0.0), np.broadcast_to(error, states.shape)


def proved_jumps(box: Splitting, share: Callable[[Any], FloatArray], most: int) -> ProvedJumps:
    """Proved parts of a box, of which those are halved first of which most is open by ``share``."""
    if not box.free:
        found = first_ends(box.point(box.whole.high[:, 0]), box.vary, begin=box.begin)
        ends = bool(np.isfinite(found.value))
        box.whole.safe[:] = found.value - found.error if ends else found.until
        box.whole.top[:] = found.value + found.error if ends else np.inf
        return ProvedJumps(box.vary, box.begin, (), box.whole)
    box.sharp = True
    first, *others = [pieces[last] for pieces, last, _ in box.run(share, most)]
    return ProvedJumps(box.vary, box.begin, box.free, first.concatenated(*others))
