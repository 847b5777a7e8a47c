"""The fold that ends a followed state as the design moves, in floats: predictions for searches that verify what they find."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..bifurcation.tubes.tube_regions import Parts
from ..bifurcation.tubes.tubes import SMALL
from ..bifurcation.tubes.turning_points import secants
from ..numerics.interval_arrays import FloatArray
from .gradients import JumpGradient
from .jump_ends import Ends
from .jumps import Followed, first_ends, slopes_of
from .values import told


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
        none = np.zeros((0, 1))
        parts = Parts(asked.fixed, none, none)
        # At a fold the null vector of K is the direction of the curve: nothing else of z changes there.
        along = np.linalg.svd(tubes.floats(parts, z)[1][:, :n, 0])[2][-1]
        pivot = int(np.argmax(np.abs(along) / np.maximum(np.abs(last[:n]), SMALL)))
        z, met = secants(tubes, parts, tubes.corrected(parts, z, pivot), pivot, np.ones(1))
        value = z[n].reshape(asked.shape)
        if not met[0] or not asked.begin[0] <= value <= asked.until[0]:
            return None
        return Ends(value, np.zeros(asked.shape), z[:n].reshape(n, *asked.shape), {})
