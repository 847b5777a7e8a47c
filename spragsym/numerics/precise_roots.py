"""Roots with many digits: of a root that floats know a small box of balls, and all roots where the
Jacobian is nearly singular.

A known root is enclosed by Krawczyk's operator around the end of Newton's method.

Near a fold or a cusp the Jacobian has rank n − 1. So n − 1 of the equations determine all unknowns
but one, u, uniquely in a small box, and the last equation becomes g(u). Its Taylor polynomial of
degree 3 with an enclosure of the last coefficient holds all roots: a cubic with one coefficient
that is an interval. These are isolated by halving, in balls of many digits.

What is proved of the box: the other unknowns stay in it, as functions of u, by interval Newton on
the n − 1 equations; a piece of u holds no root if the polynomial is not 0 on it, and exactly one if
its slope is not 0 on it and its signs at both ends differ.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Protocol, TypeAlias

import numpy as np

from ..core.options import Options, limit
from . import balls, contractors
from .arithmetic import Matrix, Number, is_zero, linear_solution
from .balls import Ball, UndecidedSign, ball
from .interval_arrays import FloatArray, Intervals, quiet
from .jets import Jet, constant, gradient, variables
from .polynomials import derivative, evaluate, shifted

#: F of balls or of jets of balls.
Evaluate: TypeAlias = Callable[[Sequence[Any]], Sequence[Any]]
#: Lower and upper end of each unknown.
Box: TypeAlias = list[tuple[Fraction, Fraction]]


@dataclass(frozen=True)
class DigitOptions(Options):
    """Options of a search with many digits, where roots lie close together.

    Parameters
    ----------
    depth : int
        Times a box is halved.
    parts : int
        Parts of a box that are looked at: both halves at each depth around two roots. A box whose
        halves never get simpler, as along a line of roots or around a pole, costs no more.
    """

    depth: int = limit(26)
    parts: int = limit(120)


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
        if self.order:
            return list(map(constant, self.equations(variables(unknowns, self.order))))
        return self.equations(unknowns)

    def slopes(self, unknowns: Sequence[Any]) -> Matrix:
        """∂F/∂x over a box."""
        return [
            gradient(row, len(unknowns))
            for row in self.equations(variables(unknowns, self.order + 1))
        ]


def narrowed(
    system: Digits, box: FloatArray, alone: FloatArray, enough: Fraction = Fraction(1, 2**160)
) -> list[Ball] | None:
    """A box of balls around the root in a box of floats, None where it can't be made smaller; both
    boxes of shape (2, n).

    Newton's method leads to a point z. Where |1 − Y J| is at most 1/2 in a box of half-width r
    around z, and r not less than 2 |Y F(z)|, the operator x − Y F(x) maps that box into itself: so
    it holds a root. It is that of the box of floats where the small box lies in ``alone``, or where
    |1 − Y J| is at most 1/2 all over a box that holds both.
    """
    z = [ball(float(value), system.bits) for value in Intervals(box).middle]
    with suppress(UndecidedSign, ZeroDivisionError):
        for _ in range(40):  # steps, each of which doubles the number of digits near the root
            Y = _inverse(as_balls(system.slopes(z), system.bits), system.bits)
            values = as_balls([system.values(z)], system.bits)[0]
            step = [_dot(row, values) for row in Y]
            size = _norm(step)
            if size <= enough:
                return _proved(system, z, 2 * size, Y, box, alone)
            z = [balls.middle(part - change) for part, change in zip(z, step, strict=True)]
    return None


def _proved(
    system: Digits,
    z: Sequence[Ball],
    r: Fraction,
    Y: Sequence[Sequence[Ball]],
    box: FloatArray,
    alone: FloatArray,
) -> list[Ball] | None:
    """The box of half-width r around z if it is shown to hold the root."""
    with balls.precision(system.bits):
        enclosed = [part + balls.between(-r, r) for part in z]
        sides = zip(map(balls.ends, enclosed), exact_ends(alone), strict=True)
        within = all(low <= least and most <= high for (least, most), (low, high) in sides)
        given = zip(enclosed, exact_ends(box), strict=True)
        over = (
            enclosed
            if within
            else [balls.union(part, balls.between(*side)) for part, side in given]
        )
    columns = list(zip(*as_balls(system.slopes(over), system.bits), strict=True))
    off = [
        [_dot(row, column) - int(i == j) for j, column in enumerate(columns)]
        for i, row in enumerate(Y)
    ]
    return enclosed if max(map(_norm, off)) <= Fraction(1, 2) else None


def exact_ends(box: FloatArray) -> Box:
    """Lower and upper end of each unknown in a box of floats, shape (2, n), exactly."""
    return [(Fraction(-float(low)), Fraction(float(high))) for low, high in box.T]


def as_balls(rows: Matrix, bits: int) -> list[list[Ball]]:
    """Entries that are numbers as balls, too."""
    return [
        [entry if isinstance(entry, Ball) else ball(float(entry), bits) for entry in row]
        for row in rows
    ]


def _inverse(rows: Sequence[Sequence[Ball]], bits: int) -> list[list[Ball]]:
    """The inverse of the matrix of middles, roughly, of balls without width."""
    try:
        middles = np.array([[float(sum(balls.ends(entry)) / 2) for entry in row] for row in rows])
    except OverflowError:  # of no number that is a float
        middles = np.full((len(rows), len(rows)), np.nan)
    with quiet():
        return [
            [ball(float(entry), bits) for entry in row]
            for row in contractors.inverse(middles[:, :, None])[:, :, 0]
        ]


def _dot(row: Sequence[Any], column: Sequence[Any]) -> Ball:
    total: Ball = sum(a * b for a, b in zip(row, column, strict=True))
    return total


def _norm(values: Sequence[Ball]) -> Fraction:
    """Bound on the sum of |x|."""
    return sum((max(map(abs, balls.ends(value))) for value in values), Fraction(0))


def as_intervals(values: Sequence[Ball]) -> Intervals:
    """Balls as intervals of floats, shape (numbers, 1)."""
    return outward([balls.ends(value) for value in values])


def outward(sides: Sequence[tuple[Fraction, Fraction]]) -> Intervals:
    """Lower and upper ends as intervals of floats, shape (numbers, 1)."""
    ends = np.array([[-float(low) for low, _ in sides], [float(high) for _, high in sides]])
    # A float is the nearest to its end, or the next one.
    return Intervals(np.nextafter(ends, np.inf)[:, :, None])


@dataclass(frozen=True)
class Reduced:
    """Boxes, as pairs of fractions for each unknown: around each root, those in which it is alone,
    and those still open.
    """

    roots: list[Box]
    alone: list[Box]
    undecided: list[Box]


def reduced_roots(
    evaluate: Evaluate,
    box: Sequence[tuple[Any, Any]],
    jacobian: FloatArray,
    bits: int,
    options: DigitOptions | None = None,
) -> Reduced:
    """All roots in a box; ``jacobian`` is F's somewhere in it, roughly."""
    options = options or DigitOptions()
    task, found = _task(evaluate, jacobian, range(len(box))), Reduced([], [], [])
    with balls.precision(bits):
        whole = [(Fraction(low), Fraction(high)) for low, high in box]
        task.search(whole, found, options)
    return found


