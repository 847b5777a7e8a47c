"""Quantities behind the symbols of generated code: name in print, meaning, unit and domain."""

import math
import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Interval:
    """The interval of allowed values; infinite ends are open."""

    low: float = -math.inf
    high: float = math.inf
    low_open: bool = True
    high_open: bool = True

    def holds(self, value: float) -> bool:
        """Whether a finite number is allowed."""
        above = value > self.low or (value == self.low and not self.low_open)
        below = value < self.high or (value == self.high and not self.high_open)
        return math.isfinite(value) and above and below


@dataclass(frozen=True)
class Quantity:
    """An entry of a nomenclature.

    The number may be a quantity over a ``scale``, as a length over L_0.
    """

    article: str
    meaning: str
    unit: str = "1"
    domain: str = "real"
    scale: str = ""

    @property
    def interval(self) -> Interval:
        """The domain as an interval."""
        return interval(self.domain)


def interval(domain: str) -> Interval:
    """Parse a domain, ``real``, ``> 0``, ``>= 0``, ``(0, pi)``, ``(-pi/2, pi/2)`` or ``[-1, 1]``; a
    set ``{0, 1}`` gives its hull.
    """
    if domain == "real":
        return Interval()
    if bound := re.fullmatch(r"(>=?) (\S+)", domain):
        return Interval(_number(bound[2]), low_open=bound[1] == ">")
    if ends := re.fullmatch(r"([(\[{])(\S+), (\S+)([)\]}])", domain):
        return Interval(_number(ends[2]), _number(ends[3]), ends[1] == "(", ends[4] == ")")
    raise ValueError(f"{domain!r} is not a domain; write it as real, > 0, >= 0, (0, pi) or [-1, 1]")


def written(allowed: Interval) -> str:
    """The text of an interval as a domain."""
    low, high = ("pi" if end == math.pi else f"{end:g}" for end in (allowed.low, allowed.high))
    if math.isinf(allowed.high):
        return "real" if math.isinf(allowed.low) else f">{'' if allowed.low_open else '='} {low}"
    return f"{'(' if allowed.low_open else '['}{low}, {high}{')' if allowed.high_open else ']'}"


def _number(text: str) -> float:
    """Parse a decimal or a multiple of pi, as ``-pi/2``."""
    if multiple := re.fullmatch(r"(-?)pi(?:/(\d+))?", text):
        return math.pi / int(multiple[2] or 1) * (-1 if multiple[1] else 1)
    return float(text)
