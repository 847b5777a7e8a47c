"""Atomic writing of files: to a temporary file beside the target, flushed to the disk, then renamed.

Whatever ends a write, a full disk or a kill, what stood there before stays, and nothing half-written stands under a name that was
asked for. What a killed process leaves, ``.spragsym-`` with its number, is removed by the next write to the same folder.
"""

import errno
import math
import os
import re
import secrets
import shutil
import stat
import time
from contextlib import suppress
from pathlib import Path

from ..errors import ParameterError, StoreError
from .locks import write_all

_LEFT = re.compile(r"\.spragsym-(\d+)-[0-9a-f]{16}")
#: Seconds after which a write has ended, wherever its process runs.
_AGE = 3600.0


def resolved(path: str | os.PathLike[str]) -> Path:
    """The file that a path leads to through links, even if it does not exist yet."""
    try:
        target = Path(path).resolve()
        if target.is_symlink():
            target.stat()  # raises what Python from 3.13 on no longer says when it resolves
        if target.exists() and not target.is_file() and not target.is_dir():
            raise ParameterError(f"{path} is a device or a pipe; give the name of a file")
    except (OSError, RuntimeError, ValueError) as error:  # a link that leads to itself, a name too long, a NUL within
        reason = getattr(error, "strerror", None) or error
        raise ParameterError(f"{os.fspath(path)[:200]!r} leads nowhere ({reason}); give another path") from error
    return target


def probe(path: str | os.PathLike[str], bytes_needed: int = 0, *, made: bool = False) -> Path:
    """Where a path leads, found out before any work: a ParameterError if no file can be written there.

    ``made`` is for folders that are made on writing: the nearest one that exists is tried.
    """
    target = resolved(path)
    folder = target.parent
    while made and not folder.exists() and folder != folder.parent:
        folder = folder.parent
    if target.is_dir() or not folder.is_dir():
        problem = "is a folder" if target.is_dir() else "lies in a folder that does not exist"
        raise ParameterError(f"{target} {problem}; give the name of a file in an existing folder")
    try:
        os.close(_opened(trial := _beside(folder)))
        trial.unlink()
        free = shutil.disk_usage(folder).free
    except OSError as error:
        raise ParameterError(
            f"{target} cannot be written ({error.strerror}); give another path, or the right to write there"
        ) from error
    if free < bytes_needed:
        needed, there = (f"{math.ceil(size / 1e6)} MB" for size in (bytes_needed, free))
        raise ParameterError(f"{target}: about {needed} are needed and {there} are free; make room, or write to another disk")
    return target


def put(path: str | os.PathLike[str], data: bytes | str, *, made: bool = False) -> None:
    """Write a file, whole or not at all, or raise a StoreError that names it; a file that was there keeps its mode.

    ``made`` is for a folder that is made if missing.
    """
    target = resolved(path)
    try:
        if made:
            target.parent.mkdir(parents=True, exist_ok=True)
        _remove_left(target.parent)
        _replace(target, data.encode() if isinstance(data, str) else data)
        _settle(target.parent)
    except PermissionError as error:  # on Windows also while a spreadsheet shows the file that was there
        raise StoreError(
            f"{target} cannot be written: {error.strerror}; close what has it open, or give a path where you may write"
        ) from error
    except OSError as error:
        raise StoreError(f"{target} cannot be written: {error.strerror}; make room, or give another path") from error


def _replace(target: Path, data: bytes) -> None:
    temporary = _beside(target.parent)
    number = _opened(temporary)
    try:
        with open(number, "wb", buffering=0) as file:
            write_all(file, data)
            with suppress(OSError):
                os.chmod(temporary, stat.S_IMODE(target.stat().st_mode))
            os.fsync(number)
        os.replace(temporary, target)
    except BaseException:
        with suppress(OSError):
            temporary.unlink()
        raise


def _beside(folder: Path) -> Path:
    return folder / f".spragsym-{os.getpid()}-{secrets.token_hex(8)}"


def _opened(path: Path) -> int:
    """A new file, never one that is there, nor what a link leads to."""
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
    return os.open(path, flags, 0o666)


def _remove_left(folder: Path) -> None:
    """Remove what killed writes left in a folder."""
    with suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            found = _LEFT.fullmatch(entry.name)
            if found and entry.is_file(follow_symlinks=False):
                old = time.time() - entry.stat(follow_symlinks=False).st_mtime > _AGE
                if old or not _runs(int(found[1])):
                    os.unlink(entry.path)


def _runs(process: int) -> bool:
    """Whether a process may be there; on Windows it can't be asked without harm."""
    if os.name != "posix":
        return True
    try:
        os.kill(process, 0)
    except OSError as error:
        return error.errno != errno.ESRCH
    except OverflowError:
        return False
    return True


def _settle(folder: Path) -> None:
    """Make a new name in a folder survive a power cut, on systems that can do this."""
    with suppress(OSError):
        number = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(number)
        finally:
            os.close(number)
