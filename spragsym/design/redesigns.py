"""What to change, and by how little, so that a jump lies beyond a target."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..display import Result
from ..errors import ParameterError
from ..parameters import FloatArray, ParameterSet, PhysicalParameters
from .design_space import Space
from .jump_boundary import on_border
from .nearest import RAYS, Member, nearest, shortened
from .values import Values

#: A design on the target is moved outward by the first of these shares at which it is verified.
_OUTWARD = np.array([0.0, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6])


#: Where many designs jump first, as far as that tells on which side of a limit: (set of the model, name, limit).
Jumps: TypeAlias = Callable[[Any, str, float], Values]


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
    designs: Space, wanted: Mapping[str, float], jumps: Jumps, solved: Callable[[Any, str], float], rays: int = RAYS,
    **options: Any,
) -> Redesign:  # fmt: skip
    """The nearest of the designs that reach all targets; ``solved`` says where one jumps; ``options`` of jump_gradient."""
    for name in wanted:
        if name in designs.names:
            raise ParameterError(f"{name} is the target and can't be what changes; leave it out of one of the two")

    def member(z: FloatArray) -> NDArray[np.bool_]:
        result = np.ones(z.shape[:-1], dtype=np.bool_)
        for name, limit in wanted.items():
            left = np.flatnonzero(result)
            if left.size:
                at = jumps(designs.sets(z[left]), name, limit)
                result[left] = ~(at.value < limit)
                result[left[list(at.reasons)]] = False
        return result

    found = nearest(member, designs.limits(), rays)
    if found is None:
        return Redesign(np.inf, {}, None, {})
    best = _on_target(designs, found, wanted, member, **options) if found.any() else found
    change = dict(zip(designs.names, (best * designs.scale).tolist(), strict=True))
    jump = {name: solved(designs.sets(best), name) for name in wanted}
    return Redesign(float(np.linalg.norm(best)), change, designs.made(best), jump)


def _on_target(designs: Space, z: FloatArray, wanted: Mapping[str, float], member: Member, **options: Any) -> FloatArray:
    """The nearest design on a fold at one of the targets, verified; else the border along the ray."""
    candidates = []
    # Just inside of the border there is a jump at the target.
    border = shortened(member, z)
    inside = border * (1 - 1e-9)
    for name, limit in wanted.items():
        better = on_border(designs, inside, name, limit, **options)
        if better is not None:
            outward = better * (1 + _OUTWARD)[:, None]
            verified = np.flatnonzero(member(outward))
            if verified.size:
                candidates.append(outward[verified[0]])
    return min([border, *candidates], key=lambda one: float(np.linalg.norm(one)))
