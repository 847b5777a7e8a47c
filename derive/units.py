"""Dimensions of a page's quantities: reading units, checking sums, and making quantities
dimensionless.

A dimension is a triple of exponents of kilogram, metre and second, all 0 for angles and numbers.
With three quantities as units of measure (those that become 1) every other quantity becomes a
number: it is divided by the one product of powers of these three that has its dimension.
"""

import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import cache
from typing import TypeAlias

import sympy as sp
from sympy import Expr, Matrix, Symbol

#: Exponents of kilogram, metre and second.
Dimension: TypeAlias = tuple[Fraction, Fraction, Fraction]


def _of(kilograms: int, metres: int, seconds: int) -> Dimension:
    return Fraction(kilograms), Fraction(metres), Fraction(seconds)


#: Of a number, and of an angle.
NONE = _of(0, 0, 0)


class UnitsError(ArithmeticError):
    """An expression whose units do not fit together, or a text that is no unit."""


def times(one: Dimension, other: Dimension, power: Fraction | int = 1) -> Dimension:
    """Dimension of ``one · other^power``."""
    kilograms, metres, seconds = (a + power * b for a, b in zip(one, other, strict=True))
    return kilograms, metres, seconds


@cache
def read(text: str) -> Dimension:
    """The dimension of a written unit: ``N/m``, ``N s/m``, ``kg m/s^2``, ``N/m^(3/2)``."""
    dimension, power = NONE, 1
    named: dict[str, Dimension] = {
        "1": NONE,
        "rad": NONE,
        "kg": _of(1, 0, 0),
        "m": _of(0, 1, 0),
        "s": _of(0, 0, 1),
        "N": _of(1, 1, -2),
        "J": _of(1, 2, -2),
        "Hz": _of(0, 0, -1),
    }
    for part in re.findall(
        r"/|[^\s/]+(?:\^\([^)]*\))?", re.sub(r"\^\((\S+)/(\S+)\)", r"^\1|\2", text)
    ):
        if part == "/":
            power = -1
            continue
        name, _, exponent = part.partition("^")
        if name not in named or not re.fullmatch(r"-?\d+(\|\d+)?|", exponent):
            raise UnitsError(
                f"{text!r} is not a unit; write it with {', '.join(named)}, as N s/m or N/m^(3/2)"
            )
        dimension = times(dimension, named[name], power * Fraction(exponent.replace("|", "/") or 1))
    return dimension


def spelled(dimension: Dimension) -> str:
    """A dimension in base units: ``kg m s^-2``."""
    parts = [
        name + ("" if power == 1 else f"^{power}" if power.denominator == 1 else f"^({power})")
        for name, power in zip(("kg", "m", "s"), dimension, strict=True)
        if power
    ]
    return " ".join(parts) or "a number without a unit"


def of(expression: Expr, dimensions: Mapping[Symbol, Dimension]) -> Dimension | None:
    """The dimension of an expression; None for zero, which fits any dimension.

    Raises
    ------
    UnitsError
        If a sum adds different dimensions, or a function is taken of a quantity with a unit.
    """
    match expression:
        case Symbol():
            return dimensions[expression]
        case sp.Add() | sp.Max() | sp.Min():
            return _of_sum(expression, expression.args, dimensions)
        case sp.Mul():
            dimension = NONE
            for factor in expression.args:
                part = of(factor, dimensions)
                if part is None:
                    return None
                dimension = times(dimension, part)
            return dimension
        case sp.Pow() if (power := expression.exp.doit()).is_Rational:  # 5/2, not evaluated
            base = of(expression.base, dimensions)
            return base and times(NONE, base, Fraction(power.p, power.q))
        case sp.Abs():
            return of(expression.args[0], dimensions)
        case sp.Piecewise():
            values = [value for value, _ in expression.args]
            return _of_sum(expression, values, dimensions)
        case sp.sign():
            of(expression.args[0], dimensions)
            return NONE
        case _ if expression.is_number:
            return None if expression == 0 else NONE
    for argument in expression.args:
        if of(argument, dimensions) not in (None, NONE):
            raise UnitsError(
                f"{expression} is taken of {argument}, which is in "
                f"{spelled(of(argument, dimensions) or NONE)}, not a number"
            )
    return NONE


def _of_sum(
    expression: Expr, terms: Iterable[Expr], dimensions: Mapping[Symbol, Dimension]
) -> Dimension | None:
    found: dict[Dimension, Expr] = {}
    for term in terms:
        dimension = of(term, dimensions)
        if dimension is not None:
            found.setdefault(dimension, term)
    if len(found) > 1:
        listed = " and ".join(
            f"{term} is in {spelled(dimension)}" for dimension, term in found.items()
        )
        raise UnitsError(f"{expression} adds what can't be added: {listed}")
    return next(iter(found), None)


@cache
def powers(dimension: Dimension, units: tuple[Dimension, ...]) -> tuple[Fraction, ...] | None:
    """Exponents p with ``dimension = Π unitsᵢ^pᵢ``; None if there are none."""
    if not units:
        return () if dimension == NONE else None
    try:
        found, free = Matrix(units).T.gauss_jordan_solve(Matrix(dimension))
    except ValueError:
        return None
    return None if free else tuple(Fraction(int(it.p), int(it.q)) for it in found)
