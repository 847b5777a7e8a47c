"""Straight-line code of a function: shorthands in order, powers as products, and every common
subexpression computed once.
"""

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import sympy as sp
from sympy import Expr, Symbol

from ..algebra import Names, Row
from .definitions import flat
from .function import Function, Results


@dataclass(frozen=True)
class Body:
    """The straight-line code of a function: assignments in order, and nested results."""

    assignments: tuple[tuple[Symbol, Expr], ...]
    results: Results
    powers: frozenset[Symbol] = frozenset()  #: names of integer powers of other names

    @cached_property
    def negated(self) -> Mapping[Symbol, Expr]:
        """Names for the negative of another name, which are replaced where they occur; except those
        of which a power is taken.
        """
        wholes = (*dict(self.assignments).values(), *flat(self.results))
        bases = {power.base for whole in wholes for power in whole.atoms(sp.Pow)}
        return {
            symbol: value
            for symbol, value in self.assignments
            if (-value).is_Symbol and symbol not in bases
        }

    @cached_property
    def _computed(self) -> list[Expr]:
        """All computed expressions, with negated names replaced."""
        values = (value for symbol, value in self.assignments if symbol not in self.negated)
        return [value.xreplace(self.negated) for value in (*values, *flat(self.results))]

    @cached_property
    def inlined(self) -> Mapping[Symbol, Expr]:
        """Names without a statement of their own, with their expressions: a power that is used
        once, a second name of a value, a negated name.
        """
        used = Counter(part for whole in self._computed for part in sp.preorder_traversal(whole))
        kept = {
            symbol: value
            for symbol, value in self.assignments
            if value.is_Symbol or (symbol in self.powers and used[symbol] == 1)
        }
        return {**kept, **self.negated}

    @property
    def operations(self) -> int:
        """The number of operations."""
        return sum(int(sp.count_ops(value)) for value in self._computed)

    @property
    def statements(self) -> list[tuple[Symbol, Expr]]:
        """The assignments that are printed."""
        return [(symbol, value) for symbol, value in self.assignments if symbol not in self.inlined]


def straight_line(function: Function) -> Body:
    """The straight-line code of a function, with common subexpressions eliminated."""
    leaves = tuple(flat(function.results))
    named = _needed(leaves, function)
    powers = _Powers({str(symbol) for symbol in (*function.accepted, *function.shorthands)})
    expressions = [powers.replace(expression) for _, expression in named]
    leaves = tuple(powers.replace(leaf) for leaf in leaves)
    definitions = dict(powers.definitions)
    everything = [*expressions, *definitions.values(), *leaves]
    # By name, since symbols of one name with other assumptions are not equal.
    free = (symbol for symbol in sp.numbered_symbols("w") if str(symbol) not in powers.taken)
    temporaries, reduced = sp.cse(everything, symbols=free)
    # The elimination makes new powers, as of exp(x) and exp(2 x).
    again = _Powers(
        {str(symbol) for symbol in (*function.accepted, *function.shorthands, *definitions)}
    )
    temporaries = [(symbol, again.rest(expression)) for symbol, expression in temporaries]
    reduced = [again.rest(expression) for expression in reduced]
    count, extra = len(expressions), len(definitions)
    available = dict(temporaries)
    available.update(zip((symbol for symbol, _ in named), reduced[:count], strict=True))
    available.update(zip(definitions, reduced[count : count + extra], strict=True))
    available.update(again.definitions)
    outputs = reduced[count + extra :]
    # A common subexpression that is also the base of a power has two names; its powers are named
    # after the wrong one.
    second = {
        symbol: available.pop(symbol) for symbol in definitions if available[symbol].is_Symbol
    }
    for symbol in definitions:
        base, _, exponent = str(symbol).rpartition("_")
        if (of := Symbol(base, real=True)) in second:
            second[symbol] = Symbol(powers.free(f"{second[of]}_{exponent}"), real=True)
    available = {
        second.get(symbol, symbol): expression.xreplace(second)
        for symbol, expression in available.items()
    }
    outputs = [sp.sympify(expression).xreplace(second) for expression in outputs]

    ordered: Names = {}
    for root in [*(symbol for symbol, _ in named), *outputs]:
        _place(root, available, ordered)
    of_powers = {second.get(symbol, symbol) for symbol in definitions} | again.definitions.keys()
    whole = {
        it
        for it in of_powers & ordered.keys()
        if ordered[it].is_Mul or (ordered[it].is_Pow and ordered[it].exp == 2)
    }
    return Body(tuple(ordered.items()), _refill(function.results, iter(outputs)), frozenset(whole))


