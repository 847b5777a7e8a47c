"""One rule for every command that writes: no file is overwritten without ``--force``; the refusal comes before any work."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import Any, TypeVar

import click

from ..errors import TargetError

F = TypeVar("F", bound=Callable[..., Any])


def force(function: F) -> F:
    """``--force``."""
    return click.option("--force", is_flag=True, help="Overwrite files that are in the way.")(function)


def refuse(paths: Iterable[Path], force: bool) -> None:
    """Raise if one of the files exists, unless it is to be overwritten."""
    found = [str(path) for path in paths if path.exists()]
    if found and not force:
        exist = "exists" if len(found) == 1 else "exist"
        raise TargetError(f"{', '.join(found)} {exist}; nothing was written; use --force to overwrite, or give another path")


def holds(path: Path, text: str) -> bool:
    """Whether a file has exactly this text, so that there is nothing to write."""
    return path.is_file() and path.read_bytes() == text.encode()


@contextmanager
def set_aside(path: Path) -> Iterator[None]:
    """Move a file away, and move it back if the body has not written a new one."""
    if not path.is_file():
        yield
        return
    before = path.with_name(path.name + ".before")
    path.replace(before)
    try:
        yield
    finally:
        if path.exists():
            before.unlink()
        else:
            before.replace(path)


@contextmanager
def resumed(path: Path, force: bool) -> Iterator[None]:
    """Work that goes on in its file where it stopped; with ``force`` from the beginning, the old file kept until that is done."""
    try:
        with set_aside(path) if force else nullcontext():
            yield
    except TargetError as error:
        raise TargetError(f"{error}, or use --force to overwrite") from error
