"""Dimensional quantities of a brake: their units and ranges, and the dimensionless parameters that
follow from them.
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
from numpy.typing import ArrayLike

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
from .parameters import POSITIVE, Carried, ParameterSet, Range, Values, as_mapping, as_numbers
from .units import dimension
from .units import factor as factor


class Quantities:
    """The quantities of a model's page.

    ``bases`` are the SI units of the page's units of measure, by name, and ``units`` those of all
    quantities. ``coordinates`` are the units of coordinates. ``parameters`` are the names of the
    model's parameters, by quantity. Methods take ``values`` in SI by name, arrays for many brakes.
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
        #: The friction law that reports describe: the first that is the coefficient in full slip,
        #: else the first of all.
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
        """The quantity that is the named parameter, or None."""
        return next((quantity for quantity, one in self.parameters.items() if one == name), None)

    @property
    def friction(self) -> str | None:
        """The quantity that is the friction coefficient, or None."""
        return self._quantity(self.model.coefficient)

    @property
    def inclination(self) -> str | None:
        """The quantity that is the inclination, or None."""
        return self._quantity(self.model.inclination)

    @property
    def has_friction(self) -> bool:
        """Whether the friction law depends on the friction coefficient."""
        return self.law["at_rest"] == "full" or self.friction in self.law["quantities"]

    def powers(self, unit: str) -> dict[str, float]:
        """Exponents of the page's units whose product has the dimension of an SI unit."""
        return dict(zip(self.bases, _powers(unit, tuple(self.bases.values())), strict=True))

    def scale(self, unit: str, values: Mapping[str, Any]) -> float:
        """Size in SI of the dimensionless unit of a quantity whose SI unit is ``unit``.

        It is the product of powers of the page's units that has this dimension. Source: dimensional
        analysis; the page sets three quantities of independent dimensions to 1.

        >>> brake = {"m": 4.0, "k_c": 100.0, "L_0": 0.5}
        >>> found = quantities("kang_nam")
        >>> round(found.scale("N", brake), 12), round(found.scale("s", brake), 12)
        (50.0, 0.2)
        """
        result = 1.0
        for name, power in self.powers(unit).items():
            if power:  # so that the scale of an angle or a number is exactly 1
                result = result * values[name] ** power
        return result

    def scales(self, values: Mapping[str, Any]) -> Scales:
        """The scales of length, time and force."""
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
        """The dimensionless parameters as a set."""
        return self.model.Parameters(**self.groups(values))

    def ranges(self, values: Mapping[str, Any] | None = None) -> dict[str, Range]:
        """Allowed ranges of quantities, in SI: positive for the page's units, for others those of
        the parameters times their scales.

        Without ``values`` scales are unknown. Then a range with a dimension keeps only its ends 0,
        and other ends become 0 or infinite.
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
        """Quantities on which the balance of forces depends, without those of friction, in the
        order of the model.
        """
        arguments, found = set(self.about["arguments"]["statics"]), set[str]()
        for quantity, name in self.parameters.items():
            if arguments & {name, *self.about["angles"].get(name, ())}:
                scale = re.findall(r"\w+", self.model.unit(self.units[quantity]))
                found |= {quantity, *self.bases.keys() & set(scale)}
        return self._ordered(found)

    @cached_property
    def of_statics(self) -> tuple[str, ...]:
        """Quantities on which equilibria depend: those of the balance and of friction in
        statics.
        """
        frictions = (
            (self.friction,) if law["at_rest"] == "full" else law["quantities"]
            for law in self.about["frictions"]
        )
        return self._ordered({*self.balanced, *itertools.chain(*frictions)})

    @cached_property
    def of_the_law(self) -> tuple[str, ...]:
        """Quantities that may be omitted: those of friction laws alone. Friction is then the
        coefficient at full slip.

        Only laws proportional to the coefficient at full slip have such quantities.
        """
        laws = self.about["frictions"]
        names = dict.fromkeys(
            name for law in laws if law["at_rest"] == "full" for name in law["quantities"]
        )
        return tuple(name for name in names if name not in (*self.of_statics, self.friction))

    @cached_property
    def dampers(self) -> tuple[str, ...]:
        """Quantities that are damping coefficients, by their units N s/m and N m s."""
        return tuple(
            name
            for name, unit in self.units.items()
            if _powers(unit, ("kg", "m", "s")) in ((1.0, 0.0, -1.0), (1.0, 2.0, -1.0))
        )

    @property
    def may_rise(self) -> tuple[str, ...]:
        """Quantities that may be the loading parameter: equilibria depend on them, and they are no
        unit.
        """
        return tuple(quantity for quantity in self.parameters if quantity in self.of_statics)

    @property
    def drawing(self) -> str:
        """The page's drawing of the mechanism, in characters."""
        return title_drawing_words(self.about)[1]

    @property
    def rises(self) -> str | None:
        """The default loading parameter of a model without a friction coefficient, or None.

        Quantities of the friction law come last, since they may fall.
        """
        choice = () if self.friction else self.may_rise
        return min(choice, key=lambda name: name in self.law["quantities"], default=None)

    def _ordered(self, names: set[str]) -> tuple[str, ...]:
        """The names in the order of the model."""
        return tuple(quantity for quantity in self.units if quantity in names)


