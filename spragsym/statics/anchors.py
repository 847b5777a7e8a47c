"""Searches in angle and length of a spring's line, see :mod:`~spragsym.statics.polar`: stiff, anchored and torsion
springs."""

from dataclasses import replace
from functools import partial

import numpy as np

from ..numerics import certified_roots, contractors
from ..numerics.certified_roots import Roots
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals, raised, stacked
from .mechanics.balance import Balance
from .mechanics.precise_balance import PreciseBalance, refined, settled_by_digits
from .polar import Given, Polar, ends_are_linear

#: Width of boxes that are left where a search gives up along a circle; those around a fold are narrower.
WIDE = 2.0**-10
#: Stiffness over that of the contact from which on a point is looked at in polar coordinates first. In lift-off, where nothing
#: else may hold the mass across, the line of a single spring is the better guide however soft it is.
STIFF = 3e3
#: What is searched beyond φ = ±π, and beyond l = 0 in parts of the largest length.
BEYOND = 2.0**-6
#: Upper bound of π.
HALF_TURN = 3.1415926535897936
#: Once around, and what it is known by.
TURN, TURN_ERROR = 2 * np.pi, 1e-14
#: By what the tension may be larger than it can be, so that none lies on the border of the region.
ROOM = 1.0 + 2.0**-10
#: Steps of interval Newton on lengths that are small parts of the largest one.
STEPS = 6


def turned_points(balance: Balance, given: FloatArray, regions: FloatArray) -> tuple[Roots, BoolArray]:
    """Roots and undecided boxes of points with a torsion spring, and which points these are.

    A model with torsion springs along several lines, or along one whose first end is not at two coordinates, has none of them.
    ``given`` are parameters, shape (parameters, points), and ``regions`` have the shape (2, n, points).
    """
    done = np.zeros(given.shape[1], dtype=np.bool_)
    system = _system(balance, given, balance.torsions[0], True) if len(balance.torsions) == 1 else None
    if system is None:
        return Roots.none(balance.n), done
    done = _stiffnesses(balance, given, "torsions").low[0] > 0
    return _of_points(system, given, regions, np.flatnonzero(done)), done


def stiff_points(balance: Balance, given: FloatArray, regions: FloatArray) -> tuple[Roots, BoolArray]:
    """Roots of points with a stiff spring that are decided around one of the springs, and which points these are."""
    if not hasattr(balance.model.algebra, "stiffnesses"):
        return Roots.none(balance.n), np.zeros(given.shape[1], dtype=np.bool_)
    least = 0.0 if balance.springs == 1 and not balance.contact else STIFF
    stiff = _stiffnesses(balance, given).high.max(axis=0, initial=0.0) > least
    return _of_any_spring(balance, given, regions, np.flatnonzero(stiff))


def around_anchors(balance: Balance, given: FloatArray, regions: FloatArray, found: Roots, wider: float = WIDE) -> Roots:
    """What a search has left along circles around anchors, decided in polar coordinates where that succeeds.

    ``wider`` is the width of a box that is left from which on a point is looked at.
    """
    wide = (found.left[0] + found.left[1]).max(axis=0, initial=0.0) > wider
    again, done = _of_any_spring(balance, given, regions, np.unique(found.left_point[wide]))
    return certified_roots.concatenated([found.of(np.flatnonzero(done), others=True), again], balance.n) if done.any() else found


def _stiffnesses(balance: Balance, given: FloatArray, name: str = "stiffnesses") -> Intervals:
    """Stiffnesses of all springs, or for ``"torsions"`` of all torsion springs, shape (springs, points)."""
    values = balance.over(Intervals.point(given))
    with np.errstate(all="ignore"):
        return stacked(balance.of_no_place(name, values), given.shape[1:])


def _of_any_spring(balance: Balance, given: FloatArray, around: FloatArray, points: IntArray) -> tuple[Roots, BoolArray]:
    """Roots of the points of which all is decided around one of the springs, and which these are."""
    done = np.zeros(given.shape[1], dtype=np.bool_)
    parts: list[Roots] = []
    if balance.torsions:
        points = points[_stiffnesses(balance, given[:, points], "torsions").high.max(axis=0) <= 0]
    for spring in range(balance.springs):
        points = points[~done[points]]
        system = _system(balance, given, spring, False) if points.size else None
        if system is not None:
            found = _of_points(system, given, around, points)
            decided = np.setdiff1d(points, found.left_point)
            parts.append(found.of(decided))
            done[decided] = True
    return certified_roots.concatenated(parts, balance.n), done


def _system(balance: Balance, given: FloatArray, spring: int, turns: bool) -> Polar | None:
    """The system around a spring; None where it has no chart. A folder that was derived before has no forces without springs."""
    names = balance.model.about["springs"][spring]["chart"]
    if names is None or not hasattr(balance.model.algebra, "forces_apart") or not ends_are_linear(balance, given):
        return None
    x, y = (balance.coordinates.index(name) for name in names)
    return Polar(balance, spring, (x, y), turns, False)


def _of_points(system: Polar, given: FloatArray, around: FloatArray, points: IntArray) -> Roots:
    """Roots and undecided boxes of some points, by their numbers."""
    given, around = given[:, points], around[:, :, points]
    parts: list[Roots] = []
    if points.size:
        with np.errstate(all="ignore"):
            sides, scale, narrow = _sides(system, given, around)
        for tight in (False, True):
            some = np.flatnonzero(narrow == tight)
            if some.size:
                columns = np.concatenate([given[:, some], scale[None, some]])
                found = _searched(replace(system, tight=tight), columns, sides[:, :, some], around[:, :, some])
                parts.append(found.numbered(points[some]))
    return certified_roots.concatenated(parts, system.balance.n)


