"""Roots with many digits, in ball arithmetic.

:func:`narrowed` encloses one root, known in floats, by Krawczyk's operator around the result of
Newton's method.

:func:`reduced_roots` finds all roots in a box where the Jacobian is nearly singular, as near a fold
or a cusp, by Lyapunov–Schmidt reduction. There the Jacobian has rank n − 1. So n − 1 of the
equations determine all unknowns but one, u, as functions of u in a small box; this is proved by
interval Newton. The last equation becomes g(u) = 0. Its Taylor polynomial of degree 3, with an
enclosure of the third coefficient over the whole box, is a cubic with one interval coefficient,
which contains all roots. These are isolated by bisection in u: a piece contains no root if the
polynomial is not 0 on it, and exactly one if its derivative is not 0 on it and its signs at both
ends differ.
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
from .arithmetic import Matrix, Number, dot, is_zero, linear_solution
from .balls import Ball, UndecidedSign, ball
from .interval_arrays import FloatArray, Intervals, quiet, width_of
from .jets import Jet, constant, gradient, variables
from .polynomials import derivative, evaluate, shifted

#: The function F of balls, or of jets of balls.
Evaluate: TypeAlias = Callable[[Sequence[Any]], Sequence[Any]]
#: Lower and upper end of each unknown.
Box: TypeAlias = list[tuple[Fraction, Fraction]]


@dataclass(frozen=True)
class DigitOptions(Options):
    """Options of the search with many digits, where roots are close together.

    Parameters
    ----------
    depth : int
        Maximum number of bisections of a box.
    parts : int
        Maximum number of parts examined; the default suffices for both halves at each depth around
        two roots. It limits the cost of a box whose halves are no simpler, as along a curve of
        roots or around a pole.
    """

    depth: int = limit(26)
    parts: int = limit(120)


class Digits(Protocol):
    """n equations in n unknowns in ball arithmetic."""

    #: Precision of the balls.
    bits: int
    #: Order of the derivatives that occur in the equations.
    order: int = 0

    def equations(self, unknowns: Sequence[Any]) -> Sequence[Any]:
        """F of jets of balls; of balls only if ``order`` is 0."""

    def values(self, unknowns: Sequence[Any]) -> Sequence[Any]:
        """F of balls."""
        if self.order:
            return list(map(constant, self.equations(variables(unknowns, self.order))))
        return self.equations(unknowns)

    def slopes(self, unknowns: Sequence[Any]) -> Matrix:
        """The Jacobian ∂F/∂x over a box."""
        return [
            gradient(row, len(unknowns))
            for row in self.equations(variables(unknowns, self.order + 1))
        ]


def narrowed(
    system: Digits,
    box: FloatArray,
    alone: FloatArray | None,
    enough: Fraction = Fraction(1, 2**160),
) -> list[Ball] | None:
    """A small box of balls that contains the root in ``box``, (2, n); None if that is not proved.

    ``alone``, (2, n), is a larger box in which the root is unique. If it is None, the root is
    proved to be the only one in both boxes, and may lie beside ``box``.

    ``enough`` is the Newton step at which the iteration ends, in a point z. If |1 − Y J| ≤ 1/2 in
    the box of half-width r ≥ 2 |Y F(z)| around z, the operator x − Y F(x) maps this box into
    itself, so that it contains a root. It is the given root if the box is inside ``alone``, or if
    |1 − Y J| ≤ 1/2 over a box that contains both.
    """
    z = [ball(float(value), system.bits) for value in Intervals(box).middle]
    # From the middle of a box that holds the root, where |1 − Y J| ≤ 1/2, steps are shorter.
    longest = Fraction(float(width_of(box).max()))
    with suppress(UndecidedSign, ZeroDivisionError):
        for _ in range(40):  # quadratic convergence
            Y = _inverse(as_balls(system.slopes(z), system.bits), system.bits)
            values = as_balls([system.values(z)], system.bits)[0]
            step = [dot(row, values) for row in Y]
            size = _norm(step)
            if size <= enough:
                return _proved(system, z, 2 * size, Y, box, alone)
            if alone is None and size > longest:
                return None
            z = [balls.middle(part - change) for part, change in zip(z, step, strict=True)]
    return None


def _proved(
    system: Digits,
    z: Sequence[Ball],
    r: Fraction,
    Y: Sequence[Sequence[Ball]],
    box: FloatArray,
    alone: FloatArray | None,
) -> list[Ball] | None:
    """The box of half-width r around z if it is proved to contain the root; else None."""
    with balls.precision(system.bits):
        enclosed = [part + balls.between(-r, r) for part in z]
        domain = enclosed
        if alone is None or not lies_in(enclosed, alone):
            pairs = zip(enclosed, exact_ends(box), strict=True)
            domain = [balls.union(part, balls.between(*side)) for part, side in pairs]
    columns = list(zip(*as_balls(system.slopes(domain), system.bits), strict=True))
    contraction = [
        [dot(row, column) - int(i == j) for j, column in enumerate(columns)]
        for i, row in enumerate(Y)
    ]
    return enclosed if max(map(_norm, contraction)) <= Fraction(1, 2) else None


def lies_in(numbers: Sequence[Ball], box: FloatArray) -> bool:
    """Whether a box of balls lies in a box of floats, (2, n)."""
    sides = zip(map(balls.ends, numbers), exact_ends(box), strict=True)
    return all(low <= least and most <= high for (least, most), (low, high) in sides)


def exact_ends(box: FloatArray) -> Box:
    """Lower and upper end of each unknown of a box of floats (2, n), as fractions."""
    return [(Fraction(-float(low)), Fraction(float(high))) for low, high in box.T]


def as_balls(rows: Matrix, bits: int) -> list[list[Ball]]:
    """A matrix of balls and numbers as one of balls."""
    return [
        [entry if isinstance(entry, Ball) else ball(float(entry), bits) for entry in row]
        for row in rows
    ]


def _inverse(rows: Sequence[Sequence[Ball]], bits: int) -> list[list[Ball]]:
    """Approximate inverse of the matrix of midpoints, of exact balls."""
    try:
        middles = np.array([[float(sum(balls.ends(entry)) / 2) for entry in row] for row in rows])
    except OverflowError:
        middles = np.full((len(rows), len(rows)), np.nan)
    with quiet():
        return [
            [ball(float(entry), bits) for entry in row]
            for row in contractors.inverse(middles[:, :, None])[:, :, 0]
        ]


def _norm(values: Sequence[Ball]) -> Fraction:
    """Upper bound of Σ |x|."""
    return sum((max(map(abs, balls.ends(value))) for value in values), Fraction(0))


def as_intervals(values: Sequence[Ball]) -> Intervals:
    """Balls as intervals of floats, (numbers, 1)."""
    return outward([balls.ends(value) for value in values])


def outward(sides: Sequence[tuple[Fraction, Fraction]]) -> Intervals:
    """Pairs (low, high) as intervals of floats rounded outward, (numbers, 1)."""
    ends = np.array([[-float(low) for low, _ in sides], [float(high) for _, high in sides]])
    # float() of a fraction rounds to nearest.
    return Intervals(np.nextafter(ends, np.inf)[:, :, None])


@dataclass(frozen=True)
class Reduced:
    """Result of :func:`reduced_roots`: tight boxes around the roots, boxes in which each is unique
    (``alone``), and undecided boxes.
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
    """All roots in a box, with pairs (low, high); ``jacobian``, (n, n), is approximately that of F
    in the box.
    """
    options = options or DigitOptions()
    task, found = _task(evaluate, jacobian, range(len(box))), Reduced([], [], [])
    with balls.precision(bits):
        whole = [(Fraction(low), Fraction(high)) for low, high in box]
        task.search(whole, found, options)
    return found


