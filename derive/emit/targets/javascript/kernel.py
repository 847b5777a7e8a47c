"""The kernel's functions in JavaScript: records become objects, and of a choice only the side that
is taken is computed.
"""

import ast
import math
from collections.abc import Collection

from ...expressions import Syntax, number, printed
from ...language import Routine, Source
from ...routines import Printer
from .. import Material, words
from .algebra import comment, wrapped


def render(material: Material) -> str:
    """The kernel's constants, then its functions."""
    source = material.both_kernels
    lines = ["// Counts of roundings, derived from the statements of this file.\n"]
    lines += [f"const {name} = {number(value)};\n" for name, value in material.counts.items()]
    own = "".join(material.runtime.get("javascript", {}).values())
    asked = source.routines.keys() & words(own, r"//[^\n]*|/\*.*?\*/")
    return "".join(lines) + definitions(source, asked)


def module(name: str, source: Source, header: str) -> str:
    """An ES module of a source's functions, which are the fields of the one object exported."""
    listed = ", ".join(source.routines)
    return (
        f"{comment(f'{source.summary} {header}')}\n\n{definitions(source, source.routines)}\n"
        f"export const {name} = Object.freeze({{ {listed} }});\n"
    )


def definitions(source: Source, asked: Collection[str]) -> str:
    """Constants, and the functions that are asked for with all that they call."""
    lines = list[str]()
    for it in source.constants:
        value = "Infinity" if math.isinf(it.value) else number(it.value)
        lines.append(f"{_said(it.comment)}const {it.name} = {value};\n")
    functions = (_JavaScriptPrinter(it, source).definition() for it in printed(source, asked))
    return "".join([*lines, "\n", "\n".join(functions)])


def _said(text: str, indent: str = "") -> str:
    return f"{comment(text, indent)}\n" if text else ""


class _JavaScriptPrinter(Printer):
    begin = "for (let pass = 0; pass < {}; pass++) {{"

    def __init__(self, routine: Routine, source: Source) -> None:
        syntax = Syntax(
            primitives={
                "maximum": "larger",
                "minimum": "smaller",
                "absolute": "Math.abs",
                "sqrt": "Math.sqrt",
                "cube_root": "cube_root",
            },
            logic={ast.BitAnd: "&&", ast.BitOr: "||", ast.Invert: "!"},
            algebra=lambda name: f"algebra.{name}",
            signs={"==": "==="},
        )
        super().__init__(routine, source, syntax)
        self.declared = {name for name, _ in routine.arguments}

    def definition(self) -> str:
        said = "//\n".join(map(_said, self.routine.summary.split("\n\n")))
        arguments = ", ".join(name for name, _ in self.routine.arguments)
        return f"{said}function {self.routine.name}({arguments}) {{\n{self.body('  ')}}}\n"

    def line(self, text: str, indent: str) -> str:
        return f"{wrapped(indent + text, indent + '  ')}\n"

    def comment(self, text: str, indent: str) -> str:
        return _said(text, indent)

    def assignment(self, name: str, value: ast.expr, indent: str) -> str:
        kind = "" if name in self.declared else "let " if self.written[name] > 1 else "const "
        self.declared.add(name)
        return self.line(f"{kind}{name} = {self.expressions.print(value)};", indent)

    def unpacking(self, target: ast.Tuple, called: ast.Call, indent: str) -> str:
        return self.line(
            f"const {self._pattern(target)} = {self.expressions.print(called)};", indent
        )

    def record(self, name: str, values: list[ast.expr], indent: str) -> str:
        listed = ", ".join(
            field if text == field else f"{field}: {text}"
            for field, text in self.fields(name, values)
        )
        return self.line(f"return {{ {listed} }};", indent)

    def several(self, values: list[ast.expr], indent: str) -> str:
        return self.line(f"return [{self.expressions.listed(values)}];", indent)

    def _pattern(self, target: ast.expr) -> str:
        """The destructuring pattern for an array of results, with empty places for those that are
        not used.
        """
        if isinstance(target, ast.Tuple):
            return f"[{', '.join(map(self._pattern, target.elts)).rstrip(', ')}]"
        assert isinstance(target, ast.Name)
        self.declared.add(target.id)
        return target.id if target.id in self.used else ""
