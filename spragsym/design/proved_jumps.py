"""Points of a box of parameters at which the followed state has ended, told by parts of the box of
which that is proved: thousands of points at once.

Tubes hold the state that is taken up in the middle of the box, and what it becomes over the box. In
a room about it there is no other, so that the reference state of a point is that state if it lies
there; where that is not proved of all points of a part, it is looked for at each. Where nothing but
the loading varies one jump value tells all.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..models.parameters import ParameterSet
from ..numerics.columns import selected_rows
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals, scale_of
from ..statics.balance import Balance
from ..statics.equilibria import equilibria
from ..statics.reference_state import is_reference, reference_state
from ..statics.regions import region
from ..statics.search import balances_of
from .jumps import Followed, first_limit_points
from .tube_certificates import Pieces, Splitting


@dataclass(frozen=True)
class ProvedJumps:
    """Parts of a box, and the parameters that vary in it beside the loading ``vary``, which rises
    from ``begin``: up to ``safe`` the state of each part goes on, and above ``top`` it has ended.

    Of parts that are ``known`` it is the reference state of all their points.
    """

    vary: str
    begin: float
    free: tuple[str, ...]
    pieces: Pieces
    known: BoolArray
    touching: str  #: contacts that touch in the state of the parts, of several

    def ended(self, p: ParameterSet) -> FloatArray:
        """1 where the state of a point has ended, 0 where it has not, NaN where no part tells it;
        parameters of shape (M,).
        """
        pieces, (count,) = self.pieces, p.shape
        loading, *free = (np.broadcast_to(p[name], count) for name in (self.vary, *self.free))
        part = self._parts(free) if free else np.zeros(count, dtype=int)
        proved = (part >= 0) & self.known[part] & (p.followed is None)
        given = {name: np.broadcast_to(p[name], count) for name in p.ranges if p[name] is not None}
        asked = np.flatnonzero((part >= 0) & ~proved)
        if asked.size:
            there, room = self._there(free, part, asked)
            states, error = self._reference_states(p.replace(**selected_rows(given, asked)))
            part[asked[~(np.abs(states - there) + error <= room).all(axis=0)]] = -1
        below, above = loading <= pieces.safe[part], loading > pieces.top[part]
        out = np.where(part < 0, np.nan, np.where(above, 1.0, np.where(below, 0.0, np.nan)))
        left = np.flatnonzero(proved & np.isnan(out))
        if left.size and free:
            begin = np.full(left.size, self.begin)
            until = np.maximum(begin, loading[left])
            of = p.replace(**selected_rows(given, left))
            followed = Followed(of, self.vary, "up", begin, until)
            out[left] = followed.have_ended(of_state=self._there(free, part, left))
        return out

    def _there(
        self, free: Sequence[FloatArray], part: IntArray, rows: IntArray
    ) -> tuple[FloatArray, FloatArray]:
        """About the states of some points where the loading begins, by their parts, and the room
        about each in which there is no other; shape (n, M). There is none where that is not proved.
        """
        off = np.stack(free)[:, rows] - 0.5 * self.pieces.of.sum(axis=0)[:, part[rows]]
        base = self.pieces.base[part[rows]]
        there = base.z[:-1] + np.einsum("ikM,kM->iM", base.by_p[:-1], off)
        return there, np.where(base.sure, base.radius[:-1], -1.0)

    def _parts(self, free: Sequence[FloatArray]) -> IntArray:
        """Number of the part that each point lies in, −1 where it lies in none."""
        low, high = self.pieces.low, self.pieces.high
        part, order = np.full(free[0].size, -1), np.argsort(free[0])
        begin = np.searchsorted(free[0][order], low[0], "left")
        end = np.searchsorted(free[0][order], high[0], "right")
        for k in range(len(self.pieces)):
            rows = order[begin[k] : end[k]]
            for one, least, most in zip(free[1:], low[1:-1, k], high[1:-1, k], strict=True):
                rows = rows[(least <= one[rows]) & (one[rows] <= most)]
            part[rows] = k
        return part

    def _reference_states(self, p: ParameterSet) -> tuple[FloatArray, FloatArray]:
        """Coordinates of the states that are followed, where the loading begins, with bounds on
        their errors, infinite where they are not known; shape (n, M).
        """
        eq = equilibria(p.replace(**{self.vary: self.begin}))
        rows, slot = np.arange(p.shape[0]), reference_state(eq, p.followed)
        states = np.array([column[rows, slot] for column in eq.coordinates.values()])
        decided = eq.decided & np.isfinite(states).all(axis=0)
        if p.model.has_regimes:
            decided &= eq.touching[rows, slot] == self.touching
        error = np.where(decided, eq.error[rows, slot] * scale_of(states).max(axis=0), np.inf)
        return np.where(decided, states, 0.0), np.broadcast_to(error, states.shape)


def proved_jumps(box: Splitting, share: Callable[[Any], FloatArray], most: int) -> ProvedJumps:
    """Proved parts of a box, of which those are halved first of which most is open by ``share``."""
    if not box.free:
        found = first_limit_points(box.point(box.whole.high[:, 0]), box.vary, begin=box.begin)
        if not found.reasons:  # else nothing is known
            ends = bool(np.isfinite(found.value))
            box.whole.safe[:] = found.value - found.error if ends else found.until
            box.whole.top[:] = found.value + found.error if ends else np.inf
        return ProvedJumps(box.vary, box.begin, (), box.whole, np.ones(1, dtype=bool), "")
    # Of the whole box hardly anything is proved.
    box.whole = box.whole.divided(box.whole.weight(box.whole.base), most)
    box.sharp = True
    first, *others = [pieces[last] for pieces, last, _ in box.run(share, most)]
    pieces = first.concatenated(*others)
    return ProvedJumps(
        box.vary, box.begin, box.free, pieces, _known(box, pieces), box.balance.touching
    )


def _known(box: Splitting, pieces: Pieces) -> BoolArray:
    """Parts at all points of which the reference state is proved to be that of their tubes."""
    # Of several combinations of contacts it is to be the reference state of the states of all.
    if box.near is not None or len(balances_of(box.model)) > 1:
        return np.zeros(len(pieces), dtype=bool)
    balance, low = Balance(box.model), np.repeat(box.tubes.fixed, len(pieces), axis=1)
    high = low.copy()
    low[box.rows[:-1]], high[box.rows[:-1]] = pieces.low[:-1], pieces.high[:-1]
    low[box.rows[-1]] = high[box.rows[-1]] = box.begin
    bounds = Intervals.between(low, high)
    searched, whole = region(balance, bounds)
    held = pieces.base.box().ends[:, :-1]
    found = is_reference(balance, bounds, held, searched)
    return found & whole & pieces.base.sure