def third_derivative(
    evaluate: Evaluate, box: Box, jacobian: FloatArray, bits: int, among: Sequence[int]
) -> Ball:
    """Enclosure of g‴/6 over a box; u and the last equation are chosen ``among`` these indices."""
    with balls.precision(bits):
        task = _task(evaluate, jacobian, among)
        return task.third(box[task.along], task.others(box[task.along], box))


def _task(evaluate: Evaluate, jacobian: FloatArray, among: Sequence[int]) -> _Task:
    """The reduction of a system, with u and the last equation chosen ``among`` these indices: those
    with the largest components of the Jacobian's singular vectors of the smallest singular value.
    """
    left, _, right = np.linalg.svd(jacobian)
    unknowns, equations = (
        _first(max(among, key=lambda i: abs(float(part[i]))), part.size)
        for part in (right[-1], left[:, -1])
    )
    return _Task(evaluate, unknowns, equations)


def _first(number: int, n: int) -> tuple[int, ...]:
    """0, …, n − 1 with ``number`` moved to the beginning."""
    return (number, *(i for i in range(n) if i != number))


@dataclass(frozen=True)
class _Task:
    """Lyapunov–Schmidt reduction of a system.

    ``unknowns`` and ``equations`` are permutations: u is the first of the unknowns, and the last
    equation, which becomes g(u) = 0, the first of the equations. Methods take and return values in
    these orders: u and the others, g and the others.
    """

    evaluate: Evaluate
    unknowns: tuple[int, ...]
    equations: tuple[int, ...]

    def _ordered(self, values: Sequence[Any]) -> list[Any]:
        """Unknowns in the system's own order."""
        return [values[self.unknowns.index(index)] for index in range(len(values))]

    def _values(self, unknowns: Sequence[Any]) -> list[Any]:
        """F."""
        values = self.evaluate(self._ordered(unknowns))
        return [values[row] for row in self.equations]

    def _slopes(self, unknowns: Sequence[Any]) -> list[list[Any]]:
        """The Jacobian of F, of balls: a quotient of integers would be a float."""
        rows = [
            gradient(row, len(unknowns))
            for row in self.evaluate(variables(self._ordered(unknowns), 1))
        ]
        zero = unknowns[0] * 0
        return [[rows[row][index] + zero for index in self.unknowns] for row in self.equations]

    def _coefficients(self, series: Matrix, order: int) -> list[Any]:
        """Taylor coefficients of F of an order, for unknowns that are power series known to one
        order less.
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
        """Interval Newton operator m − J⁻¹ S(u, m) for the other unknowns, with the n − 1 equations
        S = 0 and midpoints m.
        """
        middle = [balls.middle(value) for value in others]
        slopes = [row[1:] for row in self._slopes([u, *others])[1:]]
        steps = linear_solution(slopes, self._values([u, *middle])[1:], _largest_pivot)
        return [m - step for m, step in zip(middle, steps, strict=True)]

    def _expansion(self, u: Ball, others: Sequence[Ball], highest: int) -> list[Any]:
        """Taylor coefficients of g in u, from order 1 to ``highest``.

        Order by order, the coefficients of the other unknowns solve a linear system, whose matrix
        is the Jacobian of S.
        """
        slopes = self._slopes([u, *others])
        matrix, zero = [row[1:] for row in slopes[1:]], Ball(0, 0, 0, u.bits)
        steps = linear_solution(matrix, [row[0] for row in slopes[1:]], _largest_pivot)
        series = [
            [u, 1],
            *([value, zero - step] for value, step in zip(others, steps, strict=True)),
        ]
        out = [slopes[0][0] - dot(slopes[0][1:], steps) + zero]
        for order in range(2, highest + 1):
            rest, *rows = self._coefficients(series, order)
            steps = linear_solution(matrix, rows, _largest_pivot)
            out.append(rest - dot(slopes[0][1:], steps) + zero)
            for part, term in zip(series, [0, *(zero - step for step in steps)], strict=True):
                part.append(term)
        return out

    @property
    def along(self) -> int:
        """Index of u."""
        return self.unknowns[0]

    def third(self, span: tuple[Fraction, Fraction], others: Sequence[Ball]) -> Ball:
        """Enclosure of g‴/6 over a span of u."""
        return self._expansion(balls.between(*span), others, 3)[2]

    def at(self, u: Fraction, others: Sequence[Ball]) -> list[Any]:
        """Taylor coefficients of g of order 0, 1, 2 at a point."""
        point = balls.exact(u)
        sharp = self._narrowed(point, others)
        return [self._values([point, *sharp])[0], *self._expansion(point, sharp, 2)]

    def search(self, box: Box, found: Reduced, options: DigitOptions) -> None:
        """Add all roots of a box to ``found``, by bisection in u until they are isolated."""
        waiting = deque([(box, options.depth)])
        for _ in range(options.parts):
            if not waiting:
                return
            part, depth = waiting.popleft()
            if self._isolates(part, found):
                continue
            if not depth:
                found.undecided.append(part)
                continue
            low, high = part[self.along]
            cut = low + (high - low) * Fraction(61, 128)
            for side in ((low, cut), (cut, high)):
                half = [side if i == self.along else other for i, other in enumerate(part)]
                waiting.append((half, depth - 1))
        found.undecided.extend(part for part, _ in waiting)

    def _isolates(self, box: Box, found: Reduced) -> bool:
        """Isolate the roots of a box and add them to ``found``; False if that fails."""
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
        """The box with a span of u and the other unknowns."""
        sides = [span, *map(balls.ends, others)]
        return self._ordered(sides)

    def _polished(self, span: tuple[Fraction, Fraction], others: list[Ball], last: Number) -> Box:
        """A tight box around the only root in a span, by interval Newton for g; ``last`` encloses
        g‴/6.
        """
        for _ in range(12):
            middle = _short((span[0] + span[1]) / 2)
            coefficients = [*self.at(middle, others), last]
            piece = balls.between(span[0] - middle, span[1] - middle)
            about, off = _about(coefficients, piece)
            slope = evaluate(derivative(about), off)
            if not balls.sign(slope):
                break
            # Quotients of the ends: the ball of a wide quotient would be wider.
            values = balls.ends(coefficients[0])
            steps = [value / by for value in values for by in balls.ends(slope)]
            new = (max(middle - max(steps), span[0]), min(middle - min(steps), span[1]))
            if new[1] - new[0] > (span[1] - span[0]) * Fraction(3, 4):
                break
            span = new
            if span[1] - span[0] < Fraction(1, 10**17):
                break
        return self._boxed(span, self._narrowed(balls.between(*span), others))

    def others(self, span: tuple[Fraction, Fraction], box: Box) -> list[Ball]:
        """Balls that contain the other unknowns for all u of a span, with exactly one value for
        each u; UndecidedSign if that is not proved.
        """
        u = balls.between(*span)
        given = [balls.between(*side) for number, side in enumerate(box) if number != self.along]
        # The balls are widened until interval Newton maps them into themselves. They may exceed the
        # box.
        for _ in range(8):
            wide = [value + (value - balls.middle(value)) * 3 for value in given]
            image = self._newton(u, wide)
            if all(_inside(one, other) for one, other in zip(image, wide, strict=True)):
                return self._narrowed(u, image)
            given = [balls.union(one, other) for one, other in zip(image, given, strict=True)]
        raise UndecidedSign("the other unknowns in a box")

    def _narrowed(self, u: Ball, others: Sequence[Ball]) -> list[Ball]:
        """Balls of the other unknowns contracted by interval Newton, until they shrink by less than
        half, or are far narrower than the precision of u.

        Without the second limit the contraction towards an exact 0 would never end: exponents would
        triple in each step, until they exceed the memory.
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
    """All roots in [low, high] of a polynomial with balls as coefficients: intervals with exactly
    one root each; UndecidedSign if they cannot be isolated.
    """
    found, stack, pieces = [], [(low, high, 0)], 0
    while stack:
        begin, end, depth = stack.pop()
        pieces += 1
        about, off = _about(coefficients, balls.between(begin, end))
        if balls.sign(evaluate(about, off)):
            continue
        if balls.sign(evaluate(derivative(about), off)):
            signs = [balls.sign(evaluate(coefficients, balls.exact(u))) for u in (begin, end)]
            if 0 in signs:
                raise UndecidedSign("a root on the end of a piece")
            if signs[0] != signs[1]:
                found.append((begin, end))
            continue
        if depth > 60 or pieces > 300:  # then new expansions about smaller boxes are needed
            raise UndecidedSign("roots that lie close together")
        cut = begin + (end - begin) * Fraction(63, 128)
        stack += [(begin, cut, depth + 1), (cut, end, depth + 1)]
    return found


