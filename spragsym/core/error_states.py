"""NumPy's handling of overflow, underflow and invalid operations: a caller's own changes no
answer.
"""

from __future__ import annotations

import functools
from collections.abc import Callable

import numpy as np

from .type_variables import P, R


def in_usual_state(function: Callable[P, R]) -> Callable[P, R]:
    """The function under NumPy's default error state, whatever that of its caller is.

    Algorithms rely on underflow to 0, and ask for more where they rely on it.
    """

    @functools.wraps(function)
    def calculated(*args: P.args, **options: P.kwargs) -> R:
        with np.errstate(divide="warn", over="warn", under="ignore", invalid="warn"):
            return function(*args, **options)

    return calculated
