"""Printed derivatives: ∂V/∂x and d/dt (∂L/∂x′) of energies, f′(x) of definitions, μ′ of friction.

In syntax trees they are symbols with the names ``diff(V, x)``, ``diff(diff(L, vx), t)``,
``diff(mu)``; here these get their expressions.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import partial

import sympy as sp
from sympy import Dummy, Expr, Symbol, diff

from .. import laws
from ..mechanics import SLIP, FrictionForce
from .identities import is_zero
from .names import function_behind
from .objects import TIME, Derivation
from .tree import Node, Unread, symbols, to_sympy


@dataclass(frozen=True)
class Slope:
    """The derivative of the name ``of`` by the name ``by``.

    An empty ``by`` is the sliding speed of a friction law; "at rest" is no derivative but the value
    of the law at the sliding speed of a body at rest.
    """

    of: str
    by: str

    @property
    def name(self) -> str:
        """The name of the derivative in trees and in SymPy's syntax."""
        if self.by == "at rest":
            return f"at_rest({self.of})"
        return f"diff({self.of}, {self.by})" if self.by else f"diff({self.of})"

    @property
    def order(self) -> int:
        """The number of differentiations."""
        return self.of.count("diff(") + (self.by != "at rest")

    def law(self, coefficients: Collection[str]) -> str | None:
        """The friction coefficient whose derivative by the sliding speed, or value at rest, this
        is; else None.
        """
        return function_behind(self.of, coefficients) if self.by in ("", "at rest") else None

    def latex(self, of: str, by_letter: str) -> str:
        r"""LaTeX of the derivative, \frac{\partial V}{\partial x}, from that of both names."""
        if self.by == "at rest":
            return rf"{of}|_{{0}}"
        if not by_letter:
            return f"{of}'"
        if self.by == str(TIME):
            return rf"\frac{{\mathrm{{d}}}}{{\mathrm{{d}}t}}{of}"
        return rf"\frac{{\partial {of}}}{{\partial {by_letter}}}"


def expressions(
    known: Mapping[str, Expr],
    defined: Mapping[str, Node],
    slopes: Mapping[str, Slope],
    derivation: Derivation,
    *,
    steady: bool = False,
    signs: Mapping[str, int] | None = None,
) -> dict[str, Expr]:
    """Expressions of known names, and of all definitions and derivatives that follow from them.

    A derivative that does not exist in this form of the page is left out. ``signs`` has -1 for each
    coordinate and rate whose direction is reversed in the print.
    """
    found = dict(known)
    laws_of = dict(zip(map(str, derivation.coefficients), derivation.model.frictions, strict=False))
    trees, pending = dict(defined), dict(slopes)
    while True:
        ready = [name for name, tree in trees.items() if symbols(tree) <= found.keys()]
        for name in ready:
            found[name] = to_sympy(trees.pop(name), found)
        ready_slopes = [one for one in pending.values() if one.of in found or one.law(laws_of)]
        for slope in ready_slopes:
            if coefficient := slope.law(laws_of):
                at_rest = steady or slope.by == "at rest"
                found[slope.name] = _of_law(laws_of[coefficient], slope.order, derivation, at_rest)
            else:
                sign = (signs or {}).get(slope.by, 1)
                with suppress(Unread):
                    value = None
                    if slope.of in defined:
                        value = derivation.kept(
                            "by momenta",
                            f"{slope.name}, {found[slope.of]}",
                            partial(by_momenta, slope, defined, dict(found), derivation),
                        )
                    if value is None:
                        value = of_value(found[slope.of], slope.by, derivation)
                    found[slope.name] = sign * value
            del pending[slope.name]
        if not ready and not ready_slopes:
            return found


def by_momenta(
    slope: Slope, defined: Mapping[str, Node], known: Mapping[str, Expr], derivation: Derivation
) -> Expr | None:
    """The partial derivative of a function of coordinates and momenta, as Hamilton's is, by one of
    these while the others stay; None where the name is defined as no such function.
    """
    momenta: dict[str, Symbol] = {}

    def written(name: str) -> Expr:
        """The value of a name, in symbols of the momenta."""
        if name not in defined:
            return known[name]
        if name not in momenta and _is_momentum(known[name], derivation):
            momenta[name] = Dummy(name, real=True)
        if name in momenta:
            return momenta[name]
        return to_sympy(defined[name], {it: written(it) for it in symbols(defined[name])})

    if _is_momentum(known[slope.of], derivation):
        return None
    value = derivation.expanded(written(slope.of))
    by = momenta.get(slope.by, derivation.names.get(slope.by))
    if not momenta or value.has(*derivation.model.rates) or by is None:
        return None
    return diff(value, by).xreplace({it: known[name] for name, it in momenta.items()})


def _is_momentum(value: Expr, derivation: Derivation) -> bool:
    """Whether an expression is the momentum ∂T/∂q′ of a coordinate, in either direction."""
    if not value.has(*derivation.model.rates) or value.has(*derivation.accelerations):
        return False
    near, value = 1e-12, derivation.expanded(value)
    for gap in (value - sign * it for it in derivation.momenta for sign in (1, -1)):
        names = sorted(gap.free_symbols, key=str)
        at = {it: sp.Rational(3 + place, 7 + 2 * place) for place, it in enumerate(names)}
        if abs(complex(sp.N(gap.subs(at)))) < near and is_zero(gap):
            return True
    return False


def of_value(value: Expr, by: str, derivation: Derivation) -> Expr:
    """The derivative of an expression by a coordinate, rate or parameter; by t along the motion.

    Raises
    ------
    Unread
        If the expression holds a normal force or a friction coefficient, which have symbols of
        their own, or ``by`` is no variable of the page.
    """
    value = derivation.expanded(value)
    if forces := sorted(map(str, value.free_symbols & {*derivation.laws})):
        raise Unread(f"a derivative of what holds {', '.join(forces)} is not read")
    symbol = derivation.names.get(by)
    if symbol == TIME:
        if value.has(*derivation.accelerations):
            raise Unread("the rate of an acceleration is not read")
        changes = (*derivation.model.rates, *derivation.accelerations)
        slopes = dict(zip(derivation.states, changes, strict=True))
        if (clock := derivation.model.clock) is not None:  # which has no state of its own
            slopes[clock] = derivation.spelled(derivation.model.speed)
        return sp.Add(*(diff(value, state) * slope for state, slope in slopes.items()))
    moving = (*derivation.states, *derivation.accelerations)
    if by not in derivation.parameters and symbol not in moving:
        raise Unread(f"a derivative by {by}, which is no coordinate, rate or parameter of the page")
    return diff(value, symbol)


def _of_law(friction: FrictionForce, order: int, derivation: Derivation, at_rest: bool) -> Expr:
    """The friction law, or its derivative of an order by the sliding speed, for either sign of
    that speed.
    """
    ahead, behind = diff(friction.ahead, SLIP, order), diff(friction.behind, SLIP, order)
    if at_rest:
        return derivation.spelled(ahead.subs(SLIP, friction.still))
    speed = laws.slip(friction)
    sign = sp.sign(speed)
    before, after = ahead.subs(SLIP, speed), (-1) ** order * behind.subs(SLIP, -speed)
    return derivation.spelled(((1 + sign) * before + (1 - sign) * after) / 2)
