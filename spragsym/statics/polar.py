"""The balance of forces in polar coordinates around a spring's anchor: angle φ and length l of its
line.

Let the vector from the mass to the anchor be l (c, s), where (c, s) is a unit vector at the angle
φ. (With a torsion spring, φ is measured from the direction at rest.) Let T be the tension of the
spring, and A_x, A_y the sums of all other forces, with the sign that they have in the balance. Then

    along the line:                 A_x c + A_y s − T = 0,
    across the line:                A_y c − A_x s = 0.

Near a stiff spring with little else to hold the mass, the balance nearly holds on the whole circle
of its undeformed length r. In polar coordinates the circle is straight. With the elongation l − r
as an unknown, the tension k (l − r) is no difference of two large forces. At the anchor φ still
defines the direction, which x and y do not.

A torsion spring acts across its line with k_t φ/l, which is unbounded at the anchor. The balance

    across the line, times l:       l (A_y c − A_x s) − k_t φ = 0

is smooth at l = 0 too. A third coordinate z, by which the vector changes by (a, b), has the row A_z
+ T (c a + s b) + (c b − s a) k_t φ/l = 0. There the balance across replaces k_t φ/l by A_y c − A_x
s. For l > 0 these equations are regular combinations of the balance of forces and have the same
roots, so that exclusion and interval Newton apply.

Which roots are equilibria:

- l > 0, and −π < φ < π with a torsion spring: an equilibrium.
- l < 0: none, since the true angle of the line is φ + π.
- l = 0: none. The two equations are for φ alone, and the energy has no derivative at the anchor,
  with a torsion spring no value. At such parameters an equilibrium ends at the anchor.
- |φ| > π with a torsion spring: none, since the least angle counts. At φ = ±π the energy has a
  ridge; its slopes ∓k_t π on the two sides lead away.

A search extends a little beyond l = 0 and |φ| = π. Roots proved to lie there are dropped; roots
that may lie on a limit are undecided.
"""

from __future__ import annotations

import itertools
from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from ..numerics import certified_roots, contractors, jets
from ..numerics.arithmetic import Number
from ..numerics.certified_roots import Roots
from ..numerics.interval_arrays import (
    HALF_TURN,
    BoolArray,
    FloatArray,
    IntArray,
    Intervals,
    Shape,
    quiet,
    rounded_outward,
    stacked,
    width_of,
)
from .balance import SCALE, Balance
from .forces import Evaluation, Values, as_intervals
from .namespaces import XP
from .precise_balance import reduced_by_turns, refined, refined_in_digits
from .systems import WithoutTapes


