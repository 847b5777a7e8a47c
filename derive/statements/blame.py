"""Search for the one edit of one definition that makes the most wrong rows right."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from .book import Book, used, with_defined
from .comparison import Comparison, Component, Conventions
from .reading import ASSERTED, Item, read_statement
from .repair import Pool, Repair, Search, Values, evaluated, same
from .tree import Node, printed, symbols

Holds = Callable[[Item, Conventions], bool]


@dataclass(frozen=True)
class Mended:
    """A definition after one edit, and the rows that are right with it."""

    name: str
    repair: Repair
    rows: Mapping[str, Item]  #: as read with the mended definition, by their ids
    count: int  #: how many edits of the same cost do the same


def mended(
    wrong: Mapping[str, Item], right: Sequence[Item], conventions: Conventions, holds: Holds
) -> Mended | None:
    """The edit of one definition that makes the most rows right, the cheapest of these; None where
    there is none that leaves all rows right that are.
    """
    best: list[Mended] = []
    for name, rows in _users(wrong).items():
        book, found = next(iter(rows.values())).book, list[Mended]()
        if _is_held_twice(name, book.definers[name], right):
            continue
        others = [it for it in right if name in used(it.equations, book)]
        for repair in _candidates(name, [*rows.values()], conventions):
            if found and repair.cost > found[0].repair.cost + 0.01:
                break
            changed = replace(book, defined={**book.defined, name: repair.tree})
            again = {id: it for id, one in rows.items() if (it := _again(one, changed))}
            near = [
                it
                for it in again.values()
                if it.statement.limit or Comparison(it, conventions).agrees
            ]
            if not any(holds(it, conventions) for it in near):
                continue
            held = {id: it for id, it in again.items() if holds(it, conventions)}
            if all((it := _again(one, changed)) and holds(it, conventions) for one in others):
                found.append(Mended(name, repair, held, 1))
        if found:
            most = max(found, key=lambda it: len(it.rows))
            same_size = sum(len(it.rows) == len(most.rows) for it in found)
            best.append(replace(most, count=same_size))
    return min(best, key=lambda it: (-len(it.rows), it.repair.cost), default=None)


def _users(wrong: Mapping[str, Item]) -> dict[str, dict[str, Item]]:
    """The rows that use each defined name; without the statement that defines it."""
    found: dict[str, dict[str, Item]] = {}
    for id, item in wrong.items():
        book = item.book
        names = (used(item.equations, book) & book.definers.keys()) - book.multipliers
        for name in sorted(names):
            if book.definers[name] != id:
                found.setdefault(name, {})[id] = item
    return found


def _is_held_twice(name: str, definer: str, right: Sequence[Item]) -> bool:
    """Whether the statement that defines a name gives it the same value again, as in a = b = c."""
    own = (it for item in right if item.statement.id == definer for it in item.equations)
    return any(name in symbols(it.left) for it in own)


def _again(item: Item, book: Book) -> Item | None:
    """A statement read with the names of another book."""
    found = read_statement(item.statement, book)
    return found if isinstance(found, Item) else None


def _candidates(name: str, rows: Sequence[Item], conventions: Conventions) -> list[Repair]:
    """Edits of a definition after which one of the rows may be right, the cheapest first."""
    tree, found = rows[0].book.defined[name], dict[str, Repair]()
    for item in rows[:3]:
        slopes = {it.of for it in item.slopes.values()}
        search = Search(tree, _pool(name, tree, item))
        comparison, needs = Comparison(item, conventions), list[Values]()
        if item.statement.word not in ASSERTED and not slopes:
            for part in comparison.components():
                needs += _needed(name, part, comparison)
        few = [it for it in search.firsts if it.edits[0].kind not in ("symbol", "exponent")]
        # Where what is needed is not known, as of a speed whose sign alone counts, few are tried.
        repairs = [one for one, _ in search.repairs(np.array(needs))] if needs else few[:80]
        for repair in repairs:
            found.setdefault(printed(repair.tree), repair)
    return sorted(found.values(), key=lambda it: (it.cost, len(printed(it.tree))))


def _pool(name: str, tree: Node, item: Item) -> Pool:
    """The names that an edit of a definition may bring in."""
    derivation = item.derivation
    moving = {*map(str, derivation.accelerations), *map(str, derivation.model.rates)}
    own = symbols(tree)
    names = own | (derivation.free - (set() if own & moving else moving)) - {name, "lam", "t"}
    values = with_defined(item.values, item.defined)
    return Pool({it: values[it] for it in sorted(names) if it in values}, derivation.kinds)


def _needed(name: str, part: Component, comparison: Comparison) -> Iterator[Values]:
    """Values of a name for which a side has those of a target, by the secant method."""
    item = comparison.item
    others = {it: tree for it, tree in item.defined.items() if it != name}
    for target, _ in part.targets[:6]:

        def value(at: Values) -> Values:
            return evaluated(part.tree, with_defined({**item.values, name: at}, others))

        before = comparison.values[name]
        after = before * 1.01 + 1e-3
        with np.errstate(all="ignore"):
            gap = value(before) - target
            for _ in range(40):
                next_gap = value(after) - target
                step = next_gap * (after - before) / (next_gap - gap)
                before, gap = after, next_gap
                after = after - np.where(np.isfinite(step), step, 0.0)
        if same(value(after), target):
            yield after
