"""``xp`` of generated functions for affine numbers: f(m) + f′(X)(x − m) over the whole X, the mean value theorem."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np

from . import interval_functions
from .affine import Affine
from .interval_arrays import Intervals
from .jets import Functions, Jet


def _through(name: str) -> Callable[[Affine], Affine]:
    """A function of affine numbers from itself and its slope, of intervals."""
    function = getattr(interval_functions, name)

    def through(x: Affine) -> Affine:
        with np.errstate(all="ignore"):
            slope = _INTERVALS.of(name, Jet.variable(x.interval(), 0, 1)).derivative(0)
            return Affine.linear(x, Affine.between(function(Intervals.point(x.value))), slope)

    return through


def _taken(value: Any) -> Affine:
    """A number as one without terms."""
    return value if isinstance(value, Affine) else Affine(np.full(1, float(value)), np.zeros((1, 1)))


class _Functions(Functions):
    #: π.
    pi = Affine.between(interval_functions.PI)

    def sign(self, value: Any) -> Affine:
        """−1, 0, 1."""
        return Affine.between(self.taken(value).interval().sign())


_INTERVALS = Functions(interval_functions, lambda value: value)
#: The one that is needed.
AFFINE = _Functions(
    SimpleNamespace(**{name: _through(name) for name in ("sqrt", "exp", "log", "tanh", "atan", "cos", "sin")}), _taken
)
