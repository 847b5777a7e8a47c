"""The kernel's functions in C: records become structures, flags ints, and both sides of a choice are computed."""

from __future__ import annotations

import ast
import itertools
import math
from collections import Counter
from collections.abc import Mapping

from ...expressions import SUM, Expressions, Syntax, assigned, number, places
from ...language import FLAG, REAL, KernelError, Kinds, Record, Routine, passes
from .layout import broken, comment, definition

#: Doubles: of one number or two.
PRIMITIVES = {"maximum": "larger", "minimum": "smaller", "absolute": "fabs", "sqrt": "sqrt", "cube_root": "cube_root"}


def structure(record: Record) -> str:
    """A record's definition."""
    of_a_kind = itertools.groupby(record.fields, key=lambda field: field[1])
    fields = [f"    {declared(kind)} {', '.join(name for name, _ in names)};\n" for kind, names in of_a_kind]
    return f"{comment(record.summary)}typedef struct {{\n{''.join(fields)}}} {record.name};\n"


def declared(kind: str) -> str:
    """The type of a kind."""
    return {REAL: "double", FLAG: "int"}.get(kind) or kind


def routine(it: Routine, kinds: Kinds, prefix: str) -> str:
    """A function's definition; generated algebra is called by ``prefix`` and its name."""
    return _Printer(it, kinds, prefix).definition()


def _syntax(prefix: str) -> Syntax:
    return Syntax(
        primitives=PRIMITIVES, logic={ast.BitAnd: "&", ast.BitOr: "|", ast.Invert: "!"}, algebra=lambda name: f"{prefix}{name}",
        routine=lambda name: name, arithmetic={}, comparisons={}, ternary=True,
    )  # fmt: skip


class _Printer:
    def __init__(self, it: Routine, kinds: Kinds, prefix: str) -> None:
        self.it, self.kinds = it, kinds
        self.expressions = Expressions(kinds.source, _syntax(prefix))
        self.names: dict[str, str] = dict(it.arguments)
        self.written = Counter(name for statement in it.body for name in assigned(statement))
        self.used = {
            node.id
            for statement in it.body
            for node in ast.walk(statement)
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)
        }

    def definition(self) -> str:
        arguments = ", ".join(f"{declared(kind)} {name}" for name, kind in self.it.arguments)
        head = f"INLINE {declared(self.it.returns)} {self.it.name}({arguments}) {{"
        unused = "".join(f"    (void){name};\n" for name, _ in self.it.arguments if name not in self.used)
        body = "".join(self.explained(statement, "    ") for statement in self.it.body)
        return f"{comment(self.it.summary)}{definition(broken(head), unused + body)}"

    def explained(self, node: ast.stmt, indent: str) -> str:
        """A statement, below the comment that stands above it in the kernel."""
        above = self.kinds.source.lines[node.lineno - 2].strip()
        said = comment(above.removeprefix("#").strip(), indent) if above.startswith("# ") else ""
        return said + self.statement(node, indent)

    def statement(self, node: ast.stmt, indent: str) -> str:
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=value):
                return self.assignment(name, value, indent)
            case ast.Assign(targets=[ast.Tuple() as target], value=ast.Call(func=ast.Name(id=called), args=args)):
                return self.unpacked([name for name, _ in places(target)], called, args, indent)
            case ast.For(body=body):
                inside = "".join(self.explained(statement, indent + "    ") for statement in body)
                return f"{indent}for (int i = 0; i < {passes(node)}; i++) {{\n{inside}{indent}}}\n"
            case ast.Return(value=ast.Call(func=ast.Name(id=name), args=values)) if name in self.kinds.source.records:
                return self.record(name, values, indent)
            case ast.Return(value=ast.Tuple(elts=values)):
                return self.record(self.it.returns, values, indent)
            case ast.Return(value=ast.expr() as value):
                return broken(f"{indent}return {self.expressions.print(value)};") + "\n"
        raise KernelError(f"line {node.lineno}: {ast.unparse(node)} is not in the kernel's language")

    def record(self, name: str, values: list[ast.expr], indent: str) -> str:
        """A record, returned."""
        listed = ", ".join(self.expressions.print(value, SUM) for value in values)
        return f"{broken(f'{indent}const {name} result = {{{listed}}};')}\n{indent}return result;\n"

    def assignment(self, name: str, value: ast.expr, indent: str) -> str:
        kind = self.kinds.of(value, self.names)
        known = name in self.names
        self.names[name] = kind
        start = name if known else f"{'' if self.written[name] > 1 else 'const '}{declared(kind)} {name}"
        return broken(f"{indent}{start} = {self.expressions.print(value)};") + "\n"

    def unpacked(self, names: list[str], called: str, args: list[ast.expr], indent: str) -> str:
        """Results of generated algebra, which come in an array, and double-doubles in a record."""
        results = f"{called}_results"
        if called in self.kinds.source.routines:
            record = self.kinds.source.records[self.kinds.source.routines[called].returns]
            fields = [f"{results}.{field}" for field, _ in record.fields]
            kind = record.fields[0][1]
            lines = [
                f"{indent}const {record.name} {results} = {self.expressions.called(called)}({self.expressions.listed(args)});"
            ]
        else:
            fields = [f"{results}[{place}]" for place in range(len(names))]
            kind = REAL
            passed = ", ".join([*map(self.expressions.print, args), results])
            lines = [f"{indent}double {results}[{len(names)}];", f"{indent}{self.expressions.called(called)}({passed});"]
        self.names |= dict.fromkeys(names, kind)
        unpacked = ", ".join(f"{name} = {field}" for name, field in zip(names, fields, strict=True) if name in self.used)
        lines.append(f"{indent}const {declared(kind)} {unpacked};")
        return "\n".join(map(broken, lines)) + "\n"


def constants(values: Mapping[str, tuple[float, str]]) -> str:
    """Named numbers with their comments."""
    lines = []
    for name, (value, text) in values.items():
        if math.isinf(value):  # C has a name for it
            continue
        lines += [comment(text)] if text else []
        lines.append(f"#define {name} {number(value)}\n")
    return "".join(lines)
