"""Units of measure: those that are read, what one is in SI, and numbers of objects that carry
one.
"""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, lru_cache
from typing import Any

import numpy as np

from ..core.errors import ParameterError, ParameterTypeError


@dataclass(frozen=True)
class Measure:
    """A unit of measure: its size in SI, and its powers of kilogram, metre, second and radian."""

    size: Fraction | float
    powers: tuple[Fraction, ...] = (Fraction(0),) * 4

    def times(self, other: Measure, power: Fraction | float = 1) -> Measure:
        """The product with a power of another unit."""
        of = Fraction(power)
        powers = (one + of * more for one, more in zip(self.powers, other.powers, strict=True))
        return Measure(self.size * other.size**of, tuple(powers))


# ------------------------------------------------------------------------------------- their words

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
#: Units that take them: symbol, size in SI, powers, and long names.
_WITH_PREFIX: dict[str, tuple[str, tuple[int, ...], tuple[str, ...]]] = {
    "m": ("1", (0, 1, 0, 0), ("meter", "metre")),
    "g": ("1e-3", (1, 0, 0, 0), ("gram",)),
    "s": ("1", (0, 0, 1, 0), ("second",)),
    "N": ("1", (1, 1, -2, 0), ("newton",)),
    "Pa": ("1", (1, -1, -2, 0), ("pascal",)),
    "J": ("1", (1, 2, -2, 0), ("joule",)),
    "W": ("1", (1, 2, -3, 0), ("watt",)),
    "Hz": ("1", (0, 0, -1, 0), ("hertz",)),
    "rad": ("1", (0, 0, 0, 1), ("radian",)),
}
#: Units without a prefix: name, size in another unit, and the words that mean it. The inch and the
#: pound are those of 1959, the standard gravity that of 1901.
_ALONE: dict[str, tuple[str | float, str, tuple[str, ...]]] = {
    "metric_ton": ("1000", "kg", ("t", "tonne", "metric_ton")),
    "pound": ("0.45359237", "kg", ("lb", "lbs", "pound", "pounds", "lbm", "pound_mass")),
    "short_ton": ("2000", "pound", ("short_ton",)),
    "grain": ("1/7000", "pound", ("grain", "grains")),
    "inch": ("0.0254", "m", ("in", "inch", "inches")),
    "foot": ("12", "inch", ("ft", "foot", "feet")),
    "yard": ("36", "inch", ("yd", "yard", "yards")),
    "thou": ("1e-3", "inch", ("thou",)),
    "mile": ("5280", "foot", ("mi", "mile", "miles")),
    "pound_force": ("9.80665", "pound m/s^2", ("lbf", "pound_force", "force_pound")),
    "kilogram_force": ("9.80665", "N", ("kgf", "kp", "kilogram_force", "force_kilogram")),
    "slug": ("1", "pound_force s^2/foot", ("slug", "slugs")),
    "kip": ("1000", "pound_force", ("kip",)),
    "psi": ("1", "pound_force/inch^2", ("psi", "pound_force_per_square_inch")),
    "ksi": ("1000", "psi", ("ksi", "kip_per_square_inch")),
    "bar": ("1e5", "Pa", ("bar",)),
    "millibar": ("100", "Pa", ("mbar", "millibar")),
    "degree": (math.pi / 180, "rad", ("deg", "degree", "degrees", "°")),
    "arcminute": (math.pi / 10800, "rad", ("arcmin", "arcminute", "arcminutes")),
    "gon": (math.pi / 200, "rad", ("gon", "grade")),
    "turn": (2 * math.pi, "rad", ("turn", "rev", "revolution")),
    "rpm": (math.pi / 30, "rad/s", ("rpm", "revolutions_per_minute")),
    "minute": ("60", "s", ("min", "minute", "minutes")),
    "hour": ("3600", "s", ("h", "hr", "hour", "hours")),
}
#: Words of no unit.
_FACTORS = {"%": "percent", "percent": "percent", "ppm": "ppm"}
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
    """Long names of units by the words that are read."""
    known = {word: name for name, (*_, words) in _ALONE.items() for word in words}
    for symbol, (*_, names) in _WITH_PREFIX.items():
        long = [form for one in names for form in (one, f"{one}s")]
        known |= dict.fromkeys([symbol, *long], names[0])
        for prefix, (whole, _) in _PREFIXES.items():
            known.setdefault(prefix + symbol, whole + names[0])
            known |= {whole + form: whole + names[0] for form in long}
    return known


