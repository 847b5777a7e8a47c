"""What number types have in common: powers as repeated products, and a namespace of functions that are their methods."""

from __future__ import annotations

from typing import Any, TypeVar

_Number = TypeVar("_Number")


def repeated_product(self: _Number, power: int) -> _Number:
    """A positive power, one product after the other: the ``__pow__`` of types for which only small powers occur."""
    result: Any = self
    for _ in range(power - 1):
        result = result * self
    return result  # type: ignore[no-any-return]  # a product of numbers of the type is one


class Functions:
    """``xp`` of generated functions for numbers that have these functions as methods."""

    @staticmethod
    def sqrt(value: Any) -> Any:
        """Square root."""
        return value.sqrt()

    @staticmethod
    def exp(value: Any) -> Any:
        """Exponential."""
        return value.exp()

    @staticmethod
    def log(value: Any) -> Any:
        """Natural logarithm."""
        return value.log()

    @staticmethod
    def tanh(value: Any) -> Any:
        """Hyperbolic tangent."""
        return value.tanh()

    @staticmethod
    def atan(value: Any) -> Any:
        """Arc tangent."""
        return value.atan()

    @staticmethod
    def cos(value: Any) -> Any:
        """Cosine."""
        return value.cos()

    @staticmethod
    def sin(value: Any) -> Any:
        """Sine."""
        return value.sin()

    @staticmethod
    def sign(value: Any) -> Any:
        """−1, 0, 1."""
        return value.sign()

    @staticmethod
    def abs(value: Any) -> Any:
        """Absolute value."""
        return abs(value)
