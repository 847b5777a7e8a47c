"""Numbers with units: read from text, checked for their dimension, and given back in the unit in which they came."""

from __future__ import annotations

import functools
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ..errors import ParameterError

if TYPE_CHECKING:
    import pint

#: SI unit of every quantity of the article's model → how an engineer would write one, for messages.
EXAMPLES: Mapping[str, str] = {
    "kg": "0.35 kg", "N/m": "180 N/mm", "m": "38 mm", "rad": "52 deg", "N": "420 N", "m/s": "1.2 m/s", "s/m": "10 s/m",
    "1": "0.45",
}  # fmt: skip

#: The same for ranges.
RANGE_EXAMPLES: Mapping[str, str] = {
    "kg": "[0.3, 0.4] kg", "N/m": "[150, 210] N/mm", "m": "[37, 39] mm", "rad": "[51, 53] deg", "N": "[400, 440] N",
    "m/s": "[1, 1.4] m/s", "s/m": "[8, 12] s/m", "1": "[0.3, 0.6]",
}  # fmt: skip
_NUMBER = r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
_SIGN = r"(?:±|\+/-|\+-)"
_UNIT = r"(?:1\s*/\s*)?[^\d\s±\[\],+.][^±\[\],]*?"
_PLAIN = re.compile(
    rf"\s*(?P<value>{_NUMBER})\s*(?P<unit>{_UNIT})?\s*(?:{_SIGN}\s*(?P<off>{_NUMBER})\s*(?P<of>{_UNIT})?)?\s*", re.DOTALL
)
_RANGE = re.compile(
    rf"\s*\[\s*(?P<low>{_NUMBER})\s*(?P<first>{_UNIT})?\s*,\s*(?P<high>{_NUMBER})\s*(?P<second>{_UNIT})?\s*\]\s*(?P<unit>{_UNIT})?\s*"
)
#: (180 ± 15) N/mm
_BRACKETED = re.compile(
    rf"\s*\(\s*(?P<value>{_NUMBER})\s*(?P<sign>{_SIGN})\s*(?P<off>{_NUMBER})\s*\)\s*(?P<unit>{_UNIT})\s*", re.DOTALL
)
_PERCENT = {"percent": "%", "per cent": "%", "pct": "%"}
#: What a unit may be written with; pint's own parser sees nothing else.
_LETTERS = re.compile(r"[\w°µμΩ%*/^·⋅²³⁻¹ ().\-]{1,40}")


@dataclass(frozen=True)
class Measured:
    """A quantity with its tolerance: value and ends in SI, and the unit in which it was given."""

    value: float
    low: float
    high: float
    unit: str

    @property
    def tolerance(self) -> float:
        """Half of the width of its range."""
        return 0.5 * (self.high - self.low)


@functools.cache
def registry() -> pint.UnitRegistry[Any]:
    """The units of pint."""
    from pint import UnitRegistry

    return UnitRegistry(cache_folder=None)


@functools.lru_cache(maxsize=256)
def factor(unit: str, si: str) -> float:
    """What one ``unit`` is in the SI unit ``si``.

    Raises
    ------
    ParameterError
        For a unit that is not known, or is one of another quantity.

    Examples
    --------
    >>> factor("N/mm", "N/m"), factor("deg", "rad") == math.pi / 180
    (1000.0, True)
    """
    if si == "1":
        if unit not in ("", "1", "%"):
            raise ParameterError(f"the unit {unit!r} is too much: this is a number without unit")
        return 0.01 if unit == "%" else 1.0
    if unit in _TWO_MEANINGS:
        raise ParameterError(f"the unit {unit!r} {_TWO_MEANINGS[unit]}")
    wanted, given = registry().parse_units(si), parsed(unit)
    if dimension(given) != dimension(wanted):
        name = f" ({given})" if str(given) != unit else ""
        remark = f"measures {described(given)}, and this is {described(wanted)}{_weight(unit, wanted)}"
        raise ParameterError(f"the unit {unit!r}{name} {remark}")
    size: Any = registry().Quantity(1.0, given).to(wanted).magnitude
    return float(size)


#: Units that mean one thing here and another there.
_TWO_MEANINGS = {
    "grad": "may be the degree or the 400th part of a circle; write deg or gon",
    "Grad": "would be a thousand million radians; write deg",
}


def _weight(unit: str, wanted: pint.Unit) -> str:
    """The unit of weight where one of mass was given in its place."""
    meant = re.sub(r"(?<![A-Za-z])(lb|kg)(?![A-Za-z])", r"\1f", unit)
    found = _by_pint(meant)
    return f"; did you mean {meant}?" if meant != unit and found is not None and dimension(found) == dimension(wanted) else ""


