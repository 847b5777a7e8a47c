"""Files that this user's own runs wrote, told from all others: by a key that only they can read.

The key signs the entries of the cache and the lines of journals. Files and folders of others, those
that others may write, and links are none of the user's.
"""

from __future__ import annotations

import hmac
import os
import secrets
import stat
import time
from contextlib import suppress
from pathlib import Path

from ..core.errors import ParameterError, StoreError
from .storage import new_file
from .text import contents

#: Bytes of a key.
_LENGTH = 32


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


def user_key() -> bytes:
    """The user's key, beside the cache; made at random if it is missing.

    Raises
    ------
    ParameterError
        If it has no place.
    StoreError
        If it can't be read or made, or is not the user's own.
    """
    path = key_path()
    try:
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        # Of processes that begin at once, one makes it.
        with suppress(FileExistsError), open(new_file(path, 0o600), "wb", buffering=0) as file:
            file.write(secrets.token_bytes(_LENGTH))
        require_own(path)
    except OSError as error:
        raise StoreError(
            f"{path} can't be read or made: {error.strerror}; set XDG_CACHE_HOME to a folder of "
            "yours"
        ) from error
    for wait in (0.0, 0.1, 1.0):  # another process may be making it
        time.sleep(wait)
        if len(key := contents(path)) == _LENGTH:
            return key
    raise StoreError(f"{path} is damaged; remove it")


def key_path() -> Path:
    """The file of the user's key."""
    return cache_folder().with_name("spragsym-key")


def signature(key: bytes, about: str, data: bytes) -> bytes:
    """Of data under a name, in hexadecimal digits."""
    return hmac.digest(key, about.encode() + b"\n" + data, "sha256").hex().encode()


def require_own(path: Path) -> None:
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