@cache
def _named_units() -> dict[str, Measure]:
    """Units with a prefix, or with one that is left out, by their long names."""
    sizes = {"": "1"} | dict(_PREFIXES.values())
    return {
        prefix + names[0]: Measure(Fraction(size) * Fraction(own), tuple(map(Fraction, powers)))
        for own, powers, names in _WITH_PREFIX.values()
        for prefix, size in sizes.items()
    }


#: What a unit may be written with.
_LETTERS = re.compile(r"[\w°µμΩ%*/^·⋅²³⁻¹ ().\-]{1,60}")
_WORD = re.compile(r"(?:(?![²³¹])[^\W\d])+|[%°]")
_RAISED = str.maketrans("⁻¹²³", "-123")


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
    wanted, given = parsed(si), parsed(unit)
    # A torque is N m, and its stiffness N m or N m/rad: the radian is 1.
    counted = 3 if wanted.powers[:3] == parsed("N m").powers[:3] else 4
    if given.powers[:counted] != wanted.powers[:counted]:
        spelled = re.sub(r"\s*([*/])\s*", r" \1 ", _spelled(unit))
        raise ParameterError(f"the unit {unit!r} ({spelled}) does not measure what {si} does")
    return float(given.size / wanted.size)


@lru_cache(maxsize=256)
def parsed(unit: str) -> Measure:
    """A unit from its text: SI with prefixes and engineers' units, each word with one meaning."""
    # A power of a power may be larger than any number.
    powers = re.search(r"(\^|\*\*)[^*/·⋅]*(\^|\*\*)", unit)
    if (
        not _LETTERS.fullmatch(unit)
        or powers
        or any(len(digits) > 2 for digits in re.findall(r"\d+", unit))
    ):
        raise ParameterError(f"the unit {unit!r} can't be read")
    text = re.sub("[⁻¹²³]+", lambda found: f"^{found[0].translate(_RAISED)}", _spelled(unit))
    text = re.sub(r"(?<=[\w)])\s+(?=[\w(])", "*", re.sub("[·⋅]", "*", text)).replace("^", "**")
    try:
        found = _product(ast.parse(text, mode="eval").body)
        float(found.size)  # which may be larger than any number
    except (SyntaxError, ValueError, ArithmeticError) as error:
        raise ParameterError(f"the unit {unit!r} is not known") from error
    return found


def _product(tree: ast.expr) -> Measure:
    """The unit that is a product of others and of their powers."""
    match tree:
        case ast.Constant(1):
            return Measure(Fraction(1))
        case ast.Name(name) if name in _ALONE:
            size, of, _ = _ALONE[name]
            factor = size if isinstance(size, float) else Fraction(size)
            return Measure(factor).times(parsed(of))
        case ast.Name(name) if name in _named_units():
            return _named_units()[name]
        case ast.BinOp(base, ast.Pow(), power):
            return Measure(Fraction(1)).times(_product(base), _number(power))
        case ast.BinOp(one, ast.Mult() | ast.Div() as sign, other):
            return _product(one).times(_product(other), 1 if isinstance(sign, ast.Mult) else -1)
    raise ValueError("no product of units")


def _number(tree: ast.expr) -> Fraction:
    """The number of an exponent."""
    match tree:
        case ast.Constant(int() | float() as number):
            return Fraction(str(number))
        case ast.UnaryOp(ast.USub(), of):
            return -_number(of)
        case ast.BinOp(one, ast.Div(), other):
            return _number(one) / _number(other)
    raise ValueError("no number")


def _spelled(unit: str) -> str:
    """A unit with the long names of its words."""
    return _WORD.sub(lambda found: _named(found[0], unit), unit)


def _named(word: str, unit: str) -> str:
    """Long name of a word of a unit; an error that says what else it may be."""
    if word in _TWO_MEANINGS:
        raise ParameterError(f"the unit {word!r} has two meanings, {_TWO_MEANINGS[word]}")
    if word in _FACTORS:
        raise ParameterError(
            f"{_FACTORS[word]} in the unit {unit!r} is a factor and no unit; multiply the number "
            "by it"
        )
    if word not in _words():
        raise ParameterError(f"the unit {unit!r} is not known; {_REMEDY}")
    return _words()[word]


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
