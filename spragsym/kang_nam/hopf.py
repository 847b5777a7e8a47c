"""Hopf points of the article's model in closed form: with the damping of the friction law along the
belt, whatever V and d, states at which K₂₁ = 0 or K₁₂ = 0.

``derive/kang_nam/routh.py`` proves it: Hurwitz's last condition is c² K₁₂ K₂₁ > 0. K₂₁ = 0 is an
upright spring, θ = π/2; K₁₂ = 0 is one polynomial in tan(θ/2 − π/4).
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from ..generated import catastrophe as _catastrophe
from ..generated import stability as _stability
from ..numerics import balls, polynomials
from ..numerics.arithmetic import Number
from ..numerics.balls import atan2, decided
from ..numerics.polynomials import RootOf, on_circle, real_roots, root_bound
from . import kernel
from .flutter import Elimination, Onset, onsets, rank


class Uncoupled(Elimination):
    """The eliminated condition K₁₂ = 0, where L = −σ sin θ cos θ/μ₀."""

    degree = 6
    grows = 1  # L K₁₂ is positive there, since K₂₁ < 0

    def remaining(self, c: Fraction, s: Fraction) -> Fraction:
        S, A, D = _stability.coupling_lines(c, s, *self.values)
        return A * A + self.alpha**2 * (S * S - D * D) if self.alpha else A

    def crossing(self, *onset: Any) -> tuple[Any, int]:
        change, across = _stability.coupling_crossing(*onset)
        return change, decided(across, "f′ = 0 at an onset")

    def length(self, c: Number, s: Number, values: tuple[Any, ...]) -> tuple[Any, Any]:
        mu0, _, _, sigma, _ = values
        return -sigma * s * c, mu0


def hopf_points(values: tuple[Fraction, ...], bits: int) -> Iterator[Onset]:
    """Every Hopf point with 0 < θ₀ < π in contact, for exact μ₀ > 0, κ, α, σ and β."""
    yield from _upright(values, bits)
    yield from onsets(Uncoupled(*values), bits)


def _upright(exact: tuple[Fraction, ...], bits: int) -> Iterator[Onset]:
    """States with θ = π/2: q α cos θ₀ + μ₀ σ sin θ₀ = μ₀ (κ + σ), a quadratic in tan(θ₀/2).

    All are in contact, as of every state with cos θ ≤ 0.
    """
    mu0, kappa, alpha, sigma, beta = exact
    along, press = (1 + beta + sigma) * alpha, mu0 * (kappa + sigma)
    quadratic = polynomials.primitive((along - press, 2 * mu0 * sigma, -along - press))
    simple = polynomials.squarefree(quadratic)
    values = tuple(map(balls.exact, exact))
    zero, one = (balls.exact(Fraction(number)) for number in (0, 1))
    for low, high in real_roots(simple, Fraction(0), root_bound(simple), bits):
        root = RootOf(simple, low, high)
        c0, s0, _ = on_circle(root.interval())
        L, x, y = kernel.state_of(zero, one, c0, s0, *values[1:])
        trig = kernel.f_coefficients(c0, s0, *values, 1)
        slope = decided(kernel.f_slope(zero, one, *trig), "f′ = 0 at θ = 90°")
        (by_angle, _), *_ = _catastrophe.unfolding(zero, one, c0, s0, *values)
        # θ grows with θ₀ by −f_θ₀/f′, and the pair grows where cos θ < 0.
        touches = len(simple) < len(quadratic)
        side = 0 if touches else -slope * decided(by_angle, "the turn of the spring")
        edge = s0 - values[1] / values[3]
        branch, count = rank(kernel.t_quartic(*trig), one, edge, bits // 2)
        yield Onset((atan2(s0, c0), *values), atan2(one, zero), L, x, y, branch, count, side, slope)
