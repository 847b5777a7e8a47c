"""Parameter values at which affine forces may vanish on a whole line of states.

If the forces K q + f are affine in the coordinates, there is one state where det K ≠ 0, and a line
of states or none where det K = 0. On a line all determinants of Cramer's rule, in which f replaces
a column of K, vanish too, and no row of K is 0 unless its f is. Branch and prune over ranges of the
parameters excludes all other values. Determinants are bounded directly and by the mean value
theorem.

An end of a range that does not belong to it, as k = 0 of k > 0, may be a common root of all
determinants; halving never separates it from values beside it. Let the derivatives of a determinant
D(λ) below the m-th be exactly 0 at the end λ*, in ball arithmetic. Then D(λ) = D⁽ᵐ⁾(ξ) (λ −
λ*)ᵐ/m!. If D⁽ᵐ⁾ has a sign over a box at λ*, D vanishes in that box at λ* only. If the end belongs
to the range, λ* itself must be excluded too.
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
from ..statics.balance import Balance, PreciseBalance
from ..statics.forces import Evaluation
from ..statics.regions import halved
from .defining_systems import FOLD, Augmented, Family


def lines_of_states(family: Family) -> tuple[FloatArray, IntArray]:
    """Boxes of the varying parameters, shape (2, number, boxes), that may hold a line of states,
    and the point of each.
    """
    sides = np.stack([-family.spans[:, 0], family.spans[:, 1]])[:, :, None]
    count, number = family.given.shape[1], len(family.vary)
    ends, point = np.repeat(sides, count, axis=2), np.arange(count)
    for halving in range(32 * number):  # each range is halved 32 times
        possible = np.flatnonzero(_may_hold_a_line(family, ends, point))
        ends, point = ends[:, :, possible], point[possible]
        if not point.size:
            break
        if np.bincount(point, minlength=1).max() > 1000:  # too many: their hull
            points, which = np.unique(point, return_inverse=True)
            return hulls_of(ends, which, points.size), points
        row = halving % number
        ends, point = halved(Intervals(ends), row).ends, np.repeat(point, 2)
    return ends, point


def is_singular(balance: Balance, family: Family) -> bool:
    """Whether det K is 0 for all states and for all values of the parameters that are not 0 in the
    family.

    K is evaluated in exact arithmetic at random rational coordinates, parameters, directions and
    friction coefficients. That is no proof. But if det K were not 0 everywhere, it would be 0 at
    all of these samples with negligible probability (Schwartz–Zippel lemma).
    """
    rng = np.random.default_rng(0)
    given = zip(balance.parameters, family.given[:, 0].tolist(), strict=True)
    zero = {name for name, value in given if value == 0 and name not in balance.angles}

    def drawn() -> Fraction:
        largest = 2**30  # numerator or denominator
        return Fraction(*map(int, rng.integers(1, largest, 2)))

    def circle() -> list[Fraction]:
        # A rational point of the unit circle.
        t = drawn()
        return [(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)]

    for _ in range(12):
        values = {name: 0 if name in zero else drawn() for name in balance.codes}
        for pair in balance.angles.values():
            values |= dict(zip(pair, circle(), strict=True))
        q, mus = [drawn() for _ in balance.coordinates], [drawn() for _ in balance.rubbing]
        lines = [part for _ in range(balance.springs) for part in (*circle(), drawn())]
        first = [*q, *lines, *(drawn() for _ in balance.torsions)]
        at = balance.at(q, values, xp=None)
        try:
            K = at.call("forces_jacobian", first, *mus, *balance.indicators, kind="statics")
        except AttributeError:  # the law is not algebraic
            return False
        if determinant(K) != 0:
            return False
    return True


def _may_hold_a_line(family: Family, ends: FloatArray, point: IntArray) -> BoolArray:
    """Boxes of parameters in which a line of states is not excluded."""
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
    """Whether a box at the ``end`` of the range of parameter number k is proved to hold no line of
    states.

    ``signs`` are those of the derivatives of all determinants by that parameter over the box, by
    order.
    """
    bits = 192  # of ball arithmetic
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
    none_at_end = any(balls.sign(force) and all(map(_is_nothing, row)) for row, force in rows)
    allowed = system.balance.model.Parameters.ranges[system.family.vary[k]]
    if allowed.contains(end) and not none_at_end:
        return False
    return any(_root_alone(one, k, [of[j] for of in signs]) for j, one in enumerate(minors))


def _root_alone(minor: Number, k: int, signs: Sequence[int]) -> bool:
    """Whether a determinant is proved to vanish at the end and nowhere else in the box.

    ``signs`` are those of its derivatives over the box.
    """
    orders = range(len(signs))
    first = next((m for m in orders if not _is_nothing(_slope(minor, k, m))), 0)
    return first > 0 and signs[first] != 0


def _affine(at: Evaluation) -> tuple[Matrix, Sequence[Any]]:
    """K and f of the affine forces, from an evaluation at q = 0."""
    return at.slopes, at.forces()


def _minors(K: Matrix, f: Sequence[Any]) -> list[Any]:
    """det K, and the determinants of Cramer's rule."""
    rows = list(zip(K, f, strict=True))
    replaced = [[[*row[:j], force, *row[j + 1 :]] for row, force in rows] for j in range(len(rows))]
    return [determinant(K), *map(determinant, replaced)]


def _slope(value: Number, k: int, order: int) -> Number:
    """The derivative of a jet or number by parameter number k."""
    if isinstance(value, Jet):
        return value.derivative(*[k] * order)
    return 0 if order else value


def _signs(values: Sequence[Any], count: int) -> Int8Array:
    """Signs of numbers or jets over boxes; 0 where unknown."""
    return stacked([constant(value) for value in values], (count,)).signs


def _is_nothing(value: Number) -> bool:
    """Whether a ball or jet is exactly 0."""
    return balls.is_exactly_zero(constant(value))
