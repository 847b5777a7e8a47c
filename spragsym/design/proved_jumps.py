"""Points of a box of parameters at which the followed state has ended, decided by proved parts of
the box: thousands of points at once.

Tubes hold the reference state at the middle of the box, and what it becomes over the box. Within a
radius about it there is no other state, so the reference state of a point is that of the tube if it
lies there. For parts where this is proved for all points, nothing is computed at a point; elsewhere
the reference state is computed at each. If only the loading parameter varies, one jump value
decides all points.
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
    """Proved parts of a box, for the loading parameter ``vary``, which rises from ``begin``.

    ``free`` are the other parameters that vary. For each part of ``pieces`` the state is proved to
    exist up to ``safe`` and to have ended above ``top``. Where a part is ``known``, that state is
    proved to be the reference state of all points.
    """

    vary: str
    begin: float
    free: tuple[str, ...]
    pieces: Pieces
    known: BoolArray
    touching: str  #: touching contacts in the state of the parts, if there are several

    def ended(self, p: ParameterSet) -> FloatArray:
        """1 where the state of a point has ended, 0 where it has not, NaN where no part decides;
        parameters of shape (M,).
        """
        pieces, (count,) = self.pieces, p.shape
        loading, *free = (np.broadcast_to(p[name], count) for name in (self.vary, *self.free))
        part = self._parts(free) if free else np.zeros(count, dtype=int)
        nothing = (pieces.safe <= self.begin) & np.isinf(pieces.top)
        part[nothing[part]] = -1
        proved = (part >= 0) & self.known[part] & (p.followed is None)
        given = {name: np.broadcast_to(p[name], count) for name in p.ranges if p[name] is not None}
        unknown = np.flatnonzero((part >= 0) & ~proved)
        if unknown.size:
            predicted, radius = self._there(free, part, unknown)
            states, error = self._reference_states(p.replace(**selected_rows(given, unknown)))
            same = (np.abs(states - predicted) + error <= radius).all(axis=0)
            part[unknown[~same]] = -1
        below, above = loading <= pieces.safe[part], loading > pieces.top[part]
        out = np.select([part < 0, above, below], [np.nan, 1.0, 0.0], np.nan)
        open_ = np.flatnonzero(proved & np.isnan(out))
        if open_.size and free:
            begin = np.full(open_.size, self.begin)
            until = np.maximum(begin, loading[open_])
            own = p.replace(**selected_rows(given, open_))
            followed = Followed(own, self.vary, "up", begin, until)
            out[open_] = followed.have_ended(of_state=self._there(free, part, open_))
        return out

    def _there(
        self, free: Sequence[FloatArray], part: IntArray, rows: IntArray
    ) -> tuple[FloatArray, FloatArray]:
        """Approximate states of points where the loading begins, from their parts, and the radius
        within which each is the only one; both of shape (n, M). The radius is −1 where that is not
        proved.
        """
        off = np.stack(free)[:, rows] - 0.5 * self.pieces.of.sum(axis=0)[:, part[rows]]
        base = self.pieces.base[part[rows]]
        states = base.z[:-1] + np.einsum("ikM,kM->iM", base.by_p[:-1], off)
        return states, np.where(base.proved, base.radius[:-1], -1.0)

    def _parts(self, free: Sequence[FloatArray]) -> IntArray:
        """Index of the part that holds each point, −1 for none."""
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
        """Coordinates of the followed states where the loading begins, with error bounds, shape (n,
        M).

        The bound is infinite where a state is not known.
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
    """Proved parts of a box; those with the largest open ``share`` are halved first, up to ``most``
    parts.
    """
    if not box.free:
        found = first_limit_points(box.point(box.whole.high[:, 0]), box.vary, begin=box.begin)
        if not found.reasons:  # otherwise nothing is proved
            ends = bool(np.isfinite(found.value))
            box.whole.safe[:] = found.value - found.error if ends else found.until
            box.whole.top[:] = found.value + found.error if ends else np.inf
        return ProvedJumps(box.vary, box.begin, (), box.whole, np.ones(1, dtype=bool), "")
    # Hardly anything can be proved for the whole box at once.
    box.whole = box.whole.divided(box.whole.weight(box.whole.base), most)
    box.sharp = True
    first, *others = [pieces[last] for pieces, last, _ in box.run(share, most)]
    pieces = first.concatenated(*others)
    return ProvedJumps(
        box.vary, box.begin, box.free, pieces, _known(box, pieces), box.balance.touching
    )


def _known(box: Splitting, pieces: Pieces) -> BoolArray:
    """Parts whose tubes are proved to hold the reference state of all their points."""
    # With several combinations of contacts, the reference state is chosen among those of all.
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
    return found & whole & pieces.base.proved
