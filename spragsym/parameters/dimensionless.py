"""The dimensionless parameters of the article's model."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from numpy.typing import ArrayLike

from ..generated.quantities import BASE_VALUES, PARAMETERS
from .ranges import range_of
from .sets import ParameterSet, check_names, named

#: Names of the dimensionless parameters, in the order in which every function takes them.
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

RANGES = {name: range_of(name, _REMEDIES.get(name, "")) for name in NAMES}


@named
@dataclass(frozen=True, eq=False, repr=False)
class Parameters(ParameterSet):
    """Dimensionless parameters, scalars or arrays that broadcast together.

    Parameters
    ----------
    theta0 : array_like, optional
        Inclination θ₀ of the undeformed spring, radians, in (0, π). May be left out for functions that span it.
    mu0 : array_like, optional
        Friction coefficient μ₀ ≥ 0. May be left out for functions that span it.
    kappa : array_like
        Preload κ = F_L / (k_c L_0) > 0.
    alpha, beta : array_like
        Stiffness ratios α = k_x / k_c ≥ 0 and β = k_y / k_c ≥ 0.
    sigma : array_like
        Stiffness ratio σ = k / k_c > 0.

    Raises
    ------
    ParameterError
        For a value out of range, or shapes that do not broadcast.
    ParameterTypeError
        For anything but real numbers.

    Notes
    -----
    Source: text after (9), with n = N / (k_c L_0) as derived.

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
    spanned = frozenset(("theta0", "mu0"))
    origin = "Parameters.article(...)"

    theta0: Any = None
    mu0: Any = None
    kappa: Any = None
    alpha: Any = None
    sigma: Any = None
    beta: Any = None

    @classmethod
    def article(cls, **changes: ArrayLike | None) -> Parameters:
        """The article's base values, μ₀ = 0.5, κ = α = 0.007, σ = 0.1, β = 0, with changes."""
        check_names(changes, NAMES)
        return cls(**{**ARTICLE, **changes})
