"""From a brake to a verdict: how sure a jump is, how far it is, and what to change, for every model."""

from .certificates import Certificate
from .gradients import JumpGradient
from .margins import JumpMargin
from .probability import JumpProbability
from .redesigns import Redesign

__all__ = ["Certificate", "JumpGradient", "JumpMargin", "JumpProbability", "Redesign"]
