"""The sign of an expression over all parameters of their domains, all places and all penetrations:
a proof that it is not negative, or a witness that it is.
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

    In what it is affine it is least at an end of the range, so that the ends of all these together
    decide; each of them by the signs of what is left.
    """
    if _is_nonnegative(expression):
        return True
    free = sp.Dummy(real=True)
    bounded = {
        atom: ends
        for atom, ends in _bounded(model, expression).items()
        if sp.expand(sp.diff(expression.xreplace({atom: free}), free, 2)) == 0
    }
    # More bounded quantities than these are not taken at all their ends.
    if not bounded or len(bounded) > 10:
        return False
    return all(
        _is_nonnegative(expression.xreplace(dict(zip(bounded, corner, strict=True))))
        for corner in itertools.product(*bounded.values())
    )


def _is_nonnegative(expression: Expr) -> bool:
    forms = (expression, sp.factor_terms(sp.expand(expression)))
    return any(bool(form.is_nonnegative) for form in forms) or _is_nonnegative_polynomial(
        expression
    )


def _is_nonnegative_polynomial(expression: Expr) -> bool:
    """Whether an expression is a polynomial of one quantity, with numbers as coefficients, that is
    nowhere negative: it changes its sign at roots of odd multiplicity only.
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
    """Bounds of sines and cosines, of hyperbolic tangents and of parameters whose domain has two
    ends.
    """
    waves = sorted(expression.atoms(sp.sin, sp.cos, sp.tanh), key=sp.default_sort_key)
    found: dict[Expr, _Ends] = dict.fromkeys(waves, (S.NegativeOne, S.One))
    angles = {angle.symbol: angle for angle in model.angles}
    for datum in model.parameters:
        symbol, allowed = number(datum), interval(datum.domain)
        ends = (
            Rational(allowed.low) if math.isfinite(allowed.low) else -sp.oo,
            (Rational(allowed.high) if math.isfinite(allowed.high) else sp.oo),
        )
        angle = angles.get(symbol)
        if angle:
            found |= {angle.c: _cosine(*ends), angle.s: _cosine(*(e - sp.pi / 2 for e in ends))}
        if (angle is None or angle.alone) and sp.oo not in (ends[1], -ends[0]):
            found[symbol] = ends
    return {atom: ends for atom, ends in found.items() if expression.has(atom)}


def _cosine(low: Expr, high: Expr) -> _Ends:
    """Least and largest cosine over a range."""
    if sp.oo in (high, -low):
        return S.NegativeOne, S.One
    inside = range(int(sp.ceiling(low / sp.pi)), int(sp.floor(high / sp.pi)) + 1)
    values = [sp.cos(low), sp.cos(high), *((-1) ** turn * S.One for turn in inside)]
    return sp.Min(*values), sp.Max(*values)


def witness(model: Mechanics, expression: Expr) -> str:
    """Place where an expression is negative, in words; empty if no place that was tried shows it.

    Floats propose a place, exact numbers confirm it.
    """
    domains = {number(datum): interval(datum.domain) for datum in model.parameters}
    angled = expression.subs(placed(model, {one: one for one in domains}), simultaneous=True)
    free = sorted(angled.free_symbols - domains.keys(), key=sp.default_sort_key)
    domains |= {symbol: Interval(low=0.0 if symbol.is_positive else -math.inf) for symbol in free}
    exact = negative_place(angled, domains)
    if exact is None:
        return ""
    where = ", ".join(f"{_shown(symbol)} = {sp.N(one, 3)}" for symbol, one in exact.items())
    value = sp.N(angled.subs(exact), 3)
    return f"{f'at {where} ' * bool(where)}it is {value} times its scale"


def placed(model: Mechanics, values: Mapping[Symbol, Expr]) -> dict[Symbol, Expr]:
    """Values of symbols, and of angles among these their cosines and sines."""
    found = dict(values)
    for angle in model.angles:
        if angle.symbol in values:
            value = values[angle.symbol]
            found |= {angle.c: sp.cos(value), angle.s: sp.sin(value)}
    return found


def negative_place(
    expression: Expr, domains: Mapping[Symbol, Interval]
) -> dict[Symbol, Rational] | None:
    """A place of the domains where an expression is negative; None if no place that was tried shows
    it.
    """
    rng = random.Random(0)
    needed = [symbol for symbol in domains if symbol in expression.free_symbols]
    by_floats = sp.lambdify([needed], expression, "math")
    # Floats look for a witness among numbers of common size, then of any.
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


def _shown(symbol: Symbol) -> str:
    return "depth" if symbol.name.startswith(DEPTH.name) else symbol.name


def _drawn(rng: random.Random, allowed: Interval, common: bool) -> float:
    """A number of a domain, with few digits, of common size or of any."""
    low, high = allowed.low, allowed.high
    # Sizes of what has no bounds.
    sizes = tuple(10.0**power for power in range(-6, 4))
    while True:
        if math.isfinite(low) and math.isfinite(high):
            value = low + (high - low) * rng.random()
        else:
            size = rng.uniform(0.1, 3.0) * (1.0 if common else rng.choice(sizes))
            away = low if math.isfinite(low) else high if math.isfinite(high) else 0.0
            sign = 1 if math.isfinite(low) else -1 if math.isfinite(high) else rng.choice((-1, 1))
            value = away + sign * size
        value = float(f"{value:.3g}")
        if allowed.holds(value):
            return value
