"""Counts of rounding errors for the kernel's error bounds, derived from the emitted statements.

Every rounded operation multiplies each term of a result by 1 + δ with |δ| ≤ u. If every term of an
expression has at most n roundings, its error is at most n u times its size, the sum of the absolute
values of its terms, to first order. One more covers higher orders and the rounding of the size
itself, as long as n u is tiny: the counts are n + 1. Generated algebra is followed statement by
statement; the kernel's functions are run on numbers that carry their counts.
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
    """A number with its size, and the largest number of roundings of its terms.

    ``cancels`` says that terms may have different signs: then the count does not bound the relative
    error of the number itself.
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
    """A number with its count; a plain number is exact."""
    return value if isinstance(value, Counted) else Counted(abs(sp.nsimplify(value)))


def _is_power_of_two(value: Counted) -> bool:
    return value.count == 0 and value.size.is_Number and math.frexp(float(value.size))[0] == 0.5


# ----------------------------------------------------------------------------------------------
# generated algebra


def follow(function: Function, arguments: tuple[Counted, ...]) -> tuple[Counted, ...]:
    """The counted results of a generated function."""
    body = straight_line(function)
    values = dict(zip(function.arguments, arguments, strict=True))
    for symbol, expression in body.assignments:
        values[symbol] = _follow(expression, values)
    return tuple(_follow(expression, values) for expression in flat(body.results))


def _follow(expression: Expr, values: Mapping[Symbol, Counted]) -> Counted:
    if expression.is_Symbol:
        return values[expression]
    if expression.is_Rational:
        # p/q is printed as a product and a quotient; only the quotient rounds, unless q is a power
        # of 2.
        return Counted(
            abs(expression), 0 if _is_power_of_two(Counted(sp.Integer(expression.q))) else 1
        )
    parts = [
        _follow(part, values)
        for part in expression.args
        if not (expression.is_Pow and part.is_Number)
    ]
    if expression.is_Add:
        # In any order of summation a term has at most all additions.
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
    """The counts that the kernel names; ``functions`` are the generated functions by name."""
    kernel: dict[str, Any] = {"__name__": f"{__package__}.kernel", "__package__": __package__}
    # The text of our own file.
    exec(compile(source.text, "the kernel", "exec"), kernel)  # noqa: S102
    exact = {symbol: Counted(Symbol(f"{symbol}_size")) for symbol in (*nm.PARAMETERS, nm.nbar)}
    # cos θ₀ and sin θ₀ have an error of one unit in the last place, two units of u.
    angle0 = tuple(Counted(Symbol(f"{name}0_size"), 2) for name in ("cos", "sin"))
    # t is exact, so that 1 − t and 1 + t have one relative rounding: the counts of cos θ and sin θ
    # bound relative errors.
    direction = kernel["direction"](Counted(Symbol("t")))
    c, s = Counted(Symbol("c"), direction.cosine.count), Counted(Symbol("s"), direction.sine.count)

    # The common factor of a balance does not change its roots: only the multiplication rounds.
    coefficients = follow(functions["f_coefficients"], (*angle0, *exact.values()))
    line = tuple(Counted(value.size, value.count + 1, value.cancels) for value in coefficients)
    _same_sizes(coefficients, follow(functions["f_magnitudes"], (*angle0, *exact.values())))

    cubic = follow(functions["resolvent"], line)
    PQ = kernel["depressed"](*cubic)
    sizes = kernel["depressed_size"](*(value.size for value in line))
    _covers(sizes.P, PQ.P.size)
    _covers(sizes.Q, PQ.Q.size)

    arguments = (c, s, *line)
    (value,), (slope,) = follow(functions["f"], arguments), follow(functions["f_slope"], arguments)
    e1 = follow(functions["t_quartic"], line)[1]
    L, x, y = follow(
        functions["state"],
        (c, s, *angle0, exact[nm.kappa], exact[nm.sigma], exact[nm.beta], exact[nm.nbar]),
    )

    # The stability has an uncertainty ω ≥ 8 u of cos θ, sin θ and L in place of u: a rounding is an
    # eighth of it.
    omega = Rational(8)
    uncertain = [Counted(Symbol(name), omega) for name in ("c", "s", "L")]
    stiffness = follow(
        functions["stiffness"],
        (*uncertain, *(exact[symbol] for symbol in (nm.mu0, nm.alpha, nm.sigma, nm.beta, nm.nbar))),
    )
    trace, _, flutter = follow(functions["invariants"], stiffness)
    found = {
        "COUNT_P": PQ.P.count,
        "COUNT_Q": PQ.Q.count,
        "COUNT_E1": e1.count,
        "COUNT_F": value.count,
        "COUNT_SLOPE": slope.count,
        "COUNT_STATE": max(
            L.count, y.count, Rational(x.count, 2)
        ),  # x once with L, and once with itself
        "COUNT_K": max(trace.count, flutter.count) / omega,
    }
    rounded = {name: float(math.ceil(number) + 1) for name, number in found.items()}
    # θ = 2 atan t is below π; the arc tangent is within four units in the last place.
    return {**rounded, "COUNT_THETA": 16.0}


def _covers(size: Expr, wanted: Expr) -> None:
    """Raise unless a size that the kernel computes is at least another one, term by term."""
    surplus = sp.expand(size - wanted)
    if surplus != 0 and any(coefficient < 0 for coefficient in sp.Poly(surplus).coeffs()):
        raise ArithmeticError(f"the size {size} does not cover {wanted}")


def _same_sizes(coefficients: tuple[Counted, ...], emitted: tuple[Counted, ...]) -> None:
    """Raise unless ``f_magnitudes`` gives the sizes of a and d, and b and m are their own sizes."""
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
