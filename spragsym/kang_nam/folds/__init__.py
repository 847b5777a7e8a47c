"""Where states meet, vanish and jump: the surface, folds, cusps, flutter, and paths over them, all without a guess."""

from .bifurcation_sets import bifurcation_set
from .cusp_points import cusps
from .equilibrium_surface import Surface, surface
from .flutter_points import FlutterBoundary, flutter_boundary, flutter_onsets
from .fold_points import folds
from .linear import LinearSprag, linear_critical_friction, linear_sprag
from .lowest_fold import critical_friction
from .sliding import sliding_friction

__all__ = [
    "FlutterBoundary",
    "LinearSprag",
    "Surface",
    "bifurcation_set",
    "critical_friction",
    "cusps",
    "flutter_boundary",
    "flutter_onsets",
    "folds",
    "linear_critical_friction",
    "linear_sprag",
    "sliding_friction",
    "surface",
]
