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
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from ..numerics import boxes, jets
from ..numerics.balls import XP as BALLS
from ..numerics.balls import ball
from ..numerics.interval_arrays import BoolArray, FloatArray, Intervals, Shape, raised, stacked
from ..numerics.interval_arrays import length as interval_length
from ..numerics.precise_roots import Digits
from .mechanics.balance import Balance
from .mechanics.directions import direction, quotients
from .mechanics.forces import Values
from .mechanics.laws import XP
from .mechanics.precise_balance import PreciseBalance

#: Bound, in units of 2⁻⁵² relative, on the error of NumPy's arctangent.
ARCTAN_ULPS = 8.0


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