def third_derivative(
    evaluate: Evaluate, box: Box, jacobian: FloatArray, bits: int, among: Sequence[int]
) -> Ball:
    """A sixth of the third derivative of g all over a box, with u and the equation that is left
    among the given ones.
    """
    with balls.precision(bits):
        task = _task(evaluate, jacobian, among)
        return task.third(box[task.along], task.others(box[task.along], box))


def _task(evaluate: Evaluate, jacobian: FloatArray, among: Sequence[int]) -> _Task:
    """With u and the equation that is left among the given ones."""
    left, _, right = np.linalg.svd(jacobian)
    unknowns, equations = (
        _first(max(among, key=lambda i: abs(float(part[i]))), part.size)
        for part in (right[-1], left[:, -1])
    )
    return _Task(evaluate, unknowns, equations)


def _first(number: int, n: int) -> tuple[int, ...]:
    """Numbers in their order, but one of them first."""
    return (number, *(i for i in range(n) if i != number))


@dataclass(frozen=True)
class _Task:
    """A system in one box: u is the first of the ``unknowns``, the equation that is left the first
    of the ``equations``.
    """

    evaluate: Evaluate
    unknowns: tuple[int, ...]
    equations: tuple[int, ...]

    def _ordered(self, values: Sequence[Any]) -> list[Any]:
        """Unknowns in their order, of u and the others."""
        return [values[self.unknowns.index(index)] for index in range(len(values))]

    def _values(self, unknowns: Sequence[Any]) -> list[Any]:
        """F, the equation that is left first."""
        values = self.evaluate(self._ordered(unknowns))
        return [values[row] for row in self.equations]

    def _slopes(self, unknowns: Sequence[Any]) -> list[list[Any]]:
        """Slopes of F by u and the others, the equation that is left first."""
        rows = [
            gradient(row, len(unknowns))
            for row in self.evaluate(variables(self._ordered(unknowns), 1))
        ]
        return [[rows[row][index] for index in self.unknowns] for row in self.equations]

    def _coefficients(self, series: Matrix, order: int) -> list[Any]:
        """Coefficients of that order of F along series of u and the others to one order less, the
        equation that is left first.
        """
        jets = [
            Jet({(0,) * k: part[k] for k in range(order) if not is_zero(part[k])}, order)
            for part in series
        ]
        return [
            row.terms.get((0,) * order, 0) if isinstance(row, Jet) else 0
            for row in self._values(jets)
        ]

    def _newton(self, u: Ball, others: Sequence[Ball]) -> list[Any]:
        """Interval Newton's operator m − J⁻¹ S(u, m) for the other unknowns as functions of u,
        which solve n − 1 equations S.
        """
        middle = [balls.middle(value) for value in others]
        slopes = [row[1:] for row in self._slopes([u, *others])[1:]]
        steps = linear_solution(slopes, self._values([u, *middle])[1:], _largest_pivot)
        return [m - step for m, step in zip(middle, steps, strict=True)]

    def _expansion(self, u: Ball, others: Sequence[Ball], highest: int) -> list[Any]:
        """Taylor coefficients of g from the first on; those of F are linear in the last ones of the
        others.
        """
        slopes = self._slopes([u, *others])
        matrix, zero = [row[1:] for row in slopes[1:]], Ball(0, 0, 0, u.bits)
        steps = linear_solution(matrix, [row[0] for row in slopes[1:]], _largest_pivot)
        series = [
            [u, 1],
            *([value, zero - step] for value, step in zip(others, steps, strict=True)),
        ]
        out = [slopes[0][0] - _dot(slopes[0][1:], steps) + zero]
        for order in range(2, highest + 1):
            rest, *rows = self._coefficients(series, order)
            steps = linear_solution(matrix, rows, _largest_pivot)
            out.append(rest - _dot(slopes[0][1:], steps) + zero)
            for part, term in zip(series, [0, *(zero - step for step in steps)], strict=True):
                part.append(term)
        return out

    @property
    def along(self) -> int:
        """Number of u."""
        return self.unknowns[0]

    def third(self, span: tuple[Fraction, Fraction], others: Sequence[Ball]) -> Ball:
        """The third coefficient of the expansion about any point of a span."""
        return self._expansion(balls.between(*span), others, 3)[2]

    def at(self, u: Fraction, others: Sequence[Ball]) -> list[Any]:
        """The other coefficients of the expansion about a point."""
        at = balls.exact(u)
        sharp = self._narrowed(at, others)
        return [self._values([at, *sharp])[0], *self._expansion(at, sharp, 2)]

    def search(self, box: Box, found: Reduced, options: DigitOptions) -> None:
        """All roots of a box: of the whole if it can be settled, else of its halves in u, and of
        theirs.
        """
        waiting = deque([(box, options.depth)])
        for _ in range(options.parts):
            if not waiting:
                return
            part, depth = waiting.popleft()
            if self._settled(part, found):
                continue
            if not depth:
                found.undecided.append(part)
                continue
            low, high = part[self.along]
            cut = low + (high - low) * Fraction(61, 128)
            for side in ((low, cut), (cut, high)):
                waiting.append(
                    (
                        [side if i == self.along else other for i, other in enumerate(part)],
                        depth - 1,
                    )
                )
        found.undecided.extend(part for part, _ in waiting)

    def _settled(self, box: Box, found: Reduced) -> bool:
        """Whether the roots of a box could be isolated; those found are kept."""
        low, high = box[self.along]
        middle = (low + high) / 2
        try:
            others = self.others(box[self.along], box)
            last = self.third(box[self.along], others)
            pieces = _isolated([*self.at(middle, others), last], low - middle, high - middle)
        except UndecidedSign:
            return False
        for piece in pieces:
            where = (middle + piece[0], middle + piece[1])
            found.roots.append(self._polished(where, others, last))
            found.alone.append(self._boxed(where, others))
        return True

    def _boxed(self, span: tuple[Fraction, Fraction], others: Sequence[Ball]) -> Box:
        """A span of u, and the other unknowns."""
        sides = [span, *map(balls.ends, others)]
        return self._ordered(sides)

    def _polished(self, span: tuple[Fraction, Fraction], others: list[Ball], last: Number) -> Box:
        """A small box around the only root in a span, by interval Newton on g; ``last`` is its
        third coefficient.
        """
        for _ in range(12):  # steps, the last of which no longer narrow it
            middle = _short((span[0] + span[1]) / 2)
            point = [*self.at(middle, others), last]
            about, off = _about(point, balls.between(span[0] - middle, span[1] - middle))
            slope = evaluate(derivative(about), off)
            if not balls.sign(slope):
                break
            # By the ends: a ball of a wide quotient would be wider.
            steps = [value / by for value in balls.ends(point[0]) for by in balls.ends(slope)]
            new = (max(middle - max(steps), span[0]), min(middle - min(steps), span[1]))
            if new[1] - new[0] > (span[1] - span[0]) * Fraction(3, 4):
                break
            span = new
            if span[1] - span[0] < Fraction(1, 10**17):
                break
        return self._boxed(span, self._narrowed(balls.between(*span), others))

    def others(self, span: tuple[Fraction, Fraction], box: Box) -> list[Ball]:
        """Balls that hold the other unknowns for all u of the span: exactly one value for each u,
        in the box.
        """
        u = balls.between(*span)
        given = [balls.between(*side) for number, side in enumerate(box) if number != self.along]
        # Widened, until the unknowns as functions of u stay inside; where they leave the box itself
        # no harm is done.
        for _ in range(8):
            wide = [value + (value - balls.middle(value)) * 3 for value in given]
            image = self._newton(u, wide)
            if all(_inside(one, other) for one, other in zip(image, wide, strict=True)):
                return self._narrowed(u, image)
            given = [balls.union(one, other) for one, other in zip(image, given, strict=True)]
        raise UndecidedSign("the other unknowns in a box")

    def _narrowed(self, u: Ball, others: Sequence[Ball]) -> list[Ball]:
        """Balls of the other unknowns contracted until they are not narrower by much, or far
        narrower than the digits of u.

        Around an exact 0 the contraction never ends: exponents would grow threefold a step, until
        no memory holds them.
        """
        current, enough = list(others), Fraction(1, 1 << 4 * u.bits)
        for _ in range(12):
            if all(_width(value) < enough for value in current):
                break
            image = self._newton(u, current)
            if any(
                _width(one) * 2 > _width(other) for one, other in zip(image, current, strict=True)
            ):
                return [
                    min(one, other, key=_width) for one, other in zip(image, current, strict=True)
                ]
            current = image
        return current


