"""Printer of the kernel's functions in a target's syntax, statement by statement."""

import ast
from collections import Counter
from collections.abc import Callable, Iterator
from typing import ClassVar

from .expressions import Expressions, Syntax
from .language import KernelError, Routine, Source, passes


class Printer:
    """Printer of one routine. A target's subclass says how each kind of statement is written, as
    lines that end in a newline.
    """

    step: ClassVar[str] = "  "  #: indentation of a loop's statements
    begin: ClassVar[str]  #: first line of a loop, with ``{}`` for the number of passes
    end: ClassVar[str] = "}"  #: last line of a loop
    gives: ClassVar[str] = "return {};"  #: return statement

    def __init__(self, routine: Routine, source: Source, syntax: Syntax) -> None:
        self.routine, self.source = routine, source
        self.expressions = Expressions(source, syntax)
        self.written = Counter(name for statement in routine.body for name in assigned(statement))
        self.used = {
            node.id
            for statement in routine.body
            for node in ast.walk(statement)
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)
        }

    def body(self, indent: str) -> str:
        return "".join(self._explained(statement, indent) for statement in self.routine.body)

    def _explained(self, node: ast.stmt, indent: str) -> str:
        """A statement with the comment that stands above it in the kernel."""
        above = self.source.lines[node.lineno - 2].strip()
        said = self.comment(above.removeprefix("# "), indent) if above.startswith("# ") else ""
        return said + self._statement(node, indent)

    def _statement(self, node: ast.stmt, indent: str) -> str:
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                return self.assignment(name, value, indent)
            case ast.Assign(targets=[ast.Tuple() as target], value=ast.Call() as value):
                return self.unpacking(target, value, indent)
            case ast.For(body=body):
                inside = "".join(
                    self._explained(statement, indent + self.step) for statement in body
                )
                return f"{indent}{self.begin.format(passes(node))}\n{inside}{indent}{self.end}\n"
            case ast.Return(value=ast.Call(func=ast.Name(id=name), args=values)) if (
                name in self.source.records
            ):
                return self.record(name, values, indent)
            case ast.Return(value=ast.Tuple(elts=values)):
                return self.several(values, indent)
            case ast.Return(value=ast.expr() as value):
                return self.line(self.gives.format(self.expressions.print(value)), indent)
        raise KernelError(
            f"line {node.lineno}: {ast.unparse(node)} is not in the kernel's language"
        )

    def fields(self, name: str, values: list[ast.expr]) -> Iterator[tuple[str, str]]:
        """The fields of a record with their printed values."""
        return zip(
            dict(self.source.records[name].fields), map(self.expressions.print, values), strict=True
        )

    #: How a target writes a long statement, a comment, an assignment, the unpacking of results of
    #: generated algebra, a returned record, and several returned results.
    line: Callable[[str, str], str]
    comment: Callable[[str, str], str]
    assignment: Callable[[str, ast.expr, str], str]
    unpacking: Callable[[ast.Tuple, ast.Call, str], str]
    record: Callable[[str, list[ast.expr], str], str]
    several: Callable[[list[ast.expr], str], str]


def assigned(node: ast.stmt) -> Iterator[str]:
    """Names that a statement assigns; those in a loop twice, since they change."""
    match node:
        case ast.Assign(targets=[target]):
            yield from places(target)
        case ast.For(body=body):
            for statement in [*body, *body]:
                yield from assigned(statement)


def places(target: ast.expr) -> Iterator[str]:
    """Names on the left of an assignment, which may be nested."""
    return (item.id for item in items(target) if isinstance(item, ast.Name))


def items(node: ast.expr) -> list[ast.expr]:
    """Items of a nested tuple, in order."""
    if isinstance(node, ast.Tuple):
        return [leaf for item in node.elts for leaf in items(item)]
    return [node]
