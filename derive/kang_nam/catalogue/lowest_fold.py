"""Functions of the points at which the curve of folds turns back in μ₀."""

from __future__ import annotations

import sympy as sp

from ...emit.function import Function
from .. import elimination, equilibrium, lowest_fold
from .. import nomenclature as nm
from .arrangement import STIFFNESS, require_same, shorthands


def functions() -> tuple[Function, ...]:
    """Those of the module ``catastrophe``."""
    numerator, denominator, names = _turning_sine()
    weight, constant, along = lowest_fold.turning_line()
    cosine = nm.alpha * nm.s * (nm.sigma - (nm.sigma * nm.s + nm.kappa) * nm.s0) / weight
    require_same("cosines of a turning point", (cosine,), ((constant + along * nm.s0) / weight,))
    return (
        Function("turning_polynomial", "Coefficients of e0 + … + e9 s⁹, among whose roots s = sin θ in (0, 1] are all points at which the "
                 "curve of folds turns back in μ₀. Needs α > 0.", "f = f′ = f_θ₀ = 0", (nm.kappa, *STIFFNESS),
                 lowest_fold.turning_polynomial(), "e0, …, e9", shorthands(equilibrium.CONTACT, nm.B)),
        Function("turning_sine", "Numerator and denominator of sin θ₀ where the curve of folds turns back in μ₀.", "f = f′ = f_θ₀ = 0",
                 (nm.s, nm.kappa, *STIFFNESS), (numerator, denominator), "numerator, denominator", names),
        Function("turning_cosine", "cos θ cos θ₀ where the curve of folds turns back in μ₀. Needs α > 0.", "f = f_θ₀ = 0",
                 (nm.s, nm.s0, nm.kappa, *STIFFNESS), cosine, "cos cos0", shorthands(equilibrium.CONTACT, nm.p)),
    )  # fmt: skip


def _turning_sine() -> tuple[sp.Expr, sp.Expr, dict[sp.Symbol, sp.Expr]]:
    """By the coefficients of two quadratics in sin θ₀, each named."""
    w, l0, l1, v, width, lean = sp.symbols("w_line l_0 l_1 v width lean")
    first, second = sp.symbols("a_:3"), sp.symbols("c_:3")
    s, sigma = nm.s, nm.sigma
    slope, circle = lowest_fold.arranged_quadratics(w, l0, l1, v, width, lean)
    names = {
        **shorthands(equilibrium.CONTACT, nm.B, nm.p, nm.q, nm.fa),
        w: nm.kappa * nm.p + nm.alpha * sigma * s,
        v: sigma * s + nm.kappa,
        l0: nm.alpha * sigma * s,
        l1: -nm.alpha * s * v,
        width: 1 - s**2,
        lean: nm.kappa * nm.p - nm.fa * s**3 - nm.p * nm.B * s * width,
        **dict(zip((*first, *second), (*slope, *circle), strict=True)),
    }
    numerator, denominator = lowest_fold.common_sine(first, second)
    local = {name: value for name, value in names.items() if name not in equilibrium.SHORTHANDS}
    for _ in range(3):
        local = {name: sp.sympify(value).subs(local) for name, value in local.items()}
    derived = lowest_fold.common_sine(*lowest_fold.turning_quadratics())
    derived = tuple(value.subs(elimination.f_coefficients()) for value in derived)
    require_same("sine of a turning point", (numerator, denominator), derived, local)
    return numerator, denominator, names
