"""Zero tests of expressions by exact algebra.

Expressions are compared modulo sin² + cos² = 1 of every angle (:mod:`..algebra`), with multiple and
half angles expanded, hyperbolic functions written in exponentials, and absolute values and signs
resolved case by case.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Iterator, Mapping

import sympy as sp
from sympy import Dummy, Expr, S, Symbol
from sympy.core.relational import Relational

from .. import algebra
from ..factors import factor_list, factored


def is_zero(expression: Expr) -> bool:
    """Whether an expression is proved to be 0."""
    if _vanishes(expression):
        return True
    cases = [*_by_signs(expression)]
    return cases != [expression] and all(map(_vanishes, cases))


def normal_form(expression: Expr) -> Expr:
    """An expression reduced modulo sin² + cos² = 1 of every angle; 0 if it is 0 on all circles."""
    plain, shown, circles = _on_circles(expression)
    if not plain.has(sp.Piecewise):  # the reduction is one of polynomials
        plain = algebra.difference(plain, S.Zero, circles)
    return plain.xreplace(shown)


@functools.cache
def quotients(
    expression: Expr, coordinates: tuple[Symbol, ...], moving: tuple[Symbol, ...]
) -> tuple[tuple[Expr, Expr], ...]:
    """Divisors of an expression that depend on coordinates, each with the quotient.

    A divisor is a product of factors without ``moving`` symbols; the quotient still depends on the
    state. Up to three such factors are combined.
    """
    above, below = sp.fraction(normal_form(expression))
    number, factors = factor_list(above)
    powers = [base**power for base, power in factors]
    states = [it for it in powers if it.has(*coordinates, *moving)]
    candidates = [it for it in states if not it.has(*moving)][:3]
    sizes = range(1, min(len(states), len(candidates) + 1))
    found = []
    for size in sizes:
        for divisors in itertools.combinations(candidates, size):
            rest = [it for it in powers if it not in divisors]
            found.append((sp.Mul(*divisors), sp.expand(sp.Mul(number, *rest)) / below))
    return tuple(found)


def _vanishes(expression: Expr) -> bool:
    plain, _, circles = _on_circles(expression)
    return not plain.has(sp.Piecewise) and algebra.equal(plain, S.Zero, circles)


def _by_signs(expression: Expr) -> Iterator[Expr]:
    """An expression in each combination of signs of its absolute values, signs and conditions.

    Hyperbolic functions are written in exponentials, and these in exponentials of single terms;
    logarithms are of single factors.
    """
    still = {it: Dummy(positive=True) for it in expression.free_symbols if it.is_nonnegative}
    plain = expression.xreplace(still).rewrite((sp.sinh, sp.cosh, sp.tanh), sp.exp)
    plain = plain.replace(sp.log, lambda power: sp.expand_log(sp.log(factored(power))))
    plain = plain.replace(sp.Abs, lambda size: size * _sign(size)).replace(sp.sign, _sign)
    conditions = (it for it in plain.atoms(Relational) if not it.has(sp.sign))
    plain = plain.xreplace({it: it.func(_sign(it.lhs - it.rhs), 0) for it in conditions})
    found = plain.atoms(sp.sign)
    most = 5  # of more signs no combinations are tried: they double with each
    count = len(found) if len(found) <= most else 0
    for signs in itertools.product((1, -1), repeat=count):
        chosen = plain.xreplace(dict(zip(found, map(sp.Integer, signs), strict=False)))
        yield chosen.replace(sp.exp, lambda power: sp.expand_power_exp(sp.exp(sp.expand(power))))


def _sign(size: Expr) -> Expr:
    """The sign of an expression as the product of those of its factors.

    A factor and its negative give the same symbol, with another sign before it.
    """
    found: Expr = S.One
    for factor in sp.Mul.make_args(factored(size)):
        if not factor.is_nonnegative:
            minus = factor.could_extract_minus_sign()
            found *= -sp.sign(-factor) if minus else sp.sign(factor)
    return found


def _on_circles(expression: Expr) -> tuple[Expr, Mapping[Expr, Expr], algebra.Circles]:
    """An expression with symbols c, s for the cosine and sine of each angle; the meanings of the
    symbols; and the pairs (c, s), which lie on unit circles.
    """
    plain = expression.replace(sp.cot, lambda angle: sp.cos(angle) / sp.sin(angle))
    plain = plain.replace(sp.tan, lambda angle: sp.sin(angle) / sp.cos(angle))
    plain, parts = _in_parts(plain)
    plain = sp.expand_trig(plain)
    angles = sorted({node.args[0] for node in plain.atoms(sp.cos, sp.sin)}, key=sp.default_sort_key)
    circles = tuple((Dummy("c", real=True), Dummy("s", real=True)) for _ in angles)
    names: dict[Expr, Expr] = {}
    for angle, (cosine, sine) in zip(angles, circles, strict=True):
        names |= {sp.cos(angle): cosine, sp.sin(angle): sine}
    shown = {symbol: wave.xreplace(parts) for wave, symbol in names.items()}
    return plain.xreplace(names), shown, circles


def _in_parts(expression: Expr) -> tuple[Expr, Mapping[Expr, Expr]]:
    """An expression in whole multiples of its angles, and the meanings of new symbols.

    If θ/2 stands beside θ, both are multiples of a symbol for θ/2.
    """
    waves = sorted(expression.atoms(sp.cos, sp.sin), key=sp.default_sort_key)
    terms = [[it.as_coeff_Mul() for it in sp.Add.make_args(sp.expand(w.args[0]))] for w in waves]
    below: dict[Expr, int] = {}
    for times, angle in itertools.chain(*terms):
        below[angle] = math.lcm(below.get(angle, 1), 1 if angle.is_number else times.q)
    parts = {angle: Dummy(real=True) for angle, number in below.items() if number > 1}
    whole = {angle: below[angle] * part for angle, part in parts.items()}
    known = {}
    for wave, sums in zip(waves, terms, strict=True):
        known[wave] = wave.func(sp.Add(*(times * whole.get(it, it) for times, it in sums)))
    return expression.xreplace(known), {part: angle / below[angle] for angle, part in parts.items()}
