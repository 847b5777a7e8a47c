"""Quantities with units and tolerances: read from text, with checks of dimension and range, and
written in the unit in which they were given.
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
#: Examples for each SI unit: with a tolerance if usual, and as an interval.
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
#: Ends of a normal distribution that is not cut off, in standard deviations from the mean.
SIGMAS_AT_ENDS = 3.0
#: Ends of its numerical range, in standard deviations from the mean.
SIGMAS_IN_ALL = 6.0


@dataclass(frozen=True)
class Measured:
    """A quantity with its tolerance: value and ends in SI, and the unit in which it was given.

    Without ``sd`` the distribution is uniform between the ends. Otherwise it is normal with this
    standard deviation: cut off at the ends if ``cut``; if not, the ends are at three standard
    deviations, with a probability of 0.27 % beyond.
    """

    value: float
    low: float
    high: float
    unit: str
    sd: float = 0.0
    cut: bool = True

    @property
    def varies(self) -> bool:
        """True if the quantity has a tolerance."""
        return self.high > self.low

    @property
    def whole(self) -> Measured:
        """The quantity with the ends of its whole distribution: for a normal one that is not cut
        off at six standard deviations, with a probability of 2e-9 beyond.
        """
        low, high = (self.value + sign * SIGMAS_IN_ALL * self.sd for sign in (-1, 1))
        return self if self.cut else replace(self, low=low, high=high)

    def cdf(self, value: ArrayLike) -> FloatArray:
        """Cumulative distribution function, for the distribution restricted to its ends."""
        if not self.varies:
            return (np.asarray(value) >= self.value).astype(float)
        least, most, here = (self._below(end) for end in (self.low, self.high, np.asarray(value)))
        share: FloatArray = np.clip((here - least) / (most - least), 0.0, 1.0)
        return share

    def ppf(self, share: object) -> FloatArray:
        """Quantile function, the inverse of :meth:`cdf`."""
        from scipy.special import ndtri  # a slow import, which input errors do not need

        least, most = self._below(self.low), self._below(self.high)
        value = least + np.asarray(share) * (most - least)
        return np.clip(
            self.value + self.sd * ndtri(value) if self.sd else value, self.low, self.high
        )

    def _below(self, value: FloatArray | float) -> FloatArray | float:
        """Cumulative distribution of the unrestricted normal distribution, or for a uniform one the
        value itself.
        """
        from scipy.special import ndtr  # a slow import, which input errors do not need

        return ndtr((value - self.value) / self.sd) if self.sd else value

    def scaled(self, value: float, share: bool) -> Measured:
        """Another value with this tolerance: relative to the value if ``share``, else absolute."""
        by = value / self.value if share and self.value else 1.0
        low, high = (value + by * (end - self.value) for end in (self.low, self.high))
        return Measured(value, low, high, self.unit, by * self.sd, self.cut)


def read(text: str, si: str, allowed: Range = FINITE, example: str = "") -> Measured:
    """Read a quantity from text such as ``"180 N/mm ± 15 %"``, ``"[150, 210] N/mm"`` or
    ``"180 N/mm sd 5 %"``.

    The text has a number and a unit, and optionally a tolerance: absolute, relative, as an
    interval, or as a standard deviation, with an interval if the distribution is cut off, as in
    ``"180 N/mm sd 5 % in [160, 200] N/mm"``. Other texts, and ambiguous tolerances, raise a
    ParameterError with examples; values outside ``allowed`` raise one with the allowed range.

    >>> read("180 N/mm +- 15 %", "N/m")
    Measured(value=180000.0, low=153000.0, high=207000.0, unit='N/mm', sd=0.0, cut=True)
    >>> round(read("0.45 sd 0.05", "1").high, 9)
    0.6
    """
    with _with_remedy(text, si, allowed, example):
        return _read(text, si, allowed)


def read_exact(text: str, si: str, allowed: Range = FINITE, example: str = "") -> float:
    """Read a quantity that takes no tolerance, in SI; errors are those of :func:`read`.

    >>> read_exact("38 mm", "m")
    0.038
    """
    alone = re.split(r"±|\+/?-|\bsd\b", text)[0].strip()
    with _with_remedy(text, si, allowed, example, exact=True):
        try:
            one = _measured(alone, si)
        except ParameterError:  # the unit may come after a tolerance
            one = _measured(text, si)
        if one.varies or alone != text.strip():
            value = shown_in(one.value, one.unit, si)
            raise _OutsideError(f'it takes no tolerance here; write "{value}"')
        _require_inside(one, si, allowed)
    return one.value


@contextmanager
def _with_remedy(
    text: str, si: str, allowed: Range, example: str, exact: bool = False
) -> Iterator[None]:
    """Context that adds the text to a ParameterError, and examples unless the value is out of
    range.
    """
    try:
        yield
    except ParameterError as error:
        brief = repr(text) if len(text) <= 200 else f"{text[:20]!r}…"
        write = "" if isinstance(error, _OutsideError) else remedy(si, allowed, example, exact)
        raise ParameterError(f"{brief}: {error}{'; write ' * bool(write)}{write}") from error


class _OutsideError(ParameterError):
    """Raised for a valid text with a value that is not allowed; examples would not help."""


def check_words(text: str, si: str, allowed: Range = FINITE, example: str = "") -> None:
    """Raise those errors of :func:`read` that do not depend on the sizes of units, without the slow
    import of pint.
    """
    with _with_remedy(text, si, allowed, example):
        _matched(text, si)


def remedy(si: str, allowed: Range, example: str, exact: bool = False) -> str:
    """What to write instead: examples that are valid and allowed, ``exact`` ones without a
    tolerance.
    """
    by_sign = {allowed.low, allowed.high} <= {0.0, math.inf, -math.inf}
    good = []
    texts = [example, *EXAMPLES.get(si, (f"1 {si}", f"[1, 2] {si}"))]
    if exact:
        texts = [text.partition(" ±")[0] for text in texts if not text.startswith("[")]
    for text in texts:
        with suppress(ParameterError):
            # If the sign decides, the size of the unit is not needed.
            if not by_sign:
                _read(text, si, allowed)
            elif not allowed.contains(float(_matched(text, si)[0][1])):
                continue
            good.append(f'"{text}"')
    return " or ".join(good[:2]) if good else f"a number in {allowed} of the unit {si}"


def _matched(text: str, si: str) -> tuple[re.Match[str], re.Match[str] | None]:
    """Match of the text of a quantity, with checked names of units, and match of the interval at
    which its distribution is cut off, if there is one.
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
    one = _measured(text, si)
    _require_inside(one, si, allowed)
    return one


