"""Roots of a system in a small box where its Jacobian is nearly singular: reduced to one unknown, with many digits.

Near a fold or a cusp the Jacobian has rank n − 1. So n − 1 of the equations determine all unknowns but one, u, uniquely in the
box, and the last equation becomes one function g(u), whose Taylor polynomial of degree 3 with an enclosure of the last
coefficient holds all roots: a cubic with one coefficient that is an interval. Its roots are isolated by halving, in balls of
many digits.

What is proved of the box: the other unknowns stay in it, as functions of u, by Krawczyk's operator on the n − 1 equations; a
piece of u holds no root if the polynomial is not 0 on it, and exactly one if its slope is not 0 on it and its signs at both
ends differ.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from .elimination import solved
from .intervals import Ball, Balls
from .jets import Jet
from .polynomials import Undecided

#: F of balls or of jets of balls.
Evaluate: TypeAlias = Callable[[Sequence[Any]], Sequence[Any]]
#: Lower and upper end of each unknown.
Box: TypeAlias = list[tuple[Fraction, Fraction]]

_BALLS = Balls()
#: Times a piece of u is halved before the expansion is made anew for its halves.
HALVINGS = 60
#: Pieces of one expansion after which it counts as too wide.
PIECES = 300
#: Steps of interval Newton on one root.
STEPS = 12
#: Times the other unknowns are given more room.
WIDENINGS = 8
#: Times the box itself is halved.
DEPTH = 26
#: Parts of the box that are looked at: both halves at each depth around two roots. A box whose halves never get simpler, as
#: along a line of roots or around a pole, costs no more than these.
PARTS = 120


@dataclass(frozen=True)
class Reduced:
    """Boxes, as pairs of fractions for each unknown: around each root, those in which it is alone, and those still open."""

    roots: list[Box]
    alone: list[Box]
    left: list[Box]


def reduced_roots(evaluate: Evaluate, box: Sequence[tuple[float, float]], jacobian: NDArray[np.float64], bits: int) -> Reduced:
    """All roots in a box.

    Parameters
    ----------
    evaluate : callable
    box : sequence of (float, float)
        Ends of each unknown.
    jacobian : ndarray
        F's Jacobian somewhere in the box, roughly.
    bits : int
        Of the balls.
    """
    left_vectors, _, right_vectors = np.linalg.svd(jacobian)
    task = _Task(evaluate, int(np.abs(right_vectors[-1]).argmax()), int(np.abs(left_vectors[:, -1]).argmax()), len(box))
    found = Reduced([], [], [])
    with _BALLS.precision(bits):
        task.search([(Fraction(low), Fraction(high)) for low, high in box], found)
    return found


def third_derivative(evaluate: Evaluate, box: Box, jacobian: NDArray[np.float64], bits: int, among: Sequence[int]) -> Ball:
    """A sixth of the third derivative of g all over a box, with u and the equation that is left among the given ones.

    Raises
    ------
    Undecided
        Where the other unknowns are not proved to be functions of u that stay in a box slightly larger.
    """
    left_vectors, _, right_vectors = np.linalg.svd(jacobian)
    along = max(among, key=lambda i: abs(float(right_vectors[-1, i])))
    equation = max(among, key=lambda i: abs(float(left_vectors[i, -1])))
    with _BALLS.precision(bits):
        return _Task(evaluate, along, equation, len(box)).third(box)


@dataclass(frozen=True)
class _Task:
    evaluate: Evaluate
    along: int  #: number of u
    equation: int  #: number of the equation that is left
    n: int

    def third(self, box: Box) -> Ball:
        """The third coefficient of the expansion about any point of a box."""
        last: Ball = self._expansion(_BALLS.between(*box[self.along]), self._others(box[self.along], box))[3]
        return last

    def search(self, box: list[tuple[Fraction, Fraction]], found: Reduced) -> None:
        """All roots of a box: of the whole if it can be settled, else of its halves in u, and of theirs."""
        waiting = deque([(box, DEPTH)])
        for _ in range(PARTS):
            if not waiting:
                return
            part, depth = waiting.popleft()
            if self._settled(part, found):
                continue
            if depth:
                waiting.extend((half, depth - 1) for half in self._halves(part))
            else:
                found.left.append(part)
        found.left.extend(part for part, _ in waiting)

    def _halves(self, box: list[tuple[Fraction, Fraction]]) -> Iterator[list[tuple[Fraction, Fraction]]]:
        low, high = box[self.along]
        cut = low + (high - low) * Fraction(61, 128)
        for part in ((low, cut), (cut, high)):
            yield [part if i == self.along else side for i, side in enumerate(box)]

    def _settled(self, box: list[tuple[Fraction, Fraction]], found: Reduced) -> bool:
        """Whether the roots of a box could be isolated; those found are kept."""
        low, high = box[self.along]
        middle = (low + high) / 2
        try:
            others = self._others(box[self.along], box)
            whole = self._expansion(_BALLS.between(low, high), others)
            at = _BALLS.exact(middle)
            point = self._expansion(at, self._narrowed(at, others))
            pieces = _isolated([*point[:3], whole[3]], low - middle, high - middle)
        except Undecided:
            return False
        if pieces is None:
            return False
        for piece in pieces:
            where = (middle + piece[0], middle + piece[1])
            found.roots.append(self._polished(where, others, whole[3]))
            found.alone.append(self._boxed(where, others))
        return True

    def _boxed(self, span: tuple[Fraction, Fraction], others: Sequence[Ball]) -> Box:
        """A span of u, and the other unknowns."""
        ends = iter([_BALLS.ends(value) for value in others])
        return [span if i == self.along else next(ends) for i in range(self.n)]

    def _polished(self, span: tuple[Fraction, Fraction], others: list[Ball], last: Any) -> Box:
        """A small box around the only root in a span, by interval Newton on g; ``last`` is its third coefficient."""
        for _ in range(STEPS):
            middle = _short((span[0] + span[1]) / 2)
            at = _BALLS.exact(middle)
            point = [*self._expansion(at, self._narrowed(at, others), 2), last]
            slope = _taylor_slope(point, _BALLS.between(span[0] - middle, span[1] - middle))
            if not _sign(slope):
                break
            # By the ends: a ball of a wide quotient would be wider.
            steps = [value / by for value in _BALLS.ends(point[0]) for by in _BALLS.ends(slope)]
            new = (max(middle - max(steps), span[0]), min(middle - min(steps), span[1]))
            if new[1] - new[0] > (span[1] - span[0]) * Fraction(3, 4):
                break
            span = new
            if span[1] - span[0] < Fraction(1, 10**17):
                break
        return self._boxed(span, self._narrowed(_BALLS.between(*span), others))

    def _all(self, u: Any, others: Sequence[Any]) -> list[Any]:
        """All unknowns in their order."""
        rest = iter(others)
        return [u if i == self.along else next(rest) for i in range(self.n)]

    def _jets(self, u: Any, others: Sequence[Any]) -> tuple[list[Any], list[list[Any]]]:
        """The n − 1 equations and their slopes by the other unknowns."""
        values = self.evaluate(self._all(u, [Jet.variable(value, number, 1) for number, value in enumerate(others)]))
        rows = [value for number, value in enumerate(values) if number != self.equation]
        return [_value(row) for row in rows], [[_slope(row, number) for number in range(self.n - 1)] for row in rows]

    def _others(self, span: tuple[Fraction, Fraction], box: list[tuple[Fraction, Fraction]]) -> list[Ball]:
        """Balls that hold the other unknowns for all u of the span: exactly one value for each u, in the box."""
        u = _BALLS.between(*span)
        given = [_BALLS.between(*side) for number, side in enumerate(box) if number != self.along]
        # Widened, until the unknowns as functions of u stay inside; where they leave the box itself no harm is done.
        for _ in range(WIDENINGS):
            wide = [value + (value - _BALLS.middle(value)) * 3 for value in given]
            image = self._newton(u, wide)
            if all(_inside(one, other) for one, other in zip(image, wide, strict=True)):
                return self._narrowed(u, image)
            given = [_BALLS.union(one, other) for one, other in zip(image, given, strict=True)]
        raise Undecided("the other unknowns in a box")

    def _narrowed(self, u: Ball, others: Sequence[Ball]) -> list[Ball]:
        """Balls of the other unknowns contracted until they are not narrower by much."""
        current = list(others)
        for _ in range(12):
            image = self._newton(u, current)
            if any(_width(one) * 2 > _width(other) for one, other in zip(image, current, strict=True)):
                return [min(one, other, key=_width) for one, other in zip(image, current, strict=True)]
            current = image
        return current

    def _newton(self, u: Ball, others: Sequence[Ball]) -> list[Ball]:
        """Interval Newton's operator m − J⁻¹ S(u, m) on the n − 1 equations S."""
        middle = [_BALLS.middle(value) for value in others]
        values = [row for number, row in enumerate(self.evaluate(self._all(u, middle))) if number != self.equation]
        slopes = self._jets(u, others)[1]
        return [m - step for m, step in zip(middle, solved(slopes, values, _largest_pivot), strict=True)]

    def _expansion(self, u: Ball, others: Sequence[Ball], highest: int = 3) -> list[Any]:
        """Taylor coefficients of g to the third or less, at any point of u."""
        slopes = self._jets(u, others)[1]
        jets = [Jet({(): value}, highest) for value in others]
        variable = Jet.variable(u, 0, highest)
        for order in range(1, highest + 1):
            rows = [row for number, row in enumerate(self.evaluate(self._all(variable, jets))) if number != self.equation]
            steps = solved(slopes, [_coefficient(row, order) for row in rows], _largest_pivot)
            jets = [Jet({**jet.terms, (0,) * order: -step}, highest) for jet, step in zip(jets, steps, strict=True)]
        last = self.evaluate(self._all(variable, jets))[self.equation]
        return [_coefficient(last, order) for order in range(highest + 1)]


