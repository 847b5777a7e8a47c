"""What a symbol of generated code stands for: its name in print, meaning, unit and allowed values."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

import sympy as sp


@dataclass(frozen=True)
class Interval:
    """Allowed values; an infinite end is open."""

    low: float = -math.inf
    high: float = math.inf
    low_open: bool = True
    high_open: bool = True


@dataclass(frozen=True)
class Quantity:
    """One entry of a nomenclature; ``str(symbol)`` is the name in generated code.

    The number may be a multiple of some ``scale``, as a length over L_0 is: then ``meaning`` describes the number and ``measured``
    what is measured in that scale.
    """

    symbol: sp.Symbol
    article: str
    meaning: str
    unit: str = "1"
    domain: str = "real"
    measured: str = ""
    scale: str = ""

    @property
    def interval(self) -> Interval:
        """The domain as numbers."""
        return interval(self.domain)


def interval(domain: str) -> Interval:
    """Read ``real``, ``> 0``, ``>= 0``, ``(0, pi)``, ``(-pi/2, pi/2)``, ``[-1, 1]``; a set of values, ``{0, 1}``, has the interval that it spans."""
    if domain == "real":
        return Interval()
    if bound := re.fullmatch(r"(>=?) (\S+)", domain):
        return Interval(_number(bound[2]), low_open=bound[1] == ">")
    if ends := re.fullmatch(r"([(\[{])(\S+), (\S+)([)\]}])", domain):
        return Interval(_number(ends[2]), _number(ends[3]), ends[1] == "(", ends[4] == ")")
    raise ValueError(f"{domain!r} is not a domain; write it as real, > 0, >= 0, (0, pi) or [-1, 1]")


def _number(text: str) -> float:
    """A decimal, or a multiple of pi as ``pi``, ``-pi/2``."""
    if multiple := re.fullmatch(r"(-?)pi(?:/(\d+))?", text):
        return math.pi / int(multiple[2] or 1) * (-1 if multiple[1] else 1)
    return float(text)
