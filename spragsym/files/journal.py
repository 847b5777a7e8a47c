"""The journal of a sweep: a file beside the result with a line for each finished point.

It is removed when the result is written. A line is a checksum and JSON; the checksum of a point
includes the fingerprint of its sweep, so that a line that is cut, changed or of another sweep is
never taken for a result.
"""

from __future__ import annotations

import errno
import hashlib
import json
import os
import stat
import warnings
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from io import FileIO
from pathlib import Path
from typing import Any, TypeAlias, cast

from filelock import lock_descriptor

from ..core.errors import DamageWarning, ParameterError, SpragsymError, StoreError, SweepError
from .storage import provenance, write_all
from .text import has_shape, json_of, printed

#: One point of a sweep: its measured values and, if it failed, why.
Record: TypeAlias = tuple[list[float], str]


@dataclass(frozen=True)
class _Points:
    """What is known of the points of a sweep: their number, and the numbers that each has."""

    total: int
    width: int | None

    def read(self, point: object) -> tuple[int, Record] | None:
        """The index and the record of a point; None where it is none of the sweep's."""
        if not has_shape(point, (int, [int | float], str)):
            return None
        index, values, reason = cast("tuple[int, list[float], str]", point)
        is_one = 0 <= index < self.total and len(values) in (0, self.width or len(values))
        return (index, (values, reason)) if is_one else None


def path_of(target: Path) -> Path:
    """Path of the journal of a result."""
    return target.with_name(target.name + ".partial")


@contextmanager
def journal(
    target: Path, fingerprint: str, total: int, width: int | None = None
) -> Iterator[tuple[dict[int, Record], Callable[[int, Record], None]]]:
    """Open the journal of ``target``: finished points of earlier runs, and a function that stores
    one more. A point is one of ``total``, and has no numbers or ``width`` of them.

    Every line is written before the next task begins. When the body ends without an error, having
    written the target, the journal is removed; an error says how many points are kept. A line that
    was cut short by a kill is dropped, a damaged one with a
    :class:`~spragsym.core.errors.DamageWarning`.

    Raises
    ------
    StoreError
        If another process has the journal, or the file can't be read or written or is no journal.
    ParameterError
        If it has points of another sweep.
    """
    path = path_of(target)
    with ExitStack() as stack:
        file, data = _opened(stack, path)
        done = _begun(file, path, fingerprint, data, _Points(total, width))

        def keep(index: int, record: Record) -> None:
            _append(file, path, _line(fingerprint, [index, *record]))
            done[index] = record

        kept = f"of {total} points are kept in {path}, and the same call goes on from there"
        try:
            yield done, keep
        except KeyboardInterrupt as stop:
            raise KeyboardInterrupt(f"{len(done)} {kept}") from stop
        except (SweepError, StoreError) as error:
            raise type(error)(f"{error}; {len(done)} {kept}") from error
        if os.name == "posix":
            path.unlink()  # while it is locked, so that no other process has it
    if os.name != "posix":
        # Windows can't remove an open file; if another process has it open, that one finds the
        # work done.
        with suppress(OSError):
            path.unlink()


def clear(target: Path, fingerprint: str, total: int) -> None:
    """Remove a journal that a killed process left beside its finished result, unless another
    process uses it.
    """
    if path_of(target).exists():
        with suppress(SpragsymError, OSError), journal(target, fingerprint, total):
            pass


def _opened(stack: ExitStack, path: Path) -> tuple[FileIO, bytes]:
    """Open and lock the journal until the stack is left; the file and its content.

    The journal itself is locked, so that no lock file is left behind. The system releases the lock
    when the process ends. On a network file system the lock holds between machines as far as the
    file system's own locks do.
    """
    try:
        while True:
            file = stack.enter_context(FileIO(path, "a+", opener=_no_link))
            with suppress(FileNotFoundError):
                if not _locked(file, path) or os.path.samestat(
                    os.fstat(file.fileno()), path.stat()
                ):
                    return file, _whole(file, path)
            file.close()  # it was renamed or removed between opening and locking
    except StoreError:
        raise
    except OSError as error:
        raise StoreError(
            f"{path} cannot be read and written: {error.strerror}; give another path"
        ) from error


def _no_link(path: str, flags: int) -> int:
    """Open a file, or make it; a link is neither followed nor is what it leads to made."""
    return os.open(path, flags | getattr(os, "O_NOFOLLOW", 0), 0o666)


