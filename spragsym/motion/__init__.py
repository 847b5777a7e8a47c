"""Motion in time: trajectories on two integrators, and what a motion comes to."""

from .events import Events
from .problem import Event
from .regimes import Outcome, Regime
from .simulation import simulate
from .trajectory import Trajectory

__all__ = ["Event", "Events", "Outcome", "Regime", "Trajectory", "simulate"]
