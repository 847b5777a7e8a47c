"""Complex numbers over any real number type: pairs of balls, of intervals, of floats."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .arithmetic import Arithmetic


@dataclass(frozen=True)
class Complex(Arithmetic):
    """re + i im."""

    re: Any
    im: Any

    def __add__(self, other: Any) -> Complex:
        other = as_complex(other)
        return Complex(self.re + other.re, self.im + other.im)

    def __neg__(self) -> Complex:
        return Complex(-self.re, -self.im)

    def __mul__(self, other: Any) -> Complex:
        if not isinstance(other, Complex):
            return Complex(self.re * other, self.im * other)
        return Complex(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)

    def __truediv__(self, other: Any) -> Complex:
        if not isinstance(other, Complex):
            return Complex(self.re / other, self.im / other)
        square = other.squared()
        return Complex(
            (self.re * other.re + self.im * other.im) / square, (self.im * other.re - self.re * other.im) / square
        )  # fmt: skip

    def squared(self) -> Any:
        """|z|²."""
        return self.re**2 + self.im**2

    def conjugate(self) -> Complex:
        """re − i im."""
        return Complex(self.re, -self.im)


def as_complex(value: Any) -> Complex:
    """A real number with the imaginary part 0, and a complex one itself."""
    return value if isinstance(value, Complex) else Complex(value, 0)
