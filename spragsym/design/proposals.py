"""How far a design of any model is from the end of its followed state, and what to change: the nearest designs, by tubes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ParameterError
from ..models.parameters import ParameterSet, PhysicalParameters, as_number
from ..numerics.interval_arrays import FloatArray
from ..questions import Method, model_of, question
from .design_space import Design, Space, space
from .jumps import have_jumped, jump_value
from .margins import JumpMargin, margin
from .moved_folds import MovedFold
from .redesigns import Redesign, redesigned
from .tube_certificates import certify

#: Rays for each dimension squared: a point takes some milliseconds.
RAYS = 8
#: Parts of a box that a proof may take.
BOXES = 500


@question
def jump_margin(
    p: ParameterSet | PhysicalParameters | Design, scale: Mapping[str, float], *, vary: str | None = None,
    begin: float | None = None, prove: bool = False, method: Method = "auto",
) -> JumpMargin:  # fmt: skip
    """The nearest parameters at which the followed state ends as ``vary`` rises to its value, in the metric of the tolerances.

    Parameters
    ----------
    p : Parameters or PhysicalParameters
        One design, with its friction.
    scale : mapping of str to float
        A tolerance for each quantity that may be off; the others stay.
    vary, begin : str and float, optional
        The parameter that rises, mu0 unless told otherwise, and from where, the lower end of its range.
    prove : bool
        Also prove that nothing jumps within a part of the distance, as large as can be shown in some seconds.
    method : {"auto", "closed", "search"}
        Whether what is asked on the way may be answered by closed forms.

    Returns
    -------
    JumpMargin

    Raises
    ------
    ParameterError
        For quantities that ``p`` does not have, tolerances that are not positive, and a proof with physical quantities.

    Notes
    -----
    Source: F = 0, det K = 0 at the least change. That the point found is on a fold at which that state jumps is certain; that
    there is no nearer one is known within ``proved`` only: the search follows the fold that ends the state, and asks along rays
    for nearer ones; where the state has no end, it goes out along them, up to 256 tolerances away.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> p = ss.Parameters.article(theta0=np.radians(40.0))
    >>> margin = ss.jump_margin(p, {"theta0": np.radians(1.0), "mu0": 0.05})
    >>> round(margin.distance, 4), {name: round(value, 4) for name, value in margin.change.items()}
    (1.6845, {'theta0': 0.0114, 'mu0': 0.0776})
    >>> margin = ss.jump_margin(ss.load("cubic_contact").Parameters(theta0=0.7, gamma=3000.0, mu0=0.5), {"mu0": 0.05})
    >>> round(margin.distance, 6)
    1.948441
    """
    name, first = model_of(p).rising(vary, begin)
    designs = space(p, scale, None)
    if prove and not isinstance(p, ParameterSet):
        raise ParameterError("prove = True is for dimensionless Parameters; call .dimensionless() and give their tolerances")

    def ending(z: FloatArray) -> NDArray[np.bool_]:
        # A design below where the parameter begins has not come to any end.
        return np.asarray(have_jumped(designs.sets(z), name, designs.begin(z, first)) == 1)

    def safe(radius: float) -> bool:
        return safe_within(designs, radius, name, first)

    return margin(designs, ending, safe if prove else None, name, MovedFold(name, first), RAYS)


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

    def first(name: str) -> float | None:
        allowed = ranges[name]
        return allowed.reached(allowed.low) if begin is None and np.isfinite(allowed.low) else begin

    def keeps(some: Any, name: str, limit: float) -> NDArray[np.bool_]:
        begins = first(name) if first(name) is not None else getattr(some, name)
        return np.asarray(have_jumped(some.replace(**{name: np.full(some.shape, limit)}), name, begins) == 0)

    def solved(one: Any, name: str) -> float:
        return float(jump_value(one, name, begin=first(name)))

    return redesigned(space(p, scale, change, "change"), wanted, keeps, solved, lambda name: MovedFold(name, first(name)), RAYS)


@question
def safe_within(designs: Space, radius: float, vary: str, begin: float, *, method: Method = "auto") -> bool:
    """Whether it is proved that no state ends within a ball: over the box around it."""
    low, high = designs.limits()
    if (low > -radius).any() or (high < radius).any():
        return False
    ends = [designs.sets(np.full(len(designs.names), side * radius)) for side in (-1, 1)]
    return certify(ends[0], ends[1], "no jump", vary=vary, begin=begin, max_boxes=BOXES, refute=False).outcome == "proved"
