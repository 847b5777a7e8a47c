"""How far a design is from a jump: the nearest parameters at which the state of small deformation jumps."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

import numpy as np
from numpy.typing import NDArray

from ...design.design_space import Space, space
from ...design.margins import JumpMargin, margin
from ...errors import ParameterError
from ...parameters import NAMES, FloatArray, Parameters, PhysicalParameters
from .cells import Boxes
from .certificates import halved
from .claims import CLAIMS
from .events import have_jumped
from .gradients import jump_gradient

#: Boxes that a proof that nothing jumps may take.
_BOXES = 3_000


def jump_margin(p: Parameters | PhysicalParameters, scale: Mapping[str, float], *, prove: bool = False) -> JumpMargin:
    """The nearest parameters at which the state of small deformation jumps, in the metric of the tolerances.

    Parameters
    ----------
    p : Parameters or PhysicalParameters
        One design, with its friction.
    scale : mapping of str to float
        A tolerance for each quantity that may be off; the others stay.
    prove : bool
        Also prove that nothing jumps within a part of the distance, as large as can be shown in some seconds.

    Returns
    -------
    JumpMargin

    Raises
    ------
    ParameterError
        For quantities that ``p`` does not have, tolerances that are not positive, and a proof with physical quantities.

    Notes
    -----
    Source: f = f′ = 0 at the least change. That the point found is on a fold at which that state jumps is certain; that there is
    no nearer one is known within ``proved`` only: the search follows the fold that ends the state, and asks along rays for nearer
    ones; where the state has no end, it goes out along them, up to 256 tolerances away.

    Examples
    --------
    >>> import numpy as np
    >>> p = Parameters.article(theta0=np.radians(40.0))
    >>> margin = jump_margin(p, {"theta0": np.radians(1.0), "mu0": 0.05})
    >>> round(margin.distance, 4), {name: round(value, 4) for name, value in margin.change.items()}
    (1.6845, {'theta0': 0.0114, 'mu0': 0.0776})
    """
    designs = space(p, scale, None)
    if prove and not isinstance(p, Parameters):
        raise ParameterError("prove = True is for dimensionless Parameters; call .dimensionless() and give their tolerances")
    safe = partial(_nothing_jumps_within, designs) if prove else None
    return margin(designs, partial(jumping, designs), safe, "mu0", partial(jump_gradient, vary="mu0"))


def jumping(designs: Space, z: FloatArray) -> NDArray[np.bool_]:
    """Which designs jump at their own friction or below it."""
    p = designs.sets(z)
    assert isinstance(p, Parameters)
    return np.asarray(have_jumped(p) == 1)


def _nothing_jumps_within(designs: Space, radius: float) -> bool:
    """Boxes around the design are halved until each lies outside of the ball or is proved.

    Of the friction only the largest value matters that the ball has over a box of the others.
    """
    low, high = designs.limits()
    if (low > -radius).any() or (high < radius).any():
        return False
    values = designs.parameters(np.zeros(len(designs.names)))
    others = [j for j, name in enumerate(designs.names) if name != "mu0"]
    place = [NAMES.index(designs.names[j]) for j in others]
    origin, scale = designs.origin[others, None], designs.scale[others, None]
    ends = np.array([[float(values[name])] for name in NAMES])
    begin, end = ends.copy(), ends.copy()
    begin[place], end[place] = origin - radius * scale, origin + radius * scale
    pending, seen = Boxes(begin, end, np.ones(1)), 0
    while pending.share.size:
        seen += pending.share.size
        if seen > _BOXES:
            return False
        off = (np.clip(origin, pending.low[place], pending.high[place]) - origin) / scale
        rest = (radius * (1 + 1e-9)) ** 2 - (off**2).sum(axis=0)
        pending, rest = pending.rows(np.flatnonzero(rest >= 0)), rest[rest >= 0]
        if "mu0" in designs.names:
            j, k = NAMES.index("mu0"), designs.names.index("mu0")
            pending.low[j] = pending.high[j] = designs.origin[k] + designs.scale[k] * np.sqrt(rest)
        proved, weight = CLAIMS["no jump"].prove(pending)
        left = np.flatnonzero(~proved)
        pending = halved(pending.rows(left), weight[:, left])
    return True
