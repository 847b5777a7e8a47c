"""The kernel's functions in MATLAB: records become structures of columns, and both sides of a choice are computed."""

from __future__ import annotations

import ast
import math
import re
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
    words = set(re.findall(r"\w+", re.sub(r"%.*", "", "".join(material.runtime.get("matlab", {}).values()))))
    asked = [name for name in source.routines if method_name(name) in words]
    said: set[str] = set()
    return [_Printer(it, source, material, said).definition() for it in printed(source, asked)]


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
    def __init__(self, it: Routine, source: Source, material: Material, said: set[str]) -> None:
        self.it, self.source, self.said = it, source, said
        self.expressions = Expressions(self.source, _syntax(material.library))
        self.numbers = {item.name: (item.value, item.comment) for item in self.source.constants}
        self.numbers |= {name: (value, "a count of roundings") for name, value in material.counts.items()}
        self.used = {node.id for statement in it.body for node in ast.walk(statement)
                     if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)}  # fmt: skip

    def definition(self) -> str:
        first, *rest = self.it.summary.split("\n\n")
        given = ", ".join(name for name, _ in self.it.arguments)
        lines = [
            f"function {self.returned()} = {method_name(self.it.name)}({given})",
            *comment(f"{method_name(self.it.name).upper()}  {first}", ""),
            *(line for paragraph in rest for line in ("%", *comment(paragraph, "  "))),
            *self.constants(),
            *(line for statement in self.it.body for line in self.explained(statement, "  ")),
            "end\n",
        ]
        return "\n".join(lines)

    def returned(self) -> str:
        """What stands for the result, or for each of several."""
        match self.it.body[-1]:
            case ast.Return(value=ast.Tuple(elts=results)):
                return f"[{', '.join(f'result{place + 1}' for place in range(len(results)))}]"
        return "result"

    def constants(self) -> Iterator[str]:
        """Named numbers that this routine uses, explained where the first of all does."""
        for name, (value, said) in self.numbers.items():
            if name in self.used:
                line = f"  {name} = {'Inf' if math.isinf(value) else number(value)};"
                said = "" if name in self.said else said
                self.said.add(name)
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
                fields = zip(
                    (field for field, _ in self.source.records[name].fields), map(self.expressions.print, args), strict=True
                )
                listed = ", ".join(f"'{field}', {value}" for field, value in fields)
                yield from wrapped(f"{indent}result = struct({listed});")
            case ast.Return(value=ast.Tuple(elts=results)):
                for place, value in enumerate(results):
                    yield from wrapped(f"{indent}result{place + 1} = {self.expressions.print(value)};")
            case ast.Return(value=ast.expr() as value):
                yield from wrapped(f"{indent}result = {self.expressions.print(value)};")
            case _:
                raise KernelError(f"line {node.lineno}: {ast.unparse(node)} is not in the kernel's language")
