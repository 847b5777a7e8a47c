"""Points of the surface with f = f′ = 0, enclosed: what proofs of folds and of cusps find."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

from ..exact.escalation import angle, as_floats, decided
from ..exact.intervals import Arithmetic, Interval
from ..statics import kernel


class Angles(NamedTuple):
    """cos θ, sin θ, cos θ₀ and sin θ₀."""

    c: Interval
    s: Interval
    c0: Interval
    s0: Interval


@dataclass(frozen=True)
class Point:
    """A point of the surface with f = f′ = 0, in intervals: parameters in the order of ``NAMES``, direction and state."""

    parameters: tuple[Interval, ...]
    theta: Interval
    L: Interval
    x: Interval
    y: Interval

    def row(self, arith: Arithmetic) -> tuple[float, ...]:
        """Middles as floats, and the largest error, the rounding to float included."""
        values, error = as_floats(arith, (*self.parameters, self.theta, self.L, self.x, self.y))
        return (*values, error)


def in_contact(arith: Arithmetic, angles: Angles, mu0: Interval, values: tuple[Interval, ...]) -> Iterator[Point]:
    """The point at κ, α, σ, β with its state, if it is in contact with L > 0."""
    kappa, _, sigma, beta = values
    L, x, y = kernel.state(*angles, kappa, sigma, beta, 1)
    if decided(arith, L, "L = 0") > 0 and decided(arith, y, "y = 0") < 0:
        yield Point((angle(arith, angles.c0, angles.s0), mu0, *values), angle(arith, angles.c, angles.s), L, x, y)
