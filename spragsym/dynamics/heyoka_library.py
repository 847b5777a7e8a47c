"""heyoka, without its warnings: it prints them on standard output, where results stand."""

from __future__ import annotations

import functools
from typing import Any

from ..interrupts import held


@functools.cache
def library() -> Any:
    """The module, which from now on reports errors only.

    Its warnings are of a cache that can't be written, as in a read-only home, and of its search for crossings near a tangency.
    ``heyoka.set_logger_level_warning()`` brings them back.
    """
    with held():
        import heyoka as hy
    hy.set_logger_level_error()
    return hy


class Functions:
    """The namespace ``xp`` of heyoka's expressions, whose functions take numbers too, as the 2 of sqrt(2)."""

    def __getattr__(self, name: str) -> Any:
        hy = library()
        found = getattr(hy, name)
        if isinstance(found, hy.expression):
            return found
        return lambda *values: found(*(hy.expression(float(it)) if isinstance(it, int | float) else it for it in values))


class Roots:
    """A namespace of functions which keeps the arguments of square roots: where one is zero a spring has no length."""

    def __init__(self, xp: Any) -> None:
        self._xp, self.arguments = xp, list[Any]()

    def __getattr__(self, name: str) -> Any:
        return getattr(self._xp, name)

    def sqrt(self, value: Any) -> Any:
        """The root; the argument is kept."""
        self.arguments.append(value)
        return self._xp.sqrt(value)


#: The one that is needed.
XP = Functions()
