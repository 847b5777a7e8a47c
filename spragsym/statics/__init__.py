"""Equilibria: what is known of them, and how they are found for one point and for millions."""

from .backends import get_backend, set_backend
from .bifurcation_sets import BifurcationSet, Curve
from .lowest_ends import LowestEnd
from .onsets import Onsets
from .paths import Jump, Path
from .points import Points
from .results import Equilibria, Stability, Undecided
from .solver import count, equilibria

__all__ = [
    "BifurcationSet",
    "Curve",
    "Equilibria",
    "Jump",
    "LowestEnd",
    "Onsets",
    "Path",
    "Points",
    "Stability",
    "Undecided",
    "count",
    "equilibria",
    "get_backend",
    "set_backend",
]
