"""Forces of states that run to infinity: coordinates q = u/w with w → 0 as a number type.

A number a w^−k is a pair of a, regular at w = 0, and the integer k. Sums, products, quotients, even roots and lengths of springs
are such numbers again; so the algebra that is generated for the balance gives each row as w^−k G(u, w) with G regular at w = 0,
where it is the part of highest degree. An exponential or a cosine of what runs away is none: :class:`NoChart`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ...numerics.arithmetic import Arithmetic
from .laws import XP


class NoChart(Exception):
    """A function of what runs to infinity that has no expansion there."""


class Scaled(Arithmetic):
    """A number value · w^−order, with one w for all."""

    __slots__ = ("order", "value", "w")
    __array_ufunc__ = None

    def __init__(self, value: Any, order: int, w: Any) -> None:
        self.value, self.order, self.w = value, order, w

    def _of(self, other: Any) -> Scaled:
        return other if isinstance(other, Scaled) else Scaled(other, 0, self.w)

    def finite(self) -> Any:
        """The number itself, where it does not run away."""
        if self.order > 0:
            raise NoChart
        return self.value * self.w**-self.order if self.order else self.value

    def __neg__(self) -> Scaled:
        return Scaled(-self.value, self.order, self.w)

    def __add__(self, other: Any) -> Scaled:
        other = self._of(other)
        if isinstance(other.value, int) and other.value == 0:
            return self
        small, large = sorted((self, other), key=lambda one: one.order)
        shift = large.order - small.order
        return Scaled(large.value + (small.value * self.w**shift if shift else small.value), large.order, self.w)

    def __mul__(self, other: Any) -> Any:
        other = self._of(other)
        if isinstance(other.value, int) and other.value == 0:
            return 0
        return Scaled(self.value * other.value, self.order + other.order, self.w)

    def __truediv__(self, other: Any) -> Any:
        other = self._of(other)
        return Scaled(self.value / other.value, self.order - other.order, self.w)

    def __rtruediv__(self, other: Any) -> Any:
        return self._of(other) / self

    def __pow__(self, power: int) -> Any:
        return Scaled(self.value**power, self.order * power, self.w)


class _Functions:
    """The namespace ``xp`` of generated functions of such numbers."""

    pi = XP.pi

    @staticmethod
    def sqrt(value: Any) -> Any:
        """Square root of an even order: half of it."""
        if not isinstance(value, Scaled):
            return XP.sqrt(value)
        if value.order % 2:
            raise NoChart
        return Scaled(XP.sqrt(value.value), value.order // 2, value.w)

    @staticmethod
    def atan2(sine: Any, cosine: Any) -> Any:
        """Angle; of no number that runs to infinity."""
        raise NoChart

    def __getattr__(self, name: str) -> Callable[[Any], Any]:
        function: Callable[[Any], Any] = getattr(XP, name)
        return lambda value: function(value.finite() if isinstance(value, Scaled) else value)


#: The one that is needed.
SCALED: Any = _Functions()
