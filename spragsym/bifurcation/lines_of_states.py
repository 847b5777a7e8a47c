"""Parameters at which affine forces may vanish on a whole line of states.

Of forces K q + f, affine in the coordinates, no two isolated states meet: where det K = 0 there is
a line of states, or none. On a line each determinant of Cramer's rule is 0 as well, in which f
stands for a column of K, and no row of K is 0 where its f is not. Ranges of the parameters are
halved, and what one of these excludes is dropped; determinants are bounded as they are and by the
mean value theorem.

An end of a range that is excluded from it, as k = 0 of k > 0, may be a root of them all, which no
halving tells from one beside it. A determinant D(λ) whose derivatives below the m-th are exactly 0
at λ*, in balls, is D⁽ᵐ⁾(ξ) (λ − λ*)ᵐ/m!: where D⁽ᵐ⁾ has a sign over a box at λ*, D is not 0 in that
box but at λ*. At an end that belongs to the range, λ* itself is asked as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from ..numerics import balls
from ..numerics.arithmetic import Matrix, Number, determinant
from ..numerics.balls import UndecidedSign, ball
from ..numerics.interval_arrays import (
    BoolArray,
    FloatArray,
    Int8Array,
    IntArray,
    Intervals,
    hulls_of,
    quiet,
    stacked,
)
from ..numerics.jets import Jet, constant
from ..statics.balance import PreciseBalance
from ..statics.forces import Evaluation
from ..statics.regions import halved
from .defining_systems import FOLD, Augmented, Family


def lines_of_states(family: Family) -> tuple[FloatArray, IntArray]:
    """Boxes of the parameters that vary, shape (2, number, boxes), in which affine forces may
    vanish on a line; and their points.
    """
    sides = np.stack([-family.spans[:, 0], family.spans[:, 1]])[:, :, None]
    count, number = family.given.shape[1], len(family.vary)
    ends, point = np.repeat(sides, count, axis=2), np.arange(count)
    # Halvings of each range.
    for halving in range(32 * number):
        some = np.flatnonzero(_may_hold_a_line(family, ends, point))
        ends, point = ends[:, :, some], point[some]
        if not point.size:
            break
        # Boxes of a point that are kept, or else their hull.
        if np.bincount(point, minlength=1).max() > 100:
            points, which = np.unique(point, return_inverse=True)
            return hulls_of(ends, which, points.size), points
        row = halving % number
        ends, point = halved(Intervals(ends), row).ends, np.repeat(point, 2)
    return ends, point


def _may_hold_a_line(family: Family, ends: FloatArray, point: IntArray) -> BoolArray:
    """Boxes in which nothing excludes a line of states."""
    system, (number, count) = Augmented(family, FOLD), ends.shape[1:]
    n, boxes = system.balance.n, Intervals(ends)
    with quiet():
        origin = [Intervals.point(np.zeros(count))] * n
        varied = [Jet.variable(boxes[k], k, n) for k in range(number)]
        K, f = _affine(system.state([*origin, *varied], system.prepared_at(family.given[:, point])))
        minors, centres = _minors(K, f), Intervals.point(boxes.middle)
        middle = system.state([*origin, *centres], system.prepared_at(family.given[:, point]))
        centred = [
            sum(((boxes[k] - centres[k]) * _slope(one, k, 1) for k in range(number)), value)
            for one, value in zip(minors, _minors(*_affine(middle)), strict=True)
        ]
        out: BoolArray = (_signs([*minors, *centred], count) == 0).all(axis=0)
        for row, force in zip(K, f, strict=True):
            nothing = stacked([constant(entry) for entry in row], (count,)).magnitude.max(axis=0)
            out &= (nothing > 0) | (_signs([force], count)[0] == 0)
        for k in range(number):
            slopes = [_signs([_slope(one, k, m) for one in minors], count) for m in range(n + 1)]
            for end, side in zip(family.spans[k].tolist(), (boxes.low, boxes.high), strict=True):
                for box in np.flatnonzero(out & (side[k] == end)):
                    signs = [of_order[:, box].tolist() for of_order in slopes]
                    given, beside = family.given[:, point[box]], ends[:, :, box]
                    out[box] = not _none_from(system, given, beside, k, end, signs)
    return out


def _none_from(
    system: Augmented,
    given: FloatArray,
    box: FloatArray,
    k: int,
    end: float,
    signs: Sequence[Sequence[int]],
) -> bool:
    """Proof that a box, at the ``end`` of the range of the k-th parameter, holds no line of states.

    ``signs`` are those of the derivatives of all determinants by that parameter over the box.
    """
    # Bits at an end.
    bits = 192
    precise = PreciseBalance(system, given, bits)
    with balls.precision(bits):
        varied: list[Any] = [
            balls.between(Fraction(-low), Fraction(high)) for low, high in box.T.tolist()
        ]
    varied[k] = Jet.variable(ball(end, bits), k, system.balance.n)
    try:
        K, f = _affine(precise.state([ball(0, bits)] * system.balance.n + varied))
        minors = _minors(K, f)
    except (UndecidedSign, ZeroDivisionError):
        return False
    rows = zip(K, map(constant, f), strict=True)
    alone = any(balls.sign(force) and all(map(_is_nothing, row)) for row, force in rows)
    if system.balance.model.Parameters.ranges[system.family.vary[k]].contains(end) and not alone:
        return False
    return any(_root_alone(one, k, [of[j] for of in signs]) for j, one in enumerate(minors))


def _root_alone(minor: Number, k: int, signs: Sequence[int]) -> bool:
    """Proof that a determinant is 0 at the end and nowhere else in the box, by its derivatives."""
    orders = range(len(signs))
    first = next((m for m in orders if not _is_nothing(_slope(minor, k, m))), 0)
    return first > 0 and signs[first] != 0


def _affine(at: Evaluation) -> tuple[Matrix, Sequence[Any]]:
    """K and f of the forces K q + f, from an evaluation at q = 0."""
    return at.slopes, at.forces()


def _minors(K: Matrix, f: Sequence[Any]) -> list[Any]:
    """det K, and the determinants of Cramer's rule."""
    rows = list(zip(K, f, strict=True))
    replaced = [[[*row[:j], force, *row[j + 1 :]] for row, force in rows] for j in range(len(rows))]
    return [determinant(K), *map(determinant, replaced)]


def _slope(value: Number, k: int, order: int) -> Number:
    """A derivative by the k-th parameter, of a jet or a number."""
    if isinstance(value, Jet):
        return value.derivative(*[k] * order)
    return 0 if order else value


def _signs(values: Sequence[Any], count: int) -> Int8Array:
    """Signs of numbers or jets over boxes, 0 where one is not known."""
    return stacked([constant(value) for value in values], (count,)).signs


def _is_nothing(value: Number) -> bool:
    """The number 0, exactly."""
    return not any(balls.ends(constant(value)))
