"""The parameters of the article's model: without dimension, and in newtons and metres."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Self, cast

from numpy.typing import ArrayLike

from ..generated.quantities import BASE_VALUES, QUANTITIES
from ..models.parameters import ParameterSet, Range, named
from ..models.quantities import QuantityValues


@named
@dataclass(frozen=True, eq=False, repr=False)
class Parameters(ParameterSet):
    """Dimensionless parameters of the article's model, scalars or arrays that broadcast together;
    base values where left out.

    Parameters
    ----------
    theta0 : array_like, optional
        Inclination θ₀ of the undeformed spring, radians, in (0, π). May be left out for functions
        that span it.
    mu0 : array_like, default 0.5
        Friction coefficient μ₀ ≥ 0. None for functions that span it.
    kappa : array_like, default 0.007
        Preload κ = F_L / (k_c L_0) > 0.
    alpha, beta : array_like, default 0.007 and 0
        Stiffness ratios α = k_x / k_c ≥ 0 and β = k_y / k_c ≥ 0.
    sigma : array_like, default 0.1
        Stiffness ratio σ = k / k_c > 0.
    V : array_like, default 0.5
        Belt speed over L_0 sqrt(k_c/m), V ≥ 0, for the motion. The article states none: the default
        is an assumption.
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
    Source: text after (9), with n = N / (k_c L_0) as derived. The balance of forces is that at full
    slip, (12), where friction is μ₀ whatever V and d.

    Examples
    --------
    >>> import numpy as np
    >>> p = Parameters.article(theta0=np.radians([30.0, 49.0]), mu0=0.7)
    >>> p.shape
    (2,)
    >>> float(p.kappa)
    0.007
    """

    #: The belt's speed and the steepness of the friction law (10) are for the motion only.
    ranges = {
        name: Range(
            QUANTITIES[name].low,
            QUANTITIES[name].high,
            QUANTITIES[name].low_open,
            remedy,
            unit="rad" if name == "theta0" else "1",
        )
        for name, remedy in {
            "theta0": (
                "angles are radians, strictly between 0 and pi; use numpy.radians for degrees"
            ),
            "mu0": (
                "a belt that runs the other way is the mirror image: give the supplement of theta0"
            ),
            "kappa": "without preload nothing presses the mass on the belt",
            "alpha": "",
            "sigma": "without the inclined spring there is no sprag",
            "beta": "",
        }.items()
    } | {
        "V": Range(
            0.0,
            remedy=(
                "a belt that runs the other way is the mirror image: theta0 -> pi - theta0, x -> -x"
            ),
        ),
        "d": Range(
            0.0,
            open_low=True,
            remedy="d is the steepness of the friction law (10); without it there is no friction",
        ),
    }
    spanned = frozenset(("theta0", "mu0", "V", "d"))
    origin = "Parameters.article(...)"
    where = "kang_nam"

    theta0: Any = None
    mu0: Any = BASE_VALUES["mu0"]
    kappa: Any = BASE_VALUES["kappa"]
    alpha: Any = BASE_VALUES["alpha"]
    sigma: Any = BASE_VALUES["sigma"]
    beta: Any = BASE_VALUES["beta"]
    V: Any = 0.5
    d: Any = 10.0

    @classmethod
    def article(cls, **changes: ArrayLike | None) -> Self:
        """The article's base values, μ₀ = 0.5, κ = α = 0.007, σ = 0.1, β = 0, with changes; V and d
        as assumed.
        """
        return cls(**changes)


@named
@dataclass(frozen=True, eq=False)
class PhysicalParameters(QuantityValues):
    """The model in newtons, metres, kilograms and seconds, or any consistent system of units;
    scalars or arrays that broadcast.

    Quantities of pint, astropy, unyt and quantities are converted to SI; then all have units that
    have a dimension.

    Parameters
    ----------
    m : array_like
        Mass.
    k, k_x, k_y, k_c : array_like
        Stiffness of the inclined spring, along the belt, across it, and of the contact.
    F_L : array_like
        Preload.
    L_0 : array_like
        Length of the undeformed inclined spring.
    theta0 : array_like
        Its inclination, radians, in (0, π).
    mu0 : array_like
        Friction coefficient.
    V : array_like, optional
        Belt speed.
    d : array_like, optional
        Steepness of the friction law in creep, per unit of speed.

    Notes
    -----
    Source: text after (9). Lengths are measured in L_0, time in sqrt(m/k_c), forces in k_c L_0.

    Examples
    --------
    >>> from math import radians
    >>> brake = PhysicalParameters(
    ...     m=0.4, k=1e5, k_x=7e3, k_y=0, k_c=1e6, F_L=350, L_0=0.05,
    ...     theta0=radians(49), mu0=0.5, V=20,
    ... )
    >>> brake.dimensionless().replace(theta0=None)
    Parameters(mu0=0.5, kappa=0.007, alpha=0.007, sigma=0.1, beta=0.0, V=0.2529822128134704)
    >>> brake.scales.force
    50000.0
    """

    m: Any
    k: Any
    k_x: Any
    k_y: Any
    k_c: Any
    F_L: Any
    L_0: Any
    theta0: Any
    mu0: Any
    V: Any = None
    d: Any = None
    of_model = Parameters

    def dimensionless(self) -> Parameters:
        """The system as :class:`Parameters`; without V and d if these were not given."""
        return cast(Parameters, super().dimensionless())