def _isolated(
    coefficients: Sequence[Any], low: Fraction, high: Fraction
) -> list[tuple[Fraction, Fraction]]:
    """Intervals with exactly one root each of a cubic, all of its roots in [low, high]; Undecided
    where that can't be told.
    """
    found, stack, looks = [], [(low, high, 0)], 0
    while stack:
        one, two, depth = stack.pop()
        looks += 1
        h = balls.between(one, two)
        about, off = _about(coefficients, h)
        if balls.sign(evaluate(about, off)):
            continue
        if balls.sign(evaluate(derivative(about), off)):
            signs = [balls.sign(evaluate(coefficients, balls.exact(end))) for end in (one, two)]
            if 0 in signs:
                raise UndecidedSign("a root on the end of a piece")
            if signs[0] != signs[1]:
                found.append((one, two))
            continue
        # Else the expansion is made anew for the halves of the box.
        if depth > 60 or looks > 300:
            raise UndecidedSign("roots that lie close together")
        cut = one + (two - one) * Fraction(63, 128)
        stack += [(one, cut, depth + 1), (cut, two, depth + 1)]
    return found


def _about(c: Sequence[Any], h: Ball) -> tuple[list[Any], Ball]:
    """Coefficients of the polynomial about the middle of a piece, and what the piece is from
    there.
    """
    middle = balls.middle(h)
    return shifted(c, middle), h - middle


def _short(value: Fraction) -> Fraction:
    """A rational of few digits, much nearer than what is asked for here."""
    return Fraction(round(value * 2**100), 2**100)


def _width(value: Ball | Fraction) -> Fraction:
    low, high = balls.ends(value)
    return high - low


def _inside(one: Ball, other: Ball) -> bool:
    (low, high), (least, most) = balls.ends(one), balls.ends(other)
    return least < low and high < most


def _largest_pivot(rows: list[list[Any]], k: int) -> None:
    # By rationals, not floats: beside the end of a range a slope may be larger than any.
    pivot = max(range(k, len(rows)), key=lambda i: abs(sum(balls.ends(rows[i][k]), Fraction(0))))
    rows[k], rows[pivot] = rows[pivot], rows[k]
    if not balls.sign(rows[k][k]):
        raise UndecidedSign("a pivot that may be 0")
