"""Linearization about an equilibrium: K (28), n̄ (29), the characteristic equation (27), and the
damping it leaves out.
"""

from functools import cache

import sympy as sp
from sympy import Expr, Matrix, diff, expand

from ..algebra import Names, Pair, Row
from . import unit_circles, elimination, equilibrium, mechanics
from .nomenclature import B, L, M, alpha, beta, c, c0, kappa, mu, mu0, n, nbar, p, q, s, s0
from .nomenclature import sigma, vx, vy
from .unit_circles import (
    ascending,
    by_inclination,
    polynomial,
    reduce_circles,
    require,
    rotate_derivative,
)

lam = sp.Symbol("lambda")


def _gradient(expression: Expr) -> Pair:
    """∂/∂x and ∂/∂y of an expression in x, y and L(x, y), at the state (c, s, L)."""
    square, polar = mechanics.spring_length() ** 2, equilibrium.displacement()
    slopes = {coordinate: (diff(square, coordinate) / (2 * L)).subs(polar) for coordinate in polar}
    return tuple(
        expand(diff(expression, coordinate).subs(polar) + diff(expression, L).subs(polar) * slope)
        for coordinate, slope in slopes.items()
    )


@cache
def stiffness() -> Matrix:
    """K of (28): the Jacobian of (F_x, F_y) at the equilibrium, in c, s and L."""
    return Matrix([_gradient(force) for force in equilibrium.balance_cartesian()])


@cache
def damping() -> Matrix:
    """∂(F_x, F_y)/∂(x', y') at steady sliding: the term that (27) leaves out, in y, μ₀, d and V."""
    forces = Matrix(mechanics.motion()).subs(
        {mu: mechanics.smooth_friction(sp.S.One), n: mechanics.contact_family()}
    )
    return sp.simplify(forces.jacobian([vx, vy]).subs(mechanics.AT_REST))


def characteristic(K: Matrix, C: Matrix) -> Expr:
    """det(λ² I + λ C + K): (27) where C = 0."""
    return expand((lam**2 * sp.eye(2) + lam * C + K).det())


def flutter_discriminant(K: Matrix) -> Expr:
    """(K₁₁ − K₂₂)² + 4 K₁₂ K₂₁, the discriminant of (27) in λ²: negative is flutter."""
    return (K[0, 0] - K[1, 1]) ** 2 + 4 * K[0, 1] * K[1, 0]


@cache
def trace_identity() -> bool:
    """The trace of K at an equilibrium in contact is α + σ + (B sin θ₀ + κ)/(L sin θ): positive for
    0 < θ, θ₀ < π.

    Where the discriminant is 0, the determinant is a quarter of its square: positive, so that no
    onset of flutter is a fold.
    """
    _, across = equilibrium.balance()
    (preload,) = sp.solve(in_contact(across), kappa)
    positive = p + (B * s0 + preload) / (L * s)
    return equilibrium.equal(in_shorthand(stiffness()).trace(), positive)


@cache
def reference_lines() -> tuple[Expr, Expr, Expr, Expr]:
    """u1, w1, u2, w2 of sin θ₀ = u1 + w1 L and α cos θ₀ = u2 + w2 L, the two balances in contact at
    given θ and μ₀.
    """
    friction, preload = M / B, sigma * s + kappa
    lines = (
        -preload / B,
        q * s / B,
        friction * preload - sigma * c,
        p * c - friction * sigma * s,
    )
    sine, cosine = (
        (constant + slope * L).subs(equilibrium.POLES) for constant, slope in (lines[:2], lines[2:])
    )
    gaps = [in_contact(force).subs(s0, sine) for force in equilibrium.balance()]
    gaps[0] -= alpha * c0 - cosine
    require(
        all(unit_circles.equal(gap, 0) for gap in gaps),
        "the balance at a direction, linear in the spring length",
    )
    return lines


@cache
def flutter_quadratic() -> Row:
    """Coefficients, lowest power first, of L² times the discriminant: zero at an onset with spring
    length L in direction θ.
    """
    discriminant = expand(L**2 * flutter_discriminant(in_shorthand(stiffness())))
    coefficients = map(reduce_circles, ascending(discriminant, L))
    difference = alpha - B
    arranged = (
        sigma**2,
        2 * sigma * (difference * (c**2 - s**2) + 2 * M * s * c),
        difference**2,
    )
    require(all(map(unit_circles.equal, arranged, coefficients)), "the discriminant of (27)")
    return arranged


@cache
def flutter_elimination() -> tuple[Expr, Expr, Expr]:
    """X, Y and Z in u1, w1, u2, w2 and e0, e1, e2: X² = Y Z is the resultant, in L, of the
    discriminant and of the unit circle.

    :func:`flutter_quadratic` has the coefficients e; α² (cos² θ₀ + sin² θ₀ − 1) with
    :func:`reference_lines` is a second quadratic in L. Where the two share one root, it is X/Y.
    """
    u1, w1, u2, w2 = LINES
    e0, e1, e2 = QUADRATIC
    g0 = u2**2 + alpha**2 * (u1**2 - 1)
    g1 = 2 * (u2 * w2 + alpha**2 * u1 * w1)
    g2 = w2**2 + alpha**2 * w1**2
    X, Y, Z = e0 * g2 - e2 * g0, e2 * g1 - e1 * g2, e1 * g0 - e0 * g1
    resultant = sp.resultant(*(polynomial(one, L) for one in (QUADRATIC, (g0, g1, g2))), L)
    require(expand(X**2 - Y * Z - resultant) == 0, "X² − Y Z, the resultant")
    return X, Y, Z


