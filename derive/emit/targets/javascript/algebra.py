"""Generated algebra in JavaScript: the same statements as in Python, operation for operation, for
single numbers.
"""

import textwrap
from collections.abc import Iterable, Mapping

from ...definitions import WIDTH, Definition, nested, ported, symbols
from ...quantities import Quantity


def definition(function: Definition) -> str:
    """One method of the algebra: one result is returned as a number, several as an array, nested as
    in Python.
    """
    given = [f"{name} = 0" if name in function.further else name for name in function.accepted]
    return "\n".join(
        [
            comment(f"{function.summary} {function.origin}", "  "),
            wrapped(f"  {function.name}({', '.join(given)}) {{"),
            *(
                wrapped(f"    const {name} = {_printed(expression)};")
                for name, expression in function.statements
            ),
            wrapped(f"    return {nested(function.results, '[]', _printed)};"),
            "  },\n",
        ]
    )


def _printed(expression: str) -> str:
    return ported(expression, {"pi": "Math.PI"}, "Math.")


def meanings(functions: Iterable[Definition], quantities: Mapping[str, Quantity]) -> str:
    """The meanings of all arguments of some functions, as a comment."""
    return "".join(
        f"{comment(f'{name}: {quantities[name].meaning}')}\n" for name in symbols(functions)
    )


def comment(text: str, indent: str = "") -> str:
    """Lines of a comment."""
    return textwrap.fill(
        text, WIDTH, initial_indent=f"{indent}// ", subsequent_indent=f"{indent}// "
    )


def declaration(function: Definition) -> str:
    """The type of a function, as a member of an interface."""
    given = ", ".join(
        f"{name}{'?' if name in function.further else ''}: number" for name in function.accepted
    )
    said = f"  /** {function.summary} Source: {function.equations}. Returns {function.returns}. */"
    return (
        f"{said}\n  {function.name}({given}): "
        f"{nested(function.results, '[]', lambda _: 'number')};\n"
    )


def wrapped(line: str, further: str = "      ") -> str:
    """A statement on as many lines as it needs."""
    return textwrap.fill(
        line, WIDTH, subsequent_indent=further, break_long_words=False, break_on_hyphens=False
    )
