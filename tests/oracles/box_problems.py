"""Small systems with known numbers of roots, for the search over boxes.

M. W. Smiley and C. Chun, "An algorithm for finding all solutions of a nonlinear system", J. Comput.
Appl. Math. 137 (2001) 293–315, examples 2.2, 5.2 and 5.4; numbers of roots and regions as in the
examples of IntervalRootFinding.jl. Rastrigin's function as in that package's tests.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from spragsym.numerics import boxes
from spragsym.numerics.interval_arrays import Intervals, matrix, stacked
from spragsym.numerics.jets import gradient, variables
from spragsym.statics.namespaces import XP


def interval(low: float, high: float) -> Intervals:
    """One interval."""
    return Intervals.between([low], [high])


#: π, which lies above its float.
PI = interval(np.pi, np.nextafter(np.pi, 4))


@dataclass(frozen=True)
class Problem(boxes.EquationSystem):
    """Equations without parameters, by their values; derivatives come from jets."""

    title: str
    function: Callable[[Sequence[Any]], Sequence[Any]]
    region: tuple[tuple[float, float], ...]
    roots: int

    @property
    def ends(self) -> NDArray[np.float64]:
        """The region as −low and high, shape (2, n, 1)."""
        return np.array([[-low, high] for low, high in self.region]).T[:, :, None]

    def residuals(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """The values over boxes."""
        return stacked(self.function(list(unknowns)), unknowns.shape[1:])

    def jacobian(self, unknowns: Intervals, parameters: Intervals) -> Intervals:
        """Their derivatives."""
        rows = self.function(variables(list(unknowns), 1))
        return matrix([gradient(row, unknowns.shape[0]) for row in rows], unknowns.shape[1:])


def _example_22(x: Sequence[Any]) -> Sequence[Any]:
    return (
        x[0] ** 2 + 4 * x[1] ** 2 - 4,
        x[1] * (x[0] - interval(*_around("1.995"))) * (x[1] - x[0] ** 2) * (x[1] - x[0] + 1),
    )


def _around(digits: str) -> tuple[float, float]:
    value = float(digits)
    return float(np.nextafter(value, -np.inf)), float(np.nextafter(value, np.inf))


def _decimal(digits: str) -> Intervals:
    return interval(*_around(digits))


def _example_52(x: Sequence[Any]) -> Sequence[Any]:
    """Two spheres, two planes, and three planes through a line."""
    d1, d2 = _decimal("0.2"), _decimal("-0.7")
    radius = x[0] ** 2 + x[1] ** 2 + x[2] ** 2
    plane = 0.5 * x[0] + 0.5 * x[1] + x[2]
    product: Any = 1
    for i in (1, 2, 3):
        angle = PI * i / 3
        c, s = XP.cos(angle), XP.sin(angle)
        v = -(0.5 * c + 0.5 * s)
        third = 0.5 * s - 0.5 * c
        product = product * (
            x[0] * (0.5 * v - s) + x[1] * (c - 0.5 * v) + x[2] * third - d1 * third
        )
    return ((radius - 1) * (radius - 4), (plane - d1) * (plane - d2), product)


def _example_54(t: Sequence[Any]) -> Sequence[Any]:
    """Rescaled, as is usual."""
    c11, c15, c21 = _decimal("1.069e-5"), _decimal("-1.283e-4"), _decimal("2e-2")
    return (
        t[0] ** 4 * c11 + t[0] ** 3 * t[1] * 200 + t[0] ** 3 * 1e5 - t[0] * 1.8e5 + c15,
        t[0] * t[1] ** 2 * c21 + t[1] ** 2 * 10 - 10,
    )


def _rastrigin(x: Sequence[Any]) -> Sequence[Any]:
    return [2 * value + XP.sin(value * (2 * PI)) * (20 * PI) for value in x]


PROBLEMS = (
    Problem("Smiley and Chun 2.2", _example_22, ((-3, 3), (-3, 3)), 8),
    Problem("Smiley and Chun 5.2", _example_52, ((-3, 3), (-3, 3), (-3, 3)), 24),
    Problem("Smiley and Chun 5.4", _example_54, ((-510, 1.4), (-510, 1.1)), 7),
    Problem("Rastrigin", _rastrigin, ((-5, 6), (-5, 6)), 529),
)
