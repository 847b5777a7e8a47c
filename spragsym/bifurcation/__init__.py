"""Bifurcations of equilibria for any model: folds, cusps, Hopf points, their curves in a plane, and
paths.
"""

#: Modules that other rooms ask; each is loaded when it is imported.
__all__ = [
    "bifurcation_sets",
    "branches",
    "critical",
    "defining_systems",
    "digits",
    "flutter",
    "folds",
    "hopf_curves",
    "normal_forms",
    "paths",
    "tubes",
    "turning_points",
]
