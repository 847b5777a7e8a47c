"""Limits that statements name, as ``d*V -> oo`` or ``linear in x``, in which the print holds."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import sympy as sp
from sympy import Dummy, Expr, S, Symbol

from .comparison import Comparison, Component
from .identities import normal_form
from .reading import Item
from .samples import numeric
from .tree import Unread


@dataclass(frozen=True)
class LimitCase:
    """A limit that a statement names.

    The ``symbols`` tend to ``end``, all ``together`` or each alone. If ``order`` is not 0, the
    limit is the Taylor polynomial of that order in the symbols together.
    """

    symbols: tuple[Symbol, ...]
    end: Expr = S.Zero
    together: bool = True
    order: int = 0

    def forms(self, value: Expr, comparison: Comparison) -> list[Expr]:
        """The limit of an expression: one expression, or one for each symbol that tends alone.

        A limit that is not found is nan.
        """
        derivation = comparison.item.derivation
        named = comparison.laws(comparison.item.subject.side) | {
            Symbol(one): at for one, at in derivation.geometry.items()
        }
        expanded = {symbol: derivation.expanded(meaning) for symbol, meaning in named.items()}
        depending = {one: at for one, at in expanded.items() if at.free_symbols & {*self.symbols}}
        value, size = value.xreplace(depending), Dummy(positive=True)
        if not self.together:
            return [_limit(value, one, self.end) for one in self.symbols]
        if self.end == 0:
            value = value.xreplace({one: size * one for one in self.symbols})
        if not self.order:
            return [_limit(value, size if self.end == 0 else self.symbols[0], self.end)]
        terms = [value.subs(size, 0)]
        for order in range(1, self.order + 1):
            value = sp.diff(value, size).replace(sp.DiracDelta, lambda *_: S.Zero)  # between jumps
            terms.append(value.subs(size, 0) / math.factorial(order))
        return [_finite(sp.Add(*terms))]


def limit_of(item: Item) -> LimitCase:
    """The limit of a statement, as ``d*V -> oo``, ``c_x, c_y -> 0``, ``linear in x, y`` or
    ``cubic in x``.

    Raises
    ------
    Unread
        Where what stands there is none, or is of a name that the page has not.
    """
    text, names = item.statement.limit, item.derivation.names
    word, to_order, small = text.partition(" in ")
    order = {"linear": 1, "quadratic": 2, "cubic": 3}.get(word, 0) if to_order else 0
    what, arrow, end = (small if order else text).partition("->")
    end, together = end.strip() or "0", "*" not in what
    listed = [it.strip() for it in what.split("," if together else "*")]
    is_known = end in ("oo", "0") and not (together and end == "oo" and len(listed) > 1)
    if not is_known or bool(order) is bool(arrow):
        said = "'d*V -> oo', 'c_x, c_y -> 0', 'linear in x, y', 'quadratic in x' or 'cubic in x'"
        raise Unread(f"limit = {text!r} is none; write as {said}, of names of the page")
    if unknown := [it for it in listed if not getattr(names.get(it), "is_Symbol", False)]:
        said = f"{', '.join(unknown)} is no name of the page; known are {', '.join(sorted(names))}"
        raise Unread(f"limit = {text!r}: {said}")
    return LimitCase(tuple(names[it] for it in listed), sp.sympify(end), together, order)


def is_approximation(comparison: Comparison, part: Component, limit: LimitCase) -> bool:
    """Whether a printed side and one of its targets have the same limit, by exact algebra."""
    ours = limit.forms(comparison.exactly(part.tree), comparison)
    return any(
        all(map(comparison.equals, ours, limit.forms(exact, comparison)))
        for _, exact in part.targets
    )


def in_limit(item: Item, limit: LimitCase) -> Iterator[Item]:
    """The statement with its object replaced by the object's limit.

    If coordinates are small to some order, a second version takes their rates and accelerations as
    small too.
    """
    derivation, subject = item.derivation, item.subject
    also_small = (it for row in derivation.moved if {*row} & {*limit.symbols} for it in row)
    small = (*limit.symbols, *also_small)
    cases = [limit, replace(limit, symbols=tuple(dict.fromkeys(small)))]
    for case in cases if limit.order else cases[:1]:
        comparison = Comparison(item)
        entries = tuple(
            case.forms(entry, comparison)[0] if place in subject.index else entry
            for place, entry in enumerate(subject.entries)
        )
        readings = tuple(
            replace(one, entry=case.forms(one.entry, comparison)[0]) for one in subject.readings
        )
        yield replace(
            item,
            subject=replace(subject, entries=entries, readings=readings),
            targets=tuple(numeric(entry, item.values) for entry in entries),
            readings=tuple(numeric(one.entry, item.values) for one in readings),
        )


def _limit(value: Expr, symbol: Symbol, end: Expr) -> Expr:
    """The limit of an expression with positive parameters; nan if it is not found."""
    positive = {it: Dummy(it.name, positive=True) for it in value.free_symbols if it.is_nonnegative}
    value, symbol = value.xreplace(positive), positive.get(symbol, symbol)
    positive |= {it: Dummy(positive=True) for it in value.atoms(sp.Abs) if not it.has(symbol)}
    found = _finite(_part_by_part(value.xreplace(positive), symbol, end))
    return found.xreplace({symbol: it for it, symbol in reversed(positive.items())})


def _finite(value: Expr) -> Expr:
    return sp.nan if value.has(sp.nan, sp.oo, -sp.oo, sp.zoo, sp.AccumBounds) else value


def _part_by_part(value: Expr, symbol: Symbol, end: Expr) -> Expr:
    """The limit of an expression from the limits of its parts; by SymPy's limit if these are not
    finite or meet a jump.
    """
    if symbol not in value.free_symbols:
        return value
    if value == symbol:
        return end
    parts = [_part_by_part(part, symbol, end) for part in value.args]
    found = value.func(*parts)
    is_jump = isinstance(value, sp.sign) and found == 0
    if not is_jump and _finite(found) is not sp.nan:
        return found
    if value.is_rational_function(symbol):
        return _of_quotient(value, symbol, end)
    fixed, moving = value.as_independent(symbol)
    most = 200  # operations; SymPy's limit takes very long beyond
    of_moving = sp.limit(moving, symbol, end) if sp.count_ops(moving) < most else sp.nan
    return value.func(fixed, of_moving) if value.is_Add or value.is_Mul else of_moving


def _of_quotient(value: Expr, symbol: Symbol, end: Expr) -> Expr:
    """The limit of a quotient of polynomials in a symbol, by the powers that outweigh the others
    there; nan if it is not finite, or if such a coefficient of the denominator vanishes.
    """
    above, below = (
        sp.Poly(part, symbol).terms()[0 if end == sp.oo else -1]
        for part in sp.fraction(sp.together(value))
    )
    (power,), coefficient = below
    excess = above[0][0] - power if end == sp.oo else power - above[0][0]
    if normal_form(coefficient) == 0 or excess > 0:
        return sp.nan
    return above[1] / coefficient if excess == 0 else S.Zero
