"""Motion in time: trajectories on two integrators, and what a motion comes to."""

from .regimes import Outcome, Regime
from .trajectory import Event, Events, Trajectory, simulate

__all__ = ["Event", "Events", "Outcome", "Regime", "Trajectory", "simulate"]
