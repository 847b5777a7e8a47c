"""Critical value of a parameter: the lowest end of a followed state reaches a given friction; one search for every model."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from ..errors import ConvergenceError, ParameterError
from ..models.parameters import Range, as_number


def value_at(
    lowest: Callable[[float], float], level: tuple[str, float], vary: str, bracket: Sequence[float], allowed: Range
) -> float:  # fmt: skip
    """The value in a bracket of ``vary`` at which ``lowest`` of it, infinite where there is no end, has a level.

    That is the name and the value of the loading parameter to the end.
    """
    from scipy.optimize import brentq

    along, height = level
    low, high = (as_number(f"bracket[{i}]", value, allowed) for i, value in enumerate(bracket))
    if not low < high:
        raise ParameterError(f"bracket = ({low}, {high}) is empty; give two values, the smaller first")

    def excess(value: float) -> float:
        return math.atan(lowest(value)) - math.atan(height)  # finite where there is no fold

    ends = excess(low), excess(high)
    if ends[0] * ends[1] > 0:
        frictions = ", ".join(f"{_in_words(lowest(value))} at {vary} = {value:g}" for value in (low, high))
        raise ParameterError(f"bracket: the critical {along} is {frictions}, both on one side of {along} = {height:g}; widen it")
    root = float(brentq(excess, low, high, xtol=1e-300, rtol=8.9e-16, maxiter=1000))
    if abs(excess(root)) > 1e-9:
        below, above = (lowest(max(float(np.nextafter(root, end)), allowed.low)) for end in (-math.inf, math.inf))
        raise ConvergenceError(
            f"the critical {along} jumps across {height:g} at {vary} = {root:.12g}, from {_in_words(below)} to "
            f"{_in_words(above)}: there it has no value between; try a bracket on one side"
        )
    return root


def _in_words(friction: float) -> str:
    return "infinite (there is no fold)" if math.isinf(friction) else f"{friction:.6g}"
