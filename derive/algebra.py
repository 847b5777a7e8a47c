"""Exact comparison of expressions: they are equal if and only if their difference reduces to 0.

An angle is a pair of symbols for its cosine and sine. A difference is brought over one denominator,
and its numerator is reduced modulo cos² + sin² = 1 of each pair. These relations are a Gröbner
basis: the remainder is 0 exactly if the numerator vanishes on all unit circles. No floats are used.
"""

import itertools
import math
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypeAlias

import sympy as sp
from sympy import Dummy, Expr, S, Symbol, expand
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyElement, PolyRing

from .factors import factored

#: Tuples of expressions, and pairs.
Row: TypeAlias = tuple[Expr, ...]
Pair: TypeAlias = tuple[Expr, Expr]
#: Tuples of symbols, as arguments are, and the meanings of symbols.
Symbols: TypeAlias = tuple[Symbol, ...]
Names: TypeAlias = dict[Symbol, Expr]
#: Pairs of symbols for cosine and sine of an angle.
Circles = tuple[tuple[Symbol, Symbol], ...]
#: Factors of a denominator, and their powers.
Factors: TypeAlias = Mapping[PolyElement, int]


def expanded(expression: Expr) -> Expr:
    """An expression multiplied out, except for denominators, exponentials, and roots of sums with
    the powers of sums that hold one.

    Over intervals 1/(1 − x)² keeps its sign, and 1/(1 − 2x + x²) does not; exp(−(x − 1)²) is at
    most 1, and a factor of it, as exp(2 x), overflows; and of a spring that hardens,
    (√((a − x)² + y²) − l)³, multiplied out, is a sum of large terms that cancel.
    """
    below = {
        node
        for node in expression.atoms(sp.Pow)
        if node.exp.is_Integer and node.exp.is_negative and node.base.is_Add
    }
    kept = {node: Dummy() for node in below | expression.atoms(sp.exp) | rooted(expression)}
    return expand(expression.xreplace(kept)).xreplace({dummy: node for node, dummy in kept.items()})


def rooted(expression: Expr) -> set[sp.Pow]:
    """The roots of sums in an expression, and the powers of sums that hold one."""
    sums = {node for node in expression.atoms(sp.Pow) if node.base.is_Add}
    roots = {node for node in sums if node.exp.is_Rational and not node.exp.is_Integer}
    return roots | {node for node in sums if node.exp.is_Integer and node.base.has(*roots)}


def reached(level: Expr) -> Expr:
    """1 where a level is ≥ 0, −1 where it is negative."""
    return sp.sign(2 * sp.sign(level) + 1)


def quotients(expression: Expr) -> list[sp.Pow]:
    """The quotients and roots in an expression: powers whose exponents are no positive integers."""
    return [
        node
        for node in expression.atoms(sp.Pow)
        if not (node.exp.is_Integer and node.exp.is_positive)
    ]


