"""Faults planted in right equations of ``validation/papers``: each is found, and told right.

A case is one equation with one fault, or every third time with two: a sign, an index or a name, a
number, an exponent, sine for cosine, a term or a factor lost. The verdict must be a misprint whose
repair has the value of the right equation (``true``); ``first`` counts those whose form is the
right one as well. A fault may not be called right.
"""

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
import sympy as sp

from spragsym.derive import pages
from spragsym.derive.statements import papers, verdicts
from spragsym.derive.statements.objects import Derivation
from spragsym.derive.statements.tree import Node, printed, with_part

CASES = 600
FOLDER = Path(__file__).parent / "papers"
#: Seconds of processor time for one statement at most.
SLOWEST = 2.0


@cache
def sources() -> list[tuple[pages.Model, papers.Paper, verdicts.Item]]:
    """Every right statement of the files, read, behind the definitions that it may use."""
    found = []
    for path in sorted(FOLDER.rglob("*.toml")):
        paper = papers.read(path)
        own = path.parent / paper.model
        model = pages.read(own if own.is_file() else pages.SHIPPED / f"{paper.model}.py")
        forms = verdicts.forms_of(model)
        rows = verdicts.check(paper, model).rows
        defined: dict[str, Node] = {}
        before: list[papers.Statement] = []
        for statement, row in zip(paper.statements, rows, strict=True):
            item = verdicts.prepared(statement, forms, paper.renamed, defined)
            if row.status == "confirmed" and isinstance(item, verdicts.Item):
                found.append((model, replace(paper, statements=(*before, statement)), item))
            elif row.status == "definition":
                before.append(statement)
    return found


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One equation with a fault, or with two."""
    known = sources()
    model, paper, item = known[int(rng.integers(len(known)))]
    equation = item.equations[0]
    double = number % 3 == 2
    for _ in range(100):
        side, other = _side(equation, item, rng)
        for _ in range(2 if double else 1):
            side = planted(side, item.it, rng)
        wrong_text = f"{printed(other)} = {printed(side)}"
        row = _verdict(model, _with(paper, wrong_text))
        if row[0].status != "confirmed":  # a fault that changes the value
            break
    verdict, seconds = row
    kind = "pair" if double else "single"
    found: dict[str, Any] = {"kind": kind, "wrong": [], "seconds": seconds, "true": 0, "first": 0}
    if verdict.status == "misprint":
        found["true"] = 1
        first = verdict.repaired.removesuffix(" = 0").rpartition(" = ")[2]
        found["first"] = int(_form(first, item) in _right_forms(equation, item))
    elif not double:
        found["missed"] = 1
    if verdict.status not in ("misprint", "failed"):
        found["wrong"].append(f"{wrong_text}: {verdict.status}")
    if seconds > SLOWEST:
        found["slow"] = 1
    return found


def _with(paper: papers.Paper, text: str) -> papers.Paper:
    *before, last = paper.statements
    return replace(paper, statements=(*before, replace(last, text=text, is_latex=False)))


def _verdict(model: pages.Model, paper: papers.Paper) -> tuple[verdicts.Row, float]:
    begin = process_time()
    row = verdicts.check(paper, model).rows[-1]
    return row, process_time() - begin


def _form(text: str, item: verdicts.Item) -> sp.Expr:
    """The form of an expression, its signs and the order of terms apart."""
    names = {name: sp.Symbol(name) for name in item.values}
    names |= {name: sp.Symbol(name) for name in item.held.names}
    try:
        return sp.sympify(text, locals=names | {"E": sp.Symbol("E")})
    except (sp.SympifyError, TypeError, SyntaxError):
        return sp.nan


def _side(
    equation: verdicts.Equation, item: verdicts.Item, rng: np.random.Generator
) -> tuple[Node, Node]:
    """The side that gets a fault: of a residual the longer one more often; and the other."""
    left, right = equation.left, equation.right
    lengths = [len(list(_places(side))) for side in (left, right)]
    chosen = not item.held.is_value and rng.random() * sum(lengths) < lengths[0]
    return (left, right) if chosen or printed(right) == "0" else (right, left)


def _right_forms(equation: verdicts.Equation, item: verdicts.Item) -> list[sp.Expr]:
    left, right = printed(equation.left), printed(equation.right)
    if item.held.is_value:
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
            dims = it.dimensions
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
