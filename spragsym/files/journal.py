"""The journal of a sweep: a file beside the result with a line for each finished point.

It is removed when the result is written. A line is a signature with the user's key and JSON; that
of a point is under the fingerprint of its sweep, so that a line that is cut, changed, of another
sweep or of another user is never taken for a result.
"""

from __future__ import annotations

import errno
import hmac
import json
import os
import secrets
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
from .own import signature, user_key
from .storage import provenance, write_all
from .text import Shape, has_shape, json_of, printed

#: What a first line holds.
_HEAD: Shape = {"journal": int, "fingerprint": str}
#: One point of a sweep: its measured values and, if it failed, why.
Record: TypeAlias = tuple[list[float], str]


@dataclass(frozen=True)
class _Sweep:
    """What is known of a sweep: the key and the name with which its points are signed, their
    number, and the numbers that each has.
    """

    key: bytes
    fingerprint: str
    total: int
    width: int | None

    def read(self, point: object) -> tuple[int, Record] | None:
        """The index and the record of a point; None where it is none of the sweep's."""
        if not has_shape(point, (int, [int | float], str)):
            return None
        index, values, reason = cast("tuple[int, list[float], str]", point)
        is_one = 0 <= index < self.total and len(values) in (0, self.width or len(values))
        return (index, (values, reason)) if is_one else None

    def head(self) -> bytes:
        """The first line."""
        about = {"journal": 2, "fingerprint": self.fingerprint, **provenance()}
        return _line(self.key, "", about)


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
        If another process has the journal, or the file can't be read or written, is no journal or
        is signed with another key.
    ParameterError
        If it has points of another sweep.
    """
    path = path_of(target)
    with ExitStack() as stack:
        file, data = _opened(stack, path)
        sweep = _Sweep(_key(path), fingerprint, total, width)
        done = _begun(file, path, data, sweep)

        def keep(index: int, record: Record) -> None:
            _append(file, path, _line(sweep.key, fingerprint, [index, *record]))
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


def _key(path: Path) -> bytes:
    """The user's key; one that is lost with this process, and a warning, where none can be kept."""
    try:
        return user_key()
    except SpragsymError as error:
        warnings.warn(
            f"no process but this one can go on from {path}, which your key would sign: {error}",
            stacklevel=2,
        )
        return secrets.token_bytes()


def _line(key: bytes, about: str, content: object) -> bytes:
    """A signed line, about the fingerprint for a point, about nothing for other lines."""
    text = json.dumps(content).encode()
    return signature(key, about, text) + b" " + text + b"\n"


def _signed(line: bytes, key: bytes, about: str) -> Any:
    """The content of a line; None if it was not signed so."""
    signed, _, text = line.partition(b" ")
    return _content(line) if hmac.compare_digest(signed, signature(key, about, text)) else None


def _content(line: bytes) -> Any:
    """The content of a line, whoever signed it; None if it is no JSON."""
    with suppress(ValueError):
        return json_of(line.partition(b" ")[2])
    return None


def _begun(file: FileIO, path: Path, data: bytes, sweep: _Sweep) -> dict[int, Record]:
    """The undamaged points of this sweep; warns of damage and makes the file ready for appending.

    Raises
    ------
    ParameterError
        If the lines are of another sweep.
    StoreError
        If the file is no journal, or signed with another key.
    """
    *lines, cut = data.split(b"\n")
    points, damaged, owner = dict[int, Record](), list[int](), None
    for number, line in enumerate(lines, 1):
        point = sweep.read(_signed(line, sweep.key, sweep.fingerprint))
        other = _signed(line, sweep.key, "")
        if point is not None and point[0] not in points:
            index, record = point
            printed(str(path), record[1])
            points[index] = record
        elif has_shape(other, _HEAD):
            owner = other["fingerprint"]
        else:
            damaged.append(number)
    head = sweep.head()
    ours = owner == sweep.fingerprint or bool(points)
    if not ours and owner is not None and damaged:
        # Lines that look damaged may be points of another sweep.
        raise ParameterError(
            f"{path} belongs to another sweep, or to other code; remove it to start anew, or "
            "give another path"
        )
    if not ours and owner is None and lines and has_shape(_content(lines[0]), _HEAD):
        raise StoreError(
            f"{path} is not signed with your key: another user wrote it, or you on a machine with "
            "another home or by an older version; remove it to start anew, or, if it is yours, set "
            "XDG_CACHE_HOME to the folder that holds the spragsym-key of where it was written"
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
            f"signatures or parts; the {len(points)} points of the other lines are good, and what "
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
