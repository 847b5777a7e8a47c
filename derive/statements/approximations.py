"""Limits that statements name, in which a print is what is derived."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import sympy as sp
from sympy import Dummy, Expr, S, Symbol

from .comparison import Comparison, Component
from .reading import Item
from .samples import numeric


@dataclass(frozen=True)
class LimitCase:
    """A limit that a statement names: quantities, and where they go, each by itself or together; to
    an ``order`` in what is small together where that is not 0.
    """

    symbols: tuple[Symbol, ...]
    end: Expr = S.Zero
    together: bool = True
    order: int = 0

    def forms(self, value: Expr, it: Comparison) -> list[Expr]:
        """A value in its limit, once for each quantity that goes there by itself; nan where that is
        not found.
        """
        page = it.item.it
        named = it.laws(it.item.held.side) | {Symbol(one): at for one, at in page.geometry.items()}
        opened = {symbol: page.expanded(meaning) for symbol, meaning in named.items()}
        moving = {one: at for one, at in opened.items() if at.free_symbols & {*self.symbols}}
        value, size = value.xreplace(moving), Dummy(positive=True)
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


def limit_of(item: Item) -> LimitCase | None:
    """The limit of a statement, as ``d*V -> oo``, ``c_x, c_y -> 0``, ``linear in x, y`` or
    ``cubic in x``; None where what stands there is none.
    """
    word, to_order, small = item.statement.limit.partition(" in ")
    order = {"linear": 1, "quadratic": 2, "cubic": 3}.get(word, 0) if to_order else 0
    what, arrow, end = (small if order else item.statement.limit).partition("->")
    end, together = end.strip() or "0", "*" not in what
    names = item.it.names
    symbols = [names.get(it.strip(), sp.nan) for it in what.split("," if together else "*")]
    if not all(it.is_Symbol for it in symbols) or bool(order) is bool(arrow):
        return None
    if end not in ("oo", "0") or (together and end == "oo" and len(symbols) > 1):
        return None
    return LimitCase(tuple(symbols), sp.sympify(end), together, order)


def is_approximation(it: Comparison, part: Component, limit: LimitCase) -> bool:
    """Whether a print and what is derived have the same limit, whatever else they hold."""
    ours = limit.forms(it.exactly(part.tree), it)
    return any(all(map(it.equals, ours, limit.forms(exact, it))) for _, exact in part.targets)


def in_limit(item: Item, limit: LimitCase) -> Iterator[Item]:
    """A statement beside the limit of what is derived: of what is small to some order with its
    rates and accelerations as well.
    """
    page, held = item.it, item.held
    rows = zip(page.model.coordinates, page.model.rates, page.accelerations, strict=True)
    more = tuple(it for row in rows if {*row} & {*limit.symbols} for it in row)
    small = (*limit.symbols, *more)
    ways = [limit, replace(limit, symbols=tuple(dict.fromkeys(small)))]
    for way in ways if limit.order else ways[:1]:
        it = Comparison(item)
        entries = tuple(
            way.forms(entry, it)[0] if place in held.index else entry
            for place, entry in enumerate(held.entries)
        )
        readings = tuple(replace(one, entry=way.forms(one.entry, it)[0]) for one in held.readings)
        yield replace(
            item,
            held=replace(held, entries=entries, readings=readings),
            targets=tuple(numeric(entry, item.values) for entry in entries),
            readings=tuple(numeric(one.entry, item.values) for one in readings),
        )


def _limit(value: Expr, at: Symbol, end: Expr) -> Expr:
    """The limit of a value where nonnegative parameters are positive; nan where it is not found."""
    positive = {it: Dummy(it.name, positive=True) for it in value.free_symbols if it.is_nonnegative}
    value, at = value.xreplace(positive), positive.get(at, at)
    positive |= {it: Dummy(positive=True) for it in value.atoms(sp.Abs) if not it.has(at)}
    found = _finite(_part_by_part(value.xreplace(positive), at, end))
    return found.xreplace({symbol: it for it, symbol in reversed(positive.items())})


def _finite(value: Expr) -> Expr:
    return sp.nan if value.has(sp.nan, sp.oo, -sp.oo, sp.zoo, sp.AccumBounds) else value


def _part_by_part(value: Expr, at: Symbol, end: Expr) -> Expr:
    """The limit of a value from those of its parts, where they give one."""
    if at not in value.free_symbols:
        return value
    if value == at:
        return end
    parts = [_part_by_part(part, at, end) for part in value.args]
    found = value.func(*parts)
    is_jump = isinstance(value, sp.sign) and found == 0
    if not is_jump and _finite(found) is not sp.nan:
        return found
    fixed, moving = value.as_independent(at)
    # Operations of what SymPy's own limit is asked for.
    most = 200
    of_moving = sp.limit(moving, at, end) if sp.count_ops(moving) < most else sp.nan
    return value.func(fixed, of_moving) if value.is_Add or value.is_Mul else of_moving
