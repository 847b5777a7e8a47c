"""Exact algebra on the unit circles of θ and θ₀, whose cosines and sines are symbols of the nomenclature."""

from __future__ import annotations

import sympy as sp

from .. import algebra
from . import nomenclature as nm


def reduce_circles(polynomial: sp.Expr) -> sp.Expr:
    """Normal form of a polynomial modulo cos² = 1 − sin² for θ and θ₀."""
    return algebra.reduce_circles(polynomial, nm.UNIT_CIRCLES)


def difference(left: sp.Expr, right: sp.Expr) -> sp.Expr:
    """``left − right`` in the normal form of :func:`derive.algebra.difference`."""
    return algebra.difference(left, right, nm.UNIT_CIRCLES)


def equal(left: sp.Expr, right: sp.Expr) -> bool:
    """Whether two expressions are the same function of θ and θ₀."""
    return difference(left, right) == 0


def rotate_derivative(expression: sp.Expr) -> sp.Expr:
    """d/dθ of an expression in ``c`` and ``s``: dc = −s dθ, ds = c dθ."""
    return sp.diff(expression, nm.s) * nm.c - sp.diff(expression, nm.c) * nm.s
