"""Exact comparison: two expressions are equal when their difference reduces to zero, and not otherwise.

Differences are brought over one denominator and their numerators reduced modulo cos² + sin² = 1 for θ and θ₀, which
is a Gröbner basis: the remainder is zero exactly when the numerator vanishes on both unit circles. No float takes part.
"""

from __future__ import annotations

import sympy as sp

from .kang_nam import nomenclature as nm


def reduce_circles(polynomial: sp.Expr) -> sp.Expr:
    """Normal form of a polynomial modulo cos² = 1 − sin² on each unit circle."""
    polynomial = sp.expand(polynomial)
    for cosine, sine in nm.UNIT_CIRCLES:
        if not polynomial.has(cosine):
            continue
        even_odd = [sp.S.Zero, sp.S.Zero]
        for (power,), coefficient in sp.Poly(polynomial, cosine).terms():
            even_odd[power % 2] += coefficient * (1 - sine**2) ** (power // 2)
        polynomial = sp.expand(even_odd[0] + cosine * even_odd[1])
    return polynomial


def difference(left: sp.Expr, right: sp.Expr) -> sp.Expr:
    """``left − right`` in normal form: 0 exactly when the two are equal as functions on the unit circles.

    Roots, exponentials, absolute values and signs count as unknowns of their own, so that nothing is taken for equal that
    is not equal term by term.
    """
    unknowns: dict[sp.Expr, sp.Dummy] = {}
    gap = (sp.sympify(left) - sp.sympify(right)).replace(
        _is_transcendental, lambda node: unknowns.setdefault(node, sp.Dummy(f"u{len(unknowns)}"))
    )
    numerator, denominator = sp.fraction(sp.together(gap))
    numerator = reduce_circles(numerator)
    if numerator == 0:
        return sp.S.Zero
    return (numerator / sp.factor(denominator)).subs({dummy: node for node, dummy in unknowns.items()})


def _is_transcendental(node: sp.Basic) -> bool:
    return isinstance(node, sp.exp | sp.Abs | sp.sign | sp.Piecewise) or (
        isinstance(node, sp.Pow) and not node.exp.is_Integer
    )


def equal(left: sp.Expr, right: sp.Expr) -> bool:
    """Whether two expressions are the same function on the unit circles."""
    return difference(left, right) == 0


def on_circle(expression: sp.Expr) -> sp.Expr:
    """The same expression with cos θ, sin θ, cos θ₀, sin θ₀ as functions of the angles turned into symbols."""
    return expression.subs(
        {sp.cos(nm.theta): nm.c, sp.sin(nm.theta): nm.s, sp.cos(nm.theta0): nm.c0, sp.sin(nm.theta0): nm.s0}
    )


def rotate_derivative(expression: sp.Expr) -> sp.Expr:
    """d/dθ of an expression in ``c`` and ``s``: dc = −s dθ, ds = c dθ."""
    return sp.diff(expression, nm.s) * nm.c - sp.diff(expression, nm.c) * nm.s


def manifestly_positive(
    polynomial: sp.Expr, symbols: tuple[sp.Symbol, ...], strict_symbols: tuple[sp.Symbol, ...]
) -> bool:
    """Whether a polynomial is positive for all ``symbols`` ≥ 0 of which the ``strict_symbols`` are > 0.

    No coefficient is negative, and one term holds none but strict symbols. Sufficient, not necessary.
    """
    terms = sp.Poly(sp.expand(polynomial), *symbols).terms()
    strict = [symbol in strict_symbols for symbol in symbols]
    return all(value.is_number and value > 0 for _, value in terms) and any(
        all(allowed or power == 0 for allowed, power in zip(strict, powers, strict=True)) for powers, _ in terms
    )
