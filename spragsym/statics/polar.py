"""The balance around a spring's anchor, in the angle φ and the length l of the spring's line in
place of its end's coordinates.

Let the vector from the mass to the anchor be l (c, s), with (c, s) at the angle φ (from the angle
at rest, where a torsion spring resists turning), let T be the tension of the spring, and A_x, A_y
the sums of all other forces, on the side of the balance. Then

    along the line:                 A_x c + A_y s − T = 0,
    across the line:                A_y c − A_x s = 0.

A stiff spring with little else to hold the mass has near-equilibria on the whole circle of its
undeformed length, which is straight here; with the elongation l − r for an unknown, the tension k
(l − r) is no difference of two large forces. At the anchor, where x and y do not say the direction,
φ does.

A torsion spring pulls across its line with k_t φ/l, which has no bound at the anchor. There the
balance

    across the line, times l:       l (A_y c − A_x s) − k_t φ = 0

is smooth at l = 0, too. A third coordinate z, by which the vector changes by (a, b), has A_z + T (c
a + s b) + (c b − s a) k_t φ/l = 0, where the balance across gives k_t φ/l = A_y c − A_x s. For l >
0 these equations have the same roots as the balance of forces, since the one are regular
combinations of the other; so exclusion and interval Newton decide there as anywhere else.

What a root of them means:

- l > 0, and with a torsion spring −π < φ < π: an equilibrium.
- l < 0: none, since the line's angle is another one there.
- l = 0: none. These are two equations for φ alone; the page's energy has no derivative at the
  anchor, with a torsion spring no value. At such parameters an equilibrium arrives at the anchor
  and is no more.
- |φ| > π with a torsion spring: none, since φ is the least turning. At φ = ±π the energy has a
  ridge: its slopes on both sides, ∓k_t π, lead away.

So a search goes a little beyond l = 0 and |φ| = π; roots that are proved to lie there are dropped,
and those that can't be told from one on the border are undecided.
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
    """The balance along and across a spring's line; unknowns are φ, the length, and the other
    coordinates.

    The unknown for the length is l over a scale, or where the spring is so stiff that l stays
    beyond half of its undeformed length, the elongation over a scale (``tight``). The scale is one
    more parameter, the last. ``turns`` where a torsion spring resists φ.
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
        """Identity of the balance, and the chart."""
        return self.balance.identity(), self.spring, self.chart, self.turns, self.tight

    def prepared(self, bounds: Intervals) -> Intervals:
        """Prepared parameters of the balance, with the scale last."""
        return Intervals(
            np.concatenate([self.balance.prepared(bounds[:-1]).ends, bounds[-1:].ends], axis=1)
        )

    def at(
        self, q: Sequence[Any], values: Values, shape: Shape = (), xp: object = XP
    ) -> Evaluation:
        """The state with φ as its turning."""
        nowhere = self.balance.at((), values, shape, xp)
        angle, part, *others = q
        cosine, sine = nowhere.xp.cos(angle), nowhere.xp.sin(angle)
        c0, s0 = nowhere.at_rest[0] if self.turns else (1, 0)
        c, s = cosine * c0 - sine * s0, sine * c0 + cosine * s0
        q = list(nowhere.q)
        for number, value in zip(
            (i for i in range(self.balance.n) if i not in self.chart), others, strict=True
        ):
            q[number] = value
        *anchor, rest = replace(nowhere, q=q).geometry[self.spring]
        length = part * values[SCALE] + rest if self.tight else part * values[SCALE]
        for number, end, share in zip(self.chart, anchor, (c, s), strict=True):
            q[number] = -(length * share) + end
        at = replace(nowhere, q=q)
        lines = [
            (c, s, length) if number == self.spring else at.direction(dx, dy)
            for number, (dx, dy, _) in enumerate(at.geometry)
        ]
        at.fixed = self.rotated(itertools.chain(*lines), angle)
        return at

    def rotated(self, directions: Iterable[Any], angle: Number) -> list[Any]:
        """Directions with the angle behind by which the torsion spring turns; without stiffness it
        does not matter.
        """
        return [*directions, *(angle if self.turns else 0 for _ in self.balance.torsions)]

    def conditions(self, at: Evaluation, unknowns: Sequence[Any]) -> list[Any]:
        """Balance along, and across times l, in the rows of the line's end; of the other
        coordinates.
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
                out[row] = (
                    forces[row]
                    + tension * (c * a[row] + s * b[row])
                    + (c * b[row] - s * a[row]) * across
                )
        return out

    def other_forces(self, at: Evaluation) -> list[Any]:
        """All but those of this line."""
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
        """Boxes beyond the contact's border, and boxes with no coordinates that balance the forces
        of their directions.
        """
        at = self.state(unknowns, parameters)
        return at.beside_border()[1] | np.logical_or.reduce(
            width_of(self.balance.with_directions(at)) < 0
        )

    def cartesian(self, ends: FloatArray, parameters: Intervals) -> FloatArray:
        """Boxes that hold the coordinates."""
        return stacked(self.state(Intervals(ends), parameters).q, ends.shape[2:]).ends


def end_slopes(at: Evaluation, near: Number = 0) -> list[tuple[list[Any], list[Any]]]:
    """Derivatives of the vector of every spring by the coordinates: for ends that are linear in
    them the same everywhere.
    """
    n = at.balance.n
    rows = replace(at, q=jets.variables([near] * n, 1), xp=XP).geometry
    return [(jets.gradient(dx, n), jets.gradient(dy, n)) for dx, dy, _ in rows]


def ends_are_linear(balance: Balance, given: FloatArray) -> bool:
    """Whether the ends of all springs are linear in the coordinates."""
    at = balance.at((), balance.over(Intervals.point(given)))
    slopes = end_slopes(at, Intervals.between(np.array([-2.0]), np.array([3.0])))
    every = [entry for pair in slopes for row in pair for entry in row]
    return bool((stacked(every, (1,)).width < 1e-12).all()) if every else True


def turned_points(
    balance: Balance, given: FloatArray, regions: FloatArray
) -> tuple[Roots, BoolArray]:
    """Roots and undecided boxes of points with a torsion spring, and which points these are.

    A model with torsion springs along several lines, or along one whose first end is not at two
    coordinates, has none of them. ``given`` are parameters, shape (parameters, points), and
    ``regions`` have the shape (2, n, points).
    """
    done = np.zeros(given.shape[1], dtype=bool)
    system = (
        _system(balance, given, balance.torsions[0], True) if len(balance.torsions) == 1 else None
    )
    if system is None:
        return Roots.none(balance.n), done
    done = _stiffnesses(balance, given, "torsions").low[0] > 0
    return _of_points(system, given, regions, np.flatnonzero(done)), done


def stiff_points(
    balance: Balance, given: FloatArray, regions: FloatArray
) -> tuple[Roots, BoolArray]:
    """Roots of points with a stiff spring that are decided around one of the springs, and which
    points these are.
    """
    # In lift-off, where nothing else may hold the mass across, the line of a single spring is the
    # better guide however soft it is.
    least = 0.0 if balance.springs == 1 and not balance.contact else balance.options.stiff
    stiff = _stiffnesses(balance, given).high.max(axis=0, initial=0.0) > least
    return _of_any_spring(balance, given, regions, np.flatnonzero(stiff))


def around_anchors(balance: Balance, given: FloatArray, regions: FloatArray, found: Roots) -> Roots:
    """Boxes that a search has left, as along circles around anchors, decided in polar coordinates
    where that succeeds.
    """
    again, done = _of_any_spring(balance, given, regions, np.unique(found.undecided_point))
    return found.of(np.flatnonzero(done), others=True).concatenated(again)


def _stiffnesses(balance: Balance, given: FloatArray, name: str = "stiffnesses") -> Intervals:
    """Stiffnesses of all springs, or for ``"torsions"`` of all torsion springs, shape (springs,
    points).
    """
    with quiet():
        return stacked(
            balance.at((), balance.over(Intervals.point(given))).of_springs(name), given.shape[1:]
        )


def _of_any_spring(
    balance: Balance, given: FloatArray, box: FloatArray, points: IntArray
) -> tuple[Roots, BoolArray]:
    """Roots of the points of which all is decided around one of the springs, and which these
    are.
    """
    done, roots = np.zeros(given.shape[1], dtype=bool), Roots.none(balance.n)
    if balance.torsions:
        points = points[_stiffnesses(balance, given[:, points], "torsions").high.max(axis=0) <= 0]
    for spring in range(balance.springs):
        points = points[~done[points]]
        system = _system(balance, given, spring, False) if points.size else None
        if system is not None:
            found = _of_points(system, given, box, points)
            decided = np.setdiff1d(points, found.undecided_point)
            roots = roots.concatenated(found.of(decided))
            done[decided] = True
    return roots, done


def _system(balance: Balance, given: FloatArray, spring: int, turns: bool) -> Polar | None:
    """The system around a spring; None where it has no chart."""
    names = balance.model.about["springs"][spring]["chart"]
    if names is None or not ends_are_linear(balance, given):
        return None
    x, y = (balance.coordinates.index(name) for name in names)
    return Polar(balance, spring, (x, y), turns, False)


def _of_points(system: Polar, given: FloatArray, box: FloatArray, points: IntArray) -> Roots:
    """Roots and undecided boxes of some points, by their numbers."""
    given, box, roots = given[:, points], box[:, :, points], Roots.none(system.balance.n)
    with quiet():
        sides, scale, narrow = _sides(system, given, box)
        for tight in (False, True):
            some = np.flatnonzero(narrow == tight)
            if some.size:
                columns = np.concatenate([given[:, some], scale[None, some]])
                found = _searched(
                    replace(system, tight=tight), columns, sides[:, :, some], box[:, :, some]
                )
                roots = roots.concatenated(found.numbered(points[some]))
    return roots


def _sides(
    system: Polar, given: FloatArray, box: FloatArray
) -> tuple[FloatArray, FloatArray, BoolArray]:
    """For each point the region in the unknowns, the scale, and whether the length stays away from
    0.
    """
    balance, shape = system.balance, given.shape[1:]
    nowhere = balance.at((), balance.over(Intervals.point(given)), shape)
    k = as_intervals(nowhere.of_springs("stiffnesses")[system.spring], shape)
    q = [0 if i in system.chart else Intervals(box[:, i]) for i in range(balance.n)]
    *anchor, rest = stacked(replace(nowhere, q=q).geometry[system.spring], shape)
    reach = [
        np.maximum(*rounded_outward(box[:, i] + end.ends[::-1]))
        for i, end in zip(system.chart, anchor, strict=True)
    ]
    length = rounded_outward(np.hypot(*reach), 4)
    # Along the line the tension balances all else.
    whole = replace(nowhere, q=list(Intervals(box)))
    directions = system.rotated(whole.directions[: 3 * balance.springs], 0)
    forces = stacked(system.other_forces(replace(whole, fixed=directions)), shape)
    # More than it can be, so that no tension lies on the border of the region.
    most = (1.0 + 2.0**-10) * rounded_outward(
        np.hypot(*(forces.magnitude[i] for i in system.chart)) / k.low, 8
    )
    most = np.where(np.isfinite(most) & (k.low > 0), most, np.inf)
    tight = most < 0.5 * rest.low
    longest = np.fmin(length, rounded_outward(rest.high + most))
    # What is searched beyond φ = ±π, more than where a turn is cut, and beyond l = 0 in
    # parts of the largest length.
    beyond = 2.0**-6
    shortest = np.maximum(-beyond * longest, -rounded_outward(most - rest.low))
    scale = np.where(tight, most, longest)
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
    """All roots of points, as boxes of coordinates."""
    found = certified_roots.search(system, sides, given, given)
    found = refined_in_digits(system, given, sides, found)
    found = found if system.turns else reduced_by_turns([0], found)
    prepared = system.prepared_at(given)
    possible, sure = _are_equilibria(system, found.ends)
    found = found.select(undecided=_are_equilibria(system, found.undecided)[0]).reopened(
        sure, possible & ~sure
    )
    balance, point, undecided_point = system.balance, found.point, found.undecided_point
    roots = Roots.at(system.cartesian(found.ends, prepared[:, point]), point=point)
    # On which side of the border a root lies that floats can't tell from it, digits do.
    on_border = ~contractors.within(roots.ends, box[:, :, point])
    roots = refined(balance, given[:-1], roots, on_border)
    left = system.cartesian(found.undecided, prepared[:, undecided_point])
    return _apart(roots.with_undecided(left, undecided_point), box)


def _are_equilibria(system: Polar, ends: FloatArray) -> tuple[BoolArray, BoolArray]:
    """Boxes that may hold an equilibrium; and those of which lengths are proved to be positive,
    angles those of least turning.
    """
    possible = np.ones((2, ends.shape[2]), dtype=bool)
    if system.turns:
        angle = Intervals(ends[:, 0])
        possible &= angle.mignitude <= HALF_TURN, angle.magnitude < np.pi
    if not system.tight:
        possible &= ends[1, 1] >= 0, ends[0, 1] < 0
    return possible[0], possible[0] & possible[1]


def _apart(found: Roots, box: FloatArray) -> Roots:
    """Roots of the region, each in a box of its own; those in boxes that meet are among what is
    left.
    """
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
