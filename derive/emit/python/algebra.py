"""Python modules of plain algebra, for any number type that has + − × ÷ and integer powers."""

from __future__ import annotations

import itertools
import re
import textwrap
from collections.abc import Iterable, Mapping
from typing import Any

import sympy as sp
from sympy import Add, Expr, Symbol
from sympy.printing.str import StrPrinter

from ..definitions import WIDTH, nested
from ..function import Function, Module, Results
from ..quantities import Quantity
from ..statements import Body, straight_line

#: What is printed: algebra, and functions by their names.
KNOWN = (Symbol, sp.Rational, Add, sp.Mul, sp.Pow, sp.core.numbers.Pi, sp.core.numbers.Exp1)
BY_NAME: Mapping[type[sp.Basic], str] = {
    sp.exp: "exp",
    sp.log: "log",
    sp.tanh: "tanh",
    sp.atan: "atan",
    sp.cos: "cos",
    sp.sin: "sin",
    sp.atan2: "atan2",
    sp.Abs: "abs",
    sp.sign: "sign",
}


class RoundedError(ArithmeticError):
    """A fraction that would be rounded: it stands by itself, where no number type makes an
    enclosure of it.
    """


class AlgebraPrinter(StrPrinter):
    """Python source in which a rational coefficient stays a multiplication and a division by
    integers.
    """

    def __init__(self, body: Body, one: str = "") -> None:
        """For the statements of a function; ``one`` names a 1 of its arguments' type, without which
        no fraction may stand by itself.
        """
        super().__init__({"order": None})
        self.body, self.one = body, one

    def square(self, base: Expr) -> str:
        """A square."""
        return f"{self._print(base)}*{self._print(base)}"

    def parenthesize(self, item: sp.Basic, level: int, strict: bool = False) -> str:
        if item in self.body.negated:  # a factor, of a product that turns its own sign
            return str(self._print(-self.body.negated[item]))
        text = str(super().parenthesize(item, level, strict))
        return f"({text})" if item in self.body.inlined and "*" in text else text

    def _print_Mul(self, expression: sp.Mul) -> str:
        # A square that comes first is computed first without brackets.
        # An unevaluated −(−a) would be a decrement in C.
        plain = super()._print_Mul(expression).removeprefix("--")
        text = re.sub(r"^(-?)\((\w+\*\w+)\)", r"\1\2", plain)
        if sum(factor in self.body.negated for factor in expression.args) % 2 == 0:
            return text
        return text.removeprefix("-") if text.startswith("-") else f"-{text}"

    def _print_Symbol(self, expression: Symbol) -> str:
        value = self.body.inlined.get(expression)
        if value is None:
            return str(expression.name)
        return self.square(value.base) if value.is_Pow else str(self._print(value))

    def call(self, name: str, *arguments: Expr) -> str:
        """A function of these arguments."""
        # −x*x is the product of −x and x, which to intervals is no square: of both signs, where a
        # bell exp(−x*x) is at most 1.
        given = (re.sub(r"^-((\w+)\*\2)\b", r"-(\1)", self._print(one)) for one in arguments)
        return f"{'' if name == 'abs' else 'xp.'}{name}({', '.join(given)})"

    def _print(self, expression: sp.Basic, **options: Any) -> str:
        # The printer of SymPy writes whatever it is given, under SymPy's name for it.
        if not isinstance(expression, (*KNOWN, *BY_NAME)):
            raise ArithmeticError(
                f"{type(expression).__name__} is no function that code is written for: {expression}"
            )
        return str(super()._print(expression, **options))

    def _print_Rational(self, expression: sp.Rational) -> str:
        # x/2 is printed by the product that holds the 1/2; a fraction on its own would be a float,
        # which some are exactly.
        if (
            expression.q & (expression.q - 1) == 0
            and abs(expression.p) < 2**53
            and expression.q < 2**53
        ):
            return repr(expression.p / expression.q)
        if self.one:
            return f"({expression.p}*{self.one}/{expression.q})"
        raise RoundedError(
            f"the rational {expression.p}/{expression.q} would be rounded: bring the sum over "
            "one denominator"
        )

    def _print_Add(self, expression: Add, order: str | None = None) -> str:
        constant, rest = expression.as_coeff_Add()
        if constant.is_Integer:
            return str(super()._print_Add(expression, order))
        over = Add(*(constant.q * term for term in Add.make_args(rest)), constant.p)
        return f"({super()._print_Add(over, order)})/{constant.q}"

    def _print_Pow(self, expression: sp.Pow, rational: bool = False) -> str:
        if expression.exp == -1:
            return str(super()._print_Pow(expression, rational=rational))
        if abs(expression.exp.p) != 1 or not expression.exp.is_Rational:
            raise ArithmeticError(
                f"{expression} is not a reciprocal or a root: powers are products by now"
            )
        base, order = expression.base, expression.exp.q  # of what is not negative; of 0, exp(−∞)
        root = (
            self.call("sqrt", base) if order == 2 else f"xp.exp({self.call('log', base)}/{order})"
        )
        return root if expression.exp > 0 else f"1/{root}"

    def _print_Function(self, expression: sp.Function) -> str:
        return self.call(BY_NAME[expression.func], *expression.args)

    # SymPy's printer has methods of its own for these.
    _print_exp = _print_log = _print_Abs = _print_sign = _print_Function

    def _print_Exp1(self, expression: Expr) -> str:
        return self.call("exp", sp.S.One)

    def _print_Pi(self, expression: Expr) -> str:
        return "xp.pi"