@dataclass(frozen=True)
class Polar(WithoutTapes):
    """The balance along and across the line of one spring; unknowns are φ, the length and the other
    coordinates.

    The unknown length is l divided by a scale. If the spring is so stiff that l stays beyond half
    of its undeformed length (``tight``), it is the elongation divided by a scale instead. The scale
    is one more parameter, the last. With ``turns``, a torsion spring acts on φ. ``chart`` are the
    numbers of the two coordinates that φ and l replace.
    """

    balance: Balance
    spring: int
    chart: tuple[int, int]
    turns: bool
    tight: bool

    @cached_property
    def n(self) -> int:  # type: ignore[override]  # of the balance
        """Number of unknowns."""
        return self.balance.n

    def identity(self) -> Hashable:
        """Identity of the balance, the spring and the kind of its unknowns."""
        return self.balance.identity(), self.spring, self.chart, self.turns, self.tight

    def prepared(self, bounds: Intervals) -> Intervals:
        """Prepared parameters of the balance, and the scale as the last row."""
        return Intervals(
            np.concatenate([self.balance.prepared(bounds[:-1]).ends, bounds[-1:].ends], axis=1)
        )

    def at(
        self, q: Sequence[Any], values: Values, shape: Shape = (), xp: object = XP
    ) -> Evaluation:
        """The evaluation at φ, the length and the other coordinates."""
        origin = self.balance.at((), values, shape, xp)
        angle, part, *others = q
        cosine, sine = origin.xp.cos(angle), origin.xp.sin(angle)
        c0, s0 = origin.at_rest[0] if self.turns else (1, 0)
        c, s = cosine * c0 - sine * s0, sine * c0 + cosine * s0
        q = list(origin.q)
        free = (i for i in range(self.balance.n) if i not in self.chart)
        for number, value in zip(free, others, strict=True):
            q[number] = value
        *anchor, rest = replace(origin, q=q).geometry[self.spring]
        length = part * values[SCALE] + rest if self.tight else part * values[SCALE]
        for number, end, share in zip(self.chart, anchor, (c, s), strict=True):
            q[number] = -(length * share) + end
        at = replace(origin, q=q)
        lines = [
            (c, s, length) if number == self.spring else at.direction(dx, dy)
            for number, (dx, dy, _) in enumerate(at.geometry)
        ]
        at.fixed = self.rotated(itertools.chain(*lines), angle)
        return at

    def rotated(self, directions: Iterable[Any], angle: Number) -> list[Any]:
        """The directions, followed by the torsion angle ``angle``; 0 where no torsion
        spring acts.
        """
        return [*directions, *(angle if self.turns else 0 for _ in self.balance.torsions)]

    def conditions(self, at: Evaluation, unknowns: Sequence[Any]) -> list[Any]:
        """Residuals: the balance along the line in the row of x, across (times l) in that of y, and
        the rows of the other coordinates.
        """
        far = unknowns[1] * at.values[SCALE]
        elongation = far if self.tight else far - at.geometry[self.spring][2]
        c, s, length = at.directions[3 * self.spring : 3 * self.spring + 3]
        forces = self.other_forces(at)
        x, y = self.chart
        tension = elongation * at.of_springs("stiffnesses")[self.spring]
        across = forces[y] * c - forces[x] * s
        out = list(forces)
        out[x] = forces[x] * c + forces[y] * s - tension
        out[y] = across
        if self.turns:
            (torsion,) = at.of_springs("torsions")
            out[y] = length * across - at.directions[-1] * torsion
        if self.balance.n > 2:
            a, b = end_slopes(at)[self.spring]
            for row in set(range(self.balance.n)) - set(self.chart):
                along_row = tension * (c * a[row] + s * b[row])
                out[row] = forces[row] + along_row + (c * b[row] - s * a[row]) * across
        return out

    def other_forces(self, at: Evaluation) -> list[Any]:
        """The forces without those of this spring, by coordinate."""
        forces = list(at.rows("forces_apart"))
        if self.balance.springs == 1:
            return forces
        lines = zip(at.of_springs("stiffnesses"), at.geometry, end_slopes(at), strict=True)
        for index, (k, (*_, rest), (a, b)) in enumerate(lines):
            if index != self.spring:
                c, s, length = at.directions[3 * index : 3 * index + 3]
                tension = (length - rest) * k
                forces = [
                    force + tension * (c * a[row] + s * b[row]) for row, force in enumerate(forces)
                ]
        return forces

    # ------------------------------------------------------------------------------------------
    # over boxes

    def state(
        self,
        unknowns: Intervals | Sequence[Number],
        parameters: Intervals,
        sides: Sequence[int] | None = None,
    ) -> Evaluation:
        """The evaluation over boxes."""
        return self.at(
            list(unknowns),
            self.balance.arguments(parameters) | {SCALE: parameters[-1]},
            parameters.shape[1:],
        )

    def excluded(self, unknowns: Intervals, parameters: Intervals) -> BoolArray:
        """Boxes beyond the contact's border, and boxes whose directions no coordinates can
        balance.
        """
        at = self.state(unknowns, parameters)
        return at.beside_border()[1] | np.logical_or.reduce(
            width_of(self.balance.with_directions(at)) < 0
        )

    def cartesian(self, ends: FloatArray, parameters: Intervals) -> FloatArray:
        """Boxes of coordinates that hold the given boxes of φ and the length, as −low and high."""
        return stacked(self.state(Intervals(ends), parameters).q, ends.shape[2:]).ends


def end_slopes(at: Evaluation, near: Number = 0) -> list[tuple[list[Any], list[Any]]]:
    """Derivatives of every spring's vector (dx, dy) by the coordinates, at coordinates ``near``.

    They are constants where the ends are linear in the coordinates.
    """
    n = at.balance.n
    rows = replace(at, q=jets.variables([near] * n, 1), xp=XP).geometry
    return [(jets.gradient(dx, n), jets.gradient(dy, n)) for dx, dy, _ in rows]


def ends_are_linear(balance: Balance, given: FloatArray) -> bool:
    """Whether the ends of all springs are linear in the coordinates: their slopes are constant over
    a box.
    """
    at = balance.at((), balance.over(Intervals.point(given)))
    slopes = end_slopes(at, Intervals.between(np.array([-2.0]), np.array([3.0])))
    every = [entry for pair in slopes for row in pair for entry in row]
    return bool((stacked(every, (1,)).width < 1e-12).all()) if every else True


