"""n equations with a nearly singular Jacobian as one function of one unknown u, of many boxes at once or with many digits.

Near a fold or a cusp the Jacobian has rank n − 1. So n − 1 of the equations determine all unknowns but one, u, uniquely in a
small box, and the last equation becomes g(u). What is written here once, over the number type, are the equations in that order,
interval Newton for the other unknowns, and the Taylor series of them and of g.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from .elimination import Choice, solved
from .interval_arrays import Intervals
from .intervals import Ball, Balls
from .jets import Jet, constant
from .wide_balls import WideBalls


class System(Protocol):
    """n equations in n unknowns, of some of the boxes, by their rows."""

    def values(self, rows: NDArray[np.int64], unknowns: Sequence[Any]) -> Sequence[Any]:
        """F of numbers, or of jets of numbers."""

    def slopes(self, rows: NDArray[np.int64], unknowns: Sequence[Any]) -> Sequence[Sequence[Any]]:
        """∂F/∂x of numbers, row by row."""


@dataclass(frozen=True)
class ReducedEquations:
    """Boxes with their u and the equation that is left: the first of the ``unknowns`` and ``equations``, shape (n, N).

    Numbers are arrays of N intervals or of N balls; a :class:`~spragsym.exact.intervals.Ball` is a single number, where N is 1.
    """

    system: System
    rows: NDArray[np.int64]
    unknowns: NDArray[np.int64]
    equations: NDArray[np.int64]
    choose: Choice | None = None

    def ordered(self, where: NDArray[np.int64], values: Sequence[Any], like: Any = None) -> list[Any]:
        """Unknowns in their order, of u and the others."""
        like = values[0] if like is None else like
        place = np.argsort(self.unknowns[:, where], axis=0, kind="stable")
        return [_picked(values, row, like) for row in place]

    def values(self, where: NDArray[np.int64], unknowns: Sequence[Any]) -> list[Any]:
        """F, the equation that is left first."""
        values = self.system.values(self.rows[where], self.ordered(where, unknowns))
        return [_picked(values, row, unknowns[0]) for row in self.equations[:, where]]

    def slopes(self, where: NDArray[np.int64], unknowns: Sequence[Any]) -> list[list[Any]]:
        """Slopes of F by u and the others, the equation that is left first."""
        like = unknowns[0]
        rows = self.system.slopes(self.rows[where], self.ordered(where, unknowns))
        columns = [[_picked(column, places, like) for places in self.equations[:, where]] for column in zip(*rows, strict=True)]
        return [[_picked(row, places, like) for places in self.unknowns[:, where]] for row in zip(*columns, strict=True)]

    def _coefficients(self, where: NDArray[np.int64], series: Sequence[Sequence[Any]], order: int) -> list[Any]:
        """Coefficients of that order of F along series of u and the others to one order less, the equation that is left first."""
        orders = [self.ordered(where, [part[k] for part in series], series[0][0]) for k in range(order)]
        jets = [
            Jet({(0,) * k: row[i] for k, row in enumerate(orders) if not _is_zero(row[i])}, order) for i in range(len(series))
        ]
        rows = self.system.values(self.rows[where], jets)
        parts = [row.terms.get((0,) * order, 0) if isinstance(row, Jet) else 0 for row in rows]
        return [_picked(parts, row, series[0][0]) for row in self.equations[:, where]]

    def newton(self, where: NDArray[np.int64], u: Any, others: Sequence[Any]) -> list[Any]:
        """Interval Newton's operator m − J⁻¹ S(u, m) for the other unknowns as functions of u, which solve n − 1 equations S."""
        middle = [_middle(value) for value in others]
        values = self.values(where, [u, *middle])[1:]
        slopes = [row[1:] for row in self.slopes(where, [u, *others])[1:]]
        return [m - step for m, step in zip(middle, solved(slopes, values, self.choose), strict=True)]

    def expansion(
        self, where: NDArray[np.int64], u: Any, others: Sequence[Any], highest: int
    ) -> tuple[list[Any], list[list[Any]]]:
        """Taylor coefficients of g from the first on, and of the others as functions of u, from their values on.

        Coefficients of F are linear in the last ones of the others.
        """
        slopes = self.slopes(where, [u, *others])
        matrix = [row[1:] for row in slopes[1:]]
        steps = solved(matrix, [row[0] for row in slopes[1:]], self.choose)
        zero = Ball(0, 0, 0, u.bits) if isinstance(u, Ball) else Intervals(np.zeros((2, where.size)))
        series: list[list[Any]] = [[u, 1], *([value, zero - step] for value, step in zip(others, steps, strict=True))]
        out = [less(slopes[0][0], slopes[0][1:], steps) + zero]
        for order in range(2, highest + 1):
            rest, *rows = self._coefficients(where, series, order)
            steps = solved(matrix, rows, self.choose)
            out.append(less(rest, slopes[0][1:], steps) + zero)
            for part, term in zip(series, [0, *(zero - step for step in steps)], strict=True):
                part.append(term)
        return out, series[1:]


def less(value: Any, factors: Sequence[Any], steps: Sequence[Any]) -> Any:
    """value − Σ factor step."""
    for factor, step in zip(factors, steps, strict=True):
        value = value - factor * step
    return value


def _is_zero(value: Any) -> bool:
    return isinstance(value, int) and value == 0


def _middle(value: Any) -> Any:
    return Balls().middle(value) if isinstance(value, Ball) else Intervals.point(value.middle)


def _picked(values: Sequence[Any], places: NDArray[np.int64], like: Any) -> Any:
    """Of several arrays of numbers, or numbers, that of the given place, element by element, as numbers like another."""
    if all(value is values[0] or (isinstance(value, int) and value == values[0]) for value in values[1:]):
        return values[0]
    kind = type(constant(like))
    if kind is Ball:
        return values[places[0]]
    out = None
    for number, value in enumerate(values):
        array = value if isinstance(value, kind) else _constant(kind, float(value), places.size)
        out = array if out is None else kind.where(places == number, array, out)
    return out


def _constant(kind: type, value: float, count: int) -> Any:
    numbers = np.full(count, value)
    return WideBalls.exact(numbers) if kind is WideBalls else Intervals.point(numbers)
