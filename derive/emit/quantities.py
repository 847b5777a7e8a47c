"""What a symbol of generated code stands for: its name in print, meaning, unit and allowed
values.
"""

import math
import re
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Interval:
    """Allowed values; an infinite end is open."""

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
    """One entry of a nomenclature; ``str(symbol)`` is the name in generated code.

    The number may be a multiple of some ``scale``, as a length over L_0 is.
    """

    symbol: Any  #: SymPy's, or only its name
    article: str
    meaning: str
    unit: str = "1"
    domain: str = "real"
    scale: str = ""

    @property
    def interval(self) -> Interval:
        """The domain as numbers."""
        return interval(self.domain)


def interval(domain: str) -> Interval:
    """Read ``real``, ``> 0``, ``>= 0``, ``(0, pi)``, ``(-pi/2, pi/2)``, ``[-1, 1]``; a set of
    values, ``{0, 1}``, has the interval that it spans.
    """
    if domain == "real":
        return Interval()
    if bound := re.fullmatch(r"(>=?) (\S+)", domain):
        return Interval(_number(bound[2]), low_open=bound[1] == ">")
    if ends := re.fullmatch(r"([(\[{])(\S+), (\S+)([)\]}])", domain):
        return Interval(_number(ends[2]), _number(ends[3]), ends[1] == "(", ends[4] == ")")
    raise ValueError(f"{domain!r} is not a domain; write it as real, > 0, >= 0, (0, pi) or [-1, 1]")


def written(allowed: Interval) -> str:
    """An interval as a domain is written."""
    low, high = ("pi" if end == math.pi else f"{end:g}" for end in (allowed.low, allowed.high))
    if math.isinf(allowed.high):
        return "real" if math.isinf(allowed.low) else f">{'' if allowed.low_open else '='} {low}"
    return f"{'(' if allowed.low_open else '['}{low}, {high}{')' if allowed.high_open else ']'}"


def _number(text: str) -> float:
    """A decimal, or a multiple of pi as ``pi``, ``-pi/2``."""
    if multiple := re.fullmatch(r"(-?)pi(?:/(\d+))?", text):
        return math.pi / int(multiple[2] or 1) * (-1 if multiple[1] else 1)
    return float(text)
