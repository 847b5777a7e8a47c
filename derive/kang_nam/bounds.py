"""Counts of roundings, from the statements that are emitted: what the kernel's error bounds rest
on.

Every rounded operation multiplies each term of a result by 1 + δ with |δ| ≤ u. An expression whose
every term meets at most n roundings is therefore off by at most n u times its size, the sum of its
terms' absolute values, to first order; one more covers the higher orders and the rounding of the
size itself, as long as n u is tiny. The counts below are those n + 1. Generated algebra is followed
statement by statement, the kernel's own functions are run on numbers that carry their count along.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp
from sympy import Expr, Rational, Symbol

from . import nomenclature as nm
from .catalogue import Function
from ..emit.language import Source
from ..emit.definitions import flat
from ..emit.statements import straight_line


@dataclass(frozen=True)
class Counted:
    """A number with the roundings that its terms have met, and its size.

    ``cancels``: its terms may have different signs, so that the count says nothing about its own
    relative error.
    """

    size: Any
    count: int | Rational = 0
    cancels: bool = False

    def __add__(self, other: Counted | float) -> Counted:
        other = counted(other)
        return Counted(
            self.size + other.size, max(self.count, other.count) + 1, self.cancels or other.cancels
        )

    __radd__ = __add__

    def __neg__(self) -> Counted:
        return self

    def __sub__(self, other: Counted | float) -> Counted:
        return replace(self + other, cancels=True)

    __rsub__ = __sub__

    def __mul__(self, other: Counted | float) -> Counted:
        other = counted(other)
        rounded = 0 if _is_power_of_two(self) or _is_power_of_two(other) else 1
        return Counted(
            self.size * other.size,
            self.count + other.count + rounded,
            self.cancels or other.cancels,
        )

    __rmul__ = __mul__

    def __truediv__(self, other: Counted | float) -> Counted:
        other = counted(other)
        if other.cancels:
            raise ArithmeticError(f"a quotient by {other.size}, which may cancel, has no bound")
        rounded = 0 if _is_power_of_two(other) else 1
        return Counted(self.size / other.size, self.count + other.count + rounded, self.cancels)

    def __rtruediv__(self, other: float) -> Counted:
        return counted(other) / self


def counted(value: Counted | float) -> Counted:
    """A plain number is exact."""
    return value if isinstance(value, Counted) else Counted(abs(sp.nsimplify(value)))


def _is_power_of_two(value: Counted) -> bool:
    return value.count == 0 and value.size.is_Number and math.frexp(float(value.size))[0] == 0.5


# ----------------------------------------------------------------------------------------------
# generated algebra


def follow(function: Function, arguments: tuple[Counted, ...]) -> tuple[Counted, ...]:
    """The results of a generated function, by its statements."""
    body = straight_line(function)
    values = dict(zip(function.arguments, arguments, strict=True))
    for symbol, expression in body.assignments:
        values[symbol] = _follow(expression, values)
    return tuple(_follow(expression, values) for expression in flat(body.results))


def _follow(expression: Expr, values: Mapping[Symbol, Counted]) -> Counted:
    if expression.is_Symbol:
        return values[expression]
    if expression.is_Rational:
        # p/q in a product is printed as a product and a quotient, of which only the quotient may
        # round, and not by a power of 2.
        return Counted(
            abs(expression), 0 if _is_power_of_two(Counted(sp.Integer(expression.q))) else 1
        )
    parts = [
        _follow(part, values)
        for part in expression.args
        if not (expression.is_Pow and part.is_Number)
    ]
    if expression.is_Add:
        # Printed in some order: each term meets at most all of the additions.
        signs = {part.could_extract_minus_sign() for part in expression.args}
        cancels = len(signs) > 1 or any(part.cancels for part in parts)
        return Counted(
            sp.Add(*(part.size for part in parts)),
            max(part.count for part in parts) + len(parts) - 1,
            cancels,
        )
    if expression.is_Mul:
        return math.prod(parts[1:], start=parts[0])
    if expression.is_Pow and expression.exp == 2:
        return parts[0] * parts[0]
    if expression.is_Pow and expression.exp == -1:
        return 1 / parts[0]
    if isinstance(expression, sp.Abs):
        return parts[0]
    raise ArithmeticError(f"no bound is known for the rounding of {expression}")


# ------------------------------------------------------------------------------------------------
# counts


def counts(source: Source, functions: Mapping[str, Function]) -> dict[str, float]:
    """Every count that the kernel names, with ``functions`` the generated functions by name."""
    kernel: dict[str, Any] = {"__name__": f"{__package__}.kernel", "__package__": __package__}
    # our own file, as every import is
    exec(compile(source.text, "the kernel", "exec"), kernel)  # noqa: S102
    exact = {symbol: Counted(Symbol(f"{symbol}_size")) for symbol in (*nm.PARAMETERS, nm.nbar)}
    # Units that cos θ₀ and sin θ₀ are off by: one in the last place.
    angle0 = tuple(Counted(Symbol(f"{name}0_size"), 2) for name in ("cos", "sin"))
    # t is exact, so that 1 − t and 1 + t are rounded once, relative to themselves: the counts of
    # cos θ and sin θ are relative.
    at = kernel["direction"](Counted(Symbol("t")))
    c, s = Counted(Symbol("c"), at.cosine.count), Counted(Symbol("s"), at.sine.count)

    # The common factor of a balance changes no root: only the product with it rounds.
    coefficients = follow(functions["f_coefficients"], (*angle0, *exact.values()))
    line = tuple(Counted(value.size, value.count + 1, value.cancels) for value in coefficients)
    _same_sizes(coefficients, follow(functions["f_magnitudes"], (*angle0, *exact.values())))

    cubic = follow(functions["resolvent"], line)
    it = kernel["depressed"](*cubic)
    sizes = kernel["depressed_size"](*(value.size for value in line))
    _covers(sizes.P, it.P.size)
    _covers(sizes.Q, it.Q.size)

    here = (c, s, *line)
    (value,), (slope,) = follow(functions["f"], here), follow(functions["f_slope"], here)
    e1 = follow(functions["t_quartic"], line)[1]
    L, x, y = follow(
        functions["state"],
        (c, s, *angle0, exact[nm.kappa], exact[nm.sigma], exact[nm.beta], exact[nm.nbar]),
    )

    # In units of the uncertainty ω: one for each of cos θ, sin θ and L, and an eighth for a
    # rounding.
    # Where ``uncertainty`` ω of the stability stands for u: it is at least 8 u.
    omega = Rational(8)
    vague = [Counted(Symbol(name), omega) for name in ("c", "s", "L")]
    stiffness = follow(
        functions["stiffness"],
        (*vague, *(exact[symbol] for symbol in (nm.mu0, nm.alpha, nm.sigma, nm.beta, nm.nbar))),
    )
    trace, _, flutter = follow(functions["invariants"], stiffness)
    found = {
        "COUNT_P": it.P.count,
        "COUNT_Q": it.Q.count,
        "COUNT_E1": e1.count,
        "COUNT_F": value.count,
        "COUNT_SLOPE": slope.count,
        "COUNT_STATE": max(
            L.count, y.count, Rational(x.count, 2)
        ),  # x once with L, and once with itself
        "COUNT_K": max(trace.count, flutter.count) / omega,
    }
    rounded = {name: float(math.ceil(number) + 1) for name, number in found.items()}
    # Roundings that θ = 2 atan t may be off by: an arc tangent within four units in the last
    # place, of an angle below π.
    return {**rounded, "COUNT_THETA": 16.0}


def _covers(size: Expr, wanted: Expr) -> None:
    """The size that the kernel computes is at least that of the statements, term by term."""
    surplus = sp.expand(size - wanted)
    if surplus != 0 and any(coefficient < 0 for coefficient in sp.Poly(surplus).coeffs()):
        raise ArithmeticError(f"the size {size} does not cover {wanted}")


def _same_sizes(coefficients: tuple[Counted, ...], emitted: tuple[Counted, ...]) -> None:
    a, b, d, m = coefficients
    if b.cancels or m.cancels:
        raise ArithmeticError(
            "b and m are taken for sums of terms of one sign, which are their own size"
        )
    for wanted, given in zip((a, d), emitted, strict=True):
        if sp.expand(wanted.size - given.size) != 0:
            raise ArithmeticError(
                f"f_magnitudes gives {given.size} where the terms add up to {wanted.size}"
            )
