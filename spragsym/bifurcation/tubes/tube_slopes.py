"""Slopes of the forces over a part of a tube: in intervals at a point of parameters, in affine arithmetic over boxes of them.

The state moves with the parameters, and slopes depend on both. Affine arithmetic keeps that to first order, so that over a box
little more is left than slopes really vary by; intervals would take each entry of the matrix for its own.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...numerics import contractors
from ...numerics.affine import Affine
from ...numerics.affine_functions import AFFINE
from ...numerics.interval_arrays import FloatArray, Intervals, stacked
from ...statics.mechanics.balance import Balance


@dataclass(frozen=True)
class Slopes:
    """Rows of slopes by q, v and the free parameters, with the ``zero`` of their type, and how they are ``taken`` for intervals.

    ``forces`` makes of forces, shape (n, N), what belongs to these rows, ``solved`` a step of interval Newton from it.
    """

    rows: Sequence[Sequence[Any]]
    zero: Any
    taken: Callable[[Any], Intervals]
    forces: Callable[[Intervals], Intervals]
    solved: Callable[[Intervals, Intervals, FloatArray, FloatArray], FloatArray]

    def image(self, row: int, direction: FloatArray, start: Any = None) -> Any:
        """A row times a vector, shape (n + 1, N), and more: what is 0 for all boxes is left out."""
        terms = (self.rows[row][j] * part for j, part in enumerate(direction) if part.any())
        return sum(terms, self.zero if start is None else start)

    def newton(self, left: Sequence[Intervals], others: Sequence[int], reach: FloatArray) -> FloatArray:
        """Ends of a step of interval Newton for the unknowns ``others`` from what is left of the forces."""
        shape = reach.shape[1:]
        entries = [self.taken(row[j]) for row in self.rows for j in others]
        matrix = Intervals(stacked(entries, shape).ends.reshape(2, len(self.rows), len(others), *shape))
        return self.solved(stacked(left, shape), matrix, np.zeros_like(reach), reach)


def of_intervals(slopes: Intervals) -> Slopes:
    """Slopes from a matrix of intervals, shape (n, n + 1 + free, N)."""

    def newton(*given: Any) -> FloatArray:
        return contractors.newton(*given).ends

    rows = [list(row) for row in slopes]
    return Slopes(rows, Intervals(np.zeros((2, *slopes.shape[2:]))), _same, _same, newton)


def _same(value: Any) -> Any:
    return value


def of_affine(rows: Sequence[Sequence[Any]], others: Sequence[int], shape: tuple[int, ...]) -> Slopes:
    """Slopes from rows of affine numbers, multiplied by the inverse of their midpoints before they become intervals."""
    middles = np.array([[_middle(row[j], shape) for j in others] for row in rows])
    Y, zero = contractors.inverse(middles), Affine(np.zeros(shape), np.zeros((1, *shape)))
    n = range(len(rows))
    whole = [[sum((rows[k][j] * Y[i, k] for k in n), zero) for j in range(len(rows[0]))] for i in n]

    def forces(found: Intervals) -> Intervals:
        return Intervals(contractors.product(Y, found.ends[:, :, None])[:, :, 0])

    return Slopes(whole, zero, Affine.interval, forces, contractors.by_rows)


def _middle(entry: Any, shape: tuple[int, ...]) -> FloatArray:
    return np.broadcast_to(entry.value if isinstance(entry, Affine) else float(entry), shape)


def affine_rows(
    balance: Balance, values: dict[str, Any], q: Sequence[Affine], turnings: Sequence[Intervals], names: Sequence[str]
) -> list[list[Any]]:
    """Slopes of the forces by the coordinates and by some parameters, of coordinates and parameters that are affine numbers."""
    arguments = balance.arguments_of(values, AFFINE)
    directions: list[Any] = []
    for dx, dy, _ in balance.geometry(q, arguments, AFFINE):
        length = AFFINE.sqrt(dx * dx + dy * dy)
        directions += [dx / length, dy / length, length]
    directions += map(Affine.between, turnings)
    stiffness = balance.by_coordinate("forces_jacobian", q, directions, arguments, AFFINE)
    moved = balance.by_parameters(names, q, directions, arguments, AFFINE)
    return [[*row, *more] for row, more in zip(stiffness, moved, strict=True)]