def _isolated(coefficients: Sequence[Any], low: Fraction, high: Fraction) -> list[tuple[Fraction, Fraction]]:
    """Intervals with exactly one root each of a cubic, all of its roots in [low, high]; Undecided where that can't be told."""
    found, stack, looks = [], [(low, high, 0)], 0
    while stack:
        one, two, depth = stack.pop()
        looks += 1
        h = _BALLS.between(one, two)
        if _sign(_taylor(coefficients, h)):
            continue
        if _sign(_taylor_slope(coefficients, h)):
            signs = [_sign(_at(coefficients, end)) for end in (one, two)]
            if 0 in signs:
                raise Undecided("a root on the end of a piece")
            if signs[0] != signs[1]:
                found.append((one, two))
            continue
        if depth > HALVINGS or looks > PIECES:
            raise Undecided("roots that lie close together")
        cut = one + (two - one) * Fraction(63, 128)
        stack += [(one, cut, depth + 1), (cut, two, depth + 1)]
    return found


def _taylor(c: Sequence[Any], h: Ball) -> Any:
    """The polynomial over a piece, expanded about the middle of it."""
    m = _BALLS.middle(h)
    d = h - m
    slope = c[1] + m * (c[2] * 2 + m * c[3] * 3)
    return c[0] + m * (c[1] + m * (c[2] + m * c[3])) + d * (slope + d * (c[2] + m * c[3] * 3 + d * c[3]))


