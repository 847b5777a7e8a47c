"""Sprag-slip oscillation as a cusp catastrophe: equilibria, stability, folds, cusps, jumps and motion in time.

The model is that of J. Kang and J. Nam, "Minimal Model for Sprag-Slip Oscillation as Catastrophe-Type Behavior", Applied
Sciences 10 (2020) 2698, as derived from first principles in ``derive/``. Names below are loaded when they are used.

Examples
--------
>>> import numpy as np, spragsym as ss
>>> p = ss.Parameters.article(theta0=np.radians(49))
>>> ss.equilibria(p).count
array(1)
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from ._version import __version__
from .errors import ConvergenceError, MissingExtraError, ParameterError, ParameterTypeError, SpragsymError
from .parameters import Parameters, PhysicalParameters, Scales

if TYPE_CHECKING:
    from . import precise as precise
    from .solver import Equilibria as Equilibria
    from .solver import Stability as Stability
    from .solver import equilibria as equilibria

#: Public name → module that defines it. A module's own name stands for the module.
_LAZY: dict[str, str] = {
    "Equilibria": "solver",
    "Stability": "solver",
    "equilibria": "solver",
    "precise": "precise",
}

__all__ = [
    "ConvergenceError",
    "MissingExtraError",
    "ParameterError",
    "ParameterTypeError",
    "Parameters",
    "PhysicalParameters",
    "Scales",
    "SpragsymError",
    "__version__",
    *_LAZY,
]


def __getattr__(name: str) -> Any:
    if name not in _LAZY:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module = importlib.import_module(f".{_LAZY[name]}", __name__)
    value = getattr(module, name, module)  # a module's own name, such as precise, stands for the module
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_LAZY})
