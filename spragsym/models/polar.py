"""Equilibria around a spring's anchor, in its angle θ and its elongation, which for a stiff spring is its tension.

A stiff spring with little else to hold the mass has near-equilibria on the whole circle of its undeformed length. Boxes of x
and y that cover the circle in small pieces do not tell the few equilibria on it. In θ and the tension T = k (l − r) the circle is
straight, and no difference of large forces is left: the spring adds T (c ∂dx + s ∂dy) to the balance of all else, the balance
along the spring gives T, and one equation in θ remains, however stiff the spring. At the anchor itself, where x and y do not say
the direction, θ does.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
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
#: Once around, outside of it.
TURN = Intervals.between(np.array(2 * np.pi - 1e-15), np.array(2 * np.pi + 1e-15))
#: By what the tension may be larger than it can be, so that none lies on the border of the region.
ROOM = 1.0 + 2.0**-10
#: Stiffness over that of the contact from which on a point is looked at in polar coordinates first.
STIFF = 3e3


#: Coordinates, directions, arguments of generated functions, shape, tension.
_State: TypeAlias = tuple[list[Any], list[Any], dict[str, Any], tuple[int, ...], Any]


@dataclass(frozen=True)
class _Polar(boxes.Plain):
    """The balance with θ and the elongation of a spring in place of the coordinates of its end; others follow.

    The elongation is measured in its unit, or where a force of 1 stretches the spring by less, by that force.
    """

    balance: Balance
    spring: int
    chart: tuple[int, int]

    def prepared(self, bounds: Intervals) -> Intervals:
        """As for the balance."""
        return self.balance.prepared(bounds)

    def state(self, unknowns: Sequence[Any], parameters: Intervals) -> _State:
        """Coordinates, directions, arguments, shape, and tension."""
        shape = parameters.shape[1:]
        values = self.balance.arguments(parameters)
        angle, elongation, *others = unknowns
        turned = isinstance(angle, jets.Jet)
        c, s = (angle.cos(), angle.sin()) if turned else (cos(angle), sin(angle))
        q: list[Any] = [0] * self.balance.n
        for place, value in zip((i for i in range(self.balance.n) if i not in self.chart), others, strict=True):
            q[place] = value
        *anchor, rest = undecorated(self.balance.model.statics.geometry)(*q, *self.given(values), xp=XP)[self.spring]
        stiffness = self.stiffness(values, shape)
        unit = Intervals.point(np.maximum(1.0, stiffness.high))
        length = elongation * (1 / unit) + rest
        for place, end, part in zip(self.chart, anchor, (c, s), strict=True):
            q[place] = -(length * part) + end
        directions = self.balance.directions(q, values, shape)
        directions[3 * self.spring : 3 * self.spring + 3] = [c, s, length]
        return q, directions, values, shape, elongation * (stiffness / unit)

    def given(self, values: Mapping[str, Any]) -> list[Any]:
        """Arguments of functions of a place."""
        return _arguments_of_a_place(self.balance, values)

    def stiffness(self, values: Mapping[str, Any], shape: tuple[int, ...]) -> Intervals:
        """Of this spring."""
        return _stiffnesses(self.balance, values, shape)[self.spring]

    def _rows(self, unknowns: Sequence[Any], parameters: Intervals) -> tuple[list[Any], tuple[int, ...]]:
        """The balance over boxes of unknowns."""
        q, directions, values, shape, tension = self.state(unknowns, parameters)
        return self.rows(q, directions, values, tension), shape

    def rows(self, q: Sequence[Any], directions: Sequence[Any], values: Mapping[str, Any], tension: Any) -> list[Any]:
        """The balance in a state with a tension of this spring."""
        balance = self.balance
        rows = list(balance.call("forces_apart", q, directions, values))
        statics = balance.model.statics
        stiffnesses = undecorated(statics.stiffnesses)(*q, *self.given(values), xp=XP)
        rests = [row[2] for row in undecorated(statics.geometry)(*q, *self.given(values), xp=XP)]
        slopes = end_slopes(balance, self.given(values), Intervals.point(np.zeros(1)))
        for place, (k, rest, (along, across)) in enumerate(zip(stiffnesses, rests, slopes, strict=True)):
            c, s, length = directions[3 * place : 3 * place + 3]
            pull = tension if place == self.spring else (length - rest) * k
            for row in range(balance.n):
                rows[row] = rows[row] + pull * (c * along[row] + s * across[row])
        return rows

    def residuals(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Forces over boxes of θ and tension."""
        rows, shape = self._rows(list(unknowns), parameters)
        return stacked(rows, shape)

    def jacobian(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Their slopes by θ, tension and the other coordinates."""
        rows, shape = self._rows(jets.variables(list(unknowns), 1), parameters)
        return matrix([jets.gradient(row, self.balance.n) for row in rows], shape)

    def hopeless(self, unknowns: Intervals, parameters: Intervals) -> NDArray[np.bool_]:
        """Boxes beyond the contact's border, or where no direction of another spring balances the forces."""
        q, _, values, shape, _ = self.state(list(unknowns), parameters)
        return self.balance.beyond_border(q, values, shape)

    def cartesian(self, ends: FloatArray, parameters: Intervals) -> FloatArray:
        """Boxes that hold the coordinates."""
        q = self.state(list(Intervals(ends)), parameters)[0]
        return stacked(q, ends.shape[2:]).ends


def _arguments_of_a_place(balance: Balance, values: Mapping[str, Any]) -> list[Any]:
    return [values[name] for name in balance.model.about["arguments"]["statics"]]


def _stiffnesses(balance: Balance, values: Mapping[str, Any], shape: tuple[int, ...]) -> Intervals:
    """Of all springs: they depend on no place."""
    none = [0] * balance.n
    return stacked(undecorated(balance.model.statics.stiffnesses)(*none, *_arguments_of_a_place(balance, values), xp=XP), shape)


def end_slopes(balance: Balance, given: Sequence[Any], near: Intervals) -> list[tuple[list[Any], list[Any]]]:
    """How the vector of every spring changes with the coordinates: for ends that are linear in them the same everywhere."""
    place = jets.variables([near] * balance.n, 1)
    rows = undecorated(balance.model.statics.geometry)(*place, *given, xp=XP)
    return [(jets.gradient(dx, balance.n), jets.gradient(dy, balance.n)) for dx, dy, _ in rows]


def _ends_are_linear(balance: Balance, given: FloatArray) -> bool:
    """Whether the ends of all springs are linear in the coordinates."""
    values = balance.arguments(balance.prepared(Intervals.point(given)))
    slopes = end_slopes(balance, _arguments_of_a_place(balance, values), Intervals.between(np.array([-2.0]), np.array([3.0])))
    every = [entry for pair in slopes for row in pair for entry in row]
    return bool((stacked(every, (1,)).width < 1e-12).all()) if every else True


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
        again = _of_any_spring(balance, given[:, [point]], around[:, :, [point]])
        if again is not None:
            found = replaced(found, np.array([point]), again)
    return found


def stiff_points(balance: Balance, given: FloatArray, regions: FloatArray) -> tuple[Roots, NDArray[np.bool_]]:
    """Roots of points with a stiff spring, and which points these are that are decided."""
    n, count = balance.n, given.shape[1]
    around = np.broadcast_to(regions, (*regions.shape[:2], count))
    done = np.zeros(count, dtype=np.bool_)
    parts: list[Roots] = []
    if not hasattr(balance.model.statics, "stiffnesses"):
        return certified_roots.concatenated(parts, n), done
    values = balance.arguments(balance.prepared(Intervals.point(given)))
    stiff = _stiffnesses(balance, values, (count,)).high.max(axis=0, initial=0.0) > STIFF
    for point in np.flatnonzero(stiff):
        again = _of_any_spring(balance, given[:, [point]], around[:, :, [point]])
        if again is not None:
            done[point] = True
            parts.append(replace(again, point=np.full(again.point.size, point)))
    return certified_roots.concatenated(parts, n), done


def _of_any_spring(balance: Balance, given: FloatArray, region: FloatArray) -> Roots | None:
    """Roots of one point by the first spring around which all is decided."""
    # A folder that was derived before has no forces without springs.
    if not hasattr(balance.model.statics, "forces_apart") or balance.torsions or not _ends_are_linear(balance, given):
        return None
    for number, spring in enumerate(balance.model.about["springs"]):
        if spring["chart"] is None:
            continue
        chart = tuple(balance.coordinates.index(name) for name in spring["chart"])
        again = _searched(_Polar(balance, number, (chart[0], chart[1])), given, region)
        if again is not None:
            return again
    return None


def _searched(system: _Polar, given: FloatArray, region: FloatArray) -> Roots | None:
    """All roots of a point, each in a box of coordinates apart from the others; None where not all is decided."""
    balance = system.balance
    with np.errstate(all="ignore"):
        sides = _region(system, given, region)
        if sides is None:
            return None
        outcome = boxes.search(system, sides, given, given)
        roots = certified_roots.roots(system, outcome, sides, given, given)
        once = None if roots.left.shape[2] else _once_around(roots)
        if once is None:
            return None
        columns = system.prepared(Intervals.point(np.repeat(given, once.shape[2], axis=1)))
        ends = system.cartesian(once, columns)
    ends = ends[:, :, ~contractors.apart(ends, region)]
    ends = ends[:, :, np.argsort(-ends[0, 0])]
    place = np.arange(ends.shape[2])
    together = ~contractors.apart(ends[:, :, :, None], ends[:, :, None, :]) & (place[:, None] != place)
    if together.any() or not contractors.within(ends, region).all():
        return None
    # All roots are known, and no other one is in the box of any.
    nothing = np.empty((2, balance.n, 0)), np.empty(0, dtype=np.int64)
    return Roots(ends, ends, np.zeros(place.size, dtype=np.int64), *nothing)


def _region(system: _Polar, given: FloatArray, region: FloatArray) -> FloatArray | None:
    """Ends of angle, elongation and the others that hold the region; None where no spring pulls."""
    parameters = system.prepared(Intervals.point(given))
    values = system.balance.arguments(parameters)
    stiffness = system.stiffness(values, (1,))
    if not stiffness.low[0] > 0:
        return None
    others = [i for i in range(system.balance.n) if i not in system.chart]
    q: list[Any] = [Intervals(region[:, i]) if i in others else 0 for i in range(system.balance.n)]
    *anchor, rest = stacked(
        undecorated(system.balance.model.statics.geometry)(*q, *system.given(values), xp=XP)[system.spring], (1,)
    )
    ends = np.stack([part.ends for part in anchor], axis=1)
    reach = np.maximum(*raised(region[:, list(system.chart)] + ends[::-1]))[:, 0]
    length = float(raised(np.hypot(*reach), 4))
    unit = np.maximum(1.0, stiffness.high[0])
    elongation = (Intervals.between(np.zeros(1), np.array([length])) - rest) * Intervals.point(np.array([unit]))
    # Along the spring its tension balances all else.
    whole = list(Intervals(region))
    rest_of_forces = stacked(system.rows(whole, system.balance.directions(whole, values, (1,)), values, 0), (1,))
    most = rest_of_forces[list(system.chart)].magnitude.sum(axis=0) * (unit / stiffness.low[0])
    elongation = Intervals(np.fmin(elongation.ends, ROOM * raised(np.stack([most, most]), 4)))
    sides = [[AROUND, AROUND], elongation.ends[:, 0].tolist(), *(region[:, i, 0].tolist() for i in others)]
    out: FloatArray = np.array(sides).T[:, :, None]
    return out


def _once_around(roots: Roots) -> FloatArray | None:
    """Boxes of roots without those a turn away from another; None where that is not known."""
    shifted = roots.ends.copy()
    shifted[:, 0] = (Intervals(roots.ends[:, 0]) - TURN).ends
    back = roots.ends.copy()
    back[:, 0] = (Intervals(roots.ends[:, 0]) + TURN).ends
    one, other = np.nonzero(~contractors.apart(roots.ends[:, :, :, None], shifted[:, :, None, :]))
    same = contractors.within(shifted[:, :, other], roots.alone[:, :, one])
    same |= contractors.within(back[:, :, one], roots.alone[:, :, other])
    return np.delete(roots.ends, other, axis=2) if same.all() else None
