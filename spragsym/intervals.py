"""Interval arithmetic of any precision: python-flint's Arb where it is installed, mpmath's otherwise.

One small interface over the two, so that a proof is written once. An interval has + − × ÷ and integer powers; the functions below
give it what those leave out. All precisions are in bits.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any, Protocol, TypeAlias

import mpmath

#: An Arb ball or an mpmath interval.
Interval: TypeAlias = Any


class Arithmetic(Protocol):
    """What a proof needs of interval arithmetic."""

    name: str

    def precision(self, bits: int) -> Any:
        """A context in which results carry ``bits`` bits."""

    def exact(self, value: Fraction) -> Interval:
        """The smallest interval around a rational."""

    def between(self, low: mpmath.mpf, high: mpmath.mpf) -> Interval:
        """The interval [low, high]."""

    def cos_sin(self, angle: Interval) -> tuple[Interval, Interval]:
        """Cosine and sine."""

    def sqrt(self, value: Interval) -> Interval:
        """Square root."""

    def atan(self, value: Interval) -> Interval:
        """Arc tangent."""

    def pi(self) -> Interval:
        """π."""

    def ends(self, value: Interval) -> tuple[mpmath.mpf, mpmath.mpf]:
        """Lower and upper end."""


class MpmathIntervals:
    """mpmath's ``iv`` context."""

    name = "mpmath"

    @contextmanager
    def precision(self, bits: int) -> Iterator[None]:
        """Set the precision of ``iv`` and of the numbers that its ends become."""
        before = mpmath.iv.prec
        with mpmath.workprec(bits + 10):
            mpmath.iv.prec = bits
            try:
                yield
            finally:
                mpmath.iv.prec = before

    def exact(self, value: Fraction) -> Interval:
        """The smallest interval around a rational."""
        return mpmath.iv.mpf(value.numerator) / value.denominator

    def between(self, low: mpmath.mpf, high: mpmath.mpf) -> Interval:
        """The interval [low, high]."""
        return mpmath.iv.mpf([low, high])

    def cos_sin(self, angle: Interval) -> tuple[Interval, Interval]:
        """Cosine and sine."""
        return mpmath.iv.cos(angle), mpmath.iv.sin(angle)

    def sqrt(self, value: Interval) -> Interval:
        """Square root."""
        return mpmath.iv.sqrt(value)

    def atan(self, value: Interval) -> Interval:
        """Arc tangent, which grows with its argument: the ends' arc tangents, rounded outward."""
        low, high = self.ends(value)
        return self.between(_nudged(mpmath.atan(low), -1), _nudged(mpmath.atan(high), 1))

    def pi(self) -> Interval:
        """π."""
        return mpmath.iv.pi

    def ends(self, value: Interval) -> tuple[mpmath.mpf, mpmath.mpf]:
        """Lower and upper end."""
        return mpmath.mpf(value.a._mpi_[0]), mpmath.mpf(value.b._mpi_[1])


def _nudged(value: mpmath.mpf, direction: int) -> mpmath.mpf:
    """A little further out than mpmath's rounding error, which is below one unit in the last place."""
    return value + direction * abs(value) * mpmath.ldexp(1, 2 - mpmath.mp.prec)


class ArbIntervals:
    """Arb balls of python-flint."""

    name = "python-flint"

    def __init__(self) -> None:
        import flint

        self._flint = flint

    @contextmanager
    def precision(self, bits: int) -> Iterator[None]:
        """Set the precision of Arb and of the numbers that its ends become."""
        before = self._flint.ctx.prec
        with mpmath.workprec(bits + 10):
            self._flint.ctx.prec = bits
            try:
                yield
            finally:
                self._flint.ctx.prec = before

    def exact(self, value: Fraction) -> Interval:
        """The smallest ball around a rational."""
        return self._flint.arb(self._flint.fmpq(value.numerator, value.denominator))

    def between(self, low: mpmath.mpf, high: mpmath.mpf) -> Interval:
        """A ball around [low, high]."""
        return self._number(low).union(self._number(high))

    def _number(self, value: mpmath.mpf) -> Interval:
        negative, mantissa, exponent, _ = mpmath.mpf(value)._mpf_
        ball = self._flint.arb(self._flint.fmpz(-int(mantissa) if negative else int(mantissa)))
        return ball * self._flint.arb(2) ** int(exponent)

    def cos_sin(self, angle: Interval) -> tuple[Interval, Interval]:
        """Cosine and sine."""
        sine, cosine = angle.sin_cos()
        return cosine, sine

    def sqrt(self, value: Interval) -> Interval:
        """Square root."""
        return value.sqrt()

    def atan(self, value: Interval) -> Interval:
        """Arc tangent."""
        return value.atan()

    def pi(self) -> Interval:
        """π."""
        return self._flint.arb.pi()

    def ends(self, value: Interval) -> tuple[mpmath.mpf, mpmath.mpf]:
        """Lower and upper end."""
        if not value.is_finite():
            return mpmath.mpf("-inf"), mpmath.mpf("inf")
        return self._plain(value.lower()), self._plain(value.upper())

    @staticmethod
    def _plain(value: Any) -> mpmath.mpf:
        mantissa, exponent = value.mid().man_exp()
        return mpmath.ldexp(mpmath.mpf(int(mantissa)), int(exponent))


def arithmetic(name: str | None = None) -> Arithmetic:
    """The fastest interval arithmetic that is installed, or the one of that name ("python-flint", "mpmath")."""
    if name == "mpmath" or (name is None and importlib.util.find_spec("flint") is None):
        return MpmathIntervals()
    return ArbIntervals()


def sign(arith: Arithmetic, value: Interval) -> int:
    """−1 or 1 where an interval has that sign, 0 where it holds 0 or is not a number."""
    low, high = arith.ends(value)
    return 1 if low > 0 else -1 if high < 0 else 0
