"""Long work with a file: gone on with where a call before it was ended, or loaded where one has finished it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import TypeVar

from .journal import Record, clear, journal
from .storage import check_target
from .writing import resolved

T = TypeVar("T")

_OVERWRITING: ContextVar[bool] = ContextVar("overwriting", default=False)


@contextmanager
def overwriting(asked: bool = True) -> Iterator[None]:
    """Within, a file that is there is computed anew; it stays as it is until the new one takes its place."""
    token = _OVERWRITING.set(asked)
    try:
        yield
    finally:
        _OVERWRITING.reset(token)


def stored(
    store: str | os.PathLike[str], key: str, total: int, bytes_needed: int, load: Callable[[Path], T],
    compute: Callable[[dict[int, Record], Callable[[int, Record], None]], T], save: Callable[[T, Path], None],
) -> T:  # fmt: skip
    """What ``compute`` gives of points that are done and of a function that keeps one more; saved, or loaded if it was.

    ``key`` is a fingerprint of all that the result depends on.
    """
    target = resolved(store)
    known = target.is_file() and not _OVERWRITING.get()
    if known:
        result = load(target)
        clear(target, key, total)
        return result
    check_target(target, bytes_needed)
    with journal(target, key, total) as (done, keep):
        if target.is_file() and not _OVERWRITING.get():  # another process has finished it in the meantime
            return load(target)
        result = compute(done, keep)
        save(result, target)
    return result
