"""Functions of the model with the spring's angle held at θ₀."""

import sympy as sp

from ...emit.function import Function, Module
from .. import linear_sprag
from ..nomenclature import T, kappa, mu0
from .arrangement import POINT, STIFFNESS, require_same


def module() -> Module:
    determinant = sp.Symbol("determinant")
    K = linear_sprag.stiffness()
    arranged = (kappa * K[0, 1] / determinant, -kappa * K[0, 0] / determinant)
    names = {determinant: sp.collect(sp.expand(K.det()), mu0)}
    require_same("linear displacement", arranged, linear_sprag.equilibrium(), names)
    return Module(
        "linear_sprag",
        "The constant-angle model of the article's reference [17]: displacement, poles, "
        "critical friction.",
        (
            Function(
                "displacement",
                "x and y at steady sliding with the spring's angle held at θ₀.",
                "(12), (13) linearized",
                POINT,
                arranged,
                "x, y",
                names,
            ),
            Function(
                "pole_quadratic",
                "Coefficients of e0 + e1 T + e2 T², whose roots T = tan θ₀ are the poles.",
                "determinant of the linear model",
                (mu0, *STIFFNESS),
                linear_sprag.pole_quadratic(),
                "e0, e1, e2",
            ),
            Function(
                "pole_friction",
                "μ₀ with a pole at T = tan θ₀.",
                "determinant of the linear model",
                (T, *STIFFNESS),
                sp.factor_terms(linear_sprag.pole_friction()),
                "mu0",
            ),
            Function(
                "critical_friction_squared",
                "μ_cr²: for α, μ₀ > 0 there is a pole if and only if μ₀ ≥ μ_cr.",
                "article, Section 3",
                STIFFNESS,
                linear_sprag.critical_friction_squared(),
                "mu_cr²",
            ),
        ),
    )
