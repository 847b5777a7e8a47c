"""Proofs that nothing jumps within a distance of a design."""

from __future__ import annotations

import numpy as np

from ...design.design_space import Space
from ...models.parameters import NAMES
from ...questions import NotInClosedForm
from .cells import Boxes
from .certificates import halved
from .claims import CLAIMS
from .jump_values import require_usual

#: Boxes that a proof that nothing jumps may take.
_BOXES = 3_000


def safe_within(designs: Space, radius: float, vary: str, begin: float) -> bool:
    """Boxes around the design are halved until each lies outside of the ball or is proved.

    Of the friction only the largest value matters that the ball has over a box of the others.
    """
    require_usual(designs, vary, begin)
    if vary != "mu0":
        raise NotInClosedForm
    low, high = designs.limits()
    if (low > -radius).any() or (high < radius).any():
        return False
    values = designs.parameters(np.zeros(len(designs.names)))
    others = [j for j, name in enumerate(designs.names) if name != "mu0"]
    place = [NAMES.index(designs.names[j]) for j in others]
    origin, scale = designs.origin[others, None], designs.scale[others, None]
    ends = np.array([[float(values[name])] for name in NAMES])
    bottom, top = ends.copy(), ends.copy()
    bottom[place], top[place] = origin - radius * scale, origin + radius * scale
    pending, seen = Boxes(bottom, top, np.ones(1)), 0
    while pending.share.size:
        seen += pending.share.size
        if seen > _BOXES:
            return False
        off = (np.clip(origin, pending.low[place], pending.high[place]) - origin) / scale
        rest = (radius * (1 + 1e-9)) ** 2 - (off**2).sum(axis=0)
        pending, rest = pending[rest >= 0], rest[rest >= 0]
        if "mu0" in designs.names:
            j, k = NAMES.index("mu0"), designs.names.index("mu0")
            pending.low[j] = pending.high[j] = designs.origin[k] + designs.scale[k] * np.sqrt(rest)
        proved, weight = CLAIMS["no jump"].prove(pending)
        left = np.flatnonzero(~proved)
        pending = halved(pending[left], weight[:, left])
    return True
