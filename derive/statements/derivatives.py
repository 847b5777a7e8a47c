"""Derivatives that a print names: ∂V/∂x and d/dt (∂L/∂x′) of energies, f′(x) of what a paper
defines, μ′ of a friction law; as names ``diff(V, x)``, ``diff(diff(L, vx), t)``, ``diff(f)``.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from .. import laws
from ..mechanics import SLIP, FrictionForce
from .names import AT_REST
from .objects import TIME, Derivation
from .tree import Node, Unread, Vocabulary, read_sympy


@dataclass(frozen=True)
class Derivative:
    """A derivative of a value of the page, and the coordinates by which it was taken: where a print
    counts one of these the other way, the derivative has the other sign. That of a friction law has
    its value at steady sliding, too.
    """

    value: sp.Expr
    along: tuple[str, ...] = ()
    still: sp.Expr | None = None


def name_of(of: str, by: str) -> str:
    """The name of a derivative, by its argument where ``by`` is empty."""
    if by == AT_REST:
        return f"{of}_at_rest"
    return f"diff({of}, {by})" if by else f"diff({of})"


def letter_of(of: str, by: str) -> str:
    r"""LaTeX of a derivative: \frac{\partial V}{\partial x}."""
    if by in ("", AT_REST):
        return f"{of}'" if not by else rf"{of}|_{{0}}"
    if by == str(TIME):
        return rf"\frac{{\mathrm{{d}}}}{{\mathrm{{d}}t}}{of}"
    return rf"\frac{{\partial {of}}}{{\partial {by}}}"


def of_value(value: sp.Expr, by: str, it: Derivation) -> Derivative:
    """The derivative of a value in coordinates, rates and parameters; by t along the motion.

    Raises
    ------
    Unread
        Of what holds a normal force or a friction coefficient, which are no functions of these.
    """
    value = it.expanded(value)
    if held := sorted(map(str, value.free_symbols & {*it.normals, *it.coefficients})):
        raise Unread(f"a derivative of what holds {', '.join(held)} is not read")
    moving = (it.model.coordinates, it.model.rates, it.accelerations)
    symbol = it.names.get(by)
    if symbol == TIME:
        if value.has(*it.accelerations):
            raise Unread("the rate of an acceleration is not read")
        pairs = [*zip(moving[0], moving[1], strict=True), *zip(moving[1], moving[2], strict=True)]
        return Derivative(sum((sp.diff(value, one) * rate for one, rate in pairs), sp.S.Zero))
    along = tuple(str(row[0]) for row in zip(*moving, strict=True) if symbol in row)
    if not along and by not in it.parameters:
        raise Unread(f"a derivative by {by}, which is no coordinate, rate or parameter of the page")
    return Derivative(sp.diff(value, symbol), along)


def of_law(friction: FrictionForce, order: int, it: Derivation) -> Derivative:
    """The slope of a friction law, and its further derivatives, by the sliding speed."""
    ahead, behind = sp.diff(friction.ahead, SLIP, order), sp.diff(friction.behind, SLIP, order)
    still = ahead.subs(SLIP, friction.still)
    speed = laws.slip(friction)
    sign = sp.sign(speed)
    before, after = ahead.subs(SLIP, speed), (-1) ** order * behind.subs(SLIP, -speed)
    moving = ((1 + sign) * before + (1 - sign) * after) / 2
    return Derivative(it.spelled(moving), (), it.spelled(still))


def tree_of(value: sp.Expr, it: Derivation) -> Node:
    """A derivative of what a paper prints in a definition, as if it were printed."""
    return read_sympy(str(value), Vocabulary(frozenset(it.names), (), {}))[0].left
