"""Sprag-slip oscillation as a cusp catastrophe: equilibria, stability, folds, cusps, jumps and motion in time.

The model is that of J. Kang and J. Nam, "Minimal Model for Sprag-Slip Oscillation as Catastrophe-Type Behavior", Applied
Sciences 10 (2020) 2748, as derived from first principles in ``derive/``. Names below are loaded when they are used.

Examples
--------
>>> import numpy as np, spragsym as ss
>>> p = ss.Parameters.article(theta0=np.radians(49))
>>> ss.equilibria(p).count
array(1, dtype=int8)
"""

from __future__ import annotations

import sys as _sys

if (_sys.argv[0] == "-m" and "spragsym" in _sys.orig_argv) or _sys.argv[0].endswith(("/spragsym", "\\spragsym")):
    import _signal

    # As a command: until that hears Ctrl-C itself, it ends the process, without a traceback of what is imported.
    _signal.signal(_signal.SIGINT, _signal.SIG_DFL)

import importlib as _importlib
import importlib.util as _util
import pathlib as _pathlib
import re as _re
from typing import Any as _Any

_HERE = _pathlib.Path(__file__).resolve().parent  # a link to this folder, from wherever, leads to its checkout


def _find_beside(name: str) -> None:
    """Import a part of this package from beside it: it alone, since a path to all that is there leads to this package again."""
    whole = f"{__name__}.{name}"
    spec = _util.spec_from_file_location(whole, _HERE.parent / name / "__init__.py")
    assert spec is not None
    assert spec.loader is not None
    module = _sys.modules[whole] = globals()[name] = _util.module_from_spec(spec)
    spec.loader.exec_module(module)


# In a checkout derive/ and generated/ stand beside this folder, with links to them in it; where links can't be made, as by git on
# Windows unless it is told to, the folders are found beside it all the same.
for _name in ("derive", "generated"):
    if not (_HERE / _name).is_dir() and (_HERE.parent / _name / "__init__.py").is_file():
        _find_beside(_name)

_LIST = _pathlib.Path(__file__).with_suffix(".pyi")
#: Public name → where it is, read from the list that type checkers read. The name of a module stands for the module.
_HOMES = {
    name: home
    for home, name in _re.findall(r"^from (\.[\w.]*) import (\w+) as", _LIST.read_text(encoding="utf-8"), _re.MULTILINE)
}

__all__ = sorted({*_HOMES} - {"open"})  # which an import of all names would put in the place of Python's own


def __getattr__(name: str) -> _Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    home = _HOMES[name]
    module = _importlib.import_module(f".{name}" if home == "." else home, __name__)
    value = module if home == "." else getattr(module, name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOMES})
