"""Parameters in newtons, metres and seconds, and the scales between them and the dimensionless ones."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from ... import names
from ...display import Shown
from ...errors import NotDimensionlessError
from .dimensionless import Parameters
from .ranges import as_numbers
from .sets import ParameterSet, Values, named

if TYPE_CHECKING:
    from ..quantities import Quantities


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
        for name, allowed in self.kind.ranges().items():
            if getattr(self, name) is not None or name not in self.kind.of_the_law:
                array = as_numbers(name, getattr(self, name), allowed)
                object.__setattr__(self, name, array if array.ndim else float(array))
        self.shape  # noqa: B018  # shapes that do not broadcast are an error here, not later

    def __getattr__(self, name: str) -> Any:
        # Every function of the model first asks its parameters for one of these.
        if not name.startswith("_") and hasattr(Parameters, name):
            raise NotDimensionlessError(
                "dimensionless Parameters are needed here, and these are PhysicalParameters; call .dimensionless() on them"
            )
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}{names.hint(name, dir(self))}")

    @property
    def kind(self) -> Quantities:
        """The quantities of the article's model: units, ranges, and what they are without dimension."""
        from ..quantities import quantities

        return quantities(Parameters.where)

    @property
    def known(self) -> dict[str, Any]:
        """The quantities that were given, by name."""
        return {name: value for name in self.kind.units if (value := getattr(self, name)) is not None}

    @property
    def scales(self) -> Scales:
        """Scales of length, time and force: multiply a dimensionless result by its scale."""
        return Scales(*(self.kind.scale(unit, self.known) for unit in ("m", "s", "N")))

    def dimensionless(self) -> Parameters:
        """The system as :class:`Parameters`; without V and d if these were not given."""
        return Parameters(**{"V": None, "d": None} | self.kind.groups(self.known))
