"""Cache of generated texts in the user's cache folder, by a digest of what they are made of.

Nothing in it is believed that this user's own runs did not write: every entry is signed under its
name, so that it is taken for no other, and what is not the user's is neither read nor written.
"""

import hashlib
import hmac
import json
import os
import re
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path

from ..core.errors import SpragsymError
from .own import cache_folder, require_own, signature, user_key
from .storage import put
from .text import contents, has_shape, json_of

#: Largest size in bytes of an entry.
_LARGEST = 1 << 26


def cached(
    made_of: Mapping[str, object], make: Callable[[], dict[str, str]], most: int = 64
) -> dict[str, str]:
    """Texts of files by name: from the cache if they were made of the same before, else by
    ``make()``.

    An entry that is damaged or foreign is made again, and one that can't be written is not kept;
    neither is an error. The cache holds the ``most`` recent entries.
    """
    name = hashlib.sha256(json.dumps(made_of, sort_keys=True).encode()).hexdigest()
    with suppress(OSError, SpragsymError, ValueError):
        return _entry(cache_folder() / f"{name}.json", user_key())
    files = make()
    with suppress(OSError, SpragsymError):
        path = cache_folder() / f"{name}.json"
        data = json.dumps(files).encode()
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        require_own(path.parent)
        _write(path, signature(user_key(), path.name, data) + b"\n" + data)
        entries = [one for one in path.parent.glob("*.json") if one.is_file()]
        for old in sorted(entries, key=os.path.getmtime)[:-most]:
            old.unlink()
    return files


def digest_of_folder(folder: Path) -> str:
    """SHA-256 of the names and bytes of a folder's files, without what Python compiled."""
    digest = hashlib.sha256()
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.suffix != ".pyc":
            data = path.read_bytes()
            digest.update(f"{path.relative_to(folder).as_posix()}\0{len(data)}\0".encode() + data)
    return digest.hexdigest()


def _entry(path: Path, key: bytes) -> dict[str, str]:
    """The texts of an entry.

    Raises
    ------
    ValueError
        If it is not as it was written, or names a file that lies in no folder below.
    """
    require_own(path.parent)
    require_own(path)
    signed, _, data = contents(path, _LARGEST).partition(b"\n")
    if not hmac.compare_digest(signed, signature(key, path.name, data)):
        raise ValueError("not as it was written")
    files: dict[str, str] = json_of(data)
    name = r"(?!\.)[\w+ .-]+"  # as a page's name and those of packages allow
    below = re.compile(rf"{name}(/{name})*")
    if not files or not has_shape(files, dict):
        raise ValueError("no texts of files")
    if not all(below.fullmatch(name) and isinstance(text, str) for name, text in files.items()):
        raise ValueError("no texts of files below a folder")
    return files


def _write(path: Path, data: bytes) -> None:
    """Write a file that only this user may read; a link or a file of others stays as it is."""
    if os.path.lexists(path):
        require_own(path)
    put(path, data, private=True)
