"""The functions that a page may be made of, and where each may stand: what code, intervals and balls are written for, and no more.

A law is smooth on each side of its border, and the borders of a motion are two: the gap, and the sliding speed. So a kink
elsewhere is refused, as are a root of what may be negative, a logarithm of what may be 0, and a function that no number type has.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from .model import FUNCTIONS, Contact, Friction, Page, PageError, expression_of
from .statements import expressions

#: What an expression may be made of beside :data:`~derive.model.FUNCTIONS`.
ALGEBRA = (sp.Symbol, sp.Rational, sp.Add, sp.Mul, sp.Pow, sp.core.numbers.Pi, sp.core.numbers.Exp1)
#: Largest denominator of an exponent: a float of it is read back as that fraction, and as no other.
LARGEST_ROOT = 1000


def check(page: Page) -> None:
    """All of it; a :class:`~derive.model.PageError` names the first line with a function that can't be carried through."""
    moving = {entry.symbol for entry in page.coordinates} | {entry.rate for entry in page.coordinates}
    for value, line in expressions(page):
        _check_known(value, "this statement", line)
        _check_kinks(value, moving, line)
        _check_domains(value, moving, "this statement", line, strict=False)
    if page.normal is not None:
        _check_contact(page.normal)
    if page.sliding is not None:
        _check_friction(page.sliding)


def _check_known(value: sp.Expr, what: str, line: int) -> None:
    """Every part is algebra, or a function of the vocabulary."""
    for node in sp.preorder_traversal(value):
        if node in (sp.I, sp.nan, sp.zoo, sp.oo, -sp.oo):
            raise PageError(
                line, f"{what} is {value}, which is no real number; look for roots of negative numbers and divisions by 0"
            )
        if isinstance(node, sp.Pow) and not _is_root(node.exp):
            raise PageError(
                line, f"{what} holds {node}: an exponent is a fraction of two integers, as Rational(4, 3), up to {LARGEST_ROOT}"
            )
        if not isinstance(node, (*ALGEBRA, *FUNCTIONS.values())):
            raise PageError(
                line,
                f"{what} holds {_named(node)}, which is not among the functions that can be carried through: {', '.join(FUNCTIONS)} "
                f"and powers. {_instead(node)}",
            )


def _is_root(exponent: sp.Expr) -> bool:
    return isinstance(exponent, sp.Rational) and exponent.q <= LARGEST_ROOT


def _named(node: sp.Basic) -> str:
    text = str(node)
    return text if len(text) < 60 else str(node.func)


def _instead(node: sp.Basic) -> str:
    if isinstance(node, sp.Min | sp.Max | sp.Piecewise | sp.Heaviside | sp.floor | sp.ceiling):
        return "It has a kink or a jump; a law is smooth but where the gap or the sliding speed is 0: write one formula, as tanh(v/v_s)"
    return "Write one of these that is near it, or leave it out: the rest of the page can be derived without it"


def _check_kinks(value: sp.Expr, moving: set[sp.Symbol], line: int) -> None:
    for node in sorted(value.atoms(sp.Abs, sp.sign), key=sp.default_sort_key):
        if node.free_symbols & moving:
            raise PageError(
                line,
                f"this statement holds {node}, which has a kink where {node.args[0]} = 0; a motion has borders where the gap and where the "
                "sliding speed is 0, and no other: take a smooth function, as sqrt(x**2 + r**2) for Abs(x)",
            )


def _check_domains(value: sp.Expr, of: set[sp.Symbol], what: str, line: int, strict: bool) -> None:
    """Roots are taken of what is not negative, of what is positive if ``strict``; logarithms of what is positive."""
    for node in sorted(value.atoms(sp.Pow, sp.log), key=sp.default_sort_key):
        argument = node.args[0]
        is_log = isinstance(node, sp.log)
        if not argument.free_symbols & of or not (is_log or not node.exp.is_Integer):
            continue
        positive = is_log or strict
        if not any(form.is_positive or (not positive and form.is_nonnegative) for form in _forms(argument)):
            raise PageError(
                line,
                f"{what} holds {node}, and {argument} is not seen to be {'positive' if positive else 'not negative'} everywhere, 0 "
                f'included: take a form that is, as {"log(1 + a*u)" if is_log else "sqrt(1 + a*u)"}, with domains "> 0" or ">= 0" of its '
                "parameters",
            )


def _forms(value: sp.Expr) -> Iterator[sp.Expr]:
    yield value
    yield sp.factor_terms(sp.expand(value))


# ------------------------------------------------------------------------------------------------ laws


def _check_contact(contact: Contact) -> None:
    """Smooth for every positive penetration; for every penetration if the mass never leaves."""
    what = "the contact law"
    one_sided = contact.unilateral or contact.gap is None
    u = sp.Symbol("depth", positive=True) if one_sided else sp.Symbol("depth", real=True)
    law = expression_of(contact.law(u))
    _check_known(law, what, contact.line)
    if any(node.has(u) for node in law.atoms(sp.Abs, sp.sign)):
        where = "at a penetration other than 0" if one_sided else "and this contact never opens (unilateral=False)"
        raise PageError(
            contact.line,
            f"{what} is {law}: it has a kink {where}, where no border is looked for; write a law that is smooth there",
        )
    _check_domains(*_closed(law, u, one_sided), what, contact.line, strict=False)


def _check_friction(friction: Friction) -> None:
    """Smooth on either side of v = 0, and beyond that border a little: a step may end behind it."""
    what = "the friction law"
    v = sp.Symbol("v", positive=True)
    for way in (1, -1):
        side = expression_of(friction.law(way * v))
        _check_known(side, what, friction.line)
        kinks = sorted((node for node in side.atoms(sp.Abs, sp.sign) if node.has(v)), key=sp.default_sort_key)
        if kinks:
            raise PageError(
                friction.line,
                f"{what} has a kink where {kinks[0].args[0]} = 0, not only where v = 0, where the belt and the mass are as fast; no border "
                "is looked for there: write a law that is smooth on each side of v = 0",
            )
        _check_domains(*_closed(side, v, True), what, friction.line, strict=True)


def _closed(law: sp.Expr, variable: sp.Symbol, one_sided: bool) -> tuple[sp.Expr, set[sp.Symbol]]:
    """The law with its border, and its variable."""
    if not one_sided:
        return law, {variable}
    border = sp.Symbol(variable.name, nonnegative=True)
    return law.xreplace({variable: border}), {border}
