"""Generated algebra in MATLAB, for arrays of any one size; nested results come one after the other."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from typing import ClassVar

import sympy as sp

from ...function import Function
from ...statements import Body, flatten, straight_line
from ..python.algebra import NAMES, DividingPrinter

#: Of a function, which is indented by four.
WIDTH = 126


class MatlabPrinter(DividingPrinter):
    """Algebra in MATLAB."""

    functions: ClassVar[Mapping[str, str]] = {name: name for name in NAMES}

    def doprint(self, expr: sp.Expr) -> str:
        """An expression in which every product and quotient is one of elements; powers are products by now."""
        return str(super().doprint(expr)).replace("*", ".*").replace("/", "./")


def definition(function: Function) -> str:
    """One function."""
    body = straight_line(function)
    printer = MatlabPrinter.of(body)
    results = list(flatten(body.results))
    names = _outputs(body, results)
    given = ", ".join(map(str, function.accepted))
    returned = names[0] if len(names) == 1 else f"[{', '.join(names)}]"
    lines = [
        *wrapped(f"function {returned} = {function.name}({given})"),
        *comment(
            f"{function.name.upper()}  {function.summary} Returns {function.returns}. "
            f"Source: {function.equations}. Operations: {body.operations}.", ""
        ),
    ]  # fmt: skip
    if function.further:
        missing = len(function.arguments)
        for place, symbol in enumerate(function.further):
            lines += [f"  if nargin < {missing + place + 1}", f"    {symbol} = 0;", "  end"]
    statements = [*((str(symbol), value) for symbol, value in body.statements), *zip(names, results, strict=True)]
    for name, value in statements:
        if name != str(value):
            lines += wrapped(f"  {name} = {printer.doprint(value)};")
    return "\n".join([*lines, "end", ""])


def _outputs(body: Body, results: list[sp.Expr]) -> list[str]:
    """Names of what is returned: of a result that has a statement of its own, the name there."""
    named = {symbol for symbol, _ in body.statements if results.count(symbol) == 1}
    return [str(value) if value in named else f"result{place}" for place, value in enumerate(results, 1)]


def comment(text: str, indent: str) -> list[str]:
    """Lines of a help text."""
    return textwrap.wrap(text, WIDTH, initial_indent=f"%{indent}", subsequent_indent="%  ", break_on_hyphens=False)


def wrapped(line: str) -> list[str]:
    """A statement on as many lines as it needs, broken at spaces, and after brackets where these leave a line too long."""
    if len(line) <= WIDTH:
        return [line]
    width = WIDTH - len(" ...")
    indent = " " * (len(line) - len(line.lstrip()) + 4)
    wrapper = textwrap.TextWrapper(width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)
    broken = wrapper.wrap(line)
    if max(map(len, broken)) > width:
        broken = [part.replace("(\0 ", "(").replace("(\0", "(") for part in wrapper.wrap(line.replace("(", "(\0 "))]
    return [*(f"{part} ..." for part in broken[:-1]), broken[-1]]
