"""Real roots on the whole line, or on its positive half: those up to about 1 in size, and larger ones as reciprocals."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from . import balls
from .balls import Interval
from .descartes import real_roots
from .polynomials import Polynomial, has_root


@dataclass(frozen=True)
class Root:
    """A real root of a polynomial in (low, high], or of the reversed polynomial: then it is the reciprocal."""

    low: Fraction
    high: Fraction
    backward: bool

    def interval(self) -> Interval:
        """Around the root."""
        value = balls.between(self.low, self.high)
        return 1 / value if self.backward else value

    def is_of(self, polynomial: Polynomial) -> bool:
        """Whether it is one of a divisor of its polynomial."""
        return has_root(tuple(reversed(polynomial)) if self.backward else polynomial, self.low, self.high)


#: Ends of the two charts: no round numbers, where roots of symmetric parameters are.
_BELOW, _BETWEEN = Fraction(-1, 7), Fraction(13, 11)


def roots_on_the_line(polynomial: tuple[Any, ...], bits: int, *, positive: bool = False) -> list[Root]:
    """All real roots of a polynomial without multiple ones, or the positive ones only; arguments as of :func:`.real_roots`.

    Exact coefficients go with ``positive`` only: an end of a chart may be a root of theirs, where balls are undecided.
    """
    while positive and polynomial and isinstance(polynomial[0], int) and polynomial[0] == 0:
        polynomial = polynomial[1:]  # the root 0
    found: list[Root] = []
    if not polynomial:
        return found
    for chart, limit, backward in ((polynomial, _BETWEEN, False), (tuple(reversed(polynomial)), 1 / _BETWEEN, True)):
        for low, high in real_roots(chart, _BELOW if positive else -limit, limit, bits):
            at_the_end = backward and low == limit  # which the first chart has
            if not at_the_end and (high > 0 or not positive):
                found.append(Root(low, high, backward))
    return found