def _needed(leaves: Row, function: Function) -> list[tuple[Symbol, Expr]]:
    """The shorthands that the results use, each after those that it uses itself.

    Raises
    ------
    ArithmeticError
        If a symbol is neither an argument nor a shorthand.
    """
    ordered: Names = {}
    shorthands = {
        symbol: value
        for symbol, value in function.shorthands.items()
        if symbol not in function.accepted
    }
    for leaf in leaves:
        _place(leaf, shorthands, ordered)
    for expression in (*leaves, *ordered.values()):
        for symbol in expression.free_symbols - {*function.accepted, *ordered}:
            raise ArithmeticError(
                f"{function.name}: {symbol} is neither an argument nor a shorthand"
            )
    return list(ordered.items())


class _Powers:
    """Replaces powers by named products, so that a number type needs no powers.

    Integer powers become products of smaller ones, each computed once; squares too, since some
    interval libraries cannot square a ball around zero. Fractional powers become products of a
    root. A name that the function itself uses, as ``sigma_2`` may be, is not given to a power.
    """

    def __init__(self, taken: set[str]) -> None:
        self.definitions: Names = {}
        self.taken = taken

    def replace(self, expression: Expr) -> Expr:
        return sp.sympify(expression).replace(
            lambda node: isinstance(node, sp.Pow) and node.exp.is_Rational and abs(node.exp.p) > 1,
            self._named,
        )

    def rest(self, expression: Expr) -> Expr:
        """Replace powers, unless the whole expression is the square of a name."""
        if isinstance(expression, sp.Pow) and expression.exp == 2 and expression.base.is_Symbol:
            return expression
        return self.replace(expression)

    def _named(self, node: sp.Pow) -> Expr:
        power = (
            self._power(node.base, abs(int(node.exp)))
            if node.exp.is_Integer
            else self._root_power(node.base, abs(node.exp))
        )
        return power if node.exp > 0 else 1 / power

    def _root_power(self, base: Expr, exponent: sp.Rational) -> Expr:
        value = sp.Pow(base, sp.Rational(1, exponent.q))
        root = self._once("root", value)
        whole, part = divmod(exponent.p, exponent.q)
        return (self._power(base, whole) if whole else sp.S.One) * self._power(root, part)

    def _once(self, stem: str, value: Expr) -> Symbol:
        """The name of a value: that which it has already, or a new one."""
        new = Symbol(self.free(f"{stem}{len(self.definitions)}"), real=True)
        symbol = next(
            (symbol for symbol, definition in self.definitions.items() if definition == value), new
        )
        self.definitions.setdefault(symbol, value)
        return symbol

    def free(self, name: str) -> str:
        while name in self.taken:
            name += "_"
        return name

    def _power(self, base: Expr, exponent: int) -> Expr:
        if exponent == 1:
            return base
        if not base.is_Symbol:
            base = self._once("base", base)
        # Always with the same assumptions: otherwise SymPy takes them for different symbols.
        symbol = Symbol(self.free(f"{base}_{exponent}"), real=True)
        if symbol not in self.definitions:
            low, high = exponent // 2, exponent - exponent // 2
            halves = self._power(base, low), self._power(base, high)
            self.definitions[symbol] = sp.Pow(halves[0], 2) if low == high else sp.Mul(*halves)
        return symbol


def _place(root: Expr, available: Names, ordered: Names) -> None:
    """Add the symbols that an expression needs to ``ordered``, each after those that it needs."""
    if root.is_Symbol and (root in ordered or root not in available):
        return
    whole = available[root] if root.is_Symbol else root
    for symbol in sorted(whole.free_symbols, key=str):
        _place(symbol, available, ordered)
    if root.is_Symbol:
        ordered[root] = whole


def _refill(shape: Results, leaves: Iterator[Expr]) -> Results:
    """Leaves nested as in a shape."""
    if isinstance(shape, tuple):
        return tuple(_refill(item, leaves) for item in shape)
    return next(leaves)
