"""Right equations of ``validation/papers`` in another convention: none may be called wrong.

A case is one paper, all of its right statements written with a coordinate reversed, with an angle
counted from another axis, from a moved origin, with sides swapped, or times a factor of parameters.
"""

import math
from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np

from spragsym.derive.statements import papers, verdicts
from spragsym.derive.statements.reading import Item
from spragsym.derive.statements.tree import Equation, Node, printed, renamed, symbols

from .printed_faults import Case, sources

CASES = 100
KINDS = ("reversed", "turned", "moved", "swapped", "factor")


@cache
def by_paper() -> list[list[Case]]:
    """Right statements with units, paper by paper; the article's misprints are left out with it."""
    found: dict[str, list[Case]] = {}
    for case in sources():
        is_shared = case.model.name == "kang_nam" or case.item.derivation.scaled
        if not is_shared and case.item.subject.law != "scale":
            found.setdefault(case.paper.title, []).append(case)
    return [cases for cases in found.values() if len(cases) > 1]


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One paper in one convention."""
    known = by_paper()
    cases = known[int(rng.integers(len(known)))]
    kind = KINDS[number % len(KINDS)]
    page = cases[0].model.page
    entries = [it for it in page.coordinates if (it.unit == "rad") is (kind == "turned")]
    if kind in ("swapped", "factor", "reversed"):
        entries = list(page.coordinates)
    lengths = [it for it in (*page.units, *page.parameters) if it.unit == "m"]
    if not entries or (kind == "moved" and not lengths):
        return {"kind": "not possible", "wrong": []}
    entry = entries[int(rng.integers(len(entries)))]
    name, sign = str(entry.symbol), -1 if kind == "reversed" else 1
    held = [{name for one in case.item.equations for name in names_in(one)} for case in cases]
    if kind in ("turned", "moved") and sum(name in names for names in held) < 2:
        return {"kind": "not possible", "wrong": []}  # of one row it is an edit
    shift: Node | None = None
    if kind == "turned":
        half = Node("div", (Node("number", value="pi"), Node("number", value="2")))
        shift = half if rng.random() < 0.5 else Node("number", value="pi")
    if kind == "moved":
        shift = Node("symbol", value=str(lengths[int(rng.integers(len(lengths)))].symbol))
    factor = Node("symbol", value=str(page.parameters[0].symbol)) if page.parameters else None
    statements = [*_definitions(cases[0], name, sign, shift)]
    for place, case in enumerate(cases):
        statements.append(_written(place, case.item, kind, name, sign, shift, factor))
    paper = papers.Paper("", "", {}, tuple(statements))
    rows = verdicts.check(paper, cases[0].model).rows
    wrong = [
        f"{kind} {name}: {row.print}: {row.status}"
        for row in rows
        if row.status not in ("confirmed", "definition")
    ]
    return {"kind": kind, "wrong": wrong}


def names_in(equation: Equation) -> frozenset[str]:
    """Names of the quantities of both sides."""
    return symbols(equation.left) | symbols(equation.right)


def _slopes(item: Item, name: str, sign: int) -> dict[str, Node]:
    """Derivatives by a coordinate that a print counts the other way."""
    found: dict[str, Node] = {}
    for own, slope in item.book.slopes.items():
        if (slope.by in (name, f"v{name}") and sign < 0) is not (slope.of in found):
            found[own] = Node("neg", (Node("symbol", value=own),))
    return found


def _names(name: str, sign: int, shift: Node | None) -> dict[str, Node]:
    """What stands in the print for a coordinate, its rate and its acceleration."""

    def signed(node: Node) -> Node:
        return Node("neg", (node,)) if sign < 0 else node

    symbols = [Node("symbol", value=it) for it in (name, f"v{name}", f"a{name}")]
    if shift is not None:
        symbols[0] = Node("add", (symbols[0], Node("neg", (shift,))))
    return {
        it: signed(node) for it, node in zip((name, f"v{name}", f"a{name}"), symbols, strict=True)
    }


def _definitions(
    case: Case, name: str, sign: int, shift: Node | None
) -> Iterator[papers.Statement]:
    names = _names(name, sign, shift)
    names |= _slopes(case.item, name, sign)
    for own, tree in case.item.book.defined.items():
        text = f"{own} = {printed(renamed(tree, names))}"
        yield papers.Statement(own, "definition", text, is_latex=False, form="units")


def _written(
    place: int,
    item: Item,
    kind: str,
    name: str,
    sign: int,
    shift: Node | None,
    factor: Node | None,
) -> papers.Statement:
    """A statement in the convention."""
    names, held = _names(name, sign, shift) | _slopes(item, name, sign), item.subject
    rows = math.isqrt(len(held.entries))
    coordinates = [str(it) for it in item.derivation.model.coordinates]
    coordinates *= max(rows // len(coordinates), 1)
    texts = []
    for equation, index in zip(item.equations, held.index, strict=True):
        is_value = held.is_value and equation.left.kind == "symbol"
        left, right = equation.left, renamed(equation.right, names)
        turns = {
            "vector": [index],
            "form": [index // rows, index % rows],
        }.get(held.law, [])
        if is_value and sign ** sum(coordinates[it] == name for it in turns) < 0:
            right = Node("neg", (right,))
        if not is_value:
            left = renamed(left, names)
            if kind == "factor" and factor is not None and held.factor == "parameters":
                left, right = (Node("mul", (factor, it)) for it in (left, right))
            if kind == "swapped":
                left, right = right, left
        texts.append(f"{printed(left)} = {printed(right)}")
    about = item.statement.about
    return papers.Statement(f"{place}", about, "; ".join(texts), is_latex=False, form="units")