def reduce_circles(polynomial: Expr, circles: Circles) -> Expr:
    """Normal form of a polynomial modulo cos² = 1 − sin² on each unit circle."""
    polynomial = expand(polynomial)
    for cosine, sine in circles:
        if not polynomial.has(cosine):
            continue
        even_odd = [S.Zero, S.Zero]
        for (power,), coefficient in sp.Poly(polynomial, cosine).terms():
            even_odd[power % 2] += coefficient * (1 - sine**2) ** (power // 2)
        polynomial = expand(even_odd[0] + cosine * even_odd[1])
    return polynomial


def fewest_terms(polynomial: Expr, cosine: Symbol, sine: Symbol) -> Expr:
    """A polynomial with c² or s² eliminated by c² + s² = 1, whichever leaves fewer terms."""
    forms = (reduce_circles(polynomial, (pair,)) for pair in ((cosine, sine), (sine, cosine)))
    return min(forms, key=lambda form: len(sp.Add.make_args(form)))


@dataclass(frozen=True)
class Gap:
    """A difference with symbols in place of functions and roots."""

    value: Expr
    unknowns: dict[Expr, Dummy]  #: symbols by the functions
    roots: dict[Expr, Dummy]  #: symbols by the bases of the roots
    order: int  #: the symbol to this power is the base


def gap(left: Expr, right: Expr, circles: Circles) -> Gap:
    """``left − right`` with a symbol for every function and every root.

    The symbols are independent unknowns, so that an equality that needs a relation between two
    functions is not recognized. These relations are: fractional powers of one base are powers of
    one root; exponentials with commensurable exponents are powers of one; functions of arguments
    that are equal on the circles are equal; odd and even functions of opposite arguments are
    opposite or equal.
    """

    def normal(argument: Expr) -> Expr:
        if argument.is_polynomial(*argument.free_symbols):
            return reduce_circles(argument, circles)
        return argument

    def unknown(node: Expr) -> Expr:
        """The expression, in symbols, for a function or a piecewise expression."""
        if not isinstance(node, sp.Function):
            return named(node)
        arguments = [normal(argument) for argument in node.args]
        if isinstance(node, odd | even) and arguments[0].could_extract_minus_sign():
            return named(node.func(-arguments[0])) * (-1 if isinstance(node, odd) else 1)
        if not isinstance(node, sp.exp):
            return named(node.func(*arguments))
        times, exponent = arguments[0].as_content_primitive()
        if exponent.could_extract_minus_sign():
            times, exponent = -times, -exponent
        return named(sp.exp(exponent)) ** times

    def named(node: Expr) -> Dummy:
        return unknowns.setdefault(node, Dummy(f"u{len(unknowns)}"))

    odd = sp.sign | sp.tan | sp.sinh | sp.tanh | sp.atan | sp.asin
    even = sp.Abs | sp.cosh
    unknowns: dict[Expr, Dummy] = {}
    value = (sp.sympify(left) - sp.sympify(right)).replace(
        lambda node: isinstance(node, sp.Function | sp.Piecewise),
        unknown,
    )
    order = math.lcm(*(node.exp.q for node in value.atoms(sp.Pow) if node.exp.is_Rational))
    roots: dict[Expr, Dummy] = {}

    def root(node: sp.Pow) -> Expr:
        """A fractional power as a power of the symbol for the root of its base."""
        base = normal(node.base)
        if (power := base**node.exp).is_Rational:
            return power
        return roots.setdefault(base, Dummy(f"r{len(roots)}")) ** (order * node.exp)

    value = value.replace(lambda node: isinstance(node, sp.Pow) and not node.exp.is_Integer, root)
    return Gap(value, unknowns, roots, order)


def equal(left: Expr, right: Expr, circles: Circles) -> bool:
    """Whether :func:`difference` is 0; faster, since its form is not computed."""
    return not _reduced(gap(left, right, circles), circles)[0]


def difference(left: Expr, right: Expr, circles: Circles) -> Expr:
    """``left − right`` in normal form: 0 exactly if both are equal on the unit circles, with the
    functions and roots of :func:`gap` as unknowns.
    """
    found = gap(left, right, circles)
    numerator, factors = _reduced(found, circles)
    below = (factored(factor.as_expr()) ** power for factor, power in factors.items())
    shown = numerator.as_expr() / sp.Mul(*below)
    for base, root in reversed(found.roots.items()):
        shown = shown.subs(root, sp.Pow(base, sp.Rational(1, found.order)))
    # Outer functions first: their arguments hold symbols of inner ones.
    return shown.subs([(dummy, node) for node, dummy in reversed(found.unknowns.items())])


def _reduced(found: Gap, circles: Circles) -> tuple[PolyElement, Factors]:
    """The reduced numerator of a difference, and the factors of its denominator with their powers,
    as polynomials with integer coefficients.
    """
    values = (found.value, *found.roots, *found.roots.values(), *itertools.chain(*circles))
    atoms = set().union(*(value.atoms() for value in values))
    powers = set().union(*(value.atoms(sp.Pow) for value in values))
    names = {atom for atom in atoms if not atom.is_Rational}
    names |= {power for power in powers if not power.exp.is_Integer}
    ring = PolyRing(sorted(names, key=sp.default_sort_key), sp.ZZ, lex)
    numerator, denominator = _quotient(found.value, ring)
    factors = Counter(denominator)
    for base, root in reversed(found.roots.items()):
        above, below = _quotient(base, ring)
        numerator, most = _lowered(numerator, ring(root), found.order, above, below)
        factors.update({factor: power * most for factor, power in below.items()})
    for cosine, sine in circles:
        numerator, _ = _lowered(numerator, ring(cosine), 2, 1 - ring(sine) ** 2, {})
    return numerator, factors


def _quotient(value: Expr, ring: PolyRing) -> tuple[PolyElement, Factors]:
    """The numerator of an expression, and the factors of its denominator with their powers."""
    if value.is_Rational:
        return ring(value.p), {} if value.q == 1 else {ring(value.q): 1}
    if value in ring.symbols:
        return ring(value), {}
    if isinstance(value, sp.Pow) and value.exp.is_Integer:
        above, below = _quotient(value.base, ring)
        power = abs(int(value.exp))
        if value.exp > 0:
            return above**power, {factor: power * times for factor, times in below.items()}
        return _multiplied(ring.one, below) ** power, {above: power}
    parts = [_quotient(part, ring) for part in value.args]
    shared: Counter[PolyElement] = Counter()
    if isinstance(value, sp.Mul):
        for _, below in parts:
            shared.update(below)
        return math.prod((above for above, _ in parts), start=ring.one), shared
    if not isinstance(value, sp.Add):
        raise TypeError(f"{value} is no quotient of polynomials")
    for _, below in parts:
        shared |= Counter(below)
    terms = (_multiplied(above, shared - Counter(below)) for above, below in parts)
    return sum(terms, ring.zero), shared


def _multiplied(polynomial: PolyElement, factors: Factors) -> PolyElement:
    for factor, power in factors.items():
        polynomial = polynomial * factor**power
    return polynomial


def _lowered(
    polynomial: PolyElement, name: PolyElement, order: int, above: PolyElement, below: Factors
) -> tuple[PolyElement, int]:
    """A polynomial reduced modulo name^order = above/below, times the power of ``below`` that
    clears denominators; and that power.
    """
    ring = polynomial.ring
    index, divisor = ring.gens.index(name), _multiplied(ring.one, below)
    parts: dict[int, dict[tuple[int, ...], int]] = {}
    for powers, value in polynomial.terms():
        times, rest = divmod(powers[index], order)
        part = parts.setdefault(times, {})
        part[(*powers[:index], rest, *powers[index + 1 :])] = value
    most = max(parts, default=0)
    terms = (
        ring.from_dict(part) * above**times * divisor ** (most - times)
        for times, part in parts.items()
    )
    return sum(terms, ring.zero), most


def manifestly_positive(polynomial: Expr) -> bool:
    """Whether a polynomial is positive because all coefficients are, all symbols are nonnegative,
    and one term has positive symbols only: a sufficient condition.
    """
    symbols = sorted(polynomial.free_symbols, key=str)
    terms = sp.Poly(expand(polynomial), *symbols).terms()
    return (
        all(symbol.is_nonnegative for symbol in symbols)
        and all(value.is_number and value > 0 for _, value in terms)
        and any(
            all(
                symbol.is_positive or power == 0
                for symbol, power in zip(symbols, powers, strict=True)
            )
            for powers, _ in terms
        )
    )
