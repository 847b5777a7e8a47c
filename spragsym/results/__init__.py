"""Results on equilibria, and on the points, curves and paths on which they change: one class each, for every model."""

from .bifurcation_sets import BifurcationSet, Curve
from .equilibria import Equilibria, Stability, Undecided
from .lowest_ends import LowestEnd
from .named_columns import Columns, Named
from .paths import Jump, Path
from .points import Points
from .result import Result, Rows

__all__ = [
    "BifurcationSet", "Columns", "Curve", "Equilibria", "Jump", "LowestEnd", "Named", "Path", "Points", "Result", "Rows",
    "Stability", "Undecided",
]  # fmt: skip
