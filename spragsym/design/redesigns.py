"""Least changes of a design that move a jump beyond a target."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from ..errors import ParameterError
from ..models.parameters import FloatArray, ParameterSet, PhysicalParameters, as_number
from ..numerics.interval_arrays import BoolArray
from ..questions import Method, model_of, question
from ..results.result import Result
from .design_space import Design, space
from .jump_boundary import MovedFold, on_border
from .jumps import have_jumped, jump_value
from .nearest import nearest

#: A design on the target is moved outward by the first of these shares at which it is verified.
_OUTWARD = np.array([0.0, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6])


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
        Where the reference state jumps in the new design, solved for again, exactly; NaN where it never does.
    """

    distance: float
    change: Mapping[str, float]
    parameters: ParameterSet | PhysicalParameters | None
    jump: Mapping[str, float]


@question
def redesign(
    p: ParameterSet | PhysicalParameters | Design, change: str | Iterable[str], target: Mapping[str, float],
    scale: Mapping[str, float] | None = None, *, begin: float | None = None, method: Method = "auto",
) -> Redesign:  # fmt: skip
    """The least change of some quantities that keeps the end of the followed state beyond a target.

    Parameters
    ----------
    p : Parameters or PhysicalParameters
        One design.
    change : str or sequence of str
        What may change: parameters, or physical quantities of :class:`PhysicalParameters`.
    target : mapping of str to float
        For parameters that rise, as ``mu0`` or ``theta0``, below what value the state may not end.
    scale : mapping of str to float, optional
        A tolerance for each quantity that may change, in which changes are measured; by default its own value.
    begin : float, optional
        From where they rise instead of the lower end of their range: from its value in ``p`` a design whose state has ended
        below that looks like one whose state goes on.
    method : {"auto", "closed", "search"}
        Whether what is asked on the way may be answered by closed forms.

    Returns
    -------
    Redesign

    Raises
    ------
    ParameterError
        For quantities that ``p`` does not have, a target that is no parameter, or one that is to change itself.

    Notes
    -----
    Source: F = 0, det K = 0 at the target. That the new design keeps it is verified; that there is no smaller change is not
    proved: the search follows the fold, and asks along rays for nearer ones, or goes out along them, up to 256 scales away, if it
    knows none.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> p = ss.Parameters.article(theta0=np.radians(40.0))
    >>> better = ss.redesign(p, ("sigma", "theta0"), {"mu0": 0.7})
    >>> round(better.distance, 4), {name: round(value, 4) for name, value in better.change.items()}
    (0.115, {'sigma': 0.0016, 'theta0': -0.0795})
    >>> round(better.jump["mu0"], 9)
    0.7
    """
    model = model_of(p)
    ranges = model.Parameters.ranges
    wanted = {name: as_number(f"target[{name!r}]", value, ranges[name]) for name, value in target.items() if name in ranges}
    if len(wanted) != len(target) or not wanted:
        raise ParameterError(f"target = {dict(target)!r}; give parameters of {model.name} below whose values nothing may end")

    designs = space(p, scale, change, "change")
    for name in wanted:
        if name in designs.names:
            raise ParameterError(f"{name} is the target and can't be what changes; leave it out of one of the two")
    lowest = {name: ranges[name].reached(ranges[name].low) for name in wanted if np.isfinite(ranges[name].low)}
    first = {name: lowest.get(name) if begin is None else begin for name in wanted}
    along = {name: MovedFold(name, first[name]) for name in wanted}

    def keeps(z: FloatArray) -> BoolArray:
        result = np.ones(z.shape[:-1], dtype=np.bool_)
        for name, limit in wanted.items():
            left = np.flatnonzero(result)
            if left.size:
                some = designs.sets(z[left])
                begins = getattr(some, name) if first[name] is None else first[name]
                result[left] = have_jumped(some.replace(**{name: np.full(some.shape, limit)}), name, begins) == 0
        return result

    def on_target(z: FloatArray) -> FloatArray | None:
        """The nearest design on a fold at one of the targets, verified."""
        candidates = []
        for name, limit in wanted.items():
            better = on_border(designs, z, along[name], limit)
            if better is not None:
                outward = better * (1 + _OUTWARD)[:, None]
                candidates += list(outward[keeps(outward)][:1])
        return min(candidates, key=np.linalg.norm, default=None)

    best = nearest(keeps, designs.limits(), on_target)
    if best is None:
        return Redesign(np.inf, {}, None, {})
    changed = dict(zip(designs.names, (best * designs.scale).tolist(), strict=True))
    jump = {name: float(jump_value(designs.sets(best), name, begin=first[name])) for name in wanted}
    return Redesign(float(np.linalg.norm(best)), changed, designs.made(best), jump)