@cache
def _powers(unit: str, bases: tuple[str, ...]) -> tuple[float, ...]:
    """Exponents of the ``bases`` whose product has the dimension of ``unit``."""
    if unit in ("1", "rad"):  # without loading pint
        return (0.0,) * len(bases)

    def powers(text: str) -> list[float]:
        exponents = {} if text == "1" else dimension(text)
        return [float(exponents.get(axis, 0)) for axis in ("[mass]", "[length]", "[time]")]

    matrix = np.array([powers(base) for base in bases]).T
    solution = np.linalg.solve(matrix, np.array(powers(unit)))
    return tuple(round(float(power), 9) for power in solution)


def quantities(name: str) -> Quantities:
    """The quantities of a model, by its name or folder."""
    return _of(load(name))


_of = cache(Quantities)


def _share_of(model: Model, p: ParameterSet, contact: str) -> FloatArray:
    """The share of full-slip friction that one contact has at the speed of the belt."""
    full = model.friction(p, "friction_at_rest", contact)
    works = model.friction(p, "friction_at_speed", contact)
    return np.where(full > 0, works / np.where(full > 0, full, 1.0), 1.0)[()]


def share(model: Model, p: ParameterSet) -> FloatArray | float:
    """The share of μ₀ that friction has at the speed of the belt, by the model's law; of the shape
    of ``p``.
    """
    # Statics takes other laws as they are: their share is 1.
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
    """Sizes of a dimensionless model's units of length, time and force, in the units of the data.

    For the article's model they are L_0, sqrt(m/k_c) and k_c L_0. They have the shape of the data.

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
        """Itself, so that scales and studies are used alike."""
        return self

    def unit_of(self, si: str, _: str = "") -> tuple[str, float]:
        """The unit ``si``, and the size in it of the model's unit of the same dimension."""
        sizes = (self.length, self.time, self.force)
        powers = _powers(si, ("m", "s", "N"))
        return si, float(math.prod(size**power for size, power in zip(sizes, powers, strict=True)))


def in_si(
    given: Mapping[str, ArrayLike], allowed: Mapping[str, Range]
) -> tuple[dict[str, FloatArray], bool]:
    """The given quantities in SI, checked, and whether they have units.

    Raises
    ------
    ParameterTypeError
        If some have units and others, which are not 0, have none; errors of ``as_numbers``.
    """
    found, bare, carrying = dict[str, FloatArray](), list[str](), list[str]()
    for name, value in given.items():
        carried = Carried(name, allowed[name].unit)
        found[name] = as_numbers(name, value, allowed[name], carried)
        if allowed[name].unit not in ("1", "rad") and found[name].any():  # 0 is 0 in any unit
            (carrying if carried.units - {""} else bare).append(name)
    if bare and carrying:
        raise ParameterTypeError(
            f"{', '.join(carrying)} with units, and {', '.join(bare)} without: the numbers may be "
            "of another system of units; give units to all of them, or to none"
        )
    return found, bool(carrying)


@dataclass(frozen=True, eq=False)
class QuantityValues(Values):
    """The quantities of a model in SI or any consistent system of units, scalars or arrays that
    broadcast.

    Subclasses have a field for each quantity; one that may be omitted can be None. Quantities of
    pint, astropy, unyt and quantities are converted to SI; then all quantities with a dimension
    must have a unit.
    """

    #: Class of the dimensionless parameters.
    of_model: ClassVar[type[ParameterSet]]
    #: Whether the numbers were given with units.
    has_units: ClassVar[bool] = False

    @property
    def _of_model(self) -> Model:
        return self.of_model.model_of_class()

    def __post_init__(self) -> None:
        ranges, optional = self.kind.ranges(), self.kind.of_the_law
        given = {name: getattr(self, name) for name in ranges}
        found, has_units = in_si(
            {name: it for name, it in given.items() if it is not None or name not in optional},
            ranges,
        )
        object.__setattr__(self, "has_units", has_units)
        for name, array in found.items():
            object.__setattr__(self, name, array if array.ndim else float(array))
        self.shape  # noqa: B018  # shapes that do not broadcast are an error here, not later

    def __getattr__(self, name: str) -> Any:
        # A question that gets quantities instead of parameters asks for such an attribute first.
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
        """The quantities of the model: units, ranges and dimensionless parameters."""
        return quantities(self.of_model.where)

    @property
    def known(self) -> dict[str, Any]:
        """The values that were given, by quantity."""
        return {
            name: value for name in self.kind.units if (value := getattr(self, name)) is not None
        }

    @property
    def scales(self) -> Scales:
        """Scales of length, time and force: a dimensionless result times its scale is in the unit
        of the data.
        """
        return self.kind.scales(self.known)

    def dimensionless(self) -> ParameterSet:
        """The dimensionless parameters; those of the friction law alone may be missing."""
        left_out = {self.kind.parameters[name]: None for name in self.kind.of_the_law}
        return self.of_model(**left_out | self.kind.groups(self.known))


@dataclass(frozen=True)
class Unit:
    """A unit of measure that varies: its range over its base value, and its exponent in each
    parameter.

    A parameter is P u₁^e₁ u₂^e₂ …, where P is its value at the base values of the units.
    """

    low: float
    high: float
    powers: Mapping[str, float]


def checked_units(
    units: Mapping[str, Unit] | None, parameters: Collection[str], angles: Collection[str]
) -> dict[str, Unit]:
    """Units by name, without exponents that are 0; an error for one that does not fit the model.

    ``angles`` are those of the ``parameters`` that are angles.
    """
    found = {}
    for name, unit in as_mapping("units", units, "units by name").items():
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
