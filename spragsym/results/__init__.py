"""What is known of equilibria, and of the points, curves and paths on which they change: one class each, for every model."""

from .bifurcation_sets import BifurcationSet, Curve
from .equilibria import Equilibria, Stability, Undecided
from .lowest_ends import LowestEnd
from .onsets import Onsets
from .paths import Jump, Path
from .points import Points

__all__ = ["BifurcationSet", "Curve", "Equilibria", "Jump", "LowestEnd", "Onsets", "Path", "Points", "Stability", "Undecided"]
