"""Functions of the points at which the curve of folds turns back in μ₀."""

import sympy as sp

from ...emit.function import Function
from .. import lowest_fold
from ..nomenclature import s, s0
from .arrangement import WITHOUT_FRICTION, in_contact


def functions() -> tuple[Function, ...]:
    """Functions of the module ``catastrophe``."""
    first, second = sp.symbols("a_:3"), sp.symbols("c_:3")
    slope, circle = lowest_fold.quadratics_in_parts()
    names = {
        **in_contact(),
        **lowest_fold.PARTS,
        **dict(zip((*first, *second), (*slope, *circle), strict=True)),
    }
    outer, upper, _ = lowest_fold.minors(first, second)
    weight, constant, along = lowest_fold.turning_line()
    cosine = sp.factor_terms(constant + along * s0) / weight
    return (
        Function(
            "turning_polynomial",
            "Coefficients of e0 + … + e9 s⁹, among whose roots s = sin θ in (0, 1] are all points "
            "at which the curve of folds turns back in μ₀. Needs α > 0.",
            "f = f′ = f_θ₀ = 0",
            WITHOUT_FRICTION,
            lowest_fold.turning_polynomial(),
            "e0, …, e9",
            in_contact(),
        ),
        Function(
            "turning_sine",
            "Numerator and denominator of sin θ₀ where the curve of folds turns back in μ₀.",
            "f = f′ = f_θ₀ = 0",
            (s, *WITHOUT_FRICTION),
            (-outer, upper),
            "numerator, denominator",
            names,
        ),
        Function(
            "turning_cosine",
            "cos θ cos θ₀ where the curve of folds turns back in μ₀. Needs α > 0.",
            "f = f_θ₀ = 0",
            (s, s0, *WITHOUT_FRICTION),
            cosine,
            "cos cos0",
            in_contact(),
        ),
    )
