"""Test functions of a periodic orbit: each passes zero at a bifurcation of it.

They are products over multipliers, every factor divided by its size, so that one of 10¹⁰ hides nothing of the others.
"""

import math
from collections.abc import Callable, Iterator
from functools import partial
from itertools import combinations

import numpy as np

from .shooting import Loop

#: Errors of a factor up to which a zero of a test function is told: what is lost concludes nothing.
LOST = 1e-6


def _factors(loop: Loop, kind: str) -> Iterator[tuple[complex, float]]:
    """The factors of a test function, 1 ± a multiplier or 1 − a product of two, scaled to size 1 at most, and their errors."""
    values, errors = loop.multipliers.others, loop.multipliers.errors
    if kind == "torus":
        for (a, e), (b, f) in combinations(zip(values.tolist(), errors.tolist(), strict=True), 2):
            scale = 1 + abs(a * b)
            yield (1 - a * b) / scale, (abs(a) * f + abs(b) * e) / scale
        return
    sign = 1 if kind == "period_doubling" else -1
    for value, error in zip(values.tolist(), errors.tolist(), strict=True):
        scale = 1 + abs(value)
        yield (1 + sign * value) / scale, error / scale


def criterion_of(kind: str, loop: Loop) -> float:
    """Passes zero at a fold, where a multiplier is 1, at a period doubling, where one is −1, and where the product of two is 1.

    That is a torus, if they are complex; nothing, if they are real.
    """
    return math.prod((factor for factor, _ in _factors(loop, kind)), start=1.0 + 0.0j).real


def is_lost(loop: Loop, kind: str) -> bool:
    """Whether the sign of a test function is unknown, because a factor is less than its error and that is no small one."""
    return any(not abs(factor) > error and not error < LOST for factor, error in _factors(loop, kind))


def unsure(loop: Loop, kind: str) -> float:
    """Error of a test function: that of its smallest factor, times the others."""
    factors = sorted(_factors(loop, kind), key=lambda pair: abs(pair[0]))
    return float(factors[0][1] * np.prod([abs(factor) for factor, _ in factors[1:]])) if factors else 0.0


def is_complex_pair(loop: Loop) -> bool:
    """Whether the two multipliers whose product is nearest to 1 are a complex pair, by more than their errors."""
    values, errors = loop.multipliers.others, loop.multipliers.errors
    pairs = [
        (abs(1 - values[i] * values[j]) / (1 + abs(values[i] * values[j])), abs(values[i].imag), errors[i])
        for i in range(len(values))
        for j in range(i)
    ]
    return bool(pairs) and min(pairs)[1] > max(1e-9, min(pairs)[2])


#: Kinds of event that a test function tells.
CRITERIA: dict[str, Callable[[Loop], float]] = {
    kind: partial(criterion_of, kind) for kind in ("fold", "period_doubling", "torus")
}
