"""Derivations with a fault, told where it stands; and the same ones in another style, told right.

Two cases of three plant a fault into a paper of ``validation/derivations``: in a definition that several
rows use, in the last member of a chain, in another row, in a matrix of states in another order, or
one fault copied into two rows. These rows and no others must be wrong, and the paper right with
their repairs (``true``, of the ``planted``). Every third case prints a right paper in another style: all
its rows (``rows``) must stay right, or be unread (``unread``).
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp
from numpy.random import Generator

from spragsym.derive import pages
from spragsym.derive.statements import papers, verdicts
from spragsym.derive.statements.book import with_defined
from spragsym.derive.statements.reading import Item, read_paper
from spragsym.derive.statements.repair import evaluated, same
from spragsym.derive.statements.tree import (
    Equation,
    Node,
    leaf,
    printed,
    renamed,
    residual,
    symbols,
    tidied,
    to_sympy,
)

from .printed_faults import differs, planted

CASES = 450
FOLDER = Path(__file__).parent / "derivations"
FAULTS = ("definition", "row", "copied", "chain", "definition", "row", "copied", "order")
STYLES = ("swapped", "multiplied", "moved", "written out", "expanded", "inserted", "order")
#: Three orders of the states of two coordinates.
ORDERS = ((0, 1, 2, 3), (0, 2, 1, 3), (2, 3, 0, 1))


class Derived:
    """A right derivation: its statements as they are read, and its page."""

    def __init__(self, path: Path) -> None:
        self.paper = papers.read(path)
        self.model = pages.read(path.parent / self.paper.model, only_equations=True)
        self.book, found = read_paper(self.paper, self.model)
        self.items = {it.statement.id: it for it in found if isinstance(it, Item)}
        #: equations with which each statement is written: what it defines, and what it claims
        self.prints: dict[str, list[Equation]] = {it.id: [] for it in self.paper.statements}
        for name, id in self.book.definers.items():
            self.prints[id].append(Equation(leaf(name), self.book.defined[name]))
        for id, item in self.items.items():
            self.prints[id] += item.equations
        self.derivation = next(iter(self.items.values())).derivation

    def users(self, name: str) -> list[str]:
        """The rows whose verdicts depend on a definition."""
        own = self.book.definers[name]
        return [id for id, it in self.items.items() if id != own and name in it.defined]

    def verdicts(
        self, changed: Mapping[str, str], order: Sequence[str] = ()
    ) -> dict[str, verdicts.Row]:
        """The verdicts with other texts of some statements, in an order."""
        known = {it.id: it for it in self.paper.statements}
        known |= {id: replace(known[id], text=it, is_latex=False) for id, it in changed.items()}
        statements = tuple(known[id] for id in order or known)
        return {
            row.id: row
            for row in verdicts.check(replace(self.paper, statements=statements), self.model).rows
        }


@cache
def derivations() -> list[Derived]:
    """All papers of the folder."""
    return [Derived(path) for path in sorted(FOLDER.glob("*.toml"))]


def judge(number: int, rng: Generator) -> dict[str, Any]:
    """One paper with a fault, or in one style."""
    is_style = number % 3 == 2
    place = number // 3 if is_style else number - number // 3
    kinds = STYLES if is_style else FAULTS
    kind = kinds[place % len(kinds)]
    while True:
        it = derivations()[int(rng.integers(len(derivations())))]
        found = _in_style(it, kind, rng) if is_style else _with_fault(it, kind, rng)
        if found is not None:
            return {"kind": f"{'style' if is_style else 'fault'} {kind}", **found}


def _text(equations: Sequence[Equation]) -> str:
    return "; ".join(f"{printed(it.left)} = {printed(it.right)}" for it in equations)


# ------------------------------------------------------------------------------------------------
# faults


def _with_fault(it: Derived, kind: str, rng: Generator) -> dict[str, Any] | None:
    """What is told of a fault; None where this paper has no place for it."""
    for _ in range(100):
        changed = _faulty(it, kind, rng)
        if changed is None:
            return None
        if changed and all(_is_other(it, id, new) for id, new in changed.items()):
            break
    else:
        return None
    texts = {id: _text(new) for id, new in changed.items()}
    rows = it.verdicts(texts)
    said = "; ".join(texts.values())
    right = [id for id in texts if rows[id].status in verdicts.RIGHT]
    others = [
        id for id, row in rows.items() if id not in texts and row.status not in verdicts.RIGHT
    ]
    wrong = [f"{said}: {id} {rows[id].status}" for id in (*right, *others)]
    repaired = [id for id in texts if rows[id].repaired]
    mended = {id: rows[id].repaired for id in repaired if id not in it.items}
    again = it.verdicts(mended) if mended else {}  # the repairs of other rows are proved
    true = len(repaired) == len(texts) and all(
        row.status in verdicts.RIGHT for row in again.values()
    )
    return {"wrong": wrong, "planted": 1, "true": int(true)}


def _faulty(it: Derived, kind: str, rng: Generator) -> dict[str, list[Equation]] | None:
    """New equations of the statements that get a fault, by their ids."""
    plain = [
        id for id, one in it.items.items() if one.statement.word not in ("definition", "system")
    ]
    match kind:
        case "definition":
            names = [name for name in it.book.defined if len(it.users(name)) > 1]
            ids = [it.book.definers[name] for name in names]
            ids = [id for id in ids if id not in it.items]
        case "chain":
            ids = [id for id, one in it.items.items() if one.statement.word == "definition"]
        case "order":
            ids = [id for id, one in it.items.items() if one.statement.word == "system"]
        case "copied":
            two = [str(one) for one in rng.choice(plain, 2, replace=False)]
            held = (_names(it.prints[id]) & it.derivation.parameters.keys() for id in two)
            if not (shared := sorted(set.intersection(*map(set, held)))):
                return {}
            name = str(rng.choice(shared))
            twice = Node("mul", (Node("number", value="2"), leaf(name)))
            new = {name: twice if rng.random() < 0.5 else Node("neg", (leaf(name),))}
            return {id: [_renamed(one, new) for one in it.prints[id]] for id in two}
        case _:
            ids = plain
    if not ids:
        return None
    id = str(rng.choice(sorted(set(ids))))
    equations = it.prints[id]
    if kind == "order":
        equations = _ordered(equations, ORDERS[int(rng.integers(3))])
        places = [place for place, one in enumerate(equations) if len(symbols(one.right)) > 1]
        place = int(rng.choice(places))
    else:
        place = len(equations) - 1
    one = equations[place]
    is_left = printed(one.right) == "0" or (one.left.kind != "symbol" and rng.random() < 0.3)
    side = planted(one.left if is_left else one.right, it.derivation, rng)
    if printed(tidied(side)) != printed(side):  # as v - v, which nobody prints
        return {}
    new_one = replace(one, left=side) if is_left else replace(one, right=side)
    return {id: [*equations[:place], new_one, *equations[place + 1 :]]}


def _names(equations: Sequence[Equation]) -> frozenset[str]:
    return frozenset().union(*(symbols(it.left) | symbols(it.right) for it in equations))


def _renamed(equation: Equation, names: Mapping[str, Node]) -> Equation:
    return replace(
        equation, left=renamed(equation.left, names), right=renamed(equation.right, names)
    )


def _ordered(entries: Sequence[Equation], order: Sequence[int]) -> list[Equation]:
    """The entries of a matrix of states in another order of these."""
    size = len(order)
    places = [(i, j) for i in order for j in order]
    pairs = zip(entries, places, strict=True)
    return [replace(one, right=entries[size * i + j].right) for one, (i, j) in pairs]


def _is_other(it: Derived, id: str, new: Sequence[Equation]) -> bool:
    """Whether the last equation that changed says something else."""
    item, old = it.items.get(id), it.prints[id]
    if item is not None and item.statement.word != "system":
        return differs(item, old[-1], new[-1])
    one = item or it.items[it.users(new[-1].left.value)[0]]
    values = with_defined(one.values, one.defined)
    found = []
    for equations in (old, new):
        sides = np.array([evaluated(each.right, values) for each in equations])
        found.append(np.sort(sides, axis=0))
    return not same(found[0].ravel(), found[1].ravel())


# ------------------------------------------------------------------------------------------------
# styles


def _in_style(it: Derived, kind: str, rng: Generator) -> dict[str, Any] | None:
    """What is told of a paper in another style."""
    order: list[str] = []
    texts: dict[str, str] = {}
    if kind == "moved":
        order = [str(id) for id in rng.permutation([*it.prints])]
    for id, item in it.items.items():
        new = _styled(it, item, kind, rng)
        if new:
            texts[id] = _text(new)
    if not (texts or order):
        return None
    rows = it.verdicts(texts, order)
    wrong = [
        f"{kind}, {id}: {texts.get(id, row.print)}: {row.status}"
        for id, row in rows.items()
        if row.status not in (*verdicts.RIGHT, "unread")
    ]
    unread = [id for id, row in rows.items() if row.status == "unread"]
    return {"wrong": wrong, "rows": len(texts) or len(rows), "unread": len(unread)}


def _styled(it: Derived, item: Item, kind: str, rng: Generator) -> list[Equation]:
    """The equations of a row in a style; none where it does not change."""
    equations, subject, word = it.prints[item.statement.id], item.subject, item.statement.word
    is_open = not subject.is_value and word != "definition"
    is_motion = word in ("motion", "equilibrium")
    (one,) = equations[-1:]
    match kind:
        case "order" if word == "system":
            return _ordered(equations, ORDERS[int(rng.integers(3))])
        case "swapped" if is_open:
            return [Equation(one.right, one.left)]
        case "multiplied" if is_motion:
            moving = [*map(str, it.derivation.parameters)]
            moving += map(str, it.derivation.model.rates if word == "motion" else ())
            factor = leaf(str(rng.choice(moving)))
            left, right = (Node("mul", (factor, side)) for side in (one.left, one.right))
            return [Equation(left, right)]
        case "written out" if word != "system":
            own = {name: tree for name, tree in it.book.defined.items() if name in item.defined}
            out = one
            for _ in own:
                out = _renamed(out, own)
            left = out.left if is_open or one.left.kind != "symbol" else one.left
            return [*equations[:-1], replace(out, left=left)]
        case "expanded" if word != "system":
            return [*equations[:-1], replace(one, right=_expanded(one.right))]
        case "inserted" if word == "motion":
            seconds = {str(name) for name in it.derivation.accelerations}
            others = [own for own in it.items.values() if own.statement.word == "motion"]
            for other in (own for own in others if own is not item):
                if (solved := _solved(other, seconds)) and solved[0] in symbols(one.left):
                    return [_renamed(one, dict([solved]))]
    return []


def _solved(item: Item, seconds: set[str]) -> tuple[str, Node] | None:
    """The acceleration that an equation of motion is the one for, and its value."""
    tree = residual(item.equations[0])
    names = {name: sp.Symbol(name) for name in symbols(tree)}
    second = f"a{item.statement.about.split()[1]}"
    whole = to_sympy(tree, names)
    if second not in names or len(seconds & names.keys()) < 2:
        return None
    slope = sp.diff(whole, names[second])
    value = sp.sstr((slope * names[second] - whole).expand() / slope)
    return second, Node("symbol", value=f"({value})")


def _expanded(tree: Node) -> Node:
    """A side with its products written out."""
    known = {name: sp.Symbol(name) for name in symbols(tree)}
    text = sp.sstr(sp.expand(to_sympy(tree, known)))
    return Node("symbol", value=text)
