"""What is generated: functions of algebra, gathered in modules."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import sympy as sp

from ..algebra import Names, Symbols

#: Nested results: an expression, or a tuple of such.
Results = sp.Expr | tuple["Results", ...]


@dataclass(frozen=True)
class Function:
    """One generated function: ``results`` in ``arguments`` and in ``shorthands``, each of these in
    arguments and earlier shorthands.
    """

    name: str
    summary: str
    equations: str
    arguments: Symbols
    results: Results
    returns: str
    shorthands: Names = field(default_factory=dict)
    #: Arguments that the published model does not have and a changed assumption brings in: they
    #: come last and default to 0.
    further: Symbols = ()

    @property
    def accepted(self) -> Symbols:
        """All arguments, in order."""
        return (*self.arguments, *self.further)


def of_page(
    name: str,
    summary: str,
    taken: Symbols,
    results: Results,
    returns: str,
    shorthands: Names | None = None,
) -> Function:
    """One of a model's own functions, which follow from its page."""
    return Function(name, summary, "the page", taken, results, returns, shorthands or {})


def renamed(function: Function, spelled: Callable[[str], str]) -> Function:
    """The function with all of its symbols spelled anew."""

    def of(part: Results) -> Results:
        if isinstance(part, tuple):
            return tuple(map(of, part))
        whole = sp.sympify(part)
        return whole.xreplace(
            {it: sp.Symbol(spelled(it.name), **it.assumptions0) for it in whole.free_symbols}
        )

    return replace(
        function,
        arguments=of(function.arguments),
        further=of(function.further),
        results=of(function.results),
        shorthands={of(symbol): of(value) for symbol, value in function.shorthands.items()},
    )


def rows(matrix: sp.Matrix) -> Results:
    """A matrix as a tuple of its rows."""
    return tuple(map(tuple, matrix.tolist()))


@dataclass(frozen=True)
class Module:
    """One generated module."""

    name: str
    summary: str
    functions: tuple[Function, ...]
