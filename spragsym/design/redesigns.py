"""What to change, and by how little, so that a jump lies beyond a target."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..errors import ParameterError
from ..models.parameters import FloatArray, ParameterSet, PhysicalParameters
from ..results.result import Result
from .design_space import Space
from .jump_boundary import Gradient, on_border
from .nearest import RAYS, nearest

#: A design on the target is moved outward by the first of these shares at which it is verified.
_OUTWARD = np.array([0.0, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6])


#: Which of many designs are known not to jump below a limit: (set of the model, name, limit).
Keeps: TypeAlias = Callable[[Any, str, float], NDArray[np.bool_]]


@dataclass(frozen=True)
class Redesign(Result):
    """The least change that keeps a jump beyond its target.

    Attributes
    ----------
    distance : float
        Root of the sum of squares of the changes over their scales; 0 if nothing need change, ``inf`` if nothing was found.
    change : dict of str to float
        What to change, by how much.
    parameters : Parameters or PhysicalParameters or None
        The new design.
    jump : dict of str to float
        Where the state of small deformation jumps in the new design, solved for again, exactly; NaN where it never does.
    """

    distance: float
    change: Mapping[str, float]
    parameters: ParameterSet | PhysicalParameters | None
    jump: Mapping[str, float]


def redesigned(
    designs: Space, wanted: Mapping[str, float], keeps: Keeps, solved: Callable[[Any, str], float],
    gradient: Callable[[str], Gradient], rays: int = RAYS,
) -> Redesign:  # fmt: skip
    """The nearest of the designs that reach all targets; ``solved`` says where one jumps, ``gradient`` is along a parameter."""
    for name in wanted:
        if name in designs.names:
            raise ParameterError(f"{name} is the target and can't be what changes; leave it out of one of the two")

    def member(z: FloatArray) -> NDArray[np.bool_]:
        result = np.ones(z.shape[:-1], dtype=np.bool_)
        for name, limit in wanted.items():
            left = np.flatnonzero(result)
            if left.size:
                result[left] = keeps(designs.sets(z[left]), name, limit)
        return result

    along = {name: gradient(name) for name in wanted}

    def on_target(z: FloatArray) -> FloatArray | None:
        """The nearest design on a fold at one of the targets, verified."""
        candidates = []
        for name, limit in wanted.items():
            better = on_border(designs, z, name, along[name], limit)
            if better is not None:
                outward = better * (1 + _OUTWARD)[:, None]
                candidates += list(outward[member(outward)][:1])
        return min(candidates, key=np.linalg.norm, default=None)

    best = nearest(member, designs.limits(), on_target, rays)
    if best is None:
        return Redesign(np.inf, {}, None, {})
    change = dict(zip(designs.names, (best * designs.scale).tolist(), strict=True))
    jump = {name: solved(designs.sets(best), name) for name in wanted}
    return Redesign(float(np.linalg.norm(best)), change, designs.made(best), jump)
