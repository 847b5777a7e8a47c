"""Cycles: closed orbits of piecewise smooth motion, their branches, events and boundaries."""

from .branch import CycleBranch, CycleEvent, cycle_branch
from .fates import FateBoundary, fate_boundary
from .finding import cycle
from .lyapunov import Lyapunov, lyapunov
from .orbit import Cycle
from .two_parameters import EventCurve, cycle_events

__all__ = [
    "Cycle", "CycleBranch", "CycleEvent", "EventCurve", "FateBoundary", "Lyapunov",
    "cycle", "cycle_branch", "cycle_events", "fate_boundary", "lyapunov",
]  # fmt: skip
