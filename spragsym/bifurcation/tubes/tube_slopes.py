"""Slopes of the forces over a part of a tube: in intervals at a point of parameters, in affine arithmetic over boxes of them.

The state moves with the parameters, and slopes depend on both. Affine arithmetic keeps that to first order, so that over a box
little more is left than slopes really vary by; intervals would take each entry of the matrix for its own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...numerics import contractors
from ...numerics.affine import Affine
from ...numerics.interval_arrays import FloatArray, Intervals, matrix, stacked


@dataclass(frozen=True)
class Slopes:
    """Rows of slopes by q, v and the free parameters: intervals, or affine numbers that ``Y`` has multiplied.

    ``zero`` is the 0 of their type; what belongs to the rows beside slopes ``Y`` multiplies as well.
    """

    rows: Sequence[Sequence[Any]]
    zero: Any
    Y: FloatArray | None = None

    def taken(self, value: Any) -> Intervals:
        """A number of the type as an interval."""
        interval: Intervals = value if self.Y is None else value.interval()
        return interval

    def forces(self, found: Intervals) -> Intervals:
        """Forces, shape (n, N), as these rows have them."""
        return found if self.Y is None else Intervals(contractors.product(self.Y, found.ends[:, :, None])[:, :, 0])

    def image(self, row: int, direction: FloatArray, start: Any = None) -> Any:
        """A row times a vector, shape (n + 1, N), and more: what is 0 for all boxes is left out."""
        terms = (self.rows[row][j] * part for j, part in enumerate(direction) if part.any())
        return sum(terms, self.zero if start is None else start)

    def newton(self, left: Sequence[Intervals], others: Sequence[int], reach: FloatArray) -> FloatArray:
        """Ends of a step of interval Newton for the unknowns ``others`` from what is left of the forces."""
        shape = reach.shape[1:]
        entries = matrix([[self.taken(row[j]) for j in others] for row in self.rows], shape)
        given = stacked(left, shape), entries, np.zeros_like(reach), reach
        return contractors.newton(*given).ends if self.Y is None else contractors.by_rows(*given)


def of_affine(rows: Sequence[Sequence[Any]], others: Sequence[int], shape: tuple[int, ...]) -> Slopes:
    """Slopes from rows of affine numbers, multiplied by the inverse of their midpoints before they become intervals."""
    middles = np.array([[_middle(row[j], shape) for j in others] for row in rows])
    Y, zero = contractors.inverse(middles), Affine(np.zeros(shape), np.zeros((1, *shape)))
    n = range(len(rows))
    return Slopes([[sum((rows[k][j] * Y[i, k] for k in n), zero) for j in range(len(rows[0]))] for i in n], zero, Y)


def _middle(entry: Any, shape: tuple[int, ...]) -> FloatArray:
    return np.broadcast_to(entry.value if isinstance(entry, Affine) else float(entry), shape)