def _taylor_slope(c: Sequence[Any], h: Ball) -> Any:
    m = _BALLS.middle(h)
    d = h - m
    return c[1] + m * (c[2] * 2 + m * c[3] * 3) + d * (c[2] * 2 + m * c[3] * 6 + d * c[3] * 3)


def _at(c: Sequence[Any], place: Fraction) -> Any:
    h = _BALLS.exact(place)
    return c[0] + h * (c[1] + h * (c[2] + h * c[3]))


def _sign(value: Any) -> int:
    return _BALLS.sign(value) if isinstance(value, Ball) else (value > 0) - (value < 0)


def _short(value: Fraction) -> Fraction:
    """A rational of few digits, much nearer than what is asked for here."""
    return Fraction(round(value * 2**100), 2**100)


def _value(row: Any) -> Any:
    return row.value if isinstance(row, Jet) else row


def _slope(row: Any, number: int) -> Any:
    return row.derivative(number) if isinstance(row, Jet) else 0


def _coefficient(row: Any, order: int) -> Any:
    return row.terms.get((0,) * order, 0) if isinstance(row, Jet) else (row if order == 0 else 0)


def _width(value: Any) -> Fraction:
    if not isinstance(value, Ball):
        return Fraction(0)
    low, high = _BALLS.ends(value)
    return high - low


def _inside(one: Any, other: Ball) -> bool:
    low, high = _BALLS.ends(one) if isinstance(one, Ball) else (Fraction(one), Fraction(one))
    least, most = _BALLS.ends(other)
    return least < low and high < most


def _largest_pivot(rows: list[list[Any]], k: int) -> None:
    pivot = max(range(k, len(rows)), key=lambda i: abs(_size(rows[i][k])))
    rows[k], rows[pivot] = rows[pivot], rows[k]
    if not _sign(rows[k][k]):
        raise Undecided("a pivot that may be 0")


def _size(value: Any) -> Fraction:
    # No float: beside the end of a range a slope may be larger than any.
    return sum(_BALLS.ends(value), Fraction(0)) / 2 if isinstance(value, Ball) else Fraction(value)
