"""Units of measure: those that are read, what one is in SI, and numbers of objects that carry
one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache, lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from ..core.errors import ParameterError, ParameterTypeError

if TYPE_CHECKING:
    import pint

# ------------------------------------------------------------------------------------- their words

#: Prefixes of SI, and the units that take them, each with its long names.
_PREFIXES = {
    "n": "nano",
    "u": "micro",
    "µ": "micro",
    "μ": "micro",
    "m": "milli",
    "c": "centi",
    "d": "deci",
    "da": "deca",
    "h": "hecto",
    "k": "kilo",
    "M": "mega",
    "G": "giga",
}
_WITH_PREFIX = {
    "m": ("meter", "metre"),
    "g": ("gram",),
    "s": ("second",),
    "N": ("newton",),
    "Pa": ("pascal",),
    "J": ("joule",),
    "W": ("watt",),
    "Hz": ("hertz",),
    "rad": ("radian",),
}
#: Units without a prefix: what pint calls each, and the words that mean it.
_ALONE = {
    "metric_ton": ("t", "tonne", "metric_ton"),
    "short_ton": ("short_ton",),
    "pound": ("lb", "lbs", "pound", "pounds", "lbm", "pound_mass"),
    "grain": ("grain", "grains"),
    "slug": ("slug", "slugs"),
    "inch": ("in", "inch", "inches"),
    "foot": ("ft", "foot", "feet"),
    "yard": ("yd", "yard", "yards"),
    "thou": ("thou",),
    "mile": ("mi", "mile", "miles"),
    "pound_force": ("lbf", "pound_force", "force_pound"),
    "kilogram_force": ("kgf", "kp", "kilogram_force", "force_kilogram"),
    "kip": ("kip",),
    "psi": ("psi", "pound_force_per_square_inch"),
    "ksi": ("ksi", "kip_per_square_inch"),
    "bar": ("bar",),
    "millibar": ("mbar", "millibar"),
    "degree": ("deg", "degree", "degrees", "°"),
    "arcminute": ("arcmin", "arcminute", "arcminutes"),
    "gon": ("gon", "grade"),
    "turn": ("turn", "rev", "revolution"),
    "rpm": ("rpm", "revolutions_per_minute"),
    "minute": ("min", "minute", "minutes"),
    "hour": ("h", "hr", "hour", "hours"),
}
#: Words with several meanings, none of which is taken, and what says each of them.
_TWO_MEANINGS = {
    "grad": "deg and gon",
    "Grad": "deg and gon",
    "gr": "g and grain",
    "ton": "t (1000 kg) and short_ton",
    "tons": "t (1000 kg) and short_ton",
    "mil": "mm and thou",
    "mils": "mm and thou",
}
_REMEDY = (
    "write m, g, s, N, Pa, J, W, Hz or rad, each with a prefix if need be, or t, in, ft, yd, "
    "mi, lb, "
    "lbf, slug, kgf, kip, psi, ksi, bar, deg, gon, arcmin, rev, rpm, min or h"
)


@cache
def _words() -> dict[str, str]:
    """Names of pint by the words that are read, whatever else pint takes them for."""
    known = {word: name for name, words in _ALONE.items() for word in words}
    for symbol, (name, *others) in _WITH_PREFIX.items():
        long = [form for one in (name, *others) for form in (one, f"{one}s")]
        known |= dict.fromkeys([symbol, *long], name)
        for prefix, whole in _PREFIXES.items():
            known.setdefault(prefix + symbol, whole + name)
            known |= {whole + form: whole + name for form in long}
    return known


#: What a unit may be written with; pint's own parser sees nothing else.
_LETTERS = re.compile(r"[\w°µμΩ%*/^·⋅²³⁻¹ ().\-]{1,60}")
_WORD = re.compile(r"(?:(?![²³¹])[^\W\d])+|[%°]")
_TORQUE = [("[length]", 2.0), ("[mass]", 1.0), ("[time]", -2.0)]


@cache
def registry() -> pint.UnitRegistry[Any]:
    """The units of pint."""
    from pint import UnitRegistry

    return UnitRegistry(cache_folder=None)


@lru_cache(maxsize=256)
def factor(unit: str, si: str) -> float:
    """Size of one ``unit`` in the SI unit ``si``; an error if it is unknown, or of another
    quantity.

    >>> import math
    >>> factor("N/mm", "N/m"), factor("deg", "rad") == math.pi / 180
    (1000.0, True)
    """
    if si == "1":
        if unit not in ("", "1", "%"):
            raise ParameterError(f"the unit {unit!r} is too much: this is a number without unit")
        return 0.01 if unit == "%" else 1.0
    wanted, given = registry().parse_units(si), parsed(unit)
    (*of_given, angle), (*of_wanted, wanted_angle) = dimension(given), dimension(wanted)
    # A torque is N m, and its stiffness N m or N m/rad: the radian is 1.
    if of_given != of_wanted or (angle != wanted_angle and of_wanted != _TORQUE):
        raise ParameterError(f"the unit {unit!r} ({given}) does not measure what {si} does")
    return float(registry().Quantity(1.0, given).to(wanted).magnitude)


def parsed(unit: str) -> pint.Unit:
    """A unit from its text: SI with prefixes and engineers' units, each word with one meaning."""
    # A power of a power may be larger than any number.
    powers = re.search(r"(\^|\*\*)[^*/·⋅]*(\^|\*\*)", unit)
    if (
        not _LETTERS.fullmatch(unit)
        or powers
        or any(len(digits) > 2 for digits in re.findall(r"\d+", unit))
    ):
        raise ParameterError(f"the unit {unit!r} can't be read")
    named = _WORD.sub(lambda found: _named(found[0], unit), unit)
    try:
        return registry().parse_units(named.replace("·", "*").replace("⋅", "*"))
    except Exception as error:  # pint raises many kinds, of the tokenizer too
        raise ParameterError(f"the unit {unit!r} is not known") from error


