"""The equilibrium surface in closed form, its folds (f = f′ = 0) and its cusps (f = f′ = f″ =
0).
"""

from functools import cache

import sympy as sp
from sympy import Expr, expand

from ..algebra import Names, Pair, Row
from . import unit_circles, elimination, stability
from .nomenclature import B, L, M, alpha, c, c0, fa, fa_v, fb, fb_v, fd, fd_v, fm, fm_v, kappa
from .nomenclature import p, q, s, s0, sigma
from .elimination import f_form
from .equilibrium import POLES, equal
from .unit_circles import (
    ascending,
    in_half_angle,
    polynomial,
    reduce_circles,
    require,
    rotate_derivative,
)

#: f′, f″ and f‴ with respect to θ.
slope = expand(rotate_derivative(f_form))
curvature = expand(rotate_derivative(slope))
third = expand(rotate_derivative(curvature))


@cache
def surface() -> Expr:
    """M(θ, θ₀) = μ₀ n̄ on the equilibrium surface: f is linear in M."""
    f = elimination.f_in_parameters()
    surface = surface_in_coefficients().subs(elimination.f_coefficients())
    (friction,) = sp.solve(f, M)
    require(
        not sp.diff(f, M).has(M) and sp.simplify(friction - surface) == 0,
        "f, linear in M, and the surface",
    )
    return surface


def surface_in_coefficients() -> Expr:
    """The same, with a and b kept as symbols."""
    arranged = fa * s * c + fb * c + q * alpha * c0 * s
    return arranged / (s * (kappa - sigma * (s0 - s)))


@cache
def slope_identity() -> bool:
    """L det K = ∂f/∂θ wherever f = 0: with the friction for which f = 0 put in, the two sides are
    the same function.
    """
    on_surface = {M: surface()}
    determinant = stability.in_shorthand(stability.stiffness()).det()
    left = (L * determinant).subs(L, elimination.state()[L])
    right = rotate_derivative(elimination.f_in_parameters())
    return equal(left.subs(on_surface), right.subs(on_surface))


# ------------------------------------------------------------------------------------------------
# folds


@cache
def fold_relations() -> Names:
    """b and d on a fold, from f = f′ = 0, which are linear in the two."""
    solution = sp.solve([f_form, slope], [fb, fd], dict=True)[0]
    arranged = {
        fb: -(s**2) * (fa * s + fm * c),
        fd: -fa * c**3 + fm * s * (1 + c**2),
    }
    require(
        all(unit_circles.equal(solution[symbol], value) for symbol, value in arranged.items()),
        "b and d on a fold",
    )
    return arranged


@cache
def fold_residuals() -> Pair:
    """b − b(fold) and d − d(fold): both zero exactly where f = f′ = 0, and linear in each of μ₀, κ,
    α, σ and β.
    """
    coefficients = elimination.f_coefficients()
    return tuple((symbol - value).subs(coefficients) for symbol, value in fold_relations().items())


@cache
def fold_angles() -> Pair:
    """sin θ₀ and cos θ₀ on the fold through θ at friction M: a line and a parabola in M. Needs α, B
    > 0.
    """
    along, across = fold_residuals()
    (sine0,) = sp.solve(along, s0)
    (cosine0,) = sp.solve(across, c0)
    return sine0, cosine0


@cache
def fold_quartic() -> tuple[Row, Names]:
    """Coefficients, lowest power first, of the polynomial in M whose roots are all folds at a given
    θ, and names in them.

    It is sin² θ₀ + cos² θ₀ − 1 with :func:`fold_angles`, u0 + u1 M and g0 + g1 M + g2 M²; α = 0
    takes :func:`fold_quadratic`. Dividing by p B and q α first keeps every coefficient a sum of a
    few squares and products.
    """
    sine0, cosine0 = fold_angles()
    line, parabola = sp.symbols("u:2"), sp.symbols("g:3")
    sine, cosine = (polynomial(names, M) for names in (line, parabola))
    values = (
        *ascending(sine0, M),
        *ascending(sp.cancel(cosine0.subs(s0, sine)), M),
    )
    coefficients = ascending(expand(sine**2 + cosine**2 - 1), M)
    return coefficients, dict(zip((*line, *parabola), map(sp.factor_terms, values), strict=True))


