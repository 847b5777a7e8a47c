"""From a brake to a verdict: where it jumps, how far that is, how sure, and what to change."""

from .certificates import Certificate, certify
from .gradients import JumpGradient, jump_gradient
from .jump_values import jump_value

__all__ = ["Certificate", "JumpGradient", "certify", "jump_gradient", "jump_value"]