def _measured(text: str, si: str) -> Measured:
    """A quantity of any value."""
    found, ends = _matched(text, si)
    if "low" in found.re.groupindex:
        return _between(found, si)
    return _about(found, si, None if ends is None else _between(ends, si))


def _require_inside(one: Measured, si: str, allowed: Range) -> None:
    """Raise unless a value and its tolerance are allowed."""
    for end in (one.value, one.whole.low, one.whole.high):
        if not allowed.contains(end):
            here = shown_in(end, one.unit, si, 6)
            there = f"the tolerance reaches {here}, out of range; all of it"
            if end == one.value:
                there = f"{here} is out of range; it"
            raise _OutsideError(f"{there} must be {_ends(allowed, one.unit, si)}")


def _ends(allowed: Range, unit: str, si: str) -> str:
    """An allowed range as text."""
    low, high = (shown_in(limit, unit, si, 6) for limit in (allowed.low, allowed.high))
    words = f"{'above' if allowed.open_low else 'at least'} {low}"
    if not math.isinf(allowed.high):
        words += f" and {'at most' if allowed.closed_high else 'below'} {high}"
    # The remedy for angles is in radians.
    return f"{words}: {allowed.remedy}" if allowed.remedy and si != "rad" else words


def _between(found: re.Match[str], si: str) -> Measured:
    """A quantity given as an interval."""
    unit, _ = _units(found)
    low, high = (_in_si(found[name], unit, si) for name in ("low", "high"))
    if low > high:
        raise ParameterError("the range begins above its end")
    # Computed before the conversion, so that the midpoint of [0.3, 0.6] is the float 0.45.
    middle = _in_si(f"{0.5 * (float(found['low']) + float(found['high'])):.15g}", unit, si)
    return Measured(middle, low, high, unit)


def _about(found: re.Match[str], si: str, ends: Measured | None) -> Measured:
    """A quantity given as a value, alone or with a tolerance or a standard deviation."""
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
    """A number in a unit, converted to SI."""
    scale = factor(unit, si)
    # math.radians rounds once.
    value = math.radians(float(number)) if scale == math.pi / 180 else float(number) * scale
    if not math.isfinite(value):
        raise ParameterError("this is too large for a number")
    return value


def plain_unit(si: str) -> str:
    """Unit in which a report shows quantities that were given as plain numbers in SI."""
    units = {
        "N/m": "N/mm",
        "N/m^3": "N/mm^3",
        "m": "mm",
        "rad": "deg",
        "1": "",
    }
    return units.get(si, si)


def shown_in(value: float, unit: str, si: str, digits: int = 4) -> str:
    """A value in SI as text in another unit, as ``"180 N/mm"``."""
    number = f"{value / factor(unit, si):.{digits}g}"
    return f"{number}{'' if unit == '°' else ' '}{unit}".strip()


def hertz(frequency: float, digits: int = 4) -> str:
    """A frequency as text, in Hz below 1000 Hz, else in kHz."""
    kilo = frequency >= 1000.0
    return f"{frequency / 1e3:.{digits}g} kHz" if kilo else f"{frequency:.{digits}g} Hz"
