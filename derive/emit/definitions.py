"""Generated functions parsed from their Python text, from which all other languages are printed
without SymPy.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

#: Largest length of a line of generated text.
WIDTH = 126
#: Other names for symbols that have the name of a function, for languages that would confuse them.
SPELLED = {"cos": "cos_theta", "sin": "sin_theta"}

#: The text of an expression, or a tuple of results.
Results = str | tuple["Results", ...]


@dataclass(frozen=True)
class Definition:
    """A generated function with its statements as text."""

    name: str
    summary: str
    returns: str
    equations: str
    operations: int
    arguments: tuple[str, ...]
    further: tuple[str, ...]  #: arguments that come last and default to 0
    statements: tuple[tuple[str, str], ...]  #: names and expressions, in order
    results: Results

    @property
    def accepted(self) -> tuple[str, ...]:
        """All arguments, in order."""
        return (*self.arguments, *self.further)

    @cached_property
    def leaves(self) -> tuple[str, ...]:
        """The results in order, without nesting."""
        return tuple(flat(self.results))

    @cached_property
    def read(self) -> frozenset[str]:
        """All names in its expressions."""
        return frozenset(
            word
            for text in (*dict(self.statements).values(), *self.leaves)
            for word in re.findall(r"\w+", text)
        )

    @property
    def origin(self) -> str:
        """The text of a comment: its equations and number of operations."""
        return f"Source: {self.equations}. Operations: {self.operations}."

    def spelled(self, of: Callable[[str], str]) -> Definition:
        """The function with ``of`` applied to all names and expressions."""

        def each(part: Results) -> Results:
            return tuple(map(each, part)) if isinstance(part, tuple) else of(part)

        changed: dict[str, Any] = {
            name: each(getattr(self, name))
            for name in ("arguments", "further", "statements", "results")
        }
        return replace(self, **changed)

    def tree(self, spelled: Mapping[str, str]) -> ast.Module:
        """The syntax tree of its statements and return statement, with some names replaced."""
        lines = [f"{name} = {expression}" for name, expression in self.statements]
        tree = ast.parse("\n".join([*lines, f"return {nested(self.results, '()', str)}"]))
        for node in ast.walk(tree):
            if isinstance(node, ast.Name):
                node.id = spelled.get(node.id, node.id)
        return tree


def flat(results: object) -> Iterator[Any]:
    """The leaves of a nested result in order."""
    if isinstance(results, tuple):
        for item in results:
            yield from flat(item)
    else:
        yield results


def nested(results: object, brackets: str, printed: Callable[[Any], str]) -> str:
    """The text of a nested result in brackets; a tuple of one ends in a comma."""
    if not isinstance(results, tuple):
        return printed(results)
    comma = "," if brackets == "()" and len(results) == 1 else ""
    items = ", ".join(nested(item, brackets, printed) for item in results)
    return f"{brackets[0]}{items}{comma}{brackets[1]}"


def of_module(text: str) -> tuple[Definition, ...]:
    """All functions of a generated module."""
    lines = text.splitlines()
    nodes = (node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef))
    return tuple(definition("\n".join(lines[node.lineno - 1 : node.end_lineno])) for node in nodes)


def definition(text: str) -> Definition:
    """Parse a generated function from its text, without decorators."""
    (node,) = ast.parse(text).body
    assert isinstance(node, ast.FunctionDef)
    docstring = re.compile(r"(.*?) Returns (.*?)\.(?: Source: (.*)\.)? Operations: (\d+)\.")
    said = docstring.fullmatch(" ".join((ast.get_docstring(node) or "").split()))
    assert said is not None, node.name
    names = [argument.arg for argument in node.args.args]
    count = len(names) - len(node.args.defaults)
    *assigned, last = node.body[1:]
    assert isinstance(last, ast.Return)
    assert last.value is not None
    statements = [
        (ast.unparse(it.targets[0]), _plain(text, it.value))
        for it in assigned
        if isinstance(it, ast.Assign)
    ]
    return Definition(
        node.name,
        said[1],
        said[2],
        said[3] or "",
        int(said[4]),
        tuple(names[:count]),
        tuple(names[count:]),
        tuple((name, value) for name, value in statements if name != "_one"),
        _results(text, last.value),
    )


def _results(text: str, node: ast.expr) -> Results:
    """The nested texts of returned values."""
    if isinstance(node, ast.Tuple):
        return tuple(_results(text, item) for item in node.elts)
    return _plain(text, node)


def _plain(text: str, node: ast.expr) -> str:
    """An expression on one line with fractions as divisions of integers, without the factor
    ``_one``, which only Python needs for other number types.
    """
    one_line = " ".join((ast.get_source_segment(text, node) or "").split())
    one_line = re.sub(r"\(?(-?\d+)\*_one/(\d+)\)?", r"(\1/\2)", one_line)
    return re.sub(
        r"(?<![\w.])\d+\.\d+(?:e[-+]?\d+)?",
        lambda found: f"({Fraction(float(found[0]))})",
        one_line,
    )


def ported(expression: str, names: Mapping[str, str], home: str = "") -> str:
    """An expression in another language, whose functions stand in ``home``: those that have other
    names there have these from ``names``.
    """
    return re.sub(
        r"xp\.(\w+)|\b(abs)(?=\()",
        lambda found: names.get(found[1] or found[2], f"{home}{found[1] or found[2]}"),
        expression,
    )


def with_reals(expression: str, written: str) -> str:
    """An expression whose integers are real numbers, in a format as ``{}.0``."""

    def real(found: re.Match[str]) -> str:
        largest_exact = 2**53
        if int(found[0]) > largest_exact:
            raise ArithmeticError(f"the integer {found[0]} would be rounded")
        return written.format(found[0])

    return re.sub(r"(?<![\w.])\d+(?![\w.])", real, expression)


def symbols(functions: Iterable[Definition]) -> dict[str, None]:
    """All arguments of functions, each once, in order."""
    return dict.fromkeys(name for function in functions for name in function.accepted)
