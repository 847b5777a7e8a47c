"""Regions of states in which several frictions hold where nothing moves, of forces that are linear
in the coordinates.

With the coefficients μ_i = h_i μ_s,i and given normal forces N_i, the balance K q + b = Σ μ_i N_i
s_i makes of the box of shares h_i in [−1, 1] a parallelepiped of states: each coordinate is least
and largest at its middle less and plus the sizes of all edges along it. In the displacements that
friction opposes its measure is 2ᵐ |det(Sᵀ K⁻¹ S)| Π μ_s,i N_i, with the columns s_i of S.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ..core.errors import ConvergenceError, ModelError
from ..models.forces import named
from ..models.parameters import ParameterSet
from ..numerics.arithmetic import cofactor, determinant, is_zero
from ..numerics.interval_arrays import Intervals, quiet
from ..numerics.jets import Jet, constant, gradient, variables
from ..results.points import StickingStates
from ..statics.balance import Balance
from ..statics.forces import as_intervals
from ..statics.search import columns

#: An interval for the one point that is asked for.
ONE = (1,)


def region(p: ParameterSet) -> StickingStates:
    """All states in which every friction that can hold does, of scalar parameters; a
    :class:`ModelError` where the forces are not linear in coordinates and friction coefficients.
    """
    balance = Balance(p.model)
    n, holding = balance.n, [one["name"] for one in p.model.frictions if one["holds"]]
    with quiet():
        values = balance.over(Intervals.point(columns(p, balance.parameters)))
        rows = _forces(balance, values)
        at = balance.at([Intervals(np.zeros((2, *ONE)))] * n, values, ONE)
        coefficients = [
            (at.call(named("friction_held", one), (), share) for share in (0, 1))
            if one in holding
            else (at.call(named("friction_at_speed", one), ()),) * 2
            for one in balance.rubbing
        ]
        normal = [at.contact_force(balance.contacts.index(one), 1) for one in holding]
        pressed = [as_intervals(force, ONE) for force in normal]
        if any((force.high <= 0).all() for force in pressed):
            return _result(p, [])
        if any((force.low <= 0).all() for force in pressed):
            raise ConvergenceError("the sign of a normal force is not known; change a parameter")
        slopes = [gradient(row, n + len(balance.rubbing)) for row in rows]
        K, C = [row[:n] for row in slopes], [row[n:] for row in slopes]
        det = as_intervals(determinant(K), ONE)
        if det.holds_zero().any():
            raise ConvergenceError(
                "det K is 0, or too near to it: states of sticking form sets without an end; "
                "change a parameter"
            )

        def solved(force: list[Any]) -> list[Intervals]:
            """K⁻¹ times a force."""
            return [
                as_intervals(sum(cofactor(K, r, j) * force[r] for r in range(n)), ONE) / det
                for j in range(n)
            ]

        pairs = [tuple(pair) for pair in coefficients]
        balanced = [
            constant(row) + sum(mid * C[r][i] for i, (mid, _) in enumerate(pairs))
            for r, row in enumerate(rows)
        ]
        middle = [-part for part in solved(balanced)]
        edges, opposed = list[list[Intervals]](), list[list[Any]]()
        for i, ((none, whole), name) in enumerate(zip(pairs, balance.rubbing, strict=True)):
            if name in holding:
                column = [C[r][i] for r in range(n)]
                edges.append([part * (whole - none) for part in solved(column)])
                opposed.append([-part / pressed[holding.index(name)] for part in column])
        around = [sum((abs(edge[j]) for edge in edges), middle[j] * 0) for j in range(n)]
        products = [
            [sum(a * b for a, b in zip(one, edge, strict=True)) for edge in edges]
            for one in opposed
        ]
        measure = abs(as_intervals(determinant(products), ONE)) * 2 ** len(edges)
    ends = [*((middle[j] - around[j], middle[j] + around[j]) for j in range(n)), (measure,)]
    return _result(p, ends)


def _forces(balance: Balance, values: Any) -> list[Any]:
    """Forces as jets of coordinates and friction coefficients, in which they are linear, about 0 of
    both.
    """
    zeros = [Intervals(np.zeros((2, *ONE)))] * (balance.n + len(balance.rubbing))
    moved = variables(zeros, 2)
    rows: list[Any] = []
    if not balance.springs:
        at = balance.at(moved[: balance.n], values, ONE)
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


def _result(p: ParameterSet, ends: list[tuple[Intervals, ...]]) -> StickingStates:
    """Enclosures of both ends of every coordinate and of the measure, or of nothing, as a
    result.
    """
    names = [f"{name}_{end}" for name in p.model.coordinates for end in ("low", "high")]
    names.append("measure")
    every = [part for parts in ends for part in parts] or [Intervals(np.empty((2, 0)))] * len(names)
    error = np.max([one.width / np.maximum(1.0, one.magnitude) for one in every], axis=0)
    return StickingStates(
        p, error, True, (), {name: one.middle for name, one in zip(names, every, strict=True)}
    )
