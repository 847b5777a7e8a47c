"""From a brake to a verdict: where it jumps, how far that is, how sure, and what to change."""

from .certificates import Certificate, certify
from .gradients import JumpGradient, jump_gradient
from .jump_values import jump_value
from .margins import JumpMargin, jump_margin
from .probability import JumpProbability, jump_probability
from .redesigns import Redesign, redesign

__all__ = [
    "Certificate",
    "JumpGradient",
    "JumpMargin",
    "JumpProbability",
    "Redesign",
    "certify",
    "jump_gradient",
    "jump_margin",
    "jump_probability",
    "jump_value",
    "redesign",
]
