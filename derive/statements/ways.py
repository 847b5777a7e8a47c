"""Ways in which papers mean an equation that is not right as it is read first."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, replace

import sympy as sp
from sympy import Dummy, Expr, S, Symbol

from .book import used
from .comparison import Comparison, Conventions, judged_side
from .objects import NoObject
from .reading import Item
from .repair import Values
from .samples import numeric
from .tree import ZERO, Equation, nodes, symbols

#: Words of objects that are printed to first order as they stand.
LINEARIZED = ("motion", "acceleration", "equilibrium", "balance")


@dataclass(frozen=True)
class Way:
    """A statement as it may be meant, and in words how."""

    item: Item
    said: str
    status: str = ""  #: the verdict where it is right so, if not its own
    is_usual: bool = False  #: whether what is wrong is repaired in this way too


def other_ways(item: Item, conventions: Conventions) -> Iterator[Way]:
    """The ways in which a statement may be meant besides the first."""
    yield from _with_size_of_friction(item)
    yield from _in_own_units(item)
    yield from _to_first_order(item, conventions)


def _with_size_of_friction(item: Item) -> Iterator[Way]:
    """The size of a friction coefficient whose law has a sign, as in μ N sgn v."""
    derivation = item.derivation
    sides = [side for one in item.equations for side in (one.left, one.right)]
    named = set().union(*map(symbols, sides))
    laws = zip(derivation.coefficients, derivation.speeds, strict=False)
    sizes: dict[str, Expr] = {str(mu): mu * sp.sign(v) for mu, v in laws if str(mu) in named}
    if sizes and any(part.value == "sign" for side in sides for part in nodes(side)):
        said = f"{', '.join(sizes)} is the size of the friction coefficient"
        yield Way(replace(item, meant=sizes), said, is_usual=True)


def _in_own_units(item: Item) -> Iterator[Way]:
    """The quantities that a scaled print lacks are 1, as its units."""
    derivation, subject = item.derivation, item.subject
    entries = [subject.entries[place] for place in subject.index]
    held = set().union(*(derivation.expanded(it).free_symbols for it in entries))
    own = [it.symbol for it in derivation.page.units]
    ones = {it: S.One for it in own if it in held}
    sides = [side for one in item.equations if (side := judged_side(item, one))]
    names = used([Equation(tree, ZERO) for tree, _ in sides], item.book)
    names |= {str(it) for name, at in item.bound.items() if name in names for it in at.free_symbols}
    if derivation.scaled or not ones or names & {*map(str, own)} or subject.law == "scale":
        return
    targets = tuple(entry.xreplace(ones) for entry in subject.entries)
    readings = tuple(replace(one, entry=one.entry.xreplace(ones)) for one in subject.readings)
    way = replace(
        item,
        subject=replace(subject, entries=targets, readings=readings),
        targets=tuple(numeric(entry, item.values) for entry in targets),
        readings=tuple(numeric(one.entry, item.values) for one in readings),
        limited=lambda value: item.limited(value).xreplace(ones),
        has_units=False,
    )
    said = f"in units in which {', '.join(map(str, ones))} = 1"
    is_scaled = len(ones) > 1  # a single one may be lost
    yield Way(way, said, "" if is_scaled else "convention", is_usual=is_scaled)


def _to_first_order(item: Item, conventions: Conventions) -> Iterator[Way]:
    """A print that is linear in coordinates in which its object is not."""
    statement, derivation, subject = item.statement, item.derivation, item.subject
    sides = [side for one in item.equations if (side := judged_side(item, one))]
    if statement.limit or statement.word not in LINEARIZED or not sides:
        return
    comparison = Comparison(item, conventions)
    own = [comparison.exactly(tree) for tree, _ in sides]
    entries = [derivation.expanded(subject.entries[place]) for place in subject.index]
    rows = [row for row in derivation.moved if row[0] != derivation.model.clock]
    small = [
        str(row[0]) for row in rows if not all(_is_linear(it, row, item.values) for it in entries)
    ]
    several = [it for row in rows if str(row[0]) in small for it in row]
    if small and all(_is_linear(derivation.expanded(it), several, item.values) for it in own):
        limit = f"linear in {', '.join(small)}"
        said = f"right to first order in {', '.join(small)}: say limit = {limit!r}"
        yield Way(replace(item, statement=replace(statement, limit=limit)), said, is_usual=True)


def _is_linear(value: Expr, small: Collection[Symbol], values: Mapping[str, Values]) -> bool:
    """Whether an expression is of first order in what is small together."""
    size = Dummy(positive=True)
    scaled = value.xreplace({it: size * it for it in small})
    if scaled.has(sp.sign, sp.Abs, sp.Piecewise) or _is_bent(value, small, values):
        return False
    return sp.expand(sp.diff(scaled, size, 2)) == 0


def _is_bent(value: Expr, small: Collection[Symbol], values: Mapping[str, Values]) -> bool:
    """Whether the samples show that an expression is not of first order, far beyond rounding.

    The second derivative of a long expression takes seconds.
    """
    try:
        one, two, three = (
            numeric(value, {**values, **{str(it): size * values[str(it)] for it in small}})
            for size in (1.0, 2.0, 3.0)
        )
    except (KeyError, NoObject):  # something has no value there
        return False
    far = 1e-6 * (abs(one) + abs(two) + abs(three))
    return bool((abs(three - 2.0 * two + one) > far).any())
