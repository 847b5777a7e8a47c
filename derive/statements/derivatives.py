"""Derivatives that a print names: ∂V/∂x and d/dt (∂L/∂x′) of energies, f′(x) of what a paper
defines, μ′ of a friction law; as names ``diff(V, x)``, ``diff(diff(L, vx), t)``, ``diff(mu)``.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from contextlib import suppress
from dataclasses import dataclass

import sympy as sp
from sympy import Expr, diff

from .. import laws
from ..mechanics import SLIP, FrictionForce
from .names import function_behind
from .objects import TIME, Derivation
from .tree import Node, Unread, symbols, to_sympy


@dataclass(frozen=True)
class Slope:
    """The derivative of a name by another; of a friction law by the sliding speed, where the second
    is empty, or none but its value at rest, where the second says so.
    """

    of: str
    by: str

    @property
    def name(self) -> str:
        """Its name in what is read, which can be read again."""
        if self.by == "at rest":
            return f"at_rest({self.of})"
        return f"diff({self.of}, {self.by})" if self.by else f"diff({self.of})"

    @property
    def order(self) -> int:
        """Of how many derivatives it is one, that itself counted."""
        return self.of.count("diff(") + (self.by != "at rest")

    def law(self, coefficients: Collection[str]) -> str | None:
        """The friction coefficient that it is a derivative of by the sliding speed, or a value of;
        None of another name.
        """
        return function_behind(self.of, coefficients) if self.by in ("", "at rest") else None

    def latex(self, of: str, by: str) -> str:
        r"""LaTeX by that of both names: \frac{\partial V}{\partial x}."""
        if self.by == "at rest":
            return rf"{of}|_{{0}}"
        if not by:
            return f"{of}'"
        if self.by == str(TIME):
            return rf"\frac{{\mathrm{{d}}}}{{\mathrm{{d}}t}}{of}"
        return rf"\frac{{\partial {of}}}{{\partial {by}}}"


def expressions(
    known: Mapping[str, Expr],
    defined: Mapping[str, Node],
    slopes: Mapping[str, Slope],
    it: Derivation,
    *,
    steady: bool = False,
    signs: Mapping[str, int] | None = None,
) -> dict[str, Expr]:
    """Known names, and those of definitions and derivatives that stand on these and each other,
    but for derivatives that there are not: by a name that the page has in its other form alone.

    ``signs`` are those of coordinates and rates that a print counts the other way.
    """
    found = dict(known)
    laws_of = dict(zip(map(str, it.coefficients), it.model.frictions, strict=False))
    trees, pending = dict(defined), dict(slopes)
    while True:
        ready = [name for name, tree in trees.items() if symbols(tree) <= found.keys()]
        for name in ready:
            found[name] = to_sympy(trees.pop(name), found)
        steps = [one for one in pending.values() if one.of in found or one.law(laws_of)]
        for one in steps:
            if base := one.law(laws_of):
                at_rest = steady or one.by == "at rest"
                found[one.name] = _of_law(laws_of[base], one.order, it, at_rest)
            else:
                sign = (signs or {}).get(one.by, 1)
                with suppress(Unread):
                    found[one.name] = sign * of_value(found[one.of], one.by, it)
            del pending[one.name]
        if not ready and not steps:
            return found


def of_value(value: Expr, by: str, it: Derivation) -> Expr:
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
        return sp.Add(*(diff(value, one) * rate for one, rate in pairs))
    if by not in it.parameters and not any(symbol in row for row in moving):
        raise Unread(f"a derivative by {by}, which is no coordinate, rate or parameter of the page")
    return diff(value, symbol)


def _of_law(friction: FrictionForce, order: int, it: Derivation, at_rest: bool) -> Expr:
    """The friction law or a derivative of it by the sliding speed."""
    ahead, behind = diff(friction.ahead, SLIP, order), diff(friction.behind, SLIP, order)
    if at_rest:
        return it.spelled(ahead.subs(SLIP, friction.still))
    speed = laws.slip(friction)
    sign = sp.sign(speed)
    before, after = ahead.subs(SLIP, speed), (-1) ** order * behind.subs(SLIP, -speed)
    return it.spelled(((1 + sign) * before + (1 - sign) * after) / 2)
