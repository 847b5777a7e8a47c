"""All folds along one parameter for many points at once, in float64 with proof; points that float64
can't decide are marked.

The same folds as of :mod:`.folds`, by the same polynomials in t = tan(θ/2): their positive roots
are isolated by :mod:`spragsym.numerics.bernstein`, and every sign that says what a fold is carries
a bound on its error.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from ..models.parameters import FloatArray
from ..numerics import balls, bernstein
from ..numerics.affine import Rounded, as_rounded, cosine_and_sine
from ..numerics.arithmetic import Number, Polynomial
from ..numerics.balls import Ball, as_floats, ends
from ..numerics.interval_arrays import BoolArray, IndexArray, Int8Array, quiet, scale_of
from ..numerics.polynomials import on_circle
from . import kernel
from .kernel import LINEAR
from .parameters import NAMES


@dataclass(frozen=True)
class FoldArrays:
    """Folds in contact of many points, in no order: the point of each, and what
    :class:`~.folds.Fold` says of it.

    ``value`` and ``t`` = tan(θ/2) carry proved bounds. Of points in ``undecided`` nothing is
    listed.
    """

    row: IndexArray
    value: Rounded
    t: Rounded
    side: Int8Array
    upper: BoolArray
    undecided: BoolArray

    def rows(self, index: IndexArray) -> FoldArrays:
        """Some of them."""
        value, t = self.value.rows(index), self.t.rows(index)
        return FoldArrays(
            self.row[index], value, t, self.side[index], self.upper[index], self.undecided
        )


def folds(vary: str, given: Mapping[str, FloatArray], size: int) -> FoldArrays:
    """All folds along one of the six of ``size`` points, in its range; the others are arrays of
    ``size`` or one number each.
    """
    with quiet():
        return _in_theta0(given, size) if vary == "theta0" else _along(vary, given, size)


def _along(vary: str, given: Mapping[str, FloatArray], size: int) -> FoldArrays:
    values, angle, without, change, sextic = _eliminated(vary, given)
    roots = bernstein.positive_roots(sextic, size)
    here = on_circle(roots.t)[:2]
    slope = kernel.f(*here, *_rows(change, roots.row))
    value = -kernel.f(*here, *_rows(without, roots.row)) / slope
    others = dict(zip(LINEAR, _rows(values, roots.row), strict=True)) | {vary: value}
    upper = roots.rising * slope.sign()
    return _kept(roots, value, (*here, *_rows(angle, roots.row)), others, (-roots.rising, upper))


def friction_sextic(given: Mapping[str, FloatArray]) -> Sequence[Any]:
    """f′ f_μ₀ − f f_μ₀′ times (1 + t²)³ by powers of t = tan(θ/2): negative where μ₀ on the surface
    f = 0 rises with θ.
    """
    return _eliminated("mu0", given)[-1]


def _eliminated(
    vary: str, given: Mapping[str, FloatArray]
) -> tuple[Any, Any, Any, Any, Sequence[Any]]:
    """The others with 0 for one, cos θ₀ and sin θ₀, a, b, d, m of f and of f_v there, and f′ f_v −
    f f_v′ by powers of t.
    """
    values = [Rounded(given[name] if name != vary else np.float64(0.0)) for name in LINEAR]
    angle = cosine_and_sine(given["theta0"])
    without, change = kernel.f_along(vary, *angle, *values)
    return values, angle, without, change, kernel.fold_sextic(*without, *change)


def _in_theta0(given: Mapping[str, FloatArray], size: int) -> FoldArrays:
    """With α = 0 cos θ₀ drops out of f: θ₀ and π − θ₀ are folds together, where the second relation
    holds.
    """
    values = [Rounded(given[name]) for name in LINEAR]
    polynomial, free = _circle(values), np.broadcast_to(given["alpha"] == 0, size)
    if free.any():
        relation = math.prod(
            [Polynomial([1, 0, 1])] * 3, start=Polynomial(kernel.fold_cubics(*values)[1])
        )
        polynomial = [
            _where(free, one, other)
            for one, other in zip(relation.coefficients, polynomial, strict=True)
        ]
    roots = bernstein.positive_roots(polynomial, size)
    twice = np.flatnonzero(free[roots.row])
    index = np.append(np.arange(roots.row.size), twice)
    roots = bernstein.PolynomialRoots(
        roots.row[index], roots.t.rows(index), roots.rising[index], roots.undecided
    )
    others, at = _rows(values, roots.row), on_circle(roots.t)[:2]
    sin0, cos0 = kernel.fold_sine(*at, *others), kernel.fold_angles(*at, *others)[1]
    inside = np.ones(index.size, dtype=np.int8)
    if twice.size:
        square, free = 1 - sin0 * sin0, free[roots.row]
        inside, width = np.where(free, square.sign(), 1), square.sqrt()
        cos0 = _where(
            free, width * np.where(np.arange(index.size) < index.size - twice.size, 1.0, -1.0), cos0
        )
    trig = kernel.f_coefficients(cos0, sin0, *others, 1)
    change = kernel.f(*at, *kernel.f_changes(cos0, sin0, *others)[0])
    curvature = kernel.f_curvature(*at, *trig).sign()
    # The true point lies on the unit circle, at most this far from the computed one.
    distance = np.hypot(sin0.error, cos0.error)
    theta0 = Rounded(
        np.arctan2(sin0.value, cos0.value), np.where(distance < 0.1, 1.01 * distance, 4.0) + 1e-15
    )
    named = dict(zip(LINEAR, others, strict=True))
    return _kept(
        roots, theta0, (*at, cos0, sin0), named, (-curvature * change.sign(), curvature), inside
    )


def _circle(values: list[Rounded]) -> list[Rounded]:
    """(1 + t²)⁶ (p B q α)² (sin² θ₀ + cos² θ₀ − 1), by powers of t."""
    _, _, alpha, sigma, beta = values
    width = alpha * (beta + 1 + sigma)
    scale = (alpha + sigma) * (beta + 1) * width
    powers, others = (
        (one * one).coefficients for one in map(Polynomial, kernel.fold_cubics(*values))
    )
    result = [width * width * one + other for one, other in zip(powers, others, strict=True)]
    for half, binomial in enumerate((1, 6, 15, 20, 15, 6, 1)):
        result[2 * half] = result[2 * half] - scale * scale * binomial
    return result


def _kept(
    roots: bernstein.PolynomialRoots,
    value: Rounded,
    angles: tuple[Rounded, Rounded, Rounded, Rounded],
    here: Mapping[str, Rounded],
    signs: tuple[Int8Array, Int8Array],
    inside: Int8Array | int = 1,
) -> FoldArrays:
    """Candidates in contact with the value in its range, with ``signs`` of their side and of where
    they are upper ones; a sign that is needed and open makes the point undecided.
    """
    L, _, y = kernel.state_of(*angles, *(here[name] for name in kernel.Fixed._fields))
    tests = [value.sign(), L.sign(), -y.sign(), angles[3].sign(), inside]
    out = functools.reduce(np.logical_or, [test < 0 for test in tests])
    vague = functools.reduce(np.logical_or, [test == 0 for test in (*tests, *signs)]) & ~out
    undecided = roots.undecided.copy()
    undecided[roots.row[vague]] = True
    every = FoldArrays(roots.row, value, roots.t, signs[0], signs[1] > 0, undecided)
    return every.rows(np.flatnonzero(~out & ~undecided[roots.row]))


def _rows(parts: Iterable[Any], index: IndexArray) -> list[Any]:
    return [as_rounded(part).rows(index) for part in parts]


def _where(which: BoolArray, *numbers: Any) -> Rounded:
    one, other = map(as_rounded, numbers)
    return Rounded(
        *(np.where(which, getattr(one, part), getattr(other, part)) for part in ("value", "error"))
    )


# ------------------------------------------------------------------------------------------------
# more digits


#: Largest error of a value over max(1, |value|), proved.
LARGEST_ERROR = 1e-12


def sharpened(
    vary: str, given: Mapping[str, FloatArray], found: FoldArrays
) -> tuple[Rounded, Rounded, IndexArray]:
    """t = tan(θ/2) and the values on folds with less uncertainty, and where it is still too large.

    ``given`` has for each fold the others of the six.
    """
    exact = {name: Rounded(column) for name, column in given.items()}
    wide = Rounded(found.value.value, 2 * found.value.error)  # with the surface beside the fold
    steps = _sharpened(
        vary,
        exact,
        (found.t, wide),
        _cosine_and_sine,
        lambda one: Rounded(one.value),
        lambda one, other: _where(2 * other.error <= one.error, other, one),
    )
    with quiet():
        # Most steps of Newton's rule for arrays, each of which squares the error.
        for near in itertools.islice(steps, 2):
            left = np.flatnonzero(~(near[1].error <= LARGEST_ERROR * scale_of(near[1].value)))
            if not left.size:
                break
    return *near, left


def _cosine_and_sine(angle: Rounded) -> tuple[Rounded, Rounded]:
    cosine, sine = cosine_and_sine(angle.value)
    return Rounded(cosine.value, cosine.error + angle.error), Rounded(
        sine.value, sine.error + angle.error
    )


def with_more_digits(vary: str, given: Mapping[str, float], t: Rounded, value: Rounded) -> float:
    """The value on one fold of :func:`sharpened`, to the digits of a float; undecided where f_v or
    f″ may be 0 within bounds.
    """

    def around(number: Rounded) -> Ball:
        middle, error = Fraction(float(number.value)), Fraction(float(number.error))
        return balls.between(middle - error, middle + error)

    def narrower(one: Ball, other: Ball) -> Ball:
        (low, high), (begin, end) = ends(one), ends(other)
        return other if 2 * (end - begin) <= high - low else one

    # Bits of balls: enough for a value that loses half of the digits of float64, twice over.
    with balls.precision(160):
        exact = {name: balls.exact(Fraction(number)) for name, number in given.items()}
        steps = _sharpened(
            vary, exact, (around(t), around(value)), balls.cos_sin, balls.middle, narrower
        )
        # Most further steps, for balls.
        *_, (_, best) = itertools.islice(steps, 3)
        return as_floats((best,))[0][0]


def _sharpened(
    vary: str,
    given: Mapping[str, Any],
    near: tuple[Any, Any],
    cos_sin: Callable[[Any], tuple[Any, Any]],
    middle: Callable[[Any], Any],
    narrower: Callable[[Any, Any], Any],
) -> Iterator[tuple[Any, Any]]:
    """t and the value v with less uncertainty after each step, of arrays with bounds or of one ball
    each.

    ``near`` holds what they are on the fold, and beside it, in the directions of t, the surface f =
    0. On that dv/dθ = −f′/f_v, which is 0 on the fold: v in the middle of the directions is off by
    at most their width times the largest \\|f′/f_v\\| over all of them; and a step of Newton's rule
    for f′ = 0 narrows them. ``narrower`` takes the second of two numbers where it is at most half
    as wide as the first.
    """

    level = None if vary == "theta0" else cos_sin(given["theta0"])

    def with_value(v: Number) -> tuple[Any, ...]:
        return *(level or cos_sin(v)), *(v if name == vary else given[name] for name in LINEAR)

    t, value = near
    while True:
        centre, v = middle(t), middle(value)
        (here, enclosing), values = (on_circle(one) for one in (centre, t)), with_value(value)
        trig = kernel.f_coefficients(*values, 1)
        change = kernel.f_changes(*values)[NAMES.index(vary)]
        # By dθ ≤ 2 dt.
        drift = (
            kernel.f_slope(*enclosing[:2], *trig)
            / kernel.f(*enclosing[:2], *change)
            * (2 * (t - centre))
        )
        on_surface = v - kernel.f(*here[:2], *kernel.f_coefficients(*with_value(v), 1)) / kernel.f(
            *here[:2], *change
        )
        value = narrower(value, on_surface + drift)
        slope = kernel.f_slope(*here[:2], *kernel.f_coefficients(*with_value(value), 1))
        t = narrower(
            t, centre - slope / kernel.f_curvature(*enclosing[:2], *trig) * enclosing.scale / 2
        )
        yield t, value
