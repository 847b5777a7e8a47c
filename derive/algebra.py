"""Exact comparison: two expressions are equal when their difference reduces to zero, and not
otherwise.

An angle enters as a pair of symbols for its cosine and sine. A difference is brought over one
denominator and its numerator reduced modulo cos² + sin² = 1 for each pair, which is a Gröbner
basis: the remainder is zero exactly when the numerator vanishes on all of the unit circles. No
float takes part.
"""

import math
from typing import TypeAlias

import sympy as sp

#: Expressions in a row, as coefficients and results are, and two of them.
Row: TypeAlias = tuple[sp.Expr, ...]
Pair: TypeAlias = tuple[sp.Expr, sp.Expr]
#: Symbols in a row, as arguments are, and what symbols stand for.
Symbols: TypeAlias = tuple[sp.Symbol, ...]
Names: TypeAlias = dict[sp.Symbol, sp.Expr]
#: Pairs of symbols, each for the cosine and the sine of one angle.
Circles = tuple[tuple[sp.Symbol, sp.Symbol], ...]


def expanded(expression: sp.Expr) -> sp.Expr:
    """Products and powers written out, but for denominators and exponentials.

    1/(1 − x)² keeps its sign over an interval, 1/(1 − 2x + x²) does not; and exp(−(x − 1)²) is at
    most 1, where factors of it, as exp(2 x), exceed all floats.
    """
    below = {
        node
        for node in expression.atoms(sp.Pow)
        if node.exp.is_Integer and node.exp.is_negative and node.base.is_Add
    }
    kept = {node: sp.Dummy() for node in below | expression.atoms(sp.exp)}
    return sp.expand(expression.xreplace(kept)).xreplace(
        {dummy: node for node, dummy in kept.items()}
    )


def reached(level: sp.Expr) -> sp.Expr:
    """1 where a level is not negative, −1 where it is: a border belongs to one of its sides."""
    return sp.sign(2 * sp.sign(level) + 1)


def quotients(expression: sp.Expr) -> list[sp.Pow]:
    """Quotients and roots in it: powers that are no products."""
    return [
        node
        for node in expression.atoms(sp.Pow)
        if not (node.exp.is_Integer and node.exp.is_positive)
    ]


def reduce_circles(polynomial: sp.Expr, circles: Circles) -> sp.Expr:
    """Normal form of a polynomial modulo cos² = 1 − sin² on each unit circle."""
    polynomial = sp.expand(polynomial)
    for cosine, sine in circles:
        if not polynomial.has(cosine):
            continue
        even_odd = [sp.S.Zero, sp.S.Zero]
        for (power,), coefficient in sp.Poly(polynomial, cosine).terms():
            even_odd[power % 2] += coefficient * (1 - sine**2) ** (power // 2)
        polynomial = sp.expand(even_odd[0] + cosine * even_odd[1])
    return polynomial


def fewest_terms(polynomial: sp.Expr, cosine: sp.Symbol, sine: sp.Symbol) -> sp.Expr:
    """By c² + s² = 1 either square may go: whichever leaves fewer terms."""
    forms = (reduce_circles(polynomial, (pair,)) for pair in ((cosine, sine), (sine, cosine)))
    return min(forms, key=lambda form: len(sp.Add.make_args(form)))


def difference(left: sp.Expr, right: sp.Expr, circles: Circles) -> sp.Expr:
    """``left − right`` in normal form: 0 exactly when the two are equal as functions on the unit
    circles.

    Every absolute value, sign or other function is treated as an independent unknown, and so is one
    root of every base, of which its powers are powers, and one exponential of all whose exponents
    are rational multiples of each other. An equality that holds only because of a relation between
    two of them is not recognised; arguments and bases that are equal as polynomials on the circles
    are the same.
    """

    def normal(argument: sp.Expr) -> sp.Expr:
        return (
            reduce_circles(argument, circles)
            if argument.is_polynomial(*argument.free_symbols)
            else argument
        )

    def unknown(node: sp.Expr) -> sp.Expr:
        """What stands for a function, or for the case that it is."""
        if not isinstance(node, sp.Function):
            return named(node)
        arguments = [normal(argument) for argument in node.args]
        if not isinstance(node, sp.exp):
            return named(node.func(*arguments))
        times, exponent = arguments[0].as_content_primitive()
        if exponent.could_extract_minus_sign():
            times, exponent = -times, -exponent
        return named(sp.exp(exponent)) ** times

    def named(node: sp.Expr) -> sp.Dummy:
        return unknowns.setdefault(node, sp.Dummy(f"u{len(unknowns)}"))

    unknowns: dict[sp.Expr, sp.Dummy] = {}
    gap = (sp.sympify(left) - sp.sympify(right)).replace(
        lambda node: isinstance(node, sp.Function | sp.Piecewise),
        unknown,
    )
    order = math.lcm(*(node.exp.q for node in gap.atoms(sp.Pow) if node.exp.is_Rational))
    roots: dict[sp.Expr, sp.Dummy] = {}
    gap = gap.replace(
        lambda node: isinstance(node, sp.Pow) and not node.exp.is_Integer,
        lambda node: (
            roots.setdefault(normal(node.base), sp.Dummy(f"r{len(roots)}")) ** (order * node.exp)
        ),
    )
    numerator, denominator = sp.fraction(sp.together(gap))
    for base, root in reversed(roots.items()):
        numerator, further = sp.fraction(sp.together(_without_powers(numerator, root, base, order)))
        denominator *= further
    numerator = reduce_circles(numerator, circles)
    if numerator == 0:
        return sp.S.Zero
    known = {root: sp.Pow(base, sp.Rational(1, order)) for base, root in reversed(roots.items())}
    shown = numerator / sp.factor(denominator)
    for root, value in known.items():
        shown = shown.subs(root, value)
    # The outermost first, for its arguments hold the others.
    return shown.subs([(dummy, node) for node, dummy in reversed(unknowns.items())])


def _without_powers(polynomial: sp.Expr, root: sp.Symbol, base: sp.Expr, order: int) -> sp.Expr:
    """Normal form modulo root^order = base."""
    terms = sp.Poly(sp.expand(polynomial), root).terms()
    return sp.Add(
        *(value * base ** (power // order) * root ** (power % order) for (power,), value in terms)
    )


def manifestly_positive(polynomial: sp.Expr) -> bool:
    """Whether no coefficient is negative, and one term holds none but positive symbols: sufficient
    for being positive, not necessary.
    """
    symbols = sorted(polynomial.free_symbols, key=str)
    terms = sp.Poly(sp.expand(polynomial), *symbols).terms()
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
