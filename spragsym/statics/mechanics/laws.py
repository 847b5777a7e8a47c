"""The namespace ``xp`` of a model's functions over boxes of coordinates."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ...numerics.interval_arrays import Intervals
from ...numerics.interval_functions import atan2, cos, sin
from ...numerics.jets import Jet, JetFunctions, constant


class LawFunctions(JetFunctions):
    """As for any interval, but that roots and logarithms are taken of what is not negative.

    A law of contact that is no polynomial is asked for on its own side of the border only (``Balance.limits``), and what else has
    roots or logarithms has them of what is seen to be positive when its page is read. So their arguments are not negative, and
    where an enclosure reaches below 0 that is rounding, or an enclosure that is not sharp.
    """

    def __init__(self) -> None:
        functions: dict[str, Callable[..., Any]] = {
            "sqrt": lambda value: _not_negative(value).sqrt(),
            "exp": lambda value: value.exp(),
            "log": lambda value: _not_negative(value).log(),
            "tanh": lambda value: value.tanh(),
            "atan": lambda value: value.atan(),
            "atan2": atan2,
            "cos": cos,
            "sin": sin,
        }
        super().__init__(functions, _enclosed)

    def _of(self, name: str, value: Any) -> Any:
        if isinstance(value, Jet) and name in ("sqrt", "log"):
            value = Jet({**value.terms, (): _not_negative(_enclosed(value.value))}, value.order)
        return super()._of(name, value)

    #: π.
    pi = Intervals.between([np.pi], [np.nextafter(np.pi, 4.0)])

    def exp(self, value: Any) -> Any:
        """Exponential: 1 of the number 0."""
        return 1 if isinstance(value, int | float) and value == 0 else super().exp(value)

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


class FreeWaves(LawFunctions):
    """The same with cosines and sines for numbers of their own, anything from −1 to 1 and the same for every value."""

    def cos(self, value: Any) -> Any:
        """From −1 to 1."""
        return self._wave(value)

    def sin(self, value: Any) -> Any:
        """From −1 to 1."""
        return self._wave(value)

    def _wave(self, value: Any) -> Any:
        return Intervals(np.ones_like(self.taken(constant(value)).ends))


#: The one that is needed.
XP = LawFunctions()
#: For bounds far away, where forces are linear but for what is bounded.
FREE = FreeWaves()
