"""heyoka, without its warnings: it prints them on standard output, where results stand."""

from __future__ import annotations

from typing import Any


def library() -> Any:
    """The module, which from now on reports errors only.

    Its warnings are of a cache that can't be written, as in a read-only home, and of its search for crossings near a tangency.
    ``heyoka.set_logger_level_warning()`` brings them back.
    """
    import heyoka as hy

    hy.set_logger_level_error()
    return hy
