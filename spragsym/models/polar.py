"""Equilibria around a spring's anchor, in polar coordinates of that spring: its angle θ and its length l.

A stiff spring with little else to hold the mass has near-equilibria on the whole circle of its undeformed length. Boxes of x
and y that cover the circle in small pieces do not tell the few equilibria on it. In θ and l the circle is straight: the balance
along the spring gives l, and one equation in θ is left. At the anchor itself, where x and y do not say the direction, θ does.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..exact import boxes, certified_roots, contractors, jets
from ..exact.certified_roots import Roots
from ..exact.interval_arrays import FloatArray, Intervals, raised, stacked
from ..exact.interval_functions import cos, sin
from .balance import Balance, matrix, undecorated
from .laws import XP
from .precise import replaced

#: Width of boxes that are left where a search gives up along a circle; those around a fold are narrower.
WIDE = 2.0**-10
#: The angles that are searched, more than once around, so that no root lies on their border.
AROUND = 3.3
#: Half-width of the box of x and y in which a root is proved to be the only one, over its size.
ALONE = 2.0**-20


#: Coordinates, directions, arguments of generated functions, shape.
_State: TypeAlias = tuple[list[Any], list[Any], dict[str, Any], tuple[int, ...]]


@dataclass(frozen=True)
class _Polar(boxes.Plain):
    """The balance with θ and l of a spring in place of the coordinates of its end; others follow."""

    balance: Balance
    spring: int
    chart: tuple[int, int]

    def prepared(self, bounds: Intervals) -> Intervals:
        """As for the balance."""
        return self.balance.prepared(bounds)

    def state(
        self, unknowns: Sequence[Any], parameters: Intervals
    ) -> tuple[list[Any], list[Any], dict[str, Any], tuple[int, ...]]:
        """Coordinates, directions, arguments and shape."""
        shape = parameters.shape[1:]
        values = self.balance.arguments(parameters)
        angle, length, *others = unknowns
        turned = isinstance(angle, jets.Jet)
        c, s = (angle.cos(), angle.sin()) if turned else (cos(angle), sin(angle))
        q: list[Any] = [0] * self.balance.n
        for place, value in zip((i for i in range(self.balance.n) if i not in self.chart), others, strict=True):
            q[place] = value
        given = [values[name] for name in self.balance.model.about["arguments"]["statics"]]
        anchor = undecorated(self.balance.model.statics.geometry)(*q, *given, xp=XP)[self.spring][:2]
        for place, end, part in zip(self.chart, anchor, (c, s), strict=True):
            q[place] = -(length * part) + end
        directions = self.balance.directions(q, values, shape)
        directions[3 * self.spring : 3 * self.spring + 3] = [c, s, length]
        return q, directions, values, shape

    def residuals(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Forces over boxes of θ and l."""
        q, directions, values, shape = self.state(list(unknowns), parameters)
        return stacked(self.balance.call("forces", q, directions, values), shape)

    def jacobian(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Their slopes by θ, l and the other coordinates."""
        q, directions, values, shape = self.state(jets.variables(list(unknowns), 1), parameters)
        rows = self.balance.call("forces", q, directions, values)
        return matrix([jets.gradient(row, self.balance.n) for row in rows], shape)

    def hopeless(self, unknowns: Intervals, parameters: Intervals) -> NDArray[np.bool_]:
        """Boxes beyond the contact's border, or where no direction of another spring balances the forces."""
        q, _, values, shape = self.state(list(unknowns), parameters)
        return self.balance.beyond_border(q, values, shape)

    def cartesian(self, ends: FloatArray, parameters: Intervals) -> FloatArray:
        """Boxes that hold the coordinates."""
        q = self.state(list(Intervals(ends)), parameters)[0]
        return stacked(q, ends.shape[2:]).ends


def around_anchors(balance: Balance, given: FloatArray, regions: FloatArray, found: Roots, wider: float = WIDE) -> Roots:
    """What a search has left along circles around anchors, decided in polar coordinates where that succeeds.

    Parameters
    ----------
    given : ndarray
        Parameters, shape (parameters, points).
    regions : ndarray
        Shape (2, n, points) or (2, n, 1).
    wider : float
        Width of a box that is left from which on a point is looked at.
    """
    if not balance.model.about["contact"].get("polynomial") and balance.contact:
        return found  # a law that is asked for on its own side only
    wide = (found.left[0] + found.left[1]).max(axis=0, initial=0.0) > wider
    around = np.broadcast_to(regions, (*regions.shape[:2], given.shape[1]))
    for point in np.unique(found.left_point[wide]):
        for number, spring in enumerate(balance.model.about["springs"]):
            if spring["chart"] is None:
                continue
            chart = tuple(balance.coordinates.index(name) for name in spring["chart"])
            again = _searched(_Polar(balance, number, (chart[0], chart[1])), given[:, [point]], around[:, :, [point]])
            if again is not None:
                found = replaced(found, np.array([point]), again)
                break
    return found


def _searched(system: _Polar, given: FloatArray, region: FloatArray) -> Roots | None:
    """All roots of a point, each alone in a box of coordinates; None where not all is decided."""
    balance = system.balance
    with np.errstate(all="ignore"):
        parameters = system.prepared(Intervals.point(given))
        others = [i for i in range(balance.n) if i not in system.chart]
        none = np.zeros((2, 2, 1))
        anchor = system.cartesian(np.concatenate([none, region[:, others]], axis=1), parameters)
        reach = np.maximum(*raised(region + anchor[::-1]))[list(system.chart), 0]
        sides = [[AROUND, AROUND], [0.0, float(raised(np.hypot(*reach), 4))], *(region[:, i, 0].tolist() for i in others)]
        polar = np.array(sides).T[:, :, None]
        outcome = boxes.search(system, polar, given, given)
        roots = certified_roots.roots(system, outcome, polar, given, given)
        if roots.left.shape[2]:
            return None
        columns = system.prepared(Intervals.point(np.repeat(given, roots.point.size, axis=1)))
        ends = system.cartesian(roots.ends, columns)
        ends = ends[:, :, ~contractors.apart(ends, region)]
        columns = balance.prepared(Intervals.point(np.repeat(given, ends.shape[2], axis=1)))
        wide = ends + ALONE * np.maximum(1.0, np.abs(ends).max(axis=0))
        middle = Intervals(ends).middle
        step = contractors.newton(
            balance.at_points(middle, columns),
            balance.jacobian(Intervals(wide), columns),
            middle,
            np.maximum(*raised(wide + np.stack([middle, -middle]))),
        )
    if not contractors.inside(step.ends, wide).all():
        return None
    ends = np.fmin(step.ends, ends)
    order = np.argsort(-wide[0, 0])
    ends, wide = ends[:, :, order], wide[:, :, order]
    keep, unclear = certified_roots.once(ends, wide, np.zeros(order.size, dtype=np.int64))
    if unclear.size or not contractors.within(ends[:, :, keep], region).all():
        return None
    nothing = np.empty((2, balance.n, 0)), np.empty(0, dtype=np.int64)
    return Roots(ends[:, :, keep], wide[:, :, keep], np.zeros(keep.size, dtype=np.int64), *nothing)
