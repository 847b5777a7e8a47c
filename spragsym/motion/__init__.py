"""Motion in time: trajectories on two integrators, and what a motion comes to."""

from .problem import Event
from .regimes import Outcome, Regime
from .trajectory import Events, Trajectory, simulate

__all__ = ["Event", "Events", "Outcome", "Regime", "Trajectory", "simulate"]
