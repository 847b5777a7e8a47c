"""Single faults in Python source: each mutant replaces one node of the syntax tree, and has a key that outlives other edits."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

_SWAPS: dict[type, tuple[type, ...]] = {
    ast.Add: (ast.Sub,), ast.Sub: (ast.Add,), ast.Mult: (ast.Div,), ast.Div: (ast.Mult,), ast.FloorDiv: (ast.Mult,),
    ast.Mod: (ast.Mult,), ast.Pow: (ast.Mult,), ast.BitAnd: (ast.BitOr,), ast.BitOr: (ast.BitAnd,),
    ast.Lt: (ast.LtE, ast.GtE), ast.LtE: (ast.Lt, ast.Gt), ast.Gt: (ast.GtE, ast.LtE), ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,), ast.NotEq: (ast.Eq,), ast.Is: (ast.IsNot,), ast.IsNot: (ast.Is,), ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,), ast.And: (ast.Or,), ast.Or: (ast.And,),
}  # fmt: skip
_NAMES = {"min": "max", "minimum": "maximum", "any": "all", "floor": "ceil", "argmin": "argmax", "nanargmin": "nanargmax"}
_NAMES |= {other: name for name, other in _NAMES.items()}
_SIZES = {"abs", "absolute"}
_STATEMENTS = ast.AugAssign | ast.Expr | ast.Raise | ast.Continue | ast.Break


@dataclass(frozen=True)
class Mutant:
    """One fault: ``node`` stands in ``field`` of ``parent`` (in place ``index`` of a list), and ``other`` would replace it."""

    key: str
    line: int
    parent: ast.AST
    field: str
    index: int | None
    other: ast.AST
    scope: str

    def apply(self) -> None:
        """Put the fault into the tree."""
        other = ast.fix_missing_locations(ast.copy_location(self.other, self.parent))
        if self.index is None:
            setattr(self.parent, self.field, other)
        else:
            getattr(self.parent, self.field)[self.index] = other


def mutants(tree: ast.Module) -> list[Mutant]:
    """All faults of a module, in the order of its text."""
    found: list[Mutant] = []
    seen: Counter[str] = Counter()
    for parent, field, index, node, scope in _sites(tree, ""):
        for other in _variants(node, field):
            place = f" in {_text(parent)}" if isinstance(node, ast.Constant | ast.UnaryOp) else ""
            key = f"{scope or 'module'}: {_text(node)} -> {_text(other)}{place}"
            seen[key] += 1
            numbered = key if seen[key] == 1 else f"{key} #{seen[key]}"
            found.append(Mutant(numbered, getattr(node, "lineno", 0), parent, field, index, other, scope))
    return found


def _text(node: ast.AST) -> str:
    text = ast.unparse(node).replace("\n", " ")
    return text if len(text) <= 90 else f"{text[:60]}…{text[-29:]}"


def _sites(parent: ast.AST, scope: str) -> Iterator[tuple[ast.AST, str, int | None, ast.AST, str]]:
    """Every node that may be replaced, with where it stands; no annotations, decorators, docstrings, messages."""
    for field, value in ast.iter_fields(parent):
        if field in ("annotation", "returns", "decorator_list", "bases", "keywords_of_class", "type_params"):
            continue
        for index, node in enumerate(value if isinstance(value, list) else [value]):
            if not isinstance(node, ast.AST) or _is_left_alone(node) or getattr(parent, "arg", "") == "strict":
                continue
            inner = f"{scope}.{node.name}".lstrip(".") if isinstance(node, ast.FunctionDef | ast.ClassDef) else scope
            yield parent, field, index if isinstance(value, list) else None, node, scope
            if not isinstance(node, ast.Raise):
                yield from _sites(node, inner)


def _is_left_alone(node: ast.AST) -> bool:
    docstring = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    alias = isinstance(node, ast.AnnAssign) and "TypeAlias" in ast.unparse(node.annotation)
    types = isinstance(node, ast.Assign) and "TypeVar" in ast.unparse(node.value)
    return docstring or alias or types or isinstance(node, ast.JoinedStr | ast.Import | ast.ImportFrom | ast.Assert)


def _variants(node: ast.AST, field: str) -> Iterator[ast.AST]:
    """What may stand in a node's place."""
    match node:
        case ast.BinOp(left=left, op=op, right=right):
            yield from (ast.BinOp(left, other(), right) for other in _SWAPS.get(type(op), ()))
            if isinstance(op, ast.Add | ast.Sub):
                yield left
            if isinstance(op, ast.Add):
                yield right
        case ast.AugAssign(target=target, op=op, value=value):
            yield from (ast.AugAssign(target, other(), value) for other in _SWAPS.get(type(op), ()))
        case ast.UnaryOp(op=ast.USub() | ast.Not() | ast.Invert(), operand=operand):
            yield operand
        case ast.Compare(left=left, ops=ops, comparators=values):
            for i, op in enumerate(ops):
                yield from (ast.Compare(left, [*ops[:i], other(), *ops[i + 1 :]], values) for other in _SWAPS[type(op)])
        case ast.BoolOp(op=op, values=values):
            yield from (ast.BoolOp(other(), values) for other in _SWAPS[type(op)])
            for i in range(len(values)):
                rest = [*values[:i], *values[i + 1 :]]
                yield rest[0] if len(rest) == 1 else ast.BoolOp(op, rest)
        case ast.Constant(value=value):
            yield from (ast.Constant(other) for other in _other_constants(value))
        case ast.Call(func=ast.Name() | ast.Attribute(), args=args, keywords=keywords):
            yield from _other_calls(node, args, keywords)
    if field == "test" and isinstance(node, ast.Name | ast.Call | ast.Attribute | ast.Subscript | ast.BinOp):
        yield ast.UnaryOp(ast.Not(), node)
    if isinstance(node, _STATEMENTS) or (isinstance(node, ast.Assign) and _changes(node)):
        yield ast.Pass()


def _changes(node: ast.Assign) -> bool:
    """Whether an assignment changes what was there; without the first one of a name nothing runs."""
    used = {part.id for part in ast.walk(node.value) if isinstance(part, ast.Name)}
    places = [part for target in node.targets for part in ast.walk(target)]
    return any(isinstance(part, ast.Subscript | ast.Attribute) or getattr(part, "id", "") in used for part in places)


def _other_constants(value: Any) -> Iterator[Any]:
    if isinstance(value, bool):
        yield not value
    elif isinstance(value, int):
        yield 0 if value == 1 else value + 1
    elif isinstance(value, float):
        yield value * 1.5 if value else 1.0
        if value:
            yield value / 1.5


def _other_calls(node: ast.Call, args: list[ast.expr], keywords: list[ast.keyword]) -> Iterator[ast.AST]:
    func = node.func
    name = func.id if isinstance(func, ast.Name) else func.attr if isinstance(func, ast.Attribute) else ""
    if name in _NAMES:
        swapped = ast.Name(_NAMES[name], ast.Load()) if isinstance(func, ast.Name) else _renamed(func, _NAMES[name])
        yield ast.Call(swapped, args, keywords)
    if name in _SIZES and args:
        yield args[0]


def _renamed(func: ast.expr, name: str) -> ast.Attribute:
    assert isinstance(func, ast.Attribute)
    return ast.Attribute(func.value, name, func.ctx)
