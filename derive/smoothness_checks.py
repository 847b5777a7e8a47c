"""Whether generated code can say what a page says: smooth, of functions that every number type has.

Kinks are where a mass touches the belt and where friction turns, and nowhere else: equilibria are sought by derivatives, and a motion
is integrated from one kink to the next. Each error names the line, what stands there, and the remedy.
"""

from __future__ import annotations

import sympy as sp

from . import laws
from .emit.python.algebra import KNOWN
from .mechanics import DEPTH, Mechanics
from .model import FUNCTIONS, WRITTEN, PageError, expression_of
from .statement_checks import statements

#: Functions with a kink or a step, of which a sum of smooth forces has none.
_KINKED = (sp.Abs, sp.sign, sp.Max, sp.Min, sp.Piecewise, sp.Heaviside, sp.floor, sp.ceiling)
#: Largest denominator of an exponent.
LARGEST_ROOT = 1000


def check(model: Mechanics) -> None:
    """A :class:`~derive.model.PageError` for the first statement that generated code can't say."""
    moving = {*model.coordinates, *model.rates, DEPTH, laws.SLIP}
    angles = {angle.symbol for angle in model.angles}
    for it in statements(model.page):
        value, what, line = model.scaled(it.value), it.what, it.line
        _check_angles(value, what, line, moving | angles)
        _check_kinks(value, what, line, moving)
        _check_known(value, what, line)
        _check_domains(value, what, line, moving)
    _check_contact(model)


def _check_angles(value: sp.Expr, what: str, line: int, turning: set[sp.Symbol]) -> None:
    for node in sorted(value.atoms(sp.cos, sp.sin), key=sp.default_sort_key):
        inner = node.args[0]
        if not inner.free_symbols & turning:
            raise PageError(
                line, f"{what} takes {node}, and {inner} is no angle of the page; make it a parameter with the unit rad"
            )


def _check_kinks(value: sp.Expr, what: str, line: int, moving: set[sp.Symbol]) -> None:
    for node in sorted(value.atoms(*_KINKED), key=sp.default_sort_key):
        if node.free_symbols & moving:
            raise PageError(
                line,
                f"{what} holds {node}, which is not smooth where its argument changes its sign; kinks are at the touch of the belt and at "
                "the turn of friction only: write something smooth, as tanh, a power or an exp",
            )


def _check_known(value: sp.Expr, what: str, line: int) -> None:
    """Algebra, and functions that every number type has."""
    if value.has(sp.I, sp.oo, sp.nan, sp.zoo):
        raise PageError(line, f"{what} is {value}, which is no real number; write one that is")
    for node in sp.preorder_traversal(value):
        if isinstance(node, sp.Pow) and not (isinstance(node.exp, sp.Rational) and node.exp.q <= LARGEST_ROOT):
            raise PageError(
                line,
                f"{what} holds {node}: an exponent is a fraction of two integers, as in {node.base}**Rational(4, 3), and no other; "
                "what varies in it is said by exp and log",
            )
        if not isinstance(node, (*KNOWN, *WRITTEN)):
            raise PageError(
                line,
                f"{what} holds {node}, which generated code does not know; it knows {', '.join(FUNCTIONS)}, sqrt and powers: write what "
                "is near it with these, or leave it out to derive the rest of the page",
            )


def _check_domains(value: sp.Expr, what: str, line: int, moving: set[sp.Symbol]) -> None:
    """Roots of what is not negative, and in friction of what is positive, for a step may end behind its border; logarithms of that."""
    border = {symbol: sp.Symbol(symbol.name, nonnegative=True) for symbol in (DEPTH, laws.SLIP)}
    closed = value.xreplace(border)
    varying = moving | set(border.values())
    for node in sorted(closed.atoms(sp.Pow, sp.log), key=sp.default_sort_key):
        argument = node.args[0]
        if not argument.free_symbols & varying or not (isinstance(node, sp.log) or not node.exp.is_Integer):
            continue
        positive = isinstance(node, sp.log) or argument.has(border[laws.SLIP])
        forms = (argument, sp.factor_terms(sp.expand(argument)))
        if not any(form.is_positive or (not positive and form.is_nonnegative) for form in forms):
            raise PageError(
                line,
                f"{what} holds {node}, and {argument} is not seen to be {'positive' if positive else 'not negative'}, 0 of its variables "
                f"included; take a form that is, as {'log' if isinstance(node, sp.log) else 'sqrt'}(1 + …), of parameters that are positive",
            )


def _check_contact(model: Mechanics) -> None:
    contact, energy = model.page.normal, model.contact_energy
    if contact is None:
        return
    if contact.gap is not None and not contact.unilateral:
        # The penetration is of either sign: what is smooth where it is positive may not be so beyond.
        depth = sp.Dummy(real=True)
        law = model.scaled(expression_of(contact.law(depth)))
        _check_kinks(law, "the contact law, with unilateral=False,", contact.line, {depth})
        _check_domains(law, "the contact law, with unilateral=False,", contact.line, {depth})
    unknown = [node for node in energy.atoms(sp.Function, sp.Integral, sp.nan, sp.zoo) if not isinstance(node, WRITTEN)]
    if unknown or energy.has(sp.nan, sp.zoo, sp.oo, sp.I):
        raise PageError(
            contact.line,
            f"the contact law {model.law} has no energy in {', '.join(FUNCTIONS)} and powers; give one whose integral SymPy finds in these",
        )
