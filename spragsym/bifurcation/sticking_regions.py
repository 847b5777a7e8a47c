"""Regions of states in which several frictions hold where nothing moves, of forces that are linear
in the coordinates, with the contacts that touch.

With the coefficients μ_i = h_i μ_s,i and given normal forces N_i, the balance K q + b = Σ μ_i N_i
s_i makes of the box of shares h_i in [−1, 1] a parallelepiped of states: each coordinate is least
and largest at its middle less and plus the sizes of all edges along it. In the displacements that
friction opposes its measure is 2ᵐ |det(Sᵀ K⁻¹ S)| Π μ_s,i N_i, with the columns s_i of S.

Beside contacts that open, shares at which the gaps of a combination of these have the right signs
form a polytope in that box: a coordinate is least and largest at its corners. Those of combinations
that differ in one contact are one connected set where a corner of both has its gap at 0, at which
its force begins.

Where no force depends on a coordinate, as on a ramp, a column of K is 0 and one friction has one
share at all states: these form a line along that coordinate, which has no end.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np

from ..core.errors import ConvergenceError, ModelError
from ..models.forces import named, presses_either
from ..models.parameters import ParameterSet
from ..numerics.arithmetic import cofactor, determinant, is_zero
from ..numerics.interval_arrays import FloatArray, Intervals, quiet
from ..numerics.jets import Jet, constant, gradient, is_linear, variables
from ..numerics.vectors import TURN
from ..results.points import StickingStates
from ..statics.balance import Balance
from ..statics.forces import as_intervals
from ..statics.search import columns

#: An interval for the one point that is asked for.
ONE_POINT = (1,)


class NotLinear(ModelError):
    """Forces or gaps that are not linear in coordinates and friction coefficients."""


def region(p: ParameterSet) -> StickingStates:
    """All states in which every friction that can hold does, of scalar parameters; a
    :class:`NotLinear` error where forces and gaps are not linear in coordinates and friction
    coefficients.
    """
    parts = [_balanced(p, Balance(p.model, key)) for key in p.model.regimes]
    further = [] if parts[0].balance.opens else ["measure"]
    if not _is_pressed(parts[0].pressed):
        return _result(p, [], further)
    with quiet():
        sets = _connected({one.closed: one.corners() for one in parts})
        measures = [(abs(parts[0].measure()),)] if further else []
    if not sets:
        return _result(p, [], further)
    hulls = sorted(map(_hull, sets), key=lambda ends: float(ends[0, 0, 1, 0]))
    every = np.concatenate(hulls, axis=-1)
    return _result(
        p, [*((Intervals(low), Intervals(high)) for low, high in every), *measures], further
    )


@dataclass(frozen=True)
class _Corner:
    """A state at a corner of a polytope of shares, and the contacts whose gaps are 0 there."""

    q: list[Intervals]
    just_touching: frozenset[int]


def _hull(corners: Sequence[_Corner]) -> FloatArray:
    """Ends of the least and the largest of each coordinate, shape (n, 2, 2, 1)."""
    every = np.array([[part.ends for part in corner.q] for corner in corners])
    below, above = every[:, :, 0], every[:, :, 1]
    least, most = (below.max(0), above.min(0)), (below.min(0), above.max(0))
    return np.stack([np.stack(least, axis=1), np.stack(most, axis=1)], axis=1)


def _connected(corners: Mapping[frozenset[int], Sequence[_Corner]]) -> list[list[_Corner]]:
    """Corners of connected sets, from those of every combination of contacts that touch."""
    left, sets = {key for key, found in corners.items() if found}, list[list[_Corner]]()
    while left:
        open_, found = [left.pop()], list[_Corner]()
        while open_:
            key = open_.pop()
            found += corners[key]
            near = {key ^ {k} for corner in corners[key] for k in corner.just_touching} & left
            left -= near
            open_ += near
        sets.append(found)
    return sets


def line(p: ParameterSet) -> StickingStates | None:
    """All states in which the only friction holds, of scalar parameters, where no force depends on
    one of the coordinates; None where each has a force that does, or forces are not linear.
    """
    try:
        it = _balanced(p, Balance(p.model))
    except ModelError:
        return None
    n, ((none, whole),) = it.balance.n, it.coefficients
    free = [j for j in range(n) if all(is_zero(row[j]) for row in it.K)]
    if len(free) != 1:
        return None
    if not _is_pressed(it.pressed):
        return _result(p, [], [])
    with quiet():
        others = [j for j in range(n) if j not in free]
        A = [[*(it.K[r][j] for j in others), it.C[r][0] * (whole - none)] for r in range(n)]
        det = as_intervals(determinant(A), ONE_POINT)
        if det.holds_zero().any():
            return None
        found = _solution(A, det, [-force for force in it.forces])
    share = found.pop()
    if (share.low > 1).any() or (share.high < -1).any():
        return _result(p, [], [])
    if share.magnitude.max() > 1:
        raise ConvergenceError(
            "whether friction is at its limit or beyond it is not known; change a parameter"
        )
    reach = TURN / 2 if free[0] in it.balance.periodic else np.inf
    ends: list[tuple[Intervals, ...]] = [(one, one) for one in found]
    ends.insert(free[0], (Intervals.point(np.full(1, -reach)), Intervals.point(np.full(1, reach))))
    return _result(p, ends, [])


def is_convex(p: ParameterSet) -> bool:
    """Whether all states in which friction holds are proved to form one convex set, as where forces
    are linear: that in which the balance and |h_i| ≤ 1 hold, both linear in coordinates and shares.
    """
    try:
        it = _balanced(p, Balance(p.model))
        return not it.balance.opens and _is_pressed(it.pressed)
    except (ModelError, ConvergenceError):
        return False


@dataclass(frozen=True)
class _Balanced:
    """Forces K q + b + Σ (μ_i − μ_0,i) C_i of coordinates and friction coefficients, of which
    ``coefficients`` are, for each, that of no share used, μ_0, and that of all; gaps g + s q of
    contacts that open.
    """

    balance: Balance
    K: list[list[Any]]
    C: list[list[Any]]
    forces: list[Any]  #: b, with μ_0
    coefficients: list[tuple[Any, ...]]
    pressed: list[Intervals]  #: normal forces of the frictions that hold
    holding: list[int]  #: numbers of these frictions
    gaps: list[tuple[Any, list[Any]]]

    @property
    def closed(self) -> frozenset[int]:
        """Numbers of the contacts that open and touch."""
        return frozenset(k for k in self.balance.opens if self.balance.pushing[k])

    def _columns(self) -> list[list[Any]]:
        """C of the frictions that hold."""
        return [[row[i] for row in self.C] for i in self.holding]

    def _solutions(self) -> tuple[list[Intervals], list[list[Intervals]]]:
        """The state at which no share is used, and by how much each share moves it."""
        det = as_intervals(determinant(self.K), ONE_POINT)
        if det.holds_zero().any():
            raise ConvergenceError(
                "det K is 0, or too near to it: states of sticking form sets without an end; "
                "change a parameter"
            )
        middle = [-part for part in _solution(self.K, det, self.forces)]
        spans = [whole - none for none, whole in (self.coefficients[i] for i in self.holding)]
        edges = [
            _solution(self.K, det, [-part * span for part in column])
            for column, span in zip(self._columns(), spans, strict=True)
        ]
        return middle, edges

    def measure(self) -> Intervals:
        """Length, area or volume, with a sign, in the displacements that friction opposes."""
        _, edges = self._solutions()
        opposed = [
            [part / force for part in column]
            for column, force in zip(self._columns(), self.pressed, strict=True)
        ]
        products = [
            [sum(a * b for a, b in zip(one, edge, strict=True)) for edge in edges]
            for one in opposed
        ]
        return as_intervals(determinant(products), ONE_POINT) * 2 ** len(edges)

    def corners(self) -> list[_Corner]:
        """States at the corners of the polytope of shares at which this combination touches."""
        middle, edges = self._solutions()
        count = len(edges)
        # Sides a · h <= b, with the contact whose gap is 0 there.
        sides: list[tuple[list[Any], Any, int | None]] = [
            ([side * int(i == j) for j in range(count)], 1, None)
            for i in range(count)
            for side in (1, -1)
        ]
        for k, (value, slopes) in zip(self.balance.opens, self.gaps, strict=True):
            way = 1 if k in self.closed else -1
            row = [way * _product(slopes, edge) for edge in edges]
            sides.append((row, -way * (value + _product(slopes, middle)), k))
        found = list[_Corner]()
        for chosen in combinations(range(len(sides)), count):
            rows = [sides[c][0] for c in chosen]
            det = as_intervals(determinant(rows), ONE_POINT)
            if not det.magnitude.any():  # of parallel sides
                continue
            shares = _solution(rows, det, [sides[c][1] for c in chosen])
            slack = [
                as_intervals(most - _product(row, shares), ONE_POINT)
                for c, (row, most, _) in enumerate(sides)
                if c not in chosen
            ]
            if any((room.high < 0).all() for room in slack):
                continue
            if det.holds_zero().any() or any((room.low < 0).any() for room in slack):
                raise ConvergenceError(
                    "whether a contact touches where friction is at its limit is not known; change "
                    "a parameter"
                )
            q = [
                as_intervals(middle[j] + _product([edge[j] for edge in edges], shares), ONE_POINT)
                for j in range(self.balance.n)
            ]
            touching = (sides[c][2] for c in chosen)
            found.append(_Corner(q, frozenset(k for k in touching if k is not None)))
        return found


def _product(one: Sequence[Any], other: Sequence[Any]) -> Any:
    return sum(a * b for a, b in zip(one, other, strict=True))


def _balanced(p: ParameterSet, balance: Balance) -> _Balanced:
    p.model.require_answered("sticking_states")
    with quiet():
        values = balance.over(Intervals.point(columns(p, balance.parameters)))
        rows, gaps = _forces(balance, values)
        at = balance.at([Intervals(np.zeros((2, *ONE_POINT)))] * balance.n, values, ONE_POINT)
        holding = [one["name"] for one in p.model.frictions if one["holds"]]
        coefficients = [
            (at.call(named("friction_held", one), (), share) for share in (0, 1))
            if one in holding
            else (at.call(named("friction_at_speed", one), ()),) * 2
            for one in balance.rubbing
        ]
        numbers = [balance.contacts.index(one) for one in holding]
        normal = [
            abs(force) if presses_either(p.model.contacts[k]) else force
            for k in numbers
            for force in (as_intervals(at.contact_force(k, 1), ONE_POINT),)
        ]
        slopes = [gradient(row, balance.n + len(balance.rubbing)) for row in rows]
        pairs = [tuple(pair) for pair in coefficients]
        K, C = [row[: balance.n] for row in slopes], [row[balance.n :] for row in slopes]
        balanced = [
            constant(row) + sum(mid * C[r][i] for i, (mid, _) in enumerate(pairs))
            for r, row in enumerate(rows)
        ]
        distances = [(constant(gap), gradient(gap, balance.n)) for gap in gaps]
    numbers = [balance.rubbing.index(one) for one in holding]
    return _Balanced(balance, K, C, balanced, pairs, normal, numbers, distances)


def _solution(A: list[list[Any]], det: Intervals, right: list[Any]) -> list[Intervals]:
    """The solution of A x = right, by Cramer's rule."""
    rows = range(len(A))
    return [
        as_intervals(sum(cofactor(A, r, j) * right[r] for r in rows), ONE_POINT) / det for j in rows
    ]


