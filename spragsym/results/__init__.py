"""Results on equilibria, and on the points, curves and paths on which they change: one class each,
for every model.

``ss.results`` has the class of every other answer too: each stands beside its question in a later
room, and is loaded from there when it is asked for, as the stub says.
"""

import ast as _ast
import importlib as _importlib
import pathlib as _pathlib
from typing import Any as _Any

from ..display import Column
from .equilibria import Equilibria, EquilibriumType, Undecided
from .points import BifurcationSet, CriticalLoad, Curve, Jump, Path, Points
from .result import InUnits, Named, Result, Rows

__all__ = [
    "BifurcationSet",
    "Column",
    "CriticalLoad",
    "Curve",
    "Equilibria",
    "EquilibriumType",
    "InUnits",
    "Jump",
    "Named",
    "Path",
    "Points",
    "Result",
    "Rows",
    "Undecided",
]


def _listed() -> dict[str, str]:
    """The module of each class, by the stub that type checkers read."""
    stub = _pathlib.Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8")
    return {
        one.name: "." * line.level + (line.module or "")
        for line in _ast.parse(stub).body
        if isinstance(line, _ast.ImportFrom)
        for one in line.names
    }


def __getattr__(name: str) -> _Any:
    module = None if name.startswith("_") else _listed().get(name)
    if module is None:
        raise AttributeError(f"spragsym.results has no {name}")
    found = globals()[name] = getattr(_importlib.import_module(module, __name__), name)
    return found


def __dir__() -> list[str]:
    return sorted(_listed())
