"""The kernel's functions in MATLAB: records become structures of columns, and both sides of a
choice are computed.
"""

import ast
import math
from collections.abc import Iterator

from ...definitions import WIDTH
from ...expressions import Syntax, number, printed
from ...language import Routine, Source
from ...routines import Printer, places
from .. import Material, words
from .algebra import comment, wrapped


def method_name(name: str) -> str:
    """The name of a kernel's function in the package."""
    # Functions of MATLAB and Octave: Octave warns of others with these names, even in a package.
    taken = frozenset({"single", "balance"})
    return f"{name}_" if name in taken else name


def render(material: Material) -> list[str]:
    """The definitions of the kernel's functions."""
    source = material.both_kernels
    own = words("".join(material.runtime.get("matlab", {}).values()), r"%[^\n]*")
    asked = [name for name in source.routines if method_name(name) in own]
    said: set[str] = set()
    return [
        _MatlabPrinter(it, source, material, said).definition() for it in printed(source, asked)
    ]


class _MatlabPrinter(Printer):
    begin, end, gives = "for pass = 1:{}", "end", "result = {};"

    def __init__(
        self, routine: Routine, source: Source, material: Material, said: set[str]
    ) -> None:
        inside = f"{material.library}.kernel."
        syntax = Syntax(
            primitives={
                "where": f"{inside}where",
                "maximum": f"{inside}larger",
                "minimum": f"{inside}smaller",
                "absolute": "abs",
                "sqrt": "sqrt",
                "cube_root": f"{inside}cube_root",
            },
            logic={ast.BitAnd: "&", ast.BitOr: "|", ast.Invert: "~"},
            algebra=lambda name: f"{material.library}.algebra.{name}",
            routine=lambda name: f"{inside}{method_name(name)}",
            signs={"*": ".*", "/": "./"},
        )
        super().__init__(routine, source, syntax)
        self.said = said
        self.numbers = {item.name: (item.value, item.comment) for item in source.constants}
        self.numbers |= {
            name: (value, "a count of roundings") for name, value in material.counts.items()
        }

    def definition(self) -> str:
        first, *rest = self.routine.summary.split("\n\n")
        given = ", ".join(name for name, _ in self.routine.arguments)
        lines = [
            f"function {self._returned()} = {method_name(self.routine.name)}({given})",
            *comment(f"{method_name(self.routine.name).upper()}  {first}", ""),
            *(line for paragraph in rest for line in ("%", *comment(paragraph, "  "))),
            *self._constants(),
        ]
        return _joined(lines) + self.body("  ") + "end\n"

    def _returned(self) -> str:
        """Name of the result, or names of several."""
        match self.routine.body[-1]:
            case ast.Return(value=ast.Tuple(elts=results)):
                return f"[{', '.join(f'result{index + 1}' for index in range(len(results)))}]"
        return "result"

    def _constants(self) -> Iterator[str]:
        """Assignments of the named numbers that this function uses, with their comments in the
        first function that uses them.
        """
        for name, (value, said) in self.numbers.items():
            if name in self.used:
                line = f"  {name} = {'Inf' if math.isinf(value) else number(value)};"
                said = "" if name in self.said else said
                self.said.add(name)
                beside = f"{line}  % {said}" if said else line
                yield from (
                    [beside]
                    if len(beside) <= WIDTH
                    else [*(f"  {above}" for above in comment(said, " ")), line]
                )

    def line(self, text: str, indent: str) -> str:
        return _joined(wrapped(f"{indent}{text}"))

    def comment(self, text: str, indent: str) -> str:
        return _joined([f"{indent}{line}" for line in comment(text, " ")])

    def assignment(self, name: str, value: ast.expr, indent: str) -> str:
        return self.line(f"{name} = {self.expressions.print(value)};", indent)

    def unpacking(self, target: ast.Tuple, called: ast.Call, indent: str) -> str:
        names = [name if name in self.used else "~" for name in places(target)]
        while names[-1] == "~":
            names.pop()
        return self.assignment(f"[{', '.join(names)}]", called, indent)

    def record(self, name: str, values: list[ast.expr], indent: str) -> str:
        listed = ", ".join(f"'{field}', {value}" for field, value in self.fields(name, values))
        return self.line(f"result = struct({listed});", indent)

    def several(self, values: list[ast.expr], indent: str) -> str:
        return "".join(
            self.assignment(f"result{index}", value, indent)
            for index, value in enumerate(values, 1)
        )


def _joined(lines: list[str]) -> str:
    return "".join(f"{line}\n" for line in lines)
