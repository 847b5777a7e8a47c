"""The kernel's functions in JavaScript: records become objects, and of a choice only the side that is taken is computed."""

from __future__ import annotations

import ast
import math
import re
import textwrap
from collections import Counter

from ...expressions import Expressions, Syntax, assigned, number, printed
from ...language import KernelError, Routine, Source, passes
from .. import Material

_WIDTH = 130
_SYNTAX = Syntax(
    primitives={
        "maximum": "larger", "minimum": "smaller", "absolute": "Math.abs", "sqrt": "Math.sqrt", "cube_root": "cube_root",
    },
    logic={ast.BitAnd: "&&", ast.BitOr: "||", ast.Invert: "!"},
    algebra=lambda name: f"algebra.{name}",
    routine=lambda name: name,
    arithmetic={},
    comparisons={"==": "==="},
    ternary=True,
)  # fmt: skip


def render(material: Material) -> str:
    """Constants, then every routine."""
    source = material.both_kernels
    lines = ["// Counts of roundings, derived from the statements of this file.\n"]
    lines += [f"const {name} = {number(value)};\n" for name, value in material.counts.items()]
    for it in source.constants:
        value = "Infinity" if math.isinf(it.value) else number(it.value)
        lines.append(f"{_comment(it.comment, '')}const {it.name} = {value};\n")
    own = re.sub(r"//[^\n]*|/\*.*?\*/", "", "".join(material.runtime.get("javascript", {}).values()), flags=re.DOTALL)
    asked = source.routines.keys() & set(re.findall(r"\w+", own))
    return "".join(lines) + "\n" + "\n".join(_Printer(it, source).definition() for it in printed(source, asked))


def _comment(text: str, indent: str) -> str:
    if not text:
        return ""
    start = f"{indent}// "
    return textwrap.fill(text, _WIDTH, initial_indent=start, subsequent_indent=start) + "\n"


class _Printer:
    def __init__(self, it: Routine, source: Source) -> None:
        self.it, self.source = it, source
        self.expressions = Expressions(self.source, _SYNTAX)
        self.names = dict(it.arguments)
        self.written = Counter(name for statement in it.body for name in assigned(statement))
        self.used = {node.id for statement in it.body for node in ast.walk(statement)
                     if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)}  # fmt: skip

    def definition(self) -> str:
        said = "//\n".join(_comment(paragraph, "") for paragraph in self.it.summary.split("\n\n"))
        arguments = ", ".join(name for name, _ in self.it.arguments)
        body = "".join(self.explained(statement, "  ") for statement in self.it.body)
        return f"{said}function {self.it.name}({arguments}) {{\n{body}}}\n"

    def explained(self, node: ast.stmt, indent: str) -> str:
        """A statement, below the comment that stands above it in the kernel."""
        above = self.source.lines[node.lineno - 2].strip()
        said = _comment(above.removeprefix("#").strip(), indent) if above.startswith("# ") else ""
        return said + self.statement(node, indent)

    def statement(self, node: ast.stmt, indent: str) -> str:
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                return self.line(f"{self.declared(name)}{name} = {self.expressions.print(value)};", indent)
            case ast.Assign(targets=[ast.Tuple() as target], value=ast.Call() as value):
                return self.line(f"const {self.pattern(target)} = {self.expressions.print(value)};", indent)
            case ast.For(body=body):
                inside = "".join(self.explained(statement, indent + "  ") for statement in body)
                return f"{indent}for (let pass = 0; pass < {passes(node)}; pass++) {{\n{inside}{indent}}}\n"
            case ast.Return(value=ast.Call(func=ast.Name(id=name), args=args)) if name in self.source.records:
                fields = [field for field, _ in self.source.records[name].fields]
                pairs = [self.field(field, argument) for field, argument in zip(fields, args, strict=True)]
                return self.line(f"return {{ {', '.join(pairs)} }};", indent)
            case ast.Return(value=ast.Tuple(elts=results)):
                return self.line(f"return [{self.expressions.listed(results)}];", indent)
            case ast.Return(value=ast.expr() as value):
                return self.line(f"return {self.expressions.print(value)};", indent)
        raise KernelError(f"line {node.lineno}: {ast.unparse(node)} is not in the kernel's language")

    def field(self, name: str, value: ast.expr) -> str:
        text = self.expressions.print(value)
        return name if text == name else f"{name}: {text}"

    def declared(self, name: str) -> str:
        """How a name is declared where it stands for the first time."""
        if name in self.names:
            return ""
        self.names[name] = ""
        return "let " if self.written[name] > 1 else "const "

    def pattern(self, target: ast.expr) -> str:
        """Names for the results of generated algebra, which come in an array; an empty place for one that is not used."""
        if isinstance(target, ast.Tuple):
            return f"[{', '.join(map(self.pattern, target.elts)).rstrip(', ')}]"
        assert isinstance(target, ast.Name)
        self.names[target.id] = ""
        return target.id if target.id in self.used else ""

    def line(self, text: str, indent: str) -> str:
        further = indent + "  "
        return textwrap.fill(f"{indent}{text}", _WIDTH, subsequent_indent=further, break_long_words=False,
                             break_on_hyphens=False) + "\n"  # fmt: skip
