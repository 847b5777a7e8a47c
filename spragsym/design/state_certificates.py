"""Certificates over boxes of parameters about all states in contact of any model: that there is one, that none flutters.

A box of parameters is searched for equilibria as one point is, see :mod:`spragsym.numerics.boxes`: a box of coordinates in which
interval Newton proves one root holds one for every point of it. What a claim asks is decided over these boxes, and over those
that are left. A part of the box that stays open is halved across the parameter that moves the states most; its states lie where
those of the whole do.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np

from ..bifurcation.tubes.tube_regions import Flags
from ..models.parameters import ParameterSet
from ..numerics import boxes, certified_roots
from ..numerics.certified_roots import Roots
from ..numerics.interval_arrays import FloatArray, Intervals, raised
from ..results.equilibria import Equilibria, Stability
from ..statics import spectrum
from ..statics.equilibria import equilibria
from ..statics.mechanics.balance import Balance
from ..statics.mechanics.border import on_side, once_around
from ..statics.regions import region
from .certificates import Claim, Held, corner_values

#: Boxes of coordinates of one part: what needs more is halved sooner.
BUDGET = 600
#: Relative width of boxes of coordinates that are not halved any more.
NARROW = 2.0**-20
#: What the relative width of a side counts beside its effect on the states.
SLIGHT = 1e-6
#: Room around the states of a part where those of its halves are looked for.
ROOM = 1e-6


@dataclass(frozen=True)
class Found:
    """States of some parts: ``roots`` have their parts as points, with those alone that are in contact all over them.

    ``open`` are the parts with states that are not known to be in contact or not, and with boxes that are left.
    """

    bounds: Intervals
    roots: Roots
    open: Flags


Test: TypeAlias = Callable[[Balance, Found], Flags]


def _one(balance: Balance, found: Found) -> Flags:
    """Parts with one state at each point."""
    return np.asarray((np.bincount(found.roots.point, minlength=found.open.size) == 1) & ~found.open)


def _none_flutters(balance: Balance, found: Found) -> Flags:
    """Parts all of whose states have real κ only, those in boxes that are left included."""
    roots = found.roots
    every = np.concatenate([roots.ends, roots.left], axis=2)
    point = np.concatenate([roots.point, roots.left_point])
    real = spectrum.real(balance, balance.prepared(found.bounds[:, point]), every)
    return np.asarray(np.bincount(point[~real], minlength=found.open.size) == 0)


def _not_one(eq: Equilibria) -> Flags:
    """Points at which there are several, or proved to be none."""
    return np.asarray((eq.count > 1) | ((eq.count == 0) & eq.decided & eq.whole))


def _flutters(eq: Equilibria) -> Flags:
    """Points at which a state is proved to flutter."""
    return np.asarray(((eq.stability == Stability.FLUTTER) & ~eq.marginal).any(axis=-1))


#: For each claim where it holds, and at which points it is refuted.
STATES: dict[str, tuple[Test, Callable[[Equilibria], Flags]]] = {
    "one equilibrium": (_one, _not_one),
    "no flutter": (_none_flutters, _flutters),
}


@dataclass(frozen=True)
class Parts(Held):
    """Parts, and where their states are: ``around``, shape (2, n, N), is infinite where nothing is known of that."""

    around: FloatArray


class ClaimOfStates(Claim):
    """One of the claims of :data:`STATES`."""

    def __init__(self, low: Any, high: Any, claim: str) -> None:
        self.model = low.model
        self.balance = Balance(self.model, contact=True)
        self.sides = tuple(self.balance.parameters)
        self.true, self.false = STATES[claim]
        ends = corner_values(self.sides, low, high)
        nowhere = np.full((2, self.balance.n, 1), np.inf)
        never = claim == "no flutter" and self._without_flutter(*ends)
        self.whole = Parts(ends[0][:, None], ends[1][:, None], np.array([never]), nowhere)

    def _without_flutter(self, low: FloatArray, high: FloatArray) -> bool:
        """Whether no state of the box can flutter, wherever it is."""
        bounds = self.balance.prepared(Intervals.between(low[:, None], high[:, None]))
        return bool(spectrum.without_flutter(self.balance, bounds).all())

    def point(self, values: FloatArray) -> ParameterSet:
        return self.model.Parameters(**dict(zip(self.sides, values, strict=True)))

    def refuted(self, points: FloatArray) -> ParameterSet | None:
        fails = np.flatnonzero(self.false(equilibria(self.point(points))))
        return self.point(points[:, fails[0]].tolist()) if fails.size else None

    def settled(self, parts: Parts, sharp: bool = False) -> tuple[Parts, FloatArray]:
        if parts.holds.all():
            return parts, parts.low
        balance, bounds = self.balance, Intervals.between(parts.low, parts.high)
        around: FloatArray = parts.around
        whole = np.asarray(np.isfinite(around).all(axis=(0, 1)))
        new = np.flatnonzero(~whole)
        if new.size:
            around = around.copy()
            around[:, :, new], whole[new] = region(balance, bounds[:, new])
        found = once_around(
            balance,
            certified_roots.search(balance, around, parts.low, parts.high, limits=balance.limits, budget=BUDGET, narrow=NARROW),
        )
        ends, point = np.concatenate([found.ends, found.left], axis=2), np.concatenate([found.point, found.left_point])
        in_contact, beyond = on_side(balance, balance.prepared(bounds[:, point]), ends)
        proved = np.arange(point.size) < found.point.size
        kept, left = proved & in_contact, ~beyond & ~(proved & in_contact)
        states = Roots(ends[:, :, kept], ends[:, :, kept], point[kept], ends[:, :, left], point[left])
        open_ = np.bincount(states.left_point, minlength=whole.size) > 0
        where = np.full(around.shape, -np.inf)
        for box, row in zip(np.moveaxis(ends[:, :, ~beyond], 2, 0), point[~beyond], strict=True):
            where[:, :, row] = np.maximum(where[:, :, row], box)
        room = ROOM + boxes.MARGIN * np.maximum(where[0] + where[1], 0.0)
        where = np.where(whole, np.fmin(raised(where + room), around), np.inf)
        with np.errstate(all="ignore"):
            holds = whole & self.true(balance, Found(bounds, states, open_))
        return replace(parts, holds=holds, around=where), self._weights(parts, states)

    def _weights(self, parts: Parts, states: Roots) -> FloatArray:
        """By how far each parameter moves the states of each part, shape (P, N)."""
        balance, middle = self.balance, 0.5 * (parts.low + parts.high)
        width = parts.high - parts.low
        out = SLIGHT * width / np.maximum(np.abs(parts.high) + np.abs(parts.low), 1e-300)
        q = np.concatenate([states.middle, Intervals(states.left).middle], axis=1)
        point = np.concatenate([states.point, states.left_point])
        with np.errstate(all="ignore"):
            K = balance.jacobian(Intervals.point(q), balance.prepared(Intervals.point(middle[:, point]))).middle
            back = np.abs(np.linalg.pinv(np.nan_to_num(np.moveaxis(K, -1, 0))))
            for row in np.flatnonzero(width.any(axis=1)):
                low, high = middle[:, point], middle[:, point]
                low[row], high[row] = parts.low[row, point], parts.high[row, point]
                pushed = balance.residuals(Intervals.point(q), balance.prepared(Intervals.between(low, high))).width
                moved = np.einsum("Nij,jN->iN", back, pushed) / np.maximum(1.0, np.abs(q))
                np.maximum.at(out[row], point, np.nan_to_num(moved).max(axis=0))
        return np.asarray(out)
