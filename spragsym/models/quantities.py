"""The quantities that a brake with a model is given by: units, ranges, and the dimensionless
parameters that follow from them.
"""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from functools import cache, cached_property
from typing import Any, ClassVar, Self

import numpy as np

from ..core.errors import (
    ModelError,
    NotDimensionlessError,
    ParameterError,
    ParameterTypeError,
    hint,
)
from ..display import Tabular
from ..numerics.interval_arrays import FloatArray
from .load import load
from .model import Model, title_drawing_words
from .parameters import POSITIVE, Carried, ParameterSet, Range, Values, as_numbers
from .units import dimension
from .units import factor as factor


class Quantities:
    """The quantities of a model's page; ``values`` of them are in SI, of many brakes arrays.

    ``bases`` are the units of all others; ``units`` the SI units of all, ``coordinates`` those of
    coordinates, and ``parameters`` what each is called in the model.
    """

    def __init__(self, model: Model) -> None:
        self.model, self.about = model, model.about

        def by(key: str, section: str, value: str) -> dict[str, str]:
            return {entry[key]: entry[value] for entry in self.about[section]}

        self.bases = by("name", "units", "unit")
        self.coordinates = by("name", "coordinates", "unit")
        self.parameters = by("quantity", "parameters", "name")
        self.units = self.bases | by("quantity", "parameters", "quantity_unit")
        self.meanings = by("name", "units", "meaning") | by("quantity", "parameters", "meaning")
        #: The law of friction that is told: of several the first that is in full slip the
        #: coefficient.
        self.law: Mapping[str, Any] = min(
            self.about["frictions"],
            key=lambda law: law["at_rest"] != "full",
            default={"name": "", "quantities": (), "at_rest": "", "belt": "0"},
        )

    @property
    def opens(self) -> bool:
        """Whether a contact opens."""
        return any(contact["unilateral"] for contact in self.about["contacts"])

    def _quantity(self, name: str | None) -> str | None:
        """The quantity of a file that is a parameter."""
        return next((quantity for quantity, one in self.parameters.items() if one == name), None)

    @property
    def friction(self) -> str | None:
        """The quantity that is the friction coefficient, if any."""
        return self._quantity(self.model.coefficient)

    @property
    def inclination(self) -> str | None:
        """The quantity that is the inclination, if any."""
        return self._quantity(self.model.inclination)

    @property
    def has_friction(self) -> bool:
        """Whether the friction law depends on the friction coefficient."""
        return self.law["at_rest"] == "full" or self.friction in self.law["quantities"]

    def powers(self, unit: str) -> dict[str, float]:
        """Powers of the model's units whose product has the dimension of an SI unit."""
        return dict(zip(self.bases, _powers(unit, tuple(self.bases.values())), strict=True))

    def scale(self, unit: str, values: Mapping[str, Any]) -> float:
        """Size of one dimensionless unit of a quantity in SI: the product of powers of the model's
        units that has its dimension.

        Source: dimensional analysis; the model's page makes three quantities of independent
        dimensions 1.

        >>> brake = {"m": 4.0, "k_c": 100.0, "L_0": 0.5}
        >>> found = quantities("kang_nam")
        >>> round(found.scale("N", brake), 12), round(found.scale("s", brake), 12)
        (50.0, 0.2)
        """
        result = 1.0
        for name, power in self.powers(unit).items():
            # Exactly 1 for an angle or a number.
            result = result * values[name] ** power if power else result
        return result

    def scales(self, values: Mapping[str, Any]) -> Scales:
        """Scales of length, time and force."""
        return Scales(*(self.scale(unit, values) for unit in ("m", "s", "N")))

    def groups(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """The dimensionless parameters by name, from quantities of any number type."""
        given = (
            (name, quantity) for quantity, name in self.parameters.items() if quantity in values
        )
        return {
            name: values[quantity] / self.scale(self.units[quantity], values)
            for name, quantity in given
        }

    def parameter_set(self, values: Mapping[str, Any]) -> ParameterSet:
        """The values as the model's parameters."""
        return self.model.Parameters(**self.groups(values))

    def ranges(self, values: Mapping[str, Any] | None = None) -> dict[str, Range]:
        """Ranges of quantities: units of measure are positive, others as their parameters, at units
        of these values.

        Without values an end other than 0 of one with a dimension is not known but for its sign.
        """
        found = {name: replace(POSITIVE, unit=unit) for name, unit in self.bases.items()}
        for quantity, name in self.parameters.items():
            allowed, unit = self.model.Parameters.ranges[name], self.units[quantity]
            low, high, open_low = allowed.low, allowed.high, allowed.open_low
            if values is not None:
                scale = self.scale(unit, values)
                low, high = scale * low, scale * high
            elif not {abs(low), abs(high)} <= {0.0, math.inf} and any(self.powers(unit).values()):
                open_low |= low > 0
                low, high = 0.0 if low >= 0 else -math.inf, 0.0 if high <= 0 else math.inf
            found[quantity] = replace(allowed, low=low, high=high, open_low=open_low, unit=unit)
        return found

    @cached_property
    def balanced(self) -> tuple[str, ...]:
        """Quantities on which the balance of forces depends besides its friction, in the order of
        the model.
        """
        taken, found = set(self.about["arguments"]["statics"]), set[str]()
        for quantity, name in self.parameters.items():
            if taken & {name, *self.about["angles"].get(name, ())}:
                scale = re.findall(r"\w+", self.model.unit(self.units[quantity]))
                found |= {quantity, *self.bases.keys() & set(scale)}
        return self._ordered(found)

    @cached_property
    def of_statics(self) -> tuple[str, ...]:
        """Quantities on which the states depend: those of the balance and of the friction that
        works at rest.
        """
        frictions = (
            (self.friction,) if law["at_rest"] == "full" else law["quantities"]
            for law in self.about["frictions"]
        )
        return self._ordered({*self.balanced, *itertools.chain(*frictions)})

    @cached_property
    def of_the_law(self) -> tuple[str, ...]:
        """Quantities that a brake may be given without: those of friction laws alone; then friction
        is the coefficient, at full slip.

        Of a law that is not proportional to that, or not that at full slip, there are none.
        """
        laws = self.about["frictions"]
        mine = dict.fromkeys(
            name for law in laws if law["at_rest"] == "full" for name in law["quantities"]
        )
        return tuple(name for name in mine if name not in (*self.of_statics, self.friction))

    @cached_property
    def dampers(self) -> tuple[str, ...]:
        """Quantities that are coefficients of dampers, along a line or about a pivot."""
        return tuple(
            name
            for name, unit in self.units.items()
            if _powers(unit, ("kg", "m", "s")) in ((1.0, 0.0, -1.0), (1.0, 2.0, -1.0))
        )

    @property
    def may_rise(self) -> tuple[str, ...]:
        """Quantities on which the states of a model depend, without those that are the units of the
        others.
        """
        return tuple(quantity for quantity in self.parameters if quantity in self.of_statics)

    @property
    def drawing(self) -> str:
        """The mechanism as its page draws it, in characters."""
        return title_drawing_words(self.about)[1]

    @property
    def rises(self) -> str | None:
        """The quantity to choose for the loading parameter of a model without a friction
        coefficient: no one of the friction law, which may fall.
        """
        choice = () if self.friction else self.may_rise
        return min(choice, key=lambda name: name in self.law["quantities"], default=None)

    def _ordered(self, names: set[str]) -> tuple[str, ...]:
        return tuple(quantity for quantity in self.units if quantity in names)


@cache
def _powers(unit: str, bases: tuple[str, ...]) -> tuple[float, ...]:
    if unit in ("1", "rad"):  # which pint need not say
        return (0.0,) * len(bases)

    def powers(text: str) -> list[float]:
        exponents = {} if text == "1" else dimension(text)
        return [float(exponents.get(axis, 0)) for axis in ("[mass]", "[length]", "[time]")]

    matrix = np.array([powers(base) for base in bases]).T
    return tuple(
        round(float(power), 9) for power in np.linalg.solve(matrix, np.array(powers(unit)))
    )


def quantities(name: str) -> Quantities:
    """Quantities of a model by its name, or its folder."""
    return _of(load(name))


_of = cache(Quantities)


def _share_of(model: Model, p: ParameterSet, contact: str) -> FloatArray:
    full = model.friction(p, "friction_at_rest", contact)
    works = model.friction(p, "friction_at_speed", contact)
    return np.where(full > 0, works / np.where(full > 0, full, 1.0), 1.0)[()]


def share(model: Model, p: ParameterSet) -> FloatArray | float:
    """The share of μ₀ at which friction works at the speed of the belt, by the model's own law; of
    the shape of ``p``.
    """
    # Of other laws at rest statics takes the law as it is.
    full = [entry["name"] for entry in model.frictions if entry["at_rest"] == "full"]
    shares = [_share_of(model, p, contact) for contact in full]
    if any(np.any(one != shares[0]) for one in shares):
        raise ModelError(
            f"the frictions of {model.name} work at different shares of {model.coefficient}, and "
            "statics of data takes one; ask equilibria(p) of parameters without units"
        )
    return shares[0] if shares else 1.0


@dataclass(frozen=True)
class Scales(Tabular):
    """Units of a dimensionless model, in the units of the data, and of their shape: L_0,
    sqrt(m/k_c) and k_c L_0.

    Examples
    --------
    >>> Scales(length=0.038, time=4.8e-4, force=57e3).unit_of("m/s")
    ('m/s', 79.16666666666667)
    """

    length: Any
    time: Any
    force: Any

    @property
    def scales(self) -> Self:
        """Itself: a study has scales besides."""
        return self

    def unit_of(self, si: str, _: str = "") -> tuple[str, float]:
        """The unit itself, and what one of the model's is in it."""
        sizes = (self.length, self.time, self.force)
        powers = _powers(si, ("m", "s", "N"))
        return si, float(math.prod(size**power for size, power in zip(sizes, powers, strict=True)))


@dataclass(frozen=True, eq=False)
class QuantityValues(Values):
    """The quantities of a model in SI or any consistent system of units, scalars or arrays that
    broadcast; subclasses have a field for each, None where one may be left out.

    Quantities of pint, astropy, unyt and quantities are converted to SI; then all have units that
    have a dimension.
    """

    #: The class of what they are without dimension.
    of_model: ClassVar[type[ParameterSet]]

    @property
    def _of_model(self) -> Model:
        return self.of_model.model_of_class()

    def __post_init__(self) -> None:
        bare, carrying = list[str](), list[str]()
        for name, allowed in self.kind.ranges().items():
            if getattr(self, name) is not None or name not in self.kind.of_the_law:
                carried = Carried(name, allowed.unit)
                array = as_numbers(name, getattr(self, name), allowed, carried)
                if allowed.unit not in ("1", "rad") and array.any():  # 0 is 0 in any unit
                    (carrying if carried.units - {""} else bare).append(name)
                object.__setattr__(self, name, array if array.ndim else float(array))
        if bare and carrying:
            raise ParameterTypeError(
                f"{', '.join(carrying)} with units, and {', '.join(bare)} without: the numbers may "
                "be of another system of units; give units to all of them, or to none"
            )
        self.shape  # noqa: B018  # shapes that do not broadcast are an error here, not later

    def __getattr__(self, name: str) -> Any:
        # Every function of the model first asks its parameters for one of these.
        if not name.startswith("_") and hasattr(self.of_model, name):
            raise NotDimensionlessError(
                f"dimensionless Parameters are needed here, and these are {type(self).__name__}; "
                "call .dimensionless() on them"
            )
        raise AttributeError(
            f"{type(self).__name__!r} object has no attribute {name!r}{hint(name, dir(self))}"
        )

    @property
    def kind(self) -> Quantities:
        """The quantities of the model: units, ranges, and what they are without dimension."""
        return quantities(self.of_model.where)

    @property
    def known(self) -> dict[str, Any]:
        """The quantities that were given, by name."""
        return {
            name: value for name in self.kind.units if (value := getattr(self, name)) is not None
        }

    @property
    def scales(self) -> Scales:
        """Scales of length, time and force: multiply a dimensionless result by its scale."""
        return self.kind.scales(self.known)

    def dimensionless(self) -> ParameterSet:
        """The system without dimension; without what is of the friction law alone if that was not
        given.
        """
        left_out = {self.kind.parameters[name]: None for name in self.kind.of_the_law}
        return self.of_model(**left_out | self.kind.groups(self.known))


@dataclass(frozen=True)
class Unit:
    """A unit of measure that has a range too: its ends over its base value, and the power of it in
    each parameter.

    A parameter is P u₁^e₁ u₂^e₂ …, where P is what it is at the base values.
    """

    low: float
    high: float
    powers: Mapping[str, float]


def checked_units(
    units: Mapping[str, Unit] | None, parameters: Collection[str], angles: Collection[str]
) -> dict[str, Unit]:
    """Units by name, without powers that are 0, for a model with these parameters, of which some
    are angles; or an error.
    """
    if not isinstance(units or {}, Mapping):
        raise ParameterTypeError(f"units = {units!r:.60} is no mapping; give units by name")
    found = {}
    for name, unit in (units or {}).items():
        if not isinstance(unit, Unit):
            raise ParameterTypeError(
                f"units[{name!r}] = {unit!r:.60} is no Unit; make one with Unit(low, high, powers)"
            )
        if name in parameters:
            raise ParameterError(
                f"units: {name!r} is a parameter of the model; give the unit another name"
            )
        if not 0 < unit.low <= unit.high < math.inf:
            raise ParameterError(
                f"units[{name!r}]: from {unit.low} to {unit.high}; give two ends above 0, the "
                "smaller first"
            )
        for of, power in unit.powers.items():
            if of not in parameters:
                raise ParameterError(
                    f"units[{name!r}]: {of!r} is not a parameter of the model; there are "
                    f"{', '.join(parameters)}"
                )
            if not math.isfinite(power) or (power and of in angles):
                raise ParameterError(
                    f"units[{name!r}]: {of} has the power {power} of it; give a finite one, "
                    "and none for an angle"
                )
        found[name] = replace(
            unit, powers={of: power for of, power in unit.powers.items() if power}
        )
    return found