def _named(word: str, unit: str) -> str:
    """What pint calls a word of a unit; an error that says what else it may be."""
    if word in _TWO_MEANINGS:
        raise ParameterError(f"the unit {word!r} has two meanings, {_TWO_MEANINGS[word]}")
    if word in _words():
        return _words()[word]
    try:
        found = registry().Unit(word)
        bare = not any(power for _, power in dimension(found))
        zero = registry().Quantity(0.0, found).to_base_units().magnitude
    except Exception as error:  # as above
        raise ParameterError(f"the unit {unit!r} is not known; {_REMEDY}") from error
    if bare:
        raise ParameterError(
            f"{found} in the unit {unit!r} is a factor and no unit; multiply the number by it"
        )
    if zero != 0:
        raise ParameterError(f"the unit {unit!r} has a zero point of its own")
    raise ParameterError(
        f"{word!r} in the unit {unit!r} may be the {found}, or something else, and is not read; "
        f"{_REMEDY}"
    )


def dimension(unit: pint.Unit) -> tuple[Any, ...]:
    """Powers of length, mass and time, and of the radian, which pint counts as a number."""
    from pint.util import to_units_container

    powers: dict[str, Any] = dict(unit.dimensionality)
    radians: Any = to_units_container(registry().get_base_units(unit)[1]).get("radian", 0)
    return (
        *sorted((name, round(float(power), 9)) for name, power in powers.items()),
        ("angle", round(float(radians), 9)),
    )


# ---------------------------------------------------------------------- numbers that carry a unit

#: Libraries whose units are understood: where their objects have text of the unit, and numbers.
_UNDERSTOOD = {
    "pint": ("units", "magnitude"),
    "astropy": ("unit", "value"),
    "unyt": ("units", "value"),
    "quantities": ("dimensionality", "magnitude"),
}
#: Texts of no unit, and of percent.
_NO_UNIT = ("", "1", "dimensionless", "None", "()")
_PERCENT = ("percent", "%")
#: Parts of names of attributes by which an object of any other library is known to have a unit.
_HINTS = re.compile("unit|dimensionality", re.IGNORECASE)