def _is_pressed(forces: list[Intervals]) -> bool:
    """Whether all normal forces press."""
    if any((force.high <= 0).all() for force in forces):
        return False
    if any((force.low <= 0).all() for force in forces):
        raise ConvergenceError("the sign of a normal force is not known; change a parameter")
    return True


def _forces(balance: Balance, values: Mapping[str, Any]) -> tuple[list[Any], list[Any]]:
    """Forces, and gaps of contacts that open, as jets of coordinates and friction coefficients, in
    which they are linear, about 0 of both.
    """
    zeros = [Intervals(np.zeros((2, *ONE_POINT)))] * (balance.n + len(balance.rubbing))
    moved = variables(zeros, 2)
    rows, gaps = list[Any](), list[Any]()
    if not balance.springs:
        at = balance.at(moved[: balance.n], values, ONE_POINT)
        given = (*moved[balance.n :], *balance.pushing)
        rows = list(at.call("forces", at.q, *given, kind="statics"))
        gaps = [at.gap(k) for k in balance.opens]
    if not rows or not all(is_linear(it) for it in (*rows, *gaps) if isinstance(it, Jet)):
        raise NotLinear(
            f"forces of {balance.model.name} are not linear in coordinates and friction"
        )
    return rows, gaps


def _result(
    p: ParameterSet, ends: list[tuple[Intervals, ...]], further: list[str]
) -> StickingStates:
    """Enclosures of both ends of every coordinate and of ``further`` columns, or of nothing, as a
    result.
    """
    names = [f"{name}_{end}" for name in p.model.coordinates for end in ("low", "high")] + further
    every = [part for parts in ends for part in parts] or [Intervals(np.empty((2, 0)))] * len(names)
    finite = [one for one in every if np.isfinite(one.ends).all()]
    widths = [one.width / np.maximum(1.0, one.magnitude) for one in finite]
    error = np.max([np.zeros(every[0].shape), *widths], axis=0)
    return StickingStates(
        p, error, True, (), {name: one.middle for name, one in zip(names, every, strict=True)}
    )
