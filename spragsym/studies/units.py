"""Numbers with units: read from text, checked for their dimension and range, and given back in the unit in which they came."""

from __future__ import annotations

import functools
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ..errors import ParameterError
from ..parameters import FINITE, Range, shown

if TYPE_CHECKING:
    import pint

#: SI unit of a quantity → how an engineer would write one, alone and between two ends.
EXAMPLES: Mapping[str, tuple[str, str]] = {
    "kg": ("0.35 kg", "[0.3, 0.4] kg"), "N/m": ("180 N/mm ± 15 %", "[150, 210] N/mm"), "m": ("38 mm", "[37, 39] mm"),
    "rad": ("52 deg ± 1 deg", "[51, 53] deg"), "N": ("420 N", "[400, 440] N"), "m/s": ("1.2 m/s", "[1, 1.4] m/s"),
    "s/m": ("10 s/m", "[8, 12] s/m"), "1": ("0.45 ± 10 %", "[0.3, 0.6]"),
}  # fmt: skip
#: Standard deviations on either side of a normal distribution's mean that its ends are, and that lie within its range.
ENDS, WITHIN = 3.0, 6.0
_NUMBER = r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
_UNIT = r"(?:1\s*/\s*)?(?!sd\b)[^\d\s±\[\],+.-][^±\[\],]*?"
#: 180 N/mm ± 15 %, or with sd a standard deviation
_PLAIN = re.compile(
    rf"(?P<value>{_NUMBER})\s*(?P<unit>{_UNIT})?(?:\s*(?P<sign>±|\+/-|\+-|\bsd\b)\s*(?P<off>{_NUMBER})\s*(?P<of>{_UNIT})?)?"
)
#: (180 ± 15) N/mm
_BRACKETED = re.compile(
    rf"\(\s*(?P<value>{_NUMBER})\s*(?P<sign>±|\+/-|\+-|\bsd\b)\s*(?P<off>{_NUMBER})\s*\)\s*(?P<unit>{_UNIT})?"
)
_RANGE = re.compile(rf"\[\s*(?P<low>{_NUMBER})\s*,\s*(?P<high>{_NUMBER})\s*\]\s*(?P<unit>{_UNIT})?")
#: What a unit may be written with; pint's own parser sees nothing else.
_LETTERS = re.compile(r"[\w°µμΩ%*/^·⋅²³⁻¹ ().\-]{1,40}")
_PERCENT = {"percent": "%", "per cent": "%", "pct": "%"}
#: Units that mean one thing here and another there.
_TWO_MEANINGS = {"grad": "deg or gon", "Grad": "deg"}


@dataclass(frozen=True)
class Measured:
    """A quantity with its tolerance: value and ends in SI, and the unit in which it was given.

    Without ``sd`` every value between the ends is as probable. With it the distribution is normal with that standard deviation:
    cut off at the ends if ``cut``, and else three standard deviations are the ends, beyond which lie 0.27 % of it.
    """

    value: float
    low: float
    high: float
    unit: str
    sd: float = 0.0
    cut: bool = True

    @property
    def tolerance(self) -> float:
        """Half of the width of its range."""
        return 0.5 * (self.high - self.low)

    @property
    def alone(self) -> Measured:
        """The value without its tolerance."""
        return Measured(self.value, self.value, self.value, self.unit)

    def scaled(self, value: float, share: bool) -> Measured:
        """The same tolerance about another value, as a share of it, or as it is."""
        by = value / self.value if share and self.value else 1.0
        low, high = (value + by * (end - self.value) for end in (self.low, self.high))
        return Measured(value, low, high, self.unit, by * self.sd, self.cut)


class _RefusedError(Exception):
    """What is wrong with a text, and what may have been meant."""

    def __init__(self, what: str, *instead: str) -> None:
        super().__init__(what)
        self.what, self.instead = what, instead


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
        raise ParameterError(f"the unit {unit!r} has two meanings; write {_TWO_MEANINGS[unit]}")
    wanted, given = registry().parse_units(si), parsed(unit)
    if dimension(given) != dimension(wanted):
        name = f" ({given})" if str(given) != unit else ""
        raise ParameterError(f"the unit {unit!r}{name} measures {described(given)}, and this is {described(wanted)}")
    size: Any = registry().Quantity(1.0, given).to(wanted).magnitude
    return float(size)


def parsed(unit: str) -> pint.Unit:
    """A unit from its text."""
    if not _LETTERS.fullmatch(unit) or any(len(digits) > 2 for digits in re.findall(r"\d+", unit)):
        raise ParameterError(f"the unit {unit!r} can't be read")
    try:
        found = registry().parse_units(unit.replace("·", "*").replace("⋅", "*"))
        zero = registry().Quantity(0.0, found).to_base_units().magnitude
    except Exception as error:  # pint raises many kinds, of the tokenizer too
        raise ParameterError(f"the unit {unit!r} is not known") from error
    if zero != 0:
        raise ParameterError(f"the unit {unit!r} has a zero point of its own")
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


