"""The balance around a spring's anchor, in the angle φ and the length l of the spring's line in place of its end's coordinates.

Let the vector from the mass to the anchor be l (c, s), with (c, s) at the angle φ (from the angle at rest, where a torsion
spring resists turning), let T be the tension of the spring, and A_x, A_y the sums of all other forces, on the side of the
balance. Then

    along the line:                 A_x c + A_y s − T = 0,
    across the line:                A_y c − A_x s = 0.

A stiff spring with little else to hold the mass has near-equilibria on the whole circle of its undeformed length, which is
straight here; with the tension k (l − r) for an unknown no difference of large forces is left. At the anchor, where x and y do
not say the direction, φ does.

A torsion spring pulls across its line with k_t φ/l, which has no bound at the anchor. There the balance

    across the line, times l:       l (A_y c − A_x s) − k_t φ = 0

is smooth at l = 0, too. A third coordinate z, by which the vector changes by (a, b), has
A_z + T (c a + s b) + (c b − s a) k_t φ/l = 0, where the balance across gives k_t φ/l = A_y c − A_x s. For l > 0 these equations
have the same roots as the balance of forces, since the one are regular combinations of the other; so exclusion and interval
Newton decide there as anywhere else.

What a root of them means:

- l > 0, and with a torsion spring −π < φ < π: an equilibrium.
- l < 0: none, since the line's angle is another one there.
- l = 0: none. These are two equations for φ alone; the page's energy has no derivative at the anchor, with a torsion spring no
  value. At such parameters an equilibrium arrives at the anchor and is no more.
- |φ| > π with a torsion spring: none, since φ is the least turning. At φ = ±π the energy has a ridge: its slopes on both sides,
  ∓k_t π, lead away.

So a search goes a little beyond l = 0 and |φ| = π; roots that are proved to lie there are dropped, and those that can't be told
from one on the border are undecided.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, TypeAlias

import numpy as np

from ..numerics import boxes, certified_roots, contractors, jets
from ..numerics.balls import XP as BALLS
from ..numerics.balls import ball
from ..numerics.certified_roots import Roots
from ..numerics.interval_arrays import BoolArray, FloatArray, IntArray, Intervals, Shape, raised, stacked
from ..numerics.interval_arrays import length as interval_length
from ..numerics.precise_roots import Digits
from .balance import Balance
from .forces import Values, direction, quotients
from .namespaces import XP
from .precise_balance import PreciseBalance, refined, settled_by_digits

#: Bound, in units of 2⁻⁵² relative, on the error of NumPy's arctangent.
ARCTAN_ULPS = 8.0
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
#: Coordinates, directions, elongation.
Place: TypeAlias = tuple[list[Any], list[Any], Any]


@dataclass(frozen=True)
class Given:
    """Arguments of the forces, the scale, and the kind of all numbers: intervals of a shape and jets of them, or balls."""

    values: Values
    scale: Any
    shape: Shape = ()
    xp: Any = XP

    def direction(self, dx: Any, dy: Any) -> tuple[Any, Any, Any]:
        """Cosine, sine and length of a vector."""
        return direction(dx, dy, self.shape) if self.xp is XP else quotients(dx, dy, self.xp)


@dataclass(frozen=True)
class Polar(boxes.System):
    """The balance along and across a spring's line; unknowns are φ, the length, and the other coordinates.

    The unknown for the length is l over a scale, or where the spring is so stiff that l stays beyond half of its undeformed
    length, the elongation over a scale (``tight``). The scale is one more parameter, the last. ``turns`` where a torsion spring
    resists φ.
    """

    balance: Balance
    spring: int
    chart: tuple[int, int]
    turns: bool
    tight: bool

    def prepared(self, bounds: Intervals) -> Intervals:
        """Prepared parameters of the balance, with the scale last."""
        return Intervals(np.concatenate([self.balance.prepared(bounds[:-1]).ends, bounds[-1:].ends], axis=1))

    def place(self, unknowns: Sequence[Any], given: Given) -> Place:
        """Coordinates, directions and lengths with φ behind, and the elongation."""
        angle, part, *others = unknowns
        c, s = self._direction(angle, given)
        q: list[Any] = [0] * self.balance.n
        for number, value in zip((i for i in range(self.balance.n) if i not in self.chart), others, strict=True):
            q[number] = value
        *anchor, rest = self.balance.geometry(q, given.values, given.xp)[self.spring]
        far = part * given.scale
        length, elongation = (far + rest, far) if self.tight else (far, far - rest)
        for number, end, share in zip(self.chart, anchor, (c, s), strict=True):
            q[number] = -(length * share) + end
        directions: list[Any] = []
        for number, (dx, dy, _) in enumerate(self.balance.geometry(q, given.values, given.xp)):
            directions += [c, s, length] if number == self.spring else given.direction(dx, dy)
        return q, self.turned(directions, angle), elongation

    def _direction(self, angle: Any, given: Given) -> tuple[Any, Any]:
        """Cosine and sine of the line's direction at φ, from the one at φ = 0."""
        cosine, sine = given.xp.cos(angle), given.xp.sin(angle)
        c0, s0 = self.balance.at_rest(given.values, given.xp)[0] if self.turns else (1, 0)
        return cosine * c0 - sine * s0, sine * c0 + cosine * s0

    def turned(self, directions: Sequence[Any], angle: Any) -> list[Any]:
        """Directions with the angle behind by which the torsion spring turns; without stiffness it does not matter."""
        return [*directions, *(angle if self.turns else 0 for _ in self.balance.torsions)]

    def rows(self, q: Sequence[Any], directions: Sequence[Any], elongation: Any, given: Given) -> list[Any]:
        """Balance along, and across times l, in the rows of the line's end; of the other coordinates."""
        stiffnesses = self.balance.of_no_place("stiffnesses", given.values, given.xp)
        c, s, length = directions[3 * self.spring : 3 * self.spring + 3]
        forces = self.other_forces(q, directions, given, stiffnesses)
        x, y = self.chart
        tension, across = elongation * stiffnesses[self.spring], forces[y] * c - forces[x] * s
        out = list(forces)
        out[x] = forces[x] * c + forces[y] * s - tension
        out[y] = across
        if self.turns:
            (torsion,) = self.balance.of_no_place("torsions", given.values, given.xp)
            out[y] = length * across - directions[-1] * torsion
        if self.balance.n > 2:
            a, b = end_slopes(self.balance, given.values)[self.spring]
            for row in set(range(self.balance.n)) - set(self.chart):
                out[row] = forces[row] + tension * (c * a[row] + s * b[row]) + (c * b[row] - s * a[row]) * across
        return out

    def other_forces(
        self, q: Sequence[Any], directions: Sequence[Any], given: Given, stiffnesses: Sequence[Any]
    ) -> list[Any]:  # fmt: skip
        """All but those of this line."""
        forces = list(self.balance.call("forces_apart", q, directions, given.values, given.xp))
        if self.balance.springs == 1:
            return forces
        rests = [row[2] for row in self.balance.geometry(q, given.values, given.xp)]
        slopes = end_slopes(self.balance, given.values)
        for place, (k, rest, (a, b)) in enumerate(zip(stiffnesses, rests, slopes, strict=True)):
            if place != self.spring:
                c, s, length = directions[3 * place : 3 * place + 3]
                tension = (length - rest) * k
                forces = [force + tension * (c * a[row] + s * b[row]) for row, force in enumerate(forces)]
        return forces

    # ------------------------------------------------------------------------------------------ over boxes

    def _given(self, parameters: Intervals) -> Given:
        return Given(self.balance.arguments(parameters), parameters[-1], parameters.shape[1:])

    def equations(self, unknowns: Sequence[Any], parameters: Intervals) -> Sequence[Any]:
        """The equations over boxes."""
        given = self._given(parameters)
        return self.rows(*self.place(unknowns, given), given)

    def hopeless(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """Boxes beyond the contact's border."""
        given = self._given(parameters)
        return self.balance.beyond_border(self.place(list(unknowns), given)[0], given.values, given.shape)

    def contracted(self, unknowns: Intervals, parameters: Intervals) -> FloatArray:
        """Smaller boxes: the coordinates that balance the forces with these directions, and the directions towards these.

        A stiff straight guide is thin in the coordinates, and bent in angle and length.
        """
        given = self._given(parameters)
        q, directions, elongation = self.place(list(unknowns), given)
        places = Intervals(self.balance.with_directions(stacked(q, given.shape), given.values, directions))
        rows = stacked(self.rows(list(places), directions, elongation, given), given.shape)
        empty = ~np.logical_and.reduce(rows.holds_zero()) | np.logical_or.reduce(places.ends[0] + places.ends[1] < 0)
        ends = self._towards(places, unknowns, given)
        ends[:, :, empty] = -1.0
        return ends

    def _towards(self, places: Intervals, unknowns: Intervals, given: Given) -> FloatArray:
        """Boxes that hold the angles and lengths of places among the given ones, where lengths are positive."""
        dx, dy, rest = self.balance.geometry(list(places), given.values, given.xp)[self.spring]
        c, s = self._direction(Intervals.point(unknowns[0].middle), given)
        along, across = dx * c + dy * s, dy * c - dx * s
        lengths = interval_length(dx, dy)
        part = ((lengths - rest) if self.tight else lengths) / given.scale
        # What the tangent is known of turns by less than a quarter from the middle of the box.
        slope = (across / along).ends
        turned = raised(np.arctan(slope), ARCTAN_ULPS) + np.stack([-unknowns[0].middle, unknowns[0].middle])
        length = unknowns[1] * given.scale + rest if self.tight else unknowns[1] * given.scale
        ahead = (length.low > 0) & (along.low > 0) & (unknowns[0].width < 3)
        ends = unknowns.ends.copy()
        ends[:, 0] = np.where(ahead, np.fmin(raised(turned), ends[:, 0]), ends[:, 0])
        ends[:, 1] = np.where(ahead, np.fmin(part.ends, ends[:, 1]), ends[:, 1])
        return ends

    def cartesian(self, ends: FloatArray, parameters: Intervals) -> FloatArray:
        """Boxes that hold the coordinates."""
        return stacked(self.place(list(Intervals(ends)), self._given(parameters))[0], ends.shape[2:]).ends

    def precise(self, given: FloatArray, bits: int) -> _PrecisePolar:
        """The equations of balls."""
        return _PrecisePolar(self, given, bits)


class _PrecisePolar(Digits):
    """The equations at one point, of balls or jets of balls."""

    def __init__(self, system: Polar, given: FloatArray, bits: int) -> None:
        arguments = PreciseBalance(system.balance, given[:-1], bits).arguments
        self.system, self.bits, self.given = system, bits, Given(arguments, ball(float(given[-1]), bits), xp=BALLS)

    def equations(self, unknowns: Sequence[Any]) -> Sequence[Any]:
        """The equations."""
        return self.system.rows(*self.system.place(unknowns, self.given), self.given)


def end_slopes(balance: Balance, values: Values, near: Any = 0) -> list[tuple[list[Any], list[Any]]]:
    """How the vector of every spring changes with the coordinates: for ends that are linear in them the same everywhere."""
    rows = balance.geometry(jets.variables([near] * balance.n, 1), values)
    return [(jets.gradient(dx, balance.n), jets.gradient(dy, balance.n)) for dx, dy, _ in rows]


def ends_are_linear(balance: Balance, given: FloatArray) -> bool:
    """Whether the ends of all springs are linear in the coordinates."""
    values = balance.over(Intervals.point(given))
    slopes = end_slopes(balance, values, Intervals.between(np.array([-2.0]), np.array([3.0])))
    every = [entry for pair in slopes for row in pair for entry in row]
    return bool((stacked(every, (1,)).width < 1e-12).all()) if every else True


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
