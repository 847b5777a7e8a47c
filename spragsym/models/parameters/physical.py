"""Parameters in newtons, metres and seconds, and the scales between them and the dimensionless ones."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, ClassVar

import numpy as np

from ... import names
from ...display import Shown
from ...errors import NotDimensionlessError, ParameterError
from ...generated import scales as _scales
from .dimensionless import BELT_SPEED, NAMES, RANGES, Parameters
from .ranges import Range, as_numbers, range_of
from .sets import ParameterSet, Values, named


@dataclass(frozen=True)
class Scales(Shown):
    """What one dimensionless unit is, in the units of the data, and of their shape: L_0, sqrt(m/k_c) and k_c L_0."""

    length: Any
    time: Any
    force: Any


@named
@dataclass(frozen=True, eq=False)
class PhysicalParameters(Values):
    """The model in newtons, metres, kilograms and seconds, or any consistent system of units; scalars or arrays that broadcast.

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
    >>> brake = PhysicalParameters(m=0.4, k=1e5, k_x=7e3, k_y=0, k_c=1e6, F_L=350, L_0=0.05, theta0=radians(49), mu0=0.5, V=20)
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
    of_model: ClassVar[type[ParameterSet]] = Parameters

    def __post_init__(self) -> None:
        for name, allowed in physical_ranges().items():
            given = getattr(self, name)
            if given is not None or name not in ("V", "d"):
                array = as_numbers(name, given, allowed)
                object.__setattr__(self, name, array if array.ndim else float(array))
        self.shape  # noqa: B018  # shapes that do not broadcast are an error here, not later

    def __getattr__(self, name: str) -> Any:
        # Every function of the model first asks its parameters for one of these.
        if name in _DIMENSIONLESS_ONLY:
            raise NotDimensionlessError(
                "dimensionless Parameters are needed here, and these are PhysicalParameters; call .dimensionless() on them"
            )
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}{names.hint(name, dir(self))}")

    @property
    def scales(self) -> Scales:
        """Scales of length, time and force: multiply a dimensionless result by its scale."""
        return Scales(*(_as_given(value) for value in _scales.scales(self.m, self.k_c, self.L_0)))

    def dimensionless(self) -> Parameters:
        """The system as :class:`Parameters`; without V and d if these were not given."""
        V, d = (0.0 if value is None else value for value in (self.V, self.d))  # they enter their own groups only
        kappa, alpha, sigma, beta, V, d = _scales.dimensionless_groups(
            self.m, self.k_c, self.L_0, self.F_L, self.k_x, self.k, self.k_y, V, d
        )
        belt = {name: value for name, value in (("V", V), ("d", d)) if getattr(self, name) is not None}
        return Parameters(self.theta0, self.mu0, kappa, alpha, sigma, beta, **({"V": None, "d": None} | belt))

    def belt(self) -> dict[str, Any]:
        """Dimensionless ``V`` and ``d``, as :func:`spragsym.simulate` takes them; an error if one was not given."""
        for name in ("V", "d"):
            if getattr(self, name) is None:
                raise ParameterError(f"{name} is missing from the physical parameters, and the motion in time needs it")
        p = self.dimensionless()
        return {"V": _as_given(p.V), "d": _as_given(p.d)}


def physical_ranges() -> dict[str, Range]:
    """Allowed values of the quantities of :class:`PhysicalParameters`."""
    own = {name: range_of(name) for name in ("m", "k", "k_x", "k_y", "k_c", "F_L", "L_0")}
    return own | {name: RANGES[name] for name in ("theta0", "mu0")} | {"V": BELT_SPEED, "d": range_of("d_dim")}


def _as_given(value: Any) -> Any:
    """A single number as a float."""
    return float(value) if np.ndim(value) == 0 else value


#: What :class:`Parameters` has and :class:`PhysicalParameters` has not.
_DIMENSIONLESS_ONLY = {name for name in (*NAMES, *vars(Parameters), *vars(ParameterSet)) if not name.startswith("_")} - {
    field.name for field in fields(PhysicalParameters)
}