@cache
def fold_quadratic() -> Row:
    """The same for α = 0: cos θ₀ drops out of f, and what is left of d − d(fold) is quadratic in
    M.
    """
    _, across = fold_residuals()
    sine0, _ = fold_angles()
    return _coefficients_in_M(sp.cancel((p * B * across.subs(s0, sine0)).subs(alpha, 0)))


def _coefficients_in_M(condition: Expr) -> Row:
    numerator, denominator = sp.fraction(sp.together(condition))
    require(not denominator.free_symbols, "the fold condition, a polynomial in M")
    return tuple(value / denominator for value in ascending(numerator, M))


@cache
def fold_conic() -> Row:
    """E0, E1, E2, Ec of E0 + E1 sin θ₀ + E2 sin² θ₀ + Ec cos θ₀ = 0: all folds at a given θ,
    friction eliminated.

    The fold relations are lines in M, so that M drops out of u1 w2 − u2 w1. But for the last one,
    which has the factor cos θ, the coefficients are polynomials in sin θ.
    """
    threshold = kappa + sigma * s * (2 - s**2)
    conic = (
        kappa * p * threshold - fa * s**2 * (sigma + kappa * s),
        p * B * threshold - sigma * (kappa * p - fa * s**3),
        -p * B * sigma,
        -q * alpha * sigma * s**2 * c,
    )
    (u1, w1), (u2, w2) = (
        (relation.subs(M, 0), sp.diff(relation, M)) for relation in fold_residuals()
    )
    gap = u1 * w2 - u2 * w1 - polynomial(conic[:3], s0) - conic[3] * c0
    require(
        equal(gap.subs(elimination.f_coefficients()), sp.S.Zero),
        "the conic of folds at a direction",
    )
    return conic


def fold_events(conic: Row) -> tuple[Expr, Expr, Expr]:
    """Quantities that vanish where two folds of one θ meet, where one has θ₀ = 0 or π, and where
    one has no friction.

    The first two in E0, E1, E2 and Ec² of :func:`fold_conic`, which in v = tan(θ₀/2) is a quartic;
    the third is (p B q α)² (sin² θ₀ + cos² θ₀ − 1) with :func:`fold_angles` at M = 0.
    """
    e0, e1, e2, square = conic
    v, ec = sp.symbols("v ec")
    half_angle = {s0: 2 * v / (1 + v**2), c0: (1 - v**2) / (1 + v**2)}
    condition = (e0 + e1 * s0 + e2 * s0**2 + ec * c0).subs(half_angle)
    quartic = sp.Poly(sp.cancel(condition * (1 + v**2) ** 2), v)
    meeting = expand(27 * sp.discriminant(quartic)).subs(ec, sp.sqrt(square))
    border = expand(quartic.all_coeffs()[0] * quartic.all_coeffs()[-1]).subs(ec, sp.sqrt(square))
    sine0, cosine0 = (value.subs(M, 0) for value in fold_angles())
    rest = sp.cancel((p * B * q * alpha) ** 2 * (sine0**2 + cosine0.subs(s0, sine0) ** 2 - 1))
    return meeting, border, rest


#: Coefficients of ∂f/∂v, of the form of f: f is linear in every parameter v but θ₀.
CHANGE = {fa: fa_v, fb: fb_v, fd: fd_v, fm: fm_v}


@cache
def fold_sextic() -> Row:
    """Coefficients, lowest power first, of (1 + t²)³ (f′ f_v − f f_v′), t = tan(θ/2): its roots are
    all folds along v.

    With f = f₀ + v f_v the surface is v(θ) = −f₀/f_v, and v′ is minus this over f_v²; f for any
    value of v gives the same.
    """
    change = f_form.subs(CHANGE)
    condition = reduce_circles(expand(slope * change - f_form * rotate_derivative(change)))
    return in_half_angle(condition, 3)


