"""Limits that statements name, as ``d*V -> oo`` or ``linear in x``, in which the print holds."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import cast

import sympy as sp
from sympy import Dummy, Expr, S, Symbol

from .comparison import Comparison, Component, Convention, Conventions
from .identities import normal_form
from .reading import Item
from .samples import numeric
from .tree import Unread, Vocabulary, read_sympy, to_sympy


@dataclass(frozen=True)
class LimitCase:
    """A limit that a statement names.

    The ``symbols`` tend to ``end``, all ``together`` or each alone. If ``order`` is not 0, the
    limit is the Taylor polynomial of that order in the symbols together. At an end of 0 a symbol
    has the value in ``places``, 0 if there is none.
    """

    symbols: tuple[Symbol, ...]
    end: Expr = S.Zero
    together: bool = True
    order: int = 0
    places: Mapping[Symbol, Expr] = field(default_factory=dict)

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
            places = {one: self.places.get(one, S.Zero) for one in self.symbols}
            value = value.xreplace({one: at + size * (one - at) for one, at in places.items()})
        if not self.order:
            return [_limit(value, size if self.end == 0 else self.symbols[0], self.end)]
        terms = [value.subs(size, 0)]
        for order in range(1, self.order + 1):
            value = sp.diff(value, size).replace(sp.DiracDelta, lambda *_: S.Zero)  # between jumps
            terms.append(value.subs(size, 0) / math.factorial(order))
        return [_finite(sp.Add(*terms))]


def limit_of(item: Item, conventions: Conventions | None = None) -> LimitCase:
    """The limit of a statement, as ``d*V -> oo``, ``c_x, c_y -> 0``, ``x -> 0, theta -> pi``,
    ``linear in x, y`` or ``cubic in theta - pi``; a coordinate is the paper's, in its convention.

    Raises
    ------
    Unread
        Where what stands there is none, or is of a name that the page has not.
    """
    text, names = item.statement.limit, item.derivation.names
    word, to_order, small = text.partition(" in ")
    order = {"linear": 1, "quadratic": 2, "cubic": 3}.get(word, 0) if to_order else 0
    product, arrow, end = text.partition("->")
    if "*" in product and end.strip() in ("oo", "0"):
        listed = dict.fromkeys((it.strip() for it in product.split("*")), end.strip())
    else:
        listed = _small(small) if order else _ends(text)
    unknown = [it for it in listed if not getattr(names.get(it), "is_Symbol", False)]
    if (
        bool(order) is bool(arrow)
        or not all(listed.values())
        or ("oo" in listed.values() and "*" not in product and len(listed) > 1)
    ):
        said = "'d*V -> oo', 'c_x, c_y -> 0', 'linear in x, y', 'quadratic in x' or 'cubic in x'"
        raise Unread(f"limit = {text!r} is none; write as {said}, of names of the page")
    if unknown:
        said = f"{', '.join(unknown)} is no name of the page; known are {', '.join(sorted(names))}"
        raise Unread(f"limit = {text!r}: {said}")
    symbols = tuple(names[it] for it in listed)
    if "oo" in listed.values():
        return LimitCase(symbols, sp.oo, "*" not in product)
    fixed, places = {it: names[it] for it in item.derivation.parameters}, dict[Symbol, Expr]()
    for name, at in listed.items():
        try:
            tree = read_sympy(at, Vocabulary(frozenset(fixed), (), {}))[0].left
        except Unread as error:
            raise Unread(f"limit = {text!r}: {at!r} is no number of the page") from error
        convention = (conventions or {}).get(name, Convention())
        shift = item.derivation.measured(convention.shift)
        places[names[name]] = convention.sign * (to_sympy(tree, fixed) - shift)
    together = "*" not in product
    return LimitCase(symbols, S.Zero, together, order, {it: at for it, at in places.items() if at})


def _small(text: str) -> dict[str, str]:
    """What is small with the value about which it is, of ``x, theta - pi``."""
    parts = (it.partition("-") for it in text.split(","))
    return {name.strip(): at.strip() if minus else "0" for name, minus, at in parts}


def _ends(text: str) -> dict[str, str]:
    """What tends to a value with that value, of ``x, y -> 0, theta -> pi``; empty for none."""
    found: dict[str, str] = {}
    for part in reversed(text.split(",")):
        name, arrow, end = part.partition("->")
        found[name.strip()] = end.strip() if arrow else next(reversed(found.values()), "")
    return dict(reversed(found.items()))


def is_approximation(comparison: Comparison, part: Component, limit: LimitCase) -> bool:
    """Whether a printed side and one of its targets have the same limit, by exact algebra."""
    kept = comparison.item.kept

    def forms(exact: Expr) -> list[Expr]:
        if (key := (str(limit), exact)) not in kept:
            kept[key] = limit.forms(exact, comparison)
        return cast(list[Expr], kept[key])

    ours = limit.forms(comparison.exactly(part.tree), comparison)
    return any(all(map(comparison.equals, ours, forms(exact))) for _, exact in part.targets)


def cases(item: Item, limit: LimitCase) -> list[LimitCase]:
    """A limit, and of one to an order in coordinates a second one, in which their rates and
    accelerations are small too.
    """
    also_small = (it for row in item.derivation.moved if {*row} & {*limit.symbols} for it in row)
    symbols = tuple(dict.fromkeys((*limit.symbols, *also_small)))
    is_same = not limit.order or symbols == limit.symbols
    return [limit] if is_same else [limit, replace(limit, symbols=symbols)]


def in_limit(item: Item, limit: LimitCase) -> list[Item]:
    """The statement with its object replaced by the object's limit, in every case of it."""
    key = "in limit", str(limit)
    if key not in item.kept:
        item.kept[key] = [_in_case(item, case) for case in cases(item, limit)]
    return cast(list[Item], item.kept[key])


def _in_case(item: Item, case: LimitCase) -> Item:
    subject, comparison = item.subject, Comparison(item)

    def limited(value: Expr) -> Expr:
        return case.forms(value, comparison)[0]

    entries = tuple(
        limited(entry) if place in subject.index else entry
        for place, entry in enumerate(subject.entries)
    )
    readings = tuple(replace(one, entry=limited(one.entry)) for one in subject.readings)
    return replace(
        item,
        subject=replace(subject, entries=entries, readings=readings),
        targets=tuple(numeric(entry, item.values) for entry in entries),
        readings=tuple(numeric(one.entry, item.values) for one in readings),
        limited=limited,
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
