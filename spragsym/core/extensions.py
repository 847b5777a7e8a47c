"""Extension modules, which compute only where they were built from the C sources beside them.

:file:`setup.py` compiles a digest of its sources into each. After a change of the sources without a
build, and for a build by other means, it is another one: NumPy then serves, since a proof by an
older bound would be none.
"""

from __future__ import annotations

import hashlib
import re
import sys
import warnings
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from pathlib import Path
from types import ModuleType

#: Folders of what the sources of all extension modules include, in the package.
INCLUDED = ("generated/c", "numerics")
PACKAGE = Path(__file__).parent.parent


def sources(source: Path, folders: list[Path]) -> Iterator[Path]:
    """A C source, and all files that it includes by a name in quotation marks, each once."""
    found = [source]
    for path in found:
        yield path
        for name in re.findall(r'^#include "(.+)"', path.read_text(encoding="utf-8"), re.MULTILINE):
            places = (folder / name for folder in (path.parent, *folders))
            included = next(filter(Path.is_file, places), path.parent / name)
            if included not in found:
                found.append(included)


def digest(paths: Iterator[Path]) -> str:
    """The SHA-256 of files by their names and contents, whatever ends their lines."""
    whole = hashlib.sha256()
    for path in paths:
        whole.update(f"{path.name}\n{path.read_text(encoding='utf-8')}".encode())
    return whole.hexdigest()


@cache
def extension(name: str) -> ModuleType | None:
    """The extension module of a name in the package, as ``"numerics._tape"``; None if there is
    none, and with a warning if it was compiled from other sources than those beside it.
    """
    try:
        module = import_module(f"spragsym.{name}")
    except ImportError:  # there was no compiler
        return None
    source = PACKAGE / f"{name.replace('.', '/')}.c"
    try:
        expected = digest(sources(source, [PACKAGE / folder for folder in INCLUDED]))
    except OSError:
        expected = "missing"
    if vars(module).get("DIGEST") == expected:
        return module
    root = PACKAGE.parent
    what = f"--config-settings editable_mode=compat -e {root}"
    warnings.warn(
        f"{module.__file__} was compiled from other sources than {source.name} and what that "
        "includes, and is not used: NumPy and SciPy serve, many times slower; build it anew: "
        f"{sys.executable} -m pip install --force-reinstall --no-deps "
        f"{what if (root / 'setup.py').is_file() else 'spragsym'}",
        stacklevel=3,
    )
    return None
