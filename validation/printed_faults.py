"""Faults planted in right equations of ``validation/papers``: each is found, and told right.

A case is one equation with one fault, or every third time with two: a sign, an index or a name, a
number, an exponent, sine for cosine, a term or a factor lost, which changes its value at samples by
more than its object leaves open. The verdict must be a misprint whose repair has the value of the
right equation (``true``); ``first`` counts those whose form is the right one as well. A fault may
not be called right.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
import sympy as sp

from spragsym.derive import pages
from spragsym.derive.statements import papers, verdicts
from spragsym.derive.statements.book import with_defined
from spragsym.derive.statements.objects import Derivation
from spragsym.derive.statements.reading import Item, read_paper, read_statement
from spragsym.derive.statements.repair import (
    evaluated,
    same,
    same_but_for_constant,
    same_but_for_factor,
)
from spragsym.derive.statements.tree import Equation, Node, nodes, printed, residual, with_part

CASES = 600
FOLDER = Path(__file__).parent / "papers"
ARTICLE = pages.SHIPPED.parent / "kang_nam/article.toml"
#: Seconds of processor time for one statement at most.
SLOWEST = 2.0


@dataclass(frozen=True)
class Case:
    """A right statement of a paper, and the paper with what else its names need."""

    model: pages.PageModel
    paper: papers.Paper
    item: Item

    def verdict(self, text: str) -> tuple[verdicts.Row, float]:
        """The verdict on another text in its place, and the seconds that it takes."""
        own = self.item.statement
        other = replace(own, text=text, is_latex=False, transcribed="")
        begin = process_time()
        item = read_statement(other, self.item.book)
        row = (
            verdicts.verdict_on(item)
            if isinstance(item, Item)
            else verdicts.row_without_comparison(item)
        )
        return row, process_time() - begin


@cache
def files() -> list[tuple[Path, papers.Paper, pages.PageModel]]:
    """Every file with its page."""
    found = []
    for path in (*sorted(FOLDER.rglob("*.toml")), ARTICLE):
        paper = papers.read(path)
        own = path.parent / paper.model
        model = pages.read(own if own.is_file() else pages.SHIPPED / f"{paper.model}.py")
        found.append((path, paper, model))
    return found


@cache
def sources() -> list[Case]:
    """Every right statement of the files."""
    found = []
    for _, paper, model in files():
        _, items = read_paper(paper, model)
        for item, row in zip(items, verdicts.check(paper, model).rows, strict=True):
            if row.status != "confirmed" or not isinstance(item, Item):
                continue
            trees = [side for one in item.equations for side in (one.left, one.right)]
            parts = [part for tree in trees for part in nodes(tree) if not part.args]
            places = {(part.at, part.value) for part in parts}
            multiplied = item.statement.is_latex and len(places) < len(parts)
            chosen = any(part.value == "Piecewise" for tree in trees for part in nodes(tree))
            if not chosen and not multiplied:
                found.append(Case(model, paper, item))
    return found


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One equation with a fault, or with two."""
    known = sources()
    double = number % 3 == 2
    for _ in range(100):
        case = known[int(rng.integers(len(known)))]
        item = case.item
        place = int(rng.integers(len(item.equations)))
        equation = item.equations[place]
        side, other = _side(equation, item, rng)
        for _ in range(2 if double else 1):
            side = planted(side, item.derivation, rng)
        wrong_text = f"{printed(other)} = {printed(side)}"
        if item.statement.limit or not differs(item, equation, Equation(other, side)):
            continue
        texts = [f"{printed(one.left)} = {printed(one.right)}" for one in item.equations]
        verdict, seconds = case.verdict(
            "; ".join([*texts[:place], wrong_text, *texts[place + 1 :]])
        )
        break
    kind = "pair" if double else "single"
    true, first = f"{kind}_true", f"{kind}_first"
    found: dict[str, Any] = {"kind": kind, "wrong": [], "slowest": seconds, true: 0, first: 0}
    if verdict.status == "misprint":
        found[true] = 1
        form = verdict.repaired.removesuffix(" = 0").rpartition(" = ")[2]
        found[first] = int(_form(form, item) in _right_forms(equation, item))
    if verdict.status not in ("misprint", "failed"):
        found["wrong"].append(f"{wrong_text}: {verdict.status}")
    if seconds > SLOWEST:
        found["slow"] = 1
    return found


