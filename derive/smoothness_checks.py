"""Checks that a page's expressions can be generated: they are smooth, and made of known functions.

The equations may have kinks only where a contact touches and at sliding speed 0, since equilibria
are searched with derivatives, and motions are integrated from one kink to the next. Each error
names the line, the expression and the remedy. A function that finds faults yields the end of the
message, after the statement's name.
"""

import itertools
from collections.abc import Iterator

import sympy as sp
from sympy import Expr, Symbol

from .emit.python.algebra import KNOWN
from .mechanics import DEPTH, SLIP, Mechanics, NormalForce
from .model import FUNCTIONS, WRITTEN, Contact, PageError, expression_of
from .statement_checks import statements


def check(model: Mechanics, *, only_equations: bool = False) -> None:
    """Raise a :class:`~derive.model.PageError` for the first statement that can't be generated; of
    a page of ``only_equations``, whose contact has no energy.
    """
    moving = {*model.coordinates, *model.rates, DEPTH, SLIP}
    turning = moving | {angle.symbol for angle in model.angles}
    for statement in () if only_equations else statements(model.page):
        value = model.scaled(statement.value)
        for fault in itertools.chain(
            _no_angles(value, turning),
            _kinks(value, moving),
            _unknown(value),
            _open_domains(value, moving),
        ):
            raise PageError(statement.line, f"{statement.what} {fault}")
    for entry, contact in zip(model.page.contacts, model.contacts, strict=False):
        _check_contact(model, entry, contact)


def _no_angles(value: Expr, turning: set[Symbol]) -> Iterator[str]:
    """Faults: cosines and sines of expressions without an angle in them."""
    for node in sorted(value.atoms(sp.cos, sp.sin), key=sp.default_sort_key):
        if not node.args[0].free_symbols & turning:
            yield (
                f"takes {node}, and {node.args[0]} is no angle of the page; make it a parameter "
                "with the unit rad"
            )


def _kinks(value: Expr, moving: set[Symbol]) -> Iterator[str]:
    """Faults: functions with a kink or a step at some state."""
    kinked = (sp.Abs, sp.sign, sp.Max, sp.Min, sp.Piecewise, sp.Heaviside, sp.floor, sp.ceiling)
    for node in sorted(value.atoms(*kinked), key=sp.default_sort_key):
        if node.free_symbols & moving:
            yield (
                f"holds {node}, which is not smooth where its argument changes its sign; "
                "kinks are at the touch of the belt and at "
                "the turn of friction only: write something smooth, as tanh, a power or an exp"
            )


def _unknown(value: Expr) -> Iterator[str]:
    """Faults: functions, exponents and numbers that generated code does not have."""
    if value.has(sp.I, sp.oo, sp.nan, sp.zoo):
        yield f"is {value}, which is no real number; write one that is"
    for node in sp.preorder_traversal(value):
        most_denominator = 1000
        if isinstance(node, sp.Pow) and not (
            isinstance(node.exp, sp.Rational) and node.exp.q <= most_denominator
        ):
            yield (
                f"holds {node}: an exponent is a fraction of two integers, as in "
                f"{node.base}**Rational(4, 3), and no other; "
                "what varies in it is said by exp and log"
            )
        if not isinstance(node, (*KNOWN, *WRITTEN)):
            yield (
                f"holds {node}, which generated code does not know; it knows "
                f"{', '.join(FUNCTIONS)}, sqrt and powers: write what "
                "is near it with these, or leave it out to derive the rest of the page"
            )


def _open_domains(value: Expr, moving: set[Symbol]) -> Iterator[str]:
    """Faults: roots and logarithms whose arguments are not shown to be in their domains.

    In a friction law arguments of roots have to be positive, since an integration step may end
    beyond speed 0.
    """
    border = {symbol: Symbol(symbol.name, nonnegative=True) for symbol in (DEPTH, SLIP)}
    closed = value.xreplace(border)
    varying = moving | set(border.values())
    for node in sorted(closed.atoms(sp.Pow, sp.log), key=sp.default_sort_key):
        argument, is_log = node.args[0], isinstance(node, sp.log)
        if not argument.free_symbols & varying or not (is_log or not node.exp.is_Integer):
            continue
        positive = is_log or argument.has(border[SLIP])
        forms = (argument, sp.factor_terms(sp.expand(argument)))
        if not any(form.is_positive or (not positive and form.is_nonnegative) for form in forms):
            yield (
                f"holds {node}, and {argument} is not seen to be "
                f"{'positive' if positive else 'not negative'}, 0 of its variables "
                f"included; take a form that is, as {'log' if is_log else 'sqrt'}(1 + …), of "
                "parameters that are positive"
            )


def _check_contact(model: Mechanics, entry: Contact, contact: NormalForce) -> None:
    """Raise if a contact's energy is not known, or its law can't be generated where it pulls."""
    energy = contact.energy
    if contact.gap is not None and not contact.unilateral:
        # Here the penetration may be negative, and the law has to be smooth there as well.
        depth = sp.Dummy(real=True)
        law = model.scaled(expression_of(entry.law(depth)))
        for fault in itertools.chain(_kinks(law, {depth}), _open_domains(law, {depth})):
            raise PageError(contact.line, f"the contact law, with unilateral=False, {fault}")
    unknown = [
        node
        for node in energy.atoms(sp.Function, sp.Integral, sp.nan, sp.zoo)
        if not isinstance(node, WRITTEN)
    ]
    if unknown or energy.has(sp.nan, sp.zoo, sp.oo, sp.I):
        raise PageError(
            contact.line,
            f"the contact law {contact.law} has no energy in {', '.join(FUNCTIONS)} and powers; "
            "give one whose integral SymPy finds in these",
        )
