"""Forces along a motion, over k_c L_0."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..generated import motion as _motion
from ..parameters import FloatArray


def spring_force(x: Any, y: Any, cos0: float, sin0: float, sigma: float) -> FloatArray:
    """Tension σ (L − 1) of the inclined spring; L by (6)."""
    force: FloatArray = sigma * (_motion.spring_length(x, y, cos0, sin0) - 1)
    return force


def contact_force(y: Any) -> FloatArray:
    """Force of the contact, (11): −y below the surface of the belt, 0 above it."""
    force: FloatArray = np.maximum(-np.asarray(y), 0.0)
    return force
