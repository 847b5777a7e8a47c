"""The small language of the kernels, a subset of Python: its primitives and its parser.

A function consists of a docstring, statements and a return statement. A statement assigns a name,
unpacks the results of generated algebra, or repeats statements a fixed number of times. Every value
is of one of three kinds: a real number, a flag, or a record.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, NoReturn, TypeAlias, TypeGuard

#: A real number of the target: a float, an array, an interval.
Real: TypeAlias = Any
#: A truth value, or an array of these.
Flag: TypeAlias = Any

#: The routine that gives a number as a double. On doubles it returns its argument: a call of it is
#: printed as that, and it is not printed itself.
ROUGH = "rough"


def _primitive(name: str) -> Callable[..., Any]:
    """A placeholder for a function that every target provides."""

    def unbound(*_: Any) -> NoReturn:
        raise TypeError(f"{name} has no meaning before a target gives it one")

    return unbound


#: Primitives of every target: ``where``, which evaluates both sides, and functions of one or two
#: reals.
where, maximum, minimum, absolute, sqrt, cube_root = map(
    _primitive, ("where", "maximum", "minimum", "absolute", "sqrt", "cube_root")
)


def derived(number: int) -> tuple[Any, ...]:
    """Placeholders for names that a target binds: generated algebra and counts of roundings."""
    return (_primitive("what is derived"),) * number


@dataclass(frozen=True)
class Record:
    """A named tuple of reals and flags."""

    name: str
    summary: str
    fields: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Routine:
    """A function of the kernel; arguments are pairs of name and kind."""

    name: str
    summary: str
    arguments: tuple[tuple[str, str], ...]
    returns: str
    body: tuple[ast.stmt, ...]

    @cached_property
    def calls(self) -> tuple[str, ...]:
        """The names of all functions that it calls, in order."""
        nodes = (node for statement in self.body for node in ast.walk(statement))
        called = (node.func for node in nodes if isinstance(node, ast.Call))
        return tuple(it.id for it in called if isinstance(it, ast.Name))


@dataclass(frozen=True)
class Constant:
    """A named number with the comment above it."""

    name: str
    value: float
    comment: str


@dataclass(frozen=True)
class Source:
    """A parsed kernel: its parts, which targets print, and its text, which the Python target
    copies.

    The kernel of a model without one is empty.
    """

    text: str = ""
    constants: tuple[Constant, ...] = ()
    records: Mapping[str, Record] = field(default_factory=dict)
    routines: Mapping[str, Routine] = field(default_factory=dict)

    @property
    def summary(self) -> str:
        """The first line of the kernel's docstring."""
        return (ast.get_docstring(ast.parse(self.text)) or "").partition("\n")[0]

    @property
    def called(self) -> set[str]:
        """Names of all functions that its routines call."""
        return {name for it in self.routines.values() for name in it.calls}

    @cached_property
    def lines(self) -> list[str]:
        """Lines of the text, from line 1 at index 0."""
        return self.text.splitlines()


class KernelError(ArithmeticError):
    """A kernel's source is not in its language."""


def read(path: Path, *further: Path) -> Source:
    """Parse a kernel from files; imports and docstrings of all but the first are left out."""
    others = (definitions(it.read_text(encoding="utf-8")) for it in further)
    return parse("\n\n".join([path.read_text(encoding="utf-8"), *others]))


def definitions(text: str) -> str:
    """The text of a file from its first constant, record or function on."""
    lines = text.splitlines()
    first = next(
        node
        for node in ast.parse(text).body
        if _is_constant(node) or isinstance(node, ast.ClassDef | ast.FunctionDef)
    )
    return "\n".join(lines[first.lineno - 1 - len(_comment_above(first, lines)) :]) + "\n"


def _is_constant(node: ast.stmt) -> TypeGuard[ast.Assign]:
    return isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)


def joined(*sources: Source) -> Source:
    """One kernel of several."""
    return parse("\n\n".join(source.text for source in sources))


def parse(text: str) -> Source:
    """Parse a kernel from its text."""
    lines = text.splitlines()
    constants, records, routines = [], {}, {}
    for node in ast.parse(text).body:
        if _is_constant(node):
            constants.append(_constant(node, lines))
        elif isinstance(node, ast.ClassDef):
            fields = [
                (ast.unparse(item.target), ast.unparse(item.annotation))
                for item in node.body
                if isinstance(item, ast.AnnAssign)
            ]
            records[node.name] = Record(node.name, ast.get_docstring(node) or "", tuple(fields))
        elif isinstance(node, ast.FunctionDef):
            arguments = tuple(
                (argument.arg, _kind(argument.annotation, node)) for argument in node.args.args
            )
            returned, said = _kind(node.returns, node), ast.get_docstring(node) or ""
            routines[node.name] = Routine(
                node.name, said, arguments, returned, tuple(node.body[1:])
            )
    return Source(text, tuple(constants), records, routines)


def _constant(node: ast.Assign, lines: list[str]) -> Constant:
    (target,) = node.targets
    assert isinstance(target, ast.Name)
    comment = [line.removeprefix("#:").strip() for line in _comment_above(node, lines)]
    value = float("inf") if isinstance(node.value, ast.Call) else ast.literal_eval(node.value)
    return Constant(target.id, float(value), " ".join(comment))


def _comment_above(node: ast.stmt, lines: list[str]) -> list[str]:
    """The lines of the comment that documents a constant."""
    first = node.lineno - 1
    while lines[first - 1].startswith("#:"):
        first -= 1
    return lines[first : node.lineno - 1]


def _kind(annotation: ast.expr | None, node: ast.stmt | ast.arg) -> str:
    """The kind that an annotation names."""
    if not isinstance(annotation, ast.Name):
        raise KernelError(
            f"line {node.lineno}: arguments and results need a kind: Real, Flag or a record"
        )
    return annotation.id


# ------------------------------------------------------------------------------------------------
# kinds


def kind_of(expression: ast.expr, names: Mapping[str, str], source: Source) -> str:
    """The kind of an expression of the kernel: Real, Flag or the name of a record; ``names`` has
    the kinds of local names.
    """
    match expression:
        case ast.Constant():
            return "Real"
        case ast.Name(id=name):
            return names.get(name, "Real")
        case ast.Attribute(value=value, attr=attribute):
            return dict(source.records[kind_of(value, names, source)].fields)[attribute]
        case ast.Compare():
            return "Flag"
        case ast.BinOp(op=ast.BitAnd() | ast.BitOr()) | ast.UnaryOp(op=ast.Invert()):
            return "Flag"
        case ast.BinOp() | ast.UnaryOp():
            return "Real"
        case ast.Call(func=ast.Name(id="where"), args=[_, yes, _]):
            return kind_of(yes, names, source)
        case ast.Call(func=ast.Name(id=name)):
            if name in source.records:
                return name
            return source.routines[name].returns if name in source.routines else "Real"
    raise KernelError(
        f"line {expression.lineno}: {ast.unparse(expression)} is not in the kernel's language"
    )


def passes(loop: ast.For) -> int:
    """The number of passes of a loop."""
    match loop.iter:
        case ast.Call(func=ast.Name(id="range"), args=[ast.Constant(value=int(number))]):
            return number
    raise KernelError(f"line {loop.lineno}: a loop runs over range(number)")