def _about(c: Sequence[Any], piece: Ball) -> tuple[list[Any], Ball]:
    """The polynomial expanded about the midpoint of a piece, and the piece relative to that."""
    middle = balls.middle(piece)
    return shifted(c, middle), piece - middle


def _short(value: Fraction) -> Fraction:
    """A fraction rounded to 100 binary digits after the point."""
    return Fraction(round(value * 2**100), 2**100)


def _width(value: Ball | Fraction) -> Fraction:
    """Width of a ball."""
    low, high = balls.ends(value)
    return high - low


def _inside(one: Ball, other: Ball) -> bool:
    """True if a ball is in the interior of another."""
    (low, high), (least, most) = balls.ends(one), balls.ends(other)
    return least < low and high < most


def _largest_pivot(rows: list[list[Any]], k: int) -> None:
    """Partial pivoting: swap the row with the largest midpoint in column k into row k;
    UndecidedSign if it may be 0.
    """
    # Fractions, as next to the end of a range a slope may exceed all floats.
    pivot = max(range(k, len(rows)), key=lambda i: abs(sum(balls.ends(rows[i][k]), Fraction(0))))
    rows[k], rows[pivot] = rows[pivot], rows[k]
    if not balls.sign(rows[k][k]):
        raise UndecidedSign("a pivot that may be 0")