@cache
def flutter_without_alpha() -> Expr:
    """The same for α = 0: cos θ₀ is free, the second balance is itself the second condition, and
    the resultant is a square.
    """
    _, _, u2, w2 = LINES
    e0, e1, e2 = QUADRATIC
    condition = e0 * w2**2 - e1 * u2 * w2 + e2 * u2**2
    X, Y, Z = flutter_elimination()
    require(
        expand((X**2 - Y * Z).subs(alpha, 0) - condition**2) == 0,
        "the resultant at α = 0, a square",
    )
    return condition


#: Symbols for the coefficients of :func:`reference_lines` and :func:`flutter_quadratic`.
LINES = sp.symbols("u1 w1 u2 w2")
QUADRATIC = sp.symbols("e0 e1 e2")
#: Symbols for :func:`balance_slopes`.
SLOPES = sp.symbols("a_theta a_L a_theta0 b_theta b_L b_theta0")


@cache
def balance_slopes() -> Names:
    """Derivatives by θ, L and θ₀ of the balances along and across the belt, in contact."""
    a_t, a_l, a_0, b_t, b_l, b_0 = SLOPES
    names = {
        a_t: s * (p * L - sigma) - M * L * c,
        a_l: -p * c - M * s,
        a_0: M * c0 - alpha * s0,
        b_t: -c * (q * L - sigma),
        b_l: -q * s,
        b_0: B * c0,
    }
    changes = [
        change
        for form in map(in_contact, equilibrium.balance())
        for change in (rotate_derivative(form), diff(form, L), by_inclination(form))
    ]
    require(all(map(equilibrium.equal, names.values(), changes)), "the derivatives of the balance")
    return names


def crossing(by_direction: Expr, by_length: Expr) -> tuple[Pair, Names]:
    """N and J: along the equilibria at fixed μ₀, a form with these derivatives by θ and L changes
    by N/J per unit of θ₀; and names in them.

    By the implicit function theorem and Cramer's rule. J is minus the Jacobian determinant of the
    two balances in θ and L, and equals f′.
    """
    a_t, a_l, a_0, b_t, b_l, b_0 = SLOPES
    d_t, d_l = sp.symbols("d_theta d_L")
    return (
        d_t * (a_0 * b_l - b_0 * a_l) + d_l * (a_t * b_0 - b_t * a_0),
        b_t * a_l - a_t * b_l,
    ), {**balance_slopes(), d_t: by_direction, d_l: by_length}


@cache
def flutter_crossing() -> tuple[Pair, Names]:
    """:func:`crossing` of L² times the discriminant."""
    e0, e1, e2 = flutter_quadratic()
    by_direction = 4 * sigma * L * (M * (c**2 - s**2) - 2 * (alpha - B) * s * c)
    require(
        equilibrium.equal(by_direction, rotate_derivative(e0 + e1 * L + e2 * L**2)),
        "the derivative of the discriminant",
    )
    return crossing(by_direction, e1 + 2 * e2 * L)


@cache
def flutter_friction() -> Expr:
    """M at which an equilibrium with spring length L in direction θ is an onset: the discriminant
    is linear in M.
    """
    e0, e1, e2 = flutter_quadratic()
    (friction,) = sp.solve(polynomial((e0, e1, e2), L), M)
    arranged = -(e0 + 2 * sigma * (alpha - B) * (c**2 - s**2) * L + e2 * L**2) / (
        4 * sigma * s * c * L
    )
    require(unit_circles.equal(friction, arranged), "the friction at an onset")
    return arranged


@cache
def flutter_cubic() -> Row:
    """g0, g1, k0, k1, k2, k3: onsets at a given θ are where cos θ₀ (g0 + g1 sin θ₀) = k0 + k1 sin
    θ₀ + … + k3 sin³ θ₀.

    The balance along the belt times 4 σ sin θ cos θ L, with L from the balance across it and μ₀
    from :func:`flutter_friction`.
    """
    along, _ = equilibrium.balance()
    scale = 4 * sigma * s * c * L
    condition = sp.cancel(scale * in_contact(along).subs(M, flutter_friction()))
    cosine = expand(condition).coeff(c0, 1)
    rest = expand(cosine * c0 - condition)
    length = elimination.state()[L]
    return tuple(
        value for part in (cosine, rest) for value in ascending(expand(part.subs(L, length)), s0)
    )


def in_contact(force: Expr) -> Expr:
    """A balance in contact, with B for β + 1 and M for μ₀."""
    return force.subs(mu0 * nbar, M).subs(equilibrium.CONTACT).subs({mu0: M, beta: B - 1})


def in_shorthand(K: Matrix) -> Matrix:
    """K with B for β + n̄ and M for μ₀ n̄."""
    return K.subs(mu0 * nbar, M).subs(nbar, B - beta).applyfunc(expand)
