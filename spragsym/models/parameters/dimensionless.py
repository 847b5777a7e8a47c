"""The dimensionless parameters of the article's model."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Self

from numpy.typing import ArrayLike

from ... import assumed
from ...generated.quantities import BASE_VALUES, PARAMETERS, QUANTITIES
from .ranges import Range
from .sets import ParameterSet, named

#: Names of the parameters of the balance of forces, in the order in which its closed forms take them.
NAMES = PARAMETERS

#: The article's base values (Section 3); its θ₀ is the control parameter.
ARTICLE = BASE_VALUES

#: Remedies for values out of range, where the range alone does not suggest one.
_REMEDIES = {
    "theta0": "angles are radians, strictly between 0 and pi; use numpy.radians for degrees",
    "mu0": "a belt that runs the other way is the mirror image: give the supplement of theta0",
    "kappa": "without preload nothing presses the mass on the belt",
    "sigma": "without the inclined spring there is no sprag",
}


def _range(name: str, remedy: str) -> Range:
    quantity = QUANTITIES[name]
    return Range(quantity.low, quantity.high, quantity.low_open and not math.isinf(quantity.low), remedy)


#: The belt's speed and the steepness of the friction law (10) are for the motion only.
RANGES = {name: _range(name, _REMEDIES.get(name, "")) for name in NAMES} | {
    "V": Range(0.0, remedy="a belt that runs the other way is the mirror image: theta0 -> pi - theta0, x -> -x"),
    "d": Range(0.0, open_low=True, remedy="d is the steepness of the friction law (10); without it there is no friction"),
}


@named
@dataclass(frozen=True, eq=False, repr=False)
class Parameters(ParameterSet):
    """Dimensionless parameters of the article's model, scalars or arrays that broadcast together; base values where left out.

    Parameters
    ----------
    theta0 : array_like, optional
        Inclination θ₀ of the undeformed spring, radians, in (0, π). May be left out for functions that span it.
    mu0 : array_like, default 0.5
        Friction coefficient μ₀ ≥ 0. None for functions that span it.
    kappa : array_like, default 0.007
        Preload κ = F_L / (k_c L_0) > 0.
    alpha, beta : array_like, default 0.007 and 0
        Stiffness ratios α = k_x / k_c ≥ 0 and β = k_y / k_c ≥ 0.
    sigma : array_like, default 0.1
        Stiffness ratio σ = k / k_c > 0.
    V : array_like, default 0.5
        Belt speed over L_0 sqrt(k_c/m), V ≥ 0, for the motion. The article states none: the default is an assumption.
    d : array_like, default 10
        Steepness of the friction law (10), times L_0 sqrt(k_c/m), d > 0, for the motion. Likewise.

    Raises
    ------
    ParameterError
        For a value out of range, or shapes that do not broadcast.
    ParameterTypeError
        For anything but real numbers.

    Notes
    -----
    Source: text after (9), with n = N / (k_c L_0) as derived. The balance of forces is that at full slip, (12), where friction is
    μ₀ whatever V and d.

    Examples
    --------
    >>> import numpy as np
    >>> p = Parameters.article(theta0=np.radians([30.0, 49.0]), mu0=0.7)
    >>> p.shape
    (2,)
    >>> float(p.kappa)
    0.007
    """

    ranges = RANGES
    spanned = frozenset(("theta0", "mu0", "V", "d"))
    origin = "Parameters.article(...)"
    where = "kang_nam"

    theta0: Any = None
    mu0: Any = ARTICLE["mu0"]
    kappa: Any = ARTICLE["kappa"]
    alpha: Any = ARTICLE["alpha"]
    sigma: Any = ARTICLE["sigma"]
    beta: Any = ARTICLE["beta"]
    V: Any = assumed.V
    d: Any = assumed.D

    @classmethod
    def article(cls, **changes: ArrayLike | None) -> Self:
        """The article's base values, μ₀ = 0.5, κ = α = 0.007, σ = 0.1, β = 0, with changes; V and d as assumed."""
        return cls(**changes)
