"""From a brake to a verdict: where it jumps, how far that is, how sure, and what to change."""

from .gradients import JumpGradient, jump_gradient
from .jump_values import jump_value

__all__ = ["JumpGradient", "jump_gradient", "jump_value"]
