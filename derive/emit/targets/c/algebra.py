"""Generated algebra in C: the same statements as in Python, operation for operation."""

import re
import textwrap
from collections.abc import Iterable, Mapping

from ...definitions import SPELLED, WIDTH, Definition, ported, with_reals
from ...quantities import Quantity
from .. import Angles, taken
from .layout import broken, comment, definition, plain


def _expression(text: str) -> str:
    """An expression in C: integers become doubles, and a square a call."""
    text = re.sub(
        r"(?<!\w)\((\w+)\*\1\)|\b(\w+)\*\2\b", lambda found: f"square({found[1] or found[2]})", text
    )
    text = with_reals(text, "{}.0")
    text = re.sub(r"(?<![\w.])(cos|sin)\b(?!\()", lambda found: SPELLED[found[1]], text)
    names = {"abs": "fabs", "pi": "3.14159265358979323846"}
    return re.sub(r"([*/])", r" \1 ", ported(text, names))


def c_name(name: str) -> str:
    """The C name of a function of the algebra."""
    return SPELLED.get(name, name)


def _result(function: Definition) -> str:
    if isinstance(function.results, tuple):
        return f"double result[{len(function.leaves)}]"
    return "double *result"


def _signature(start: str, names: Iterable[str], result: str | None) -> str:
    arguments = [f"double {name}" for name in names] + ([] if result is None else [result])
    return broken(f"{start}({', '.join(arguments)})")


def static(name: str, function: Definition) -> str:
    """The function without checks: one result is returned, several are written to an array."""
    several = isinstance(function.results, tuple)
    said = comment(f"{function.summary} {function.origin}")
    start = f"INLINE {'void' if several else 'double'} {name}"
    result = _result(function) if several else None
    head = f"{_signature(start, map(c_name, function.arguments), result)} {{"
    unused = [
        f"    (void){c_name(name)};" for name in function.arguments if name not in function.read
    ]
    lines = [*unused, *_statements(function, "result" if several else "return"), ""]
    return said + definition(head, "\n".join(lines))


def _statements(function: Definition, result: str) -> list[str]:
    """The statements of the shorthands, then those of the results; ``result`` is the array, or the
    beginning of the statement for a single result.
    """
    if isinstance(function.results, tuple):
        results = [(f"{result}[{index}] =", value) for index, value in enumerate(function.leaves)]
    else:
        results = [(result, function.results)]
    named = [
        (f"const double {c_name(name)} =", expression) for name, expression in function.statements
    ]
    return [
        broken(f"    {target} {_expression(expression)};")
        for target, expression in (*named, *results)
    ]


def public(function: Definition, library: str, angles: Angles, *, inside: bool) -> str:
    """The public function, which refuses a null pointer and a NaN. If the library calls the
    function itself, ``inside``, the public one calls the one without checks.
    """
    count = len(function.leaves)
    several = isinstance(function.results, tuple)
    names = list(map(c_name, taken(function, angles)))
    if inside:
        arguments = ", ".join(map(c_name, function.arguments))
        called = f"algebra_{function.name}({arguments}{', value' if several else ''});"
        computed = [broken(f"    {called if several else f'const double value = {called}'}")]
    else:
        computed = _statements(function, "value" if several else "const double value =")
    asked = "\n".join(computed)
    return "\n".join(
        [
            _signature(f"{library}_status {library}_{function.name}", names, _result(function))
            + " {",
            broken(f"    const double given[] = {{{', '.join(names)}}};"),
            *([f"    double value[{count}];"] if several else []),
            f"    if (!result || !finite_all({len(names)}, given)) {{",
            f"        return {library.upper()}_BAD_INPUT;",
            "    }",
            *(
                f"    const double {part} = {turn}({angle});"
                for angle, parts in angles.items()
                if angle in names
                for turn, part in zip(("cos", "sin"), parts[-2:], strict=True)
                if re.search(rf"\b{part}\b", asked)
            ),
            *computed,
            f"    return deliver({count}, {'value' if several else '&value'}, result);",
            "}\n",
        ]
    )


def prototype(function: Definition, library: str, angles: Angles) -> str:
    """The declaration of the public function."""
    text = f"{function.summary} Result: {function.returns}. {function.origin}"
    said = textwrap.fill(
        plain(text), WIDTH - len(" */"), initial_indent="/** ", subsequent_indent=" * "
    )
    start = f"{library}_status {library}_{function.name}"
    return (
        f"\n{said} */\n"
        + _signature(start, map(c_name, taken(function, angles)), _result(function))
        + ";\n"
    )


def symbols(
    functions: Iterable[Definition], quantities: Mapping[str, Quantity], angles: Angles
) -> str:
    """The meanings of all arguments of some public functions, as lines of a comment."""
    by_name = {c_name(name): quantity for name, quantity in quantities.items()}
    names = dict.fromkeys(
        c_name(name) for function in functions for name in taken(function, angles)
    )
    return "\n * ".join(f"{name}: {plain(by_name[name].meaning)}" for name in names)
