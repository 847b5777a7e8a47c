"""Results on equilibria, and on the points, curves and paths on which they change: one class each,
for every model.
"""

from ..display import Column
from .equilibria import Equilibria, Stability, Undecided
from .points import BifurcationSet, Curve, Jump, LowestEnd, Path, Points
from .result import InUnits, Named, Result, Rows

__all__ = [
    "BifurcationSet",
    "Column",
    "Curve",
    "Equilibria",
    "InUnits",
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
