"""The sign of an expression over all parameters in their domains, all coordinates and penetrations:
a proof that it is nonnegative, or a witness that it is negative.
"""

import itertools
import math
import random
from collections.abc import Mapping

import sympy as sp
from sympy import Expr, Rational, S, Symbol

from .emit.quantities import Interval, interval
from .mechanics import DEPTH, Mechanics, number

#: A pair of bounds.
_Ends = tuple[Expr, Expr]


def is_nonnegative(model: Mechanics, expression: Expr) -> bool:
    """Whether an expression is proved to be ≥ 0.

    In quantities in which it is affine, an expression has its minimum at an end of their ranges: it
    is judged at all corners, by SymPy's assumptions or as a polynomial of one quantity.
    """
    if is_nonnegative_everywhere(expression):
        return True
    free = sp.Dummy(real=True)
    bounded = {
        atom: ends
        for atom, ends in _bounded(model, expression).items()
        if sp.expand(sp.diff(expression.xreplace({atom: free}), free, 2)) == 0
    }
    most_corners = 2**10
    if not bounded or 2 ** len(bounded) > most_corners:
        return False
    return all(
        is_nonnegative_everywhere(expression.xreplace(dict(zip(bounded, corner, strict=True))))
        for corner in itertools.product(*bounded.values())
    )


def is_nonnegative_everywhere(expression: Expr) -> bool:
    """Whether an expression is proved to be ≥ 0 for all values of its symbols, by SymPy's
    assumptions or as a polynomial of one quantity.
    """
    forms = (expression, sp.factor_terms(sp.expand(expression)))
    return any(bool(form.is_nonnegative) for form in forms) or _is_nonnegative_polynomial(
        expression
    )


def _is_nonnegative_polynomial(expression: Expr) -> bool:
    """Whether an expression is a polynomial of one quantity with rational coefficients that is
    nowhere negative.

    It has no real root of odd multiplicity, by Sturm's theorem, and its leading coefficient is
    positive.
    """
    unknown = expression.free_symbols
    if len(unknown) != 1 or not expression.is_polynomial(*unknown):
        return False
    (symbol,) = unknown
    half = bool(symbol.is_nonnegative)
    changes = [
        sp.Poly(factor, symbol)
        for factor, times in sp.sqf_list(expression)[1]
        if times % 2 and not (half and factor == symbol)
    ]
    if not all(factor.get_domain() in (sp.ZZ, sp.QQ) for factor in changes):
        return False
    roots = sum(factor.count_roots(0 if half else None) for factor in changes)
    return roots == 0 and bool(sp.LC(expression, symbol) > 0)


def _bounded(model: Mechanics, expression: Expr) -> dict[Expr, _Ends]:
    """Ranges of the sines, cosines and hyperbolic tangents in an expression, and of its parameters
    with bounded domains.
    """
    waves = sorted(expression.atoms(sp.sin, sp.cos, sp.tanh), key=sp.default_sort_key)
    found: dict[Expr, _Ends] = dict.fromkeys(waves, (S.NegativeOne, S.One))
    angles = {angle.symbol: angle for angle in model.angles}
    for datum in model.parameters:
        symbol, allowed = number(datum), interval(datum.domain)
        low, high = (
            Rational(end) if math.isfinite(end) else S(end) for end in (allowed.low, allowed.high)
        )
        angle, between = angles.get(symbol), sp.AccumBounds(low, high)
        if angle:
            turned = {angle.c: sp.cos(between), angle.s: sp.sin(between)}
            found |= {wave: (its.min, its.max) for wave, its in turned.items()}
        if (angle is None or angle.alone) and sp.oo not in (high, -low):
            found[symbol] = low, high
    return {atom: ends for atom, ends in found.items() if expression.has(atom)}


def witness(model: Mechanics, expression: Expr) -> str:
    """Where an expression is negative, as text; empty if no such place is found.

    Random floats propose a place, exact numbers confirm it.
    """
    domains = {number(datum): interval(datum.domain) for datum in model.parameters}
    angled = expression.subs(placed(model, {one: one for one in domains}), simultaneous=True)
    free = sorted(angled.free_symbols - domains.keys(), key=sp.default_sort_key)
    domains |= {symbol: Interval(low=0.0 if symbol.is_positive else -math.inf) for symbol in free}
    exact = negative_place(angled, domains)
    if exact is None:
        return ""
    where = ", ".join(f"{_page_name(symbol)} = {sp.N(one, 3)}" for symbol, one in exact.items())
    value = sp.N(angled.subs(exact), 3)
    return f"{f'at {where} ' * bool(where)}it is {value} times its scale"


def placed(model: Mechanics, values: Mapping[Symbol, Expr]) -> dict[Symbol, Expr]:
    """Values of symbols, with those of the cosines and sines of angles added."""
    found = dict(values)
    for angle in model.angles:
        if angle.symbol in values:
            value = values[angle.symbol]
            found |= {angle.c: sp.cos(value), angle.s: sp.sin(value)}
    return found


def negative_place(
    expression: Expr, domains: Mapping[Symbol, Interval]
) -> dict[Symbol, Rational] | None:
    """Values in the domains at which an expression is negative; None if random search finds
    none.
    """
    rng = random.Random(0)
    needed = [symbol for symbol in domains if symbol in expression.free_symbols]
    by_floats = sp.lambdify([needed], expression, "math")
    for common in [True] * 1000 + [False] * 1000:
        point = [_drawn(rng, domains[symbol], common) for symbol in needed]
        try:
            negative = by_floats(point) < 0
        except (ArithmeticError, ValueError, TypeError):
            continue
        if not negative:
            continue
        exact = dict(zip(needed, (Rational(str(one)) for one in point), strict=True))
        value = expression.subs(exact)
        if value.is_number and value.is_negative:
            return exact
    return None


def _page_name(symbol: Symbol) -> str:
    """The name of a symbol on the page, where every penetration is called depth."""
    return "depth" if symbol.name.startswith(DEPTH.name) else symbol.name


def _drawn(rng: random.Random, allowed: Interval, common: bool) -> float:
    """A random number of a domain with 3 digits; of order 1 if ``common``, else of any size."""
    low, high = allowed.low, allowed.high
    sizes = tuple(10.0**power for power in range(-6, 4))
    while True:
        if math.isfinite(low) and math.isfinite(high):
            value = low + (high - low) * rng.random()
        else:
            size = rng.uniform(0.1, 3.0) * (1.0 if common else rng.choice(sizes))
            if math.isfinite(low):
                value = low + size
            elif math.isfinite(high):
                value = high - size
            else:
                value = rng.choice((-1, 1)) * size
        value = float(f"{value:.3g}")
        if allowed.holds(value):
            return value
