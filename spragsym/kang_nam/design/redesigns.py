"""What to change, and by how little, so that a jump lies beyond a target."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...design.design_space import space
from ...design.redesigns import Redesign, redesigned
from ...design.values import FROM_LOWER_END
from ...errors import ParameterError
from ...parameters import RANGES, Parameters, PhysicalParameters, as_number
from .gradients import jump_gradient
from .jump_values import exactly, first_jumps


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
    search follows the fold, and asks along rays for nearer ones, or goes out along them, up to 256 scales away, if it knows none.

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

    def keeps(p: Any, name: str, limit: float) -> NDArray[np.bool_]:
        found = first_jumps(p, name, apart_from=np.full(p.shape, limit))
        known = np.full(p.shape, fill_value=True)
        known[list(found.reasons)] = False
        return known & ~(found.value < limit)

    designs = space(p, scale, change, "change")
    return redesigned(designs, wanted, keeps, lambda p, name: exactly(p, name)[0], lambda name: partial(jump_gradient, vary=name))