def parsed(unit: str) -> pint.Unit:
    """A unit from its text."""
    if not _LETTERS.fullmatch(unit) or any(len(digits) > 2 for digits in re.findall(r"\d+", unit)):
        raise ParameterError(f"the unit {unit!r} can't be read")
    found = _by_pint(unit)
    if found is None:
        remark = next((f"; did you mean {other}?" for other in _alike(unit) if other != unit and _by_pint(other)), "")
        raise ParameterError(f"the unit {unit!r} is not known{remark}")
    if registry().Quantity(0.0, found).to_base_units().magnitude != 0:
        raise ParameterError(f"the unit {unit!r} has a zero point of its own")
    return found


def _alike(unit: str) -> tuple[str, ...]:
    """What may have been meant: kilo with a small letter, the newton as N, powers with their sign, and small letters."""
    kilo = re.sub(r"(?<![A-Za-z])K(?=[A-Za-z])", "k", unit)
    newton = re.sub(r"(?<![A-Za-z])(k?)n(?![A-Za-z])", r"\1N", kilo)
    return kilo, newton, re.sub(r"([A-Za-z])(-?\d)", r"\1^\2", newton), unit.lower()


def _by_pint(unit: str) -> pint.Unit | None:
    try:
        found = registry().parse_units(unit.replace("·", "*").replace("⋅", "*"))
        registry().get_base_units(found)
    except Exception:  # pint raises many kinds, of the tokenizer too
        return None
    return found


def dimension(unit: pint.Unit) -> tuple[Any, ...]:
    """Powers of length, mass and time, and of the radian, which pint counts as a number."""
    from pint.util import to_units_container

    powers: dict[str, Any] = dict(unit.dimensionality)
    radians: Any = to_units_container(registry().get_base_units(unit)[1]).get("radian", 0)
    return (*sorted((name, round(float(power), 9)) for name, power in powers.items()), ("angle", round(float(radians), 9)))


_KINDS = {
    "kg": "mass", "N/m": "stiffness", "m": "length", "rad": "angle", "N": "force", "m/s": "speed", "s/m": "time per length",
    "s": "time", "Hz": "frequency", "Pa": "pressure", "J": "energy or moment", "K": "temperature", "A": "current", "m**2": "area",
    "N*s/m": "damping", "kg/m**3": "density", "W": "power", "rad/s": "angular speed", "m/s**2": "acceleration", "m/m": "number"
}  # fmt: skip


@functools.cache
def _kinds() -> dict[tuple[Any, ...], str]:
    return {dimension(registry().parse_units(unit)): kind for unit, kind in _KINDS.items()}


def described(unit: pint.Unit) -> str:
    """What a unit measures, in words."""
    word = _kinds().get(dimension(unit))
    return f"a {word}" if word and word[0] not in "aeiou" else f"an {word}" if word else "another quantity"


def read(text: str, si: str) -> Measured:
    """A quantity from text such as ``"180 N/mm ± 15 %"``, ``"52 deg +- 1 deg"`` or ``"[150, 210] N/mm"``.

    Parameters
    ----------
    text : str
    si : str
        The SI unit of what is wanted.

    Raises
    ------
    ParameterError
        For text that is no quantity, a unit that is missing or of another quantity, or a tolerance that makes no sense.

    Examples
    --------
    >>> read("180 N/mm +- 15 %", "N/m")
    Measured(value=180000.0, low=153000.0, high=207000.0, unit='N/mm')
    """
    if len(text) > 200:
        raise ParameterError(f"{text[:20]!r}… is {len(text)} characters long, too long for a quantity; write {_example(si)}")
    plain = text.replace("\N{MINUS SIGN}", "-")
    if found := _RANGE.fullmatch(plain):
        return _ranged(found, text, si)
    both = _BRACKETED.fullmatch(plain)
    found = _PLAIN.fullmatch(both.expand(r"\g<value> \g<unit> \g<sign> \g<off> \g<unit>") if both else plain)
    if not found:
        raise ParameterError(f"{text!r} can't be read{_with_remedy(_why(text, si), si)}")
    number, unit = float(found["value"]), (found["unit"] or "").strip()
    off, of = found["off"], _PERCENT.get((found["of"] or "").strip(), (found["of"] or "").strip())
    if not unit and si != "1" and of and "%" not in of:
        unit = of  # 180 ± 15 N/mm
    scale = _scale(unit, si, text)
    value = _finite(number, scale, text)
    if off is None:
        return Measured(value, value, value, unit)
    size = float(off)
    if not math.isfinite(size) or size < 0 or off.startswith("-"):
        raise ParameterError(f"{text!r} has the tolerance {off}; write how far it may be off as a positive number")
    if of == "%" and si == "1" and unit != "%":
        width = abs(value) * size / 100
    elif of == "%":
        width = abs(value) * size / 100 if unit != "%" else size / 100
    elif not of and (si != "1" or unit == "%"):
        raise ParameterError(
            f"{text!r} has a tolerance without unit; write ± {off} %{'' if unit == '%' else f' or ± {off} {unit}'}"
        )
    else:
        width = _finite(size, _scale(of, si, text), text)
    return Measured(value, value - width, value + width, unit)


