"""Factors of expressions, found the same way in every run.

For some of the random points that SymPy draws to factor a polynomial in several variables (Wang's
algorithm), its lifting of the factors takes minutes where it takes milliseconds for others. Most
equations of mechanics need no draw: a polynomial of degree 1 in one of its variables is
irreducible but for a factor that its two coefficients share, which is a greatest common divisor.
"""

from collections import Counter
from collections.abc import Iterator

import sympy as sp
from sympy import Expr, Poly
from sympy.core import random


def factor_list(expression: Expr) -> tuple[Expr, list[tuple[Expr, int]]]:
    """The rational factor of an expression, and its irreducible ones, each with its power.

    Functions and roots in it are unknowns, as for :func:`sympy.factor_list`.
    """
    if expression.is_number:
        return expression, []
    whole = Poly(expression)
    if not (whole.domain.is_ZZ or whole.domain.is_QQ):
        return _drawn(expression)
    integral = whole.clear_denoms(convert=True)[1]
    found = Counter(_irreducible(integral.primitive()[1]))
    number = whole.LC() / sp.Mul(*(factor.LC() ** power for factor, power in found.items()))
    powers = [(factor.as_expr(), power) for factor, power in found.items()]
    return number, sorted(powers, key=lambda it: (it[1], sp.default_sort_key(it[0])))


def factored(expression: Expr) -> Expr:
    """An expression as the product of its irreducible factors, over those of its denominator."""
    above, below = map(factor_list, sp.fraction(sp.together(expression)))
    powers = [base**power for base, power in above[1]]
    powers += [base**-power for base, power in below[1]]
    number, product = above[0] / below[0], sp.Mul(*powers)
    is_sum = product.is_Add and abs(number) != 1  # whose terms SymPy would multiply
    return sp.Mul(number, product, evaluate=False) if is_sum else number * product


def _irreducible(polynomial: Poly) -> Iterator[Poly]:
    """The irreducible factors of a primitive polynomial, each as often as it divides it."""
    linear = next((it for it in polynomial.gens if polynomial.degree(it) == 1), None)
    if linear is None:
        for factor, power in _drawn(polynomial)[1]:
            yield from [factor] * power
        return
    slope = polynomial.diff(linear)
    shared = slope.gcd(polynomial - slope * Poly(linear, *polynomial.gens))
    factor = polynomial.exquo(shared)
    yield -factor if factor.LC() < 0 else factor
    if not shared.is_ground:
        yield from _irreducible(shared)


def _drawn(expression: Expr | Poly) -> tuple[Expr, list[tuple[Expr, int]]]:
    """As :func:`sympy.factor_list`, by the same draws in every run; others go on undisturbed."""
    before = random.rng.getstate()
    random.seed(0)
    try:
        return sp.factor_list(expression)
    finally:
        random.rng.setstate(before)
