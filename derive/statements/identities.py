"""Whether an expression is 0: modulo sin² + cos² = 1 of all angles, and the identities of functions
that papers print.
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


def is_zero(expression: Expr) -> bool:
    """Whether an expression is 0 on all unit circles."""
    if _vanishes(expression):
        return True
    forms = [*_by_signs(expression)]
    return forms != [expression] and all(map(_vanishes, forms))


def normal_form(expression: Expr) -> Expr:
    """An expression modulo sin² + cos² = 1 of every angle: 0 exactly where it is 0."""
    plain, shown, circles = _on_circles(expression)
    if not plain.has(sp.Piecewise):  # a choice that is not made is compared with nothing
        plain = algebra.difference(plain, S.Zero, circles)
    return plain.xreplace(shown)


@functools.cache
def quotients(
    expression: Expr, coordinates: tuple[Symbol, ...], moving: tuple[Symbol, ...]
) -> tuple[tuple[Expr, Expr], ...]:
    """Products of some of an expression's factors that hold coordinates, and nothing else that
    moves, each beside what is left, which holds a state as well.
    """
    above, below = sp.fraction(normal_form(expression))
    number, factors = sp.factor_list(above)
    powers = [base**power for base, power in factors]
    states = [it for it in powers if it.has(*coordinates, *moving)]
    # Factors of which products are tried.
    still = [it for it in states if not it.has(*moving)][:3]
    sizes = range(1, min(len(states), len(still) + 1))
    found = []
    for some in itertools.chain(*(itertools.combinations(still, size) for size in sizes)):
        rest = [it for it in powers if it not in some]
        found.append((sp.Mul(*some), sp.expand(sp.Mul(number, *rest)) / below))
    return tuple(found)


def _vanishes(expression: Expr) -> bool:
    plain, _, circles = _on_circles(expression)
    return not plain.has(sp.Piecewise) and algebra.equal(plain, S.Zero, circles)


def _by_signs(expression: Expr) -> Iterator[Expr]:
    """An expression in exponentials of single terms, with each choice of signs of what stands in
    sizes, signs and conditions.
    """
    plain = expression.rewrite((sp.sinh, sp.cosh, sp.tanh), sp.exp)
    plain = plain.replace(sp.Abs, lambda size: size * _sign(size)).replace(sp.sign, _sign)
    conditions = (it for it in plain.atoms(Relational) if not it.has(sp.sign))
    plain = plain.xreplace({it: it.func(_sign(it.lhs - it.rhs), 0) for it in conditions})
    found = plain.atoms(sp.sign)
    # So many signs are chosen one by one.
    most = 5
    for signs in itertools.product((1, -1), repeat=len(found) * (len(found) <= most)):
        chosen = plain.xreplace(dict(zip(found, map(sp.Integer, signs), strict=False)))
        yield chosen.replace(sp.exp, lambda power: sp.expand_power_exp(sp.exp(sp.expand(power))))


def _sign(size: Expr) -> Expr:
    """The sign of a size by those of its factors, of sums that begin with a plus."""
    found: Expr = S.One
    for factor in sp.Mul.make_args(sp.factor(size)):
        if not factor.is_nonnegative:
            minus = factor.could_extract_minus_sign()
            found *= -sp.sign(-factor) if minus else sp.sign(factor)
    return found


def _on_circles(expression: Expr) -> tuple[Expr, Mapping[Expr, Expr], algebra.Circles]:
    """An expression in symbols for cosines and sines, what these stand for, and their pairs."""
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
    """An expression with whole multiples of angles, of θ/2 where that stands beside θ, and what the
    symbols for such parts are.
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
