"""Motion in time: trajectories on two integrators, and what a motion comes to."""

from .problem import Event, prepare
from .regimes import Outcome, Regime
from .rest import rest_index
from .trajectory import Events, Trajectory, simulate

__all__ = ["Event", "Events", "Outcome", "Regime", "Trajectory", "prepare", "rest_index", "simulate"]
