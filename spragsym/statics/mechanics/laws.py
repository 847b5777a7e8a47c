"""The namespace ``xp`` of a model's functions over boxes of coordinates."""

from typing import Any

import numpy as np

from ...numerics import interval_arrays
from ...numerics.interval_arrays import Intervals
from ...numerics.jets import Functions, Jet, constant


class LawFunctions(Functions):
    """Interval functions in which roots and logarithms are taken of what is not negative.

    A law of contact that is no polynomial is asked for on its own side of the border only (``Balance.limits``), and what else has
    roots or logarithms has them of what is seen to be positive when its page is read. So their arguments are not negative, and
    where an enclosure reaches below 0 that is rounding, or an enclosure that is not sharp.
    """

    #: π.
    pi = interval_arrays.PI

    def of(self, name: str, value: Any) -> Any:
        """A function of one number or jet."""
        if name in ("sqrt", "log"):
            value = _not_negative(value)
        return super().of(name, value)

    def exp(self, value: Any) -> Any:
        """Exponential: 1 of the number 0."""
        return 1 if isinstance(value, int | float) and value == 0 else self.of("exp", value)

    @staticmethod
    def sign(value: Any) -> Any:
        """−1, 0, 1."""
        return _enclosed(value).sign()


def _enclosed(value: Any) -> Any:
    """A number as an interval, so that a function of it is one that is rounded outward."""
    return Intervals.point([float(value)]) if isinstance(value, int | float) else value


def _not_negative(value: Any) -> Any:
    if isinstance(value, Jet):
        return Jet({**value.terms, (): _not_negative(_enclosed(value.value))}, value.order)
    return Intervals(np.stack([np.minimum(value.ends[0], 0.0), value.ends[1]])) if isinstance(value, Intervals) else value


class FreeWaves(LawFunctions):
    """Functions with cosines and sines as free numbers from −1 to 1, the same for every value."""

    def of(self, name: str, value: Any) -> Any:
        """A function of one number or jet."""
        return Intervals(np.ones_like(self.taken(constant(value)).ends)) if name in ("cos", "sin") else super().of(name, value)


#: The one that is needed.
XP = LawFunctions(interval_arrays, _enclosed)
#: For bounds far away, where forces are linear but for what is bounded.
FREE = FreeWaves(interval_arrays, _enclosed)
