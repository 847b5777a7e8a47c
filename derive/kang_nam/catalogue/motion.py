"""The page's equations of motion as a library in another language offers them: n̄ for contact, and only arguments that are read."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from ... import laws, motion
from ...emit.function import Function, Module, Results
from ...emit.statements import straight_line
from ...mechanics import PUSHING
from .. import mechanics
from .. import nomenclature as nm

#: The functions of the page that the library has, and the equations that are in them.
EQUATIONS = {
    "rhs": "(8)–(11)", "regime_rhs": "(8)–(10)", "regime_jacobian": "(8)–(10)", "regime_by_parameters": "(8)–(10)",
    "energy": "(1), (2)", "friction_power": "(8)",
}  # fmt: skip

#: Those that take no more than they read; the others take all that a motion is given.
_SHORT = ("energy", "friction_power")


def module() -> Module:
    """In Python they stand with the page's other functions, in ``models/kang_nam/algebra.py``."""
    model = mechanics.of_page()
    general = motion.module(model)
    names: dict[sp.Basic, sp.Expr] = {PUSHING: nm.nbar, **dict.fromkeys(laws.near(len(laws.layers(model))), sp.S.One)}
    known = {function.name: function for function in general.functions}
    functions = (replace(_renamed(known[name], names), equations=where) for name, where in EQUATIONS.items())
    return replace(general, functions=tuple(functions))


def _renamed(function: Function, names: dict[sp.Basic, sp.Expr]) -> Function:
    """A function with other symbols, or numbers, in the place of some."""
    arguments = tuple(symbol for symbol in (names.get(symbol, symbol) for symbol in function.arguments) if symbol.is_Symbol)
    shorthands = {names.get(symbol, symbol): value.xreplace(names) for symbol, value in function.shorthands.items()}
    renamed = replace(function, arguments=arguments, results=_mapped(function.results, names), shorthands=shorthands)
    return replace(renamed, arguments=_read(renamed)) if function.name in _SHORT else renamed


def _mapped(results: Results, names: dict[sp.Basic, sp.Expr]) -> Results:
    return tuple(_mapped(part, names) for part in results) if isinstance(results, tuple) else sp.sympify(results).xreplace(names)


def _read(function: Function) -> tuple[sp.Symbol, ...]:
    body = straight_line(function)
    read = {symbol for value in (*dict(body.assignments).values(), body.results) for symbol in sp.sympify(value).free_symbols}
    return tuple(symbol for symbol in function.arguments if symbol in read)