def _ranged(found: re.Match[str], text: str, si: str) -> Measured:
    units = {(found[name] or "").strip() for name in ("first", "second", "unit")} - {""}
    if len(units) > 1:
        raise ParameterError(f"{text!r} has the units {' and '.join(sorted(units))}; give one unit, behind the bracket")
    unit = units.pop() if units else ""
    scale = _scale(unit, si, text)
    low, high = (_finite(float(found[name]), scale, text) for name in ("low", "high"))
    if low > high:
        raise ParameterError(f"{text!r} begins above its end; write the smaller number first")
    # The middle of [0.3, 0.6] is to be 0.45, not a float next to it.
    middle = float(f"{0.5 * (float(found['low']) + float(found['high'])):.15g}")
    return Measured(_finite(middle, scale, text), low, high, unit)


def _scale(unit: str, si: str, text: str) -> float:
    if not unit and si != "1":
        raise ParameterError(f"{text!r} has no unit; write {_example(si)}")
    try:
        return factor(unit, si)
    except ParameterError as error:
        remark = _two_numbers(text, si) or _without_sign(text) or str(error)
        raise ParameterError(f"{text!r}: {_with_remedy(remark, si)}") from error


def _finite(number: float, scale: float, text: str) -> float:
    value = number * scale
    # 52 deg is the float nearest to it, which two roundings may miss.
    if scale == math.pi / 180:
        value = math.radians(number)
    if not math.isfinite(value):
        raise ParameterError(f"{text!r} is too large for a number; check its exponent and unit")
    return value


def _example(si: str) -> str:
    return f'for instance "{EXAMPLES.get(si, "1 " + si)}"'


def _with_remedy(remark: str, si: str) -> str:
    """A remark that does not say what to write, with an example."""
    return remark if "; write" in remark else f"{remark}; write {_example(si)}"


def _why(text: str, si: str) -> str:
    if not text.strip():
        return ": it is empty"
    if re.match(r"\s*[+-]?[\d.]*\d,\d", text):
        return ": a comma is no decimal point"
    if remark := _two_numbers(text, si) or _without_sign(text):
        return f": {remark}"
    if re.match(r"\s*[+-]?\d+\s+\d", text):
        return ": there is a blank inside of the number"
    if "[" in text or "]" in text:
        return f": {_range_remark(si)}"
    if re.match(rf"\s*\(\s*{_NUMBER}[^±]*,", text):
        return f": {_range_remark(si)}"
    if re.search(rf",\s*{_SIGN}", text):
        return ": leave out the comma before ±"
    if not re.match(rf"\s*{_NUMBER}", text):
        return ": it does not begin with a number"
    if re.search(_SIGN, text):
        return ": behind ± there is a number with a unit or %"
    return ""


def _without_sign(text: str) -> str:
    """What to say of a second number without ± before it."""
    found = re.fullmatch(rf"\s*(?P<first>{_NUMBER}\s*{_UNIT})\s+(?P<off>{_NUMBER}\s*(?:%|{_UNIT}))\s*", text)
    return f'± is missing before {found["off"]}; write "{found["first"]} ± {found["off"]}"' if found else ""


def _two_numbers(text: str, si: str) -> str:
    """What to say of two ends that are not in brackets."""
    if re.match(rf"\s*{_NUMBER}\s*(?:\.\.+|…|-|–|to)\s*\d", text):
        return _range_remark(si)
    if re.search(rf"\+\s*{_NUMBER}.*[^eE]-\s*{_NUMBER}", text):
        return f'tolerances that differ up and down are given by their two ends; write for instance "{_range_example(si)}"'
    return ""


def _range_remark(si: str) -> str:
    return f'a range is two numbers in brackets; write for instance "{_range_example(si)}"'


def _range_example(si: str) -> str:
    return RANGE_EXAMPLES.get(si, f"[1, 2] {si}")


def shown_in(value: float, unit: str, si: str, digits: int = 4) -> str:
    """A value in SI as text in another unit: ``"180 N/mm"``."""
    number = f"{value / factor(unit, si):.{digits}g}"
    return f"{number} {unit}".strip()
