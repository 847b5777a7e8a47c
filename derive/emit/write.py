"""Writes a folder whole or not at all: the files are written to a new folder beside it, then the two change places."""

from __future__ import annotations

import hashlib
import shutil
import signal
import tempfile
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

SOURCES = Path(__file__).resolve().parent.parent


def source_hash() -> str:
    """SHA-256 over the names and bytes of all source files of ``derive/``."""
    digest = hashlib.sha256()
    files = (path for path in SOURCES.rglob("*") if path.is_file() and path.suffix not in (".pyc", ".pyo"))
    for path in sorted(files, key=lambda path: path.relative_to(SOURCES).as_posix()):
        digest.update(path.relative_to(SOURCES).as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()


def write(files: dict[str, str], target: Path) -> None:
    """Replace the folder ``target`` by one that holds ``files``; after a failure or an interruption it is as it was."""
    target = target.resolve()
    if target.exists() and not target.is_dir():
        raise FileExistsError(f"{target} is a file; name a folder to write")
    if target.exists() and any(target.iterdir()) and not (target / "ledger.json").exists():
        raise FileExistsError(f"{target} holds other files and no ledger.json; name an empty folder, or one written before")
    target.parent.mkdir(parents=True, exist_ok=True)
    fresh = Path(tempfile.mkdtemp(prefix=".generated-", dir=target.parent))
    retired = fresh.with_name(fresh.name + "-old")
    try:
        for name, text in files.items():
            path = fresh / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8", newline="\n")
        fresh.chmod(0o755)
        with _undisturbed():
            if target.exists():
                target.rename(retired)
            try:
                fresh.rename(target)
            except OSError:
                if retired.exists():
                    retired.rename(target)
                raise
    finally:
        shutil.rmtree(fresh, ignore_errors=True)
        if target.exists():
            shutil.rmtree(retired, ignore_errors=True)


@contextmanager
def _undisturbed() -> Iterator[None]:
    """Hold Ctrl-C back while the folders change places, and raise it afterwards."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    pending: list[int] = []
    previous = signal.signal(signal.SIGINT, lambda number, frame: pending.append(number))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, previous)
    if pending:
        raise KeyboardInterrupt
