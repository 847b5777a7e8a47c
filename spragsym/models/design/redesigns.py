"""How far a design of any model is from the end of its followed state, and what to change: the nearest designs, by tubes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...design.design_space import Space, space
from ...design.margins import JumpMargin, margin
from ...design.redesigns import Redesign, redesigned
from ...errors import ParameterError
from ...exact.interval_arrays import FloatArray
from ...parameters import as_number
from .certificates import certify
from .jumps import Followed, jump_value
from .moved_folds import MovedFold

#: Rays for each dimension squared: a point takes some milliseconds.
RAYS = 8
#: Parts of a box that a proof may take.
BOXES = 500


def jump_margin(model: Any, p: Any, scale: Mapping[str, float], *, vary: str, begin: float, prove: bool = False) -> JumpMargin:
    """The nearest parameters at which the followed state ends as ``vary`` rises to its value, in the metric of the tolerances.

    Parameters
    ----------
    p : Parameters
        One design of the model.
    scale, prove
        As for :func:`spragsym.jump_margin`.
    vary, begin
        As for :func:`spragsym.models.design.certificates.certify`: the parameter that rises, and from where.

    Notes
    -----
    Source: tubes around curves of states, see :mod:`spragsym.models.design.jumps`. What is found is a design at which the state
    ends; that there is no nearer one is known within ``proved`` only, by the certificate over a box around it.
    """
    designs = space(p, scale, None)

    def ending(z: FloatArray) -> NDArray[np.bool_]:
        some, first = designs.sets(z), designs.begin(z, begin)
        # A design below where the parameter begins has not come to any end.
        followed = Followed(model, some, vary, "up", first, np.maximum(first, getattr(some, vary)))
        ended: NDArray[np.bool_] = followed.have_ended() == 1
        return ended

    def safe(radius: float) -> bool:
        return _safe(designs, radius, vary, begin)

    return margin(designs, ending, safe if prove else None, vary, MovedFold(model, vary, begin), RAYS)


def redesign(
    model: Any, p: Any, change: str | Iterable[str], target: Mapping[str, float], scale: Mapping[str, float] | None = None, *,
    begin: float | None = None,
) -> Redesign:  # fmt: skip
    """The least change of some parameters that keeps the end of the followed state beyond a target.

    Parameters
    ----------
    p, change, scale
        As for :func:`spragsym.redesign`.
    target : mapping of str to float
        For parameters that rise, below what value the state may not end.
    begin : float, optional
        From where they rise instead of the lower end of their range: from its value in ``p`` a design whose state has ended
        below that looks like one whose state goes on.
    """
    ranges = model.Parameters.ranges
    wanted = {name: as_number(f"target[{name!r}]", value, ranges[name]) for name, value in target.items() if name in ranges}
    if len(wanted) != len(target) or not wanted:
        raise ParameterError(f"target = {dict(target)!r}; give parameters of {model.name} below whose values nothing may end")

    return reaching(model, space(p, scale, change, "change"), wanted, begin)


def reaching(model: Any, designs: Space, wanted: Mapping[str, float], begin: float | None) -> Redesign:
    """The nearest of some designs whose followed state ends at no value below those that are wanted."""

    def first(name: str) -> float | None:
        allowed = model.Parameters.ranges[name]
        return allowed.reached(allowed.low) if begin is None and np.isfinite(allowed.low) else begin

    def keeps(some: Any, name: str, limit: float) -> NDArray[np.bool_]:
        kept: NDArray[np.bool_] = Followed(model, some, name, "up", first(name), limit).have_ended() == 0
        return kept

    def solved(one: Any, name: str) -> float:
        return float(jump_value(model, one, name, begin=first(name)))

    return redesigned(designs, wanted, keeps, solved, lambda name: MovedFold(model, name, first(name)), RAYS)


def _safe(designs: Space, radius: float, vary: str, begin: float) -> bool:
    """Whether no state ends over the box around a ball."""
    low, high = designs.limits()
    if (low > -radius).any() or (high < radius).any():
        return False
    ends = [designs.sets(np.full(len(designs.names), side * radius)) for side in (-1, 1)]
    return certify(ends[0], ends[1], "no jump", vary=vary, begin=begin, max_boxes=BOXES, refute=False).outcome == "proved"
