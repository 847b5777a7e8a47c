"""The kernel's functions in C: records become structures, flags ints, and both sides of a choice
are computed.
"""

import ast
import itertools
import math
from collections.abc import Mapping

from ...expressions import Strength, Syntax, number
from ...language import Record, Routine, Source, kind_of
from ...routines import Printer, places
from .layout import broken, comment, definition


def structure(record: Record) -> str:
    """The definition of a record as a structure."""
    of_a_kind = itertools.groupby(record.fields, key=lambda field: field[1])
    fields = [
        f"    {declared(kind)} {', '.join(name for name, _ in names)};\n"
        for kind, names in of_a_kind
    ]
    return f"{comment(record.summary)}typedef struct {{\n{''.join(fields)}}} {record.name};\n"


def declared(kind: str) -> str:
    """The C type of a kernel's type."""
    return {"Real": "double", "Flag": "int"}.get(kind) or kind


def routine(routine: Routine, source: Source) -> str:
    """The definition of a kernel's function."""
    return _CPrinter(routine, source).definition()


class _CPrinter(Printer):
    step = "    "
    begin = "for (int i = 0; i < {}; i++) {{"

    def __init__(self, routine: Routine, source: Source) -> None:
        logic: dict[type[ast.operator] | type[ast.unaryop], str] = {
            ast.BitAnd: "&",
            ast.BitOr: "|",
            ast.Invert: "!",
        }
        # Doubles: of one number or two.
        primitives = {
            "maximum": "larger",
            "minimum": "smaller",
            "absolute": "fabs",
            "sqrt": "sqrt",
            "cube_root": "cube_root",
        }
        syntax = Syntax(primitives, logic, algebra=lambda name: f"algebra_{name}")
        super().__init__(routine, source, syntax)
        self.names: dict[str, str] = dict(routine.arguments)

    def definition(self) -> str:
        arguments = ", ".join(f"{declared(kind)} {name}" for name, kind in self.routine.arguments)
        head = f"INLINE {declared(self.routine.returns)} {self.routine.name}({arguments}) {{"
        unused = "".join(
            f"    (void){name};\n" for name, _ in self.routine.arguments if name not in self.used
        )
        return (
            f"{comment(self.routine.summary)}{definition(broken(head), unused + self.body('    '))}"
        )

    def line(self, text: str, indent: str) -> str:
        return f"{broken(indent + text)}\n"

    def comment(self, text: str, indent: str) -> str:
        return comment(text, indent)

    def assignment(self, name: str, value: ast.expr, indent: str) -> str:
        kind = kind_of(value, self.names, self.source)
        assigned = name in self.names
        self.names[name] = kind
        start = (
            name
            if assigned
            else f"{'' if self.written[name] > 1 else 'const '}{declared(kind)} {name}"
        )
        return self.line(f"{start} = {self.expressions.print(value)};", indent)

    def unpacking(self, target: ast.Tuple, called: ast.Call, indent: str) -> str:
        """Results of generated algebra come in an array, those of the kernel in a record."""
        assert isinstance(called.func, ast.Name)
        name, names = called.func.id, list(places(target))
        results, function = f"{name}_results", self.expressions.called(name)
        if name in self.source.routines:
            record = self.source.records[self.source.routines[name].returns]
            fields = [f"{results}.{field}" for field, _ in record.fields]
            kind = record.fields[0][1]
            lines = [
                f"const {record.name} {results} = "
                f"{function}({self.expressions.listed(called.args)});"
            ]
        else:
            fields = [f"{results}[{index}]" for index in range(len(names))]
            kind = "Real"
            passed = ", ".join([*map(self.expressions.print, called.args), results])
            lines = [f"double {results}[{len(names)}];", f"{function}({passed});"]
        self.names |= dict.fromkeys(names, kind)
        unpacked = ", ".join(
            f"{name} = {field}"
            for name, field in zip(names, fields, strict=True)
            if name in self.used
        )
        lines.append(f"const {declared(kind)} {unpacked};")
        return "".join(self.line(line, indent) for line in lines)

    def record(self, name: str, values: list[ast.expr], indent: str) -> str:
        listed = ", ".join(self.expressions.print(value, Strength.SUM) for value in values)
        return self.line(f"const {name} result = {{{listed}}};", indent) + self.line(
            "return result;", indent
        )

    def several(self, values: list[ast.expr], indent: str) -> str:
        return self.record(self.routine.returns, values, indent)


def constants(values: Mapping[str, tuple[float, str]]) -> str:
    """Definitions of named numbers with their comments; infinity has a name in C already."""
    return "".join(
        f"{comment(text) if text else ''}#define {name} {number(value)}\n"
        for name, (value, text) in values.items()
        if not math.isinf(value)
    )
