"""Where the curve of folds turns back in μ₀, and folds at θ₀ = 0: all that end the lowest state, for exact parameters."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from ...generated import catastrophe as _catastrophe
from ...numerics import balls, descartes, polynomials
from ...numerics.adaptive_bits import decided, sign_or_zero
from ...numerics.half_angle import on_circle
from ...numerics.line_roots import roots_on_the_line
from ..quartic import kernel
from .fold_enclosures import Angles, Point, SineRoot, in_contact

#: Degrees in sin θ of sin θ₀, and of f″, times the denominator of sin θ₀.
_DEGREE, _CURVATURE_DEGREE = 6, 9


def turning_points(exact: tuple[Fraction, ...], bits: int) -> Iterator[Point]:
    """Every point with f = f′ = f_θ₀ = 0, f″ < 0, 0 < θ₀ < π/2 and μ₀ > 0, for exact κ, α, σ, β; without α there is none.

    f″ < 0: of three states the lower two in θ meet, and friction that rises ends the lowest.
    """
    if not exact[1]:
        return
    polynomial = polynomials.squarefree(_catastrophe.turning_polynomial(*exact))
    for low, high in descartes.real_roots(polynomial, Fraction(0), Fraction(1), bits - 32):
        yield from _turning_at(exact, SineRoot(polynomial, low, high))


def _turning_at(exact: tuple[Fraction, ...], sine: SineRoot) -> Iterator[Point]:
    values = tuple(map(balls.exact, exact))
    s = balls.between(sine.low, sine.high)
    numerator, denominator = _catastrophe.turning_sine(s, *values)
    s0 = numerator / denominator
    ratio = partial(_ratio, exact)
    if sine.sign_of(s0, lambda s: ratio(s)[0], _DEGREE, "sin θ₀ = 0 at a turn") <= 0:
        return
    if sine.sign_of(1 - s0, lambda s: ratio(s)[1] - ratio(s)[0], _DEGREE, "sin θ₀ = 1 at a turn") <= 0:
        return
    c0 = balls.sqrt(1 - s0 * s0)
    angles = Angles(_catastrophe.turning_cosine(s, s0, *values) / c0, s, c0, s0)
    mu0 = _catastrophe.surface(*angles, *values)
    trig = kernel.f_coefficients(c0, s0, mu0, *values, 1)

    def cusp(s: Fraction) -> Fraction:
        above, below = ratio(s)
        return (above - below * Fraction(_catastrophe.cusp_sine(s, *exact)[0])) * (3 * s * s - 2)

    curvature = kernel.f_curvature(angles.c, s, *trig)
    if sine.sign_of(curvature, cusp, _CURVATURE_DEGREE, "f″ = 0 at a turn") < 0:
        for point in in_contact(angles, mu0, values):
            if decided(mu0, "μ₀ = 0 at a turn") > 0:
                yield point


def _ratio(exact: tuple[Fraction, ...], s: Fraction) -> tuple[Fraction, ...]:
    return tuple(map(Fraction, _catastrophe.turning_sine(s, *exact)))


def level_folds(exact: tuple[Fraction, ...], bits: int) -> Iterator[Point]:
    """Every fold at θ₀ = 0 with f″ < 0 and μ₀ > 0, and every cusp there that folds with θ₀ > 0 leave."""
    level = Fraction(1), Fraction(0)
    without, change = kernel.f_along("mu0", *level, Fraction(0), *exact)
    polynomial = polynomials.primitive(tuple(map(Fraction, kernel.fold_sextic(*without, *change))))
    repeated = polynomials.common_divisor(polynomial, polynomials.derivative(polynomial))
    values = tuple(map(balls.exact, exact))
    for root in roots_on_the_line(polynomials.without(polynomial, repeated), bits - 32, positive=True):
        c, s, _ = on_circle(root.interval())
        angles = Angles(c, s, *map(balls.exact, level))
        mu0 = _catastrophe.surface(*angles, *values)
        curvature = kernel.f_curvature(c, s, *kernel.f_coefficients(angles.c0, angles.s0, mu0, *values, 1))
        end = sign_or_zero(curvature, "f″ = 0 on a fold at θ₀ = 0", partial(root.is_of, repeated))
        if end == 0:
            (by_angle, slope), (by_friction, other), *_ = _catastrophe.unfolding(*angles, mu0, *values)
            end = -decided(by_friction * slope - by_angle * other, "how a cusp at θ₀ = 0 opens")
        L, x, y = kernel.state(*angles, values[0], *values[2:], 1)
        if end < 0 and decided(mu0, "μ₀ = 0 on a fold at θ₀ = 0") > 0 and decided(y, "y = 0") < 0:
            yield Point((balls.exact(Fraction(0)), mu0, *values), balls.atan(root.interval()) * 2, L, x, y)
