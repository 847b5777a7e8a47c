"""Bifurcations of equilibria for any model: folds, cusps, Hopf points, their curves in a plane, and paths."""
