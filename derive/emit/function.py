"""Functions to be generated, as SymPy expressions, gathered in modules."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import sympy as sp

from ..algebra import Names, Symbols

#: An expression, or a tuple of results.
Results = sp.Expr | tuple["Results", ...]


@dataclass(frozen=True)
class Function:
    """A function to be generated: ``results`` in its arguments and ``shorthands``, each of which is
    an expression in arguments and earlier shorthands.
    """

    name: str
    summary: str
    equations: str
    arguments: Symbols
    results: Results
    returns: str
    shorthands: Names = field(default_factory=dict)
    #: Arguments that a changed assumption adds to the published model; the last ones, 0 by default.
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
    """A function of a model, which follows from its page."""
    return Function(name, summary, "the page", taken, results, returns, shorthands or {})


def renamed(function: Function, spelled: Callable[[str], str]) -> Function:
    """The function with all symbols renamed."""

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
    """A module to be generated."""

    name: str
    summary: str
    functions: tuple[Function, ...]
