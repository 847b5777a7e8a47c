"""Results on equilibria, and on the points, curves and paths on which they change: one class each,
for every model.
"""

from .equilibria import Equilibria, Stability, Undecided
from .points import BifurcationSet, Curve, Jump, LowestEnd, Path, Points
from .result import Named, Result, Rows

__all__ = [
    "BifurcationSet",
    "Curve",
    "Equilibria",
    "Jump",
    "LowestEnd",
    "Named",
    "Path",
    "Points",
    "Result",
    "Rows",
    "Stability",
    "Undecided",
]
