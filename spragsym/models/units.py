"""Units of measure: the words that are read, their size in SI, and numbers that carry a unit."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache, lru_cache
from math import pi
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.errors import ParameterError, ParameterTypeError

if TYPE_CHECKING:
    import pint

# ------------------------------------------------------------------------------------------------
# their words

#: Prefixes of SI.
_PREFIXES = {
    "n": ("nano", "1e-9"),
    "u": ("micro", "1e-6"),
    "µ": ("micro", "1e-6"),
    "μ": ("micro", "1e-6"),
    "m": ("milli", "1e-3"),
    "c": ("centi", "1e-2"),
    "d": ("deci", "1e-1"),
    "da": ("deca", "1e1"),
    "h": ("hecto", "1e2"),
    "k": ("kilo", "1e3"),
    "M": ("mega", "1e6"),
    "G": ("giga", "1e9"),
}
#: Units that take a prefix: symbol, definition, and long names.
_WITH_PREFIX: dict[str, tuple[str, tuple[str, ...]]] = {
    "m": ("[length]", ("meter", "metre")),
    "g": ("[mass]", ("gram",)),
    "s": ("[time]", ("second",)),
    "rad": ("[angle]", ("radian",)),
    "N": ("kilogram meter / second**2", ("newton",)),
    "Pa": ("newton / meter**2", ("pascal",)),
    "J": ("newton meter", ("joule",)),
    "W": ("joule / second", ("watt",)),
    "Hz": ("1 / second", ("hertz",)),
}
#: Units without a prefix: name, definition, and the words that mean it. The inch and the pound are
#: those of 1959; standard gravity is that of 1901.
_ALONE: dict[str, tuple[str, tuple[str, ...]]] = {
    "metric_ton": ("1000 kilogram", ("t", "tonne", "metric_ton")),
    "pound": ("0.45359237 kilogram", ("lb", "lbs", "pound", "pounds", "lbm", "pound_mass")),
    "short_ton": ("2000 pound", ("short_ton",)),
    "grain": ("1/7000 pound", ("grain", "grains")),
    "inch": ("0.0254 meter", ("in", "inch", "inches")),
    "foot": ("12 inch", ("ft", "foot", "feet")),
    "yard": ("36 inch", ("yd", "yard", "yards")),
    "thou": ("0.001 inch", ("thou",)),
    "mile": ("5280 foot", ("mi", "mile", "miles")),
    "pound_force": (
        "9.80665 pound meter / second**2",
        ("lbf", "pound_force", "force_pound"),
    ),
    "kilogram_force": ("9.80665 newton", ("kgf", "kp", "kilogram_force", "force_kilogram")),
    "slug": ("pound_force second**2 / foot", ("slug", "slugs")),
    "kip": ("1000 pound_force", ("kip",)),
    "psi": ("pound_force / inch**2", ("psi", "pound_force_per_square_inch")),
    "ksi": ("1000 psi", ("ksi", "kip_per_square_inch")),
    "bar": ("100000 pascal", ("bar",)),
    "millibar": ("100 pascal", ("mbar", "millibar")),
    "degree": (f"{pi / 180!r} radian", ("deg", "degree", "degrees", "°")),
    "arcminute": (f"{pi / 10800!r} radian", ("arcmin", "arcminute", "arcminutes")),
    "gon": (f"{pi / 200!r} radian", ("gon", "grade")),
    "turn": (f"{2 * pi!r} radian", ("turn", "rev", "revolution")),
    "rpm": (f"{pi / 30!r} radian / second", ("rpm", "revolutions_per_minute")),
    "minute": ("60 second", ("min", "minute", "minutes")),
    "hour": ("3600 second", ("h", "hr", "hour", "hours")),
}
#: Ambiguous words, which are refused, and the words to use instead.
_TWO_MEANINGS = {
    "grad": "deg and gon",
    "Grad": "deg and gon",
    "gr": "g and grain",
    "ton": "t (1000 kg) and short_ton",
    "tons": "t (1000 kg) and short_ton",
    "mil": "mm and thou",
    "mils": "mm and thou",
}


@cache
def _words() -> dict[str, str]:
    """Long names of units, by the words that are read."""
    long_names = {word: name for name, (_, words) in _ALONE.items() for word in words}
    for symbol, (_, names) in _WITH_PREFIX.items():
        long = [form for one in names for form in (one, f"{one}s")]
        long_names |= dict.fromkeys([symbol, *long], names[0])
        for prefix, (whole, _) in _PREFIXES.items():
            long_names.setdefault(prefix + symbol, whole + names[0])
            long_names |= {whole + form: whole + names[0] for form in long}
    return long_names


@cache
def _registry() -> pint.UnitRegistry[Any]:
    """A pint registry of the units defined above alone."""
    from pint import UnitRegistry

    registry: pint.UnitRegistry[Any] = UnitRegistry(None, non_int_type=Fraction)
    for whole, size in dict(_PREFIXES.values()).items():
        registry.define(f"{whole}- = {size}")
    units = {names[0]: definition for definition, names in _WITH_PREFIX.values()}
    for name, definition in (units | {name: one for name, (one, _) in _ALONE.items()}).items():
        registry.define(f"{name} = {definition}")
    return registry


@lru_cache(maxsize=256)
def factor(unit: str, si: str) -> float:
    """Size of one ``unit`` in the SI unit ``si``.

    Raises ParameterError if the unit is unknown or measures another quantity.

    >>> import math
    >>> factor("N/mm", "N/m"), factor("deg", "rad") == math.pi / 180
    (1000.0, True)
    """
    if si == "1":
        if unit not in ("", "1", "%"):
            raise ParameterError(f"the unit {unit!r} is too much: this is a number without unit")
        return 0.01 if unit == "%" else 1.0
    given, expected = dimension(unit), dimension(si)
    axes = {*expected, *given}
    different = {axis for axis in axes if expected.get(axis, 0) != given.get(axis, 0)}
    torque = {"[length]": 2, "[mass]": 1, "[time]": -2}
    # The stiffness of a torsion spring may be in N m or N m/rad: the radian is 1.
    if all(expected.get(axis, 0) == power for axis, power in torque.items()):
        different.discard("[angle]")
    if different:
        long = re.sub(r"\s*([*/])\s*", r" \1 ", spelled(unit))
        raise ParameterError(f"the unit {unit!r} ({long}) does not measure what {si} does")
    return float(_size(unit) / _size(si))


@lru_cache(maxsize=256)
def parsed(unit: str) -> pint.Unit:
    """The pint unit of a text; ParameterError if it is unknown."""
    named, registry = spelled(unit).replace("·", "*").replace("⋅", "*"), _registry()
    try:
        return registry.parse_units(named)
    except Exception as error:  # pint raises many kinds, of the tokenizer too
        raise ParameterError(f"the unit {unit!r} is not known") from error


def _size(unit: str) -> Fraction | float:
    """Size of one unit in the base units metre, gram, second and radian."""
    quantity = _registry().Quantity(Fraction(1), parsed(unit))
    size = quantity.to_root_units().magnitude
    return size


def dimension(unit: str) -> Mapping[str, Any]:
    """Exponents of length, mass, time and angle in a unit, without those that are 0."""
    return parsed(unit).dimensionality


def spelled(unit: str) -> str:
    """A unit with each word replaced by its long name; ParameterError for an unknown word.

    Works without pint, whose import takes longer than everything else that leads to the error.
    """
    # A power of a power could be astronomically large: only words may have powers.
    without_powers = re.sub(r"(?<=[^\W\d])\s*(\^|\*\*)\s*-?\d+", "", unit)
    nested = re.search(r"(\^|\*\*)[^*/·⋅]*(\^|\*\*)", without_powers)
    # Pint's parser sees no other characters.
    characters = re.compile(r"[\w°µμΩ%*/^·⋅²³⁻¹ ().\-]{1,60}")
    long_number = any(len(digits) > 2 for digits in re.findall(r"\d+", unit))
    if not characters.fullmatch(unit) or nested or long_number:
        raise ParameterError(f"the unit {unit!r} can't be read")
    word = re.compile(r"(?:(?![²³¹])[^\W\d])+|[%°]")
    return word.sub(lambda found: _named(found[0], unit), unit)


def _named(word: str, unit: str) -> str:
    """Long name of one word of a unit; ParameterError, with advice, for an unknown or ambiguous
    word.
    """
    if word in _TWO_MEANINGS:
        raise ParameterError(f"the unit {word!r} has two meanings, {_TWO_MEANINGS[word]}")
    factors = {"%": "percent", "percent": "percent", "ppm": "ppm"}
    if word in factors:
        raise ParameterError(
            f"{factors[word]} in the unit {unit!r} is a factor and no unit; multiply the number "
            "by it"
        )
    if word not in _words():
        raise ParameterError(
            f"the unit {unit!r} is not known; write m, g, s, N, Pa, J, W, Hz or rad, each with a "
            "prefix if need be, or t, in, ft, yd, mi, lb, lbf, slug, kgf, kip, psi, ksi, bar, deg, "
            "gon, arcmin, rev, rpm, min or h"
        )
    return _words()[word]


# ------------------------------------------------------------------------------------------------
# numbers that carry a unit

#: Libraries whose units are understood: names of the attributes that hold the unit and the numbers.
_UNDERSTOOD = {
    "pint": ("units", "magnitude"),
    "astropy": ("unit", "value"),
    "unyt": ("units", "value"),
    "quantities": ("dimensionality", "magnitude"),
}
#: Texts of no unit, and of percent.
_NO_UNIT = ("", "1", "dimensionless", "None", "()")
#: An attribute with such a name shows that an object of another library has a unit.
_HINTS = re.compile("unit|dimensionality", re.IGNORECASE)


class Carried:
    """The units found in the elements of one argument; ``""`` for an element without one."""

    def __init__(self, name: str, si: str) -> None:
        self.name, self.si = name, si
        self.units: set[str] = set()

    def numbers(self, value: Any) -> Any:
        """``value`` in SI without units: a number, an array, or lists of these."""
        kind = type(value)
        if kind in (float, int):
            self.units.add("")
            return value
        if kind in (list, tuple):
            return [self.numbers(one) for one in value]
        dtype = getattr(value, "dtype", None)
        if isinstance(value, bool) or getattr(dtype, "kind", "") == "b":
            raise ParameterTypeError(
                f"{self.name} = {value!r:.60} is a boolean; it must be real numbers"
            )
        if kind in (str, bytes) or (isinstance(value, np.generic) and kind.__module__ == "numpy"):
            self.units.add("")
            return value
        if isinstance(value, np.ma.MaskedArray) or getattr(value, "mask", None) is not None:
            value = self._unmasked(value)
        if type(value) is np.ndarray:
            return self._elements(value)
        return self._of_library(value)

    def _elements(self, array: NDArray[Any]) -> object:
        """The elements of an array, each converted if they are objects."""
        if array.dtype != object:
            if array.size:
                self.units.add("")
            return array
        return [self.numbers(one) for one in array] if array.ndim else self.numbers(array.item())

    def _unmasked(self, value: Any) -> Any:
        """A masked array as a plain one; ParameterTypeError if an element is masked."""
        mask = value.mask
        if callable(mask):  # as of pandas
            return value
        if np.any(mask):
            raise ParameterTypeError(
                f"{self.name} has {int(np.sum(mask))} masked values, and a masked value has no "
                f"equilibria; use {self.name}.compressed(), or {self.name}.filled(...) with a "
                "number"
            )
        if isinstance(value, np.ma.MaskedArray):
            # A subclass from another library may carry a unit, which filled() keeps.
            return value.data if type(value) is np.ma.MaskedArray else value.filled()
        return getattr(value, "unmasked", value)

    def _of_library(self, value: Any) -> Any:
        """Numbers in SI of an object of some library: a container, or a quantity with a unit."""
        root = _root(type(value))
        if root in _UNDERSTOOD and hasattr(value, _UNDERSTOOD[root][0]):
            unit, numbers = (getattr(value, one) for one in _UNDERSTOOD[root])
            return self._converted(getattr(unit, "string", str(unit)), numbers)
        dims = getattr(value, "dims", ())
        if dims and hasattr(value, "values"):
            raise ParameterTypeError(
                f"{self.name} has the dimensions {', '.join(map(str, dims))}, and arrays broadcast "
                f"by their shapes here; give {self.name}.values, or xarray.broadcast(...) first"
            )
        graph = getattr(value, "__dask_graph__", None)
        if graph is not None and graph() is not None:
            return self.numbers(value.compute())
        attributes = getattr(value, "attrs", None)
        labelled: Any = attributes if hasattr(attributes, "keys") else {}
        for key in labelled:  # of xarray, pandas and HDF5
            if _HINTS.search(str(key)):
                held = value.data if root == "xarray" else np.asarray(value)
                return self._converted(str(labelled[key]), held)
        if root == "pandas" and hasattr(value, "array"):
            return self.numbers(value.array)
        if root == "xarray":
            return self.numbers(value.data)
        if carried := next(_signs(value), None):
            raise ParameterTypeError(
                f"{self.name} is {carried}, an object of {root}, whose units are not "
                "converted; give "
                f"its numbers {self._wanted()}, or a quantity of {', '.join(_UNDERSTOOD)}"
            )
        if isinstance(value, Sequence) and not hasattr(value, "__array__"):
            return [self.numbers(one) for one in value]
        array = value if isinstance(value, int | float) else np.asanyarray(value)
        if type(array) is type(value) or not isinstance(array, np.ndarray):
            array = np.asarray(array)  # a subclass without a unit
        if array.dtype == object and not array.ndim:
            return value  # no number: the caller raises the error
        return self.numbers(array)

    def _converted(self, unit: str, numbers: object) -> ArrayLike:
        """Numbers with a unit, in SI."""
        plain = "" if unit.strip() in _NO_UNIT else unit.strip()
        inner = Carried(self.name, self.si)
        given = np.asarray(inner.numbers(numbers))
        if inner.units - {""}:
            raise ParameterTypeError(f"{self.name} has a unit within a unit, {unit}")
        self.units.add(plain)
        if not plain or given.dtype.kind not in "iuf":
            return given
        try:
            return given.astype(float) * factor(
                "%" if plain in ("percent", "%") else plain, self.si
            )
        except ParameterError as error:
            raise ParameterTypeError(
                f"{self.name} is in {plain}: {error}; give its number {self._wanted()}"
            ) from error

    def _wanted(self) -> str:
        """The expected unit, for messages."""
        return {"1": "without unit", "rad": "in radians"}.get(self.si, f"in {self.si}")


def _root(kind: type) -> str:
    """Name of the library of a class; of any of its bases if that library is understood."""
    roots = [base.__module__.partition(".")[0] for base in kind.__mro__]
    return next((root for root in roots if root in _UNDERSTOOD), roots[0])


def _signs(value: object) -> Iterator[str]:
    """Texts on attributes that show that an object has a unit."""
    for name in ("units", "unit"):
        text = getattr(value, name, None)
        if text is not None and not callable(text) and str(text) not in _NO_UNIT:
            yield f"in {text}"
    plain = any(name in ("units", "unit") for name in dir(value))
    for name in sorted(dir(value), key=lambda name: name.startswith("_")):
        if _HINTS.search(name) and not plain:
            yield f"with {name}"
