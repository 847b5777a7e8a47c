"""A root that floats know, in a box of balls of many digits: Krawczyk's operator around the end of Newton's method."""

from collections.abc import Sequence
from contextlib import suppress
from fractions import Fraction
from typing import Any, Protocol

import numpy as np

from . import balls, contractors
from .arithmetic import Matrix
from .balls import Ball, Undecided, ball
from .interval_arrays import FloatArray, Intervals
from .jets import constant, gradient, variables

#: Steps of Newton's method.
STEPS = 40
#: Step of it after which there is no further one.
ENOUGH = Fraction(1, 2**160)


class Digits(Protocol):
    """n equations in n unknowns, of balls."""

    #: Of the balls.
    bits: int
    #: How many derivatives the equations themselves are made of.
    order: int = 0

    def equations(self, unknowns: Sequence[Any]) -> Sequence[Any]:
        """F, of balls or of jets of balls."""

    def values(self, unknowns: Sequence[Any]) -> Sequence[Any]:
        """F of balls, or of jets of balls where no derivatives are needed."""
        return list(map(constant, self.equations(variables(unknowns, self.order)))) if self.order else self.equations(unknowns)

    def slopes(self, unknowns: Sequence[Any]) -> Matrix:
        """∂F/∂x over a box."""
        return [gradient(row, len(unknowns)) for row in self.equations(variables(unknowns, self.order + 1))]


def narrowed(system: Digits, box: FloatArray, alone: FloatArray, enough: Fraction = ENOUGH) -> list[Ball] | None:
    """A box of balls around the root in a box of floats, None where it can't be made smaller; both boxes of shape (2, n).

    Newton's method leads to a point z. Where |1 − Y J| is at most 1/2 in a box of half-width r around z, and r not less than
    2 |Y F(z)|, the operator x − Y F(x) maps that box into itself: so it holds a root. It is that of the box of floats where the
    small box lies in ``alone``, or where |1 − Y J| is at most 1/2 all over a box that holds both.
    """
    z = [ball(float(value), system.bits) for value in Intervals(box).middle]
    with suppress(Undecided, ZeroDivisionError):
        for _ in range(STEPS):
            Y = _inverse(as_balls(system.slopes(z), system.bits), system.bits)
            values = as_balls([system.values(z)], system.bits)[0]
            step = [_dot(row, values) for row in Y]
            size = _norm(step)
            if size <= enough:
                return _proved(system, z, 2 * size, Y, box, alone)
            z = [balls.middle(part - change) for part, change in zip(z, step, strict=True)]
    return None


def _proved(
    system: Digits, z: Sequence[Ball], r: Fraction, Y: Sequence[Sequence[Ball]], box: FloatArray, alone: FloatArray
) -> list[Ball] | None:
    """The box of half-width r around z if it is shown to hold the root."""
    with balls.precision(system.bits):
        around = [part + balls.between(-r, r) for part in z]
        within = all(
            Fraction(-float(low)) <= balls.ends(part)[0] and balls.ends(part)[1] <= Fraction(float(high))
            for part, (low, high) in zip(around, alone.T, strict=True)
        )
        floats = (balls.between(Fraction(-float(low)), Fraction(float(high))) for low, high in box.T)
        over = around if within else [balls.union(part, given) for part, given in zip(around, floats, strict=True)]
    columns = list(zip(*as_balls(system.slopes(over), system.bits), strict=True))
    off = [[_dot(row, column) - int(i == j) for j, column in enumerate(columns)] for i, row in enumerate(Y)]
    return around if max(map(_norm, off)) <= Fraction(1, 2) else None


def as_balls(rows: Matrix, bits: int) -> list[list[Ball]]:
    """Entries that are numbers as balls, too."""
    return [[entry if isinstance(entry, Ball) else ball(float(entry), bits) for entry in row] for row in rows]


def _inverse(rows: Sequence[Sequence[Ball]], bits: int) -> list[list[Ball]]:
    """The inverse of the matrix of middles, roughly, of balls without width."""
    try:
        middles = np.array([[float(sum(balls.ends(entry)) / 2) for entry in row] for row in rows])
    except OverflowError:  # of no number that is a float
        middles = np.full((len(rows), len(rows)), np.nan)
    with np.errstate(all="ignore"):
        return [[ball(float(entry), bits) for entry in row] for row in contractors.inverse(middles[:, :, None])[:, :, 0]]


def _dot(row: Sequence[Ball], column: Sequence[Ball]) -> Ball:
    return sum((a * b for a, b in zip(row, column, strict=True)), Ball(0, 0, 0, row[0].bits))


def _norm(values: Sequence[Ball]) -> Fraction:
    """Bound on the sum of |x|."""
    return sum((max(map(abs, balls.ends(value))) for value in values), Fraction(0))


def as_intervals(values: Sequence[Ball]) -> Intervals:
    """Balls as intervals of floats, shape (numbers, 1)."""
    return outward([balls.ends(value) for value in values])


def outward(sides: Sequence[tuple[Fraction, Fraction]]) -> Intervals:
    """Lower and upper ends as intervals of floats, shape (numbers, 1)."""
    ends = np.array([[-float(low) for low, _ in sides], [float(high) for _, high in sides]])
    return Intervals(np.nextafter(ends, np.inf)[:, :, None])  # a float is the nearest to its end, or the next one
