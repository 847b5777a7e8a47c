"""Results on equilibria, and on the points, curves and paths on which they change: one class each,
for every model.

``ss.results`` has the class of every other answer too: each stands beside its question in a later
room. All are loaded when they are asked for.
"""

import ast as _ast
import importlib as _importlib
import pathlib as _pathlib
from typing import Any as _Any

# The module of each class, by the stub that type checkers read; ``lazy_loader`` takes none that
# lies outside of the package.
_MODULES = {
    one.name: "." * line.level + (line.module or "")
    for line in _ast.parse(
        _pathlib.Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8")
    ).body
    if isinstance(line, _ast.ImportFrom)
    for one in line.names
}


def __getattr__(name: str) -> _Any:
    if name not in _MODULES:
        raise AttributeError(f"spragsym.results has no {name}")
    found = globals()[name] = getattr(_importlib.import_module(_MODULES[name], __name__), name)
    return found


def __dir__() -> list[str]:
    return sorted(_MODULES)
