"""Arb balls of python-flint behind the interface of :mod:`spragsym.numerics.intervals`: a second arithmetic, to hold the first against.

It sets ``flint.ctx.prec``, which is one variable for all threads: for tests, one thread at a time. ``python -m tests.oracles.arb``
prints what a point in intervals costs with either.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

import flint

from spragsym.kang_nam.quartic import adaptive_precision
from spragsym.numerics import intervals
from spragsym.numerics.polynomials import Undecided


class Arb:
    """Interval arithmetic of python-flint; as :class:`spragsym.numerics.intervals.Arithmetic` has it."""

    @contextmanager
    def precision(self, bits: int) -> Iterator[None]:
        """Set the precision of Arb, and restore it."""
        before = flint.ctx.prec
        flint.ctx.prec = bits
        try:
            yield
        finally:
            flint.ctx.prec = before

    def exact(self, value: Fraction) -> Any:
        """A small ball around a rational."""
        return flint.arb(flint.fmpq(value.numerator, value.denominator))

    def between(self, low: Fraction, high: Fraction) -> Any:
        """A ball that holds [low, high]."""
        return self.union(self.exact(low), self.exact(high))

    def union(self, one: Any, other: Any) -> Any:
        """A ball that holds both."""
        return one.union(other)

    def middle(self, value: Any) -> Any:
        """Its middle, as a ball without width."""
        return _finite(value).mid()

    def cos_sin(self, angle: Any) -> tuple[Any, Any]:
        """Cosine and sine."""
        sine, cosine = angle.sin_cos()
        return cosine, sine

    def sqrt(self, value: Any) -> Any:
        """Square root."""
        return _finite(value.sqrt())

    def atan(self, value: Any) -> Any:
        """Arc tangent."""
        return value.atan()

    def pi(self) -> Any:
        """π."""
        return flint.arb.pi()

    def ends(self, value: Any) -> tuple[Fraction, Fraction]:
        """Lower and upper end, exactly."""
        middle, radius = (_fraction(part) for part in (_finite(value).mid(), value.rad()))
        return middle - radius, middle + radius

    def sign(self, value: Any) -> int:
        """−1 or 1 where a ball has that sign, 0 where it holds 0 or is not a number."""
        return 1 if value > 0 else -1 if value < 0 else 0

    def power(self, value: Any) -> int:
        """n with 2ⁿ⁻¹ ≤ |middle| < 2ⁿ."""
        mantissa, exponent = value.mid().man_exp()
        return int(abs(mantissa)).bit_length() + int(exponent)


def _finite(value: Any) -> Any:
    if not value.is_finite():
        raise Undecided("not a number")
    return value


def _fraction(value: Any) -> Fraction:
    mantissa, exponent = value.man_exp()
    return int(mantissa) * Fraction(2) ** int(exponent)


def main() -> None:
    """Milliseconds for the three equilibria of one point, the best of fifty."""
    arithmetics: dict[str, intervals.Arithmetic] = {"integers": intervals.Balls(), "Arb": Arb()}
    for name, arith in arithmetics.items():
        for digits in (17, 50, 1000):
            best = float("inf")
            for _ in range(50):
                begin = time.process_time()
                adaptive_precision.equilibria(0.6, 0.5, "0.007", "0.007", "0.1", 0, digits=digits, arith=arith)
                best = min(best, time.process_time() - begin)
            print(f"{name}, {digits} digits: {1e3 * best:.2f} ms")


if __name__ == "__main__":
    main()
