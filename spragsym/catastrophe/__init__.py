"""Where states meet, vanish and jump: the surface, folds, cusps, flutter, and paths over them, all without a guess."""

from .flutter_points import FlutterBoundary, FlutterOnsets, flutter_boundary, flutter_onsets
from .paths import Jump, Path, quasi_static_path
from .points import (
    BifurcationSet,
    Cusps,
    FoldCurve,
    Folds,
    LinearSprag,
    Surface,
    bifurcation_set,
    critical_friction,
    critical_value,
    cusps,
    folds,
    linear_critical_friction,
    linear_sprag,
    sliding_friction,
    surface,
)

__all__ = [
    "BifurcationSet",
    "Cusps",
    "FlutterBoundary",
    "FlutterOnsets",
    "FoldCurve",
    "Folds",
    "Jump",
    "LinearSprag",
    "Path",
    "Surface",
    "bifurcation_set",
    "critical_friction",
    "critical_value",
    "cusps",
    "flutter_boundary",
    "flutter_onsets",
    "folds",
    "linear_critical_friction",
    "linear_sprag",
    "quasi_static_path",
    "sliding_friction",
    "surface",
]
