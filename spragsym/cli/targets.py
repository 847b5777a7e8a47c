"""One rule for every command that writes: no file is overwritten without ``--force``; the refusal comes before any work."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeVar

import click

from ..errors import TargetError
from ..files.stored import overwriting
from ..files.writing import probe

F = TypeVar("F", bound=Callable[..., Any])


def force(function: F) -> F:
    """``--force``."""
    return click.option("--force", is_flag=True, help="Overwrite files that are in the way.")(function)


def refuse(paths: Iterable[Path], force: bool, *, made: bool = False) -> None:
    """Raise, before any work, if one of the files exists, unless it is to be overwritten, or if it can't be written."""
    targets = list(paths)
    found = [str(path) for path in targets if path.exists()]
    if found and not force:
        exist = "exists" if len(found) == 1 else "exist"
        raise TargetError(f"{', '.join(found)} {exist}; nothing was written; use --force to overwrite, or give another path")
    for path in targets:
        probe(path, made=made)


def holds(path: Path, text: str) -> bool:
    """Whether a file has exactly this text, so that there is nothing to write."""
    return path.is_file() and path.read_bytes() == text.encode()


@contextmanager
def resumed(force: bool) -> Iterator[None]:
    """Work that goes on in its file where it stopped; with ``force`` whatever is there, which stays until that is done."""
    try:
        with overwriting(force):
            yield
    except TargetError as error:
        raise TargetError(f"{error}, or use --force to overwrite") from error