def render(module: Module, quantities: Mapping[str, Quantity], header: str) -> str:
    """Source text of one generated module: its symbols with meanings and units once, then its
    functions.
    """
    meanings = {
        name: it.meaning + (f" [{it.unit}]" if it.unit != "1" else "")
        for name, it in quantities.items()
    }
    return whole(
        module,
        meanings,
        header,
        ["from ._broadcast import broadcasting"],
        map(definition, module.functions),
    )


def whole(
    module: Module,
    meanings: Mapping[str, str],
    header: str,
    imports: list[str],
    definitions: Iterable[str],
) -> str:
    """A module: what it is, what its symbols are, imports and functions; at its foot these get the
    shape of their results.
    """
    body = list(definitions)
    if any("xp=numpy" in text for text in body):
        imports = ["import numpy", "", *imports]
    symbols = dict.fromkeys(
        str(symbol) for function in module.functions for symbol in function.accepted
    )
    table = "\n".join(
        textwrap.fill(f"{name} : {meanings[name]}", WIDTH - 2, subsequent_indent="    ")
        for name in symbols
    )
    summary, table = (
        text.replace("\\", r"\\").replace('""', r'"\"') for text in (module.summary, table)
    )
    said = f'"""{summary}\n\n{table}\n\n{textwrap.fill(header, WIDTH - 2)}\n"""\n\n'
    return (
        said
        + "\n\n\n".join(["\n".join(imports), *body, "__all__ = broadcasting(globals())"])
        + "\n"
    )


def listed(opening: str, items: Iterable[str], closing: str) -> str:
    """A list between brackets, on as many lines as it needs."""
    inside = textwrap.fill(
        ", ".join(items), WIDTH - 2, initial_indent="    ", subsequent_indent="    "
    )
    return f"{opening}\n{inside},\n{closing}"


def definition(function: Function, trimmed: bool = False) -> str:
    """One function: its signature, what it is with its equations and operations, and its body.

    With ``trimmed``, the last arguments that its body does not read are taken as ``*_``, so that
    functions of several models that read the same are the same.
    """
    body = straight_line(function)
    statements = _statements(function, body)
    arguments = [*map(str, function.arguments), *(f"{symbol}=0" for symbol in function.further)]
    further = ["*", "xp=numpy"] if any("xp." in line for line in statements) else []
    if trimmed:
        read = set(re.findall(r"\w+", " ".join(statements)))
        unread = len(list(itertools.takewhile(lambda name: name not in read, arguments[::-1])))
        if unread:
            arguments, further = arguments[:-unread], ["*_", *further[1:]]
    arguments += further
    signature = f"def {function.name}({', '.join(arguments)}):"
    if len(signature) > WIDTH:
        signature = listed(f"def {function.name}(", arguments, "):")
    return "\n".join(
        [signature, textwrap.indent(_docstring(function, body.operations), "    "), *statements]
    )


def _statements(function: Function, body: Body) -> list[str]:
    """Assignments and the return statement; where a fraction stands by itself, after a 1 of the
    arguments' number type.
    """
    try:
        return _printed(AlgebraPrinter(body))
    except RoundedError:
        if not function.accepted:
            raise
    printer = AlgebraPrinter(body, "_one")
    return [
        _wrap(f"    {printer.one} = 0*({' + '.join(map(str, function.accepted))}) + 1"),
        *_printed(printer),
    ]


def _printed(printer: AlgebraPrinter) -> list[str]:
    assigned = [
        # A square is always a whole right side.
        _wrap(
            f"    {symbol} = "
            f"{printer.square(it.base) if it.is_Pow and it.exp == 2 else printer.doprint(it)}"
        )
        for symbol, it in printer.body.statements
    ]
    return [*assigned, _return(printer.body.results, printer)]


def _return(results: Results, printer: AlgebraPrinter) -> str:
    """The return statement, on one line or one result a line."""
    line = f"    return {nested(results, '()', printer.doprint)}"
    if len(line) <= WIDTH or not isinstance(results, tuple):
        return _wrap(line)
    return (
        "    return (\n"
        + "".join(f"{_wrap(' ' * 8 + nested(item, '()', printer.doprint))},\n" for item in results)
        + "    )"
    )


def _wrap(line: str) -> str:
    """Break a long statement between terms, inside brackets."""
    if len(line) <= WIDTH:
        return line
    indent = " " * (len(line) - len(line.lstrip()))
    head, separator, rest = line.strip().rpartition(" = ")
    if line.strip().startswith("return "):
        head, separator, rest = "return", " ", line.strip().removeprefix("return ")
    pieces = textwrap.wrap(
        rest, WIDTH - len(indent) - 4, break_long_words=False, break_on_hyphens=False
    )
    return (
        f"{indent}{head}{separator}(\n"
        + "\n".join(f"{indent}    {piece}" for piece in pieces)
        + f"\n{indent})"
    )


def _docstring(function: Function, operations: int) -> str:
    """Docstring of a function: its subject, results, equations and operations; arguments are
    described at the head of the module.
    """
    source = f" Source: {function.equations}." if function.equations else ""
    text = f'"""{function.summary} Returns {function.returns}.{source} Operations: {operations}."""'
    return textwrap.fill(text, WIDTH - 4, break_long_words=False, break_on_hyphens=False)
