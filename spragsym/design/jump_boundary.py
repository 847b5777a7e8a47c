"""A point on the border of what jumps, brought to the nearest one of its sheet of folds."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np

from ..errors import ConvergenceError
from ..models.parameters import FloatArray
from .design_space import Space
from .gradients import JumpGradient

#: The jump value of one set of a model, and its slopes; it may take the set for a near neighbour of the last one.
Gradient: TypeAlias = Callable[[Any], JumpGradient]
#: Steps at most, the last of them over the size, and how much shorter the next one is where they don't get smaller.
STEPS, LAST, SHORTER = 40, 1e-8, 0.3
#: How near to its limit a jump value is on the border, over the slopes by z.
ON = 1e-9


def on_border(
    designs: Space, z: FloatArray, vary: str, gradient: Gradient, limit: float | None = None
) -> FloatArray | None:  # fmt: skip
    """The z of smallest size near a given one where the state ends at a limit, or at the design's own value, if there is one.

    Source: g(z) = 0, how far beyond the limit the state ends. Each step goes to the point of smallest size of the plane
    g + ∇g · (z′ − z) = 0, by jump values along ``vary`` and their gradients, or a part of the way where steps don't get smaller.
    """
    limits = designs.limits()

    def step(z: FloatArray) -> tuple[FloatArray, float]:
        """The point of smallest size of the plane at z, and how far z is from the plane, over the slopes."""
        p, slopes = designs.sets(z), designs.slopes(z)
        found = gradient(p)
        # What is not among them the jump does not depend on, as the belt's speed.
        by_z = sum((float(found.slopes[name]) * slopes[name] for name in found.slopes if name in slopes), np.zeros(z.size))
        ahead = float(found.value) - (float(getattr(p, vary)) if limit is None else limit)
        by_z = by_z - slopes[vary] if limit is None else by_z
        square = float(by_z @ by_z)
        if not 0 < square < np.inf:
            raise ConvergenceError("the state does not end, or no slope is known where it does")
        return _smallest(by_z, float(by_z @ z) - ahead, *limits), abs(ahead) / square**0.5

    share, best = 1.0, np.inf
    try:
        towards, off = step(z)
        for _ in range(STEPS):
            moved = float(np.linalg.norm(towards - z))
            if moved <= LAST * float(np.linalg.norm(z)):
                return towards if step(towards)[1] < ON else None
            share, best = (min(1.0, 2 * share), moved) if moved < best else (SHORTER * share, best)
            z = z + share * (towards - z)
            towards, off = step(z)
    except ConvergenceError:
        return None
    return z if off < ON else None


def _smallest(slopes: FloatArray, level: float, low: FloatArray, high: FloatArray) -> FloatArray:
    """The z of smallest size within limits, about 0, with slopes · z = level: one limit after the other is kept to."""
    z, free = np.zeros_like(slopes), slopes != 0
    while free.any():
        z[free] = (level - slopes[~free] @ z[~free]) * slopes[free] / (slopes[free] @ slopes[free])
        beyond = free & ((z < low) | (z > high))
        if not beyond.any():
            break
        z[beyond] = np.clip(z, low, high)[beyond]
        free &= ~beyond
    return z
