"""Cache of generated texts in the user's cache folder, by a digest of what they are made of."""

import hashlib
import json
import os
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path

from ..core.errors import SpragsymError
from .storage import put, sealed, verified


def cached(
    made_of: Mapping[str, object], make: Callable[[], dict[str, str]], most: int = 64
) -> dict[str, str]:
    """Texts of files by name: from the cache if they were made of the same before, else by
    ``make()``.

    A damaged entry is made again, and one that can't be written is not kept; neither is an error.
    The cache holds the ``most`` recent entries.
    """
    key = hashlib.sha256(json.dumps(made_of, sort_keys=True).encode()).hexdigest()
    path = cache_folder() / f"{key}.json"
    with suppress(SpragsymError):
        files: dict[str, str] = json.loads(verified(path))
        return files
    files = make()
    with suppress(OSError, SpragsymError):
        put(path, sealed(json.dumps(files).encode()), made=True)
        for old in sorted(path.parent.glob("*.json"), key=os.path.getmtime)[:-most]:
            old.unlink()
    return files


def cache_folder() -> Path:
    """Folder of cached results: below ``XDG_CACHE_HOME``, ``LOCALAPPDATA`` or ``~/.cache``."""
    usual = os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA")
    return Path(usual or Path.home() / ".cache") / "spragsym"


def digest_of_folder(folder: Path) -> str:
    """SHA-256 of the names and bytes of a folder's files, without what Python compiled."""
    digest = hashlib.sha256()
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.suffix != ".pyc":
            data = path.read_bytes()
            digest.update(f"{path.relative_to(folder).as_posix()}\0{len(data)}\0".encode() + data)
    return digest.hexdigest()
