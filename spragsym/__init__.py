"""Sprag-slip oscillation as a cusp catastrophe: equilibria, stability, folds, cusps, jumps and
motion in time.

The model is that of J. Kang and J. Nam, "Minimal Model for Sprag-Slip Oscillation as
Catastrophe-Type Behavior", Applied Sciences 10 (2020) 2748, as derived from first principles in
``derive/``. Names below are loaded when they are used.

Examples
--------
>>> import numpy as np, spragsym as ss
>>> p = ss.Parameters.article(theta0=np.radians(49))
>>> ss.equilibria(p).count
array(1, dtype=int8)
"""

import importlib.util as _util
import pathlib as _pathlib
import sys as _sys
from typing import Any as _Any

import lazy_loader as _lazy

# A link to this folder, from wherever, leads to its checkout.
_HERE = _pathlib.Path(__file__).resolve().parent


def _find_beside(name: str) -> None:
    """Import a part of this package from beside it: it alone, since a path to all that is there
    leads to this package again.
    """
    whole = f"{__name__}.{name}"
    spec = _util.spec_from_file_location(whole, _HERE.parent / name / "__init__.py")
    assert spec is not None
    assert spec.loader is not None
    module = _sys.modules[whole] = globals()[name] = _util.module_from_spec(spec)
    spec.loader.exec_module(module)


# In a checkout derive/ and generated/ stand beside this folder, with links to them in it; where
# links can't be made, as by git on Windows unless it is told to, the folders are found beside it
# all the same.
for _name in ("derive", "generated"):
    if not (_HERE / _name).is_dir() and (_HERE.parent / _name / "__init__.py").is_file():
        _find_beside(_name)

# Names are read from the list that type checkers read, and loaded when they are used.
_named, __dir__, __all__ = _lazy.attach_stub(__name__, __file__)
__all__.remove("open")  # which an import of all names would put in the place of Python's own


def __getattr__(name: str) -> _Any:
    try:
        return _named(name)
    except AttributeError as error:
        if name.startswith("_"):
            raise
        for room in ("errors", "results", "kang_nam"):
            if name in dir(_named(room)):  # where it stood before
                remedy = f"write spragsym.{room}.{name}"
                raise AttributeError(f"spragsym has no {name}; {remedy}") from error
        meant = _named("errors").hint(name, __all__) or "; pictures are drawn by spragsym.figures"
        raise AttributeError(f"spragsym has no {name}{meant}") from error
