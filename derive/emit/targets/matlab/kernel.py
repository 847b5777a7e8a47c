"""The kernel's functions in MATLAB: records become structures of columns, and both sides of a choice are computed."""

from __future__ import annotations

import ast
import math
from collections.abc import Iterator

from ...expressions import Expressions, Syntax, number, places, printed
from ...language import KernelError, Routine, Source, passes
from .. import Material
from .algebra import WIDTH, comment, wrapped


#: Names of functions that MATLAB and Octave have: Octave warns of others by that name, even in a package.
_TAKEN = frozenset({"single", "balance"})


def method_name(name: str) -> str:
    """What a routine is called in the package."""
    return f"{name}_" if name in _TAKEN else name


def render(material: Material) -> list[str]:
    """Every routine."""
    source = material.both_kernels
    return [_Printer(it, source, material).definition() for it in printed(source)]


def _syntax(library: str) -> Syntax:
    inside = f"{library}.kernel."
    return Syntax(
        primitives={
            "where": f"{inside}where", "maximum": f"{inside}larger", "minimum": f"{inside}smaller",
            "absolute": "abs", "sqrt": "sqrt", "cube_root": f"{inside}cube_root",
        },
        logic={ast.BitAnd: "&", ast.BitOr: "|", ast.Invert: "~"},
        algebra=lambda name: f"{library}.algebra.{name}",
        routine=lambda name: f"{inside}{method_name(name)}",
        arithmetic={"*": ".*", "/": "./"},
        comparisons={},
        ternary=False,
    )  # fmt: skip


class _Printer:
    def __init__(self, it: Routine, source: Source, material: Material) -> None:
        self.it, self.source = it, source
        self.expressions = Expressions(self.source, _syntax(material.library))
        self.numbers = {item.name: (item.value, item.comment) for item in self.source.constants}
        self.numbers |= {name: (value, "a count of roundings") for name, value in material.counts.items()}
        self.used = {node.id for statement in it.body for node in ast.walk(statement)
                     if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)}  # fmt: skip

    def definition(self) -> str:
        first, *rest = self.it.summary.split("\n\n")
        lines = [
            f"function result = {method_name(self.it.name)}({', '.join(name for name, _ in self.it.arguments)})",
            *comment(f"{method_name(self.it.name).upper()}  {first}", ""),
            *(line for paragraph in rest for line in ("%", *comment(paragraph, "  "))),
            *self.constants(),
            *(line for statement in self.it.body for line in self.explained(statement, "  ")),
            "end\n",
        ]
        return "\n".join(lines)

    def constants(self) -> Iterator[str]:
        """Named numbers that this routine uses."""
        for name, (value, said) in self.numbers.items():
            if name in self.used:
                line = f"  {name} = {'Inf' if math.isinf(value) else number(value)};"
                beside = f"{line}  % {said}" if said else line
                yield from [beside] if len(beside) <= WIDTH else [*(f"  {above}" for above in comment(said, " ")), line]

    def explained(self, node: ast.stmt, indent: str) -> Iterator[str]:
        """A statement, below the comment that stands above it in the kernel."""
        above = self.source.lines[node.lineno - 2].strip()
        if above.startswith("# "):
            yield from (f"{indent}{line}" for line in comment(above.removeprefix("# "), " "))
        yield from self.statement(node, indent)

    def statement(self, node: ast.stmt, indent: str) -> Iterator[str]:
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                yield from wrapped(f"{indent}{name} = {self.expressions.print(value)};")
            case ast.Assign(targets=[ast.Tuple() as target], value=ast.Call() as value):
                names = [name if name in self.used else "~" for name, _ in places(target)]
                while names[-1] == "~":
                    names.pop()
                yield from wrapped(f"{indent}[{', '.join(names)}] = {self.expressions.print(value)};")
            case ast.For(body=body):
                yield f"{indent}for pass = 1:{passes(node)}"
                for statement in body:
                    yield from self.explained(statement, indent + "  ")
                yield f"{indent}end"
            case ast.Return(value=ast.Call(func=ast.Name(id=name), args=args)) if name in self.source.records:
                for (field, _), value in zip(self.source.records[name].fields, args, strict=True):
                    yield from wrapped(f"{indent}result.{field} = {self.expressions.print(value)};")
            case ast.Return(value=ast.expr() as value):
                yield from wrapped(f"{indent}result = {self.expressions.print(value)};")
            case _:
                raise KernelError(f"line {node.lineno}: {ast.unparse(node)} is not in the kernel's language")
