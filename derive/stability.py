"""Linearization about an equilibrium: K (28), n̄ (29), the characteristic equation (27), and the damping it leaves out."""

from __future__ import annotations

from functools import cache

import sympy as sp

from . import algebra, elimination, equilibrium, mechanics
from . import nomenclature as nm

lam = sp.Symbol("lambda")


def _gradient(expression: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """∂/∂x and ∂/∂y of an expression in x, y and L(x, y), at the state (c, s, L)."""
    length = mechanics.spring_length(nm.x, nm.y, sp.S.One)
    polar = dict(zip((nm.x, nm.y), equilibrium.displacement(), strict=True))
    slopes = [mechanics.replace_length(sp.diff(length, coordinate)).subs(polar) for coordinate in (nm.x, nm.y)]
    return tuple(
        sp.expand((sp.diff(expression, coordinate).subs(polar) + sp.diff(expression, nm.L).subs(polar) * slope))
        for coordinate, slope in zip((nm.x, nm.y), slopes, strict=True)
    )  # type: ignore[return-value]


@cache
def stiffness() -> sp.Matrix:
    """K of (28): the Jacobian of (F_x, F_y) at the equilibrium, in c, s and L."""
    return sp.Matrix([_gradient(force) for force in equilibrium.balance_cartesian()])


@cache
def damping() -> sp.Matrix:
    """∂(F_x, F_y)/∂(x', y') at steady sliding: the term that (27) leaves out, in y, μ₀, d and V."""
    forces = sp.Matrix(mechanics.sliding_forces())
    return sp.simplify(forces.jacobian([nm.vx, nm.vy]).subs({nm.vx: 0, nm.vy: 0}))


def characteristic(K: sp.Matrix, C: sp.Matrix) -> sp.Expr:
    """det(λ² I + λ C + K)."""
    return sp.expand((lam**2 * sp.eye(2) + lam * C + K).det())


def trace(K: sp.Matrix) -> sp.Expr:
    """K₁₁ + K₂₂."""
    return K[0, 0] + K[1, 1]


def determinant(K: sp.Matrix) -> sp.Expr:
    """K₁₁ K₂₂ − K₁₂ K₂₁: negative is divergence."""
    return K[0, 0] * K[1, 1] - K[0, 1] * K[1, 0]


def flutter_discriminant(K: sp.Matrix) -> sp.Expr:
    """(K₁₁ − K₂₂)² + 4 K₁₂ K₂₁, the discriminant of (27) in λ²: negative is flutter."""
    return (K[0, 0] - K[1, 1]) ** 2 + 4 * K[0, 1] * K[1, 0]


@cache
def flutter_point() -> tuple[sp.Expr, sp.Expr]:
    """sin θ₀ and M at a flutter onset with spring length L in direction θ: zero discriminant, and balance across the belt."""
    (friction,) = sp.solve(flutter_discriminant(in_shorthand(stiffness())), nm.M)
    (s0,) = sp.solve(elimination.state()[nm.L] - nm.L, nm.s0)
    arranged = (
        ((nm.q * nm.L - nm.sigma) * nm.s - nm.kappa) / nm.B,
        -(((nm.alpha - nm.B) * nm.L + nm.sigma * (nm.c**2 - nm.s**2)) ** 2 + 4 * (nm.sigma * nm.s * nm.c) ** 2)
        / (4 * nm.sigma * nm.s * nm.c * nm.L),
    )
    if not all(algebra.equal(ours, derived) for ours, derived in zip(arranged, (s0, friction), strict=True)):
        raise ArithmeticError("the flutter onset is not what stability.py arranges")
    return arranged


@cache
def flutter_sextic() -> tuple[sp.Expr, ...]:
    """Coefficients, lowest power first, of the polynomial in L whose roots are the flutter onsets at a given θ.

    :func:`flutter_point` gives M and sin θ₀, the balance along the belt cos θ₀; what is left is cos² θ₀ + sin² θ₀ = 1, of
    degree 6 in L. Contact only: B > 0.
    """
    s0, friction = flutter_point()
    along, _ = equilibrium.balance()
    along = along.subs(nm.mu0 * nm.nbar, nm.M).subs({nm.nbar: 0})  # every n̄ of (14) stands beside μ₀
    scale = 4 * nm.s * nm.c * nm.L * nm.sigma * nm.B
    without_c0 = sp.cancel(scale * along.subs(nm.c0, 0).subs(nm.M, friction).subs(nm.s0, s0))
    condition = without_c0**2 - scale**2 * nm.alpha**2 * (1 - s0**2)
    polynomial = sp.Poly(sp.fraction(sp.cancel(condition))[0], nm.L)
    return tuple(reversed(polynomial.all_coeffs()))


def in_shorthand(K: sp.Matrix) -> sp.Matrix:
    """K with B for β + n̄ and M for μ₀ n̄."""
    return K.subs(nm.mu0 * nm.nbar, nm.M).subs(nm.nbar, nm.B - nm.beta).applyfunc(sp.expand)
