"""Motion in time: trajectories on two integrators, and what a motion comes to."""

from .problem import Event
from .regimes import Outcome, Regime
from .simulation import Trajectory, simulate
from .solution import Events

__all__ = ["Event", "Events", "Outcome", "Regime", "Trajectory", "simulate"]
