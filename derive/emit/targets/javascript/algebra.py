"""Generated algebra in JavaScript: the statements of the Python target, operation for operation, for one number at a time."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping
from typing import ClassVar

from ...function import Function, Results
from ...quantities import Quantity
from ...statements import straight_line
from ..python.algebra import NAMES, DividingPrinter

_WIDTH = 130


class JavaScriptPrinter(DividingPrinter):
    """Algebra in JavaScript."""

    functions: ClassVar[Mapping[str, str]] = {name: f"Math.{name}" for name in NAMES} | {"pi": "Math.PI"}


def definition(function: Function) -> str:
    """One method of the algebra: one result is returned as a number, several as an array, nested as in Python."""
    body = straight_line(function)
    printer = JavaScriptPrinter.of(body)
    given = [f"{symbol} = 0" if symbol in function.further else str(symbol) for symbol in function.accepted]
    return "\n".join([
        _comment(f"{function.summary} Source: {function.equations}. Operations: {body.operations}.", "  "),
        _wrapped(f"  {function.name}({', '.join(given)}) {{"),
        *(_wrapped(f"    const {symbol} = {printer.doprint(expression)};") for symbol, expression in body.statements),
        _wrapped(f"    return {_nested(body.results, printer)};"),
        "  },\n",
    ])  # fmt: skip


def symbols(functions: Iterable[Function], quantities: Mapping[str, Quantity]) -> str:
    """What every argument of the algebra is, as a comment."""
    names = dict.fromkeys(str(symbol) for function in functions for symbol in function.accepted)
    return "".join(f"{_comment(f'{name}: {quantities[name].meaning}')}\n" for name in names)


def _comment(text: str, indent: str = "") -> str:
    return textwrap.fill(text, _WIDTH, initial_indent=f"{indent}// ", subsequent_indent=f"{indent}// ")


def declaration(function: Function) -> str:
    """Its type, as a member of an object."""
    further = set(function.further)
    given = ", ".join(f"{symbol}{'?' if symbol in further else ''}: number" for symbol in function.accepted)
    said = f"  /** {function.summary} Source: {function.equations}. Returns {function.returns}. */"
    return f"{said}\n  {function.name}({given}): {_type(function.results)};\n"


def _type(results: Results) -> str:
    return f"[{', '.join(map(_type, results))}]" if isinstance(results, tuple) else "number"


def _nested(results: Results, printer: JavaScriptPrinter) -> str:
    if isinstance(results, tuple):
        return f"[{', '.join(_nested(item, printer) for item in results)}]"
    return str(printer.doprint(results))


def _wrapped(line: str) -> str:
    return textwrap.fill(line, _WIDTH, subsequent_indent="      ", break_long_words=False, break_on_hyphens=False)
