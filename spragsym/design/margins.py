"""How far a design is from a jump: the nearest parameters at which the state of small deformation jumps."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from ..models.parameters import FloatArray, ParameterSet, PhysicalParameters
from ..results.result import Result
from .design_space import Space
from .jump_boundary import Gradient, on_border
from .nearest import RAYS, Member, nearest

#: Shares of the distance within which a proof that nothing jumps is tried.
_SHARES = (0.95, 0.8, 0.5, 0.2)


@dataclass(frozen=True)
class JumpMargin(Result):
    """The nearest parameters at which the state of small deformation jumps as the friction rises to μ₀.

    Attributes
    ----------
    distance : float
        Root of the sum of squares of the changes over their tolerances; 0 if it jumps as it is, ``inf`` if nothing near jumps.
    proved : float
        Within this distance nothing jumps, proved; NaN where it was not asked for.
    change : dict of str to float
        What changes, by how much.
    parameters : Parameters or PhysicalParameters or None
        The nearest point, on the fold itself.
    """

    distance: float
    proved: float
    change: Mapping[str, float]
    parameters: ParameterSet | PhysicalParameters | None


def margin(
    designs: Space, member: Member, safe: Callable[[float], bool] | None, vary: str, gradient: Gradient, rays: int = RAYS
) -> JumpMargin:
    """The nearest design that jumps along ``vary``, which ``member`` tells; ``safe`` proves that none does within a radius."""

    def on_fold(z: FloatArray) -> FloatArray | None:
        better = on_border(designs, z, vary, gradient)
        if better is None:
            return None
        # On the fold to rounding: a hair beyond it the state jumps, if it is the one that ends there.
        beyond = better * (1 + 1e-9 * np.array([1.0, 10.0, 100.0]))[:, None]
        return better if member(beyond).any() else None

    best = nearest(member, designs.limits(), on_fold, rays)
    distance = np.inf if best is None else float(np.linalg.norm(best))
    # Where nothing was found two tolerances are enough.
    proved = np.nan if safe is None else _proved(safe, distance if best is not None else 2.0)
    if best is None:
        return JumpMargin(distance, proved, {}, None)
    change = dict(zip(designs.names, (best * designs.scale).tolist(), strict=True))
    return JumpMargin(distance, proved, change, designs.made(best))


def _proved(safe: Callable[[float], bool], distance: float) -> float:
    """The largest share of the distance within which nothing jumps, proved; 0 if none of those tried can be."""
    radii = (share * distance for share in _SHARES if distance)
    return next((radius for radius in radii if safe(radius)), 0.0)
