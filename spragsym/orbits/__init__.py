"""Cycles (closed orbits of the piecewise smooth motion): their computation, branches and
bifurcations, Lyapunov exponents, fates of motions and boundaries between them, proofs of cycles.
"""

from .basin_boundaries import BasinBoundary, basin_boundary
from .branch import CycleBranch, CycleEvent, EventCurve, cycle_branch, cycle_events
from .exponents import Lyapunov, lyapunov
from .fate_boundaries import FateBoundary, fate_boundary
from .fates import Fate, FateMap, fate, fate_map
from .finding import cycle
from .orbit import Cycle

__all__ = [
    "BasinBoundary",
    "Cycle",
    "CycleBranch",
    "CycleEvent",
    "EventCurve",
    "Fate",
    "FateBoundary",
    "FateMap",
    "Lyapunov",
    "basin_boundary",
    "cycle",
    "cycle_branch",
    "cycle_events",
    "fate",
    "fate_boundary",
    "fate_map",
    "lyapunov",
]
