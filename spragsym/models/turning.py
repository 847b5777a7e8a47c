"""Equilibria of a model with a torsion spring, in the angle φ by which the spring's line has turned, and the line's length l.

A torsion spring pulls across its line with k_t φ/l, which has no bound at the anchor. Let the vector from the mass to the anchor be
l (c, s), with (c, s) at the angle rest + φ, let T be the tension of a spring along the line, and A_x, A_y the sums of all other
forces, on the side of the balance. Then the balance

    along the line:                 A_x c + A_y s − T = 0,
    across the line, times l:       l (A_y c − A_x s) − k_t φ = 0

is smooth at l = 0, too. A third coordinate z, by which the vector changes by (a, b), has A_z + T (c a + s b) + (c b − s a) k_t φ/l = 0,
where the balance across gives k_t φ/l = A_y c − A_x s. For l > 0 these equations have the same roots as the balance of forces, since
the one are regular combinations of the other; so exclusion and interval Newton decide there as anywhere else.

What a root of them means:

- l > 0 and −π < φ < π: an equilibrium.
- l < 0: none, since the spring's angle is another one there.
- l = 0: none. Then φ = 0 and −k r = A_x c + A_y s with the undeformed length r, two equations for no unknown; the page's energy has no
  value at the anchor. At such parameters an equilibrium arrives at the anchor and is no more.
- |φ| > π: none, since φ is the least turning. At φ = ±π the energy has a ridge: its slopes on both sides, ∓k_t π, lead away.

So the search goes a little beyond l = 0 and |φ| = π; it drops roots that are proved to lie there, and lists as undecided those that
can't be told from one on the border.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..exact import ball_functions, boxes, certified_roots, contractors, jets
from ..exact.certified_roots import Roots
from ..exact.interval_arrays import FloatArray, Intervals, raised, stacked
from ..exact.interval_functions import cos, sin
from ..exact.interval_functions import length as interval_length
from ..exact.reduction import Evaluate
from .balance import Balance, matrix, undecorated
from .directions import direction
from .laws import XP
from .polar import ends_are_linear, end_slopes
from .precise import PreciseBalance, ball, of_each, precise_forces, settled_by_digits
from .refined import refined

#: What is searched beyond φ = ±π, and beyond l = 0 in parts of the largest length.
BEYOND = 2.0**-6
#: Upper bound of π.
HALF_TURN = 3.1415926535897936
#: By what the tension may be larger than it can be, so that none lies on the border of the region.
ROOM = 1.0 + 2.0**-10
#: Bound, in units of 2⁻⁵² relative, on the error of NumPy's arctangent.
ARCTAN_ULPS = 8.0
#: Steps of interval Newton on lengths that are small parts of the largest one.
STEPS = 6


@dataclass(frozen=True)
class _Kind:
    """A kind of numbers: namespace of generated functions, cosine and sine, direction and length of a vector."""

    xp: Any
    turn: Callable[[Any], tuple[Any, Any]]
    direction: Callable[[Any, Any], tuple[Any, Any, Any]]


def _over_boxes(shape: tuple[int, ...]) -> _Kind:
    return _Kind(
        XP,
        lambda angle: (angle.cos(), angle.sin()) if isinstance(angle, jets.Jet) else (cos(angle), sin(angle)),
        lambda dx, dy: direction(dx, dy, shape),
    )


def _quotients(dx: Any, dy: Any) -> tuple[Any, Any, Any]:
    length = ball_functions.XP.sqrt(dx * dx + dy * dy)
    return dx / length, dy / length, length


_BALLS = _Kind(ball_functions.XP, ball_functions.cosine_and_sine, _quotients)


@dataclass(frozen=True)
class Turning(boxes.Plain):
    """The balance along and across a line with a torsion spring; unknowns are φ, the length, and the other coordinates.

    The unknown for the length is l over a scale, or where the spring is so stiff that l stays beyond half of its undeformed length,
    the elongation over a scale (``tight``). The scale is one more parameter, the last.
    """

    balance: Balance
    spring: int
    chart: tuple[int, int]
    tight: bool

    def prepared(self, bounds: Intervals) -> Intervals:
        """As for the balance, with the scale behind."""
        return Intervals(np.concatenate([self.balance.prepared(bounds[:-1]).ends, bounds[-1:].ends], axis=1))

    def place(self, unknowns: Sequence[Any], values: Mapping[str, Any], scale: Any, kind: _Kind) -> tuple[list[Any], list[Any], Any]:
        """Coordinates, directions and lengths with φ behind, and the elongation."""
        angle, part, *others = unknowns
        cosine, sine = kind.turn(angle)
        c0, s0 = self._at_rest(values, kind)
        c, s = cosine * c0 - sine * s0, sine * c0 + cosine * s0
        q: list[Any] = [0] * self.balance.n
        for number, value in zip((i for i in range(self.balance.n) if i not in self.chart), others, strict=True):
            q[number] = value
        *anchor, rest = self.geometry(q, values, kind)[self.spring]
        far = part * scale
        length, elongation = (far + rest, far) if self.tight else (far, far - rest)
        for number, end, share in zip(self.chart, anchor, (c, s), strict=True):
            q[number] = -(length * share) + end
        directions: list[Any] = []
        for number, (dx, dy, _) in enumerate(self.geometry(q, values, kind)):
            directions += [c, s, length] if number == self.spring else kind.direction(dx, dy)
        return q, [*directions, angle], elongation

    def geometry(self, q: Sequence[Any], values: Mapping[str, Any], kind: _Kind) -> Any:
        """Vectors and undeformed lengths of all lines."""
        return undecorated(self.balance.model.statics.geometry)(*q, *self._given(values), xp=kind.xp)

    def _at_rest(self, values: Mapping[str, Any], kind: _Kind) -> tuple[Any, Any]:
        """Cosine and sine of the angle at rest: the line along x has turned by minus that angle."""
        balance = self.balance
        function = undecorated(balance.model.statics.turnings)
        ((cosine, sine),) = function(*[0] * balance.n, *[1, 0, 1] * balance.springs, *self._given(values), xp=kind.xp)
        return cosine, -sine

    def _given(self, values: Mapping[str, Any]) -> list[Any]:
        return [values[name] for name in self.balance.model.about["arguments"]["statics"]]

    def stiffnesses(self, values: Mapping[str, Any], kind: _Kind) -> tuple[Sequence[Any], Any]:
        """Of all springs along their lines, and of the torsion spring."""
        statics, none = self.balance.model.statics, [0] * self.balance.n
        (turning,) = undecorated(statics.torsions)(*none, *self._given(values), xp=kind.xp)
        return undecorated(statics.stiffnesses)(*none, *self._given(values), xp=kind.xp), turning

    def rows(self, unknowns: Sequence[Any], values: Mapping[str, Any], scale: Any, kind: _Kind) -> list[Any]:
        """Balance along, and across times l, in the rows of the line's end; of the other coordinates."""
        return self.rows_at(*self.place(unknowns, values, scale, kind), values, kind)

    def rows_at(
        self, q: Sequence[Any], directions: Sequence[Any], elongation: Any, values: Mapping[str, Any], kind: _Kind
    ) -> list[Any]:
        """The same in a place with directions."""
        stiffnesses, turning = self.stiffnesses(values, kind)
        c, s, length = directions[3 * self.spring : 3 * self.spring + 3]
        forces = self.other_forces(q, directions, values, stiffnesses, kind)
        x, y = self.chart
        tension, across = elongation * stiffnesses[self.spring], forces[y] * c - forces[x] * s
        out = list(forces)
        out[x], out[y] = forces[x] * c + forces[y] * s - tension, length * across - directions[-1] * turning
        if self.balance.n > 2:
            a, b = end_slopes(self.balance, self._given(values))[self.spring]
            for row in set(range(self.balance.n)) - set(self.chart):
                out[row] = forces[row] + tension * (c * a[row] + s * b[row]) + (c * b[row] - s * a[row]) * across
        return out

    def other_forces(
        self, q: Sequence[Any], directions: Sequence[Any], values: Mapping[str, Any], stiffnesses: Sequence[Any], kind: _Kind
    ) -> list[Any]:
        """All but those of this line."""
        forces = list(self.balance.call("forces_apart", q, directions, values, kind.xp))
        if self.balance.springs == 1:
            return forces
        rests = [row[2] for row in self.geometry(q, values, kind)]
        slopes = end_slopes(self.balance, self._given(values))
        for place, (k, rest, (a, b)) in enumerate(zip(stiffnesses, rests, slopes, strict=True)):
            if place != self.spring:
                c, s, length = directions[3 * place : 3 * place + 3]
                tension = (length - rest) * k
                forces = [force + tension * (c * a[row] + s * b[row]) for row, force in enumerate(forces)]
        return forces

    # ------------------------------------------------------------------------------------------ over boxes

    def _taken(self, unknowns: Sequence[Any], parameters: Intervals) -> tuple[Sequence[Any], Mapping[str, Any], Any, _Kind]:
        return unknowns, self.balance.arguments(parameters), parameters[-1], _over_boxes(parameters.shape[1:])

    def residuals(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """The equations over boxes."""
        return stacked(self.rows(*self._taken(list(unknowns), parameters)), parameters.shape[1:])

    def jacobian(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Their slopes."""
        rows = self.rows(*self._taken(jets.variables(list(unknowns), 1), parameters))
        return matrix([jets.gradient(row, self.balance.n) for row in rows], parameters.shape[1:])

    def hopeless(self, unknowns: Intervals, parameters: Intervals) -> NDArray[np.bool_]:
        """Boxes beyond the contact's border."""
        _, values, scale, kind = self._taken(list(unknowns), parameters)
        q, _, _ = self.place(list(unknowns), values, scale, kind)
        return self.balance.beyond_border(q, values, parameters.shape[1:])

    def contracted(self, unknowns: Intervals, parameters: Intervals) -> FloatArray:
        """Smaller boxes: the coordinates that balance the forces with these directions, and the directions towards these.

        A stiff straight guide is thin in the coordinates, and bent in angle and length.
        """
        _, values, scale, kind = self._taken(list(unknowns), parameters)
        q, directions, elongation = self.place(list(unknowns), values, scale, kind)
        shape = parameters.shape[1:]
        places = stacked(q, shape)
        places = Intervals(self.balance.with_directions(places, values, directions))
        rows = stacked(self.rows_at(list(places), directions, elongation, values, kind), shape)
        empty = ~np.logical_and.reduce(rows.holds_zero()) | np.logical_or.reduce(places.ends[0] + places.ends[1] < 0)
        ends = self._towards(places, unknowns, values, scale, kind)
        ends[:, :, empty] = -1.0
        return ends

    def _towards(self, places: Intervals, unknowns: Intervals, values: Mapping[str, Any], scale: Any, kind: _Kind) -> FloatArray:
        """Boxes that hold the angles and lengths of places among the given ones, where lengths are positive."""
        dx, dy, rest = self.geometry(list(places), values, kind)[self.spring]
        c0, s0 = self._at_rest(values, kind)
        cosine, sine = kind.turn(Intervals.point(unknowns[0].middle))
        c, s = cosine * c0 - sine * s0, sine * c0 + cosine * s0
        along, across = dx * c + dy * s, dy * c - dx * s
        lengths = interval_length(dx, dy)
        part = ((lengths - rest) if self.tight else lengths) / scale
        # What the tangent is known of turns by less than a quarter from the middle of the box.
        slope = (across / along).ends
        turned = raised(np.arctan(slope), ARCTAN_ULPS) + np.stack([-unknowns[0].middle, unknowns[0].middle])
        ahead = (self._length(unknowns[1], rest, scale).low > 0) & (along.low > 0) & (unknowns[0].width < 3)
        ends = unknowns.ends.copy()
        ends[:, 0] = np.where(ahead, np.fmin(raised(turned), ends[:, 0]), ends[:, 0])
        ends[:, 1] = np.where(ahead, np.fmin(part.ends, ends[:, 1]), ends[:, 1])
        return ends

    def _length(self, part: Any, rest: Any, scale: Any) -> Any:
        return part * scale + rest if self.tight else part * scale

    def cartesian(self, ends: FloatArray, parameters: Intervals) -> FloatArray:
        """Boxes that hold the coordinates."""
        q, _, _ = self.place(*self._taken(list(Intervals(ends)), parameters))
        return stacked(q, ends.shape[2:]).ends

    def precise(self, given: FloatArray, bits: int) -> Evaluate:
        """The equations of balls."""
        values, scale = PreciseBalance(self.balance, given[:-1], bits).values, ball(float(given[-1]), bits)
        return lambda unknowns: self.rows(unknowns, values, scale, _BALLS)


def covered(balance: Balance) -> tuple[int, tuple[int, int]] | None:
    """Number and chart of the one line that a torsion spring turns with; None for a model that is not searched in this way."""
    torsions = balance.model.about.get("torsions", ())
    if len(torsions) != 1 or (balance.contact and not balance.model.about["contact"].get("polynomial")):
        return None
    spring = torsions[0]["spring"]
    chart = balance.model.about["springs"][spring]["chart"]
    return None if chart is None else (spring, (balance.coordinates.index(chart[0]), balance.coordinates.index(chart[1])))


def turned_points(balance: Balance, given: FloatArray, regions: FloatArray) -> tuple[Roots, NDArray[np.bool_]]:
    """Roots and undecided boxes of points whose torsion spring is there, and which points these are.

    Parameters
    ----------
    given : ndarray
        Parameters, shape (parameters, points).
    regions : ndarray
        Shape (2, n, points) or (2, n, 1).
    """
    line, around = covered(balance), of_each(regions, given)
    done = np.zeros(given.shape[1], dtype=np.bool_)
    if line is None or not ends_are_linear(balance, given):
        return certified_roots.concatenated([], balance.n), done
    loose, tight = (Turning(balance, *line, kind) for kind in (False, True))
    with np.errstate(all="ignore"):
        done, sides, scale, narrow = _sides(loose, given, around)
    parts = []
    for system, chosen in ((loose, done & ~narrow), (tight, done & narrow)):
        points = np.flatnonzero(chosen)
        if points.size:
            columns = np.concatenate([given[:, points], scale[None, points]])
            found = _searched(system, columns, sides[:, :, points], around[:, :, points])
            parts.append(replace(found, point=points[found.point], left_point=points[found.left_point]))
    return certified_roots.concatenated(parts, balance.n), done


def _sides(
    system: Turning, given: FloatArray, around: FloatArray
) -> tuple[NDArray[np.bool_], FloatArray, FloatArray, NDArray[np.bool_]]:
    """Of each point: whether it has a torsion spring, the region in the unknowns, the scale, and whether the length stays away from 0."""
    balance, shape = system.balance, given.shape[1:]
    values = balance.arguments(balance.prepared(Intervals.point(given)))
    kind = _over_boxes(shape)
    stiffnesses, turning = system.stiffnesses(values, kind)
    k, twist = stacked([stiffnesses[system.spring], turning], shape)
    q: list[Any] = [0 if i in system.chart else Intervals(around[:, i]) for i in range(balance.n)]
    *anchor, rest = stacked(system.geometry(q, values, kind)[system.spring], shape)
    reach = [np.maximum(*raised(around[:, i] + end.ends[::-1])) for i, end in zip(system.chart, anchor, strict=True)]
    length = raised(np.hypot(*reach), 4)
    # Along the line the tension balances all else.
    whole = list(Intervals(around))
    directions = [*balance.directions(whole, values, shape)[: 3 * balance.springs], Intervals.between(-np.full(shape, 4.0), 4.0)]
    forces = stacked(system.other_forces(whole, directions, values, stiffnesses, kind), shape)
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
    sides = np.stack([np.stack([turn, turn]), raised(np.stack(ends), 2), *others], axis=1)
    return twist.low > 0, sides, scale, tight


def _searched(system: Turning, given: FloatArray, sides: FloatArray, around: FloatArray) -> Roots:
    """All roots of points, as boxes of coordinates."""
    with np.errstate(all="ignore"):
        outcome = boxes.search(system, sides, given, given)
        found = certified_roots.roots(system, outcome, sides, given, given)
        found = replace(found, ends=refined(system, given, found.ends, found.point, system.precise))
        found = settled_by_digits(system, given, sides, found, system.precise)
        prepared = system.prepared(Intervals.point(given))
        ends = found.ends if system.tight else _sharpened(system, found.ends, prepared[:, found.point])
        roots, unclear, point, unclear_point = _equilibria(system, ends, found.point)
        left, left_point, _, _ = _possible(system, found.left, found.left_point)
        left = np.concatenate([left, unclear], axis=2)
        left_point = np.concatenate([left_point, unclear_point])
        balance = system.balance
        roots = system.cartesian(roots, prepared[:, point])
        roots = refined(balance, given[:-1], roots, point, precise_forces(balance))
        left = system.cartesian(left, prepared[:, left_point])
    return _apart(roots, point, left, left_point, around)


def _possible(system: Turning, ends: FloatArray, point: NDArray[np.int64]) -> tuple[FloatArray, NDArray[np.int64], FloatArray, FloatArray]:
    """Boxes that may hold an equilibrium, their points, and by how much φ and l lie inside of their borders at least."""
    turn, length = Intervals(ends[:, 0]), Intervals(ends[:, 1])
    shortest = np.full(point.size, -np.inf) if system.tight else 0.0
    keep = (turn.mignitude <= HALF_TURN) & (length.high >= shortest)
    return ends[:, :, keep], point[keep], (np.pi - turn.magnitude)[keep], (length.low - shortest)[keep]


def _equilibria(
    system: Turning, ends: FloatArray, point: NDArray[np.int64]
) -> tuple[FloatArray, FloatArray, NDArray[np.int64], NDArray[np.int64]]:
    """Roots that are equilibria, roots of which that is not known, and the points of both."""
    ends, point, turned, length = _possible(system, ends, point)
    sure = (turned > 0) & (length > 0)
    return ends[:, :, sure], ends[:, :, ~sure], point[sure], point[~sure]


def _sharpened(system: Turning, ends: FloatArray, parameters: Intervals) -> FloatArray:
    """Roots known to more digits: a length that is a small part of the scale to as many as a large one."""
    for _ in range(STEPS):
        box = Intervals(ends)
        middle = box.middle
        reach = np.maximum(*raised(ends + np.stack([middle, -middle])))
        step = contractors.newton(system.at_points(middle, parameters), system.jacobian(box, parameters), middle, reach)
        ends = np.fmin(step.ends, ends)
    return ends


def _apart(roots: FloatArray, point: NDArray[np.int64], left: FloatArray, left_point: NDArray[np.int64], around: FloatArray) -> Roots:
    """Roots of the region, each in a box of its own; those in boxes that meet are among what is left."""
    order = np.lexsort((-roots[0, 0], point))
    roots, point = roots[:, :, order], point[order]
    inside = ~contractors.apart(roots, around[:, :, point])
    roots, point = roots[:, :, inside], point[inside]
    clear = contractors.within(roots, around[:, :, point])
    for shift in range(1, point.size):
        near = (point[shift:] == point[:-shift]) & (roots[1, 0, :-shift] >= -roots[0, 0, shift:])
        if not near.any():
            break
        first = np.flatnonzero(near)
        meet = first[~contractors.apart(roots[:, :, first], roots[:, :, first + shift])]
        clear[meet] = clear[meet + shift] = False
    left = np.concatenate([left, roots[:, :, ~clear]], axis=2)
    left_point = np.concatenate([left_point, point[~clear]])
    possible = ~contractors.apart(left, around[:, :, left_point])
    ends = roots[:, :, clear]
    return Roots(ends, ends, point[clear], left[:, :, possible], left_point[possible])