def differs(item: Item, one: Equation, other: Equation) -> bool:
    """Whether two equations of an object differ by more than it leaves open: a factor of parameters
    of an equation, a constant of an energy.
    """
    values, subject = with_defined(item.values, item.defined), item.subject
    if subject.is_value and one.left.kind == "symbol":
        first, second = (evaluated(it.right, values) for it in (one, other))
        is_free = subject.factor == "constant"
        return not (same_but_for_constant if is_free else same)(first, second)
    first, second = (evaluated(residual(it), values) for it in (one, other))
    if not same_but_for_factor(first, second):
        return True
    with np.errstate(all="ignore"):
        ratio = second / first
    return not same(ratio, np.full_like(ratio, ratio[0])) and subject.factor != "parameters"


def _form(text: str, item: Item) -> sp.Expr:
    """The form of an expression, its signs and the order of terms apart."""
    names = {name: sp.Symbol(name) for name in item.values}
    names |= {name: sp.Symbol(name) for name in item.subject.names}
    try:
        return sp.sympify(text, locals=names | {"E": sp.Symbol("E")})
    except (sp.SympifyError, TypeError, SyntaxError):
        return sp.nan


def _side(equation: Equation, item: Item, rng: np.random.Generator) -> tuple[Node, Node]:
    """The side that gets a fault: of a residual the longer one more often; and the other."""
    left, right = equation.left, equation.right
    lengths = [len(list(_places(side))) for side in (left, right)]
    if item.subject.is_value and left.kind == "symbol":
        return right, left
    chosen = rng.random() * sum(lengths) < lengths[0]
    return (left, right) if chosen or printed(right) == "0" else (right, left)


def _right_forms(equation: Equation, item: Item) -> list[sp.Expr]:
    left, right = printed(equation.left), printed(equation.right)
    if item.subject.is_value:
        return [_form(left if right == "0" else right, item)]
    residual = _form(f"{left} - ({right})", item)
    return [residual, -residual]


def planted(tree: Node, it: Derivation, rng: np.random.Generator) -> Node:
    """A tree with one fault."""
    places = list(_places(tree))
    for _ in range(200):
        path, part, above = places[int(rng.integers(len(places)))]
        new = _fault(part, above, it, rng)
        if new is not None:
            return with_part(tree, path, new)
    return tree


def _places(
    tree: Node, path: tuple[int, ...] = (), above: Node | None = None
) -> Iterator[tuple[tuple[int, ...], Node, Node | None]]:
    yield path, tree, above
    for place, part in enumerate(tree.args):
        yield from _places(part, (*path, place), tree)


def _fault(part: Node, above: Node | None, it: Derivation, rng: np.random.Generator) -> Node | None:
    match rng.integers(6):
        case 0 if above is not None and above.kind == "add":
            return part.args[0] if part.kind == "neg" else Node("neg", (part,))
        case 1 if part.kind == "symbol":
            dims = {} if it.scaled else it.kinds
            alike = [
                name
                for name in (*it.parameters, *map(str, it.model.coordinates))
                if name != part.value and dims.get(name) == dims.get(part.value)
            ]
            return Node("symbol", value=str(rng.choice(alike))) if alike else None
        case 2 if part.kind == "number" and part.value not in ("0",):
            return Node("number", value=str(int(part.value) + 1))
        case 3 if part.kind == "call" and part.value in ("sin", "cos"):
            return Node("call", part.args, "cos" if part.value == "sin" else "sin")
        case 4 if part.kind == "add" and len(part.args) > 2:
            gone = int(rng.integers(len(part.args)))
            return Node("add", tuple(a for n, a in enumerate(part.args) if n != gone))
        case 5 if part.kind == "mul" and len(part.args) > 2:
            gone = int(rng.integers(len(part.args)))
            return Node("mul", tuple(a for n, a in enumerate(part.args) if n != gone))
    return None
