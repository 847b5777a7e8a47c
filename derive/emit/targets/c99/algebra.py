"""Generated algebra in C: the statements of the Python target, operation for operation."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from ...function import SPELLED, Function
from ...quantities import Quantity
from ...statements import Body, flatten, straight_line
from ..python.algebra import NAMES, AlgebraPrinter
from .layout import WIDTH, broken, comment, definition, plain

#: Angles by their names, and the arguments of the algebra that stand for one, cosine and sine last.
Angles = Mapping[str, tuple[str, ...]]

_LARGEST_EXACT = 2**53


class CPrinter(AlgebraPrinter):
    """The statements of the Python printer in C, operation for operation."""

    functions: ClassVar[Mapping[str, str]] = {name: name for name in NAMES} | {"abs": "fabs", "pi": "3.14159265358979323846"}

    def name(self, symbol: sp.Symbol) -> str:
        return c_name(str(symbol.name))

    def square(self, base: sp.Expr) -> str:
        return f"square({self._print(base)})"

    def _print_Integer(self, expression: sp.Integer) -> str:
        if abs(int(expression)) > _LARGEST_EXACT:
            raise ArithmeticError(f"the integer {expression} would be rounded")
        return f"{int(expression)}.0"

    def _print_One(self, expression: sp.Integer) -> str:
        return "1.0"

    def _print_Zero(self, expression: sp.Integer) -> str:
        return "0.0"

    def _print_NegativeOne(self, expression: sp.Integer) -> str:
        return "-1.0"

    def _print_Rational(self, expression: sp.Rational) -> str:
        # One division of two exact numbers: the rational, rounded once.
        numerator, denominator = sp.Integer(expression.p), sp.Integer(expression.q)
        return f"({self._print_Integer(numerator)}/{self._print_Integer(denominator)})"

    def _print_Pow(self, expression: sp.Pow, rational: bool = False) -> str:
        if expression.exp == 2:
            return self.square(expression.base)
        if expression.exp == -2:
            return f"1.0/{self.square(expression.base)}"
        return re.sub(r"^1/", "1.0/", super()._print_Pow(expression, rational=rational))


@dataclass(frozen=True)
class Emitted:
    """A static function of the C source."""

    name: str
    text: str
    operations: int


def c_name(name: str) -> str:
    """A name of the algebra as C has it."""
    return SPELLED.get(name, name)


def _name(symbol: sp.Symbol) -> str:
    return c_name(str(symbol))


def _result(function: Function) -> str:
    count = len(list(flatten(function.results)))
    return f"double result[{count}]" if isinstance(function.results, tuple) else "double *result"


def _signature(start: str, names: Iterable[str], result: str | None) -> str:
    arguments = [f"double {name}" for name in names] + ([] if result is None else [result])
    return broken(f"{start}({', '.join(arguments)})")


def taken(function: Function, angles: Angles) -> list[str]:
    """Arguments of the public function: those of the algebra, an angle in the place of its cosine and sine."""
    angle_of = {part: angle for angle, parts in angles.items() for part in parts}
    return list(dict.fromkeys(c_name(angle_of.get(str(symbol), str(symbol))) for symbol in function.arguments))


def static(name: str, function: Function) -> Emitted:
    """The algebra itself, unchecked: one result is returned, several are written to an array."""
    body = straight_line(function)
    used = {
        symbol for expression in [*dict(body.assignments).values(), *flatten(body.results)] for symbol in expression.free_symbols
    }
    several = isinstance(function.results, tuple)
    said = comment(f"{function.summary} Source: {function.equations}. Operations: {body.operations}.")
    start = f"INLINE {'void' if several else 'double'} {name}"
    head = f"{_signature(start, map(_name, function.arguments), _result(function) if several else None)} {{"
    lines = [
        *(f"    (void){_name(symbol)};" for symbol in function.arguments if symbol not in used),
        *_statements(body, "result" if several else "return"),
    ]
    return Emitted(name, said + definition(head, "".join(f"{line}\n" for line in lines)), body.operations)


def _statements(body: Body, result: str) -> list[str]:
    """Shorthands, then the results: into an array, or for one result behind what begins its statement."""
    if isinstance(body.results, tuple):
        results = [(f"{result}[{place}] =", value) for place, value in enumerate(flatten(body.results))]
    else:
        results = [(result, body.results)]
    named = [(f"const double {_name(symbol)} =", expression) for symbol, expression in body.statements]
    printer = CPrinter.of(body)
    return [broken(f"    {target} {_spaced(printer.doprint(expression))};") for target, expression in (*named, *results)]


def _spaced(expression: str) -> str:
    return re.sub(r"([*/])", r" \1 ", expression)


def public(function: Function, library: str, angles: Angles, *, inside: bool) -> str:
    """The public function: no null pointer in, no NaN out. What the library calls itself, ``inside``, stands in a function of its own."""
    count = len(list(flatten(function.results)))
    several = isinstance(function.results, tuple)
    names = taken(function, angles)
    if inside:
        arguments = ", ".join(map(_name, function.arguments))
        called = f"algebra_{function.name}({arguments}{', value' if several else ''});"
        computed = [broken(f"    {called if several else f'const double value = {called}'}")]
    else:
        computed = _statements(straight_line(function), "value" if several else "const double value =")
    asked = "\n".join(computed)
    return "\n".join([
        _signature(f"{library}_status {library}_{function.name}", names, _result(function)) + " {",
        broken(f"    const double given[] = {{{', '.join(names)}}};"),
        *([f"    double value[{count}];"] if several else []),
        f"    if (!result || !finite_all({len(names)}, given)) {{",
        f"        return {library.upper()}_BAD_INPUT;",
        "    }",
        *(
            f"    const double {part} = {turn}({angle});"
            for angle, parts in angles.items() if angle in names
            for turn, part in zip(("cos", "sin"), parts[-2:], strict=True) if re.search(rf"\b{part}\b", asked)
        ),
        *computed,
        f"    return deliver({count}, {'value' if several else '&value'}, result);",
        "}\n",
    ])  # fmt: skip


def prototype(function: Function, library: str, angles: Angles) -> str:
    """The declaration of the public function."""
    operations = straight_line(function).operations
    text = f"{function.summary} Result: {function.returns}. Source: {function.equations}. Operations: {operations}."
    said = textwrap.fill(plain(text), WIDTH - len(" */"), initial_indent="/** ", subsequent_indent=" * ")
    start = f"{library}_status {library}_{function.name}"
    return f"\n{said} */\n" + _signature(start, taken(function, angles), _result(function)) + ";\n"


def symbols(functions: Iterable[Function], quantities: Mapping[str, Quantity], angles: Angles) -> str:
    """What every argument of the public functions is, as lines of a comment."""
    known = {c_name(name): quantity for name, quantity in quantities.items()}
    names = dict.fromkeys(name for function in functions for name in taken(function, angles))
    return "\n * ".join(f"{name}: {plain(known[name].meaning)}" for name in names)
