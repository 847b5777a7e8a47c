"""Functions of intervals that a tape has, and operands of every size for them."""

from collections.abc import Callable
from typing import Any

import numpy as np

from spragsym.numerics import interval_arrays
from spragsym.numerics.interval_arrays import Intervals

#: Functions of one interval.
ONE: dict[str, Callable[[Any], Any]] = {
    "negative": lambda a: -a,
    "absolute": abs,
    "square": lambda a: a * a,
    "cube": lambda a: a**3,
    "powers": lambda a: a**3 + a**4 + a**-2 + a**0 * 3,
    "numbers": lambda a: 2 * a - 3 / (a / 7 + 1) + 0 * a,
    "sqrt": lambda a: a.not_negative().sqrt(),
    "exp": interval_arrays.exp,
    "log": lambda a: a.not_negative().log(),
    "tanh": interval_arrays.tanh,
    "atan": interval_arrays.atan,
    "cos": interval_arrays.cos,
    "sin": interval_arrays.sin,
    "sign": lambda a: a.sign(),
}
#: Functions of two.
TWO: dict[str, Callable[[Any, Any], Any]] = {
    "sum": lambda a, b: a + b,
    "difference": lambda a, b: a - b,
    "product": lambda a, b: a * b,
    "quotient": lambda a, b: a / b,
    "direction": lambda a, b: interval_arrays.unit_vector(a, b)[0],
    "length": interval_arrays.length,
    **{
        f"angle {side}": lambda a, b, side=side: interval_arrays.atan2(a, b, side)
        for side in (None, 1, -1, 0)
    },
}
#: Those that the C library gives, and not the operations of IEEE 754.
OF_THE_LIBRARY = ("exp", "log", "tanh", "atan", "cos", "sin", *(n for n in TWO if "angle" in n))


def operands(rng: np.random.Generator, count: int) -> Intervals:
    """Intervals of every size: points, ends at 0 or beside it, infinite and unknown ones."""
    size = 10.0 ** rng.uniform(-320, 300, count)
    size = np.where(rng.random(count) < 0.6, 10.0 ** rng.uniform(-3, 3, count), size)
    low = size * rng.choice([-1, 0, 1], count, p=[0.4, 0.2, 0.4])
    width = np.abs(low) * 10.0 ** rng.uniform(-17, 1, count) * rng.choice([0, 1], count)
    ends = np.stack([-low, low + width])
    ends = np.where(rng.random(count) < 0.1, ends[::-1], ends)
    ends[:, ends.sum(axis=0) < 0] *= -1
    end, place = rng.integers(2, size=count), np.arange(count)
    ends[end, place] = np.where(rng.random(count) < 0.03, np.inf, ends[end, place])
    ends[:, rng.random(count) < 0.02] = np.nan
    return Intervals(ends)