# ------------------------------------------------------------------------------------------------------------- from text


def read(text: str, si: str, allowed: Range = FINITE, example: str = "") -> Measured:
    """A quantity from text such as ``"180 N/mm ± 15 %"``, ``"[150, 210] N/mm"`` or ``"180 N/mm sd 5 %"``.

    Parameters
    ----------
    text : str
        Number and unit, and a tolerance if there is one: an amount, a share, two ends; or a standard deviation, with the ends at
        which the distribution is cut off if it is, as in ``"180 N/mm sd 5 % in [160, 200] N/mm"``.
    si : str
        The SI unit of what is wanted.
    allowed : Range
        Where value and ends must lie, in SI.
    example : str
        How this quantity may be written.

    Raises
    ------
    ParameterError
        For text that is no quantity, a unit that is missing or of another quantity, a tolerance that may be read in two ways, and
        numbers that are not allowed. What it says to write has been read by this function.

    Examples
    --------
    >>> read("180 N/mm +- 15 %", "N/m")
    Measured(value=180000.0, low=153000.0, high=207000.0, unit='N/mm', sd=0.0, cut=True)
    >>> round(read("0.45 sd 0.05", "1").high, 9)
    0.6
    """
    try:
        return _read(text, si, allowed)
    except _RefusedError as error:
        brief = repr(text) if len(text) <= 200 else f"{text[:20]!r}…"
        raise ParameterError(f"{brief} {error.what}; write {remedy(error.instead, si, allowed, example)}") from error


def remedy(instead: tuple[str, ...], si: str, allowed: Range = FINITE, example: str = "") -> str:
    """What to write: those of some texts that can be read and are allowed, else examples of which the same is true."""
    good = [f'"{text}"' for text in instead if _is_good(text, si, allowed)]
    if not good:
        examples = (example, *EXAMPLES.get(si, (f"1 {si}", f"[1, 2] {si}")))
        good = [f'"{text}"' for text in examples if text and _is_good(text, si, allowed)][:2]
        return f"for instance {' or '.join(good)}"
    return " or ".join(good)


def _is_good(text: str, si: str, allowed: Range) -> bool:
    try:
        _read(text, si, allowed)
    except _RefusedError:
        return False
    return True


def _read(text: str, si: str, allowed: Range) -> Measured:
    if len(text) > 200:
        raise _RefusedError(f"is {len(text)} characters long, too long for a quantity")
    plain = text.replace("\N{MINUS SIGN}", "-").strip()
    body, ends = plain, None
    if cut := re.fullmatch(r"(.*\bsd\b.*)\bin\s*(\[.*)", plain):
        body, ends = cut[1].strip(), _RANGE.fullmatch(cut[2])
        if ends is None:
            raise _RefusedError("has no two ends behind in", f"{body} in {EXAMPLES.get(si, ('', f'[1, 2] {si}'))[1]}")
    if found := _RANGE.fullmatch(plain):
        one = _between(found, si)
    elif found := _BRACKETED.fullmatch(body) or _PLAIN.fullmatch(body):
        one = _about(found, si, None if ends is None else _between(ends, si))
    else:
        raise _RefusedError("can't be read: a quantity is a number with a point, its unit, and its tolerance if it has one")
    return _allowed(one, si, allowed)


def _between(found: re.Match[str], si: str) -> Measured:
    unit = (found["unit"] or "").strip()
    unit = _PERCENT.get(unit, unit)
    low, high = (_in_si(found[name], unit, si) for name in ("low", "high"))
    if low > high:
        raise _RefusedError("begins above its end", f"[{found['high']}, {found['low']}] {unit}".strip())
    # The middle of [0.3, 0.6] is to be 0.45, not a float next to it.
    middle = _in_si(f"{0.5 * (float(found['low']) + float(found['high'])):.15g}", unit, si)
    return Measured(middle, low, high, unit)


def _about(found: re.Match[str], si: str, ends: Measured | None) -> Measured:
    parts = {name: (part or "").strip() for name, part in found.groupdict().items()}
    number, unit, off = parts["value"], parts["unit"], parts["off"]
    unit, of = (_PERCENT.get(name, name) for name in (unit, parts.get("of", unit)))
    if not unit and si != "1" and of not in ("", "%"):
        unit = of  # 180 ± 15 N/mm
    value = _in_si(number, unit, si)
    if not off:
        return Measured(value, value, value, unit)
    width = _width(found, number, unit, off, of, si)
    if parts["sign"] != "sd":
        return Measured(value, value - width, value + width, unit)
    if ends is not None:
        if not ends.low < value < ends.high or width == 0:
            raise _RefusedError("is cut off at ends that its mean does not lie between, or has no width")
        return Measured(value, ends.low, ends.high, unit, width, True)
    return Measured(value, value - ENDS * width, value + ENDS * width, unit, width, width == 0)


