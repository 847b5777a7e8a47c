"""``xp`` of generated functions for affine numbers: f(m) + f′(X)(x − m) over the whole X, the mean value theorem."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from .affine import Affine
from .interval_arrays import Intervals
from .interval_functions import cos, sin
from .jets import JetFunctions

Function = Callable[[Intervals], Intervals]


def _through(function: Function, slope: Function) -> Callable[[Affine], Affine]:
    """A function of affine numbers from itself and its slope, of intervals."""

    def through(x: Affine) -> Affine:
        with np.errstate(all="ignore"):
            middle, slopes = function(Intervals.point(x.value)), slope(x.interval())
            return Affine.linear(x, Affine.between(middle), slopes)

    return through


def _taken(value: Any) -> Affine:
    """A number as one without terms."""
    return value if isinstance(value, Affine) else Affine(np.full(1, float(value)), np.zeros((1, 1)))


class AffineFunctions(JetFunctions):
    """As for intervals, see :class:`spragsym.numerics.jets.JetFunctions`."""

    #: π.
    pi = Affine.between(Intervals.between([np.pi], [np.nextafter(np.pi, 4.0)]))

    def sign(self, value: Any) -> Affine:
        """−1, 0, 1."""
        return Affine.between(self.taken(value).interval().sign())


#: The one that is needed.
AFFINE = AffineFunctions(
    {
        "sqrt": _through(Intervals.sqrt, lambda x: 1 / (x.sqrt() * 2)),
        "exp": _through(Intervals.exp, Intervals.exp),
        "log": _through(Intervals.log, lambda x: 1 / x),
        "tanh": _through(Intervals.tanh, lambda x: 1 - x.tanh().squared()),
        "atan": _through(Intervals.atan, lambda x: 1 / (1 + x.squared())),
        "cos": _through(cos, lambda x: -sin(x)),
        "sin": _through(sin, cos),
    },
    _taken,
)
