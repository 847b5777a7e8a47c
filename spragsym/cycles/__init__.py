"""Cycles: closed orbits of piecewise smooth motion, their branches, events and boundaries."""

from .branch import CycleBranch, CycleEvent, cycle_branch
from .finding import cycle
from .orbit import Cycle

__all__ = ["Cycle", "CycleBranch", "CycleEvent", "cycle", "cycle_branch"]