def _width(found: re.Match[str], number: str, unit: str, off: str, of: str, si: str) -> float:
    """How far a value may be off, in SI."""
    sign, amount = found["sign"], off.lstrip("+-")
    if off.startswith("-") or not math.isfinite(float(off)):
        raise _RefusedError(f"has the tolerance {off}", f"{number} {unit} {sign} {amount} {of}".replace("  ", " "))
    value, size = float(number), float(amount)
    shares = (f"{number} {unit} {sign} {amount} %".replace("  ", " "),)
    bracketed = "of" not in found.groupdict()
    if of == "%" and unit == "%" and not bracketed:
        by = abs(value) * size / 100
        raise _RefusedError(
            f"may be off by {shown(size)} points or by {shown(size)} percent of its value",
            *(_ends(value, width, "%", sign) for width in (size, by)),
        )
    if of == "%" and unit != "%":
        if value == 0 and size:
            raise _RefusedError(f"has a tolerance of {shown(size)} percent of 0, which is 0", _range(0.0, 1.0, unit))
        return abs(_in_si(number, unit, si)) * size / 100
    if not of and (si != "1" or unit == "%"):
        raise _RefusedError("has a tolerance without unit", *shares, _ends(value, size, unit, sign))
    return _in_si(amount, of, si)


def _allowed(one: Measured, si: str, allowed: Range) -> Measured:
    """The same, if value and ends lie in a range, and nearly all of a normal distribution that is not cut off."""
    reach = (one.value - WITHIN * one.sd, one.value + WITHIN * one.sd) if not one.cut else (one.low, one.high)
    for end in (one.value, *reach):
        if allowed.contains(end):
            continue
        low, high = (f"{_shown(limit, one.unit, si)}" for limit in (allowed.low, allowed.high))
        limits = "above" if allowed.open_low else "at least"
        words = f"{limits} {low}" if math.isinf(allowed.high) else f"between {low} and {high}, without these two"
        what = f"is not {words}" if end == one.value else f"reaches {_shown(end, one.unit, si)}, which is not {words}"
        ends = [_inside(given, one.value, allowed) for given in reach]
        inside = _range(_number(ends[0], one.unit, si), _number(ends[1], one.unit, si), one.unit)
        middle = f"{shown(_number(one.value, one.unit, si))} {one.unit}".strip()
        sd = f"{middle} sd {shown(_number(one.sd, one.unit, si))} {one.unit} in {inside}"
        why = f": {allowed.remedy}" if allowed.remedy and (end == allowed.low or end == one.value) and si != "rad" else ""
        raise _RefusedError(what + why, *([] if end == one.value else [sd.strip()] if one.sd else [inside]))
    return one


def _inside(end: float, value: float, allowed: Range) -> float:
    """An end that is allowed: the one that is given, a closed limit, or half way to an open one."""
    if allowed.contains(end):
        return end
    limit = allowed.low if end < value else allowed.high
    return limit if allowed.contains(limit) else 0.5 * (value + limit)


def _ends(value: float, width: float, unit: str, sign: str) -> str:
    """A tolerance as an amount that can't be misread."""
    return f"({shown(value)} {sign} {shown(round(width, 12))}) {unit}".strip()


def _range(low: float, high: float, unit: str) -> str:
    return f"[{shown(low)}, {shown(high)}] {unit}".strip()


def _number(value: float, unit: str, si: str) -> float:
    return round(value / factor(unit, si), 9)


def _shown(value: float, unit: str, si: str) -> str:
    return f"{float(f'{_number(value, unit, si):.12g}'):g} {unit}".strip()


def _in_si(number: str, unit: str, si: str) -> float:
    if not unit and si != "1":
        raise _RefusedError("has no unit")
    try:
        scale = factor(unit, si)
    except ParameterError as error:
        raise _RefusedError(f"can't be read: {error}".replace("; write", ", so say")) from error
    # 52 deg is the float nearest to it, which two roundings may miss.
    value = math.radians(float(number)) if scale == math.pi / 180 else float(number) * scale
    if not math.isfinite(value):
        raise _RefusedError("is too large for a number")
    return value


def shown_in(value: float, unit: str, si: str, digits: int = 4) -> str:
    """A value in SI as text in another unit: ``"180 N/mm"``."""
    number = f"{value / factor(unit, si):.{digits}g}"
    return f"{number} {unit}".strip()
