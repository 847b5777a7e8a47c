"""All cusps, proved complete: they are roots of a polynomial in sin θ (derived:
``cusp_polynomial``).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from ..core.questions import NotInClosedForm
from ..generated import catastrophe as _catastrophe
from ..models.parameters import Ranges
from ..numerics import balls, polynomials
from ..numerics.arithmetic import Number
from ..numerics.balls import Interval, as_mpf, as_numbers, atan2, decided, sign, with_enough_bits
from ..numerics.polynomials import RootOf, roots_on_the_line
from ..results import Points
from ..results.precise_states import CuspProof, PreciseCusp
from .folds import (
    STATE,
    Angles,
    SurfacePoint,
    cosines_of,
    in_contact,
    listed,
    unfolded,
    within,
)
from .kernel import Fixed
from .parameters import Parameters


def cusps(
    p: Parameters,
    vary: Sequence[str] | None = None,
    *,
    between: Ranges | None = None,
) -> Points:
    """The closed form of :func:`spragsym.cusps` in the plane of θ₀ and μ₀: proved complete.

    Notes
    -----
    Source: f = f′ = f″ = 0, one polynomial of degree 9 in sin θ (a cubic for α = 0); its roots are
    isolated exactly. Parameters are taken as the exact rationals that the floats are.
    """
    if vary is not None and tuple(vary) != ("theta0", "mu0"):
        raise NotInClosedForm
    exact, plane = tuple(map(Fraction, p.scalars(*Fixed._fields))), ("theta0", "mu0")
    found = with_enough_bits(
        20, lambda bits: [point.row(*plane) for point in proved_cusps(exact, bits)], "cusps"
    )
    rows = sorted(found, key=lambda row: (row[1], *row))
    spans = (-math.pi, math.pi), (-math.inf, math.inf)
    return within(listed(p, plane, np.full(len(rows), "cusp"), rows, spans=spans), between)


def precise_cusps(
    _p: Parameters, given: Mapping[str, Any], vary: Sequence[str], digits: int
) -> CuspProof:
    """All cusps in the plane of θ₀ and μ₀; source: f = f′ = f″ = 0, one rational polynomial of
    degree 9 in sin θ.
    """
    if tuple(vary) != ("theta0", "mu0"):
        raise NotInClosedForm
    exact = tuple(given[name] for name in Fixed._fields)
    found = with_enough_bits(
        digits, lambda bits: [_cusp(point, digits) for point in proved_cusps(exact, bits)], "cusps"
    )
    ordered = tuple(sorted(found, key=lambda one: (one.mu0, one.theta0)))
    if exact[1] == 1 + exact[3]:
        return CuspProof(ordered, True, {})
    polynomial, sines = cusp_sines(*exact, bits=64)
    return CuspProof(ordered, True, {}, polynomial, tuple(sines), len(sines))


def _cusp(point: SurfacePoint, digits: int) -> PreciseCusp:
    numbers, _, radius = as_numbers(
        (*point.parameters[:2], point.theta, point.L, point.x, point.y), digits
    )
    return PreciseCusp(
        dict(zip(("theta0", "mu0", *STATE), numbers, strict=True)), as_mpf(radius), is_versal(point)
    )


def cusp_sines(
    kappa: Fraction, alpha: Fraction, sigma: Fraction, beta: Fraction, *, bits: int
) -> tuple[tuple[Fraction, ...], list[polynomials.IsolatedRoot]]:
    """The polynomial of the cusps for α ≠ 1 + β, and isolating intervals of its roots in [−1, 1].

    For α = 0 neither end is a root: there the cubic is ±3 κ (1 + β + σ).
    """
    coefficients = (
        _catastrophe.cusp_polynomial(kappa, alpha, sigma, beta)
        if alpha
        else _catastrophe.cusp_cubic(kappa, sigma, beta)
    )
    polynomial = tuple(map(Fraction, coefficients))
    simple, one = polynomials.squarefree(polynomial), Fraction(1)
    lowest = (
        [polynomials.IsolatedRoot(-one, -one)] if polynomials.evaluate(simple, -one) == 0 else []
    )
    return polynomial, [*lowest, *polynomials.real_roots(simple, -one, one, bits)]


def proved_cusps(exact: tuple[Fraction, ...], bits: int) -> Iterator[SurfacePoint]:
    """Every cusp in contact with L > 0, for exact κ, α, σ, β, with θ₀ in (−π, π] and μ₀ of either
    sign, so that mirror images are included.
    """
    _, alpha, _, beta = exact
    if alpha == 1 + beta:
        yield from _cusps_without_a(tuple(map(balls.exact, exact)), bits)
        return
    polynomial, roots = cusp_sines(*exact, bits=bits - 32)
    for root in roots:
        yield from _cusps_at(exact, RootOf(polynomial, *root))
    if not alpha:
        # The second fold relation has the factor cos θ besides the cubic: a cusp at μ₀ = 0 and θ =
        # π/2. At −π/2 sin θ₀ would be −1 − κ/(1 + β).
        yield from _cusps_at(exact, RootOf((-1, 1), Fraction(1), Fraction(1)))


def _cusps_at(exact: tuple[Fraction, ...], sine: RootOf) -> Iterator[SurfacePoint]:
    """The cusps at one value of sin θ. Quantities that are exactly 0 for special parameters, as cos
    θ₀ or y, are recognized by exact algebra.
    """
    alpha = exact[1]
    values = tuple(map(balls.exact, exact))
    s = sine.interval()
    s0, friction = _catastrophe.cusp_sine(s, *values)
    L = _cusp_length(s, *values)

    def sign_of(value: Interval, exactly: Callable[[Fraction], Fraction], what: str) -> int:
        # The quantities times (3 sin² θ − 2)² are polynomials of degree at most 10 in sin θ.
        return sine.sign_of(value, lambda s: exactly(s) * (3 * s * s - 2) ** 2, 10, what)

    sides = (
        sign_of(L, lambda s: _cusp_length(s, *exact), "L = 0 on a cusp"),
        sign_of(
            s0 - L * s,
            lambda s: _catastrophe.cusp_sine(s, *exact)[0] - _cusp_length(s, *exact) * s,
            "y = 0 on a cusp",
        ),
    )
    if sides != (1, -1):
        return
    leaning = _catastrophe.cusp_point(s, *values)[1] if alpha else None
    upright = abs(sine.low) == abs(sine.high) == 1
    flat = sign_of(s, lambda s: s, "sin θ = 0 on a cusp") == 0
    flat0 = sign_of(s0, lambda s: _catastrophe.cusp_sine(s, *exact)[0], "sin θ₀ = 0 on a cusp") == 0
    for c in cosines_of(s, 0 if upright else 1):
        if alpha:
            cosines = [leaning * c]
        else:
            inside = sign_of(
                1 - s0 * s0,
                lambda s: 1 - _catastrophe.cusp_sine(s, *exact)[0] ** 2,
                "cos θ₀ = 0 on a cusp",
            )
            cosines = cosines_of(s0, inside)
        for c0 in cosines:
            angles = (_angle_or_level(c0, s0, flat0), _angle_or_level(c, s, flat))
            yield SurfacePoint(
                (angles[0], friction * c, *values), angles[1], L, c0 - L * c, s0 - L * s
            )


def _angle_or_level(cosine: Interval, sine: Interval, level: bool) -> Interval:
    """The angle in (−π, π]; exactly 0 or π if ``level`` says that the sine is 0."""
    if not level:
        return atan2(sine, cosine)
    return balls.exact(Fraction(0)) if decided(cosine, "cos θ = 0") > 0 else balls.pi()


def _cusp_length(s: Number, kappa: Number, alpha: Number, sigma: Number, beta: Number) -> Any:
    """L on a cusp: (σ s + B s₀ + κ)/(q s), where B s₀ + κ = −b/p = (a s³ + m s² c)/p."""
    p, B = alpha + sigma, 1 + beta
    return sigma * (1 + (B - alpha) * s * s / (p * (3 * s * s - 2))) / (B + sigma)


def _cusps_without_a(values: tuple[Interval, ...], bits: int) -> Iterator[SurfacePoint]:
    """The cusps for α = 1 + β: there a = 0, and f″ = 0 on a fold is 3 sin² θ = 2 at any
    friction.
    """
    third = balls.exact(Fraction(1, 3))
    for s_sign in (1, -1):
        s = s_sign * balls.sqrt(2 * third)
        for c_sign in (1, -1):
            c = c_sign * balls.sqrt(third)
            quartic = _catastrophe.fold_quartic(c, s, *values)
            for root in roots_on_the_line(quartic, bits // 2):
                mu0 = root.interval()
                s0, c0 = _catastrophe.fold_angles(c, s, mu0, *values)
                yield from in_contact(Angles(c, s, c0, s0), mu0, *values)


def is_versal(point: SurfacePoint) -> bool:
    """Whether (θ₀, μ₀) unfold a cusp versally, as catastrophe theory requires.

    f‴ ≠ 0 on every cusp: f has four roots in t with the product −1, of which three are equal, so
    that the fourth has the other sign.
    """
    theta0, *values = point.parameters
    return sign(unfolded(Angles(*balls.cos_sin(point.theta), *balls.cos_sin(theta0)), *values)) != 0
