"""Generated functions as their Python text has them, which is what every other language is printed
from; without SymPy.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

#: Characters of a line of generated text; that of a method is indented by four more.
WIDTH = 126
#: Functions that generated algebra calls, by what follows ``xp.``; ``abs`` is a built-in one.
NAMES = ("sqrt", "pi", "exp", "log", "tanh", "atan", "cos", "sin", "atan2", "abs", "sign")
#: Symbols with the name of a function that languages have, and what stands for them where the two
#: would be confused.
SPELLED = {"cos": "cos_theta", "sin": "sin_theta"}

#: Nested results: the text of an expression, or a tuple of such.
Results = str | tuple["Results", ...]


@dataclass(frozen=True)
class Definition:
    """One generated function: what it is, and its statements as text."""

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
        """The results in order."""
        return tuple(flat(self.results))

    @cached_property
    def read(self) -> frozenset[str]:
        """Names that its expressions have."""
        return frozenset(
            word
            for text in (*dict(self.statements).values(), *self.leaves)
            for word in re.findall(r"\w+", text)
        )

    @property
    def origin(self) -> str:
        """Its equations, and how many operations it takes, in a comment."""
        return f"Source: {self.equations}. Operations: {self.operations}."

    def spelled(self, of: Callable[[str], str]) -> Definition:
        """The function with all names and expressions spelled anew."""

        def each(part: Results) -> Results:
            return tuple(map(each, part)) if isinstance(part, tuple) else of(part)

        changed: dict[str, Any] = {
            name: each(getattr(self, name))
            for name in ("arguments", "further", "statements", "results")
        }
        return replace(self, **changed)

    def tree(self, spelled: Mapping[str, str]) -> ast.Module:
        """Statements and return statement of a function, with other names for some."""
        lines = [f"{name} = {expression}" for name, expression in self.statements]
        tree = ast.parse("\n".join([*lines, f"return {nested(self.results, '()', str)}"]))
        for node in ast.walk(tree):
            if isinstance(node, ast.Name):
                node.id = spelled.get(node.id, node.id)
        return tree


def flat(results: object) -> Iterator[Any]:
    """Leaves of a nested result, of texts or of expressions, in order."""
    if isinstance(results, tuple):
        for item in results:
            yield from flat(item)
    else:
        yield results


def nested(results: object, brackets: str, printed: Callable[[Any], str]) -> str:
    """A nested result between brackets; a tuple of one ends with a comma."""
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
    """A function from its text, without decorators."""
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
    if isinstance(node, ast.Tuple):
        return tuple(_results(text, item) for item in node.elts)
    return _plain(text, node)


def _plain(text: str, node: ast.expr) -> str:
    """An expression on one line, fractions as divisions of whole numbers: a 1 of the arguments'
    type is for Python only.
    """
    one_line = " ".join((ast.get_source_segment(text, node) or "").split())
    one_line = re.sub(r"\(?(-?\d+)\*_one/(\d+)\)?", r"(\1/\2)", one_line)
    return re.sub(
        r"(?<![\w.])\d+\.\d+(?:e[-+]?\d+)?",
        lambda found: f"({Fraction(float(found[0]))})",
        one_line,
    )


def ported(expression: str, functions: Mapping[str, str]) -> str:
    """An expression with another language's names of functions."""
    return re.sub(
        r"xp\.(\w+)|\b(abs)(?=\()", lambda found: functions[found[1] or found[2]], expression
    )


def symbols(functions: Iterable[Definition]) -> dict[str, None]:
    """All arguments of functions, each once, in order."""
    return dict.fromkeys(name for function in functions for name in function.accepted)