def fold_cubics() -> tuple[Row, Row]:
    """Coefficients, lowest power first, of (1 + t²)³ times p B sin θ₀ and p B q α cos θ₀ on the
    fold through t at friction M.
    """
    sine0, cosine0 = fold_angles()
    values = p * B * sine0, p * B * q * alpha * cosine0.subs(s0, sine0)
    sine, cosine = (
        tuple(map(sp.factor_terms, in_half_angle(sp.cancel(value), 3))) for value in values
    )
    return sine, cosine


# ------------------------------------------------------------------------------------------------
# cusps


@cache
def cusp_friction() -> Expr:
    """m on a cusp: f″ = 0 on the fold."""
    condition = reduce_circles(curvature.subs(fold_relations()))
    (friction,) = sp.solve(condition, fm)
    arranged = 3 * fa * s * c / (3 * s**2 - 2)
    require(unit_circles.equal(friction, arranged), "m on a cusp")
    return arranged


@cache
def cusp_angles() -> Pair:
    """sin θ₀ and cos θ₀ / cos θ on a cusp, rational functions of s = sin θ with the factor 3 s² − 2
    kept together.
    """
    S = 3 * s**2 - 2
    sine = (sigma * (B - alpha) * s**3 / (p * S) - kappa) / B
    G = 3 * kappa * p * q * s * S - 4 * B * p * sigma * (1 - s**2) + 3 * sigma * alpha * q * s**4
    ratio = (B - alpha) * G / (B * alpha * p * q * S**2)
    on_cusp = {M: cusp_friction().subs(elimination.f_coefficients()) / sigma, s0: sine}
    derived = (value.subs(on_cusp) for value in fold_angles())
    require(all(map(equal, derived, (sine, ratio * c))), "the angles of a cusp")
    return sine, ratio


@cache
def cusp_polynomial() -> Row:
    """Coefficients, lowest power first, of the polynomial in s = sin θ whose real roots in (−1, 1)
    are all the cusps.

    It is (B p α q)² (3 s² − 2)⁴ (sin² θ₀ + cos² θ₀ − 1) with :func:`cusp_angles`. Contact only, α >
    0 and a ≠ 0; the terms of degree 10 cancel.
    """
    sine0, ratio = cusp_angles()
    scale = B * p * alpha * q * (3 * s**2 - 2) ** 2
    condition = (
        sp.cancel(scale * sine0) ** 2 + (1 - s**2) * sp.cancel(scale * ratio) ** 2 - scale**2
    )
    return ascending(expand(condition.subs(POLES)), s)


@cache
def cusp_cubic() -> Row:
    """The same for α = 0, where cos θ₀ is free and what is left of d − d(fold) = 0 is a cubic in s.

    The numerator of cos θ₀ in :func:`cusp_angles`, which must vanish with α, over B − α.
    """
    _, ratio = cusp_angles()
    numerator = sp.cancel(ratio * B * alpha * p * q * (3 * s**2 - 2) ** 2 / (B - alpha))
    return ascending(expand(numerator.subs(POLES).subs(alpha, 0) / sigma), s)


def identities() -> dict[str, bool]:
    """The closed forms, each decided by exact algebra."""
    mirror = {c: -c, c0: -c0, M: -M}
    f = elimination.f_in_parameters()
    return {
        "L det K = f′ at every equilibrium": slope_identity(),
        "the fold relations solve f = f′ = 0": all(
            unit_circles.equal(value.subs(fold_relations()), 0) for value in (f_form, slope)
        ),
        "the cusp polynomial has degree 9": len(cusp_polynomial()) == 10,
        "no cusp is lost at 3 sin² θ = 2: the cusp polynomial is 16 σ⁴ (B − α)⁴/27 there": (
            expand(
                sp.rem(polynomial(cusp_polynomial(), s), 3 * s**2 - 2, s)
                - sp.Rational(16, 27) * sigma**4 * (B - alpha) ** 4
            )
            == 0
        ),
        "the cusp cubic (α = 0) has degree 3": len(cusp_cubic()) == 4,
        "the trace of K in contact is α + σ + (B sin θ₀ + κ)/(L sin θ) > 0, so that no onset "
        "of flutter is a fold": (stability.trace_identity()),
        "(θ, θ₀, μ) → (π − θ, π − θ₀, −μ) turns f into −f": unit_circles.equal(
            f.subs(mirror, simultaneous=True), -f
        ),
    }
