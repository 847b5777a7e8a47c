"""Numbers with units: read from text, checked for their dimension and range, and given back in the
unit in which they came.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from ..core.errors import ParameterError
from ..models.parameters import FINITE, Range
from ..models.quantities import factor
from ..models.units import spelled
from ..numerics.interval_arrays import FloatArray

#: Numbers by name: quantities in SI, or coordinates.
Numbers: TypeAlias = Mapping[str, float]
#: SI unit of a quantity → how an engineer would write one, alone and between two ends.
EXAMPLES: Mapping[str, tuple[str, str]] = {
    "kg": ("0.35 kg", "[0.3, 0.4] kg"),
    "N/m": ("180 N/mm ± 15 %", "[150, 210] N/mm"),
    "m": ("38 mm", "[37, 39] mm"),
    "rad": ("52 deg ± 1 deg", "[51, 53] deg"),
    "N": ("420 N ± 10 %", "[400, 440] N"),
    "m/s": ("1.2 m/s", "[1, 1.4] m/s"),
    "s/m": ("10 s/m", "[8, 12] s/m"),
    "m/s^2": ("9.81 m/s^2", "[9, 10] m/s^2"),
    "N s/m": ("7 N s/m", "[5, 9] N s/m"),
    "N m s": ("0.01 N m s", "[0.005, 0.02] N m s"),
    "1": ("0.45 ± 10 %", "[0.3, 0.6]"),
}
#: Standard deviations on either side of a normal distribution's mean that its ends are.
SIGMAS_AT_ENDS = 3.0
#: Standard deviations that lie within its range.
SIGMAS_IN_ALL = 6.0


@dataclass(frozen=True)
class Measured:
    """A quantity with its tolerance: value and ends in SI, and the unit in which it was given.

    Without ``sd`` every value between the ends is as probable. With it the distribution is normal
    with that standard deviation: cut off at the ends if ``cut``, and else three standard deviations
    are the ends, beyond which lie 0.27 % of it.
    """

    value: float
    low: float
    high: float
    unit: str
    sd: float = 0.0
    cut: bool = True

    @property
    def varies(self) -> bool:
        """Whether it has a tolerance."""
        return self.high > self.low

    @property
    def whole(self) -> Measured:
        """Distribution of the quantity; a normal one that is not cut off is taken to six standard
        deviations, beyond which lie 2e-9 of it.
        """
        low, high = (self.value + sign * SIGMAS_IN_ALL * self.sd for sign in (-1, 1))
        return self if self.cut else replace(self, low=low, high=high)

    def cdf(self, value: ArrayLike) -> FloatArray:
        """The share of its distribution within its ends up to a value."""
        if not self.varies:
            return (np.asarray(value) >= self.value).astype(float)
        least, most, here = (self._below(end) for end in (self.low, self.high, np.asarray(value)))
        share: FloatArray = np.clip((here - least) / (most - least), 0.0, 1.0)
        return share

    def ppf(self, share: object) -> FloatArray:
        """The value below which a share of its distribution within its ends lies."""
        from scipy.special import ndtri  # heavy, and a refusal does not need it

        least, most = self._below(self.low), self._below(self.high)
        value = least + np.asarray(share) * (most - least)
        return np.clip(
            self.value + self.sd * ndtri(value) if self.sd else value, self.low, self.high
        )

    def _below(self, value: FloatArray | float) -> FloatArray | float:
        from scipy.special import ndtr  # heavy, and a refusal does not need it

        return ndtr((value - self.value) / self.sd) if self.sd else value

    def scaled(self, value: float, share: bool) -> Measured:
        """The tolerance about another value, as a share of it, or as it is."""
        by = value / self.value if share and self.value else 1.0
        low, high = (value + by * (end - self.value) for end in (self.low, self.high))
        return Measured(value, low, high, self.unit, by * self.sd, self.cut)


def read(text: str, si: str, allowed: Range = FINITE, example: str = "") -> Measured:
    """A quantity from text such as ``"180 N/mm ± 15 %"``, ``"[150, 210] N/mm"`` or
    ``"180 N/mm sd 5 %"``.

    It has a number and a unit, and a tolerance if there is one: an amount, a share, two ends; or a
    standard deviation, with the ends at which the distribution is cut off if it is, as in
    ``"180 N/mm sd 5 % in [160, 200] N/mm"``. Anything else, a tolerance that may be read in two
    ways is a ParameterError with examples of what can be read; what is not ``allowed`` is one with
    what is.

    >>> read("180 N/mm +- 15 %", "N/m")
    Measured(value=180000.0, low=153000.0, high=207000.0, unit='N/mm', sd=0.0, cut=True)
    >>> round(read("0.45 sd 0.05", "1").high, 9)
    0.6
    """
    with _with_remedy(text, si, allowed, example):
        return _read(text, si, allowed)


@contextmanager
def _with_remedy(text: str, si: str, allowed: Range, example: str) -> Iterator[None]:
    """A mistake is told with the text and, where that is the remedy, how to write one."""
    try:
        yield
    except ParameterError as error:
        brief = repr(text) if len(text) <= 200 else f"{text[:20]!r}…"
        write = "" if isinstance(error, _OutsideError) else remedy(si, allowed, example)
        raise ParameterError(f"{brief}: {error}{'; write ' * bool(write)}{write}") from error


class _OutsideError(ParameterError):
    """A number that is read and not allowed: how to write one is no remedy."""


def check_words(text: str, si: str, allowed: Range = FINITE, example: str = "") -> None:
    """Refuse what :func:`read` refuses whatever the size of its units, without pint, which takes
    longer than all else that a mistake costs.
    """
    with _with_remedy(text, si, allowed, example):
        _matched(text, si)


def remedy(si: str, allowed: Range, example: str) -> str:
    """Text to write: examples that are read and allowed."""
    by_sign = {allowed.low, allowed.high} <= {0.0, math.inf, -math.inf}
    good = []
    for text in (example, *EXAMPLES.get(si, (f"1 {si}", f"[1, 2] {si}"))):
        with suppress(ParameterError):
            # What its sign decides does not wait for the size of its unit.
            if not by_sign:
                _read(text, si, allowed)
            elif not allowed.contains(float(_matched(text, si)[0][1])):
                continue
            good.append(f'"{text}"')
    return " or ".join(good[:2]) if good else f"a number in {allowed} of the unit {si}"


def _matched(text: str, si: str) -> tuple[re.Match[str], re.Match[str] | None]:
    """Parts of the text of a quantity, whose units are words that are known, and of the ends at
    which it is cut off.
    """
    if len(text) > 200:
        raise ParameterError(f"{len(text)} characters are too many for a quantity")
    plain = text.replace("\N{MINUS SIGN}", "-").strip()
    cut = re.fullmatch(r"(.*\bsd\b.*)\bin\s*(\[.*)", plain)
    positive = r"(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
    number = rf"[+-]?{positive}"
    name = r"(?:1\s*/\s*)?(?!sd\b)[^\d\s±\[\],+.-][^±\[\],]*?"
    # [150, 210] N/mm
    between = re.compile(
        rf"\[\s*(?P<low>{number})\s*,\s*(?P<high>{number})\s*\]\s*(?P<unit>{name})?"
    )
    body, ends = (cut[1].strip(), between.fullmatch(cut[2])) if cut else (plain, None)
    sign = r"(?P<sign>±|\+/-|\+-|\bsd\b)"
    # (180 ± 15) N/mm
    bracketed = re.compile(
        rf"\(\s*(?P<value>{number})\s*{sign}\s*(?P<off>{positive})\s*\)\s*(?P<unit>{name})?"
    )
    # 180 N/mm ± 15 %, or with sd a standard deviation
    bare = re.compile(
        rf"(?P<value>{number})\s*(?P<unit>{name})?"
        rf"(?:\s*{sign}\s*(?P<off>{positive})\s*(?P<of>{name})?)?"
    )
    found = between.fullmatch(plain) or bracketed.fullmatch(body) or bare.fullmatch(body)
    if found is None or bool(cut) != bool(ends):
        raise ParameterError("not a number with a point and its unit, alone or with a tolerance")
    for part in (found, ends):
        if part is None or si == "1":
            continue
        unit, of = _units(part)
        if not unit and of in ("", "%"):
            raise ParameterError("there is no unit")
        for word in {unit, of.removeprefix("%")} - {""}:
            spelled(word)
    return found, ends


def _units(found: re.Match[str]) -> tuple[str, str]:
    """Unit of a number and that of its tolerance, as written; the same where there is one."""
    words = [(found[name] or "").strip() for name in found.re.groupindex if name in ("unit", "of")]
    percent = {"percent": "%", "per cent": "%", "pct": "%"}
    return percent.get(words[0], words[0]), percent.get(words[-1], words[-1])


def _read(text: str, si: str, allowed: Range) -> Measured:
    found, ends = _matched(text, si)
    if "low" in found.re.groupindex:
        one = _between(found, si)
    else:
        one = _about(found, si, None if ends is None else _between(ends, si))
    for end in (one.value, one.whole.low, one.whole.high):
        if not allowed.contains(end):
            here = shown_in(end, one.unit, si, 6)
            there = f"the tolerance reaches {here}, out of range; all of it"
            if end == one.value:
                there = f"{here} is out of range; it"
            raise _OutsideError(f"{there} must be {_ends(allowed, one.unit, si)}")
    return one


def _ends(allowed: Range, unit: str, si: str) -> str:
    low, high = (shown_in(limit, unit, si, 6) for limit in (allowed.low, allowed.high))
    words = f"{'above' if allowed.open_low else 'at least'} {low}"
    if not math.isinf(allowed.high):
        words += f" and {'at most' if allowed.closed_high else 'below'} {high}"
    # Of angles it says radians.
    return f"{words}: {allowed.remedy}" if allowed.remedy and si != "rad" else words


def _between(found: re.Match[str], si: str) -> Measured:
    unit, _ = _units(found)
    low, high = (_in_si(found[name], unit, si) for name in ("low", "high"))
    if low > high:
        raise ParameterError("the range begins above its end")
    # The middle of [0.3, 0.6] is to be 0.45, not a float next to it.
    middle = _in_si(f"{0.5 * (float(found['low']) + float(found['high'])):.15g}", unit, si)
    return Measured(middle, low, high, unit)


def _about(found: re.Match[str], si: str, ends: Measured | None) -> Measured:
    parts = {name: (part or "").strip() for name, part in found.groupdict().items()}
    off, (unit, of) = parts["off"], _units(found)
    if not unit and si != "1" and of not in ("", "%"):
        unit = of  # 180 ± 15 N/mm
    value = _in_si(parts["value"], unit, si)
    if not off:
        return Measured(value, value, value, unit)
    if of == "%" and unit != "%":
        if value == 0:
            raise ParameterError(f"the tolerance is {off} % of 0, which is 0")
        width = abs(value) * float(off) / 100
    elif of == "%" and "of" in parts:
        raise ParameterError(
            "the tolerance may be points or a share of the value: put it in brackets, "
            f"({parts['value']} ± {off}) %, for points"
        )
    elif not of and (si != "1" or unit == "%"):
        raise ParameterError("the tolerance has no unit")
    else:
        width = _in_si(off, of, si)
    if parts["sign"] != "sd":
        return Measured(value, value - width, value + width, unit)
    if ends is not None:
        if not ends.low < value < ends.high or not 0 < width < math.inf:
            raise ParameterError(
                "the mean does not lie between the ends at which it is cut off, or sd is not "
                "above 0 and finite"
            )
        return Measured(value, ends.low, ends.high, unit, width)
    return Measured(
        value,
        value - SIGMAS_AT_ENDS * width,
        value + SIGMAS_AT_ENDS * width,
        unit,
        width,
        width == 0,
    )


def _in_si(number: str, unit: str, si: str) -> float:
    scale = factor(unit, si)
    # 52 deg is the float nearest to it, which two roundings may miss.
    value = math.radians(float(number)) if scale == math.pi / 180 else float(number) * scale
    if not math.isfinite(value):
        raise ParameterError("this is too large for a number")
    return value


def plain_unit(si: str) -> str:
    """The unit of the report where the data came as plain numbers in SI."""
    units = {
        "N/m": "N/mm",
        "N/m^3": "N/mm^3",
        "m": "mm",
        "rad": "deg",
        "1": "",
    }
    return units.get(si, si)


def shown_in(value: float, unit: str, si: str, digits: int = 4) -> str:
    """A value in SI as text in another unit: ``"180 N/mm"``."""
    number = f"{value / factor(unit, si):.{digits}g}"
    return f"{number}{'' if unit == '°' else ' '}{unit}".strip()


def hertz(frequency: float, digits: int = 4) -> str:
    """A frequency as text: in hertz, from a thousand on in kilohertz."""
    kilo = frequency >= 1000.0
    return f"{frequency / 1e3:.{digits}g} kHz" if kilo else f"{frequency:.{digits}g} Hz"
