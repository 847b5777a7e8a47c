"""The namespace ``xp`` of a model's functions over boxes of coordinates."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..exact.interval_arrays import Intervals
from ..exact.interval_functions import atan2
from ..exact.jets import Jet
from ..exact.methods import Functions


class LawFunctions(Functions):
    """As for any interval, but that a root is taken of what is not negative.

    A law of contact that is no polynomial is asked for on its own side of the border only (``Balance.limits``). So its argument
    is not negative, and where its enclosure reaches below 0 that is rounding.
    """

    #: Between the float below and the next one.
    pi = Intervals.between(np.array([math.pi]), np.array([np.nextafter(math.pi, 4.0)]))

    @staticmethod
    def atan2(sine: Any, cosine: Any) -> Any:
        """The angle in (−π, π]."""
        return atan2(_enclosed(sine), _enclosed(cosine))

    @staticmethod
    def sqrt(value: Any) -> Any:
        """Square root of the part that is not negative."""
        if isinstance(value, Jet):
            value = Jet({**value.terms, (): _not_negative(_enclosed(value.value))}, value.order)
            return value.sqrt()
        return _not_negative(_enclosed(value)).sqrt()

    @staticmethod
    def exp(value: Any) -> Any:
        """Exponential: 1 of the number 0."""
        if isinstance(value, Jet):
            return value.exp(LawFunctions.exp(value.value))
        return 1 if isinstance(value, int | float) and value == 0 else _enclosed(value).exp()

    @staticmethod
    def sign(value: Any) -> Any:
        """−1, 0, 1."""
        return _enclosed(value).sign()


def _enclosed(value: Any) -> Any:
    """A number as an interval, so that a function of it is one that is rounded outward."""
    return Intervals.point([float(value)]) if isinstance(value, int | float) else value


def _not_negative(value: Any) -> Any:
    if not isinstance(value, Intervals):
        return value
    return Intervals(np.stack([np.minimum(value.ends[0], 0.0), value.ends[1]]))


#: The one that is needed.
XP = LawFunctions()
