"""Small linear systems in any arithmetic that knows +, −, × and ÷."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

#: What is done to the rows before column k is eliminated, as a choice of its pivot.
Choice = Callable[[list[list[Any]], int], None]


def is_zero(value: Any) -> bool:
    """0 by structure."""
    return isinstance(value, int) and value == 0


def solved(matrix: Sequence[Sequence[Any]], values: Sequence[Any], choose: Choice | None = None) -> list[Any]:
    """Solution by elimination, pivots in the order of the rows unless ``choose`` exchanges them."""
    rows = [[*row, value] for row, value in zip(matrix, values, strict=True)]
    n = len(rows)
    for k in range(n):
        if choose is not None:
            choose(rows, k)
        for i in range(k + 1, n):
            if is_zero(rows[i][k]):
                continue
            factor = rows[i][k] / rows[k][k]
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k], strict=True)]
    solution: list[Any] = [0] * n
    for k in reversed(range(n)):
        rest = rows[k][n]
        for j in range(k + 1, n):
            rest = rest - rows[k][j] * solution[j]
        solution[k] = rest / rows[k][k]
    return solution
