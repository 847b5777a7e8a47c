"""What to change, and by how little, so that a jump lies beyond a target."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ..display import Result
from ..errors import ParameterError
from ..parameters import RANGES, FloatArray, Parameters, ParameterSet, PhysicalParameters, as_number
from .design_space import Space, space
from .jump_boundary import on_border
from .jump_values import FROM_LOWER_END, FirstJumps, Values, exactly, first_jumps
from .nearest import RAYS, Member, nearest, shortened

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


def redesign(
    p: Parameters | PhysicalParameters,
    change: str | Iterable[str],
    target: Mapping[str, float],
    scale: Mapping[str, float] | None = None,
) -> Redesign:
    """The least change of some quantities that keeps the jump of the state of small deformation beyond a target.

    Parameters
    ----------
    p : Parameters or PhysicalParameters
        One design.
    change : str or sequence of str
        What may change: dimensionless parameters, or physical quantities of :class:`PhysicalParameters`.
    target : mapping of str to float
        Below what friction ``mu0``, or what angle ``theta0`` in radians, nothing may jump; one of the two or both.
    scale : mapping of str to float, optional
        A tolerance for each quantity that may change, in which changes are measured; by default its own value.

    Returns
    -------
    Redesign

    Raises
    ------
    ParameterError
        For quantities that ``p`` does not have, a target other than ``mu0`` and ``theta0``, or one that is to change itself.

    Notes
    -----
    Source: f = f′ = 0 at the target. That the new design keeps it is verified; that there is no smaller change is not proved: the
    search follows rays, up to 256 scales away, and then the fold.

    Examples
    --------
    >>> import numpy as np
    >>> p = Parameters.article(theta0=np.radians(40.0))
    >>> better = redesign(p, ("sigma", "theta0"), {"mu0": 0.7})
    >>> round(better.distance, 4), {name: round(value, 4) for name, value in better.change.items()}
    (0.115, {'sigma': 0.0016, 'theta0': -0.0795})
    >>> round(better.jump["mu0"], 9)
    0.7
    """
    wanted = {
        name: as_number(f"target[{name!r}]", value, RANGES[name]) for name, value in target.items() if name in FROM_LOWER_END
    }
    if len(wanted) != len(target) or not wanted:
        raise ParameterError(f"target = {dict(target)!r}; give mu0, theta0 or both, with the value below which nothing may jump")

    def jumps(p: Any, name: str, limit: float) -> FirstJumps:
        return first_jumps(p, name, apart_from=np.full(p.shape, limit))

    return redesigned(space(p, scale, change, "change"), wanted, jumps, lambda p, name: exactly(p, name)[0])


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