def _sides(system: Polar, given: FloatArray, around: FloatArray) -> tuple[FloatArray, FloatArray, BoolArray]:
    """For each point the region in the unknowns, the scale, and whether the length stays away from 0."""
    balance, shape = system.balance, given.shape[1:]
    values = balance.over(Intervals.point(given))
    stiffnesses = balance.of_no_place("stiffnesses", values)
    k = stacked(stiffnesses, shape)[system.spring]
    q = [0 if i in system.chart else Intervals(around[:, i]) for i in range(balance.n)]
    *anchor, rest = stacked(balance.geometry(q, values)[system.spring], shape)
    reach = [np.maximum(*raised(around[:, i] + end.ends[::-1])) for i, end in zip(system.chart, anchor, strict=True)]
    length = raised(np.hypot(*reach), 4)
    # Along the line the tension balances all else.
    whole = list(Intervals(around))
    directions = system.turned(balance.directions(whole, values, shape)[: 3 * balance.springs], Intervals.point(np.zeros(shape)))
    forces = stacked(system.other_forces(whole, directions, Given(values, 1, shape), stiffnesses), shape)
    most = ROOM * raised(np.hypot(*(forces.magnitude[i] for i in system.chart)) / k.low, 8)
    most = np.where(np.isfinite(most) & (k.low > 0), most, np.inf)
    tight = most < 0.5 * rest.low
    longest = np.fmin(length, raised(rest.high + most))
    shortest = np.maximum(-BEYOND * longest, -raised(most - rest.low))
    scale = np.where(tight, most, longest)
    scale = np.where(scale > 0, scale, 1.0)
    turn = np.full(shape, HALF_TURN + BEYOND)
    ends = np.where(tight, 1.0, -shortest / scale), np.ones(shape)
    others = [around[:, i] for i in range(balance.n) if i not in system.chart]
    return np.stack([np.stack([turn, turn]), raised(np.stack(ends), 2), *others], axis=1), scale, tight


def _searched(system: Polar, given: FloatArray, sides: FloatArray, around: FloatArray) -> Roots:
    """All roots of points, as boxes of coordinates."""
    with np.errstate(all="ignore"):
        found = certified_roots.search(system, sides, given, given)
        found = refined(given, found, system.precise)
        found = settled_by_digits(system, given, sides, found, system.precise)
        found = found if system.turns else _once_around(found)
        prepared = system.prepared(Intervals.point(given))
        ends = found.ends if system.tight else _sharpened(system, found.ends, prepared[:, found.point])
        possible, sure = _are_equilibria(system, ends)
        open_ = possible & ~sure
        found = found.kept(sure, _are_equilibria(system, found.left)[0]).besides(ends[:, :, open_], found.point[open_])
        balance, point, left_point = system.balance, found.point, found.left_point
        roots = Roots.at(system.cartesian(ends[:, :, sure], prepared[:, point]), point=point)
        # On which side of the border a root lies that floats can't tell from it, digits do.
        on_border = ~contractors.within(roots.ends, around[:, :, point])
        roots = refined(given[:-1], roots, partial(PreciseBalance, balance), on_border)
        left = system.cartesian(found.left, prepared[:, left_point])
    return _apart(roots.besides(left, left_point), around)


def _once_around(found: Roots) -> Roots:
    """Roots once each, where angles that differ by a turn are the same; what is left beyond ±π is left on the other side, too."""
    back = found.ends[1, 0] < 2 * BEYOND - np.pi
    ends, alone = found.ends.copy(), found.alone.copy()
    turn = np.array([[-TURN], [TURN]])
    ends[:, 0, back] += turn + TURN_ERROR
    alone[:, 0, back] += turn - TURN_ERROR
    turned = replace(found, ends=ends, alone=alone)
    inside = Intervals(found.left[:, 0]).mignitude <= HALF_TURN
    return certified_roots.distinct(turned.kept(left=inside))


def _are_equilibria(system: Polar, ends: FloatArray) -> tuple[BoolArray, BoolArray]:
    """Boxes that may hold an equilibrium; and those of which lengths are proved to be positive, angles those of least turning."""
    possible = np.ones((2, ends.shape[2]), dtype=np.bool_)
    if system.turns:
        angle = Intervals(ends[:, 0])
        possible &= angle.mignitude <= HALF_TURN, angle.magnitude < np.pi
    if not system.tight:
        possible &= ends[1, 1] >= 0, ends[0, 1] < 0
    return possible[0], possible[0] & possible[1]


def _sharpened(system: Polar, ends: FloatArray, parameters: Intervals) -> FloatArray:
    """Roots known to more digits: a length that is a small part of the scale to as many as a large one."""
    for _ in range(STEPS):
        ends = np.fmin(certified_roots.stepped(system, ends, parameters).ends, ends)
    return ends


def _apart(found: Roots, around: FloatArray) -> Roots:
    """Roots of the region, each in a box of its own; those in boxes that meet are among what is left."""
    found = found.kept(np.lexsort((-found.ends[0, 0], found.point)))
    found = found.kept(~contractors.apart(found.ends, around[:, :, found.point]))
    roots, point = found.ends, found.point
    clear = contractors.within(roots, around[:, :, point])
    for first, second in certified_roots.neighbours(roots, point):
        meet = ~contractors.apart(roots[:, :, first], roots[:, :, second])
        clear[first[meet]] = clear[second[meet]] = False
    found = found.kept(clear).besides(roots[:, :, ~clear], point[~clear])
    return found.kept(left=~contractors.apart(found.left, around[:, :, found.left_point]))