def turned_points(
    balance: Balance, given: FloatArray, regions: FloatArray
) -> tuple[Roots, BoolArray]:
    """Roots and undecided boxes at points with a torsion spring in use, and the mask of these
    points.

    None are found for a model with torsion springs along several lines, or along one without a
    chart of two coordinates. ``given`` are parameters, shape (parameters, points), and ``regions``
    have the shape (2, n, points).
    """
    done = np.zeros(given.shape[1], dtype=bool)
    system = None
    if len(balance.torsions) == 1:
        system = _system(balance, given, balance.torsions[0], True)
    if system is None:
        return Roots.none(balance.n), done
    done = _stiffnesses(balance, given, "torsions").low[0] > 0
    return _of_points(system, given, regions, np.flatnonzero(done)), done


def stiff_points(
    balance: Balance, given: FloatArray, regions: FloatArray
) -> tuple[Roots, BoolArray]:
    """Roots at points with a stiff spring that one spring's polar coordinates decide, and their
    mask.
    """
    # In lift-off nothing else may hold the mass across the line of a single spring: then polar
    # coordinates are better however soft the spring is.
    least = 0.0 if balance.springs == 1 and not balance.contact else balance.options.stiff
    stiff = _stiffnesses(balance, given).high.max(axis=0, initial=0.0) > least
    return _of_any_spring(balance, given, regions, np.flatnonzero(stiff))


def around_anchors(balance: Balance, given: FloatArray, regions: FloatArray, found: Roots) -> Roots:
    """The result of a search, where undecided points are searched again in polar coordinates.

    The new result counts for points that one spring's polar coordinates decide.
    """
    again, done = _of_any_spring(balance, given, regions, np.unique(found.undecided_point))
    return found.of(np.flatnonzero(done), others=True).concatenated(again)


def _stiffnesses(balance: Balance, given: FloatArray, name: str = "stiffnesses") -> Intervals:
    """Stiffnesses of all springs, shape (springs, points), or with ``"torsions"`` of all torsion
    springs.
    """
    with quiet():
        return stacked(
            balance.at((), balance.over(Intervals.point(given))).of_springs(name), given.shape[1:]
        )


def _of_any_spring(
    balance: Balance, given: FloatArray, box: FloatArray, points: IntArray
) -> tuple[Roots, BoolArray]:
    """Roots at those of the points that polar coordinates of one spring decide, and their mask."""
    decided_at, roots = np.zeros(given.shape[1], dtype=bool), Roots.none(balance.n)
    if balance.torsions:
        points = points[_stiffnesses(balance, given[:, points], "torsions").high.max(axis=0) <= 0]
    for spring in range(balance.springs):
        points = points[~decided_at[points]]
        system = _system(balance, given, spring, False) if points.size else None
        if system is not None:
            found = _of_points(system, given, box, points)
            decided = np.setdiff1d(points, found.undecided_point)
            roots = roots.concatenated(found.of(decided))
            decided_at[decided] = True
    return roots, decided_at


def _system(balance: Balance, given: FloatArray, spring: int, turns: bool) -> Polar | None:
    """The polar system of a spring; None if the spring has no chart of two coordinates."""
    names = balance.model.about["springs"][spring]["chart"]
    if names is None or not ends_are_linear(balance, given):
        return None
    x, y = (balance.coordinates.index(name) for name in names)
    return Polar(balance, spring, (x, y), turns, False)


def _of_points(system: Polar, given: FloatArray, box: FloatArray, points: IntArray) -> Roots:
    """Roots and undecided boxes at the points of the given numbers."""
    given, box, roots = given[:, points], box[:, :, points], Roots.none(system.balance.n)
    with quiet():
        sides, scale, is_tight = _sides(system, given, box)
        for tight in (False, True):
            rows = np.flatnonzero(is_tight == tight)
            if rows.size:
                columns = np.concatenate([given[:, rows], scale[None, rows]])
                own = replace(system, tight=tight)
                found = _searched(own, columns, sides[:, :, rows], box[:, :, rows])
                roots = roots.concatenated(found.numbered(points[rows]))
    return roots


