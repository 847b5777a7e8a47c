"""Namespaces ``xp`` for the generated functions: over boxes, at infinity, and for mirror
symmetries.

At infinity the coordinates are q = u/w with w → 0. A number a w^−k is stored as a, regular at w =
0, and the integer k. Sums, products, quotients, even roots and lengths of springs keep this form.
So each row of the balance becomes w^−k G(u, w), and G at w = 0 is its part of highest degree. An
exponential or a cosine of an infinite argument has no such form: :class:`NoChart`.

A mirror symmetry changes the signs of some coordinates and of their rows. Parity (odd, even,
neither) is a number type for which the generated functions show this.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np

from ..numerics import interval_arrays
from ..numerics.arithmetic import Arithmetic, Number, is_zero
from ..numerics.interval_arrays import Intervals
from ..numerics.jets import Functions, Jet, constant

if TYPE_CHECKING:
    from .balance import Balance
    from .forces import Values


class LawFunctions(Functions):
    """Interval functions whose square roots and logarithms clip their argument to be ≥ 0.

    The arguments are not negative: a contact law that is no polynomial is evaluated on its own side
    of the border (``Balance.limits``), and other arguments of roots and logarithms are checked when
    the page is read. An enclosure that reaches below 0 does so by overestimation.
    """

    #: π.
    pi = interval_arrays.PI

    def of(self, name: str, value: Number) -> Number:
        """A function of one number or jet."""
        if name in ("sqrt", "log"):
            value = _not_negative(value)
        return super().of(name, value)

    def exp(self, value: Number) -> Number:
        """Exponential; the exact 1 for the exact 0."""
        return 1 if isinstance(value, int | float) and value == 0 else self.of("exp", value)


def _enclosed(value: Number) -> Number:
    """A number as an interval, so that functions of it are rounded outward."""
    return Intervals.point([float(value)]) if isinstance(value, int | float) else value


def _not_negative(value: Number) -> Number:
    """Intervals, or the constant term of a jet, clipped to be ≥ 0."""
    if isinstance(value, Jet):
        return Jet({**value.terms, (): _not_negative(_enclosed(value.value))}, value.order)
    return value.not_negative() if isinstance(value, Intervals) else value


class FreeWaves(LawFunctions):
    """Functions whose cosines and sines are free numbers in [−1, 1], whatever their argument is."""

    def of(self, name: str, value: Number) -> Number:
        """A function of one number or jet."""
        if name in ("cos", "sin"):
            return Intervals(np.ones_like(self.taken(constant(value)).ends))
        return super().of(name, value)


#: ``xp`` over boxes.
XP = LawFunctions(interval_arrays, _enclosed)
#: The same functions under another identity, for affine numbers: directions of springs are then
#: computed as quotients.
NARROW = LawFunctions(interval_arrays, _enclosed)
#: ``xp`` for bounds on far states, where forces are linear up to bounded terms.
FREE = FreeWaves(interval_arrays, _enclosed)


class NoChart(Exception):
    """Raised for a function of an infinite argument that has no expansion in powers of w."""


class Scaled(Arithmetic):
    """A number value · w^−order; w is the same for all numbers of a computation."""

    __slots__ = ("order", "value", "w")
    __array_ufunc__ = None

    def __init__(self, value: Number, order: int, w: Number) -> None:
        self.value, self.order, self.w = value, order, w

    def _of(self, other: Number) -> Scaled:
        return other if isinstance(other, Scaled) else Scaled(other, 0, self.w)

    def finite(self) -> Any:
        """The number itself; raises NoChart if it is infinite."""
        if self.order > 0:
            raise NoChart
        return self.value * self.w**-self.order if self.order else self.value

    def __neg__(self) -> Scaled:
        return Scaled(-self.value, self.order, self.w)

    def __abs__(self) -> Scaled:
        return Scaled(abs(self.finite()), 0, self.w)

    def __add__(self, other: Number) -> Scaled:
        other = self._of(other)
        if is_zero(other.value):
            return self
        small, large = sorted((self, other), key=lambda one: one.order)
        shift = large.order - small.order
        return Scaled(
            large.value + (small.value * self.w**shift if shift else small.value),
            large.order,
            self.w,
        )

    def __mul__(self, other: Number) -> Any:
        other = self._of(other)
        if is_zero(other.value):
            return 0
        return Scaled(self.value * other.value, self.order + other.order, self.w)

    def __truediv__(self, other: Number) -> Scaled:
        other = self._of(other)
        return Scaled(self.value / other.value, self.order - other.order, self.w)

    def __rtruediv__(self, other: Number) -> Scaled:
        return self._of(other) / self

    def __pow__(self, power: int) -> Scaled:
        return Scaled(self.value**power, self.order * power, self.w)


class ScaledFunctions:
    """The namespace ``xp`` for :class:`Scaled` numbers."""

    pi = XP.pi

    @staticmethod
    def sqrt(value: Number) -> Number:
        """Square root; raises NoChart for an odd order."""
        if not isinstance(value, Scaled):
            return XP.sqrt(value)
        if value.order % 2:
            raise NoChart
        return Scaled(XP.sqrt(value.value), value.order // 2, value.w)

    @staticmethod
    def atan2(sine: Number, cosine: Number) -> NoReturn:
        """Always raises NoChart: the angle has no expansion."""
        raise NoChart

    def __getattr__(self, name: str) -> Callable[[Any], Any]:
        function: Callable[[Any], Any] = getattr(XP, name)
        return lambda value: (
            Scaled(function(value.finite()), 0, value.w)
            if isinstance(value, Scaled)
            else function(value)
        )


class Parity(Arithmetic):
    """A number that changes its sign in a mirror (``odd`` True), does not (False), or neither
    (None).

    Plain numbers are even, except that 0 is both odd and even.
    """

    __slots__ = ("odd",)
    __array_ufunc__ = None

    def __init__(self, odd: bool | None) -> None:
        self.odd = odd

    def __add__(self, other: Number) -> Parity:
        if not isinstance(other, Parity):
            return self if other == 0 or self.odd is False else Parity(None)
        return self if self.odd == other.odd else Parity(None)

    def __neg__(self) -> Parity:
        return self

    def __abs__(self) -> Parity:
        return Parity(None if self.odd is None else False)

    def __mul__(self, other: Number) -> Any:
        if not isinstance(other, Parity):
            return self if other != 0 else 0
        return Parity(None if None in (self.odd, other.odd) else self.odd != other.odd)

    __truediv__ = __mul__

    def __rtruediv__(self, other: Number) -> Parity:
        return self * other

    def __pow__(self, power: int) -> Parity:
        return Parity(self.odd and power % 2 == 1) if self.odd is not None else self


class _ParityFunctions:
    """The namespace ``xp`` for :class:`Parity`."""

    pi = 3

    def __getattr__(self, name: str) -> Callable[..., Parity]:
        def parity(*values: Any) -> Parity:
            parities = [value.odd if isinstance(value, Parity) else False for value in values]
            odd = name in ("sin", "sinh", "tanh", "atan")
            even = name in ("cos", "cosh")
            if None in parities or len(parities) > 1 or (parities[0] and not (odd or even)):
                return Parity(None if True in parities or None in parities else False)
            return Parity(parities[0] and odd)

        return parity


def follows(balance: Balance, values: Values, odd: Collection[int]) -> bool:
    """Whether a mirror that changes the signs of the coordinates ``odd`` is a symmetry of the
    balance.

    It is if the rows of these coordinates change their signs and all other rows and gaps do not.
    """
    xp = _ParityFunctions()
    q = [Parity(i in odd) for i in range(balance.n)]
    given = {name: 0 if is_zero(value) else Parity(False) for name, value in values.items()}
    at = balance.at(q, given, xp=xp)
    expected = [
        *((row, i in odd) for i, row in enumerate(at.rows("forces"))),
        *((gap, False) for gap in at.gaps()),
    ]
    return all(
        (row.odd is is_odd) if isinstance(row, Parity) else (row == 0 or not is_odd)
        for row, is_odd in expected
    )
