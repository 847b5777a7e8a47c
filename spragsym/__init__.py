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

import importlib
from typing import TYPE_CHECKING, Any

from ._version import __version__
from .errors import BackendError, ConvergenceError, MissingExtraError, ParameterError, ParameterTypeError, SpragsymError
from .parameters import Parameters, PhysicalParameters, Scales

if TYPE_CHECKING:
    from . import figures as figures
    from . import precise as precise
    from .backends import get_backend as get_backend
    from .backends import set_backend as set_backend
    from .catastrophe import BifurcationSet as BifurcationSet
    from .catastrophe import Cusps as Cusps
    from .catastrophe import FoldCurve as FoldCurve
    from .catastrophe import Folds as Folds
    from .catastrophe import LinearSprag as LinearSprag
    from .catastrophe import Surface as Surface
    from .catastrophe import bifurcation_set as bifurcation_set
    from .catastrophe import critical_friction as critical_friction
    from .catastrophe import critical_value as critical_value
    from .catastrophe import cusps as cusps
    from .catastrophe import folds as folds
    from .catastrophe import linear_critical_friction as linear_critical_friction
    from .catastrophe import linear_sprag as linear_sprag
    from .catastrophe import sliding_friction as sliding_friction
    from .catastrophe import surface as surface
    from .dynamics import Event as Event
    from .dynamics import Events as Events
    from .dynamics import Trajectory as Trajectory
    from .dynamics import simulate as simulate
    from .flutter import FlutterBoundary as FlutterBoundary
    from .flutter import FlutterOnsets as FlutterOnsets
    from .flutter import flutter_boundary as flutter_boundary
    from .flutter import flutter_onsets as flutter_onsets
    from .paths import Jump as Jump
    from .paths import Path as Path
    from .paths import quasi_static_path as quasi_static_path
    from .regimes import Outcome as Outcome
    from .regimes import Regime as Regime
    from .solver import Equilibria as Equilibria
    from .solver import Stability as Stability
    from .solver import count as count
    from .solver import equilibria as equilibria
    from .sweeps import Basin as Basin
    from .sweeps import Sensitivity as Sensitivity
    from .sweeps import Sweep as Sweep
    from .sweeps import basin as basin
    from .sweeps import rms_sweep as rms_sweep
    from .sweeps import sensitivity as sensitivity

#: Public name → module that defines it. A module's own name stands for the module.
_LAZY: dict[str, str] = {
    "count": "solver",
    "Equilibria": "solver",
    "equilibria": "solver",
    "Stability": "solver",
    "bifurcation_set": "catastrophe",
    "BifurcationSet": "catastrophe",
    "critical_friction": "catastrophe",
    "critical_value": "catastrophe",
    "Cusps": "catastrophe",
    "cusps": "catastrophe",
    "flutter_boundary": "flutter",
    "flutter_onsets": "flutter",
    "FlutterBoundary": "flutter",
    "FlutterOnsets": "flutter",
    "FoldCurve": "catastrophe",
    "Folds": "catastrophe",
    "folds": "catastrophe",
    "linear_critical_friction": "catastrophe",
    "linear_sprag": "catastrophe",
    "LinearSprag": "catastrophe",
    "sliding_friction": "catastrophe",
    "Surface": "catastrophe",
    "surface": "catastrophe",
    "Jump": "paths",
    "Path": "paths",
    "quasi_static_path": "paths",
    "Event": "dynamics",
    "Events": "dynamics",
    "simulate": "dynamics",
    "Trajectory": "dynamics",
    "Basin": "sweeps",
    "basin": "sweeps",
    "Outcome": "regimes",
    "Regime": "regimes",
    "rms_sweep": "sweeps",
    "Sensitivity": "sweeps",
    "sensitivity": "sweeps",
    "Sweep": "sweeps",
    "precise": "precise",
    "figures": "figures",
    "set_backend": "backends",
    "get_backend": "backends",
}

__all__ = [
    "BackendError",
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
