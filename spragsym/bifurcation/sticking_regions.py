"""Regions of states in which several frictions hold where nothing moves, of forces that are linear
in the coordinates.

With the coefficients μ_i = h_i μ_s,i and given normal forces N_i, the balance K q + b = Σ μ_i N_i
s_i makes of the box of shares h_i in [−1, 1] a parallelepiped of states: each coordinate is least
and largest at its middle less and plus the sizes of all edges along it. In the displacements that
friction opposes its measure is 2ᵐ |det(Sᵀ K⁻¹ S)| Π μ_s,i N_i, with the columns s_i of S.

Where no force depends on a coordinate, as on a ramp, a column of K is 0 and one friction has one
share at all states: these form a line along that coordinate, which has no end.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..core.errors import ConvergenceError, ModelError
from ..models.forces import named, presses_either
from ..models.parameters import ParameterSet
from ..numerics.arithmetic import cofactor, determinant, is_zero
from ..numerics.interval_arrays import Intervals, quiet
from ..numerics.jets import Jet, constant, gradient, variables
from ..numerics.vectors import TURN
from ..results.points import StickingStates
from ..statics.balance import Balance
from ..statics.forces import as_intervals
from ..statics.search import columns

#: An interval for the one point that is asked for.
ONE_POINT = (1,)


def region(p: ParameterSet) -> StickingStates:
    """All states in which every friction that can hold does, of scalar parameters; a
    :class:`ModelError` where the forces are not linear in coordinates and friction coefficients.
    """
    it = _balanced(p)
    balance, K, C, pressed = it.balance, it.K, it.C, it.pressed
    n, holding = balance.n, [one["name"] for one in p.model.frictions if one["holds"]]
    if not _is_pressed(pressed):
        return _result(p, [], ["measure"])
    with quiet():
        det = as_intervals(determinant(K), ONE_POINT)
        if det.holds_zero().any():
            raise ConvergenceError(
                "det K is 0, or too near to it: states of sticking form sets without an end; "
                "change a parameter"
            )
        middle = [-part for part in _solution(K, det, it.forces)]
        edges, opposed = list[list[Intervals]](), list[list[Any]]()
        for i, ((none, whole), name) in enumerate(
            zip(it.coefficients, balance.rubbing, strict=True)
        ):
            if name in holding:
                column = [C[r][i] for r in range(n)]
                edges.append([part * (whole - none) for part in _solution(K, det, column)])
                opposed.append([-part / pressed[holding.index(name)] for part in column])
        reach = [sum((abs(edge[j]) for edge in edges), middle[j] * 0) for j in range(n)]
        products = [
            [sum(a * b for a, b in zip(one, edge, strict=True)) for edge in edges]
            for one in opposed
        ]
        measure = abs(as_intervals(determinant(products), ONE_POINT)) * 2 ** len(edges)
    ends = [*((middle[j] - reach[j], middle[j] + reach[j]) for j in range(n)), (measure,)]
    return _result(p, ends, ["measure"])


def line(p: ParameterSet) -> StickingStates | None:
    """All states in which the only friction holds, of scalar parameters, where no force depends on
    one of the coordinates; None where each has a force that does, or forces are not linear.
    """
    try:
        it = _balanced(p)
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
        return _is_pressed(_balanced(p).pressed)
    except (ModelError, ConvergenceError):
        return False


@dataclass(frozen=True)
class _Balanced:
    """Forces K q + b + Σ (μ_i − μ_0,i) C_i of coordinates and friction coefficients, of which
    ``coefficients`` are, for each, that of no share used, μ_0, and that of all.
    """

    balance: Balance
    K: list[list[Any]]
    C: list[list[Any]]
    forces: list[Any]  #: b, with μ_0
    coefficients: list[tuple[Any, ...]]
    pressed: list[Intervals]  #: normal forces of the frictions that hold


def _balanced(p: ParameterSet) -> _Balanced:
    p.model.require_answered("sticking_states")
    balance = Balance(p.model)
    with quiet():
        values = balance.over(Intervals.point(columns(p, balance.parameters)))
        rows = _forces(balance, values)
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
    return _Balanced(balance, K, C, balanced, pairs, normal)


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


def _forces(balance: Balance, values: Mapping[str, Any]) -> list[Any]:
    """Forces as jets of coordinates and friction coefficients, in which they are linear, about 0 of
    both.
    """
    zeros = [Intervals(np.zeros((2, *ONE_POINT)))] * (balance.n + len(balance.rubbing))
    moved = variables(zeros, 2)
    rows: list[Any] = []
    if not balance.springs:
        at = balance.at(moved[: balance.n], values, ONE_POINT)
        given = (*moved[balance.n :], *balance.pushing)
        rows = list(at.call("forces", at.q, *given, kind="statics"))
    terms = [it for row in rows if isinstance(row, Jet) for it in row.terms.items()]
    if not rows or not all(len(term) < 2 or is_zero(part) for term, part in terms):
        raise ModelError(
            f"states of sticking of {balance.model.name}, where several frictions hold, are not "
            "answered yet: its forces are not linear in coordinates and friction coefficients; "
            "they are with given normal forces and springs along coordinates"
        )
    return rows


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
