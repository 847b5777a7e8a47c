"""The fold that ends a followed state as the design moves, and the nearest point of its sheet to a design.

In floats: predictions for searches that verify what they find.
"""

from typing import Any

import numpy as np

from ..bifurcation.tubes.tube_regions import Parts
from ..bifurcation.tubes.tubes import SMALL
from ..bifurcation.tubes.turning_points import secants
from ..errors import ConvergenceError
from ..numerics.interval_arrays import FloatArray
from .design_space import Space
from .gradients import JumpGradient
from .jump_ends import Ends, told
from .jumps import Followed, first_ends, slopes_of

#: Steps at most, the last of them over the size, and how much shorter the next one is where they don't get smaller.
STEPS, LAST, SHORTER = 40, 1e-8, 0.3
#: How near to its limit a jump value is on the border, over the slopes by z.
ON = 1e-9


class MovedFold:
    """Jump value and gradient of one design after the other, each near the last.

    The first fold is the one of :func:`spragsym.design.jumps.jump_gradient`, by tubes from where ``vary`` begins. The next
    one is found from the last by secants along the curve of states of the new design, in milliseconds; that the followed state
    ends there is not known then. Where secants end nowhere it is found by tubes again.
    """

    def __init__(self, vary: str, begin: float | None) -> None:
        self.vary, self.begin = vary, begin
        self.last: FloatArray | None = None

    def __call__(self, p: Any) -> JumpGradient:
        asked = Followed(p, self.vary, "up", self.begin, None)
        found = None if self.last is None else self._next(asked, self.last)
        if found is None:
            found = told(first_ends(p, self.vary, begin=self.begin))
        z = np.append(found.state, found.value)
        self.last = z if np.isfinite(z).all() else None
        return JumpGradient(self.vary, found.value, slopes_of(p, self.vary, found))

    def _next(self, asked: Followed, last: FloatArray) -> Ends | None:
        """The fold near (q, v), if there is one within what the parameter may be."""
        n, tubes, z = asked.balance.n, asked.tubes, last[:, None]
        parts = Parts.points(asked.fixed)
        # At a fold the null vector of K is the direction of the curve: nothing else of z changes there.
        along = np.linalg.svd(tubes.floats(parts, z)[1][:, :n, 0])[2][-1]
        pivot = int(np.argmax(np.abs(along) / np.maximum(np.abs(last[:n]), SMALL)))
        z, met = secants(tubes, parts, tubes.corrected(parts, z, pivot), pivot, np.ones(1))
        value = z[n].reshape(asked.shape)
        if not met[0] or not asked.begin[0] <= value <= asked.until[0]:
            return None
        return Ends(value, np.zeros(asked.shape), z[:n].reshape(n, *asked.shape), {})


def on_border(designs: Space, z: FloatArray, gradient: MovedFold, limit: float | None = None) -> FloatArray | None:
    """The z of smallest size near a given one where the state ends at a limit, or at the design's own value, if there is one.

    Source: g(z) = 0, how far beyond the limit the state ends. Each step goes to the point of smallest size of the plane
    g + ∇g · (z′ − z) = 0, by jump values and their gradients, or a part of the way where steps don't get smaller.
    """
    limits, vary = designs.limits(), gradient.vary

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
