"""A file that one process at a time may write to; killing the process releases it.

The file itself is locked, so that no other one is left beside it. On Windows nobody else can read its first byte meanwhile.
"""

import errno
import os
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from io import FileIO
from pathlib import Path

from filelock import lock_descriptor

from ..errors import StoreError

#: The file system has no locks: some network and cluster file systems, as they are mounted.
_NO_LOCKS = (errno.ENOLCK, errno.ENOSYS, errno.EOPNOTSUPP, errno.EINVAL)


class HeldError(StoreError):
    """Another process, or another thread of this one, writes to the file."""


@contextmanager
def exclusive(path: Path) -> Iterator[FileIO]:
    """Open a file to read and append, created if absent, for this caller alone until the context ends, or raise a HeldError.

    The system lets go of the lock when the process ends, whatever ends it. On a network file system it holds between machines as
    far as the file system's own locks do; where there are none, a warning says so.
    """
    with _opened(path) as file:
        yield file


def _opened(path: Path) -> FileIO:
    while True:
        file = open(path, "a+b", buffering=0)  # noqa: SIM115 -- whoever asked closes it
        try:
            if _locked(file) and not _is_at(file, path):
                file.close()  # it was renamed or removed between opening and locking
                continue
        except BaseException:
            file.close()
            raise
        return file


def _locked(file: FileIO) -> bool:
    """Lock the file, and return whether the file system supports locks."""
    try:
        if not lock_descriptor(file.fileno(), blocking=False):
            raise HeldError(f"{file.name} is being written by another process; wait for it, or give another path")
    except OSError as error:
        if error.errno not in _NO_LOCKS:
            raise
        warnings.warn(
            f"{file.name} lies on a file system without locks ({error.strerror}): nothing keeps a second process from "
            "writing there; start one only, or give a path on a local disk",
            stacklevel=2,
        )
        return False
    return True


def _is_at(file: FileIO, path: Path) -> bool:
    try:
        return os.path.samestat(os.fstat(file.fileno()), path.stat())
    except FileNotFoundError:
        return False


def write_all(file: FileIO, data: bytes) -> None:
    """Write everything or raise: an almost full disk accepts a part, and fails only at the next write."""
    view = memoryview(data)
    while view:
        view = view[file.write(view) :]