def _whole(file: FileIO, path: Path) -> bytes:
    """All bytes of a journal."""
    about, largest = os.fstat(file.fileno()), 1 << 32
    if not stat.S_ISREG(about.st_mode) or about.st_nlink > 1 or about.st_size > largest:
        raise StoreError(
            f"{path} is no file, or one of several names, or has more than {largest} bytes; remove "
            "it, or give another path"
        )
    file.seek(0)
    return file.read(about.st_size) or b""


def _locked(file: FileIO, path: Path) -> bool:
    """Lock the file; return whether the file system supports locks, and warn if not."""
    try:
        if not lock_descriptor(file.fileno(), blocking=False):
            raise StoreError(
                f"{path} is being written by another process or thread; wait for it to end, or "
                "give another path"
            )
    except OSError as error:
        # Some network and cluster file systems have no locks.
        if error.errno not in (errno.ENOLCK, errno.ENOSYS, errno.EOPNOTSUPP, errno.EINVAL):
            raise
        warnings.warn(
            f"{path} lies on a file system without locks ({error.strerror}): nothing keeps a "
            "second process from "
            "writing there; start one only, or give a path on a local disk",
            stacklevel=2,
        )
        return False
    return True


# ------------------------------------------------------------------------------------------------
# lines


def _line(key: str, content: object) -> bytes:
    """A line with its checksum; ``key`` is the fingerprint for a point, empty for other lines."""
    text = json.dumps(content).encode()
    return _checksum(key, text) + b" " + text + b"\n"


def _checksum(key: str, text: bytes) -> bytes:
    return hashlib.sha256(key.encode() + b" " + text).hexdigest()[:16].encode()


def _content(key: str, line: bytes) -> Any:
    """The content of a line; None if the checksum is wrong, or it is no JSON."""
    checksum, _, text = line.partition(b" ")
    with suppress(ValueError):
        return json_of(text) if checksum == _checksum(key, text) else None
    return None


def _begun(
    file: FileIO, path: Path, fingerprint: str, data: bytes, expected: _Points
) -> dict[int, Record]:
    """The undamaged points of this sweep; warns of damage and makes the file ready for appending.

    Raises
    ------
    ParameterError
        If the lines are of another sweep.
    StoreError
        If the file is no journal.
    """
    *lines, cut = data.split(b"\n")
    points, damaged, owner = dict[int, Record](), list[int](), None
    for number, line in enumerate(lines, 1):
        point, other = expected.read(_content(fingerprint, line)), _content("", line)
        if point is not None and point[0] not in points:
            index, record = point
            printed(str(path), record[1])
            points[index] = record
        elif has_shape(other, {"journal": int, "fingerprint": str}):
            owner = other["fingerprint"]
        else:
            damaged.append(number)
    head = _line("", {"journal": 1, "fingerprint": fingerprint, **provenance()})
    ours = owner == fingerprint or bool(points)
    if not ours and owner is not None and damaged:
        # Lines that look damaged may be points of another sweep.
        raise ParameterError(
            f"{path} belongs to another sweep, or to other code; remove it to start anew, or "
            "give another path"
        )
    # A part of the first line may be left by a kill or a full disk.
    if not ours and owner is None and not head.startswith(data):
        raise StoreError(
            f"{path} is damaged, no journal, or one of an older version: its first line is "
            "not as it is written, and no "
            "other line is a point of this sweep; remove it to start anew, or give another path"
        )
    if damaged:
        shown = ", ".join(map(str, damaged[:10])) + (", …" if len(damaged) > 10 else "")
        warnings.warn(
            f"{path}: {len(damaged)} damaged line{'s' * (len(damaged) > 1)} ({shown}): not as "
            "written, by their "
            f"checksums or parts; the {len(points)} points of the other lines are good, and what "
            "is lost is computed again",
            DamageWarning,
            stacklevel=2,
        )
    # Drop the beginning of a line that a killed process left.
    file.truncate(len(data) - len(cut) if ours else 0)
    if not ours:
        _append(file, path, head)
    return points


def _append(file: FileIO, path: Path, line: bytes) -> None:
    """Append a line completely, or leave the file as it was and raise."""
    end = file.seek(0, os.SEEK_END)
    try:
        write_all(file, line)
    except BaseException as error:
        with suppress(OSError):
            file.truncate(end)
        if not isinstance(error, OSError):
            raise
        raise StoreError(
            f"{path} cannot be written: {error.strerror}; make room, or give another path"
        ) from error
