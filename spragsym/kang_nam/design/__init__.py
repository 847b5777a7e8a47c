"""Jumps in closed form: where they are, how far, how sure, and what to change."""

from .certificates import certify
from .gradients import jump_gradient
from .jump_values import jump_value
from .margins import jump_margin
from .probability import jump_probability
from .redesigns import redesign

__all__ = ["certify", "jump_gradient", "jump_margin", "jump_probability", "jump_value", "redesign"]
