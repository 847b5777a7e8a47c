"""Exact algebra on the unit circles of θ and θ₀, whose cosines and sines are symbols of the
nomenclature.
"""

from collections.abc import Iterable

import sympy as sp
from sympy import Expr, diff

from ..algebra import Row
from .. import algebra
from .nomenclature import UNIT_CIRCLES, c, c0, s, s0, tt


def reduce_circles(polynomial: Expr) -> Expr:
    """Normal form of a polynomial modulo cos² = 1 − sin² for θ and θ₀."""
    return algebra.reduce_circles(polynomial, UNIT_CIRCLES)


def equal(left: Expr, right: Expr) -> bool:
    """Whether two expressions are the same function of θ and θ₀."""
    return algebra.equal(left, right, UNIT_CIRCLES)


def rotate_derivative(expression: Expr) -> Expr:
    """d/dθ of an expression in ``c`` and ``s``: dc = −s dθ, ds = c dθ."""
    return diff(expression, s) * c - diff(expression, c) * s


def by_inclination(expression: Expr) -> Expr:
    """d/dθ₀ of an expression in ``c0`` and ``s0``."""
    return diff(expression, s0) * c0 - diff(expression, c0) * s0


def ascending(polynomial: Expr, variable: sp.Symbol) -> Row:
    """Coefficients of a polynomial, lowest power first."""
    return tuple(reversed(sp.Poly(polynomial, variable).all_coeffs()))


def polynomial(coefficients: Iterable[Expr], variable: Expr) -> Expr:
    """The polynomial with these coefficients, lowest power first."""
    return sp.Add(*(value * variable**power for power, value in enumerate(coefficients)))


def in_half_angle(expression: Expr, power: int) -> Row:
    """Coefficients in t = tan(θ/2), lowest power first, of (1 + t²)^power times an expression in
    ``c`` and ``s``.
    """
    t = tt
    turned = expression.subs({c: (1 - t**2) / (1 + t**2), s: 2 * t / (1 + t**2)})
    return ascending(sp.cancel(sp.together((1 + t**2) ** power * turned)), t)


def require(holds: object, what: str) -> None:
    """Raise where what is arranged by hand is not what is derived."""
    if not holds:
        raise ArithmeticError(f"the derivation does not give what is arranged: {what}")
