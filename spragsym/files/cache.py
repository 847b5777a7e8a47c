"""Cache of generated texts in the user's cache folder, by a digest of what they are made of.

Nothing in it is believed that this user's own runs did not write: every entry is signed with a key
that only they can read, and files and folders of others, those that others may write, and links are
neither read nor written.
"""

import hashlib
import hmac
import json
import os
import re
import secrets
import stat
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path

from ..core.errors import ParameterError, SpragsymError, StoreError
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
        return _entry(cache_folder() / f"{name}.json", _key())
    files = make()
    with suppress(OSError, SpragsymError):
        path = cache_folder() / f"{name}.json"
        data = json.dumps(files).encode()
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        _require_own(path.parent)
        _write(path, _signature(path, data, _key(made=True)) + b"\n" + data)
        entries = [one for one in path.parent.glob("*.json") if one.is_file()]
        for old in sorted(entries, key=os.path.getmtime)[:-most]:
            old.unlink()
    return files


def cache_folder() -> Path:
    """Folder of cached results: below ``XDG_CACHE_HOME``, ``LOCALAPPDATA`` or ``~/.cache``.

    Raises
    ------
    ParameterError
        If that is relative: what it means depends on where a command is called.
    """
    usual = os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA")
    folder = Path(usual or os.path.expanduser("~/.cache")) / "spragsym"
    if not folder.is_absolute():
        raise ParameterError(
            f"the folder of the cache, {folder}, is relative; set XDG_CACHE_HOME or HOME to an "
            "absolute path"
        )
    return folder


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
    _require_own(path.parent)
    _require_own(path)
    signature, _, data = contents(path, _LARGEST).partition(b"\n")
    if not hmac.compare_digest(signature, _signature(path, data, key)):
        raise ValueError("not as it was written")
    files: dict[str, str] = json_of(data)
    name = r"(?!\.)[\w+ .-]+"  # as a page's name and those of packages allow
    below = re.compile(rf"{name}(/{name})*")
    if not files or not has_shape(files, dict):
        raise ValueError("no texts of files")
    if not all(below.fullmatch(name) and isinstance(text, str) for name, text in files.items()):
        raise ValueError("no texts of files below a folder")
    return files


def _signature(path: Path, data: bytes, key: bytes) -> bytes:
    """Of an entry under its name, so that it is taken for no other."""
    return hmac.digest(key, path.name.encode() + b"\n" + data, "sha256").hex().encode()


def _key(*, made: bool = False) -> bytes:
    """The user's key, beside the cache; made at random if it is missing."""
    path = cache_folder().with_name("spragsym-key")
    if made and not os.path.lexists(path):
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        _write(path, secrets.token_bytes(32))
    _require_own(path)
    if len(key := contents(path)) != 32:
        raise StoreError(f"{path} is damaged; remove it")
    return key


def _write(path: Path, data: bytes) -> None:
    """Write a file that only this user may read; a link or a file of others stays as it is."""
    if os.path.lexists(path):
        _require_own(path)
    put(path, data, private=True)


def _require_own(path: Path) -> None:
    """Raise for a link, for what belongs to others, and for what others may write.

    Raises
    ------
    StoreError
        With what it is.
    """
    about = path.lstat()
    plain = stat.S_ISREG(about.st_mode) or stat.S_ISDIR(about.st_mode)
    if not plain or (stat.S_ISREG(about.st_mode) and about.st_nlink > 1):
        raise StoreError(f"{path} is a link, or no file; remove it")
    if os.name == "posix" and (about.st_uid != os.geteuid() or about.st_mode & 0o022):
        raise StoreError(f"{path} is of another user, or others may write it; remove it")
