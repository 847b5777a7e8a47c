"""From the balance of forces to one polynomial: the published quartic in L, (20)–(21), (23), (26),
and the quartic in t.

Both come from D(L) (cos θ, sin θ)ᵀ = b. The article asks that D⁻¹ b have unit length, which forgets
the sign of cos θ; solving the second row for L keeps it and leaves one trigonometric equation f(θ)
= 0.
"""

from functools import cache

import sympy as sp
from sympy import Symbol, expand

from ..algebra import Names, Row
from . import equilibrium
from .nomenclature import B, L, M, alpha, b1, b2, c, c0, fa, fb, fd, fm, kappa, nbar, p, q, s
from .nomenclature import s0, sigma, tt, x, y
from .equilibrium import spell_out
from .unit_circles import ascending, in_half_angle, polynomial, require

# ------------------------------------------------------------------------------------------------
# the published quartic in L


#: D and b in shorthands, for the family in n̄.
MATRIX = sp.Matrix([[sigma - p * L, -M * L], [0, sigma - q * L]])
RIGHT_SIDE = {b1: -alpha * c0 - M * s0, b2: -B * s0 - kappa}


@cache
def quartic_in_L() -> Row:
    """Coefficients of (21) and (26), lowest power first: of |adj(D) b|² − det(D)² for the family in
    n̄, in terms of b₁, b₂, p, q and M, as (A1)–(A9) write them.

    This is (20) times det(D)²: adj(D) = det(D) D⁻¹, and |D⁻¹ b|² = bᵀ D⁻ᵀ D⁻¹ b = bᵀ (D Dᵀ)⁻¹ b.
    """
    scaled = MATRIX.adjugate() * sp.Matrix([b1, b2])
    coefficients = ascending(expand(scaled.dot(scaled) - MATRIX.det() ** 2), L)
    return tuple(sp.factor_terms(sp.collect(value, (b1, b2))) for value in coefficients)


# ------------------------------------------------------------------------------------------------
# the equation in θ


@cache
def state() -> Names:
    """L, y and x as functions of θ, from the balance across the belt, in which μ₀ does not
    occur.
    """
    _, across = equilibrium.balance()
    (length,) = sp.solve(across, L)
    shorthand = (sigma * s + B * s0 + kappa) / (q * s)
    require(sp.simplify(length - spell_out(shorthand)) == 0, "L(θ) from F_y = 0")
    height = (sigma * (s0 - s) - kappa) / q
    require(sp.simplify(spell_out(height - (s0 - shorthand * s))) == 0, "y(θ) = s₀ − L s")
    return {L: shorthand, y: height, x: c0 - L * c}


#: f(θ) = a s c + b c + d s − m s².
f_form = fa * s * c + fb * c + fd * s - fm * s**2


@cache
def f_coefficients() -> Names:
    """a, b, d, m of f(θ) = q s F_x(θ, L(θ)), in shorthands; derived, then arranged so that few
    digits are lost.
    """
    along, _ = equilibrium.balance()
    f = expand(sp.simplify(spell_out(q * s * along.subs(L, state()[L]))))
    derived = sp.Poly(f, c, s).as_dict()
    require(
        set(derived) <= {(1, 1), (1, 0), (0, 1), (0, 2)}, "f has the four terms s c, c, s and s²"
    )
    arranged = {
        fa: sigma * (B - alpha),
        fb: -p * (B * s0 + kappa),
        fd: q * alpha * c0 + M * (sigma * s0 - kappa),
        fm: M * sigma,
    }
    for powers, value in {(1, 1): fa, (1, 0): fb, (0, 1): fd, (0, 2): -fm}.items():
        # n̄² = n̄ for n̄ in {0, 1}.
        gap = sp.rem(
            expand(derived.get(powers, 0) - spell_out(value.subs(arranged))),
            nbar**2 - nbar,
            nbar,
        )
        require(gap == 0, f"coefficient of c^{powers[0]} s^{powers[1]} in f")
    return arranged


@cache
def f_in_parameters() -> sp.Expr:
    """f(θ) in c, s, c0, s0 and the shorthands."""
    return f_form.subs(f_coefficients())


@cache
def quartic_in_t() -> Row:
    """Coefficients, lowest power first, of (1 + t²)² f with t = tan(θ/2), in a, b, d, m."""
    return tuple(map(sp.factor_terms, in_half_angle(f_form, 2)))


@cache
def resolvent_cubic() -> Row:
    """Coefficients, lowest power first, of the cubic in ℓ whose roots split f into two straight
    lines.

    On the unit circle f equals the conic f + ℓ (c² + s² − 1), which is a pair of lines where its
    determinant is zero. The cubic has the discriminant of the quartic in t (see :func:`identities`)
    and needs no division by b.
    """
    ell = Symbol("ell")
    conic = f_form + ell * (c**2 + s**2 - 1)
    homogeneous = Symbol("h")
    form = sp.Poly(conic, c, s).homogenize(homogeneous).as_expr()
    determinant = sp.hessian(form, (c, s, homogeneous)).det()
    *lower, leading = ascending(expand(determinant), ell)
    return tuple(expand(value / leading) for value in (*lower, leading))


# ------------------------------------------------------------------------------------------------
# identities


def identities() -> dict[str, bool]:
    """Relation between the two eliminations: statements, and whether exact algebra confirms
    each.
    """
    t, ell = tt, Symbol("ell")
    in_t = sp.Poly(polynomial(quartic_in_t(), t), t)
    cubic = sp.Poly(polynomial(resolvent_cubic(), ell), ell)
    length, f = state()[L], f_in_parameters()

    # In contact; lift-off is the same with β − 1 for β and μ₀ = 0. M, B and κ stay symbols.
    in_L = polynomial(quartic_in_L(), L)
    published = (q * s) ** 2 * in_L.subs(RIGHT_SIDE).subs(L, length)
    factored = (sigma - q * length) ** 2 * f * f.subs(c, -c)

    # Where a s + b = 0 the terms in cos θ cancel, so that θ and π − θ are roots together: there L =
    # σ/(σ + α).
    shared = {s: -fb / fa}
    false_root = spell_out(length.subs(shared).subs(f_coefficients()))
    return {
        "the roots in t multiply to −1": quartic_in_t()[0] == -quartic_in_t()[4],
        "the L-quartic at L(θ) is (σ − q L)² f(θ) f(π − θ) / (q s)²": equilibrium.equal(
            published, factored
        ),
        "f(θ) = f(π − θ) with cos θ ≠ 0 only at L = σ/(σ + α), where D is singular": sp.simplify(
            false_root - sp.solve(equilibrium.matrix_form()[0][0, 0], L)[0]
        )
        == 0,
        "f(θ) − f(π − θ) = 2 cos θ (a s + b)": expand(
            f_form - f_form.subs(c, -c) - 2 * c * (fa * s + fb)
        )
        == 0,
        "the resolvent cubic has the discriminant of the t-quartic": expand(
            in_t.discriminant() - 4096 * cubic.discriminant()
        )
        == 0,
    }
