"""heyoka, and the functions of its expressions under the names that generated algebra asks for."""

from __future__ import annotations

from functools import cache
from types import ModuleType
from typing import Any

from ..core.interrupts import held
from ..numerics.arithmetic import Number


@cache
def library() -> ModuleType:
    """The module, which from now on reports errors only: its warnings are of a cache that can't be
    written, as in a read-only home, and of its search for crossings near a tangency.
    ``heyoka.set_logger_level_warning()`` brings them back.
    """
    with held():
        import heyoka as hy
    hy.set_logger_level_error()
    # Generated functions take abs of parameters, and a field the functions of its numbers.
    hy.expression.__abs__ = lambda value: value * XP.sign(value)
    hy.expression.namespace = XP
    return hy


class HeyokaFunctions:
    """The namespace ``xp`` of heyoka's expressions, whose functions take numbers too, as the 2 of
    sqrt(2).
    """

    def __init__(self) -> None:
        #: Names and arguments of all that was called.
        self.called: list[tuple[str, Any]] = []

    def __getattr__(self, name: str) -> object:
        hy = library()
        found = getattr(hy, name)
        if isinstance(found, hy.expression):
            return found

        def call(*values: Number) -> Number:
            taken = [
                hy.expression(float(it)) if isinstance(it, int | float) else it for it in values
            ]
            self.called.append((name, taken[0]))
            return found(*taken)

        return call

    def sign(self, value: Number) -> Number:
        """The sign of an expression: −1, 0 or 1."""
        hy = library()
        return hy.select(hy.gt(value, 0.0), 1.0, hy.select(hy.lt(value, 0.0), -1.0, 0.0))

    def tanh(self, value: Number) -> Number:
        """By exponentials: where heyoka's rounds to 1, all its Taylor coefficients are zero, and a
        step misses what follows.
        """
        import heyoka as hy

        self.called.append(("tanh", value))
        up, down = hy.exp(2.0 * value), hy.exp(-2.0 * value)
        return hy.select(
            hy.gte(value, 0.0), 1.0 - 2.0 * down / (1.0 + down), 2.0 * up / (1.0 + up) - 1.0
        )


#: One that serves where nobody asks what was called.
XP = HeyokaFunctions()