def _sides(
    system: Polar, given: FloatArray, box: FloatArray
) -> tuple[FloatArray, FloatArray, BoolArray]:
    """For each point, the box to search in the unknowns of the polar system, the scale, and
    ``tight``.
    """
    balance, shape = system.balance, given.shape[1:]
    origin = balance.at((), balance.over(Intervals.point(given)), shape)
    k = as_intervals(origin.of_springs("stiffnesses")[system.spring], shape)
    q = [0 if i in system.chart else Intervals(box[:, i]) for i in range(balance.n)]
    *anchor, rest = stacked(replace(origin, q=q).geometry[system.spring], shape)
    reach = [
        np.maximum(*rounded_outward(box[:, i] + end.ends[::-1]))
        for i, end in zip(system.chart, anchor, strict=True)
    ]
    length = rounded_outward(np.hypot(*reach), 4)
    # Along the line the tension balances the other forces, which bound the elongation.
    whole = replace(origin, q=list(Intervals(box)))
    directions = system.rotated(whole.directions[: 3 * balance.springs], 0)
    forces = stacked(system.other_forces(replace(whole, fixed=directions)), shape)
    # Larger than the bound, so that no root lies on the border of the region.
    elongation = (1.0 + 2.0**-10) * rounded_outward(
        np.hypot(*(forces.magnitude[i] for i in system.chart)) / k.low, 8
    )
    elongation = np.where(np.isfinite(elongation) & (k.low > 0), elongation, np.inf)
    tight = elongation < 0.5 * rest.low
    longest = np.fmin(length, rounded_outward(rest.high + elongation))
    # How far the search extends beyond φ = ±π, which is more than where a turn is cut, and beyond
    # l = 0 as a share of the largest length.
    beyond = 2.0**-6
    shortest = np.maximum(-beyond * longest, -rounded_outward(elongation - rest.low))
    scale = np.where(tight, elongation, longest)
    scale = np.where(scale > 0, scale, 1.0)
    turn = np.full(shape, HALF_TURN + beyond)
    ends = np.where(tight, 1.0, -shortest / scale), np.ones(shape)
    others = [box[:, i] for i in range(balance.n) if i not in system.chart]
    return (
        np.stack([np.stack([turn, turn]), rounded_outward(np.stack(ends), 2), *others], axis=1),
        scale,
        tight,
    )


def _searched(system: Polar, given: FloatArray, sides: FloatArray, box: FloatArray) -> Roots:
    """All equilibria at points, as boxes of coordinates, by a search in the unknowns of a polar
    system.
    """
    found = certified_roots.search(system, sides, given, given)
    found = refined_in_digits(system, given, sides, found)
    found = found if system.turns else reduced_by_turns([0], found)
    prepared = system.prepared_at(given)
    possible, proved = _are_equilibria(system, found.ends)
    possible_boxes, _ = _are_equilibria(system, found.undecided)
    found = found.select(undecided=possible_boxes).reopened(proved, possible & ~proved)
    balance, point, undecided_point = system.balance, found.point, found.undecided_point
    roots = Roots.at(system.cartesian(found.ends, prepared[:, point]), point=point)
    # Narrower boxes may show on which side of the region's border a root lies.
    on_border = ~contractors.within(roots.ends, box[:, :, point])
    roots = refined(balance, given[:-1], roots, on_border)
    left = system.cartesian(found.undecided, prepared[:, undecided_point])
    return _apart(roots.with_undecided(left, undecided_point), box)


def _are_equilibria(system: Polar, ends: FloatArray) -> tuple[BoolArray, BoolArray]:
    """Boxes whose root may be an equilibrium, and boxes whose root is proved to be one.

    That is so by a positive length and, with a torsion spring, by an angle |φ| < π.
    """
    possible = np.ones((2, ends.shape[2]), dtype=bool)
    if system.turns:
        angle = Intervals(ends[:, 0])
        possible &= angle.mignitude <= HALF_TURN, angle.magnitude < np.pi
    if not system.tight:
        possible &= ends[1, 1] >= 0, ends[0, 1] < 0
    return possible[0], possible[0] & possible[1]


def _apart(found: Roots, box: FloatArray) -> Roots:
    """Roots in the region; those whose boxes meet another one or the border become undecided."""
    found = found.select(np.lexsort((-found.ends[0, 0], found.point)))
    found = found.select(~contractors.apart(found.ends, box[:, :, found.point]))
    roots, point = found.ends, found.point
    clear = contractors.within(roots, box[:, :, point])
    for first, second in certified_roots.neighbours(roots, point):
        meet = ~contractors.apart(roots[:, :, first], roots[:, :, second])
        clear[first[meet]] = clear[second[meet]] = False
    found = found.reopened(clear, ~clear)
    return found.select(
        undecided=~contractors.apart(found.undecided, box[:, :, found.undecided_point])
    )