class Carried:
    """Units that the elements of one argument carried; ``""`` where there was none."""

    def __init__(self, name: str, si: str) -> None:
        self.name, self.si = name, si
        self.units: set[str] = set()

    def numbers(self, value: Any) -> Any:
        """``value`` without units, converted to SI: numbers, an array, or lists of these."""
        kind = type(value)
        if kind in (float, int):
            self.units.add("")
            return value
        if kind in (list, tuple):
            return [self.numbers(one) for one in value]
        if isinstance(value, bool | np.bool_) or _is_boolean(value):
            raise ParameterTypeError(
                f"{self.name} = {value!r:.60} is of type bool; it must be real numbers, not "
                "booleans"
            )
        if kind in (str, bytes) or (isinstance(value, np.generic) and kind.__module__ == "numpy"):
            self.units.add("")
            return value
        if isinstance(value, np.ma.MaskedArray) or getattr(value, "mask", None) is not None:
            value = self._unmasked(value)
        if type(value) is np.ndarray:
            return self._elements(value)
        return self._of_library(value)

    def _elements(self, array: Any) -> Any:
        if array.dtype != object:
            if array.size:
                self.units.add("")
            return array
        return [self.numbers(one) for one in array] if array.ndim else self.numbers(array.item())

    def _unmasked(self, value: Any) -> Any:
        """A masked array as a plain one; an error if something is masked."""
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
            # Of another library it may have a unit.
            return value.data if type(value) is np.ma.MaskedArray else value.filled()
        return getattr(value, "unmasked", value)

    def _of_library(self, value: Any) -> Any:
        """Numbers of an object of some library, a container or one that carries a unit."""
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
        if root == "pandas" and hasattr(value, "array"):
            return self.numbers(value.array)
        attributes = getattr(value, "attrs", None)
        labelled: Any = attributes if hasattr(attributes, "keys") else {}
        for key in labelled:  # of xarray and HDF5
            if _HINTS.search(str(key)):
                held = value.data if root == "xarray" else np.asarray(value)
                return self._converted(str(labelled[key]), held)
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
            return value  # no number, which is told by whoever asks
        return self.numbers(array)

    def _converted(self, unit: str, numbers: object) -> Any:
        """Numbers of a unit in SI."""
        plain = "" if unit.strip() in _NO_UNIT else unit.strip()
        inner = Carried(self.name, self.si)
        given = np.asarray(inner.numbers(numbers))
        if inner.units - {""}:
            raise ParameterTypeError(f"{self.name} has a unit within a unit, {unit}")
        self.units.add(plain)
        if not plain or given.dtype.kind not in "iuf":
            return given
        try:
            return given.astype(float) * factor("%" if plain in _PERCENT else plain, self.si)
        except ParameterError as error:
            raise ParameterTypeError(
                f"{self.name} is in {plain}: {error}; give its number {self._wanted()}"
            ) from error

    def _wanted(self) -> str:
        return {"1": "without unit", "rad": "in radians"}.get(self.si, f"in {self.si}")


def _is_boolean(value: object) -> bool:
    return getattr(getattr(value, "dtype", None), "kind", "") == "b"


def _root(kind: type) -> str:
    """The library of a class: one that is understood if any of its bases is of it."""
    roots = [base.__module__.partition(".")[0] for base in kind.__mro__]
    return next((root for root in roots if root in _UNDERSTOOD), roots[0])


def _signs(value: object) -> Iterator[str]:
    """What shows that an object has a unit, in words."""
    for name in ("units", "unit"):
        text = getattr(value, name, None)
        if text is not None and not callable(text) and str(text) not in _NO_UNIT:
            yield f"in {text}"
    plain = any(name in ("units", "unit") for name in dir(value))
    for name in sorted(dir(value), key=lambda name: name.startswith("_")):
        if _HINTS.search(name) and not plain:
            yield f"with {name}"
